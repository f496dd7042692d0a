//! The lowest eigenvalues of G q = λ M q, G and M symmetric, with full relative accuracy.
//!
//! The problem is solved for 1/λ: with the basis scaled to a unit diagonal of G and G = L Lᵀ, the
//! largest eigenvalues of L⁻¹ M L⁻ᵀ are the smallest λ. Solving for λ itself with the factor of M
//! loses the low modes in the rounding of the high ones (docs/THEORY.md). Functions without any
//! potential energy are modes with λ = 0 and are taken out first; where G may be indefinite, so
//! that λ < 0 (divergence), G + σM takes its place.

mod definite;
mod few;
mod gyroscopic;
mod indefinite;
mod inverse;
mod rigid;
mod values;

pub use definite::lowest_values;
pub use few::{ascending_values, lowest_of_plain};
pub use gyroscopic::{Turning, turning};
pub use inverse::vectors;

use alloc::vec::Vec;
use nalgebra::DMatrix;

/// What stands in the way of a solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EigenError {
    /// An entry of a matrix is infinite or not a number, or a result is beyond f64.
    NonFinite,
    /// G is not positive definite beside its rigid motions; of [`lowest_of_any_sign`]: G + σM is not
    /// for any σ.
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
    /// One column per mode, Φᵀ M Φ = I; the largest component of each in the basis scaled to a unit
    /// diagonal of G is positive, of a rigid mode that of its own function.
    pub vectors: DMatrix<f64>,
    /// ‖G q − λ M q‖ / ‖λ M q‖ of each mode, in the basis scaled to a unit diagonal of G; 0 for a
    /// rigid mode. Where G is indefinite it is that of G + σM and λ + σ.
    pub residuals: Vec<f64>,
}

/// Steps of the QR iteration; about two per eigenvalue is usual.
const STEPS_PER_EIGENVALUE: usize = 60;

/// The `count` lowest modes of G q = λ M q, or as many as there are functions. G is positive definite
/// but for functions whose rows are exactly zero (rigid motions), M positive semidefinite; only what
/// the lower triangles hold is used.
///
/// # Errors
/// [`EigenError`].
pub fn lowest(g: &DMatrix<f64>, m: &DMatrix<f64>, count: usize) -> Result<Eigen, EigenError> {
    check(g, m, count)?;
    rigid::beside(g, m, count, |g, m, rigid| definite::lowest(g, m, count.saturating_sub(rigid)))
}

/// The same where G may be indefinite: some λ may be negative, and come first. Costs the same where
/// none is.
///
/// # Errors
/// [`EigenError`].
pub fn lowest_of_any_sign(g: &DMatrix<f64>, m: &DMatrix<f64>, count: usize) -> Result<Eigen, EigenError> {
    check(g, m, count)?;
    rigid::beside(g, m, count, |g, m, rigid| {
        // One at least, to see whether it is negative and comes before the rigid ones.
        match enough(count, rigid, count.saturating_sub(rigid).max(1), |count| definite::lowest(g, m, count)) {
            Err(EigenError::NotPositiveDefinite) => {
                enough(count, rigid, count, |count| indefinite::lowest(g, m, count))
            }
            other => other,
        }
    })
}

/// What `solve` finds of `wanted` modes, fewer where those are enough beside the rigid ones.
fn enough(
    count: usize,
    rigid: usize,
    wanted: usize,
    solve: impl Fn(usize) -> Result<Eigen, EigenError>,
) -> Result<Eigen, EigenError> {
    match solve(wanted) {
        Err(EigenError::TooFewModes(left)) if left + rigid >= count => solve(left),
        other => other,
    }
}

fn check(g: &DMatrix<f64>, m: &DMatrix<f64>, count: usize) -> Result<(), EigenError> {
    if g.iter().chain(m.iter()).any(|v| !v.is_finite()) {
        return Err(EigenError::NonFinite);
    }
    if g.is_empty() && count > 0 { Err(EigenError::TooFewModes(0)) } else { Ok(()) }
}

/// The same modes by ascending λ.
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

/// Nothing that is infinite or not a number is a result.
fn finite(modes: Eigen) -> Result<Eigen, EigenError> {
    let mut all = modes.values.iter().chain(&modes.residuals).chain(&modes.vectors);
    if all.any(|v| !v.is_finite()) { Err(EigenError::NonFinite) } else { Ok(modes) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;
    use nalgebra::DVector;

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

    /// L⁻¹ M L⁻ᵀ overflows, though neither matrix does.
    #[test]
    fn what_overflows_on_the_way_is_no_answer() {
        let g = DMatrix::identity(3, 3) * 1e-200;
        let m = DMatrix::from_fn(3, 3, |i, j| if i == j { 1e200 } else { 1e180 });
        assert_eq!(lowest(&g, &m, 2).unwrap_err(), EigenError::NonFinite);
        assert_eq!(lowest_values(&g, &m, 2), None);
        assert_eq!(lowest_values(&m, &g, 2), None);
        assert_eq!(lowest(&g, &(m * f64::NAN), 2).unwrap_err(), EigenError::NonFinite);
    }

    #[test]
    fn without_functions_there_are_no_modes() {
        let none = DMatrix::zeros(0, 0);
        assert_eq!(lowest(&none, &none, 1).unwrap_err(), EigenError::TooFewModes(0));
        assert_eq!(lowest_of_any_sign(&none, &none, 1).unwrap_err(), EigenError::TooFewModes(0));
        assert_eq!(lowest_values(&none, &none, 1), None);
    }

    #[test]
    fn a_mode_that_counts_twice_is_found_twice() {
        // A reflection of diag(2, 5, 2, 5).
        let v = DVector::from_vec(vec![0.5, -0.1, 0.3, 0.7]).normalize();
        let mirror = DMatrix::identity(4, 4) - &v * v.transpose() * 2.0;
        let g = &mirror * DMatrix::from_diagonal(&DVector::from_vec(vec![2.0, 5.0, 2.0, 5.0])) * &mirror;
        let one = DMatrix::identity(4, 4);
        let eigen = lowest(&g, &one, 4).unwrap();
        for (value, exact) in eigen.values.iter().zip([2.0, 2.0, 5.0, 5.0]) {
            assert!((value / exact - 1.0).abs() < 3e-15, "{value}");
        }
        assert!((eigen.vectors.tr_mul(&eigen.vectors) - one).amax() < 1e-14, "orthonormal");
    }

    #[test]
    fn values_alone_are_those_of_the_modes() {
        let g = DMatrix::from_fn(9, 9, |i, j| if i == j { 2.5 + i as f64 } else { 1.0 / (1.0 + i.abs_diff(j) as f64) });
        let m = DMatrix::from_fn(9, 9, |i, j| if i == j { 3.0 } else { 0.1 });
        let (values, modes) = (lowest_values(&g, &m, 4).unwrap(), lowest(&g, &m, 4).unwrap());
        for (value, other) in values.iter().zip(&modes.values) {
            assert!((value / other - 1.0).abs() < 1e-14, "{value} {other}");
        }
    }
}
