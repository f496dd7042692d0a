//! Golden values of the coupled equations: two meshes, shooting on the strong form.

#![allow(clippy::unreadable_literal, reason = "reference values stand as they are printed")]

use super::blade::{Lump, Trapeze};
use super::bounds::Proof;
use super::*;
use crate::blade::{Root, RootCondition};
use crate::numerics::PiecewiseLinear;
use alloc::vec;

mod classical;
mod gyroscopic;

fn linear(from: f64, to: f64) -> PiecewiseLinear {
    PiecewiseLinear::new(vec![0.25, 2.0], vec![from, to]).unwrap()
}

/// The blade of the golden values.
fn golden() -> CoupledBlade {
    CoupledBlade {
        radius: 2.0,
        roots: [Root { offset: 0.25, condition: RootCondition::Clamped }; 3],
        mass: linear(3.0, 2.0),
        stiffness: [linear(20.0, 8.0), linear(200.0, 100.0), linear(15.0, 7.0)],
        inertia: [linear(0.002, 0.002), linear(0.04, 0.02)],
        mass_offset: linear(0.04, 0.07),
        tension_offset: linear(0.02, 0.03),
        trapeze: Trapeze::Squared(linear(0.01, 0.01)),
        twist: linear(0.6, 0.1),
        pitch: 0.0,
        precone: 0.0,
        torque_offset: 0.0,
        spring_angle: 0.0,
        rotary: false,
        paper_moment: false,
        lumps: Vec::new(),
    }
}

fn frequencies(blade: &CoupledBlade, speed: f64, count: usize) -> Vec<f64> {
    let found = modes(blade, speed * speed, count, &GaussRules::new()).unwrap();
    found.modes.iter().map(|mode| mode.eigenvalue.max(0.0).sqrt()).collect()
}

fn assert_golden(blade: &CoupledBlade, speed: f64, known: &[f64]) {
    let found = frequencies(blade, speed, known.len());
    for (found, known) in found.iter().zip(known) {
        // The digits given.
        assert!((found / known - 1.0).abs() < 2e-11, "{found} {known}");
    }
}

fn root(dof: usize, offset: f64, condition: RootCondition, blade: &mut CoupledBlade) {
    blade.roots[dof] = Root { offset, condition };
}

/// Flap hinge free, lag spring 30, pitch spring 40.
fn hinged() -> CoupledBlade {
    let mut blade = golden();
    root(0, 0.25, RootCondition::Free, &mut blade);
    root(1, 0.25, RootCondition::Spring(30.0), &mut blade);
    root(2, 0.25, RootCondition::Spring(40.0), &mut blade);
    blade
}

fn tip_mass() -> Vec<Lump> {
    vec![Lump { r: 2.0, mass: 0.5, offset: 0.03, inertia: [1e-3, 5e-3] }]
}

/// Everything at once, each root at a radius of its own.
fn everything() -> CoupledBlade {
    let mut blade = CoupledBlade { precone: 0.05, rotary: true, torque_offset: 0.1, lumps: tip_mass(), ..hinged() };
    root(1, 0.35, RootCondition::Spring(30.0), &mut blade);
    root(2, 0.5, RootCondition::Spring(40.0), &mut blade);
    blade
}

/// Clamped, at rest, at 5 and at 12 rad/s, and each option at 12: coupled equations solved on two meshes and
/// by shooting on their strong form.
#[test]
fn golden_values() {
    let golden = golden();
    assert_golden(
        &golden,
        0.0,
        &[3.2381034548, 9.9338261741, 18.0547383839, 23.4698057116, 43.5855198374, 57.1225657559],
    );
    assert_golden(
        &golden,
        5.0,
        &[6.1885108104, 10.989808775, 21.0729893989, 25.6431943687, 47.3596859955, 58.6984608648],
    );
    assert_golden(
        &golden,
        12.0,
        &[10.8557528665, 15.9043031526, 25.9673493366, 38.2857025683, 60.0176798196, 65.5298161356],
    );
    let plain = CoupledBlade { trapeze: Trapeze::Off, tension_offset: PiecewiseLinear::uniform(0.0), ..golden.clone() };
    assert_golden(
        &plain,
        12.0,
        &[10.8406549455, 15.9029307608, 17.5333995002, 38.8569097869, 53.2557868495, 62.9456396879],
    );
    let pitched = CoupledBlade { pitch: 0.2, ..golden.clone() };
    assert_golden(
        &pitched,
        12.0,
        &[9.9381960842, 16.4919659105, 25.2789803346, 37.9439802852, 59.9736953047, 65.4306143687],
    );
    let coned = CoupledBlade { precone: 0.05, ..golden.clone() };
    assert_golden(
        &coned,
        12.0,
        &[10.8450307471, 15.8596762541, 25.6987071952, 38.2072134273, 59.9800471041, 65.4507852224],
    );
    let rotary = CoupledBlade { rotary: true, ..golden.clone() };
    assert_golden(
        &rotary,
        12.0,
        &[10.7986604005, 15.8290917602, 25.9057713952, 38.0688678965, 58.3875337982, 63.8328263733],
    );
    let offset = CoupledBlade { torque_offset: 0.1, ..golden.clone() };
    assert_golden(
        &offset,
        12.0,
        &[10.8560238759, 15.9053912604, 27.4753689563, 38.5960673643, 60.0876748685, 65.8344293366],
    );
    assert_golden(
        &hinged(),
        12.0,
        &[6.1900902719, 13.2576945373, 20.7545982079, 34.6494678069, 49.6111804825, 52.4893058919],
    );
    let tipped = CoupledBlade { lumps: tip_mass(), ..golden };
    assert_golden(
        &tipped,
        12.0,
        &[9.7718684037, 14.9996178903, 23.7306415518, 37.8121340374, 56.1207613238, 58.7226630639],
    );
    assert_golden(
        &everything(),
        12.0,
        &[6.8483430124, 13.0792173199, 22.7608693554, 35.0989170189, 46.9697816397, 53.5650289700],
    );
}

/// Ritz values, residual energies and lower bounds on few functions, of another program of the same method: to
/// its ten digits.
fn assert_bounds(blade: &CoupledBlade, radii: &[f64], proof: Proof, upper: &[f64], energies: &[f64], lower: &[f64]) {
    let layout = Layout { radii: radii.to_vec(), orders: vec![[4; 3]; radii.len() - 1], highest: 5e3 };
    let (_, solved) = solve(blade, &layout, 144.0, (7, 0), &GaussRules::new(), None).unwrap();
    for (found, known) in solved.values.iter().zip(upper) {
        assert!((found.sqrt() / known - 1.0).abs() < 2e-9, "{} {known}", found.sqrt());
    }
    for (i, known) in energies.iter().enumerate() {
        assert!((solved.gaps[(i, i)] / known - 1.0).abs() < 2e-7, "{i}: {} {known}", solved.gaps[(i, i)]);
    }
    let gaps = solved.gaps.view((0, 0), (6, 6)).into_owned() / bounds::SLACK;
    let found = lower_bounds(&solved.values[..6], &gaps, &proof).unwrap();
    for (found, known) in found.iter().zip(lower) {
        assert!((found.sqrt() / known - 1.0).abs() < 2e-9, "{} {known}", found.sqrt());
    }
}

#[test]
fn bounds_from_few_functions() {
    let radii = [0.25, 1.125, 2.0];
    let proof = |rho, sigma| Proof { below: 6, rho, theta: 0.5, sigma };
    let upper = [10.85734382, 15.90440552, 25.96863144, 38.29296066, 60.04866737, 65.53638604, 78.92910827];
    let energies = [0.03850344322, 0.003633655798, 0.0703759909, 0.6095825003, 4.024819977, 0.9200030957];
    let lower = [10.85371333, 15.90416508, 25.96549652, 38.27043362, 59.80898523, 65.4382402];
    assert_bounds(&golden(), &radii, proof(5000.0, 0.0), &upper, &energies, &lower);
    let lower = [10.85334684, 15.9041408, 25.96518027, 38.26815715, 59.78475139, 65.4284977];
    assert_bounds(&golden(), &radii, proof(5000.0, 500.0), &upper, &energies, &lower);
    assert_bounds(
        &hinged(),
        &radii,
        proof(3200.0, 100.0),
        &[6.19012711, 13.25769561, 20.75635126, 34.65179958, 49.61497501, 52.49238157, 67.86482925],
        &[5.084442261e-4, 3.171865651e-5, 0.07747449104, 0.1731913339, 0.4034313783, 0.3483580438],
        &[6.190041378, 13.257693, 20.75190198, 34.64354019, 49.5784399, 52.44352036],
    );
    assert_bounds(
        &everything(),
        &[0.25, 0.35, 0.5, 1.125, 2.0],
        proof(3900.0, 100.0),
        &[6.848343503, 13.07921733, 22.76153843, 35.09949162, 46.96986721, 53.56668479, 64.89020427],
        &[7.260111136e-6, 3.372341531e-7, 0.03374796187, 0.04610955325, 0.01006403655, 0.1969227921],
        &[6.848342402, 13.0792173, 22.75978472, 35.09752258, 46.96936113, 53.5524233],
    );
}

/// Certificates on coarse meshes, of another program of the same method.
#[test]
fn the_number_of_eigenvalues_below_is_proven() {
    use certificate::{Form, index};
    let rules = GaussRules::new();
    let of = |blade: &CoupledBlade| {
        let layout = Layout { radii: vec![0.25, 0.6875, 1.125, 1.5625, 2.0], orders: vec![[5; 3]; 4], highest: 5e3 };
        Assembly::new(blade, &layout, &rules, None)
    };
    let below = |assembly: &Assembly, omega: f64| {
        index(assembly, Form { alpha: 1.0, s: 144.0, kappa: -omega * omega, turning: 0.0 })
    };
    let held = |assembly: &Assembly, theta: f64, sigma: f64| {
        index(assembly, Form { alpha: theta, s: 144.0, kappa: sigma, turning: 0.0 })
    };
    let speeds = [5.0, 10.0, 12.0, 20.0, 30.0, 50.0, 62.0, 70.0];
    let clamped = of(&golden());
    assert_eq!(speeds.map(|omega| below(&clamped, omega)), [0, 0, 1, 2, 3, 4, 5, 6].map(Some));
    assert_eq!([10.8557, 25.9673, 65.5298].map(|omega| below(&clamped, omega)), [0, 2, 5].map(Some));
    assert_eq!(below(&clamped, 0.0), Some(0), "statically stable");
    assert_eq!([(0.1, 0.0), (0.5, 50.0)].map(|(theta, sigma)| held(&clamped, theta, sigma)), [Some(0), Some(0)]);
    assert_eq!(held(&clamped, 0.02, 0.0), None, "too coarse for so little stiffness");
    let hinged = of(&hinged());
    assert_eq!(speeds.map(|omega| below(&hinged, omega)), [0, 1, 1, 2, 3, 5, 6, 7].map(Some));
    assert_eq!([(0.1, 0.0), (0.1, 50.0)].map(|(theta, sigma)| held(&hinged, theta, sigma)), [Some(1), Some(0)]);
    // "At most 3" on two elements of four polynomials, as those of the bounds.
    let layout = Layout { radii: vec![0.25, 1.125, 2.0], orders: vec![[4; 3]; 2], highest: 5e3 };
    let coarse = Assembly::new(&golden(), &layout, &rules, None);
    assert_eq!(index(&coarse, Form { alpha: 1.0, s: 144.0, kappa: -5000.0, turning: 0.0 }), Some(6));
}

/// The untaken energy of w = 1 on a uniform element of two polynomials, κ² m² h⁵/(720 EI), and of φ = 1 with
/// one, κ² I² h³/(12 GJ).
#[test]
fn untaken_energies_of_a_uniform_element() {
    let uniform = PiecewiseLinear::uniform;
    let blade = CoupledBlade {
        mass: uniform(3.0),
        stiffness: [uniform(20.0), uniform(200.0), uniform(15.0)],
        inertia: [uniform(0.01), uniform(0.03)],
        mass_offset: uniform(0.0),
        tension_offset: uniform(0.0),
        trapeze: Trapeze::Off,
        twist: uniform(0.0),
        ..golden()
    };
    let layout = Layout { radii: vec![0.25, 2.0], orders: vec![[2, 2, 1]], highest: 5e3 };
    let assembly = Assembly::new(&blade, &layout, &GaussRules::new(), None);
    let form = certificate::Form { alpha: 0.7, s: 0.0, kappa: -9.0, turning: 0.0 };
    let energy = certificate::untaken(&assembly.elements[0], &assembly.functions[0], form).unwrap();
    let (w, phi, h) = (5, 9, 1.75_f64);
    let bent = 81.0 * 9.0 * h.powi(5) / (720.0 * 0.7 * 20.0);
    let twisted = 81.0 * 0.04_f64.powi(2) * h.powi(3) / (12.0 * 0.7 * 15.0);
    assert!((energy.at(w, w) / bent - 1.0).abs() < 1e-12, "{} {bent}", energy.at(w, w));
    assert!((energy.at(phi, phi) / twisted - 1.0).abs() < 1e-12, "{} {twisted}", energy.at(phi, phi));
}

/// A uniform rod, m = 1, R = 1, roots at 0.
fn rod(stiffness: [f64; 3], inertia: [f64; 2], condition: RootCondition) -> CoupledBlade {
    let uniform = PiecewiseLinear::uniform;
    CoupledBlade {
        radius: 1.0,
        roots: [Root { offset: 0.0, condition }; 3],
        mass: uniform(1.0),
        stiffness: stiffness.map(uniform),
        inertia: inertia.map(uniform),
        mass_offset: uniform(0.0),
        tension_offset: uniform(0.0),
        trapeze: Trapeze::Off,
        twist: uniform(0.0),
        ..golden()
    }
}

/// Every interval holds its value, which is this near to the upper end, and is this narrow, both as shares of
/// the value and of ρ where that is far above.
fn assert_within(blade: &CoupledBlade, speed: f64, known: &[f64], width: f64) {
    let found = modes(blade, speed * speed, known.len(), &GaussRules::new()).unwrap();
    let rho = *found.separation.as_ref().unwrap();
    for (mode, known) in found.modes.iter().zip(known) {
        let (lower, upper) = mode.bounds.unwrap();
        let size = known.abs().max(1e-6 * rho);
        assert!(lower <= known + 1e-13 * rho && *known <= upper + 1e-13 * rho, "{known}: {lower} … {upper}");
        assert!(upper - lower <= width * size, "{known}: {lower} … {upper}, {:e}", (upper - lower) / size);
    }
}

#[test]
fn double_and_triple_eigenvalues_are_bounded() {
    // A round rod bends alike in both planes: (z_i)⁴ twice each, and GJ/I ((2i − 1) π/2)² = 1000 (π/2)².
    let z = [1.875_104_068_711_961_2_f64, 4.694_091_132_974_175];
    let round = rod([1.0, 1.0, 2.0], [1e-3, 1e-3], RootCondition::Clamped);
    let [first, second] = z.map(|z| z.powi(4));
    let twist = 1000.0 * (core::f64::consts::PI / 2.0).powi(2);
    assert_within(&round, 0.0, &[first, first, second, second, twist], 1e-9);
    // Three free roots at rest.
    let free = rod([1.0, 1.0, 2.0], [1e-3, 1e-3], RootCondition::Free);
    assert_within(&free, 0.0, &[0.0, 0.0, 0.0], 1e-4);
}

/// Rigid motions about central free hinges, whatever the offset and the angle: 0 in the plane of rotation, Ω²
/// out of it. And free pitch at 90°: −Ω² (I₂ − I₁)/(I₁ + I₂), a divergence that is proven.
#[test]
fn rigid_motions_about_free_hinges() {
    let uniform = PiecewiseLinear::uniform;
    let mut hinged = rod([1.0, 4.0, 2.0], [1e-3, 5e-3], RootCondition::Free);
    hinged.roots[2].condition = RootCondition::Clamped;
    hinged.mass_offset = uniform(0.03);
    hinged.twist = uniform(0.4);
    let found = modes(&hinged, 36.0, 4, &GaussRules::new()).unwrap();
    for known in [0.0, 36.0] {
        let nearest = found.modes.iter().map(|mode| (mode.eigenvalue - known).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-10, "{known}: {:?}", found.modes);
    }
    let mut feathered = rod([1.0, 4.0, 2.0], [1e-3, 1e-2], RootCondition::Clamped);
    feathered.roots[2].condition = RootCondition::Free;
    feathered.twist = uniform(core::f64::consts::FRAC_PI_2);
    let found = modes(&feathered, 36.0, 3, &GaussRules::new()).unwrap();
    let (lower, upper) = found.modes[0].bounds.unwrap();
    let known = -36.0 * 9.0 / 11.0;
    assert!(lower <= known + 1e-12 && known <= upper && upper - lower < 1e-9, "{lower} {known} {upper}");
}

/// Rayleigh and Ritz: functions of a lower order are among those of a higher one, so that more of them never raise
/// an eigenvalue, but for rounding. From 4 polynomials to 5 each falls by more than that.
#[test]
fn more_functions_never_raise_an_eigenvalue() {
    let rules = GaussRules::new();
    for blade in [golden(), hinged(), everything()] {
        let layout = Layout { radii: vec![0.25, 0.35, 0.5, 1.125, 2.0], orders: vec![[14; 3]; 4], highest: 1e4 };
        let mut before = vec![f64::INFINITY; 8];
        for order in [4, 5, 6, 8, 10, 14] {
            let (_, solved) =
                solve(&blade, &layout.with_orders_up_to(order), 144.0, (before.len(), 0), &rules, None).unwrap();
            for (now, before) in solved.values.iter().zip(&before) {
                let change = now / before - 1.0;
                assert!(change < if order == 5 { -1e-12 } else { 1e-12 }, "{order}: {now} after {before}, {change:e}");
            }
            before.copy_from_slice(&solved.values[..8]);
        }
    }
}

/// Without twist and offsets flap, lag and torsion are those of the uncoupled model; where the rotor turns fast
/// the string's.
#[test]
fn a_stiff_string_converges() {
    for speed in [1.0, 10.0, 100.0, 300.0] {
        let blade = CoupledBlade {
            twist: PiecewiseLinear::uniform(0.3),
            ..rod([1.0, 3.0, 2.0], [1e-5, 1e-4], RootCondition::Clamped)
        };
        let found = modes(&blade, speed * speed, 12, &GaussRules::new()).unwrap();
        for mode in &found.modes {
            assert!(mode.error / mode.eigenvalue.abs() < 1e-9, "{speed}: {mode:?}");
            assert!(mode.bounds.is_some(), "{speed}: {:?}", found.separation);
        }
    }
}

/// The functions of a range are as good at every speed as the modes of that speed alone, and the intervals of
/// both hold the same value.
#[test]
fn a_range_is_as_good_as_each_speed_alone() {
    let rules = GaussRules::new();
    for blade in [golden(), hinged(), everything()] {
        let range = Range::new(&blade, 225.0, 8, &rules).unwrap();
        assert!(range.is_converged(), "{:e}", range.error());
        let speeds = [0.0, 0.3, 1.7, 4.0, 7.5, 11.0, 13.3, 15.0];
        let squares = speeds.map(|speed| speed * speed);
        for (s, found) in squares.into_iter().zip(range.bounded(&squares).unwrap()) {
            let alone = modes(&blade, s, 8, &rules).unwrap();
            let bounds = found.bounds.unwrap();
            for (quick, value) in range.eigenvalues(s).unwrap().iter().zip(&found.eigenvalues) {
                assert!((quick - value).abs() < 1e-8 * value.abs().max(1.0), "{s}: {quick} {value}");
            }
            for ((mode, (lower, upper)), own) in range.modes(s, 8).unwrap().iter().zip(bounds).zip(&alone.modes) {
                let size = own.eigenvalue.abs().max(1.0);
                assert!(
                    (mode.eigenvalue - own.eigenvalue).abs() < 1e-9 * size,
                    "{s}: {} {}",
                    mode.eigenvalue,
                    own.eigenvalue
                );
                let (least, most) = own.bounds.unwrap();
                assert!(lower <= most && least <= upper, "{s}: {lower} … {upper} and {least} … {most}");
                assert!(upper - lower < 2e-8 * size, "{s}: {lower} … {upper}");
                let shares: f64 = mode.shares.iter().zip(own.shares).map(|(a, b)| (a - b).abs()).sum();
                assert!(shares < 1e-4, "{s}: {:?} {:?}", mode.shares, own.shares);
            }
        }
    }
}

/// Forces and moments sampled along the span are those that the strains carry, and vanish at the tip.
#[test]
fn sampled_moments_are_those_of_the_strains() {
    let rules = GaussRules::new();
    let radii = [0.25, 0.3, 0.42, 0.7, 1.1, 1.6, 1.99, 2.0];
    for blade in [golden(), everything()] {
        let (found, samples) = shapes(&blade, 144.0, 6, &radii, &rules).unwrap();
        let stretches = blade.stretches(&blade.stations());
        for (mode, samples) in found.modes.iter().zip(&samples) {
            for (r, at) in radii.iter().zip(samples) {
                let stretch = stretches.iter().find(|stretch| *r < stretch.to).unwrap_or(stretches.last().unwrap());
                let weights = terms::SectionWeights::new(&stretch.section(*r)).elastic;
                let carried =
                    |strain: usize| -> f64 { weights[strain].iter().zip(at.fields).map(|(w, f)| w * f).sum() };
                let moves = |dof: usize| *r >= blade.roots[dof].offset;
                let size = 1e-4 * mode.eigenvalue.abs().max(1.0);
                for (dof, force, strain) in [(0, 1, 2), (1, 3, 5), (2, 4, 7)] {
                    if moves(dof) && moves(1 - dof.min(1)) {
                        let off = (at.forces[force] - carried(strain)).abs();
                        assert!(off < 1e-4 * size.max(1.0), "{r} {dof}: {} {}", at.forces[force], carried(strain));
                    } else if !moves(dof) {
                        assert_eq!(at.forces[force], 0.0);
                    }
                }
            }
        }
    }
    let (_, samples) = shapes(&golden(), 144.0, 6, &radii, &rules).unwrap();
    for samples in samples {
        let tip = samples.last().unwrap().forces;
        assert!(tip.iter().all(|force| force.abs() < 1e-9), "{tip:?}");
    }
}
