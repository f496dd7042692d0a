//! Numbers as a person reads them: so many significant figures, or as short as they are.

use alloc::format;
use alloc::string::{String, ToString};
use core::fmt;

/// Most digits before the point that stay readable without exponent in a table.
const DIGITS: i32 = 7;
/// The same in a drawing, where there is less room.
const DIGITS_IN_DRAWING: i32 = 6;

/// Decimals that show so many significant figures of `largest`.
pub fn decimals(largest: f64, figures: usize) -> usize {
    let exponent = exponent(largest, figures).unwrap_or(0);
    let decimals = i32::try_from(figures).unwrap_or(0).saturating_sub(1).saturating_sub(exponent);
    usize::try_from(decimals.max(0)).unwrap_or(0)
}

/// Decimal exponent after rounding: 9.9999 to four figures is 10.00.
fn exponent(value: f64, figures: usize) -> Option<i32> {
    let decimals = figures.saturating_sub(1);
    format!("{value:.decimals$e}").split_once('e')?.1.parse().ok()
}

/// `value` to so many significant figures; without exponent where that stays readable.
pub fn significant(value: f64, figures: usize) -> String {
    up_to(DIGITS, value, figures)
}

/// `value` to at most so many significant figures, without zeros at the end: for running text.
pub fn short(value: f64, figures: usize) -> String {
    without_idle_zeros(up_to(DIGITS, value, figures))
}

/// The same for drawings.
pub fn short_in_drawing(value: f64, figures: usize) -> String {
    without_idle_zeros(up_to(DIGITS_IN_DRAWING, value, figures))
}

fn up_to(digits: i32, value: f64, figures: usize) -> String {
    match exponent(value, figures) {
        _ if value == 0.0 => "0".into(),
        Some(exponent) if (-4..digits).contains(&exponent) => format!("{value:.*}", decimals(value, figures)),
        _ => format!("{value:.*e}", figures.saturating_sub(1)),
    }
}

fn without_idle_zeros(text: String) -> String {
    let number = text.contains('.') && !text.contains('e');
    if number { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

/// A number as the shortest text that reads back to it, with an exponent only where it helps.
#[derive(Clone, Copy, Debug)]
pub struct Shortest(pub f64);

impl fmt::Display for Shortest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = *self;
        if value == 0.0 || (1e-4..1e15).contains(&value.abs()) || !value.is_finite() {
            write!(f, "{value}")
        } else {
            write!(f, "{value:e}")
        }
    }
}

/// [`Shortest`] as a string.
pub fn shortest(value: f64) -> String {
    Shortest(value).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn significant_figures_are_counted_after_rounding() {
        let cases = [
            (0.0, "0"),
            (9.99999, "10.000"),
            (72.3, "72.300"),
            (-0.312_345_67, "-0.31235"),
            (0.000_123_456, "0.00012346"),
            (1_234_567.0, "1234567"),
            (12_345_678.0, "1.2346e7"),
            (1.0e-13, "1.0000e-13"),
        ];
        for (value, text) in cases {
            assert_eq!(significant(value, 5), text, "{value}");
        }
        assert_eq!(significant(f64::NAN, 5), "NaN", "a number that is none must stay visible");
    }

    #[test]
    fn running_text_has_no_idle_zeros() {
        for (value, text) in [(660.0, "660"), (0.25, "0.25"), (69.115_038, "69.12"), (1.0e9, "1.000e9"), (0.0, "0")] {
            assert_eq!(short(value, 4), text);
        }
    }

    #[test]
    fn drawings_have_at_most_six_digits_before_the_point() {
        let cases = [
            (660.0, "660"),
            (659.999_999_999, "660"),
            (69.116, "69.12"),
            (0.04, "0.04"),
            (0.0, "0"),
            (123_456.0, "123456"),
            (999_999.9, "1.000e6"),
            (1_234_567.0, "1.235e6"),
            (1.5e9, "1.500e9"),
        ];
        for (value, text) in cases {
            assert_eq!(short_in_drawing(value, 4), text);
        }
    }

    #[test]
    fn numbers_are_shown_shortest() {
        for (value, text) in [
            (-17.0, "-17"),
            (0.3, "0.3"),
            (5e6, "5000000"),
            (1e300, "1e300"),
            (-0.0, "-0"),
            (1.5e-7, "1.5e-7"),
            (f64::INFINITY, "inf"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(shortest(value), text);
        }
    }
}
