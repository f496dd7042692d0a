//! Numbers as a person reads them: so many significant figures.

/// Decimals that show so many significant figures of `largest`.
pub(crate) fn decimals(largest: f64, figures: usize) -> usize {
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
pub(crate) fn significant(value: f64, figures: usize) -> String {
    match exponent(value, figures) {
        _ if value == 0.0 => "0".into(),
        Some(-4..=6) => format!("{value:.*}", decimals(value, figures)),
        _ => format!("{value:.*e}", figures.saturating_sub(1)),
    }
}

/// `value` to at most so many significant figures, without zeros at the end: for running text.
pub(crate) fn short(value: f64, figures: usize) -> String {
    let text = significant(value, figures);
    let number = text.contains('.') && !text.contains('e');
    if number { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
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
}
