//! Power series about the middle of a panel, in a coordinate t from −1/2 at its outboard end to 1/2
//! at its inboard one.

use core::ops::{Add, Mul, Sub};

/// Terms kept of the properties of a panel.
pub(super) const LENGTH: usize = 24;
/// What the last terms may be of the largest, at the ends of the panel: below all roundings.
const TAIL: f64 = 1e-18;

/// A function on a panel, lowest power first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Series(pub [f64; LENGTH]);

impl Series {
    pub fn constant(value: f64) -> Self {
        let mut out = [0.0; LENGTH];
        out[0] = value;
        Self(out)
    }

    /// Linear between values at the inboard and the outboard end.
    pub fn linear([inner, outer]: [f64; 2]) -> Self {
        let mut out = Self::constant(0.5 * (inner + outer));
        out.0[1] = inner - outer;
        out
    }

    /// Sine and cosine of an angle that is linear on the panel.
    pub fn sin_cos(angle: &Self) -> [Self; 2] {
        let ((sin, cos), rate) = (angle.0[0].sin_cos(), angle.0[1]);
        let mut factor = 1.0;
        let (mut sines, mut cosines) = ([0.0; LENGTH], [0.0; LENGTH]);
        for k in 0..LENGTH {
            (sines[k], cosines[k]) = match k % 4 {
                0 => (factor * sin, factor * cos),
                1 => (factor * cos, -factor * sin),
                2 => (-factor * sin, -factor * cos),
                _ => (-factor * cos, factor * sin),
            };
            factor *= rate / (k + 1) as f64;
        }
        [Self(sines), Self(cosines)]
    }

    pub fn times(self, factor: f64) -> Self {
        Self(self.0.map(|c| factor * c))
    }

    /// The integral from the outboard end.
    pub fn integral(&self) -> Self {
        let mut out = [0.0; LENGTH];
        for (k, c) in self.0[..LENGTH - 1].iter().enumerate() {
            out[k + 1] = c / (k + 1) as f64;
        }
        let at_outer = (1..LENGTH).rev().fold(0.0, |sum, k| -0.5 * (sum + out[k]));
        out[0] = -at_outer;
        Self(out)
    }

    pub fn reciprocal(&self) -> Self {
        let mut out = [0.0; LENGTH];
        out[0] = 1.0 / self.0[0];
        for k in 1..LENGTH {
            out[k] = -(1..=k).map(|j| self.0[j] * out[k - j]).sum::<f64>() / self.0[0];
        }
        Self(out)
    }

    /// Number of terms that matter, or nothing where the last ones do.
    pub fn length(&self) -> Option<usize> {
        let mut size = self.0.map(f64::abs);
        let mut power = 1.0;
        for c in &mut size {
            *c *= power;
            power *= 0.5;
        }
        let limit = TAIL * size.into_iter().fold(0.0, f64::max);
        let length = size.iter().rposition(|&c| c > limit).map_or(0, |last| last + 1);
        // Two terms to spare: an even function has no last odd one.
        (length + 2 <= LENGTH).then_some(length)
    }
}

impl Add for Series {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(core::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl Sub for Series {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(core::array::from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl Mul for Series {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(core::array::from_fn(|k| (0..=k).map(|j| self.0[j] * other.0[k - j]).sum()))
    }
}
