//! Legendre polynomials with their integrals, as tables at Gauss points and at single points.

use alloc::vec;
use alloc::vec::Vec;

/// P_j, its integral from −1, and that one's integral, at one point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Legendre {
    /// P_j(ξ).
    pub value: f64,
    /// I_j(ξ) = ∫ P_j from −1 to ξ; at ξ = 1 it is 2 for j = 0, else 0.
    pub first: f64,
    /// J_j(ξ) = ∫ I_j from −1 to ξ; at ξ = 1 it is 2 for j = 0, −2/3 for j = 1, else 0.
    pub second: f64,
}

/// P_0 … with integrals at `x` in [−1, 1]; as many as `out` holds.
pub fn evaluate(x: f64, out: &mut [Legendre]) {
    let count = out.len();
    // Two more values than asked for: each integral is a difference of neighbours.
    let (mut before, mut here, mut next) = (0.0, 1.0, x);
    let mut firsts = (0.0, 0.0); // I_{j−2} and I_{j−1}
    for j in 0..=count {
        let n = 2.0 * j as f64 + 1.0;
        let first = if j == 0 { x + 1.0 } else { (next - before) / n };
        if let Some(entry) = out.get_mut(j) {
            entry.value = here;
            entry.first = first;
        }
        // J_{j−1} = (I_j − I_{j−2}) / (2j − 1); J_0 = (x + 1)²/2.
        if let Some(entry) = j.checked_sub(1).and_then(|i| out.get_mut(i)) {
            entry.second = if j == 1 { 0.5 * (x + 1.0) * (x + 1.0) } else { (first - firsts.0) / (n - 2.0) };
        }
        firsts = (firsts.1, first);
        let k = j as f64 + 1.0;
        (before, here, next) = (here, next, ((2.0 * k + 1.0) * x * next - k * here) / (k + 1.0));
    }
}

/// Tables of the first `order` polynomials at the points of a Gauss rule.
#[derive(Clone, Debug)]
pub struct Tables {
    points: usize,
    /// Polynomial by polynomial, each at all points.
    value: Vec<f64>,
    first: Vec<f64>,
    second: Vec<f64>,
}

impl Tables {
    /// At the points of a rule (node, weight).
    pub fn new(order: usize, rule: &[(f64, f64)]) -> Self {
        let points = rule.len();
        let mut tables = Self {
            points,
            value: vec![0.0; order * points],
            first: vec![0.0; order * points],
            second: vec![0.0; order * points],
        };
        let mut row = vec![Legendre::default(); order];
        for (k, &(node, _)) in rule.iter().enumerate() {
            evaluate(node, &mut row);
            for (j, entry) in row.iter().enumerate() {
                let at = j * points + k;
                (tables.value[at], tables.first[at], tables.second[at]) = (entry.value, entry.first, entry.second);
            }
        }
        tables
    }

    /// P_j at all points.
    pub fn value(&self, j: usize) -> &[f64] {
        &self.value[j * self.points..(j + 1) * self.points]
    }

    /// I_j at all points.
    pub fn first(&self, j: usize) -> &[f64] {
        &self.first[j * self.points..(j + 1) * self.points]
    }

    /// J_j at all points.
    pub fn second(&self, j: usize) -> &[f64] {
        &self.second[j * self.points..(j + 1) * self.points]
    }
}

/// Integrals from each point of a Gauss rule to the right end of its interval, exact for
/// polynomials of a degree below the number of points.
#[derive(Clone, Debug)]
pub struct Outboard {
    points: usize,
    /// Column by column: the weights of one value in the integrals from every point to 1.
    matrix: Vec<f64>,
}

impl Outboard {
    /// For a rule (node, weight) on [−1, 1].
    pub fn new(rule: &[(f64, f64)]) -> Self {
        let points = rule.len();
        let tables = Tables::new(points, rule);
        let mut matrix = vec![0.0; points * points];
        for k in 0..points {
            for j in 0..points {
                // The coefficient of P_j is (2j + 1)/2 Σ w P_j f, its integral from ξ to 1 is I_j(1) − I_j(ξ).
                let tail = if j == 0 { 2.0 } else { 0.0 } - tables.first(j)[k];
                let factor = 0.5 * (2.0 * j as f64 + 1.0) * tail;
                for (column, ((_, weight), value)) in rule.iter().zip(tables.value(j)).enumerate() {
                    matrix[column * points + k] += factor * weight * value;
                }
            }
        }
        Self { points, matrix }
    }

    /// Replaces each value of `out` by `at_end` + `scale` × the integral of `values` from there to 1.
    pub fn integrate(&self, values: &[f64], at_end: f64, scale: f64, out: &mut [f64]) {
        // Each sum in the order of the values; column by column they go side by side.
        out.fill(-0.0);
        for (column, value) in self.matrix.chunks_exact(self.points).zip(values) {
            out.iter_mut().zip(column).for_each(|(sum, weight)| *sum += weight * value);
        }
        for sum in out.iter_mut() {
            *sum = at_end + scale * *sum;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::quadrature::GaussRules;

    #[test]
    fn polynomials_and_integrals_are_those_of_the_textbook() {
        let mut out = [Legendre::default(); 5];
        for i in 0..=40 {
            let x = f64::from(i) / 20.0 - 1.0;
            evaluate(x, &mut out);
            // ∫ P_2 = (x³ − x)/2, ∫∫ P_2 = (x⁴ − 2x² + 1)/8; ∫ P_1 = (x² − 1)/2, ∫∫ P_1 = (x³ − 3x − 2)/6.
            let expected = [
                (1.0, x + 1.0, (x + 1.0) * (x + 1.0) / 2.0),
                (x, (x * x - 1.0) / 2.0, (x * x * x - 3.0 * x - 2.0) / 6.0),
                ((3.0 * x * x - 1.0) / 2.0, (x * x * x - x) / 2.0, (x * x - 1.0) * (x * x - 1.0) / 8.0),
            ];
            for (entry, (value, first, second)) in out.iter().zip(expected) {
                assert!((entry.value - value).abs() < 2e-16, "{x}");
                assert!((entry.first - first).abs() < 3e-16, "{x}");
                assert!((entry.second - second).abs() < 3e-16, "{x}");
            }
            let p4 = (35.0 * x.powi(4) - 30.0 * x * x + 3.0) / 8.0;
            assert!((out[4].value - p4).abs() < 1e-15, "{x}");
        }
    }

    #[test]
    fn integrals_to_the_end_are_exact_for_polynomials() {
        let rules = GaussRules::new();
        for points in [1, 2, 5, 9, 20] {
            let rule = rules.with_points(points);
            let outboard = Outboard::new(rule);
            for degree in 0..points {
                let power = i32::try_from(degree).unwrap();
                let values: Vec<f64> = rule.iter().map(|(x, _)| x.powi(power)).collect();
                let mut integrals = vec![0.0; points];
                outboard.integrate(&values, 3.0, 2.0, &mut integrals);
                for ((x, _), integral) in rule.iter().zip(&integrals) {
                    let exact = 3.0 + 2.0 * (1.0 - x.powi(power + 1)) / f64::from(power + 1);
                    assert!((integral - exact).abs() < 4e-15, "{points} points, degree {degree}: {integral}, {exact}");
                }
            }
        }
    }
}
