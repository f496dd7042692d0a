//! Branches of coupled charts follow from the blade and its nominal speed, whatever was asked for.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use bladefan_core::report::{Branch, FanChart, VeeringReport};
use bladefan_core::{Blade, ModelKind, Settings, SpeedRange, check, fan};
use bladefan_tests::coupled::CoupledBlade;
use bladefan_tests::coupled::random::case;

/// Modes asked for.
const MODES: usize = 8;
/// Frequencies of two ranges, each converged to 1e-10 in λ: seen 2e-11 apart.
const FREQUENCY: f64 = 1e-10;
/// A least distance is flat: errors of 1e-11 move its place, as a share of nominal speed, by some root of that; seen
/// 1.2e-5 where it hardly changes over a node.
const PLACE: f64 = 1e-4;
/// Where branches cross, the distance found, as a share of the frequency, is what they part by over the error of the
/// place; seen 7e-9 apart.
const GAP: f64 = 1e-7;

/// A blade of this nominal speed.
fn blade(blade: &CoupledBlade, nominal: f64) -> Blade {
    let mut definition = blade.definition();
    definition.rotor.as_mut().unwrap().nominal_speed = Some(nominal);
    check(&definition).unwrap()
}

fn chart(blade: &Blade, rotary: bool, to: f64, count: usize) -> FanChart {
    let settings = Settings {
        speeds: Some(SpeedRange { from: 0.0, to, count }),
        model: Some(ModelKind::Coupled),
        coupled_modes: MODES,
        rotary,
        harmonics: 1,
        ..Settings::default()
    };
    fan(blade, &settings).unwrap_or_else(|faults| panic!("{faults}"))
}

/// The random blade of this number and its nominal speed; at rest alone there are no branches.
fn at_speed(number: u64) -> Option<(CoupledBlade, f64)> {
    let case = case(number);
    (case.speed > 0.0).then_some((case.blade, case.speed))
}

/// Bits of numbers, of those that are none, too.
fn bits(values: impl IntoIterator<Item = f64>) -> Vec<u64> {
    values.into_iter().map(f64::to_bits).collect()
}

/// Of every blade that veers or crosses 3, 11 and 121 speeds show the same veerings, names and meetings with rays and,
/// where they coincide, the same frequencies to the last bit.
#[test]
fn the_number_of_speeds_changes_nothing() {
    let mut seen = [0, 0];
    for (own, nominal) in (0..120).filter_map(at_speed) {
        let checked = blade(&own, nominal);
        let few = chart(&checked, own.rotary, 1.2 * nominal, 3);
        for (count, kind) in seen.iter_mut().zip(["crossing", "veering"]) {
            *count += few.veerings.iter().filter(|found| found.kind == kind).count();
        }
        for count in if few.veerings.is_empty() { vec![] } else { vec![11, 121] } {
            let many = chart(&checked, own.rotary, 1.2 * nominal, count);
            assert_eq!(many.veerings, few.veerings);
            assert_eq!(many.nominal, few.nominal);
            assert_eq!(many.crossings, few.crossings);
            let names = |chart: &FanChart| -> Vec<_> {
                let of = |branch: &Branch| (branch.label, branch.labels.clone(), branch.southwell);
                chart.branches.iter().map(of).collect()
            };
            assert_eq!(names(&many), names(&few));
            for (many, few) in many.branches.iter().zip(&few.branches) {
                let there = many.frequency_rad_s.iter().step_by((count - 1) / 2).copied();
                assert_eq!(bits(there), bits(few.frequency_rad_s.iter().copied()), "{} of {count}", few.label);
            }
        }
    }
    // Without any the test would say nothing.
    assert!(seen[0] >= 10 && seen[1] >= 20, "{seen:?}");
}

/// The end of the range decides on the functions, and no more: up to there, the same branches.
#[test]
fn the_end_of_the_range_changes_nothing_before_it() {
    let mut compared = 0;
    for (own, nominal) in (0..60).filter_map(at_speed) {
        let checked = blade(&own, nominal);
        // The nodes from which least distances are sought are the same; the range of the second is longer.
        let [near, far] = [1.2, 2.4].map(|ratio| chart(&checked, own.rotary, ratio * nominal, 13));
        let before = |chart: &FanChart| -> Vec<VeeringReport> {
            chart.veerings.iter().filter(|found| found.speed_rad_s < 1.15 * nominal).copied().collect()
        };
        let (short, long) = (before(&near), before(&far));
        compared += short.len();
        assert_eq!(short.len(), long.len(), "{short:?} {long:?}");
        for (a, b) in short.iter().zip(&long) {
            assert_eq!((a.branches, a.kind), (b.branches, b.kind));
            assert!((a.speed_rad_s - b.speed_rad_s).abs() <= PLACE * nominal, "{a:?} {b:?}");
            let share = |found: &VeeringReport| found.gap_rad_s / found.frequency_rad_s;
            assert!((share(a) - share(b)).abs() <= GAP, "{a:?} {b:?}");
        }
        for (a, b) in near.branches.iter().zip(&far.branches) {
            assert_eq!(a.label, b.label);
            for i in 0..=6 {
                let (a, b) = (a.frequency_rad_s[2 * i], b.frequency_rad_s[i]);
                // Without a number where unstable.
                assert!((a.is_nan() && b.is_nan()) || (a - b).abs() <= FREQUENCY * a, "{a} against {b}");
            }
        }
    }
    assert!(compared >= 20, "{compared}");
}
