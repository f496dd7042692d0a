//! Classical functions against their end conditions, closed forms and each other.

use super::{
    AssumedFunctions, BendingRoot, ClassicalBending, ClassicalTorsion, Deformation, Mesh, PiecewiseFunctions, Sample,
    TorsionRoot,
};
use crate::numerics::quadrature::GaussRules;
use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// Calls `f(x, weight)` for each point of a rule on [a, b].
fn each_point(rule: &[(f64, f64)], a: f64, b: f64, mut f: impl FnMut(f64, f64)) {
    let (half, middle) = (0.5 * (b - a), 0.5 * (a + b));
    for &(node, weight) in rule {
        f(middle + half * node, half * weight);
    }
}

const BENDING: [BendingRoot; 7] = [
    BendingRoot::Clamped,
    BendingRoot::Free,
    BendingRoot::Spring(1e-12),
    BendingRoot::Spring(0.3),
    BendingRoot::Spring(1.2),
    BendingRoot::Spring(50.0),
    BendingRoot::Spring(1e12),
];

fn sample(functions: &dyn AssumedFunctions, x: f64) -> Vec<Sample> {
    let mut out = vec![Sample::default(); functions.count()];
    functions.sample(x, &mut out);
    out
}

#[test]
fn bending_functions_meet_their_end_conditions() {
    let length = 2.0;
    for root in BENDING {
        let functions = ClassicalBending::new(root, 200, length, 1.0);
        let (hub, tip) = (sample(&functions, 0.0), sample(&functions, length));
        for (i, (hub, tip)) in hub.iter().zip(&tip).enumerate() {
            // ∫φ² = 1 on a length of 2: amplitudes are of order 1, β = i π / 2.
            let beta = (i + 1) as f64 * 2.0;
            assert!(hub.value.abs() < 1e-14 * beta, "{root:?} {i}: {hub:?}");
            assert!(tip.curvature.abs() < 1e-13 * beta * beta * beta, "{root:?} {i}: {tip:?}");
            assert!(tip.value > 0.0, "{root:?} {i}: {tip:?}");
            match root {
                BendingRoot::Clamped => assert!(hub.slope.abs() < 1e-13 * beta, "{i}: {hub:?}"),
                BendingRoot::Free => assert!(hub.curvature.abs() < 1e-13 * beta * beta, "{i}: {hub:?}"),
                BendingRoot::Spring(k) => {
                    let moment = hub.curvature - k / length * hub.slope;
                    let size = beta * beta + k / length * 1e-2 * beta;
                    assert!(moment.abs() < 2e-12 * size, "{root:?} {i}: {hub:?} {moment}");
                }
            }
        }
    }
}

#[test]
fn bending_functions_are_orthonormal() {
    let length = 2.0;
    let rules = GaussRules::new();
    for root in BENDING {
        let functions = ClassicalBending::new(root, 40, length, 3.0);
        let phase = functions.wave_number() * length / 64.0;
        let mut gram = vec![0.0; 40 * 40];
        for panel in 0..64 {
            let (a, b) = (length * f64::from(panel) / 64.0, length * f64::from(panel + 1) / 64.0);
            each_point(rules.for_phase(phase), a, b, |x, weight| {
                let at = sample(&functions, x);
                for i in 0..40 {
                    for j in 0..40 {
                        gram[i * 40 + j] += 3.0 * weight * at[i].value * at[j].value;
                    }
                }
            });
        }
        for i in 0..40 {
            for j in 0..40 {
                let exact = if i == j { 1.0 } else { 0.0 };
                assert!((gram[i * 40 + j] - exact).abs() < 1e-12, "{root:?} {i} {j}: {}", gram[i * 40 + j]);
            }
        }
    }
}

#[test]
fn derivatives_are_those_of_the_functions() {
    // Central differences of value and slope: error h²/6 of the third derivative.
    let (x, h) = (0.7, 1e-5);
    let check = |functions: &dyn AssumedFunctions| {
        let (low, at, high) = (sample(functions, x - h), sample(functions, x), sample(functions, x + h));
        for i in 0..functions.count() {
            let slope = (high[i].value - low[i].value) / (2.0 * h);
            let curvature = (high[i].slope - low[i].slope) / (2.0 * h);
            let beta = (i + 1) as f64 * 2.0;
            assert!((slope - at[i].slope).abs() < 1e-9 * beta * beta * beta, "{i}");
            assert!((curvature - at[i].curvature).abs() < 1e-9 * beta * beta * beta * beta, "{i}");
        }
    };
    for root in BENDING {
        check(&ClassicalBending::new(root, 12, 2.0, 1.0));
    }
    for root in [TorsionRoot::Clamped, TorsionRoot::Free, TorsionRoot::Spring(0.4)] {
        check(&ClassicalTorsion::new(root, 12, 2.0));
    }
}

#[test]
fn characteristic_roots_are_right_to_fourteen_digits() {
    // Roots of Eq. 17, 19 and 22 by 50-digit arithmetic.
    let wave_number = |root, count| ClassicalBending::new(root, count, 1.0, 1.0).wave_number();
    let roots = [
        (BendingRoot::Clamped, 1, 1.875_104_068_711_961_2),
        (BendingRoot::Clamped, 2, 4.694_091_132_974_174_6),
        (BendingRoot::Clamped, 200, 626.747_734_391_163_7),
        (BendingRoot::Free, 2, 3.926_602_312_047_919),
        (BendingRoot::Free, 3, 7.068_582_745_628_732),
        (BendingRoot::Free, 200, 625.962_336_227_766_3),
    ];
    for (root, count, exact) in roots {
        let z = wave_number(root, count);
        assert!((z / exact - 1.0).abs() < 1e-14, "{root:?} {count}: {z}");
    }
    // A soft spring: z⁴ = 3k(1 − 12k/35 …) (Rayleigh's quotient for φ = x, next term by expansion).
    let z = wave_number(BendingRoot::Spring(1e-16), 1);
    assert!((z / (3e-16_f64).sqrt().sqrt() - 1.0).abs() < 1e-14, "{z}");
}

#[test]
fn torsion_functions_meet_their_end_conditions_and_norm() {
    let length = 2.0;
    for root in [
        TorsionRoot::Clamped,
        TorsionRoot::Free,
        TorsionRoot::Spring(1e-9),
        TorsionRoot::Spring(0.857),
        TorsionRoot::Spring(1e9),
    ] {
        let functions = ClassicalTorsion::new(root, 200, length);
        let (hub, tip) = (sample(&functions, 0.0), sample(&functions, length));
        for (i, (hub, tip)) in hub.iter().zip(&tip).enumerate() {
            let gamma = (i + 1) as f64 * 2.0;
            assert!(tip.slope.abs() < 1e-13 * gamma * gamma, "{root:?} {i}: {tip:?}");
            assert!(tip.value > 0.0, "{root:?} {i}: {tip:?}");
            match root {
                TorsionRoot::Clamped => assert_eq!(hub.value, 0.0, "{i}"),
                TorsionRoot::Free => assert_eq!(hub.slope, 0.0, "{i}"),
                TorsionRoot::Spring(k) => {
                    let moment = hub.slope - k / length * hub.value;
                    assert!(moment.abs() < 1e-13 * gamma * gamma * (1.0 + k).min(10.0), "{root:?} {i}: {moment}");
                }
            }
        }
        let mut square = 0.0;
        let rules = GaussRules::new();
        let few = ClassicalTorsion::new(root, 3, length);
        for panel in 0..8 {
            let (a, b) = (0.25 * f64::from(panel), 0.25 * f64::from(panel + 1));
            each_point(rules.for_phase(few.wave_number() * 0.25), a, b, |x, weight| {
                square += weight * sample(&few, x)[2].value * sample(&few, x)[2].value;
            });
        }
        assert!((square - 0.5 * length).abs() < 1e-13, "{root:?}: {square}");
    }
}

/// Sampling pairs of points about a middle is a faster way to the same numbers.
#[test]
fn samples_about_a_middle_are_those_at_the_points() {
    let families: [Box<dyn AssumedFunctions>; 5] = [
        Box::new(ClassicalBending::new(BendingRoot::Clamped, 40, 2.0, 3.0)),
        Box::new(ClassicalBending::new(BendingRoot::Free, 40, 2.0, 3.0)),
        Box::new(ClassicalBending::new(BendingRoot::Spring(0.3), 40, 2.0, 3.0)),
        Box::new(ClassicalTorsion::new(TorsionRoot::Spring(2.0), 40, 2.0)),
        Box::new(two_elements(Deformation::Bending)),
    ];
    let offsets = [-0.02, -0.007, 0.0, 0.007, 0.02];
    for functions in &families {
        let n = functions.count();
        let mut about = vec![Sample::default(); n * offsets.len()];
        let mut at = vec![Sample::default(); n];
        for middle in [0.02, 0.7, 1.3, 1.98] {
            functions.sample_about(middle, &offsets, &mut about);
            for (k, offset) in offsets.iter().enumerate() {
                functions.sample(middle + offset, &mut at);
                for (i, expected) in at.iter().enumerate() {
                    let found = about[i * offsets.len() + k];
                    // The highest wave advances by 120 rad over the blade: some 1e-14 of rounding.
                    for (found, expected) in [
                        (found.value, expected.value),
                        (found.slope, expected.slope),
                        (found.curvature, expected.curvature),
                    ] {
                        let size = 1.0 + functions.wave_number() * functions.wave_number();
                        assert!(
                            (found - expected).abs() < 1e-13 * size,
                            "{i} at {middle} + {offset}: {found} {expected}"
                        );
                    }
                }
            }
        }
    }
}

/// Three functions on elements [0, 0.7] and [0.7, 2] of three and two polynomials.
fn two_elements(deformation: Deformation) -> PiecewiseFunctions {
    let mesh = Mesh::new(vec![0.0, 0.7, 2.0], vec![3, 2]);
    let coefficients = DMatrix::from_row_slice(5, 2, &[1.0, 0.3, -0.5, 2.0, 0.25, -1.0, 0.0, 0.7, 0.4, -0.6]);
    PiecewiseFunctions::new(mesh, deformation, true, coefficients)
}

/// Slope and strain are derivatives, by differences; value and slope go on over the joint.
#[test]
fn piecewise_functions_are_integrals_of_their_strain() {
    for deformation in [Deformation::Bending, Deformation::Torsion] {
        let functions = two_elements(deformation);
        assert_eq!(functions.count(), 3);
        let at = |x: f64| {
            let mut out = vec![Sample::default(); 3];
            functions.sample(x, &mut out);
            out
        };
        let h = 1e-5;
        for x in [0.1, 0.35, 0.69, 0.71, 1.0, 1.9] {
            for ((here, low), high) in at(x).iter().zip(at(x - h)).zip(at(x + h)) {
                assert!((here.slope - (high.value - low.value) / (2.0 * h)).abs() < 1e-9, "{x}");
                if deformation == Deformation::Bending {
                    assert!((here.curvature - (high.slope - low.slope) / (2.0 * h)).abs() < 1e-9, "{x}");
                }
            }
        }
        for (inner, outer) in at(0.7 - 1e-12).iter().zip(at(0.7 + 1e-12)) {
            assert!((inner.value - outer.value).abs() < 1e-11);
            assert!(deformation == Deformation::Torsion || (inner.slope - outer.slope).abs() < 1e-11);
        }
        let root = at(0.0);
        assert!(root[1].value == 0.0 && root[2].value == 0.0);
        assert!(deformation == Deformation::Torsion || root[1].slope == 0.0);
    }
}
