//! The converged family by itself; tests/ compares it with independent solutions.

use super::{Converged, TOLERANCE, Wanted, Work};
use crate::blade::Blade;
use crate::dof::Dof;
use crate::lagrange::{Energies, assemble};
use crate::modes::solve;
use crate::numerics::quadrature::GaussRules;
use alloc::vec::Vec;

pub(super) fn stepped() -> Blade {
    with("")
}

/// The same with a point mass on the span and one at the tip, of about the blade's own weight.
pub(super) fn laden() -> Blade {
    with("point_mass = [{ r = 0.5, mass = 0.3, offset = 0.02 }, { r = 0.962, mass = 0.2, lag_inertia = 1e-4 }]")
}

fn with(point_masses: &str) -> Blade {
    let text = alloc::format!(
        r#"
        schema = "bladefan-blade/1"
        name = "stepped"
        rotor = {{ radius = 0.962, nominal_speed = 105 }}
        flap = {{ root = "hingeless", offset = 0.09 }}
        lag = {{ root = "spring-hinged", offset = 0.09, spring = 40 }}
        torsion = {{ root = "spring", offset = 0.09, spring = 100 }}
        {point_masses}
        [distribution]
        r = [0.09, 0.2, 0.2, 0.3, 0.3, 0.962]
        mass = [1.5, 1.5, 0.8, 0.8, 0.34, 0.34]
        flap_stiffness = [1500, 1500, 60, 60, 17, 17]
        lag_stiffness = [1500, 1500, 60, 60, 17, 170]
        torsion_stiffness = [500, 500, 60, 60, 17, 17]
        polar_inertia = [1e-3, 1e-3, 1e-3, 1e-3, 1e-4, 2e-4]
        mass_offset = 0.01
    "#
    );
    crate::formats::read(&text, crate::formats::Format::Toml).unwrap().blade
}

pub(super) fn converged(blade: &Blade, dof: Dof, speed_squared: f64, count: usize) -> Converged {
    Converged::new(blade, dof, &Wanted::at(speed_squared, count), &GaussRules::new(), &Work::default()).unwrap()
}

fn frequencies(found: &Converged, speed: f64, count: usize) -> Vec<f64> {
    solve(found.matrices(), speed * speed, count).unwrap().iter().map(|mode| mode.frequency).collect()
}

/// Against series in 40-digit arithmetic. TOLERANCE is that of λ; ω has half of it.
#[test]
fn a_stepped_blade_at_rest() {
    let rules = GaussRules::new();
    let found = Converged::new(&stepped(), Dof::Flap, &Wanted::at(0.0, 5), &rules, &Work::default()).unwrap();
    assert!(found.error() < TOLERANCE);
    let exact = [
        51.261_342_728_553_77,
        309.123_053_635_655_4,
        828.445_457_357_359_7,
        1_535.911_869_818_009,
        2_412.891_901_824_022,
    ];
    for (found, exact) in frequencies(&found, 0.0, 5).iter().zip(exact) {
        assert!((found / exact - 1.0).abs() < 0.5 * TOLERANCE, "{found} {exact}");
    }
}

/// One small space serves every speed of a range as well as a space made for that speed.
#[test]
fn a_range_is_as_good_as_each_of_its_speeds() {
    let (rules, blade) = (GaussRules::new(), stepped());
    for dof in Dof::ALL {
        let range = Converged::new(
            &blade,
            dof,
            &Wanted { range: (0.0, 150.0 * 150.0), count: 5, also_at: &[] },
            &rules,
            &Work::default(),
        )
        .unwrap();
        assert!(range.error() < TOLERANCE, "{dof}: {:e}", range.error());
        assert!(range.matrices().count() <= 20, "{dof}: {}", range.matrices().count());
        for speed in [0.0, 20.0, 77.0, 105.0, 140.0, 150.0] {
            let single = Converged::new(&blade, dof, &Wanted::at(speed * speed, 5), &rules, &Work::default()).unwrap();
            let pairs = frequencies(&range, speed, 5).into_iter().zip(frequencies(&single, speed, 5));
            for (of_range, own) in pairs {
                assert!((of_range / own - 1.0).abs() < TOLERANCE, "{dof} at {speed}: {of_range} {own}");
            }
        }
    }
}

/// The functions as they are sampled have the matrices that were summed up while they were found.
#[test]
fn sampled_functions_have_the_same_matrices() {
    let (rules, blade) = (GaussRules::new(), stepped());
    for dof in Dof::ALL {
        let found = Converged::new(
            &blade,
            dof,
            &Wanted { range: (0.0, 1e4), count: 3, also_at: &[] },
            &rules,
            &Work::default(),
        )
        .unwrap();
        let functions = found.functions();
        let fields = crate::lagrange::Fields::sample(found.grid(), &functions);
        let rigid = crate::functions::AssumedFunctions::has_rigid_motion(&functions);
        let sampled = assemble(found.grid(), Energies::new(found.grid(), &fields), rigid);
        for (a, b) in [
            (sampled.mass(), found.matrices().mass()),
            (sampled.stiffness(), found.matrices().stiffness()),
            (sampled.centrifugal(), found.matrices().centrifugal()),
        ] {
            assert!((a - b).amax() < 1e-11 * b.amax(), "{dof}: {:e}", (a - b).amax() / b.amax());
        }
    }
}

/// More polynomials, smaller errors, at an exponential rate.
#[test]
fn the_error_falls_exponentially_with_the_order() {
    let (rules, blade) = (GaussRules::new(), stepped());
    let errors: Vec<f64> = [4, 7, 10]
        .into_iter()
        .map(|order| Converged::with_order(&blade, Dof::Flap, 0.0, 3, order, &rules, &Work::default()).unwrap().error())
        .collect();
    assert!(errors[1] < 1e-2 * errors[0] && errors[2] < 1e-2 * errors[1], "{errors:?}");
}

/// Light soft stretches between heavy stiff blocks. What lives in the middle stretch alone does not show
/// at the tip nor in loads on the whole blade, and is counted.
#[test]
fn modes_between_heavy_blocks_are_all_found() {
    let text = r#"
        schema = "bladefan-blade/1"
        name = "blocks"
        rotor = { radius = 1, nominal_speed = 1 }
        flap = { root = "hingeless", offset = 0.05 }
        lag = { root = "hinged", offset = 0.05 }
        torsion = { root = "rigid", offset = 0.05 }
        [distribution]
        r = [0.05, 0.3, 0.3, 0.35, 0.35, 0.6, 0.6, 0.65, 0.65, 0.9, 0.9, 1]
        mass = [0.01, 0.01, 1e4, 1e4, 0.01, 0.01, 1e4, 1e4, 0.01, 0.01, 1e4, 1e4]
        flap_stiffness = [1, 1, 1e6, 1e6, 1, 1, 1e6, 1e6, 1, 1, 1e6, 1e6]
        lag_stiffness = [1, 1, 1e6, 1e6, 1, 1, 1e6, 1e6, 1, 1, 1e6, 1e6]
        torsion_stiffness = [1, 1, 1e6, 1e6, 1, 1, 1e6, 1e6, 1, 1, 1e6, 1e6]
        polar_inertia = [1e-6, 1e-6, 10, 10, 1e-6, 1e-6, 10, 10, 1e-6, 1e-6, 10, 10]
    "#;
    let blade = crate::formats::read(text, crate::formats::Format::Toml).unwrap().blade;
    for dof in Dof::ALL {
        // The blocks have a motion or two each in bending, the soft stretches come after those.
        for count in [6, 9, 12] {
            let found = converged(&blade, dof, 0.0, count);
            assert!(found.counted().is_some(), "{dof}, {count} modes, error {:e}", found.error());
            let values = crate::modes::eigenvalues(found.matrices(), 0.0, count).unwrap().values;
            let last = values[count - 1];
            let below = values.iter().filter(|value| **value < 0.9999 * last).count();
            assert_eq!(found.count_below(0.9999 * last, 0.0), Some(below), "{dof}, {count} modes");
        }
    }
}
