//! Integrals of the mass along the span: centrifugal tension, mass, static moment, inertia.

use crate::numerics::PiecewiseLinear;
use alloc::vec::Vec;

/// What a stretch adds to the tension per Ω², ∫ m ρ dρ [kg·m], from the mass per length at both ends
/// [kg/m].
pub(super) fn tension_inside(at_from: f64, at_to: f64, from: f64, to: f64) -> f64 {
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

    #[test]
    fn moments_of_a_uniform_bar_about_an_offset_root() {
        let [mass, first, second] = moments(&PiecewiseLinear::uniform(3.0), 0.5, 2.5);
        assert!((mass - 6.0).abs() < 1e-15 && (first - 6.0).abs() < 1e-15 && (second - 8.0).abs() < 1e-14);
    }
}
