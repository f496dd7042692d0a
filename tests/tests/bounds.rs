//! Two-sided bounds against the independent solution of [`bladefan_tests::exact`]: on random blades,
//! on blades with very short pieces, and where the answer is known exactly.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use bladefan_core::Dof;
use bladefan_core::Settings;
use bladefan_core::report::ModeReport;
use bladefan_tests::blades::{End, Hold, Table, TestBlade};
use bladefan_tests::bracket::{Case, Wrong};
use bladefan_tests::coupled::PointMass;
use bladefan_tests::exact::Exact;
use bladefan_tests::random::{blade, laden, part_of_cases, racket};
use bladefan_tests::solve::{converged_settings, settings, solve_with};
use proptest::prelude::*;

/// At rest, or up to one and a half times nominal speed.
fn speed() -> impl Strategy<Value = f64> {
    prop_oneof![1 => Just(0.0), 3 => 0.0..1.5_f64]
}

/// Speed as a part of nominal speed, number of modes, number of classical functions.
type How = (f64, usize, usize);

/// Both families on one random blade held in one way. Springs keep the stiffness they were drawn
/// with, or take one of the order of the stiffness itself.
fn both(mut blade: TestBlade, dof: Dof, hold: Hold, (part, count, functions): How) -> Result<(), TestCaseError> {
    let root = &mut blade.roots[dof.index()];
    root.hold = match (hold, root.hold) {
        (Hold::Spring(_), Hold::Spring(k)) => Hold::Spring(k),
        (Hold::Spring(k), _) => Hold::Spring(k * blade.stiffness[dof.index()].y[0] / blade.radius),
        (other, _) => other,
    };
    let case = Case { blade: &blade, dof, speed: part * blade.nominal_speed, count };
    // Thick sections may turn upright at speed: such a blade has no frequencies.
    if blade.inertias.is_some()
        && Exact::<f64>::new(&blade, dof, case.speed, case.speed).count_below(case.speed, 0.0) > 0
    {
        return Ok(());
    }
    let fail = |wrong: Wrong| TestCaseError::fail(wrong.to_string());
    case.check_converged().map_err(fail)?;
    case.check_classical(functions).map_err(fail)
}

/// So many cases of each test, so that they run side by side.
macro_rules! random_blades {
    ($count:literal of $blades:expr; $($name:ident: $part:literal, $dof:expr, $hold:expr;)+) => {$(
        proptest! {
            #![proptest_config(part_of_cases($part, $count))]

            #[test]
            fn $name(blade in $blades, how in (speed(), 3..=5_usize, 6..=40_usize)) {
                both(blade, $dof, $hold, how)?;
            }
        }
    )+};
}

random_blades! {
    112 of blade();
    clamped_in_flap: 1, Dof::Flap, Hold::Clamped;
    hinged_in_flap: 2, Dof::Flap, Hold::Free;
    sprung_in_flap: 3, Dof::Flap, Hold::Spring(1.0);
    clamped_in_lag: 4, Dof::Lag, Hold::Clamped;
    hinged_in_lag: 5, Dof::Lag, Hold::Free;
    sprung_in_lag: 6, Dof::Lag, Hold::Spring(1.0);
    clamped_in_torsion: 7, Dof::Torsion, Hold::Clamped;
    free_in_torsion: 8, Dof::Torsion, Hold::Free;
    sprung_in_torsion: 9, Dof::Torsion, Hold::Spring(1.0);
}

random_blades! {
    40 of laden();
    laden_and_clamped_in_flap: 11, Dof::Flap, Hold::Clamped;
    laden_and_hinged_in_flap: 12, Dof::Flap, Hold::Free;
    laden_and_sprung_in_flap: 13, Dof::Flap, Hold::Spring(1.0);
    laden_and_clamped_in_lag: 14, Dof::Lag, Hold::Clamped;
    laden_and_hinged_in_lag: 15, Dof::Lag, Hold::Free;
    laden_and_sprung_in_lag: 16, Dof::Lag, Hold::Spring(1.0);
    laden_and_clamped_in_torsion: 17, Dof::Torsion, Hold::Clamped;
    laden_and_free_in_torsion: 18, Dof::Torsion, Hold::Free;
    laden_and_sprung_in_torsion: 19, Dof::Torsion, Hold::Spring(1.0);
}

random_blades! {
    60 of racket();
    turning_flat_clamped: 21, Dof::Torsion, Hold::Clamped;
    turning_flat_free: 22, Dof::Torsion, Hold::Free;
    turning_flat_sprung: 23, Dof::Torsion, Hold::Spring(1.0);
}

fn bounds_of(blade: &TestBlade, settings: &Settings) -> Vec<(f64, f64)> {
    let bounds = |mode: &ModeReport| (mode.lower_rad_s.unwrap(), mode.upper_rad_s.unwrap());
    solve_with(&blade.blade(), settings).iter().map(bounds).collect()
}

/// Lower bounds by an independent evaluation of the method with the classical functions in 50-digit
/// arithmetic (mpmath), ρ a fifth of the way from λ₆ down to λ₅. Asked for: the digits given.
#[test]
fn lower_bounds_of_eight_classical_functions() {
    let expected = [51.260_618_82, 308.943_548_06, 824.267_559_3, 1_502.259_898_58, 2_280.018_599_23];
    let bounds = bounds_of(&TestBlade::stepped(), &settings(Dof::Flap, 0.0, 8, 5));
    for ((lower, _), expected) in bounds.iter().zip(expected) {
        assert!((lower / expected - 1.0).abs() < 2e-10, "{lower} against {expected}");
    }
}

/// Stiffness that tapers 300 : 1 within a piece divides what is integrated: eight points more than
/// the functions need once put the lower bound of the first mode 1e-5 too high.
#[test]
fn lower_bounds_on_a_strong_taper() {
    let taper = |r: [f64; 6], y: [f64; 6]| Table { r: r.into(), y: y.into() };
    let lag = taper([0.0, 0.1515, 0.1515, 0.207, 0.207, 0.3], [1.0, 1.0, 0.0688, 19.845, 1.0, 1.0]);
    let flap = taper([0.0, 0.0015, 0.0015, 0.0315, 0.0315, 0.3], [0.142, 1.0, 12.994, 0.061, 1.0, 1.0]);
    for (stiffness, spring) in [(lag, 3.333), (flap, 0.4731)] {
        let blade =
            TestBlade::uniform(0.3).with_root(Dof::Flap, End::spring(0.0, spring)).with_stiffness(Dof::Flap, stiffness);
        let case = Case { blade: &blade, dof: Dof::Flap, speed: 0.0, count: 4 };
        for functions in [6, 12, 24] {
            case.check_classical(functions).unwrap_or_else(|wrong| panic!("{functions} functions: {wrong}"));
        }
    }
}

/// A motion without any strain or pull has the frequency 0, and no rounding is let near it.
#[test]
fn motions_without_energy_are_known_exactly() {
    let loose = stepped_from_the_centre()
        .with_root(Dof::Flap, End::free(0.09))
        .with_root(Dof::Lag, End::free(0.0))
        .with_root(Dof::Torsion, End::free(0.09));
    let offset = stepped_from_the_centre().with_root(Dof::Lag, End::free(0.09));
    let sprung = stepped_from_the_centre().with_root(Dof::Lag, End::spring(0.09, 0.0));
    let heavy = PointMass { r: 0.7, mass: 2.0, offset: 0.0, inertia: [0.01, 0.02] };
    let laden = TestBlade { point_masses: vec![heavy, PointMass { r: 0.962, ..heavy }], ..loose.clone() };
    // Without a mass offset nothing turns a blade back that is free in pitch.
    let cases = [
        (&laden, Dof::Flap, &[0.0][..]),
        (&laden, Dof::Lag, &[0.0, 1.0, 105.0]),
        (&laden, Dof::Torsion, &[0.0, 105.0]),
        (&loose, Dof::Flap, &[0.0]),
        (&loose, Dof::Lag, &[0.0, 1e-3, 1.0, 105.0, 1e4]),
        (&loose, Dof::Torsion, &[0.0, 105.0]),
        (&offset, Dof::Lag, &[0.0]),
        (&sprung, Dof::Lag, &[0.0]),
    ];
    for (blade, dof, speeds) in cases {
        for &speed in speeds {
            for count in [1, 5] {
                for settings in [converged_settings(dof, speed, count), settings(dof, speed, 15, count)] {
                    let mode = &solve_with(&blade.blade(), &settings)[0];
                    let found = (mode.lower_rad_s, mode.frequency_rad_s, mode.upper_rad_s);
                    assert_eq!(found, (Some(0.0), 0.0, Some(0.0)), "{dof} at {speed}, {:?}", settings.basis);
                }
            }
        }
    }
}

/// Almost at rest, or on a very soft spring, the first mode lies many orders of magnitude below the
/// others; all keep their bounds. Below 1e-7 rad/s rounding widens them, to 8e-8 at 1e-8.
#[test]
fn first_mode_far_below_the_others() {
    for power in 0..=7 {
        let small = 0.1_f64.powi(power);
        let free = TestBlade { roots: [End::free(0.09); 3], mass_offset: Table::uniform(0.01), ..TestBlade::stepped() };
        let soft = TestBlade { roots: [End::spring(0.09, small); 3], ..free.clone() };
        for dof in Dof::ALL {
            for (blade, speed) in [(&free, small), (&soft, 0.0), (&soft, small)] {
                for count in [1, 5] {
                    let case = Case { blade, dof, speed, count };
                    let checked = case.check_converged().and_then(|_| case.check_classical(20));
                    checked.unwrap_or_else(|wrong| panic!("{small:e}: {wrong}"));
                }
            }
        }
    }
}

/// A blade on a flap hinge at the rotor's centre keeps its plane of rotation: ω = Ω, whatever its
/// stiffness. A few roundings.
#[test]
fn central_flap_hinge_turns_with_the_rotor() {
    let stepped = stepped_from_the_centre().with_root(Dof::Flap, End::free(0.0));
    let uniform = TestBlade::uniform(1.0).with_root(Dof::Flap, End::free(0.0));
    let tip = PointMass { r: 0.962, mass: 3.0, offset: 0.0, inertia: [0.0; 2] };
    let laden = TestBlade { point_masses: vec![PointMass { r: 0.5, ..tip }, tip], ..stepped.clone() };
    let cases = [(stepped, [1.0, 105.0, 1e4]), (uniform, [1e-3, 1.0, 1e3]), (laden, [1.0, 105.0, 1e4])];
    for (blade, speeds) in cases {
        for speed in speeds {
            for count in [1, 5] {
                let mode = &solve_with(&blade.blade(), &converged_settings(Dof::Flap, speed, count))[0];
                let error = mode.frequency_rad_s / speed - 1.0;
                assert!(error.abs() < 1e-12, "{count} modes at {speed}: {error:e}");
                let around = mode.lower_rad_s.unwrap()..=mode.upper_rad_s.unwrap() * (1.0 + 1e-15);
                assert!(around.contains(&speed), "{around:?} around {speed}");
            }
        }
    }
}

/// The stepped blade, from the centre outward.
fn stepped_from_the_centre() -> TestBlade {
    let radii = [0.0, 0.2, 0.3, 0.962];
    let stiffness = Table::steps(&radii, &[1500.0, 60.0, 17.0]);
    TestBlade {
        mass: Table::steps(&radii, &[1.5, 0.8, 0.34]),
        stiffness: [stiffness.clone(), stiffness.clone(), stiffness],
        ..TestBlade::stepped()
    }
}

/// A stepped blade with one very stiff and one very soft piece of 1/2000 of its radius.
fn pinched(at: f64, factors: [f64; 2], length: f64) -> TestBlade {
    let tip = 0.962;
    let base = TestBlade::stepped();
    let value = |table: &Table, r: f64| {
        let piece = (0..table.r.len() - 1).step_by(2).rfind(|&i| table.r[i] <= r).unwrap();
        table.y[piece]
    };
    let cuts = [at, at + length, at + 2.0 * length];
    let mut radii: Vec<f64> = [0.09, 0.2, 0.3, tip].into_iter().chain(cuts).collect();
    radii.sort_by(f64::total_cmp);
    let changed = |table: &Table, factors: [f64; 2]| {
        let values: Vec<f64> = radii
            .windows(2)
            .map(|ends| {
                let own = value(table, ends[0]);
                let factor =
                    cuts.iter().position(|cut| (cut - ends[0]).abs() < 0.5 * length).and_then(|i| factors.get(i));
                own * factor.unwrap_or(&1.0)
            })
            .collect();
        Table::steps(&radii, &values)
    };
    TestBlade {
        mass: changed(&base.mass, [3.0, 0.2]),
        stiffness: [0, 1, 2].map(|i| changed(&base.stiffness[i], factors)),
        ..base
    }
}

/// Both families with every kind of root, at rest and turning.
fn check_roots(blade: &TestBlade, what: &str) {
    for make in [End::clamped, End::free, |offset| End::spring(offset, 40.0)] {
        let blade = TestBlade { roots: [make(0.09); 3], ..blade.clone() };
        for dof in Dof::ALL {
            for speed in [0.0, 105.0] {
                let case = Case { blade: &blade, dof, speed, count: 5 };
                let checked = case.check_converged().and_then(|_| case.check_classical(20));
                checked.unwrap_or_else(|wrong| panic!("{what}: {wrong}"));
            }
        }
    }
}

/// Near the root and at mid-span: a piece of a two-thousandth of the radius a thousand times stiffer
/// beside one a thousand times softer. Errors and widths as on any blade.
#[test]
fn very_short_pieces() {
    for at in [0.091, 0.5] {
        for factors in [[1e3, 1e-3], [1e-3, 1e3]] {
            check_roots(&pinched(at, factors, 0.962 / 2000.0), &format!("{factors:?} at {at}"));
        }
    }
}

/// Radii of different properties that were meant to be one, 1e-12 of the radius apart: nothing may
/// divide by their distance, in which mass and stiffness go a thousandfold or stay.
#[test]
fn slivers() {
    let tip = 0.962;
    for at in [0.15, 0.5] {
        for order in [[0.0, 1.0, 2.0, 3.0], [3.0, 2.0, 1.0, 0.0]] {
            for factor in [1.0_f64, 1e3, 1e-3] {
                let cut = |i: usize| [0.09, at + 1e-12 * tip * order[i], tip];
                let step = |i: usize, inner: f64, outer: f64| Table::steps(&cut(i), &[inner, outer]);
                let stiffness = step(1, 20.0 * factor.max(1.0), 20.0 / factor.min(1.0));
                let blade = TestBlade {
                    mass: step(0, 1.5, 0.34),
                    stiffness: [stiffness.clone(), stiffness.clone(), stiffness],
                    polar_inertia: step(2, 1e-3, 1e-4),
                    mass_offset: step(3, 0.0, 0.01),
                    ..TestBlade::stepped()
                };
                check_roots(&blade, &format!("factor {factor} at {at}"));
            }
        }
    }
}
