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
            EigenError::NotPositiveDefinite if self.dofs == [Dof::Torsion] => {
                let why = "a propeller moment turns sections over, or the stiffness varies too much for f64";
                write!(f, "the torsion stiffness matrix is not positive definite; {why}")
            }
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

/// Multiplications of finding eigenvalues alone, and with their shapes, by the cube of the order.
pub const VALUES_PER_CUBE: f64 = 4.0;
const SHAPES_PER_CUBE: f64 = 4.0;

/// Eigenvalues without their shapes.
#[derive(Clone, Debug)]
pub struct Eigenvalues {
    /// λ [rad²/s²], ascending.
    pub values: Vec<f64>,
    /// About how many multiplications it took.
    pub work: f64,
}

/// The `count` lowest eigenvalues at Ω² = `speed_squared` [rad²/s²] without their shapes.
///
/// # Errors
/// [`SolveError`].
pub fn eigenvalues(matrices: &SystemMatrices, speed_squared: f64, count: usize) -> Result<Eigenvalues, SolveError> {
    let g = matrices.stiffness() + matrices.centrifugal() * speed_squared;
    let n = matrices.count() as f64;
    let work = VALUES_PER_CUBE * n * n * n;
    if let Some(values) = lowest_values(&g, matrices.mass(), count.min(matrices.count())) {
        return Ok(Eigenvalues { values, work });
    }
    let values = solve(matrices, speed_squared, count)?.iter().map(|mode| mode.eigenvalue).collect();
    Ok(Eigenvalues { values, work: work + SHAPES_PER_CUBE * n * n * n })
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blade::Blade;
    use crate::lagrange::tests::{cantilever, clamped, free};
    use crate::lagrange::{Energies, Fields, Grid, assemble, classical_functions};
    use crate::numerics::quadrature::GaussRules;
    use alloc::string::ToString;

    fn matrices(blade: &Blade, dof: Dof) -> SystemMatrices {
        let functions = classical_functions(blade, dof, 5);
        let grid = Grid::for_functions(blade, dof, functions.as_ref(), &GaussRules::new(), 0, &[]);
        let fields = Fields::sample(&grid, functions.as_ref());
        assemble(&grid, Energies::new(&grid, &fields), functions.has_rigid_motion())
    }

    #[test]
    fn a_system_is_named_by_its_degrees_of_freedom() {
        let message = |dofs, cause| SolveError { dofs, cause }.to_string();
        let coupled = message(&Dof::ALL, EigenError::NotConverged);
        assert_eq!(coupled, "the flap-lag-torsion eigenvalues did not converge");
        let single = message(&[Dof::Lag], EigenError::TooFewModes(2));
        assert_eq!(single, "the inertia along the span determines only 2 lag modes; ask for fewer modes");
        assert!(message(&[Dof::Torsion], EigenError::NonFinite).starts_with("the torsion matrices overflow"));
    }

    /// At rest the functions are the modes: ω² = EI/m (z/l)⁴, of the fourth power of a rounded z.
    #[test]
    fn a_uniform_cantilever_has_its_frequencies() {
        let matrices = matrices(&clamped(0.5), Dof::Flap);
        let modes = solve(&matrices, 0.0, 4).unwrap();
        for (index, mode) in modes.iter().enumerate() {
            let known = cantilever(index, 1.5);
            assert!((mode.eigenvalue / known - 1.0).abs() < 1e-12, "{index}: {} {known}", mode.eigenvalue);
            assert_eq!(mode.frequency, mode.eigenvalue.sqrt());
            assert!(mode.residual < 1e-12, "{index}: {:e}", mode.residual);
            let square = mode.coordinates.dot(&(matrices.mass() * &mode.coordinates));
            assert!((square - 1.0).abs() < 1e-13, "{index}: unit generalised mass, rounded");
        }
        assert_eq!(solve(&matrices, 0.0, 9).unwrap().len(), 5, "as many as there are functions");
    }

    /// About the hub a rigid motion has ω = Ω in flap and 0 in lag, and the slope 1 or 0 by Ω². At
    /// higher modes the slope is the derivative of the eigenvalue.
    #[test]
    fn the_southwell_coefficient_is_the_slope() {
        for (dof, square) in [(Dof::Flap, 1.0), (Dof::Lag, 0.0)] {
            let matrices = matrices(&free(0.0), dof);
            for s in [0.0, 9.0, 225.0] {
                let modes = solve(&matrices, s, 3).unwrap();
                assert!((modes[0].eigenvalue - square * s).abs() <= 1e-13 * s, "{dof}: {}", modes[0].eigenvalue);
                assert!((modes[0].southwell - square).abs() < 1e-12, "{dof}: {}", modes[0].southwell);
                let h = 1e-3;
                let (more, less) = (solve(&matrices, s + h, 3).unwrap(), solve(&matrices, s - h, 3));
                let Ok(less) = less else { continue };
                for ((mode, more), less) in modes.iter().zip(&more).zip(&less).skip(1) {
                    let slope = (more.eigenvalue - less.eigenvalue) / (2.0 * h);
                    // Eigenvalues of up to 1e5 lose 1e-11 each, by a step of 1e-3.
                    assert!((mode.southwell - slope).abs() < 1e-6, "{dof}: {} {slope}", mode.southwell);
                }
            }
        }
    }

    #[test]
    fn values_alone_are_those_of_the_modes() {
        for blade in [clamped(0.5), free(0.5)] {
            for dof in Dof::ALL {
                let matrices = matrices(&blade, dof);
                let (values, modes) =
                    (eigenvalues(&matrices, 50.0, 4).unwrap().values, solve(&matrices, 50.0, 4).unwrap());
                assert_eq!(values.len(), 4);
                for (value, mode) in values.iter().zip(&modes) {
                    // Two ways through the same few rotations.
                    assert!((value - mode.eigenvalue).abs() <= 1e-12 * mode.eigenvalue, "{dof}: {value}");
                }
            }
        }
    }

    #[test]
    fn an_error_says_whose_it_is() {
        let overflowed = matrices(&clamped(0.5), Dof::Flap).reduced(&DMatrix::from_element(5, 1, 1e300));
        let error = solve(&overflowed, 0.0, 1).unwrap_err();
        assert_eq!(error, SolveError { dofs: &[Dof::Flap], cause: EigenError::NonFinite });
        assert_eq!(eigenvalues(&overflowed, 0.0, 1).unwrap_err(), error);
    }
}
