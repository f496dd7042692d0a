//! How much of a fan chart to show.

use super::super::ChartOptions;
use super::units::Units;
use crate::dof::Dof;
use crate::report::{Branch, Crossing, FanChart, MeasuredPoint};
use alloc::vec::Vec;

/// Rays up to at least this harmonic count as of interest.
const LEAST_HARMONICS: u32 = 8;
/// The frequency axis goes no further than this many times the highest ray, so that high
/// branches do not press the low ones flat.
const ABOVE_REACH: f64 = 1.5;
/// As many of the lowest branches are shown wherever they are.
const LEAST_BRANCHES: usize = 3;

/// Ranges of both axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Range {
    /// Least rotor speed [rad/s].
    pub from_speed: f64,
    /// Largest rotor speed [rad/s].
    pub to_speed: f64,
    /// Lower end of the frequency axis, in its unit.
    pub bottom: f64,
    /// Upper end.
    pub top: f64,
    /// Whether rays or branches leave through the top.
    pub open: bool,
}

impl Range {
    /// All speeds of the chart; frequencies as asked for, or from 0 to the highest of what the rays
    /// can meet.
    pub(super) fn of(chart: &FanChart, options: &ChartOptions, units: Units) -> Self {
        let speeds = chart.speeds_rad_s.iter().copied().filter(|speed| speed.is_finite());
        let from_speed = speeds.clone().reduce(f64::min).unwrap_or(0.0);
        let to_speed = speeds.reduce(f64::max).filter(|&to| to > from_speed);
        let to_speed = to_speed.unwrap_or(from_speed + 1.2 * chart.nominal.speed_rad_s.abs().max(1e-9));
        let spans: Vec<(f64, f64)> = chart.branches.iter().filter_map(span).collect();
        let steepest = f64::from(chart.harmonics) * to_speed;
        let (bottom, top) = match options.window() {
            Some(window) => window,
            // The highest ray, and room for its label.
            None if units.per_rev() => {
                let highest = f64::from(chart.harmonics);
                (0.0, highest + (0.04 * highest).max(0.3))
            }
            None => {
                let top = top(chart, options.measured, (from_speed, to_speed), &spans);
                let open = steepest > top || spans.iter().any(|span| span.0 < top && span.1 > top);
                let top = units.frequency(top, to_speed).unwrap_or(top);
                return Self { from_speed, to_speed, bottom: 0.0, top, open };
            }
        };
        let rays = !units.per_rev() && units.frequency(steepest, to_speed).is_some_and(|end| end > top);
        let open = rays || chart.branches.iter().any(|branch| leaves(branch, chart, units, top));
        Self { from_speed, to_speed, bottom, top, open }
    }

    /// Whether some of the operating band shows.
    pub(super) fn meets(&self, nominal: f64, band: (f64, f64)) -> bool {
        nominal > 0.0 && band.0 * nominal < self.to_speed && band.1 * nominal > self.from_speed && band.0 < band.1
    }

    /// Whether a crossing shows.
    pub(super) fn holds(&self, crossing: &Crossing, units: Units) -> bool {
        let frequency = units.frequency(crossing.frequency_rad_s, crossing.speed_rad_s);
        (self.from_speed..=self.to_speed).contains(&crossing.speed_rad_s)
            && frequency.is_some_and(|frequency| (self.bottom..=self.top).contains(&frequency))
    }
}

/// Frequency [rad/s] at the top of an axis that begins at 0.
fn top(chart: &FanChart, measured: &[MeasuredPoint], (from_speed, to_speed): (f64, f64), spans: &[(f64, f64)]) -> f64 {
    let reach = f64::from(chart.harmonics.max(LEAST_HARMONICS)) * to_speed;
    let mut spans = spans.to_vec();
    spans.sort_by(|a, b| a.1.total_cmp(&b.1));
    let shown = spans.iter().filter(|span| span.0 <= reach).map(|span| span.1.min(ABOVE_REACH * reach));
    let lowest = spans.iter().take(LEAST_BRANCHES).map(|span| span.1);
    let points = measured.iter().filter(|point| {
        (from_speed..=to_speed).contains(&point.speed_rad_s) && point.frequency_rad_s <= ABOVE_REACH * reach
    });
    let points = points.map(|point| point.frequency_rad_s);
    let mut top = shown.chain(lowest).chain(points).fold(0.0, f64::max);
    // The first of each degree of freedom too, where that is not far.
    for dof in Dof::ALL {
        let first = chart.branches.iter().filter(|branch| branch.dof == dof).filter_map(span).map(|span| span.1);
        let first = first.reduce(f64::min).unwrap_or(0.0);
        if first <= 2.0 * top {
            top = top.max(first);
        }
    }
    // And those that would only come into view cut off.
    for span in &spans {
        if span.0 < 1.04 * top && span.1 > top && span.1 <= f64::max(ABOVE_REACH * reach, 1.3 * top) {
            top = span.1;
        }
    }
    let top = if top > 0.0 { top } else { reach };
    // Air above the highest curve.
    1.04 * top
}

/// Whether a branch rises through `top` (in the axis' unit).
fn leaves(branch: &Branch, chart: &FanChart, units: Units, top: f64) -> bool {
    let values = chart.speeds_rad_s.iter().zip(&branch.frequency_rad_s);
    let values: Vec<Option<f64>> = values.map(|(&speed, &frequency)| units.frequency(frequency, speed)).collect();
    values.windows(2).any(|pair| matches!(pair, [Some(a), Some(b)] if *a <= top && *b > top))
}

/// Lowest and highest frequency of a branch.
fn span(branch: &Branch) -> Option<(f64, f64)> {
    let values = branch.frequency_rad_s.iter().copied().filter(|value| value.is_finite());
    values.fold(None, |span, value| {
        let (low, high) = span.unwrap_or((value, value));
        Some((f64::min(low, value), f64::max(high, value)))
    })
}
