//! How good a frequency is, in words: its bounds, and how far other functions are from it.

use super::table::Cell;
use super::text::wrap;
use bladefan_core::BasisFamily;
use bladefan_core::figures::{decimals, significant};
use bladefan_core::units;

/// Bounds further apart than this share of the frequency do not hold three digits: not converged.
const CONVERGED: f64 = 1e-3;
/// Differences below this [%] are of no use to a reader of frequencies.
const LEAST_DIFFERENCE: f64 = 1e-4;
/// Errors below this [%] are rounding.
const LEAST_ERROR: f64 = 1e-10;

/// A frequency between its bounds [rad/s].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounded {
    frequency: f64,
    lower: f64,
    upper: f64,
}

impl Bounded {
    /// None where a bound is not known.
    pub(crate) fn new(frequency: Option<f64>, lower: Option<f64>, upper: Option<f64>) -> Option<Self> {
        Some(Self { frequency: frequency?, lower: lower?, upper: upper? })
    }

    pub(crate) fn converged(self) -> bool {
        // Written so that bounds that are no numbers are not converged, and bounds of zero are.
        self.upper - self.lower <= CONVERGED * self.frequency
    }

    /// `±2e-9`, or both bounds where they are far apart.
    fn words(self) -> String {
        if !self.converged() {
            let [lower, upper] = [self.lower, self.upper].map(|bound| significant(bound, 5));
            return format!("{lower} … {upper}, not converged");
        }
        let half = (self.frequency - self.lower).max(self.upper - self.frequency).max(0.0);
        if self.frequency == 0.0 && half == 0.0 { "exact".into() } else { format!("±{}", up(half)) }
    }
}

/// The bounds of a frequency.
pub(crate) fn bounds_cell(bounded: Option<Bounded>) -> Cell {
    bounded.map_or_else(|| Cell::text("-"), |bounded| Cell::text(bounded.words()))
}

/// What to do about modes that are not converged; nothing where all are.
pub(crate) fn advice(family: BasisFamily, modes: impl IntoIterator<Item = Option<Bounded>>, width: usize) -> String {
    if modes.into_iter().flatten().all(Bounded::converged) {
        return String::new();
    }
    let words = match family {
        BasisFamily::Classical => "use --basis piecewise, or more --functions",
        BasisFamily::Piecewise => "stiffness or radii vary too much for the functions that the program allows",
    };
    format!("\n{}\n", wrap(&format!("not converged: {words}"), 0, width))
}

/// `value` against `reference` [%].
pub(crate) fn percent(value: Option<f64>, reference: Option<f64>) -> Option<f64> {
    units::percent(value?, reference?)
}

/// A difference [%] with its sign.
pub(crate) fn difference(percent: Option<f64>) -> String {
    match percent {
        None => "-".into(),
        Some(0.0) => "0".into(),
        Some(percent) if percent.abs() < LEAST_DIFFERENCE => "<0.0001".into(),
        Some(percent) => format!("{percent:+.*}", decimals(percent, 2).min(4)),
    }
}

/// The same with its unit: `+0.098 %`.
pub(crate) fn difference_cell(percent: Option<f64>) -> Cell {
    let text = difference(percent);
    Cell::text(if percent.is_some() { text + " %" } else { text })
}

/// An error [%] without sign, down to rounding.
pub(crate) fn error_cell(percent: Option<f64>) -> Cell {
    Cell::text(match percent.map(f64::abs) {
        None => "-".into(),
        Some(0.0) => "0".into(),
        Some(percent) if percent < LEAST_ERROR => "<1e-10".into(),
        Some(percent) if percent < LEAST_DIFFERENCE => format!("{percent:.0e}"),
        Some(percent) => significant(percent, 2),
    })
}

/// One digit, rounded away from zero: a bound may not promise more than it holds.
fn up(value: f64) -> String {
    let text = format!("{value:.0e}");
    let Some((digit, exponent)) = text.split_once('e') else { return text };
    let (Ok(digit), Ok(exponent)) = (digit.parse::<u8>(), exponent.parse::<i32>()) else { return text };
    match digit {
        0 => "0".into(),
        _ if text.parse().is_ok_and(|rounded: f64| rounded >= value) => text,
        9 => format!("1e{}", exponent + 1),
        _ => format!("{}e{exponent}", digit + 1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(frequency: f64, lower: f64, upper: f64) -> String {
        Bounded { frequency, lower, upper }.words()
    }

    #[test]
    fn half_widths_are_rounded_up() {
        for (value, text) in [(0.0, "0"), (2e-9, "2e-9"), (2.1e-9, "3e-9"), (9.2e-9, "1e-8"), (9.7e-9, "1e-8")] {
            assert_eq!(up(value), text, "{value}");
        }
    }

    #[test]
    fn bounds_far_apart_are_both_shown() {
        assert_eq!(words(72.3, 72.3 - 0.95e-3, 72.3 + 1e-4), "±1e-3");
        assert_eq!(words(120.0, 111.371, 129.084), "111.37 … 129.08, not converged");
        assert_eq!(words(0.0, 0.0, 0.0), "exact");
        assert!(words(1.0, f64::NAN, 1.0).contains("not converged"), "no number is no bound");
    }

    #[test]
    fn differences_are_in_percent() {
        assert_eq!(percent(Some(1.01), Some(1.0)).map(|value| (value * 1e6).round()), Some(1e6));
        assert_eq!(percent(Some(0.0), Some(0.0)), Some(0.0));
        assert_eq!(percent(Some(1.0), Some(0.0)), None);
        assert_eq!(percent(None, Some(1.0)), None);
    }
}
