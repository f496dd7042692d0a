//! Functions of the radius that are linear between stations and may step at them.

use alloc::vec;
use alloc::vec::Vec;

/// A function given by values at ascending radii, linear between them. A radius that stands twice
/// is a step: the first value is the limit from inboard, the second the one from outboard.
/// Beyond its ends the function keeps its end values.
#[derive(Clone, Debug, PartialEq)]
pub struct PiecewiseLinear {
    x: Vec<f64>,
    y: Vec<f64>,
}

impl PiecewiseLinear {
    /// The function through (x\[i\], y\[i\]). `None` unless both lists have the same length of at
    /// least one, everything is finite, x ascends, and no x stands more than twice.
    pub fn new(x: Vec<f64>, y: Vec<f64>) -> Option<Self> {
        let sound = !x.is_empty()
            && x.len() == y.len()
            && x.iter().chain(&y).all(|v| v.is_finite())
            && x.windows(2).all(|w| w[0] <= w[1])
            && x.windows(3).all(|w| w[0] < w[2]);
        sound.then_some(Self { x, y })
    }

    /// The same value everywhere. A value that is not finite becomes 0.
    pub fn uniform(value: f64) -> Self {
        let value = if value.is_finite() { value } else { 0.0 };
        Self { x: vec![0.0], y: vec![value] }
    }

    /// Radii of the stations, ascending; a step stands twice.
    pub fn stations(&self) -> &[f64] {
        &self.x
    }

    /// Values at the stations.
    pub fn values(&self) -> &[f64] {
        &self.y
    }

    /// The limits from inboard and from outboard at `x`; equal where there is no step.
    pub fn limits(&self, x: f64) -> (f64, f64) {
        let below = self.x.partition_point(|&s| s < x);
        let upto = self.x.partition_point(|&s| s <= x);
        if below < upto {
            return (self.y[below], self.y[upto - 1]);
        }
        let value = match below {
            0 => self.y[0],
            n if n == self.x.len() => self.y[n - 1],
            n => {
                let ratio = (x - self.x[n - 1]) / (self.x[n] - self.x[n - 1]);
                self.y[n - 1] + (self.y[n] - self.y[n - 1]) * ratio
            }
        };
        (value, value)
    }

    /// The sum of both functions. Its stations are those of either, but for a constant's, which needs
    /// none; a step of either is a step.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let constant = |f: &Self| f.x.len() == 1;
        let mut x: Vec<f64> = match (constant(self), constant(other)) {
            (_, true) => self.x.clone(),
            (true, false) => other.x.clone(),
            (false, false) => self.x.iter().chain(&other.x).copied().collect(),
        };
        x.sort_by(f64::total_cmp);
        x.dedup();
        let steps = |f: &Self, x: f64| {
            let first = f.x.partition_point(|&s| s < x);
            f.x.get(first + 1).is_some_and(|&second| second <= x)
        };
        let mut sum = Self { x: Vec::with_capacity(x.len()), y: Vec::with_capacity(x.len()) };
        for x in x {
            let ((a, b), (c, d)) = (self.limits(x), other.limits(x));
            sum.x.push(x);
            sum.y.push(a + c);
            if steps(self, x) || steps(other, x) {
                sum.x.push(x);
                sum.y.push(b + d);
            }
        }
        sum
    }

    /// The function between two radii with no station between them, from its limits there.
    pub fn between(&self, from: f64, to: f64) -> Linear {
        let (inner, outer) = (self.limits(from).1, self.limits(to).0);
        Linear { from, inner, slope: (outer - inner) / (to - from) }
    }

    /// The value at `x`; the mean of both limits on a step.
    pub fn at(&self, x: f64) -> f64 {
        let (inboard, outboard) = self.limits(x);
        inboard + 0.5 * (outboard - inboard)
    }
}

/// A linear function of the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear {
    from: f64,
    inner: f64,
    slope: f64,
}

impl Linear {
    /// The value at `x`.
    pub fn at(&self, x: f64) -> f64 {
        self.inner + self.slope * (x - self.from)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_have_two_limits_and_a_mean() {
        let f = PiecewiseLinear::new(vec![1.0, 2.0, 2.0, 4.0], vec![0.0, 1.0, 5.0, 7.0]).unwrap();
        assert_eq!(f.limits(2.0), (1.0, 5.0));
        assert_eq!(f.at(2.0), 3.0);
        assert_eq!(f.at(1.5), 0.5);
        assert_eq!(f.at(3.0), 6.0);
        assert_eq!(f.at(0.0), 0.0);
        assert_eq!(f.at(9.0), 7.0);
        assert_eq!(f.limits(1.0), (0.0, 0.0));
        assert_eq!(f.limits(4.0), (7.0, 7.0));
        assert_eq!(PiecewiseLinear::uniform(3.0).at(17.0), 3.0);
    }

    #[test]
    fn a_sum_has_the_stations_and_steps_of_both() {
        let f = PiecewiseLinear::new(vec![1.0, 2.0, 2.0, 4.0], vec![0.0, 1.0, 5.0, 7.0]).unwrap();
        let g = PiecewiseLinear::new(vec![0.0, 2.0, 3.0, 3.0], vec![1.0, 3.0, 1.0, 0.0]).unwrap();
        let sum = f.plus(&g);
        assert_eq!(sum, g.plus(&f));
        assert_eq!(sum.stations(), [0.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0]);
        assert_eq!(sum.values(), [1.0, 2.0, 4.0, 8.0, 7.0, 6.0, 7.0]);
        for x in [-1.0, 0.5, 1.5, 2.5, 3.5, 5.0] {
            assert_eq!(sum.at(x), f.at(x) + g.at(x), "{x}");
        }
        assert!(PiecewiseLinear::new(sum.stations().to_vec(), sum.values().to_vec()).is_some());
        // A constant has no station of its own, and a step whose sides are equal stays one.
        let one = PiecewiseLinear::uniform(1.0);
        assert_eq!(one.plus(&f).stations(), f.stations());
        assert_eq!(one.plus(&one), PiecewiseLinear::uniform(2.0));
        let level = PiecewiseLinear::new(vec![1.0, 1.0, 2.0], vec![3.0, 3.0, 3.0]).unwrap();
        assert_eq!(level.plus(&level).stations(), [1.0, 1.0, 2.0]);
    }

    #[test]
    fn unsound_tables_are_refused() {
        assert!(PiecewiseLinear::new(vec![], vec![]).is_none());
        assert!(PiecewiseLinear::new(vec![1.0, 0.0], vec![1.0, 1.0]).is_none());
        assert!(PiecewiseLinear::new(vec![1.0, 1.0, 1.0], vec![1.0, 1.0, 1.0]).is_none());
        assert!(PiecewiseLinear::new(vec![1.0], vec![f64::NAN]).is_none());
    }
}
