//! The numbers that the equations are integrated in.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// `f64`, or [`Double`] with twice its digits.
pub trait Real:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// This number.
    fn of(value: f64) -> Self;
    /// The nearest f64.
    fn near(self) -> f64;
}

impl Real for f64 {
    fn of(value: f64) -> Self {
        value
    }
    fn near(self) -> f64 {
        self
    }
}

/// A number as the sum of two f64, the second below half a unit in the last place of the first: some
/// 31 digits. The operations are those of Joldes, Muller and Popescu, Tight and rigorous error bounds
/// for basic building blocks of double-word arithmetic, ACM TOMS 44 (2), 2017.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Double {
    high: f64,
    low: f64,
}

/// a + b without an error, where |a| ≥ |b|.
fn fast_sum(a: f64, b: f64) -> Double {
    let high = a + b;
    Double { high, low: b - (high - a) }
}

/// a + b without an error.
fn exact_sum(a: f64, b: f64) -> Double {
    let high = a + b;
    let part = high - b;
    Double { high, low: (a - part) + (b - (high - part)) }
}

/// a b without an error.
fn exact_product(a: f64, b: f64) -> Double {
    let high = a * b;
    Double { high, low: a.mul_add(b, -high) }
}

impl Add for Double {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (exact_sum(self.high, other.high), exact_sum(self.low, other.low));
        let first = fast_sum(high.high, high.low + low.high);
        fast_sum(first.high, low.low + first.low)
    }
}

impl Neg for Double {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let high = exact_product(self.high, other.high);
        let cross = self.high.mul_add(other.low, self.low * other.high);
        fast_sum(high.high, high.low + cross)
    }
}

impl Div for Double {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let high = self.high / other.high;
        let rest = self - other * Self::of(high);
        fast_sum(high, rest.high / other.high)
    }
}

impl Real for Double {
    fn of(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }
    fn near(self) -> f64 {
        self.high
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DIGITS: f64 = 1e-31;

    fn assert_near(a: Double, b: Double) {
        let apart = ((a - b) / b).near();
        assert!(apart.abs() < DIGITS, "{a:?} and {b:?} are {apart:e} apart");
    }

    #[test]
    fn digits_beyond_an_f64_are_kept() {
        let [one, three, tiny] = [1.0, 3.0, 1e-25].map(Double::of);
        assert_eq!((one + tiny) - one, tiny, "a small part stays");
        assert_near(one / three * three, one);
        assert_near((one + tiny) * (one - tiny), one - tiny * tiny);
        // (a + b)(a − b) = a² − b², with numbers that no f64 holds.
        let (a, b) = (one / three + tiny, Double::of(2.0) / Double::of(7.0));
        assert_near((a + b) * (a - b), a * a - b * b);
        assert_near((a / b) * b, a);
    }

    #[test]
    fn a_series_sums_to_known_digits() {
        // e to 34 digits, as two f64.
        let e = Double { high: core::f64::consts::E, low: 1.445_646_891_729_250_2e-16 };
        let mut sum = Double::of(1.0);
        for k in (1..40).rev() {
            sum = Double::of(1.0) + sum / Double::of(f64::from(k));
        }
        assert_near(sum, e);
    }

    #[test]
    fn order_looks_at_both_parts() {
        let one = Double::of(1.0);
        assert!(one < one + Double::of(1e-25), "the second part counts");
        assert!(one - Double::of(1e-25) < one, "below, too");
    }
}
