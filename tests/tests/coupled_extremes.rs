//! Coupled blades at the edge of what can be solved, against the exact count.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test stops where it fails, and shows what it measured"
)]

extern crate alloc;

use alloc::collections::BTreeMap;
use bladefan_core::report::CoupledModesReport;
use bladefan_core::{FaultCode, ModelKind, Settings, check, coupled_modes};
use bladefan_tests::coupled::Exact;
use bladefan_tests::coupled::extreme::extreme;

/// Modes asked for.
const MODES: usize = 8;
/// Error of a bounded eigenvalue: of itself, and of the highest, since of a mode far below the others it is absolute.
const ERROR: [f64; 2] = [1e-8, 1e-12];
/// Panels of the exact count, as shares of what is proven to be short enough. On these blades the count on the longest
/// wavers by up to 2e-11: only what all of them contradict is wrong.
const PANELS: [f64; 4] = [1.0, 0.5, 0.3, 0.1];
/// Blades without a proof or an answer, as a share: seen 0.02, a tenth of the strings and a twentieth of those with
/// heavy tips.
const WITHOUT: f64 = 0.05;

/// Blades in a run; more where BLADEFAN_COUPLED says so.
fn cases() -> u64 {
    std::env::var("BLADEFAN_COUPLED").ok().and_then(|text| text.parse().ok()).unwrap_or(400)
}

/// What was seen of a kind.
#[derive(Debug, Default)]
#[allow(dead_code, reason = "shown")]
struct Seen {
    blades: usize,
    refused: Vec<u64>,
    without: Vec<u64>,
    unstable: usize,
    intervals: usize,
    widest: f64,
}

/// Adds what was seen and says what is wrong: every interval holds its eigenvalue or is absent with a reason, and what
/// is bounded is right to [`ERROR`].
fn judge(report: &CoupledModesReport, exact: &mut [Exact], seen: &mut Seen, number: u64) -> Vec<String> {
    let mut wrong = Vec::new();
    if report.modes.len() < MODES && report.warnings.is_empty() {
        wrong.push(format!("{} modes and no word of it", report.modes.len()));
    }
    let size = report.modes.last().map_or(1.0, |mode| mode.eigenvalue_s2.abs());
    for (index, mode) in report.modes.iter().enumerate() {
        seen.unstable += usize::from(mode.unstable);
        let (Some(low), Some(up)) = (mode.lower_eigenvalue_s2, mode.upper_eigenvalue_s2) else {
            seen.without.push(number);
            wrong.extend(mode.bounds_missing.is_none().then(|| format!("mode {}: no reason", index + 1)));
            continue;
        };
        seen.intervals += 1;
        if !(low..=up).contains(&mode.eigenvalue_s2) {
            wrong.push(format!("mode {}: {} outside its own [{low}, {up}]", index + 1, mode.eigenvalue_s2));
        }
        seen.widest = seen.widest.max((up - low) / (mode.eigenvalue_s2.abs() + 1e-6 * size));
        let near = ERROR[0] * mode.eigenvalue_s2.abs() + ERROR[1] * size;
        let around = (mode.eigenvalue_s2 - near, mode.eigenvalue_s2 + near);
        // [0, 0] is read off the roots; the count tells 0 from the rounding of the stiffest part alone.
        let interval = Some((low, up)).filter(|interval| *interval != (0.0, 0.0));
        for (low, up) in interval.into_iter().chain([around]) {
            let why = exact.iter_mut().map(|exact| exact.contradiction(index + 1, low, up)).take_while(Option::is_some);
            let why: Vec<String> = why.flatten().collect();
            wrong.extend((why.len() == exact.len()).then(|| why.join(", ")));
        }
    }
    wrong
}

#[test]
fn intervals_hold_or_are_absent_with_a_reason() {
    let mut wrong = Vec::new();
    let mut kinds: BTreeMap<&str, Seen> = BTreeMap::new();
    for number in 0..cases() {
        let (kind, case) = extreme(number);
        let seen = kinds.entry(kind).or_default();
        seen.blades += 1;
        let blade = check(&case.blade.definition()).unwrap_or_else(|faults| panic!("{kind}, {number}: {faults}"));
        let settings = Settings {
            speed: Some(case.speed),
            model: Some(ModelKind::Coupled),
            coupled_modes: MODES,
            rotary: case.blade.rotary,
            ..Settings::default()
        };
        let place = format!("{kind}, {number} at {}", case.speed);
        match coupled_modes(&blade, &settings) {
            Ok(report) => {
                let mut exact = PANELS.map(|share| Exact::with_shorter_panels(&case.blade, case.speed, share));
                let found = judge(&report, &mut exact, seen, number);
                wrong.extend(found.into_iter().map(|why| format!("{place}: {why}")));
            }
            Err(faults) if faults.iter().all(|fault| fault.code == FaultCode::Unsolvable) => seen.refused.push(number),
            Err(faults) => wrong.push(format!("{place}: {faults}")),
        }
    }
    for seen in kinds.values_mut() {
        seen.without.dedup();
    }
    println!("{kinds:#?}");
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
    let without: usize = kinds.values().map(|seen| seen.refused.len() + seen.without.len()).sum();
    assert!(without as f64 <= WITHOUT * cases() as f64, "{without} without");
    // Divergence was among them.
    assert!(kinds.values().any(|seen| seen.unstable > 0));
}
