//! Rigid motions: functions without any potential energy, whose rows of G are exactly zero.
//!
//! Each is a mode with λ = 0. The other modes are orthogonal to it, (M q)_rigid = 0: that gives their
//! rigid component and leaves a problem with M's Schur complement. With several, one after the other
//! is taken out so, which is Cholesky's elimination, and makes them orthogonal to each other.

use super::{Eigen, EigenError, ascending, finite};
use crate::numerics::scalar::sqrt;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::{DMatrix, DVector};

/// A rigid motion that keeps less than this of its inertia beside those before it is a sum of them.
const NOTHING_NEW: f64 = 1e-13;

/// A rigid motion that has been taken out.
struct Rigid {
    /// Its place among the functions that were there still.
    index: usize,
    /// Its inertia less what those before have of it.
    inertia: f64,
    /// The rigid component of a mode is minus this times its others.
    row: DVector<f64>,
}

/// The `count` lowest modes. `solve` finds those of G and M without the rigid motions, which are so
/// many.
pub(super) fn beside(
    g: &DMatrix<f64>,
    m: &DMatrix<f64>,
    count: usize,
    solve: impl Fn(&DMatrix<f64>, &DMatrix<f64>, usize) -> Result<Eigen, EigenError>,
) -> Result<Eigen, EigenError> {
    let Some(first) = rigid_motion(g) else { return solve(g, m, 0) };
    let (mut g, mut m, mut whole) = (g.clone(), m.clone(), m.diagonal());
    m.fill_upper_triangle_with_lower_triangle();
    let mut rigid: Vec<Rigid> = Vec::new();
    let mut next = Some(first);
    while let Some(index) = next {
        let inertia = m[(index, index)];
        if inertia <= NOTHING_NEW * whole[index] {
            return Err(EigenError::TooFewModes(rigid.len()));
        }
        let row = m.column(index).remove_row(index) / inertia;
        g = g.remove_row(index).remove_column(index);
        m = m.remove_row(index).remove_column(index);
        m.ger(-inertia, &row, &row, 1.0);
        whole = whole.remove_row(index);
        rigid.push(Rigid { index, inertia, row });
        next = rigid_motion(&g);
    }
    let mut modes = if g.is_empty() {
        Eigen { values: Vec::new(), vectors: DMatrix::zeros(0, 0), residuals: Vec::new() }
    } else {
        solve(&g, &m, rigid.len()).map_err(|error| match error {
            EigenError::TooFewModes(left) => EigenError::TooFewModes(left + rigid.len()),
            other => other,
        })?
    };
    for motion in rigid.iter().rev() {
        let mut vectors = modes.vectors.insert_row(motion.index, 0.0).insert_column(0, 0.0);
        vectors[(motion.index, 0)] = 1.0 / sqrt(motion.inertia);
        for mode in 1..vectors.ncols() {
            let others = vectors.column(mode).remove_row(motion.index);
            vectors[(motion.index, mode)] = -motion.row.dot(&others);
        }
        modes.vectors = vectors;
    }
    let with_zeros = |list: Vec<f64>| -> Vec<f64> { vec![0.0; rigid.len()].into_iter().chain(list).collect() };
    modes.values = with_zeros(modes.values);
    modes.residuals = with_zeros(modes.residuals);
    let mut modes = finite(modes).map(ascending)?;
    let kept = count.min(modes.values.len());
    modes.values.truncate(kept);
    modes.residuals.truncate(kept);
    modes.vectors = modes.vectors.columns(0, kept).into_owned();
    Ok(modes)
}

/// The first function whose row of G is exactly zero. A zero diagonal alone is none: G is indefinite
/// there.
fn rigid_motion(g: &DMatrix<f64>) -> Option<usize> {
    let n = g.nrows();
    (0..n).find(|&i| g.row(i).columns(0, i + 1).iter().chain(g.column(i).rows(i, n - i).iter()).all(|v| *v == 0.0))
}

#[cfg(test)]
mod tests {
    use super::super::lowest;
    use super::*;

    fn assert_orthonormal(m: &DMatrix<f64>, eigen: &Eigen) {
        let gram = eigen.vectors.tr_mul(&(m * &eigen.vectors));
        let count = eigen.values.len();
        assert!((gram - DMatrix::<f64>::identity(count, count)).amax() < 1e-14, "orthonormal");
    }

    /// Three unit masses on a bending spring k (w₁ − 2w₂ + w₃)²/2: heave and pitch are free, λ₃ = 6k.
    #[test]
    fn a_free_beam_has_two_rigid_motions() {
        // Heave, pitch, and the middle alone.
        let m = DMatrix::from_row_slice(3, 3, &[3.0, 0.0, 1.0, 0.0, 2.0, 0.0, 1.0, 0.0, 1.0]);
        let mut g = DMatrix::zeros(3, 3);
        g[(2, 2)] = 4.0 * 5.0;
        for count in 1..=3 {
            let eigen = lowest(&g, &m, count).unwrap();
            assert_eq!(eigen.values.len(), count);
            assert!(eigen.values.iter().take(2).all(|value| *value == 0.0), "{:?}", eigen.values);
            assert!(eigen.values.get(2).is_none_or(|value| (value / 30.0 - 1.0).abs() < 1e-15), "{:?}", eigen.values);
            assert!(eigen.residuals.iter().all(|r| *r < 1e-15), "{:?}", eigen.residuals);
            assert_orthonormal(&m, &eigen);
        }
    }

    /// Masses 1, 2, 3, 4 in a row, a spring k = 5 between the last two: λ = 5 (1/3 + 1/4). The functions
    /// move all masses from the first, second, … on, in any order of the functions.
    #[test]
    fn three_rigid_motions_stand_anywhere() {
        let masses = [1.0, 2.0, 3.0, 4.0];
        for order in [[0, 1, 2, 3], [3, 0, 1, 2], [0, 3, 1, 2], [2, 1, 3, 0]] {
            let inertia = |i: usize, j: usize| masses[order[i].max(order[j])..].iter().sum::<f64>();
            let m = DMatrix::from_fn(4, 4, inertia);
            let g = DMatrix::from_fn(4, 4, |i, j| if order[i] == 3 && order[j] == 3 { 5.0 } else { 0.0 });
            let eigen = lowest(&g, &m, 4).unwrap();
            assert_eq!(eigen.values[..3], [0.0; 3]);
            assert!((eigen.values[3] / (35.0 / 12.0) - 1.0).abs() < 1e-14, "{order:?}: {:?}", eigen.values);
            assert_orthonormal(&m, &eigen);
        }
    }

    #[test]
    fn nothing_but_rigid_motions_is_solved_too() {
        let m = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, 2.0]);
        let eigen = lowest(&DMatrix::zeros(2, 2), &m, 2).unwrap();
        assert_eq!(eigen.values, [0.0; 2]);
        assert_orthonormal(&m, &eigen);
    }

    #[test]
    fn one_rigid_motion_twice_is_one() {
        let m = DMatrix::from_row_slice(3, 3, &[0.1, 0.3, 0.0, 0.3, 0.9, 0.0, 0.0, 0.0, 1.0]);
        let mut g = DMatrix::zeros(3, 3);
        g[(2, 2)] = 1.0;
        assert_eq!(lowest(&g, &m, 3).unwrap_err(), EigenError::TooFewModes(1));
        // And one without inertia is none.
        let m = DMatrix::from_diagonal(&DVector::from_vec(vec![0.0, 1.0, 1.0]));
        assert_eq!(lowest(&g, &m, 3).unwrap_err(), EigenError::TooFewModes(0));
    }

    #[test]
    fn a_zero_diagonal_in_a_row_of_others_is_no_rigid_motion() {
        let g = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 1.0, 5.0]);
        assert_eq!(lowest(&g, &DMatrix::identity(2, 2), 2).unwrap_err(), EigenError::NotPositiveDefinite);
    }

    #[test]
    fn only_the_lower_triangles_are_used() {
        let mut m = DMatrix::from_row_slice(3, 3, &[3.0, 0.0, 1.0, 0.0, 2.0, 0.0, 1.0, 0.0, 1.0]);
        let mut g = DMatrix::zeros(3, 3);
        g[(2, 2)] = 20.0;
        let eigen = lowest(&g, &m, 3).unwrap();
        (m[(0, 1)], m[(0, 2)], m[(1, 2)], g[(0, 2)]) = (9.0, 8.0, 7.0, 6.0);
        let other = lowest(&g, &m, 3).unwrap();
        assert_eq!((eigen.values, eigen.vectors), (other.values, other.vectors));
    }
}
