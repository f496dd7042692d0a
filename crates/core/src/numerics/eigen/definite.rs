//! G positive definite: the problem is solved for 1/λ.

use super::values::eigenvalues;
use super::{Eigen, EigenError, STEPS_PER_EIGENVALUE, ascending, finite};
use crate::numerics::scalar::sqrt;
use alloc::vec::Vec;
use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

/// Above this ratio of λ to the smallest λ the rounding of the eigensolver, which is relative to
/// the largest 1/λ, is taken out by a Rayleigh quotient.
const SPREAD_FOR_QUOTIENT: f64 = 1e3;
/// Up to this ratio of λ to the smallest λ eigenvalues without vectors are good to 1e-11 or so.
const SPREAD_FOR_VALUES: f64 = 5e4;
/// Above this ratio of λ₂ to λ₁ the modes from the second on are solved apart from the first.
const SPREAD_FOR_SHIFT: f64 = 1e5;
/// Share of the largest 1/λ below which an eigenvalue is nothing but rounding.
const NOTHING: f64 = 1e-13;

/// The `count` lowest λ alone, where G is positive definite and their ratios small enough for that
/// to keep nine digits or more; `None` else, and [`lowest`] has the answer.
pub fn lowest_values(g: &DMatrix<f64>, m: &DMatrix<f64>, count: usize) -> Option<Vec<f64>> {
    if g.diagonal().iter().any(|&d| !(d > 0.0 && d.is_finite())) {
        return None;
    }
    let scale = g.diagonal().map(|d| 1.0 / sqrt(d));
    let l = Cholesky::new(scaled(g, &scale))?.unpack();
    let a = sandwich(&l, scaled(m, &scale))?;
    let values = eigenvalues(a)?;
    let inverse: Vec<f64> = descending(&values).into_iter().take(count).map(|i| values[i]).collect();
    let plain = inverse.len() == count && inverse.iter().all(|v| *v * SPREAD_FOR_VALUES > inverse[0]);
    let values: Vec<f64> = inverse.iter().map(|v| 1.0 / v).collect();
    (plain && values.iter().all(|v| v.is_finite())).then_some(values)
}

/// The `count` lowest modes of finite matrices, or as many as there are functions.
pub(super) fn lowest(g: &DMatrix<f64>, m: &DMatrix<f64>, count: usize) -> Result<Eigen, EigenError> {
    let wanted = count.min(g.nrows());
    if wanted == 0 {
        return Ok(Eigen { values: Vec::new(), vectors: DMatrix::zeros(g.nrows(), 0), residuals: Vec::new() });
    }
    if g.diagonal().iter().any(|&d| d <= 0.0) {
        return Err(EigenError::NotPositiveDefinite);
    }
    let scale = g.diagonal().map(|d| 1.0 / sqrt(d));
    let g = scaled(g, &scale);
    let m = scaled(m, &scale);
    let (mut inverse, mut vectors) = largest_inverse(&g, &m, wanted)?;
    if wanted > 1 && inverse[0] > SPREAD_FOR_SHIFT * inverse[1] {
        // The first mode lies far below the rest: with G + σM, σ about λ₂, those have full accuracy.
        // The diagonal's Rayleigh quotients tell the size of λ₂.
        let mut quotients: Vec<f64> = m.diagonal().iter().filter(|&&d| d > 0.0).map(|d| 1.0 / d).collect();
        quotients.sort_by(f64::total_cmp);
        if let Some(&sigma) = quotients.get(1) {
            let (shifted, apart) = largest_inverse(&(&g + &m * sigma), &m, wanted)?;
            for mode in 1..wanted {
                inverse[mode] = 1.0 / (1.0 / shifted[mode] - sigma);
                vectors.set_column(mode, &apart.column(mode));
            }
        }
    }
    let determined = inverse.iter().take_while(|&&v| v > 0.0).count();
    if determined < wanted {
        return Err(EigenError::TooFewModes(determined));
    }
    let mut values: Vec<f64> = inverse.iter().map(|v| 1.0 / v).collect();
    let mut residuals = Vec::with_capacity(wanted);
    for (mode, value) in values.iter_mut().enumerate() {
        let mut vector = vectors.column_mut(mode);
        let (stiffness, inertia) = (&g * &vector, &m * &vector);
        let (energy, norm) = (vector.dot(&stiffness), vector.dot(&inertia));
        if *value * inverse[0] > SPREAD_FOR_QUOTIENT {
            *value = energy / norm;
        }
        let residual = (stiffness - &inertia * *value).norm() / (*value * inertia.norm());
        residuals.push(residual);
        let largest = vector.iter().fold(0.0_f64, |best, &v| if v.abs() > best.abs() { v } else { best });
        let factor = if largest < 0.0 { -1.0 } else { 1.0 } / sqrt(norm);
        vector.iter_mut().zip(scale.iter()).for_each(|(v, s)| *v *= factor * s);
    }
    // The quotients may have changed places where modes lie close.
    finite(Eigen { values, vectors, residuals }).map(ascending)
}

/// The `count` largest 1/λ, descending, and their vectors; 1/λ below what rounding leaves is 0.
fn largest_inverse(g: &DMatrix<f64>, m: &DMatrix<f64>, count: usize) -> Result<(Vec<f64>, DMatrix<f64>), EigenError> {
    let n = g.nrows();
    let l = Cholesky::new(g.clone()).ok_or(EigenError::NotPositiveDefinite)?.unpack();
    let a = sandwich(&l, m.clone()).ok_or(EigenError::NotPositiveDefinite)?;
    // The library takes neither infinities nor an empty matrix.
    if a.iter().any(|v| !v.is_finite()) {
        return Err(EigenError::NonFinite);
    }
    let eigen = SymmetricEigen::try_new(a, f64::EPSILON, STEPS_PER_EIGENVALUE * n).ok_or(EigenError::NotConverged)?;
    if eigen.eigenvalues.iter().any(|v| !v.is_finite()) {
        return Err(EigenError::NotConverged);
    }
    let order = descending(eigen.eigenvalues.as_slice());
    let floor = NOTHING * order.first().map_or(0.0, |&i| eigen.eigenvalues[i]);
    let mut values = Vec::with_capacity(count);
    let mut vectors = DMatrix::zeros(n, count);
    for (mode, &index) in order.iter().take(count).enumerate() {
        let value = eigen.eigenvalues[index];
        values.push(if value > floor { value } else { 0.0 });
        vectors.set_column(mode, &eigen.eigenvectors.column(index));
    }
    if !l.tr_solve_lower_triangular_mut(&mut vectors) {
        return Err(EigenError::NotPositiveDefinite);
    }
    Ok((values, vectors))
}

/// L⁻¹ M L⁻ᵀ: two triangular solves, the second on the transpose of the first.
fn sandwich(l: &DMatrix<f64>, m: DMatrix<f64>) -> Option<DMatrix<f64>> {
    let mut a = m;
    let solved = l.solve_lower_triangular_mut(&mut a);
    a.transpose_mut();
    (solved && l.solve_lower_triangular_mut(&mut a)).then_some(a)
}

/// Indices of `values`, the largest first; of equal ones, in their order.
fn descending(values: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&a, &b| values[b].total_cmp(&values[a]));
    order
}

/// S A S with S = diag(scale).
pub(super) fn scaled(a: &DMatrix<f64>, scale: &DVector<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| {
        // The lower triangle serves both halves, so that the result is symmetric to the bit.
        let (i, j) = if i >= j { (i, j) } else { (j, i) };
        a[(i, j)] * (scale[i] * scale[j])
    })
}
