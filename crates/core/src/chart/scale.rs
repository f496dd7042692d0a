//! Axes: value to pixel, and ticks as exact decimals.

use super::Axis;
use super::text::scientific;
use crate::numerics::scalar::{ceil, floor, log10};
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// An axis laid out on the drawing.
#[derive(Clone, Debug)]
pub(super) struct Scale {
    pub axis: Axis,
    /// Pixel of `axis.from` and `axis.to`.
    pub from_px: f64,
    pub to_px: f64,
}

/// A tick. Its text may end in a raised exponent, which is a text of its own: not every font has
/// raised digits.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tick {
    pub value: f64,
    pub text: String,
    pub exponent: Option<String>,
}

impl Scale {
    /// A scale without pixels yet. Ends that are equal or not finite are set apart.
    pub(super) fn linear(from: f64, to: f64, unit: &'static str) -> Self {
        let from = if from.is_finite() { from } else { 0.0 };
        let least = (from.abs() * 1e-9).max(f64::MIN_POSITIVE);
        let to = if to.is_finite() && to - from > least { to } else { from + from.abs().max(1.0) };
        Self { axis: Axis { from, to, unit, log: false }, from_px: 0.0, to_px: 1.0 }
    }

    /// A logarithmic scale; both ends must be positive, else it is 1 to 10.
    pub(super) fn log(from: f64, to: f64, unit: &'static str) -> Self {
        let legal = from > 0.0 && to.is_finite() && to / from > 1.000_001;
        let (from, to) = if legal { (from, to) } else { (1.0, 10.0) };
        Self { axis: Axis { from, to, unit, log: true }, from_px: 0.0, to_px: 1.0 }
    }

    /// The same on these pixels.
    pub(super) fn on(mut self, from_px: f64, to_px: f64) -> Self {
        self.from_px = from_px;
        self.to_px = to_px;
        self
    }

    /// Pixel of `value`; none where it has none.
    pub(super) fn at(&self, value: f64) -> Option<f64> {
        let axis = &self.axis;
        let share = if axis.log {
            if value <= 0.0 {
                return None;
            }
            log10(value / axis.from) / log10(axis.to / axis.from)
        } else {
            (value - axis.from) / (axis.to - axis.from)
        };
        // Far outside is as good as just outside, and stays within whole-number pixels.
        share.is_finite().then(|| self.from_px + (self.to_px - self.from_px) * share.clamp(-1e5, 1e5))
    }

    /// At most about `count` ticks.
    pub(super) fn ticks(&self, count: f64) -> Vec<Tick> {
        let axis = &self.axis;
        if axis.log { decade_ticks(axis.from, axis.to, count) } else { linear_ticks(axis.from, axis.to, count) }
    }
}

/// A power or multiple of ten as text: the same bits on every target, and correctly rounded.
fn decimal(mantissa: i64, exponent: i32) -> f64 {
    format!("{mantissa}e{exponent}").parse().unwrap_or(0.0)
}

fn linear_ticks(from: f64, to: f64, count: f64) -> Vec<Tick> {
    let coarse = (to - from) / count.max(1.0);
    let Some((_, exponent)) = scientific(coarse) else { return Vec::new() };
    let steps = [(1, exponent), (2, exponent), (25, exponent - 1), (5, exponent), (1, exponent + 1)];
    let enough = |step: &&(i64, i32)| decimal(step.0, step.1) >= coarse;
    let &(mantissa, exponent) = steps.iter().find(enough).unwrap_or(&(1, exponent + 1));
    let step = decimal(mantissa, exponent);
    // A hair of slack, so that an end that is a tick but for rounding is one.
    let (first, last) = (ceil(from / step - 1e-6), floor(to / step + 1e-6));
    if !(first.abs() < 1e15 && last.abs() < 1e15 && last - first < 1e4) {
        return Vec::new();
    }
    let largest = from.abs().max(to.abs());
    (first as i64..=last as i64)
        .map(|index| {
            let value = decimal(index * mantissa, exponent);
            let (text, raised) = tick_text(index * mantissa, exponent, largest);
            Tick { value, text, exponent: raised }
        })
        .collect()
}

/// `digits × 10^exponent` on an axis that reaches `largest`.
fn tick_text(digits: i64, exponent: i32, largest: f64) -> (String, Option<String>) {
    if digits == 0 {
        return ("0".to_string(), None);
    }
    let top = scientific(largest).map_or(0, |(_, top)| top);
    if (-3..6).contains(&top) || (exponent >= -4 && top < 6) {
        let decimals = usize::try_from(-exponent).unwrap_or(0);
        return (minus(&format!("{:.decimals$}", decimal(digits, exponent))), None);
    }
    let decimals = usize::try_from(top - exponent).unwrap_or(0);
    let mantissa = format!("{:.decimals$}", decimal(digits, exponent - top));
    (format!("{}×10", minus(&mantissa)), Some(minus(&top.to_string())))
}

fn minus(text: &str) -> String {
    text.replace('-', "−")
}

fn decade_ticks(from: f64, to: f64, count: f64) -> Vec<Tick> {
    let (low, high) = (floor(log10(from) + 1e-9) as i32, ceil(log10(to) - 1e-9) as i32);
    let decades = f64::from(high - low).max(1.0);
    let within = |value: f64| value >= from * (1.0 - 1e-9) && value <= to * (1.0 + 1e-9);
    let mantissas: &[i64] = if decades * 3.0 <= count { &[1, 2, 5] } else { &[1] };
    let every = (ceil(decades / count.max(1.0)) as i32).max(1);
    let plain = low >= -3 && high <= 5;
    (low..=high)
        // Counted from 10^0, so that ticks stand on multiples.
        .filter(|exponent| exponent.rem_euclid(every) == 0)
        .flat_map(|exponent| mantissas.iter().map(move |&mantissa| (mantissa, exponent)))
        .filter(|&(mantissa, exponent)| within(decimal(mantissa, exponent)))
        .map(|(mantissa, exponent)| {
            let value = decimal(mantissa, exponent);
            let (text, raised) = match (plain, mantissa) {
                (true, _) => (format!("{:.*}", usize::try_from(-exponent).unwrap_or(0), value), None),
                (false, 1) => ("10".to_string(), Some(minus(&exponent.to_string()))),
                (false, _) => (format!("{mantissa}×10"), Some(minus(&exponent.to_string()))),
            };
            Tick { value, text, exponent: raised }
        })
        .collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says what it expects")]
mod tests {
    use super::*;

    fn texts(scale: &Scale, count: f64) -> Vec<String> {
        let full = |tick: Tick| tick.exponent.map_or(tick.text.clone(), |e| format!("{}^{e}", tick.text));
        scale.ticks(count).into_iter().map(full).collect()
    }

    #[test]
    fn linear_ticks_are_round_and_inside() {
        assert_eq!(
            texts(&Scale::linear(0.0, 792.0, "rpm"), 8.0),
            ["0", "100", "200", "300", "400", "500", "600", "700"]
        );
        assert_eq!(texts(&Scale::linear(0.0, 1.0, ""), 4.0), ["0", "0.25", "0.50", "0.75", "1.00"]);
        assert_eq!(texts(&Scale::linear(-1.0, 1.0, ""), 4.0), ["−1.0", "−0.5", "0", "0.5", "1.0"]);
        assert_eq!(texts(&Scale::linear(0.0, 4e7, ""), 4.0), ["0", "1×10^7", "2×10^7", "3×10^7", "4×10^7"]);
        assert_eq!(texts(&Scale::linear(0.0, 3e-7, ""), 3.0), ["0", "1×10^−7", "2×10^−7", "3×10^−7"]);
        let values: Vec<f64> = Scale::linear(0.0, 0.3, "").ticks(3.0).iter().map(|tick| tick.value).collect();
        assert_eq!(values, [0.0, 0.1, 0.2, 0.3]);
    }

    #[test]
    fn log_ticks_stand_on_decades() {
        assert_eq!(
            texts(&Scale::log(1e-12, 1.0, ""), 7.0),
            ["10^−12", "10^−10", "10^−8", "10^−6", "10^−4", "10^−2", "10^0"]
        );
        assert_eq!(texts(&Scale::log(10.0, 1000.0, ""), 8.0), ["10", "20", "50", "100", "200", "500", "1000"]);
    }

    #[test]
    fn strange_ranges_still_give_an_axis() {
        for (from, to) in [(0.0, 0.0), (f64::NAN, f64::INFINITY), (5.0, 5.0), (1e300, 1e300), (3.0, 2.0), (0.0, 5e-324)]
        {
            let scale = Scale::linear(from, to, "").on(0.0, 100.0);
            assert!(scale.axis.from < scale.axis.to, "{from} {to}");
            assert!(scale.at(scale.axis.to).unwrap() > 99.0, "{from} {to}");
            assert!(scale.ticks(5.0).len() < 20, "{from} {to}");
        }
        assert_eq!(Scale::log(0.0, f64::NAN, "").at(0.0), None);
    }
}
