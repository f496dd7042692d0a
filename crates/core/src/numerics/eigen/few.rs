//! The lowest eigenvalues of a symmetric matrix with their vectors, at less cost than all of them: Householder's
//! tridiagonal form, its values by QL steps without roots, and the vectors of those wanted by inverse iteration
//! (Golub & Van Loan, Matrix Computations, 4th ed., §8.3 and §8.4.2; C. H. Reinsch, Comm. ACM 16, 1973).
//! Good to rounding of the largest eigenvalue.

use super::STEPS_PER_EIGENVALUE;
use crate::numerics::scalar::sqrt;
use crate::numerics::vector::{axpy, dot, four_dots, scale};
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// Rounds of inverse iteration: one is enough but for eigenvalues that are nearly equal.
const ROUNDS: usize = 3;
/// Largest residual of a vector in the tridiagonal form, as a share of the largest eigenvalue.
const RESIDUAL: f64 = 1e-13;

/// All eigenvalues, ascending; only the lower triangle is used. `None` where an entry is no number, or the iteration
/// does not end.
pub fn ascending_values(mut matrix: DMatrix<f64>) -> Option<Vec<f64>> {
    let size = normalise(&mut matrix)?;
    let (diagonal, beside) = tridiagonalise(&mut matrix);
    Some(tridiagonal_values(diagonal, &beside)?.into_iter().map(|value| value * size).collect())
}

/// The `count` lowest eigenvalues, ascending, with orthonormal vectors; only the lower triangle is used. `None`
/// where an entry is no number or a vector is not found.
pub fn lowest_of_plain(mut matrix: DMatrix<f64>, count: usize) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let n = matrix.nrows();
    let size = normalise(&mut matrix)?;
    let (diagonal, beside) = tridiagonalise(&mut matrix);
    let mut values = tridiagonal_values(diagonal.clone(), &beside)?;
    values.truncate(count);
    let mut vectors: Vec<Vec<f64>> = Vec::with_capacity(values.len());
    for value in &values {
        let vector = vector(&diagonal, &beside, *value, &vectors)?;
        vectors.push(vector);
    }
    let mut out = DMatrix::zeros(n, values.len());
    for (mut vector, mut column) in vectors.into_iter().zip(out.column_iter_mut()) {
        for k in (0..n.saturating_sub(2)).rev() {
            let reflector = &matrix.as_slice()[k * n + k + 1..(k + 1) * n];
            let along = dot(reflector, &vector[k + 1..]);
            axpy(&mut vector[k + 1..], -along, reflector);
        }
        column.copy_from_slice(&vector);
    }
    Some((values.into_iter().map(|value| value * size).collect(), out))
}

/// Makes a matrix of its lower triangle, divided by its largest entry, so that no square over- or underflows where
/// it matters; that entry.
fn normalise(matrix: &mut DMatrix<f64>) -> Option<f64> {
    let entries = matrix.as_mut_slice();
    let size = entries.iter().fold(0.0, |most: f64, v| if v.abs() > most { v.abs() } else { most });
    if entries.is_empty() || entries.iter().any(|v| !v.is_finite()) {
        return None;
    }
    if size > 0.0 {
        for entry in entries.iter_mut() {
            *entry /= size;
        }
    }
    matrix.fill_upper_triangle_with_lower_triangle();
    Some(size)
}

/// The eigenvalues of a tridiagonal matrix, ascending.
fn tridiagonal_values(mut d: Vec<f64>, beside: &[f64]) -> Option<Vec<f64>> {
    let n = d.len();
    let mut squares: Vec<f64> = beside.iter().map(|e| e * e).collect();
    let mut steps = STEPS_PER_EIGENVALUE * n;
    for l in 0..n {
        loop {
            let divides = |m: &usize| {
                let size = f64::EPSILON * (d[*m].abs() + d[*m + 1].abs());
                squares[*m] <= size * size
            };
            let m = (l..n - 1).find(divides).unwrap_or(n - 1);
            if m == l {
                break;
            }
            steps = steps.checked_sub(1)?;
            // Wilkinson's shift, and a QL step on rows l to m in squares.
            let root = sqrt(squares[l]);
            let half = (d[l + 1] - d[l]) / (2.0 * root);
            let distance = sqrt(half * half + 1.0);
            let shift = d[l] - root / (half + if half < 0.0 { -distance } else { distance });
            let (mut c, mut s, mut gamma) = (1.0, 0.0, d[m] - shift);
            let mut p = gamma * gamma;
            for i in (l..m).rev() {
                let square = squares[i];
                let r = p + square;
                if i + 1 < m {
                    squares[i + 1] = s * r;
                }
                let before = c;
                (c, s) = (p / r, square / r);
                let (old, alpha) = (gamma, d[i]);
                gamma = c * (alpha - shift) - s * old;
                d[i + 1] = old + (alpha - gamma);
                p = if c == 0.0 { before * square } else { gamma * gamma / c };
            }
            squares[l] = s * p;
            d[l] = shift + gamma;
        }
    }
    d.sort_by(f64::total_cmp);
    d.iter().all(|v| v.is_finite()).then_some(d)
}

/// The diagonal and what stands beside it of QᵀAQ. Below the diagonal of each column the vector u of its reflection
/// 1 − uuᵀ is left.
fn tridiagonalise(matrix: &mut DMatrix<f64>) -> (Vec<f64>, Vec<f64>) {
    let n = matrix.nrows();
    let a = matrix.as_mut_slice();
    let mut beside = vec![0.0; n.saturating_sub(1)];
    let mut product = vec![0.0; n];
    for k in 0..n.saturating_sub(1) {
        let (left, right) = a.split_at_mut((k + 1) * n);
        let u = &mut left[k * n + k + 1..];
        let length = sqrt(dot(u, u));
        if k + 2 == n || length == 0.0 {
            beside[k] = u[0];
            u.fill(0.0);
            continue;
        }
        // Reflected onto −sign(u₀) |u|, u becomes √2 times a unit vector.
        let onto = if u[0] > 0.0 { -length } else { length };
        beside[k] = onto;
        let first = u[0] - onto;
        u[0] = first;
        scale(u, 1.0 / sqrt(-onto * first));
        // p = A u, and A − u qᵀ − q uᵀ with q = p − ½ (uᵀp) u.
        let (p, m) = (&mut product[..u.len()], u.len());
        let column = |j: usize| &right[j * n + k + 1..(j + 1) * n];
        for first in (0..m).step_by(4) {
            let sums = four_dots(u, [0, 1, 2, 3].map(|j| column((first + j).min(m - 1))));
            p[first..m.min(first + 4)].iter_mut().zip(sums).for_each(|(p, sum)| *p = sum);
        }
        let half = 0.5 * dot(u, p);
        axpy(p, -half, u);
        for j in 0..m {
            let (by_u, by_q) = (p[j], u[j]);
            take_off_two(&mut right[j * n + k + 1..(j + 1) * n], (by_u, u), (by_q, p));
        }
    }
    ((0..n).map(|k| a[k * n + k]).collect(), beside)
}

/// Takes a factor times each of two lists off a third. A function of its own, so that the compiler knows that the
/// lists do not overlap.
#[inline(never)]
fn take_off_two(from: &mut [f64], (by_u, u): (f64, &[f64]), (by_q, q): (f64, &[f64])) {
    let (u, q) = (&u[..from.len()], &q[..from.len()]);
    from.iter_mut().zip(u).zip(q).for_each(|((a, u), q)| *a -= by_u * u + by_q * q);
}

/// The unit vector of an eigenvalue of a tridiagonal matrix, orthogonal to those before.
fn vector(diagonal: &[f64], beside: &[f64], value: f64, before: &[Vec<f64>]) -> Option<Vec<f64>> {
    let n = diagonal.len();
    let factor = Factor::new(diagonal, beside, value);
    // Of no symmetry that a vector may have, and another for each of equal values.
    let mut x: Vec<f64> = (0..n).map(|i| 1.0 + 0.3 * ((i * (before.len() + 3)) % 5) as f64).collect();
    for round in 0..ROUNDS {
        factor.solve(&mut x);
        let largest = x.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        scale(&mut x, 1.0 / largest);
        for known in before {
            let along = dot(known, &x);
            axpy(&mut x, -along, known);
        }
        let length = sqrt(dot(&x, &x));
        scale(&mut x, 1.0 / length);
        if round > 0 && residual(diagonal, beside, value, &x) <= RESIDUAL {
            return Some(x);
        }
    }
    None
}

/// The length of (T − λ) x.
fn residual(diagonal: &[f64], beside: &[f64], value: f64, x: &[f64]) -> f64 {
    let n = diagonal.len();
    let row = |i: usize| {
        let before = if i > 0 { beside[i - 1] * x[i - 1] } else { 0.0 };
        let after = if i + 1 < n { beside[i] * x[i + 1] } else { 0.0 };
        (diagonal[i] - value) * x[i] + before + after
    };
    sqrt((0..n).map(|i| row(i) * row(i)).sum())
}

/// T − λ as a triangle of three diagonals, with the row exchanges that led there.
struct Factor {
    /// Inverse pivots, and what stands one and two beside.
    rows: Vec<[f64; 3]>,
    /// Whether a row was exchanged with the next, and what of the upper was taken off the lower.
    steps: Vec<(bool, f64)>,
}

impl Factor {
    fn new(diagonal: &[f64], beside: &[f64], value: f64) -> Self {
        let n = diagonal.len();
        let (mut rows, mut steps) = (Vec::with_capacity(n), Vec::with_capacity(n));
        // The row that is not finished: its pivot and the entry beside.
        let (mut pivot, mut next) = (diagonal[0] - value, beside.first().copied().unwrap_or(0.0));
        // A pivot of 0 is one of rounding: the largest entry is 1.
        let inverse =
            |pivot: f64| if pivot.abs() < f64::EPSILON * f64::EPSILON { 1.0 / f64::EPSILON } else { 1.0 / pivot };
        for i in 1..n {
            let below = [beside[i - 1], diagonal[i] - value, beside.get(i).copied().unwrap_or(0.0)];
            if below[0].abs() > pivot.abs() {
                let factor = pivot / below[0];
                rows.push([1.0 / below[0], below[1], below[2]]);
                steps.push((true, factor));
                (pivot, next) = (next - factor * below[1], -factor * below[2]);
            } else {
                let factor = below[0] * inverse(pivot);
                rows.push([inverse(pivot), next, 0.0]);
                steps.push((false, factor));
                (pivot, next) = (below[1] - factor * next, below[2]);
            }
        }
        rows.push([inverse(pivot), 0.0, 0.0]);
        Self { rows, steps }
    }

    fn solve(&self, x: &mut [f64]) {
        for (i, (exchanged, factor)) in self.steps.iter().enumerate() {
            if *exchanged {
                x.swap(i, i + 1);
            }
            x[i + 1] -= factor * x[i];
        }
        let (mut one, mut two) = (0.0, 0.0);
        for (x, [inverse, first, second]) in x.iter_mut().zip(&self.rows).rev() {
            *x = (*x - first * one - second * two) * inverse;
            (one, two) = (*x, one);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DVector, SymmetricEigen};
    use proptest::prelude::*;

    fn assert_found(matrix: &DMatrix<f64>, count: usize) {
        let (values, vectors) = lowest_of_plain(matrix.clone(), count).unwrap();
        assert_eq!(values, ascending_values(matrix.clone()).unwrap()[..count]);
        let mut known: Vec<f64> = SymmetricEigen::new(matrix.clone()).eigenvalues.iter().copied().collect();
        known.sort_by(f64::total_cmp);
        let size = matrix.amax().max(f64::MIN_POSITIVE) * matrix.nrows() as f64;
        for (value, known) in values.iter().zip(&known) {
            assert!((value - known).abs() <= 1e-14 * size, "{value} {known}");
        }
        let gram = vectors.tr_mul(&vectors) - DMatrix::<f64>::identity(count, count);
        assert!(gram.amax() < 1e-13, "{gram}");
        let off = matrix * &vectors - &vectors * DMatrix::from_diagonal(&DVector::from_vec(values));
        assert!(off.amax() <= 1e-12 * size, "{off}");
    }

    proptest! {
        #[test]
        fn the_lowest_are_found(
            n in 1_usize..24,
            wanted in 1_usize..24,
            entries in prop::collection::vec(-1.0..1.0, 576),
            grade in prop_oneof![Just(1.0), 0.3..1.0],
            size in prop_oneof![Just(1.0), Just(1e-100), Just(1e100)],
        ) {
            let matrix = DMatrix::from_fn(n, n, |i, j| {
                size * entries[i.max(j) * n + i.min(j)] * f64::powf(grade, (i + j) as f64)
            });
            assert_found(&matrix, wanted.min(n));
        }
    }

    #[test]
    fn values_of_several_have_as_many_vectors() {
        let v = DVector::from_vec(vec![0.5, -0.1, 0.3, 0.7, -0.4]).normalize();
        let mirror = DMatrix::identity(5, 5) - &v * v.transpose() * 2.0;
        let diagonal = DMatrix::from_diagonal(&DVector::from_vec(vec![3.0, 2.0, 3.0, 2.0, 3.0]));
        assert_found(&(&mirror * diagonal * &mirror), 4);
        assert_found(&DMatrix::identity(6, 6), 5);
        assert_found(&DMatrix::from_diagonal(&DVector::from_vec(vec![1.0, 5.0, 5.0, 2.0])), 3);
    }

    #[test]
    fn what_is_no_number_has_none() {
        assert!(lowest_of_plain(DMatrix::from_element(3, 3, f64::NAN), 2).is_none());
        assert!(ascending_values(DMatrix::zeros(0, 0)).is_none());
        assert_eq!(ascending_values(DMatrix::zeros(3, 3)), Some(vec![0.0; 3]));
    }
}
