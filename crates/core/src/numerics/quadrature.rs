//! Gauss–Legendre rules, as many points as an oscillating integrand needs.

mod table;

use crate::numerics::scalar::cos;
use alloc::vec::Vec;
use core::f64::consts::PI;
use table::RULES;

/// Fewest points of a rule for waves; exact for polynomials of degree 5.
const FEWEST_POINTS: usize = 3;
/// Most points of a rule for waves; enough for a phase of π.
const MOST_POINTS: usize = 16;
/// Most points of any rule; polynomials have no other limit.
const LARGEST_RULE: usize = RULES.len();
/// Error of a rule relative to the integrand's size; far below the rounding of the sum.
const TOLERANCE: f64 = 1e-18;

/// Rules with 1 to 26 points, and which of them an integrand needs.
#[derive(Clone, Debug)]
pub struct GaussRules {
    rules: Vec<Vec<(f64, f64)>>,
    /// The largest phase each rule from [`FEWEST_POINTS`] on is good for, ascending.
    phases: Vec<f64>,
}

impl Default for GaussRules {
    fn default() -> Self {
        Self::new()
    }
}

impl GaussRules {
    /// All rules.
    pub fn new() -> Self {
        Self {
            rules: RULES.iter().enumerate().map(|(index, half)| whole(half, index + 1)).collect(),
            phases: (FEWEST_POINTS..=MOST_POINTS).map(largest_phase).collect(),
        }
    }

    /// Nodes and weights on [−1, 1] that integrate the product of two waves and a cubic over a
    /// panel on which each wave advances by at most `phase` ≤ π [rad], to rounding. "Wave" means
    /// sin, cos or the exponential of that rate.
    pub fn for_phase(&self, phase: f64) -> &[(f64, f64)] {
        let index = self.phases.partition_point(|&limit| limit < phase);
        self.with_points((FEWEST_POINTS + index).min(MOST_POINTS))
    }

    /// Nodes and weights of the rule with `points` points (the nearest number from 1 to 26), which
    /// integrates polynomials up to degree 2 · `points` − 1 exactly.
    pub fn with_points(&self, points: usize) -> &[(f64, f64)] {
        &self.rules[points.clamp(1, LARGEST_RULE) - 1]
    }
}

/// Nodes, ascending, and weights of the rule with `points` points, from those of its upper half.
fn whole(half: &[(f64, f64)], points: usize) -> Vec<(f64, f64)> {
    // The middle of an odd number of nodes stands only once.
    let lower = half.iter().skip(points % 2).rev().map(|&(angle, weight)| (cos(PI - angle), weight));
    lower.chain(half.iter().map(|&(angle, weight)| (cos(angle), weight))).collect()
}

/// The largest phase p for which n points integrate exp(i p t) times a cubic, t in [−1, 1], to
/// [`TOLERANCE`]. The rule's error is 2^(2k+1) (k!)⁴ / ((2k+1) ((2k)!)³) times the 2k-th
/// derivative (Abramowitz & Stegun 25.4.30), here p^(2k); two points are kept for the cubic.
fn largest_phase(n: usize) -> f64 {
    let k = n - 2;
    // p = (TOLERANCE / c)^(1/2k), the product gathered factor by factor so that nothing overflows.
    let mut log = crate::numerics::scalar::log10(TOLERANCE * (2 * k + 1) as f64 / 2.0);
    for j in 1..=k {
        let (a, b, c) = (j as f64, (2 * j - 1) as f64, (2 * j) as f64);
        log += crate::numerics::scalar::log10(b * c * (b * c) * (b * c) / (4.0 * a * a * a * a));
    }
    crate::numerics::scalar::pow(10.0, log / (2 * k) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_up_to_degree_2n_minus_1_are_exact() {
        let rules = GaussRules::new();
        for (rule, end) in rules.rules.iter().zip((2..).step_by(2)) {
            for degree in 0..end {
                let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(degree)).sum();
                let exact = if degree % 2 == 0 { 2.0 / f64::from(degree + 1) } else { 0.0 };
                assert!((sum - exact).abs() < 2e-15, "{} points, degree {degree}: {sum}", rule.len());
            }
        }
    }

    #[test]
    fn waves_and_exponentials_of_the_phase_are_exact_to_rounding() {
        let rules = GaussRules::new();
        for step in 1..=100 {
            let phase = PI * f64::from(step) / 100.0;
            let rule = rules.for_phase(phase);
            // cos(p(t+1)/2)² t³ and its like: against the same rule with every panel halved twice.
            let f = |t: f64| (phase * (t + 1.0) / 2.0).cos().powi(2) * (1.0 + t + t * t * t);
            let g = |t: f64| (phase * (t - 1.0)).exp() * (1.0 + t + t * t * t);
            for h in [&f as &dyn Fn(f64) -> f64, &g] {
                let coarse: f64 = rule.iter().map(|(x, w)| w * h(*x)).sum();
                let fine: f64 = (0..4)
                    .map(|panel| {
                        let middle = -0.75 + 0.5 * f64::from(panel);
                        rule.iter().map(|(x, w)| 0.25 * w * h(middle + 0.25 * x)).sum::<f64>()
                    })
                    .sum();
                assert!((coarse - fine).abs() < 2e-15, "phase {phase}: {coarse} {fine}");
            }
        }
    }
}
