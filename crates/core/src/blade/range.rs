//! Which numbers a quantity may be: its sign, and a size whose squares and products stay numbers.

use alloc::borrow::Cow;
use alloc::format;

/// Legal values of a quantity, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Range {
    sign: Sign,
    /// Least and greatest size of what is not 0.
    least: f64,
    most: f64,
    /// SI unit of both.
    unit: &'static str,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sign {
    Positive,
    NotNegative,
    Any,
}

impl Range {
    /// Any number.
    pub(super) const FINITE: Self = Self { sign: Sign::Any, least: 0.0, most: f64::INFINITY, unit: "" };
    /// Any number that is not negative.
    pub(super) const NOT_NEGATIVE: Self = Self { sign: Sign::NotNegative, ..Self::FINITE };

    /// From `least` to `most`, both greater than 0.
    pub(super) const fn positive(least: f64, most: f64, unit: &'static str) -> Self {
        Self { sign: Sign::Positive, least, most, unit }
    }

    /// 0, or from `least` to `most`.
    pub(super) const fn zero_or(least: f64, most: f64, unit: &'static str) -> Self {
        Self { sign: Sign::NotNegative, least, most, unit }
    }

    /// From −`most` to `most`.
    pub(super) const fn up_to(most: f64, unit: &'static str) -> Self {
        Self { sign: Sign::Any, least: 0.0, most, unit }
    }

    /// The rule that a finite value breaks.
    pub(super) fn broken_by(&self, value: f64) -> Option<Cow<'static, str>> {
        match self.sign {
            Sign::Positive if value <= 0.0 => return Some("must be greater than 0".into()),
            Sign::NotNegative if value < 0.0 => return Some("must be at least 0".into()),
            _ => {}
        }
        if value == 0.0 || (self.least..=self.most).contains(&value.abs()) {
            return None;
        }
        let Self { least, most, unit, .. } = self;
        Some(Cow::Owned(match self.sign {
            Sign::Positive => format!("must be from {least:e} to {most:e} {unit}"),
            Sign::NotNegative => format!("must be 0 or from {least:e} to {most:e} {unit}"),
            // An angle is no power of ten.
            Sign::Any if *most < 10.0 => format!("must be from -{most} to {most} {unit}"),
            Sign::Any => format!("must be from -{most:e} to {most:e} {unit}"),
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sign_is_told_before_a_size() {
        let positive = Range::positive(1e-6, 1e6, "m");
        for (value, rule) in [
            (-1e300, Some("must be greater than 0")),
            (-0.0, Some("must be greater than 0")),
            (1e-7, Some("must be from 1e-6 to 1e6 m")),
            (1e-6, None),
            (1e6, None),
            (1.1e6, Some("must be from 1e-6 to 1e6 m")),
        ] {
            assert_eq!(positive.broken_by(value).as_deref(), rule, "{value}");
        }
    }

    #[test]
    fn zero_may_be_legal_where_the_least_size_is_not_zero() {
        let mass = Range::zero_or(1e-30, 1e30, "kg/m");
        assert_eq!(mass.broken_by(0.0), None);
        assert_eq!(mass.broken_by(-1e-300).as_deref(), Some("must be at least 0"));
        assert_eq!(mass.broken_by(1e-300).as_deref(), Some("must be 0 or from 1e-30 to 1e30 kg/m"));
        assert_eq!(Range::up_to(1e6, "m").broken_by(-2e6).as_deref(), Some("must be from -1e6 to 1e6 m"));
        assert_eq!(Range::up_to(1.5, "rad").broken_by(2.0).as_deref(), Some("must be from -1.5 to 1.5 rad"));
        assert_eq!(Range::FINITE.broken_by(-1e308), None);
        assert_eq!(Range::NOT_NEGATIVE.broken_by(1e308), None);
    }
}
