//! Eigenvalues of a symmetric matrix without its vectors, in a bounded number of steps.
//!
//! nalgebra has them by `symmetric_eigenvalues`, which iterates without bound and panics where an
//! entry is not a number, and by `SymmetricEigen::try_new`, which finds the vectors too. Here its
//! tridiagonal form goes through the QR steps of Golub & Van Loan, Matrix Computations, 4th ed.,
//! Algorithm 8.3.3, each operation as nalgebra has it: the results are the same to the bit.

use super::STEPS_PER_EIGENVALUE;
use crate::numerics::scalar::sqrt;
use alloc::vec::Vec;
use nalgebra::linalg::givens::GivensRotation;
use nalgebra::{DMatrix, DVector, SymmetricTridiagonal, Vector2, wilkinson_shift};

/// All eigenvalues, in no order; only the lower triangle is used. `None` where an entry is infinite
/// or not a number, or where the iteration does not end.
pub fn eigenvalues(matrix: DMatrix<f64>) -> Option<Vec<f64>> {
    let steps = STEPS_PER_EIGENVALUE * matrix.nrows();
    eigenvalues_within(steps, matrix)
}

fn eigenvalues_within(steps: usize, mut matrix: DMatrix<f64>) -> Option<Vec<f64>> {
    if matrix.iter().any(|v| !v.is_finite()) {
        return None;
    }
    if matrix.is_empty() {
        return Some(Vec::new());
    }
    // The largest entry is 1, so that no square over- or underflows where it matters.
    let size = matrix.amax();
    if size > 0.0 {
        matrix /= size;
    }
    let mut last = matrix.nrows() - 1;
    let (mut diagonal, mut beside) = SymmetricTridiagonal::new(matrix).unpack_tridiagonal();
    for _ in 0..=steps {
        let Some((first, end)) = undivided(&diagonal, &mut beside, last) else {
            return Some(diagonal.iter().map(|value| value * size).collect());
        };
        last = end;
        if end - first == 1 {
            solve_pair(&mut diagonal, &mut beside, first);
        } else {
            step(&mut diagonal, &mut beside, first, end);
        }
    }
    None
}

/// The last block up to `last` of more than one row that nothing divides; its first and last row.
fn undivided(diagonal: &DVector<f64>, beside: &mut DVector<f64>, last: usize) -> Option<(usize, usize)> {
    let divides = |value: f64, k: usize| value.abs() <= f64::EPSILON * (diagonal[k + 1].abs() + diagonal[k].abs());
    let end = (1..=last).rev().find(|&k| !divides(beside[k - 1], k - 1))?;
    match (0..end - 1).rev().find(|&k| divides(beside[k], k)) {
        Some(k) => {
            beside[k] = 0.0;
            Some((k + 1, end))
        }
        None => Some((0, end)),
    }
}

/// Both eigenvalues of a block of two rows.
fn solve_pair(diagonal: &mut DVector<f64>, beside: &mut DVector<f64>, first: usize) {
    let (a, b, coupling) = (diagonal[first], diagonal[first + 1], beside[first]);
    let half = (a - b) * 0.5;
    let distance = sqrt(coupling * coupling + half * half);
    let middle = (a + b) * 0.5;
    (diagonal[first], diagonal[first + 1]) = (middle + distance, middle - distance);
    beside[first] = 0.0;
}

/// One implicit QR step with Wilkinson's shift on rows `first` to `end`, at least three.
fn step(diagonal: &mut DVector<f64>, beside: &mut DVector<f64>, first: usize, end: usize) {
    let shift = wilkinson_shift(diagonal[end - 1], diagonal[end], beside[end - 1]);
    let mut bulge = Vector2::new(diagonal[first] - shift, beside[first]);
    for i in first..end {
        let Some((rotation, norm)) = GivensRotation::cancel_y(&bulge) else { break };
        if i > first {
            beside[i - 1] = norm;
        }
        let (c, s) = (rotation.c(), rotation.s());
        let (cc, ss, cs) = (c * c, s * s, c * s);
        let (a, b, coupling) = (diagonal[i], diagonal[i + 1], beside[i]);
        let mixed = cs * 2.0 * coupling;
        diagonal[i] = (cc * a + ss * b) - mixed;
        diagonal[i + 1] = (ss * a + cc * b) + mixed;
        beside[i] = cs * (a - b) + coupling * (cc - ss);
        if i + 1 < end {
            bulge = Vector2::new(beside[i], -s * beside[i + 1]);
            beside[i + 1] *= c;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;
    use nalgebra::SymmetricEigen;
    use proptest::prelude::*;

    fn sorted(mut values: Vec<f64>) -> Vec<f64> {
        values.sort_by(f64::total_cmp);
        values
    }

    /// A symmetric matrix of these entries, row and column i of it times `grade`ⁱ.
    fn graded(n: usize, entries: &[f64], grade: f64) -> DMatrix<f64> {
        DMatrix::from_fn(n, n, |i, j| entries[i.max(j) * n + i.min(j)] * grade.powf((i + j) as f64))
    }

    proptest! {
        #[test]
        fn the_values_are_those_with_vectors_and_those_of_the_library(
            n in 1_usize..24,
            // Whole numbers give zeros and eigenvalues of several.
            entries in prop_oneof![
                prop::collection::vec(-1.0..1.0, 576),
                prop::collection::vec((-1..2).prop_map(f64::from), 576),
            ],
            grade in prop_oneof![Just(1.0), 0.1..2.0],
            size in prop_oneof![Just(1.0), Just(1e-200), Just(1e200)],
        ) {
            let matrix = graded(n, &entries, grade) * size;
            let found = eigenvalues(matrix.clone()).unwrap();
            let library = matrix.symmetric_eigenvalues();
            prop_assert_eq!(&found, library.as_slice());
            let found = sorted(found);
            let with_vectors = SymmetricEigen::try_new(matrix, f64::EPSILON, 60 * n).unwrap().eigenvalues;
            let with_vectors = sorted(with_vectors.as_slice().to_vec());
            let largest = with_vectors.iter().fold(0.0, |most, value| f64::max(most, value.abs()));
            for (value, other) in found.iter().zip(&with_vectors) {
                prop_assert!((value - other).abs() <= 1e-15 * largest, "{} {}", value, other);
            }
        }
    }

    #[test]
    fn closed_forms_are_met() {
        // A chain of springs clamped at both ends: 2 − 2 cos(kπ/(n + 1)).
        let n = 40;
        let chain = DMatrix::from_fn(n, n, |i, j| match i.abs_diff(j) {
            0 => 2.0,
            1 => -1.0,
            _ => 0.0,
        });
        let found = sorted(eigenvalues(chain).unwrap());
        for (k, value) in (1..).zip(&found) {
            let exact = 2.0 - 2.0 * (core::f64::consts::PI * f64::from(k) / 41.0).cos();
            assert!((value - exact).abs() < 1e-14, "{value} {exact}");
        }
        assert_eq!(eigenvalues(DMatrix::zeros(3, 3)), Some(vec![0.0; 3]));
        assert_eq!(eigenvalues(DMatrix::identity(3, 3) * 4.0), Some(vec![4.0; 3]));
        assert_eq!(eigenvalues(DMatrix::zeros(0, 0)), Some(vec![]));
    }

    #[test]
    fn neither_what_is_no_number_nor_too_few_steps_give_values() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for at in [(0, 0), (2, 1), (3, 3)] {
                let mut matrix = DMatrix::identity(4, 4);
                matrix[at] = bad;
                assert_eq!(eigenvalues(matrix), None, "{bad} at {at:?}");
            }
        }
        let hilbert = DMatrix::from_fn(8, 8, |i, j| 1.0 / (i + j + 1) as f64);
        assert_eq!(eigenvalues_within(3, hilbert.clone()), None);
        assert!(eigenvalues(hilbert).is_some());
    }
}
