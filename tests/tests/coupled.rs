//! Coupled frequencies and their bounds against the exact solution of the strong form, which shares no code with
//! them.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test stops where it fails, and shows what it measured"
)]

use bladefan_core::{ModelKind, Settings, check, coupled_modes, fan};
use bladefan_tests::coupled::{Exact, random};

/// Blades in a run; more where BLADEFAN_COUPLED says so.
fn cases() -> u64 {
    std::env::var("BLADEFAN_COUPLED").ok().and_then(|text| text.parse().ok()).unwrap_or(500)
}

fn settings(speed: f64, rotary: bool) -> Settings {
    Settings { speed: Some(speed), rotary, ..Settings::of(ModelKind::Coupled) }
}

/// Random blades with every root, option and offset: λ to 1e-8, no interval that the exact count contradicts, and
/// exactly as many eigenvalues below the separation as it claims.
#[test]
fn random_blades_are_solved_and_bounded() {
    let mut worst = 0.0_f64;
    let (mut intervals, mut without, mut wrong) = (0, Vec::new(), Vec::new());
    for number in 0..cases() {
        let case = random::case(number);
        let blade = check(&case.blade.definition()).unwrap_or_else(|faults| panic!("{number}: {faults}"));
        let report = match coupled_modes(&blade, &settings(case.speed, case.blade.rotary)) {
            Ok(report) => report,
            Err(faults) => {
                wrong.push(format!("{number}: {faults}"));
                continue;
            }
        };
        let mut exact = Exact::new(&case.blade, case.speed);
        // Of a mode far below the others the width is absolute.
        let size = report.modes.last().map_or(1.0, |mode| mode.eigenvalue_s2.abs());
        for (index, mode) in report.modes.iter().enumerate() {
            let tolerance = 1e-8 * mode.eigenvalue_s2.abs() + 1e-12 * size;
            let (low, up) = (mode.eigenvalue_s2 - tolerance, mode.eigenvalue_s2 + tolerance);
            if let Some(why) = exact.contradiction(index + 1, low, up) {
                wrong.push(format!("{number}, mode {}: {why}", index + 1));
            }
            let (Some(low), Some(up)) = (mode.lower_eigenvalue_s2, mode.upper_eigenvalue_s2) else {
                without.push(format!("{number}: {:?}", mode.bounds_missing));
                continue;
            };
            intervals += 1;
            worst = worst.max((up - low) / (mode.eigenvalue_s2.abs() + 1e-6 * size));
            if let Some(why) = exact.contradiction(index + 1, low, up) {
                wrong.push(format!("{number}, bounds of mode {}: {why}", index + 1));
            }
        }
    }
    without.dedup();
    println!("{intervals} intervals, widest {worst:.1e}; without: {without:?}");
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
    // One blade in a hundred may be beyond what is proven; it says so.
    assert!(without.len() as u64 <= cases() / 100, "{without:?}");
}

/// Every bound of a chart, at each of its speeds.
#[test]
fn charts_are_bounded_at_every_speed() {
    let mut wrong = Vec::new();
    for number in 0..cases() / 20 {
        let case = random::case(number);
        let speed = if case.speed > 0.0 { case.speed } else { 1.0 };
        let mut definition = case.blade.definition();
        if let Some(rotor) = &mut definition.rotor {
            rotor.nominal_speed = Some(speed);
        }
        let blade = check(&definition).unwrap();
        let mut settings = settings(speed, case.blade.rotary);
        settings.set("speeds", &format!("0:{}:4", 1.2 * speed)).unwrap();
        let chart = fan(&blade, &settings).unwrap_or_else(|faults| panic!("{number}: {faults}"));
        for (at, speed) in chart.speeds_rad_s.iter().enumerate() {
            let mut exact = Exact::new(&case.blade, *speed);
            let mut found: Vec<(f64, f64, f64)> = chart
                .branches
                .iter()
                .filter_map(|branch| {
                    Some((branch.frequency_rad_s[at], branch.lower_rad_s[at]?, branch.upper_rad_s[at]?))
                })
                .collect();
            found.sort_by(|a, b| a.0.total_cmp(&b.0));
            // Modes without a frequency come first, and branches of the highest may have left the list.
            let unstable = chart.branches.iter().filter(|branch| branch.frequency_rad_s[at].is_nan()).count();
            for (index, (value, low, up)) in found.iter().enumerate().take(chart.branches.len().saturating_sub(2)) {
                // What is 0 in frequency may lie a rounding below in eigenvalue.
                let low = if *low > 0.0 { low * low } else { -1e-6 * (1.0 + up * up) };
                let number_of = index + 1 + unstable;
                if let Some(why) = exact.contradiction(number_of, low, up * up) {
                    wrong.push(format!("{number} at {speed}, {value}: {why}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
}
