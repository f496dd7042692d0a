//! A few functions of the blade for a range of rotor speeds, as dense matrices: K + F, C, M and the residuals are
//! affine in Ω² between them, so every speed is a small eigenproblem.

use super::FLOOR;
use super::range::RangeMode;
use super::shares::in_sum_one;
use crate::numerics::eigen::{EigenError, ascending_values, lowest, lowest_of_plain};
use crate::numerics::scalar::{maximum, sqrt};
use crate::numerics::vector::{dot, four_dots};
use alloc::vec::Vec;
use nalgebra::{Cholesky, DMatrix};

/// What is left between two modes may move their eigenvalues by this share of them.
const UNSETTLED: f64 = 1e-15;

/// Functions with their matrices.
#[derive(Clone, Debug)]
pub struct Reduced {
    /// A shift that leaves K + F + sC + σM definite.
    sigma: f64,
    elastic: DMatrix<f64>,
    centrifugal: DMatrix<f64>,
    inertia: DMatrix<f64>,
    /// Kinetic energies of flap, lag and torsion about the mass centre.
    kinetic: [DMatrix<f64>; 3],
    /// Residual moments of every function, of its inertia, its centrifugal loads and its strains, turned so that
    /// an upper triangle is left: lengths stay what they are. Transposed.
    residuals: DMatrix<f64>,
    plain: Option<Plain>,
}

/// Coordinates in which M is the identity.
#[derive(Clone, Debug)]
struct Plain {
    elastic: DMatrix<f64>,
    centrifugal: DMatrix<f64>,
    /// The factor L of M.
    factor: DMatrix<f64>,
}

impl Plain {
    fn at(&self, s: f64) -> DMatrix<f64> {
        self.elastic.zip_map(&self.centrifugal, |elastic, centrifugal| elastic + s * centrifugal)
    }
}

impl Reduced {
    /// Of functions with these matrices K + F, C and M, kinetic energies, and residual moments.
    pub fn new(
        sigma: f64,
        [elastic, centrifugal, inertia]: [DMatrix<f64>; 3],
        kinetic: [DMatrix<f64>; 3],
        residuals: DMatrix<f64>,
    ) -> Self {
        let plain = Cholesky::new(inertia.clone()).map(|cholesky| {
            let factor = cholesky.unpack();
            Plain { elastic: congruent(&factor, &elastic), centrifugal: congruent(&factor, &centrifugal), factor }
        });
        let residuals = residuals.qr().unpack_r().transpose();
        Self { sigma, elastic, centrifugal, inertia, kinetic, residuals, plain }
    }

    /// The `count` lowest eigenvalues at Ω² = s alone, ascending: quick, and good to rounding of the highest one
    /// among the functions.
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn eigenvalues(&self, s: f64, count: usize) -> Result<Vec<f64>, EigenError> {
        let count = count.min(self.inertia.nrows());
        let Some(mut values) = self.plain.as_ref().and_then(|plain| ascending_values(plain.at(s))) else {
            return Ok(self.solve(s, count)?.0);
        };
        values.truncate(count);
        Ok(values)
    }

    /// λ and x of the lowest modes, of unit inertia.
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn solve(&self, s: f64, count: usize) -> Result<(Vec<f64>, DMatrix<f64>), EigenError> {
        let stiffness = self.elastic.zip_map(&self.centrifugal, |elastic, centrifugal| elastic + s * centrifugal);
        let count = count.min(self.inertia.nrows());
        if let Some(found) = self.quick(s, &stiffness, count) {
            return Ok(found);
        }
        let shifted = &stiffness + &self.inertia * self.sigma;
        let vectors = lowest(&shifted, &self.inertia, count)?.vectors;
        let (values, ..) = self.quotients(&stiffness, &vectors);
        Ok((values, vectors))
    }

    /// The same from the coordinates in which M is the identity, where what rounding of the highest eigenvalue leaves
    /// between the modes is nothing to them.
    fn quick(&self, s: f64, stiffness: &DMatrix<f64>, count: usize) -> Option<(Vec<f64>, DMatrix<f64>)> {
        let plain = self.plain.as_ref()?;
        let (_, mut vectors) = lowest_of_plain(plain.at(s), count)?;
        plain.factor.tr_solve_lower_triangular_mut(&mut vectors).then_some(())?;
        let (values, norms, loads) = self.quotients(stiffness, &vectors);
        for (mut x, norm) in vectors.column_iter_mut().zip(norms) {
            x /= sqrt(norm);
        }
        let floor = FLOOR * values.last()?.abs();
        for j in 1..values.len() {
            for i in 0..j {
                let between = dot(column(&vectors, i), column(&loads, j));
                let allowed = UNSETTLED * values[i].abs().max(floor);
                let moved = between * between;
                // Half the distance of coincident values counts in full.
                if moved > allowed * maximum(allowed, (values[j] - values[i]).abs()) {
                    return None;
                }
            }
        }
        Some((values, vectors))
    }

    /// Quotients of the modes themselves, which know no shift, their inertia, and what their stiffness loads them with.
    fn quotients(&self, stiffness: &DMatrix<f64>, vectors: &DMatrix<f64>) -> (Vec<f64>, Vec<f64>, DMatrix<f64>) {
        let (loads, inertia) = (times(stiffness, vectors, false), times(&self.inertia, vectors, false));
        let along = |loads: &DMatrix<f64>| -> Vec<f64> {
            (0..vectors.ncols()).map(|k| dot(column(vectors, k), column(loads, k))).collect()
        };
        let (energies, norms) = (along(&loads), along(&inertia));
        (energies.iter().zip(&norms).map(|(energy, norm)| energy / norm).collect(), norms, loads)
    }

    /// The lowest modes at Ω² = s.
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn modes(&self, s: f64, count: usize) -> Result<Vec<RangeMode>, EigenError> {
        let (values, vectors) = self.solve(s, count)?;
        let quadratic = |matrix: &DMatrix<f64>| -> Vec<f64> {
            let loads = times(matrix, &vectors, false);
            (0..values.len()).map(|k| dot(column(&vectors, k), column(&loads, k))).collect()
        };
        let slopes = quadratic(&self.centrifugal);
        let kinetic = self.kinetic.each_ref().map(quadratic);
        let mode = |(k, eigenvalue): (usize, &f64)| RangeMode {
            eigenvalue: *eigenvalue,
            slope: slopes[k],
            shares: in_sum_one([0, 1, 2].map(|of| kinetic[of][k])),
        };
        Ok(values.iter().enumerate().map(mode).collect())
    }

    /// The largest relative error of the lowest modes at Ω² = s, from their residuals.
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn error(&self, s: f64, count: usize) -> Result<f64, EigenError> {
        let (values, vectors) = self.solve(s, count)?;
        let rows = self.residual_rows(s, &values, &vectors);
        let floor = FLOOR * values.last().map_or(0.0, |value| value.abs());
        let relative = |(k, value): (usize, &f64)| rows.column(k).norm_squared() / value.abs().max(floor);
        Ok(values.iter().enumerate().map(relative).fold(0.0, maximum))
    }

    /// The energies of the residual moments of modes.
    pub fn gaps(&self, s: f64, values: &[f64], vectors: &DMatrix<f64>) -> DMatrix<f64> {
        let rows = self.residual_rows(s, values, vectors);
        times(&rows, &rows, false)
    }

    /// Columns: the residual moments of modes.
    fn residual_rows(&self, s: f64, values: &[f64], vectors: &DMatrix<f64>) -> DMatrix<f64> {
        let m = vectors.nrows();
        let mut parts = DMatrix::zeros(3 * m, values.len());
        for (k, value) in values.iter().enumerate() {
            let x = column(vectors, k);
            let own = &mut parts.as_mut_slice()[3 * m * k..3 * m * (k + 1)];
            for (part, factor) in own.chunks_exact_mut(m).zip([*value, s, 1.0]) {
                part.iter_mut().zip(x).for_each(|(part, x)| *part = factor * x);
            }
        }
        times(&self.residuals, &parts, true)
    }
}

fn column(matrix: &DMatrix<f64>, k: usize) -> &[f64] {
    &matrix.as_slice()[k * matrix.nrows()..(k + 1) * matrix.nrows()]
}

/// AᵀB, four columns of B at a time; where A is a lower triangle its zeros are left out.
fn times(a: &DMatrix<f64>, b: &DMatrix<f64>, triangular: bool) -> DMatrix<f64> {
    let mut out = DMatrix::zeros(a.ncols(), b.ncols());
    let last = b.ncols().saturating_sub(1);
    for first in (0..b.ncols()).step_by(4) {
        let columns = [0, 1, 2, 3].map(|k| column(b, (first + k).min(last)));
        for i in 0..a.ncols() {
            let from = if triangular { i.min(a.nrows()) } else { 0 };
            let sums = four_dots(&column(a, i)[from..], columns.map(|column| &column[from..]));
            for (k, sum) in sums.into_iter().enumerate().take(b.ncols() - first) {
                out[(i, first + k)] = sum;
            }
        }
    }
    out
}

/// L⁻¹ A L⁻ᵀ.
fn congruent(l: &DMatrix<f64>, a: &DMatrix<f64>) -> DMatrix<f64> {
    let half = l.solve_lower_triangular(a).unwrap_or_else(|| a.clone());
    let whole = l.solve_lower_triangular(&half.transpose()).unwrap_or(half);
    0.5 * (&whole + whole.transpose())
}
