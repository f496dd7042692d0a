//! A fan chart against the modes of single speeds: 500 random soft blades, over ranges up to ten times
//! nominal speed, on which a few functions and a few nodes of a curve must stand for all speeds.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use bladefan_core::Dof;
use bladefan_core::Warning;
use bladefan_core::{ModelKind, Settings, SpeedRange, fan, modes};
use bladefan_tests::blades::TestBlade;
use bladefan_tests::random::{blade, part_of_cases};
use proptest::prelude::*;

/// What a chart may be off without a word, as a part of the frequency.
const UNWARNED: f64 = 1e-9;
/// Speeds of a chart, and every which of them is solved for alone.
const SPEEDS: usize = 57;
const EACH: usize = 8;
const MODES: usize = 4;

/// The error that the warnings own up to for one degree of freedom. It is of one digit, of the first order,
/// and looked at in a dozen speeds: three times it, and any where it is no small number.
fn warned(warnings: &[Warning], dof: Dof) -> f64 {
    let own = warnings.iter().filter(|warning| warning.path == dof.name());
    let errors = own.filter_map(|warning| {
        let (_, rest) = warning.message.split_once("converged to ")?;
        rest.split(' ').next()?.parse::<f64>().ok()
    });
    let worst = errors.fold(0.0, f64::max);
    if worst > 1e-2 { f64::INFINITY } else { 3.0 * worst }
}

fn is_as_good_as_single_speeds(blade: &TestBlade, dof: Dof, softer: f64, range: f64) -> Result<(), TestCaseError> {
    let mut blade = blade.clone();
    for stiffness in &mut blade.stiffness {
        *stiffness = stiffness.times(softer);
    }
    let to = range * blade.nominal_speed;
    let checked = blade.blade();
    let settings = Settings {
        dofs: vec![dof],
        modes: MODES,
        speeds: Some(SpeedRange { from: 0.0, to, count: SPEEDS }),
        ..Settings::of(ModelKind::Uncoupled)
    };
    let chart = fan(&checked, &settings).unwrap();
    let of_chart = warned(&chart.warnings, dof);
    for (index, &speed) in chart.speeds_rad_s.iter().enumerate().skip(1).step_by(EACH) {
        let report = modes(&checked, &Settings { speed: Some(speed), ..settings.clone() }).unwrap();
        let allowed = UNWARNED + of_chart + warned(&report.warnings, dof);
        for (branch, mode) in chart.branches.iter().zip(&report.modes) {
            let (found, exact) = (branch.frequency_rad_s[index], mode.frequency_rad_s);
            // The equation of lag holds ω² + Ω², so that is what an error is a part of.
            let size = exact * exact + if dof == Dof::Lag { speed * speed } else { 0.0 };
            let error = (found * found - exact * exact).abs();
            prop_assert!(
                error <= 2.0 * allowed * size,
                "{} at {speed} rad/s: {found} in the chart, {exact} alone, {:e} allowed, {:?}",
                mode.label,
                allowed,
                chart.warnings
            );
        }
    }
    Ok(())
}

macro_rules! soft_blades {
    ($($name:ident: $part:literal, $dof:expr, $cases:literal;)+) => {$(
        proptest! {
            #![proptest_config(part_of_cases($part, $cases))]

            #[test]
            fn $name(blade in blade(), softer in -6.0..0.0_f64, range in 0.5..10.0_f64) {
                is_as_good_as_single_speeds(&blade, $dof, 10_f64.powf(softer), range)?;
            }
        }
    )+};
}

soft_blades! {
    soft_in_flap: 21, Dof::Flap, 170;
    soft_in_lag: 22, Dof::Lag, 165;
    soft_in_torsion: 23, Dof::Torsion, 165;
}
