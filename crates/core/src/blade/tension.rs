//! Integrals of the mass along the span: centrifugal tension, mass, static moment, inertia.

use crate::numerics::PiecewiseLinear;
use alloc::vec::Vec;

/// Tension of a rotating blade per Ω², T(r) = ∫ m ρ dρ from r to R [kg·m]: a cubic between the
/// stations of the mass, integrated exactly.
#[derive(Clone, Debug)]
pub struct Tension<'a> {
    mass: &'a PiecewiseLinear,
    /// Ends of the pieces, ascending; the last is R.
    ends: Vec<f64>,
    /// T at these ends.
    at_ends: Vec<f64>,
}

impl<'a> Tension<'a> {
    /// Tension outboard of every radius from `inner` to `radius`.
    pub fn new(mass: &'a PiecewiseLinear, inner: f64, radius: f64) -> Self {
        let mut ends: Vec<f64> =
            mass.stations().iter().copied().filter(|&station| station > inner && station < radius).collect();
        ends.dedup();
        ends.push(radius);
        let mut at_ends = alloc::vec![0.0; ends.len()];
        for i in (1..ends.len()).rev() {
            at_ends[i - 1] = at_ends[i] + pull(mass, ends[i - 1], ends[i]);
        }
        Self { mass, ends, at_ends }
    }

    /// T(r) [kg·m].
    pub fn at(&self, r: f64) -> f64 {
        let piece = self.ends.partition_point(|&end| end < r);
        match (self.ends.get(piece), self.at_ends.get(piece)) {
            (Some(&end), Some(&outboard)) => outboard + pull(self.mass, r, end),
            _ => 0.0,
        }
    }
}

/// ∫ m ρ dρ over a piece within which the mass is linear.
fn pull(mass: &PiecewiseLinear, from: f64, to: f64) -> f64 {
    over_piece(mass, from, to, |r| r)
}

/// The same from the mass per length at both ends [kg/m]: what a stretch adds to the tension [kg·m].
pub fn tension_inside(at_from: f64, at_to: f64, from: f64, to: f64) -> f64 {
    simpson(at_from, at_to, from, to, |r| r)
}

/// ∫ f(r) p(r) dr over [from, to] within which p is linear; exact for p f up to cubic (Simpson).
fn over_piece(property: &PiecewiseLinear, from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    if to <= from {
        return 0.0;
    }
    simpson(property.limits(from).1, property.limits(to).0, from, to, f)
}

fn simpson(first: f64, last: f64, from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let middle = 0.5 * (from + to);
    (to - from) / 6.0 * (first * f(from) + 2.0 * (first + last) * f(middle) + last * f(to))
}

/// ∫ xⁿ p(r) dr from `root` to `radius`, x = r − root, for n = 0, 1 and 2: mass, static moment and
/// inertia of a distributed mass about its root.
pub fn moments(property: &PiecewiseLinear, root: f64, radius: f64) -> [f64; 3] {
    let mut ends: Vec<f64> = core::iter::once(root)
        .chain(property.stations().iter().copied().filter(|&station| station > root && station < radius))
        .chain(core::iter::once(radius))
        .collect();
    ends.dedup();
    let mut sums = [0.0; 3];
    for piece in ends.windows(2) {
        let (from, to) = (piece[0], piece[1]);
        sums[0] += over_piece(property, from, to, |_| 1.0);
        sums[1] += over_piece(property, from, to, |r| r - root);
        sums[2] += over_piece(property, from, to, |r| (r - root) * (r - root));
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    #[test]
    fn tension_of_a_stepped_tapered_mass_is_exact() {
        // m = 2 up to r = 1, then 3 − r up to 2: T(1) = ∫(3r − r²) = 4.5 − 7/3, T(0) = T(1) + 1.
        let mass = PiecewiseLinear::new(vec![0.0, 1.0, 1.0, 2.0], vec![2.0, 2.0, 2.0, 1.0]).unwrap();
        let tension = Tension::new(&mass, 0.0, 2.0);
        let outer = 4.5 - 7.0 / 3.0;
        assert!((tension.at(1.0) - outer).abs() < 1e-15, "{}", tension.at(1.0));
        assert!((tension.at(0.0) - (outer + 1.0)).abs() < 1e-15, "{}", tension.at(0.0));
        let exact = 1.5 * (4.0 - 2.25) - (8.0 - 3.375) / 3.0;
        assert!((tension.at(1.5) - exact).abs() < 1e-15, "{}", tension.at(1.5));
        assert_eq!(tension.at(2.0), 0.0);
    }

    #[test]
    fn moments_of_a_uniform_bar_about_an_offset_root() {
        let [mass, first, second] = moments(&PiecewiseLinear::uniform(3.0), 0.5, 2.5);
        assert!((mass - 6.0).abs() < 1e-15 && (first - 6.0).abs() < 1e-15 && (second - 8.0).abs() < 1e-14);
    }
}
