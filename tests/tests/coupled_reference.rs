//! Coupled frequencies of other programs and formulations: the uniform part of the HART II blade, and a uniform blade
//! whose first flap and lag modes meet.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use bladefan_core::report::VeeringReport;
use bladefan_core::{Blade, ModelKind, Settings, SpeedRange, check, coupled_modes, fan};
use bladefan_tests::blades::{End, Table};
use bladefan_tests::coupled::{CoupledBlade, Trapeze};

fn frequencies(blade: &CoupledBlade, speed: f64, count: usize) -> Vec<f64> {
    let settings = Settings {
        speed: Some(speed),
        model: Some(ModelKind::Coupled),
        coupled_modes: count,
        rotary: blade.rotary,
        ..Settings::default()
    };
    let report = coupled_modes(&check(&blade.definition()).unwrap(), &settings).unwrap();
    report.modes.iter().map(|mode| mode.frequency_rad_s.unwrap()).collect()
}

/// The digits given, and no more: half a unit of the last, and a hair.
fn assert_digits(found: &[f64], known: &[(f64, i32)]) {
    for (found, (known, decimals)) in found.iter().zip(known) {
        assert!((found - known).abs() <= 0.501 * 10_f64.powi(-decimals), "{found}, known {known}");
    }
}

/// The uniform part of the HART II blade, with trapeze and rotary inertia and without a steady shape: two Ritz programs
/// with other functions, which stand beside geometrically exact beams. All digits that they give, 1e-7 and better.
#[test]
fn hart_ii() {
    let twist = |r: f64| (1.5 - r) * 0.069_813_170_1;
    let blade = CoupledBlade {
        mass: Table::uniform(0.95),
        torsion: Table::uniform(160.0),
        inertia: [1.7e-5, 7.0128e-4].map(Table::uniform),
        trapeze: Trapeze::AxialStiffness(Table::uniform(1.17e7)),
        twist: Table { r: vec![0.12, 2.0], y: vec![twist(0.12), twist(2.0)] },
        rotary: true,
        roots: [End::clamped(0.12); 3],
        ..CoupledBlade::uniform(2.0, [250.0, 5200.0])
    };
    let known = [92.02367, 119.49883, 303.45086, 418.92078, 523.85351, 556.16166, 868.70032, 1213.30096];
    assert_digits(&frequencies(&blade, 109.12, 8), &known.map(|known| (known, 5)));
}

/// EI 1 : 4, m = R = 1, no offsets, hardly any torsion: pitch shares the softening of lag. All digits of a Ritz program
/// with other functions.
fn uniform(pitch_degrees: f64) -> CoupledBlade {
    CoupledBlade { pitch: pitch_degrees.to_radians(), ..CoupledBlade::uniform(1.0, [1.0, 4.0]) }
}

#[test]
fn pitch_shares_the_softening_of_lag() {
    let at = |degrees: f64| frequencies(&uniform(degrees), 6.0, 4);
    assert_digits(&at(0.0), &[(7.36037, 5), (7.48702, 5)]);
    assert_digits(&at(30.0), &[(6.0524, 4), (8.57897, 5), (26.63754, 5), (46.352, 3)]);
    assert_digits(&at(90.0), &[(4.26323, 5), (9.59456, 5)]);
}

/// Where first flap and first lag of that blade come nearest, near 6 rad/s.
fn meeting(pitch_degrees: f64, nominal: f64) -> VeeringReport {
    let mut definition = uniform(pitch_degrees).definition();
    definition.rotor.as_mut().unwrap().nominal_speed = Some(nominal);
    let blade: Blade = check(&definition).unwrap();
    let settings = Settings {
        speeds: Some(SpeedRange { from: 0.0, to: 12.0, count: 3 }),
        model: Some(ModelKind::Coupled),
        coupled_modes: 4,
        rotary: false,
        ..Settings::default()
    };
    let chart = fan(&blade, &settings).unwrap();
    assert_eq!(chart.veerings.len(), 1, "{:?}", chart.veerings);
    chart.veerings[0]
}

/// How near they come, as a share of the upper frequency, to the digits given. Without pitch they meet; what is found
/// there is what they part by over the error of the place, a root of that of λ: seen 2.4e-9. Nominal speed, which
/// spaces the places that are looked at, moves the place by that root of 1e-13, seen 8e-7, and decides nothing.
#[test]
fn flap_and_lag_cross_or_veer() {
    for (pitch, kind, gap, digit) in [
        (0.0, "crossing", 0.0, 1e-7),
        (0.02, "crossing", 2.3e-4, 1e-5),
        (0.1, "crossing", 1.2e-3, 1e-4),
        (1.0, "veering", 1.2e-2, 1e-3),
        (5.0, "veering", 5.7e-2, 1e-3),
    ] {
        for nominal in [12.0, 3.0, 6.0, 24.0] {
            let found = meeting(pitch, nominal);
            let share = found.gap_rad_s / (found.frequency_rad_s + 0.5 * found.gap_rad_s);
            assert_eq!(found.kind, kind, "{pitch}");
            assert!((share - gap).abs() <= 0.501 * digit, "{pitch}: {share}, known {gap}");
            assert!((found.speed_rad_s - meeting(pitch, 12.0).speed_rad_s).abs() < 2e-6, "{pitch}: {found:?}");
        }
    }
}
