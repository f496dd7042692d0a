//! G indefinite: some λ are negative.
//!
//! Where M is positive definite, or G is where M is not, G + σM is positive definite from σ = −λ₁ on;
//! its λ are larger by σ. Twice to four times that, or a little where λ₁ is about 0, keeps the
//! lowest of them well above 0 without pressing the others together.

use super::definite::{self, scaled};
use super::{Eigen, EigenError, ascending, finite};
use crate::numerics::scalar::sqrt;
use nalgebra::{Cholesky, DMatrix};

/// Most trials of a shift in each direction: factors of 16 up and square roots down span f64 well
/// before.
const MOST_TRIALS: usize = 600;
/// The least shift tried, as a share of the smallest Rayleigh quotient of a single function: a smaller
/// one would press all other 1/λ together with the rounding of the largest.
const LEAST_SHARE: f64 = 1e-6;

/// The `count` lowest modes of finite matrices, or as many as there are functions, where
/// [`definite::lowest`] has refused G.
pub(super) fn lowest(g: &DMatrix<f64>, m: &DMatrix<f64>, count: usize) -> Result<Eigen, EigenError> {
    let (mut g, mut m) = (g.clone(), m.clone());
    g.fill_upper_triangle_with_lower_triangle();
    m.fill_upper_triangle_with_lower_triangle();
    let sigma = shift(&g, &m).ok_or(EigenError::NotPositiveDefinite)?;
    let mut modes = definite::lowest(&(&g + &m * sigma), &m, count)?;
    for (value, vector) in modes.values.iter_mut().zip(modes.vectors.column_iter()) {
        // Taking σ off again would leave its rounding; the quotient of G itself does not know it.
        *value = vector.dot(&(&g * vector)) / vector.dot(&(&m * vector));
    }
    finite(modes).map(ascending)
}

/// A σ with which G + σM is positive definite, from twice to four times the least of those tried;
/// `None` where none is found.
fn shift(g: &DMatrix<f64>, m: &DMatrix<f64>) -> Option<f64> {
    let quotients = g.diagonal().zip_map(&m.diagonal(), |g, m| if m > 0.0 { g / m } else { 0.0 });
    let (mut least, mut largest) = (f64::INFINITY, 0.0_f64);
    for size in quotients.iter().map(|v| v.abs()).filter(|v| *v > 0.0 && v.is_finite()) {
        least = least.min(size);
        largest = largest.max(size);
    }
    // Where all diagonals are zero any size may be right.
    if largest == 0.0 {
        (least, largest) = (1.0, 1.0);
    }
    let mut enough = largest;
    let mut trials = 0;
    while !is_definite(g, m, enough) {
        enough *= 16.0;
        trials += 1;
        if trials > MOST_TRIALS || !enough.is_finite() {
            return None;
        }
    }
    // λ₁ is at most each quotient: with less than minus the lowest of them G + σM is not definite.
    let mut short = quotients.iter().fold(least * LEAST_SHARE, |most, quotient| most.max(-quotient));
    for _ in 0..MOST_TRIALS {
        if enough <= 2.0 * short {
            break;
        }
        let between = sqrt(short) * sqrt(enough);
        if is_definite(g, m, between) {
            enough = between;
        } else {
            short = between;
        }
    }
    Some(2.0 * enough)
}

fn is_definite(g: &DMatrix<f64>, m: &DMatrix<f64>, sigma: f64) -> bool {
    let sum = g + m * sigma;
    if sum.diagonal().iter().any(|&d| !(d > 0.0 && d.is_finite())) {
        return false;
    }
    let scale = sum.diagonal().map(|d| 1.0 / sqrt(d));
    Cholesky::new(scaled(&sum, &scale)).is_some()
}

#[cfg(test)]
mod tests {
    use super::super::{Eigen, EigenError, lowest, lowest_of_any_sign};
    use alloc::vec;
    use alloc::vec::Vec;
    use nalgebra::{Cholesky, DMatrix, DVector};
    use proptest::prelude::*;

    /// Φᵀ M Φ = I and Φᵀ G Φ = diag λ.
    fn assert_modes(g: &DMatrix<f64>, m: &DMatrix<f64>, eigen: &Eigen, tolerance: f64) {
        let count = eigen.values.len();
        let gram = eigen.vectors.tr_mul(&(m * &eigen.vectors)) - DMatrix::<f64>::identity(count, count);
        assert!(gram.amax() < tolerance, "orthonormal: {gram}");
        let energy = eigen.vectors.tr_mul(&(g * &eigen.vectors));
        let largest = eigen.values.iter().fold(1.0, |most, value| f64::max(most, value.abs()));
        let energy = energy - DMatrix::from_diagonal(&DVector::from_vec(eigen.values.clone()));
        assert!(energy.amax() < tolerance * largest, "energies: {energy}");
        assert!(eigen.values.is_sorted(), "{:?}", eigen.values);
        assert_eq!(eigen.residuals.len(), count);
        assert!(eigen.residuals.iter().all(|r| *r < tolerance), "{:?}", eigen.residuals);
    }

    #[test]
    fn two_by_two_with_one_of_each_sign() {
        let g = DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 2.0, 1.0]);
        let one = DMatrix::identity(2, 2);
        assert_eq!(lowest(&g, &one, 2).unwrap_err(), EigenError::NotPositiveDefinite);
        let eigen = lowest_of_any_sign(&g, &one, 2).unwrap();
        assert!((eigen.values[0] + 1.0).abs() < 1e-15 && (eigen.values[1] - 3.0).abs() < 1e-14, "{:?}", eigen.values);
        assert_modes(&g, &one, &eigen, 1e-14);
        // A diagonal of zeros.
        let swap = DMatrix::from_row_slice(2, 2, &[0.0, 7.0, 7.0, 0.0]);
        let eigen = lowest_of_any_sign(&swap, &one, 1).unwrap();
        assert!((eigen.values[0] / -7.0 - 1.0).abs() < 1e-15, "{:?}", eigen.values);
    }

    /// Two links on torsion springs k = 1 under a dead load P, masses 2 and 1, lengths 1 (Ziegler's
    /// column with a load that keeps its direction): det(G − λM) = 2λ² − (7 − 4P)λ + (1 − 3P + P²) = 0.
    /// It buckles at P = (3 ∓ √5)/2.
    #[test]
    fn a_column_diverges_beyond_its_buckling_loads() {
        let m = DMatrix::from_row_slice(2, 2, &[3.0, 1.0, 1.0, 1.0]);
        let root5 = 5.0_f64.sqrt();
        for (load, negative) in [(0.2, 0), (0.38, 0), (0.39, 1), (1.0, 1), (2.6, 1), (2.7, 2), (10.0, 2)] {
            let g = DMatrix::from_row_slice(2, 2, &[2.0 - load, -1.0, -1.0, 1.0 - load]);
            let eigen = lowest_of_any_sign(&g, &m, 2).unwrap();
            let half = (7.0 - 4.0 * load) / 4.0;
            let root = (half * half - (1.0 - 3.0 * load + load * load) / 2.0).sqrt();
            for (value, exact) in eigen.values.iter().zip([half - root, half + root]) {
                assert!((value - exact).abs() < 1e-14 * (1.0 + exact.abs()), "{load}: {value} {exact}");
            }
            assert_eq!(eigen.values.iter().filter(|value| **value < 0.0).count(), negative, "{load}");
            assert_modes(&g, &m, &eigen, 1e-13);
        }
        for load in [0.5 * (3.0 - root5), 0.5 * (3.0 + root5)] {
            let g = DMatrix::from_row_slice(2, 2, &[2.0 - load, -1.0, -1.0, 1.0 - load]);
            let eigen = lowest_of_any_sign(&g, &m, 2).unwrap();
            assert!(eigen.values.iter().any(|value| value.abs() < 1e-15), "{load}: {:?}", eigen.values);
        }
    }

    #[test]
    fn a_definite_problem_is_solved_as_ever() {
        let g = DMatrix::from_row_slice(3, 3, &[2.0, -1.0, 0.0, -1.0, 2.0, -1.0, 0.0, -1.0, 1.0]);
        let m = DMatrix::from_diagonal(&DVector::from_vec(vec![1.0, 2.0, 3.0]));
        let (definite, any) = (lowest(&g, &m, 3).unwrap(), lowest_of_any_sign(&g, &m, 3).unwrap());
        assert_eq!((definite.values, definite.vectors), (any.values, any.vectors));
    }

    #[test]
    fn eigenvalues_of_several_are_found_as_often() {
        // A reflection of diag(−3, −3, −3, 2, 2): dense, and as multiple.
        let v = DVector::from_vec(vec![0.5, -0.1, 0.3, 0.7, -0.4]).normalize();
        let mirror = DMatrix::identity(5, 5) - &v * v.transpose() * 2.0;
        let diagonal = DMatrix::from_diagonal(&DVector::from_vec(vec![-3.0, 2.0, -3.0, 2.0, -3.0]));
        let g = &mirror * diagonal * &mirror;
        let one = DMatrix::identity(5, 5);
        let eigen = lowest_of_any_sign(&g, &one, 5).unwrap();
        for (value, exact) in eigen.values.iter().zip([-3.0, -3.0, -3.0, 2.0, 2.0]) {
            assert!((value - exact).abs() < 3e-15, "{value}");
        }
        assert_modes(&g, &one, &eigen, 1e-14);
    }

    /// Two free masses and one on a repelling spring, in mixed coordinates: rigid modes stand between.
    #[test]
    fn rigid_modes_come_after_the_negative() {
        let mut g = DMatrix::zeros(4, 4);
        (g[(1, 1)], g[(3, 3)]) = (-4.0, 9.0);
        let m = DMatrix::from_row_slice(
            4,
            4,
            &[3.0, 0.0, 1.0, 0.0, 0.0, 2.0, 0.0, 0.0, 1.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0, 1.0],
        );
        for count in 1..=4 {
            let eigen = lowest_of_any_sign(&g, &m, count).unwrap();
            let exact = [-2.0, 0.0, 0.0, 9.0];
            assert_eq!(eigen.values.len(), count);
            for (value, exact) in eigen.values.iter().zip(exact) {
                assert!((value - exact).abs() < 1e-14 * (1.0 + exact.abs()), "{count}: {:?}", eigen.values);
            }
            assert!(eigen.values.iter().skip(1).take(2).all(|value| *value == 0.0), "{:?}", eigen.values);
            assert_modes(&g, &m, &eigen, 1e-14);
        }
    }

    #[test]
    fn no_shift_helps_where_neither_matrix_is_definite() {
        let g = DMatrix::from_diagonal(&DVector::from_vec(vec![1.0, -1.0]));
        let m = DMatrix::from_diagonal(&DVector::from_vec(vec![1.0, 0.0]));
        assert_eq!(lowest_of_any_sign(&g, &m, 1).unwrap_err(), EigenError::NotPositiveDefinite);
        let zero = DMatrix::zeros(2, 2);
        assert_eq!(lowest_of_any_sign(&g, &zero, 1).unwrap_err(), EigenError::NotPositiveDefinite);
        assert_eq!(lowest_of_any_sign(&(&g * f64::NAN), &m, 1).unwrap_err(), EigenError::NonFinite);
        // M without inertia where G is positive: one mode, and it diverges.
        let eigen = lowest_of_any_sign(&(-&g), &m, 1).unwrap();
        assert!((eigen.values[0] + 1.0).abs() < 1e-15, "{:?}", eigen.values);
        assert_eq!(lowest_of_any_sign(&(-&g), &m, 2).unwrap_err(), EigenError::TooFewModes(1));
        // Nor does it matter what has no inertia where the rigid motions are enough.
        let (g, m) = (DMatrix::from_row_slice(2, 2, &[0.0, 0.0, 0.0, 1.0]), &m);
        assert_eq!(lowest_of_any_sign(&g, m, 1).unwrap().values, [0.0]);
        assert_eq!(lowest_of_any_sign(&g, m, 2).unwrap_err(), EigenError::TooFewModes(1));
    }

    #[test]
    fn small_modes_beside_a_large_divergence_keep_their_digits() {
        let g = DMatrix::from_row_slice(3, 3, &[-1e6, 1e2, 0.0, 1e2, 2.0, -1.0, 0.0, -1.0, 1.0]);
        let eigen = lowest_of_any_sign(&g, &DMatrix::identity(3, 3), 3).unwrap();
        // Of the soft pair as the large one leaves it: 2 + 1e4/1e6 to first order.
        let product: f64 = eigen.values.iter().product();
        let determinant = -1e6 * (2.0 - 1.0) - 1e4;
        assert!((product / determinant - 1.0).abs() < 1e-12, "{:?}", eigen.values);
        assert!((eigen.values.iter().sum::<f64>() - (-1e6 + 3.0)).abs() < 1e-9, "{:?}", eigen.values);
    }

    proptest! {
        #[test]
        fn the_values_are_those_of_the_problem_by_the_factor_of_m(
            n in 1_usize..9,
            entries in prop::collection::vec(-1.0..1.0, 128),
        ) {
            let mut g = DMatrix::from_fn(n, n, |i, j| entries[i.max(j) * 8 + i.min(j)]);
            let root = DMatrix::from_fn(n, n, |i, j| entries[64 + i * 8 + j]);
            let m = &root * root.transpose() + DMatrix::identity(n, n) * 0.1;
            let eigen = lowest_of_any_sign(&g, &m, n).unwrap();
            assert_modes(&g, &m, &eigen, 1e-11);
            let l = Cholesky::new(m).unwrap().unpack();
            prop_assert!(l.solve_lower_triangular_mut(&mut g));
            g.transpose_mut();
            prop_assert!(l.solve_lower_triangular_mut(&mut g));
            let mut reference: Vec<f64> = g.symmetric_eigenvalues().iter().copied().collect();
            reference.sort_by(f64::total_cmp);
            let largest = reference.iter().fold(0.0, |most, value| f64::max(most, value.abs()));
            for (value, exact) in eigen.values.iter().zip(&reference) {
                prop_assert!((value - exact).abs() <= 1e-12 * largest, "{} {}", value, exact);
            }
        }
    }
}
