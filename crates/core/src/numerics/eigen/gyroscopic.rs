//! The lowest modes of (A + iωG − ω²M) x = 0, A and M positive definite, G antisymmetric: all ω are real.

use super::{EigenError, STEPS_PER_EIGENVALUE, lowest};
use crate::numerics::scalar::sqrt;
use alloc::vec::Vec;
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Modes beyond those asked for, whose pairs are parted with them.
const BEYOND: usize = 2;
/// What is left of a vector beside others, as a share of it, when it is new among vectors at right angles.
const NEW: f64 = 0.5;

/// The lowest modes, ω ascending; x = a + ib with x*Ax + ω²x*Mx = 1, at right angles in that sense.
#[derive(Clone, Debug)]
pub struct Turning {
    /// ω > 0.
    pub values: Vec<f64>,
    /// Two columns per mode, a and b.
    pub vectors: DMatrix<f64>,
}

/// The `count` lowest modes, or as many as there are.
///
/// With Φ, Λ of the problem without G, S = Λ^½ and Γ = ΦᵀGΦ, the state (S y, ẏ) moves by an antisymmetric matrix, and
/// so by its inverse P = [[−S⁻¹ΓS⁻¹, −S⁻¹], [S⁻¹, 0]], whose eigenvalues are ∓i/ω: the largest are the modes sought.
///
/// # Errors
/// [`EigenError`].
pub fn turning(a: &DMatrix<f64>, g: &DMatrix<f64>, m: &DMatrix<f64>, count: usize) -> Result<Turning, EigenError> {
    let plain = lowest(a, m, a.nrows())?;
    let n = plain.values.len();
    if plain.values.iter().any(|value| *value <= 0.0) {
        return Err(EigenError::NotPositiveDefinite);
    }
    let inverse: Vec<f64> = plain.values.iter().map(|value| 1.0 / sqrt(*value)).collect();
    let coupling = plain.vectors.transpose() * g * &plain.vectors;
    let p = DMatrix::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
        (true, true) => -0.5 * inverse[i] * (coupling[(i, j)] - coupling[(j, i)]) * inverse[j],
        (true, false) if i == j - n => -inverse[i],
        (false, true) if i - n == j => inverse[j],
        _ => 0.0,
    });
    // The planes that P turns are those of PᵀP, which are split into modes below.
    let planes = eigen(p.transpose() * &p)?;
    let kept = 2 * (count + BEYOND).min(n);
    let v = planes.eigenvectors.select_columns(&descending(&planes.eigenvalues)[..kept]);
    let b = v.transpose() * &p * &v;
    let hermitian = DMatrix::from_fn(2 * kept, 2 * kept, |i, j| match (i < kept, j < kept) {
        (true, false) => -0.5 * (b[(i, j - kept)] - b[(j - kept, i)]),
        (false, true) => 0.5 * (b[(i - kept, j)] - b[(j, i - kept)]),
        _ => 0.0,
    });
    let split = eigen(hermitian)?;
    let mut modes: Vec<(f64, DVector<f64>, DVector<f64>)> = Vec::new();
    for index in descending(&split.eigenvalues) {
        let value = split.eigenvalues[index];
        if modes.len() == count.min(n) || value <= 0.0 {
            break;
        }
        // Every mode is there twice, turned by a right angle in time.
        let column = split.eigenvectors.column(index);
        let [mut re, mut im] = [column.rows(0, kept).into_owned(), column.rows(kept, kept).into_owned()];
        for (_, a, b) in &modes {
            let (along, across) = (a.dot(&re) + b.dot(&im), a.dot(&im) - b.dot(&re));
            re -= a * along - b * across;
            im -= a * across + b * along;
        }
        let length = sqrt(re.norm_squared() + im.norm_squared());
        if length > NEW {
            modes.push((1.0 / value, re / length, im / length));
        }
    }
    let upper = DMatrix::from_fn(n, kept, |i, j| inverse[i] * v[(i, j)]);
    let columns: Vec<DVector<f64>> =
        modes.iter().flat_map(|(_, re, im)| [&plain.vectors * (&upper * re), &plain.vectors * (&upper * im)]).collect();
    let vectors = if columns.is_empty() { DMatrix::zeros(a.nrows(), 0) } else { DMatrix::from_columns(&columns) };
    Ok(Turning { values: modes.iter().map(|(value, ..)| *value).collect(), vectors })
}

fn eigen(matrix: DMatrix<f64>) -> Result<SymmetricEigen<f64, nalgebra::Dyn>, EigenError> {
    if matrix.iter().any(|entry| !entry.is_finite()) {
        return Err(EigenError::NonFinite);
    }
    let steps = STEPS_PER_EIGENVALUE * matrix.nrows();
    SymmetricEigen::try_new(matrix, f64::EPSILON, steps).ok_or(EigenError::NotConverged)
}

fn descending(values: &DVector<f64>) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two equal oscillators on a turntable: ω = √(k + g²) ± g, g half the coupling.
    #[test]
    fn a_turntable_splits_two_equal_frequencies() {
        let (a, m) = (DMatrix::from_diagonal_element(2, 2, 9.0), DMatrix::identity(2, 2));
        let g = DMatrix::from_row_slice(2, 2, &[0.0, 8.0, -8.0, 0.0]);
        let found = turning(&a, &g, &m, 2).unwrap();
        for (found, known) in found.values.iter().zip([1.0, 9.0]) {
            assert!((found - known).abs() < 1e-14 * known, "{found} {known}");
        }
    }

    /// Double modes stay apart, and every mode satisfies the equation.
    #[test]
    fn modes_satisfy_their_equation() {
        let n = 8;
        let entry = |i: usize, j: usize| ((7 * i + 3 * j) % 11) as f64 / 11.0 - 0.4;
        let any = DMatrix::from_fn(n, n, entry);
        let a = &any * any.transpose() + DMatrix::from_diagonal_element(n, n, 1.0);
        let m = DMatrix::from_fn(n, n, |i, j| if i == j { 1.0 + 0.1 * i as f64 } else { 0.02 });
        let g = &any - any.transpose();
        // The same twice over, uncoupled: every ω is double.
        let twice = |x: &DMatrix<f64>| {
            DMatrix::from_fn(2 * n, 2 * n, |i, j| if (i < n) == (j < n) { x[(i % n, j % n)] } else { 0.0 })
        };
        let (a, g, m) = (twice(&a), twice(&g), twice(&m));
        let found = turning(&a, &g, &m, 6).unwrap();
        assert_eq!(found.values.len(), 6);
        for pair in found.values.chunks(2) {
            assert!((pair[1] / pair[0] - 1.0).abs() < 1e-12, "{:?}", found.values);
        }
        for (i, value) in found.values.iter().enumerate() {
            let (re, im) = (found.vectors.column(2 * i), found.vectors.column(2 * i + 1));
            let left = &a * re - &m * re * (value * value) - &g * im * *value;
            let other = &a * im - &m * im * (value * value) + &g * re * *value;
            assert!(left.norm() + other.norm() < 1e-11, "{value}: {} {}", left.norm(), other.norm());
        }
    }
}
