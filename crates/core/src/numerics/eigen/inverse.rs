//! Vectors of eigenvalues that are known already, by inverse iteration.

use super::definite::scaled;
use crate::numerics::scalar::sqrt;
use nalgebra::{DMatrix, DVector};

/// Rounds of inverse iteration. One is enough for an eigenvalue that is good to its last digits, where the
/// start has anything of its vector; the second makes up for a poor start.
const ROUNDS: usize = 2;

/// Vectors of these eigenvalues of G q = λ M q, one column each, qᵀ M q = 1; a small part of what solving for
/// them with their values costs. `None` where G has a zero row, or what comes out is no vector.
pub fn vectors(g: &DMatrix<f64>, m: &DMatrix<f64>, values: &[f64]) -> Option<DMatrix<f64>> {
    let n = g.nrows();
    if g.diagonal().iter().any(|&d| d <= 0.0) {
        return None;
    }
    let scale = g.diagonal().map(|d| 1.0 / sqrt(d));
    let (g, m) = (scaled(g, &scale), scaled(m, &scale));
    let mut found = DMatrix::zeros(n, values.len());
    for (&value, mut column) in values.iter().zip(found.column_iter_mut()) {
        let factor = (&g - &m * value).lu();
        // Of no symmetry that a mode may have, too.
        let mut x = DVector::from_fn(n, |i, _| 1.0 + 0.3 * (i % 3) as f64);
        for _ in 0..ROUNDS {
            x = &m * x;
            if !factor.solve_mut(&mut x) {
                return None;
            }
            let size = x.amax();
            x /= size;
        }
        let norm = sqrt(x.dot(&(&m * &x)));
        column.iter_mut().zip(&x).zip(&scale).for_each(|((out, x), s)| *out = x * s / norm);
    }
    found.iter().all(|v| v.is_finite()).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::eigen::lowest;

    /// Against the vectors found with their values, up to the sign; 1e-9: the rounding of a value by the gap.
    #[test]
    fn vectors_are_those_found_with_their_values() {
        let g = DMatrix::from_fn(6, 6, |i, j| if i == j { 3.0 + i as f64 } else { 0.3 / (1.0 + (i + j) as f64) });
        let m = DMatrix::from_fn(6, 6, |i, j| if i == j { 1.0 } else { 0.05 * (i as f64 - j as f64).abs() });
        let eigen = lowest(&g, &m, 4).unwrap();
        let found = vectors(&g, &m, &eigen.values).unwrap();
        for (a, b) in found.column_iter().zip(eigen.vectors.column_iter()) {
            let sign = a.dot(&(&m * b)).signum();
            assert!((a * sign - b).amax() < 1e-9, "{a} {b}");
        }
        let mut loose = g.clone();
        loose.fill_column(0, 0.0);
        assert!(vectors(&loose, &m, &eigen.values).is_none());
    }
}
