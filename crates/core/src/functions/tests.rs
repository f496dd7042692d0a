//! Classical functions against their end conditions, closed forms and each other.

use super::{AssumedFunctions, BendingRoot, ClassicalBending, ClassicalTorsion, Sample, TorsionRoot};
use crate::numerics::quadrature::GaussRules;
use alloc::vec;
use alloc::vec::Vec;

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
            rules.each_point(a, b, phase, |x, weight| {
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
            rules.each_point(a, b, few.wave_number() * 0.25, |x, weight| {
                square += weight * sample(&few, x)[2].value * sample(&few, x)[2].value;
            });
        }
        assert!((square - 0.5 * length).abs() < 1e-13, "{root:?}: {square}");
    }
}
