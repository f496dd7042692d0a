//! The lowest eigenvalues of G q = λ M q, G and M symmetric, with full relative accuracy.
//!
//! The problem is solved for 1/λ: with the basis scaled to a unit diagonal of G and G = L Lᵀ, the
//! largest eigenvalues of L⁻¹ M L⁻ᵀ are the smallest λ. Solving for λ itself with the factor of M
//! loses the low modes in the rounding of the high ones (docs/THEORY.md).

use crate::numerics::scalar::sqrt;
use alloc::vec::Vec;
use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

/// What stands in the way of a solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EigenError {
    /// An entry of a matrix is infinite or not a number.
    NonFinite,
    /// G is not positive definite beside its rigid function.
    NotPositiveDefinite,
    /// The iteration did not end.
    NotConverged,
    /// M leaves fewer modes than asked for; so many remain.
    TooFewModes(usize),
}

/// The lowest modes, λ ascending.
#[derive(Clone, Debug)]
pub struct Eigen {
    /// λ, ascending; exactly 0 for a rigid mode.
    pub values: Vec<f64>,
    /// One column per mode, Φᵀ M Φ = I; the largest component of each is positive.
    pub vectors: DMatrix<f64>,
    /// ‖G q − λ M q‖ / ‖λ M q‖ of each mode, in the basis scaled to a unit diagonal of G; 0 for a
    /// rigid mode.
    pub residuals: Vec<f64>,
}

/// Above this ratio of λ to the smallest λ the rounding of the eigensolver, which is relative to
/// the largest 1/λ, is taken out by a Rayleigh quotient.
const SPREAD_FOR_QUOTIENT: f64 = 1e3;
/// Up to this ratio of λ to the smallest λ eigenvalues without vectors are good to 1e-11 or so.
const SPREAD_FOR_VALUES: f64 = 5e4;
/// Above this ratio of λ₂ to λ₁ the modes from the second on are solved apart from the first.
const SPREAD_FOR_SHIFT: f64 = 1e5;
/// Share of the largest 1/λ below which an eigenvalue is nothing but rounding.
const NOTHING: f64 = 1e-13;
/// Steps of the QR iteration; about two per eigenvalue is usual.
const STEPS_PER_EIGENVALUE: usize = 60;

/// The `count` lowest modes of G q = λ M q, G positive definite but for at most one function with a
/// zero row (a rigid motion), M positive semidefinite; only what the lower triangles hold is used.
///
/// # Errors
/// [`EigenError`].
pub fn lowest(g: &DMatrix<f64>, m: &DMatrix<f64>, count: usize) -> Result<Eigen, EigenError> {
    if g.iter().chain(m.iter()).any(|v| !v.is_finite()) {
        return Err(EigenError::NonFinite);
    }
    match (0..g.nrows()).find(|&i| g[(i, i)] == 0.0) {
        Some(rigid) => with_rigid_mode(g, m, rigid, count),
        None => elastic(g, m, count),
    }
}

/// The `count` lowest λ alone, where G is positive definite and their ratios small enough for that
/// to keep nine digits or more; `None` else, and [`lowest`] has the answer.
pub fn lowest_values(g: &DMatrix<f64>, m: &DMatrix<f64>, count: usize) -> Option<Vec<f64>> {
    if g.diagonal().iter().any(|&d| !(d > 0.0 && d.is_finite())) {
        return None;
    }
    let scale = g.diagonal().map(|d| 1.0 / sqrt(d));
    let l = Cholesky::new(scaled(g, &scale))?.unpack();
    let a = sandwich(&l, scaled(m, &scale))?;
    if a.iter().any(|v| !v.is_finite()) {
        return None;
    }
    let values = a.symmetric_eigenvalues();
    let inverse: Vec<f64> = descending(values.as_slice()).into_iter().take(count).map(|i| values[i]).collect();
    let plain = inverse.len() == count && inverse.iter().all(|v| *v * SPREAD_FOR_VALUES > inverse[0]);
    plain.then(|| inverse.iter().map(|v| 1.0 / v).collect())
}

/// L⁻¹ M L⁻ᵀ: two triangular solves, the second on the transpose of the first.
fn sandwich(l: &DMatrix<f64>, m: DMatrix<f64>) -> Option<DMatrix<f64>> {
    let mut a = m;
    let solved = l.solve_lower_triangular_mut(&mut a);
    a.transpose_mut();
    (solved && l.solve_lower_triangular_mut(&mut a)).then_some(a)
}

/// The rigid function is a mode with λ = 0. The others are orthogonal to it, (M q)_rigid = 0; that
/// gives their rigid component and leaves a problem with M's Schur complement.
fn with_rigid_mode(g: &DMatrix<f64>, m: &DMatrix<f64>, rigid: usize, count: usize) -> Result<Eigen, EigenError> {
    let n = g.nrows();
    let inertia = m[(rigid, rigid)];
    if inertia <= 0.0 {
        return Err(EigenError::TooFewModes(0));
    }
    let row = m.column(rigid).remove_row(rigid) / inertia;
    let mut reduced = m.clone().remove_row(rigid).remove_column(rigid);
    reduced.ger(-inertia, &row, &row, 1.0);
    let others = if count > 1 && n > 1 {
        elastic(&g.clone().remove_row(rigid).remove_column(rigid), &reduced, count - 1).map_err(
            |error| match error {
                EigenError::TooFewModes(left) => EigenError::TooFewModes(left + 1),
                other => other,
            },
        )?
    } else {
        Eigen { values: Vec::new(), vectors: DMatrix::zeros(n - 1, 0), residuals: Vec::new() }
    };
    let modes = others.values.len() + 1;
    let mut vectors = others.vectors.insert_row(rigid, 0.0).insert_column(0, 0.0);
    vectors[(rigid, 0)] = 1.0 / sqrt(inertia);
    for mode in 1..modes {
        let elastic = vectors.column(mode).remove_row(rigid);
        vectors[(rigid, mode)] = -row.dot(&elastic);
    }
    let with_zero = |list: Vec<f64>| core::iter::once(0.0).chain(list).collect();
    Ok(Eigen { values: with_zero(others.values), vectors, residuals: with_zero(others.residuals) })
}

/// The problem without a rigid mode.
fn elastic(g: &DMatrix<f64>, m: &DMatrix<f64>, count: usize) -> Result<Eigen, EigenError> {
    let n = g.nrows();
    if g.diagonal().iter().any(|&d| d <= 0.0) {
        return Err(EigenError::NotPositiveDefinite);
    }
    let scale = g.diagonal().map(|d| 1.0 / sqrt(d));
    let g = scaled(g, &scale);
    let m = scaled(m, &scale);
    let wanted = count.min(n);
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
    if values.iter().chain(&residuals).chain(&vectors).any(|v| !v.is_finite()) {
        return Err(EigenError::NonFinite);
    }
    Ok(ascending(Eigen { values, vectors, residuals }))
}

/// The same modes by ascending λ: the quotients may have changed places where modes lie close.
fn ascending(modes: Eigen) -> Eigen {
    if modes.values.is_sorted() {
        return modes;
    }
    let mut order: Vec<usize> = (0..modes.values.len()).collect();
    order.sort_by(|&a, &b| modes.values[a].total_cmp(&modes.values[b]));
    Eigen {
        values: order.iter().map(|&i| modes.values[i]).collect(),
        vectors: modes.vectors.select_columns(&order),
        residuals: order.iter().map(|&i| modes.residuals[i]).collect(),
    }
}

/// The `count` largest 1/λ, descending, and their vectors; 1/λ below what rounding leaves is 0.
fn largest_inverse(g: &DMatrix<f64>, m: &DMatrix<f64>, count: usize) -> Result<(Vec<f64>, DMatrix<f64>), EigenError> {
    let n = g.nrows();
    let l = Cholesky::new(g.clone()).ok_or(EigenError::NotPositiveDefinite)?.unpack();
    let a = sandwich(&l, m.clone()).ok_or(EigenError::NotPositiveDefinite)?;
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

/// Indices of `values`, the largest first; of equal ones, in their order.
fn descending(values: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&a, &b| values[b].total_cmp(&values[a]));
    order
}

/// S A S with S = diag(scale).
fn scaled(a: &DMatrix<f64>, scale: &DVector<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| {
        // The lower triangle serves both halves, so that the result is symmetric to the bit.
        let (i, j) = if i >= j { (i, j) } else { (j, i) };
        a[(i, j)] * (scale[i] * scale[j])
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    /// A chain of two masses on springs: λ = (3 ± √5)/2.
    #[test]
    fn two_masses_on_springs() {
        let g = DMatrix::from_row_slice(2, 2, &[2.0, -1.0, -1.0, 1.0]);
        let m = DMatrix::identity(2, 2);
        let eigen = lowest(&g, &m, 2).unwrap();
        let root5 = 5.0_f64.sqrt();
        for (value, exact) in eigen.values.iter().zip([(3.0 - root5) / 2.0, (3.0 + root5) / 2.0]) {
            assert!((value - exact).abs() < 1e-15, "{value}");
        }
        let gram = eigen.vectors.transpose() * &m * &eigen.vectors;
        assert!((gram - DMatrix::<f64>::identity(2, 2)).amax() < 1e-15, "orthonormal");
        assert!(eigen.residuals.iter().all(|r| *r < 1e-15), "{:?}", eigen.residuals);
    }

    #[test]
    fn a_zero_row_is_a_rigid_mode_at_exactly_zero() {
        // Free–free chain of two masses in the basis (both together, second alone).
        let g = DMatrix::from_row_slice(2, 2, &[0.0, 0.0, 0.0, 1.0]);
        let m = DMatrix::from_row_slice(2, 2, &[3.0, 2.0, 2.0, 2.0]);
        let eigen = lowest(&g, &m, 2).unwrap();
        assert_eq!(eigen.values[0], 0.0);
        // Masses 1 and 2 on a unit spring: λ = 1/1 + 1/2.
        assert!((eigen.values[1] - 1.5).abs() < 1e-15, "{}", eigen.values[1]);
        let gram = eigen.vectors.transpose() * &m * &eigen.vectors;
        assert!((gram - DMatrix::<f64>::identity(2, 2)).amax() < 1e-15, "orthonormal");
    }

    #[test]
    fn modes_twelve_orders_apart_keep_their_digits() {
        let g = DMatrix::from_row_slice(3, 3, &[1e-12, 1e-13, 0.0, 1e-13, 2.0, -1.0, 0.0, -1.0, 1.0]);
        let eigen = lowest(&g, &DMatrix::identity(3, 3), 3).unwrap();
        let root5 = 5.0_f64.sqrt();
        assert!((eigen.values[0] / 1e-12 - 1.0).abs() < 1e-12, "{}", eigen.values[0]);
        for (value, exact) in eigen.values[1..].iter().zip([(3.0 - root5) / 2.0, (3.0 + root5) / 2.0]) {
            assert!((value / exact - 1.0).abs() < 1e-14, "{value}");
        }
    }

    #[test]
    fn unsolvable_problems_are_errors() {
        let one = DMatrix::<f64>::identity(2, 2);
        assert_eq!(lowest(&(-&one), &one, 1).unwrap_err(), EigenError::NotPositiveDefinite);
        assert_eq!(lowest(&(&one * f64::NAN), &one, 1).unwrap_err(), EigenError::NonFinite);
        // λ itself is beyond f64.
        assert_eq!(lowest(&(&one * 1e160), &(&one * 1e-155), 1).unwrap_err(), EigenError::NonFinite);
        let singular = DMatrix::from_diagonal(&DVector::from_vec(vec![1.0, 0.0]));
        assert_eq!(lowest(&one, &singular, 2).unwrap_err(), EigenError::TooFewModes(1));
    }
}
