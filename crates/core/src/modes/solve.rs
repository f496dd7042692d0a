//! The eigenproblem of one system at one speed.

use crate::dof::Dof;
use crate::lagrange::SystemMatrices;
use crate::numerics::eigen::{EigenError, lowest, lowest_values, vectors};
use crate::numerics::scalar::sqrt;
use alloc::vec::Vec;
use core::fmt;
use nalgebra::{DMatrix, DVector};

/// One mode of one system.
#[derive(Clone, Debug)]
pub struct Mode {
    /// λ = ω² [rad²/s²]; exactly 0 for a rigid mode.
    pub eigenvalue: f64,
    /// ω [rad/s].
    pub frequency: f64,
    /// Generalised coordinates q, qᵀ M q = 1.
    pub coordinates: DVector<f64>,
    /// dλ/dΩ² = qᵀ C q.
    pub southwell: f64,
    /// ‖Gq − λMq‖ / ‖λMq‖ in the scaled basis.
    pub residual: f64,
}

/// Why the equations of a system have no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SolveError {
    /// The degrees of freedom of the system.
    pub dofs: &'static [Dof],
    /// What is wrong.
    pub cause: EigenError,
}

impl fmt::Display for SolveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let dofs = Names(self.dofs);
        match self.cause {
            EigenError::NonFinite => write!(f, "the {dofs} matrices overflow; are the units right?"),
            EigenError::NotPositiveDefinite => {
                write!(f, "the {dofs} stiffness matrix is not positive definite; the stiffness varies too much for f64")
            }
            EigenError::NotConverged => write!(f, "the {dofs} eigenvalues did not converge"),
            EigenError::TooFewModes(left) => {
                write!(f, "the inertia along the span determines only {left} {dofs} modes; ask for fewer modes")
            }
        }
    }
}

/// `flap`, or `flap-lag-torsion` for degrees of freedom that feel one another.
struct Names(&'static [Dof]);

impl fmt::Display for Names {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, dof) in self.0.iter().enumerate() {
            if index > 0 {
                f.write_str("-")?;
            }
            f.write_str(dof.name())?;
        }
        Ok(())
    }
}

impl core::error::Error for SolveError {}

/// The `count` lowest eigenvalues at Ω² = `speed_squared` [rad²/s²] without their shapes.
///
/// # Errors
/// [`SolveError`].
pub fn eigenvalues(matrices: &SystemMatrices, speed_squared: f64, count: usize) -> Result<Vec<f64>, SolveError> {
    let g = matrices.stiffness() + matrices.centrifugal() * speed_squared;
    match lowest_values(&g, matrices.mass(), count.min(matrices.count())) {
        Some(values) => Ok(values),
        None => Ok(solve(matrices, speed_squared, count)?.iter().map(|mode| mode.eigenvalue).collect()),
    }
}

/// Generalised coordinates of modes with these eigenvalues at Ω² = `speed_squared` [rad²/s²], qᵀ M q = 1, one
/// column each.
///
/// # Errors
/// [`SolveError`].
pub fn coordinates(matrices: &SystemMatrices, speed_squared: f64, values: &[f64]) -> Result<DMatrix<f64>, SolveError> {
    let g = matrices.stiffness() + matrices.centrifugal() * speed_squared;
    if let Some(found) = vectors(&g, matrices.mass(), values) {
        return Ok(found);
    }
    let modes = solve(matrices, speed_squared, values.len())?;
    Ok(DMatrix::from_fn(matrices.count(), modes.len(), |i, j| modes[j].coordinates[i]))
}

/// The `count` lowest modes at Ω² = `speed_squared` [rad²/s²], or as many as there are functions.
///
/// # Errors
/// [`SolveError`].
pub fn solve(matrices: &SystemMatrices, speed_squared: f64, count: usize) -> Result<Vec<Mode>, SolveError> {
    let g = matrices.stiffness() + matrices.centrifugal() * speed_squared;
    let eigen = lowest(&g, matrices.mass(), count).map_err(|cause| SolveError { dofs: matrices.dofs(), cause })?;
    let modes = eigen.values.iter().zip(eigen.residuals).zip(eigen.vectors.column_iter());
    Ok(modes
        .map(|((&eigenvalue, residual), vector)| Mode {
            eigenvalue,
            frequency: sqrt(eigenvalue),
            coordinates: vector.into_owned(),
            southwell: vector.dot(&(matrices.centrifugal() * vector)),
            residual,
        })
        .collect())
}
