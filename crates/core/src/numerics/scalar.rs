//! The one door to the transcendental functions: libm on every target, so that native and WASM
//! results are the same bits.

/// sin x and cos x.
pub fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// cos x.
pub fn cos(x: f64) -> f64 {
    libm::cos(x)
}

/// eˣ.
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// Square root.
pub fn sqrt(x: f64) -> f64 {
    libm::sqrt(x)
}

/// Fourth root of a number not below 0.
pub fn fourth_root(x: f64) -> f64 {
    sqrt(sqrt(x))
}

/// √(x² + y²) without overflow.
pub fn hypot(x: f64, y: f64) -> f64 {
    libm::hypot(x, y)
}

/// The smallest whole number not below `x`.
pub fn ceil(x: f64) -> f64 {
    libm::ceil(x)
}

/// The largest whole number not above `x`.
pub fn floor(x: f64) -> f64 {
    libm::floor(x)
}

/// The nearest whole number, halves away from 0.
pub fn round(x: f64) -> f64 {
    libm::round(x)
}

/// Decimal logarithm.
pub fn log10(x: f64) -> f64 {
    libm::log10(x)
}

/// xʸ.
pub fn pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// Natural logarithm.
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// ln(1 + x).
pub fn ln_1p(x: f64) -> f64 {
    libm::log1p(x)
}

/// eˣ − 1.
pub fn exp_m1(x: f64) -> f64 {
    libm::expm1(x)
}

/// Whether an error is above a limit; one that is not a number is above any.
pub fn is_above(error: f64, limit: f64) -> bool {
    error.is_nan() || error > limit
}

/// The larger of two, not a number where either is not, and 0 rather than −0: `f64::max` drops what
/// is not a number, so that an error estimate looks good, and gives either zero, as the target likes.
#[allow(clippy::float_cmp, reason = "equal numbers may differ in the sign of 0 alone")]
pub fn maximum(a: f64, b: f64) -> f64 {
    if a > b {
        a
    } else if b > a {
        b
    } else if a == b {
        if a.is_sign_positive() { a } else { b }
    } else {
        f64::NAN
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_maximum_keeps_what_is_no_number_and_has_one_zero() {
        assert_eq!(maximum(1.0, 2.0), 2.0);
        assert_eq!(maximum(-1.0, f64::NEG_INFINITY), -1.0);
        for (a, b) in [(f64::NAN, 1.0), (1.0, f64::NAN), (f64::NAN, f64::NAN)] {
            assert!(maximum(a, b).is_nan());
        }
        for (a, b) in [(0.0, -0.0), (-0.0, 0.0), (0.0, 0.0)] {
            assert!(maximum(a, b).is_sign_positive());
        }
        assert!(maximum(-0.0, -0.0).is_sign_negative());
    }
}
