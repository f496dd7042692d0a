//! The assumed functions behind a result: either family, ready to be solved.

use super::settings::Settings;
use crate::blade::Blade;
use crate::converged::{Converged, Wanted, Work};
use crate::dof::Dof;
use crate::fault::Faults;
use crate::functions::{AssumedFunctions, BasisFamily};
use crate::lagrange::{
    Bounds, Energies, Fields, FromTip, Grid, Reference, SystemMatrices, assemble, bounds, classical_functions, system,
};
use crate::modes::{self, Mode, SolveError};
use crate::numerics::eigen::EigenError;
use crate::numerics::quadrature::GaussRules;
use alloc::boxed::Box;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// Points of each cell beyond what products of classical functions need, where bounds are asked
/// for: those divide by the stiffness.
const POINTS_FOR_BOUNDS: usize = 8;
/// The quadrature of piecewise gaps is exact but for the taper of the stiffness, which is at most
/// 2.5 over an element and changes the sum by less than this.
const TAPER_SLACK: f64 = 1.5;
/// A separation keeps so many times the error of the eigenvalue above it.
const ERROR_MARGIN: f64 = 10.0;

/// The paper's functions of one degree of freedom.
pub(super) struct Classical {
    pub(super) functions: Box<dyn AssumedFunctions>,
    pub(super) grid: Grid,
    pub(super) fields: Fields,
    pub(super) matrices: SystemMatrices,
}

impl Classical {
    pub(super) fn new(blade: &Blade, dof: Dof, count: usize, rules: &GaussRules, for_bounds: bool) -> Self {
        let functions = classical_functions(blade, dof, count);
        let more = if for_bounds { POINTS_FOR_BOUNDS } else { 0 };
        let grid = Grid::for_functions(blade, dof, functions.as_ref(), rules, more, &[]);
        let fields = Fields::sample(&grid, functions.as_ref());
        let matrices = assemble(&grid, Energies::new(&grid, &fields), functions.has_rigid_motion());
        Self { functions, grid, fields, matrices }
    }
}

/// One degree of freedom with the functions that the settings ask for.
pub(super) enum Basis {
    Classical(Box<Classical>),
    Piecewise(Box<Converged>),
}

impl Basis {
    /// Good for what is wanted.
    pub(super) fn new(
        blade: &Blade,
        dof: Dof,
        settings: &Settings,
        wanted: &Wanted,
        rules: &GaussRules,
        work: &mut Work,
    ) -> Result<Self, Faults> {
        Ok(match settings.basis {
            BasisFamily::Classical => {
                Self::Classical(Box::new(Classical::new(blade, dof, settings.functions, rules, false)))
            }
            BasisFamily::Piecewise => Self::Piecewise(Box::new(converged(blade, dof, wanted, rules, work)?)),
        })
    }

    pub(super) fn matrices(&self) -> &SystemMatrices {
        match self {
            Self::Classical(classical) => &classical.matrices,
            Self::Piecewise(converged) => converged.matrices(),
        }
    }

    /// Number of functions.
    pub(super) fn count(&self) -> usize {
        match self {
            Self::Classical(classical) => classical.matrices.count(),
            Self::Piecewise(converged) => converged.count(),
        }
    }

    /// Estimate of the largest relative error of an eigenvalue that the family is accountable for.
    pub(super) fn error(&self) -> f64 {
        match self {
            Self::Classical(_) => 0.0,
            Self::Piecewise(converged) => converged.error(),
        }
    }

    /// The functions, to be sampled.
    pub(super) fn into_functions(self) -> Box<dyn AssumedFunctions> {
        match self {
            Self::Classical(classical) => classical.functions,
            Self::Piecewise(converged) => Box::new(converged.functions()),
        }
    }

    /// The fields of modes at the points of [`grid`](Self::grid).
    pub(super) fn fields(&self, modes: &[Mode]) -> Fields {
        let coordinates = coordinates(modes);
        match self {
            Self::Classical(classical) => classical.fields.combined(&coordinates),
            Self::Piecewise(converged) => converged.fields(&coordinates),
        }
    }

    pub(super) fn grid(&self) -> &Grid {
        match self {
            Self::Classical(classical) => &classical.grid,
            Self::Piecewise(converged) => converged.grid(),
        }
    }

    /// Two-sided bounds of modes; none where nothing separates them from those above.
    pub(super) fn bounds(
        &self,
        modes: &[Mode],
        reference: &Reference,
        speed_squared: f64,
        rules: &GaussRules,
    ) -> Option<Bounds> {
        let slack = if matches!(self, Self::Piecewise(_)) { TAPER_SLACK } else { 1.0 };
        let own;
        let from_tip = match self {
            Self::Piecewise(converged) => converged.from_tip(),
            Self::Classical(_) => {
                own = FromTip::new(self.grid(), rules);
                &own
            }
        };
        bounds(self.grid(), from_tip, &self.fields(modes), &eigenvalues(modes), reference, speed_squared, slack)
    }
}

/// What separates modes from one another: the converged ones, one more than are bounded.
pub(super) fn separated(found: &Converged, modes: &[Mode]) -> Reference {
    let margin = found.counted().map_or(1.0, |share| share.max(ERROR_MARGIN * found.error()));
    Reference { eigenvalues: eigenvalues(modes), margin }
}

fn eigenvalues(modes: &[Mode]) -> Vec<f64> {
    modes.iter().map(|mode| mode.eigenvalue).collect()
}

/// The converged functions for what is wanted.
pub(super) fn converged(
    blade: &Blade,
    dof: Dof,
    wanted: &Wanted,
    rules: &GaussRules,
    work: &mut Work,
) -> Result<Converged, Faults> {
    Converged::new(blade, dof, wanted, rules, work)
        .map_err(|cause| super::unsolvable(SolveError { dofs: system(dof).dofs, cause }))
}

/// That converged functions gave no answer.
pub(super) fn failed(found: &Converged, cause: EigenError) -> Faults {
    super::unsolvable(SolveError { dofs: found.matrices().dofs(), cause })
}

pub(super) fn solve(matrices: &SystemMatrices, speed: f64, count: usize) -> Result<Vec<Mode>, Faults> {
    modes::solve(matrices, speed * speed, count).map_err(super::unsolvable)
}

fn coordinates(modes: &[Mode]) -> DMatrix<f64> {
    let n = modes.first().map_or(0, |mode| mode.coordinates.nrows());
    DMatrix::from_fn(n, modes.len(), |i, j| modes[j].coordinates[i])
}
