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
        work: &Work,
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
            Self::Piecewise(converged) => converged.integration(),
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
    work: &Work,
) -> Result<Converged, Faults> {
    Converged::new(blade, dof, wanted, rules, work)
        .map_err(|cause| super::unsolvable(SolveError { dofs: system(blade, dof).dofs, cause }))
}

pub(super) fn solve(matrices: &SystemMatrices, speed: f64, count: usize) -> Result<Vec<Mode>, Faults> {
    modes::solve(matrices, speed * speed, count).map_err(super::unsolvable)
}

fn coordinates(modes: &[Mode]) -> DMatrix<f64> {
    let n = modes.first().map_or(0, |mode| mode.coordinates.nrows());
    DMatrix::from_fn(n, modes.len(), |i, j| modes[j].coordinates[i])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::converged::TOLERANCE;
    use crate::lagrange::tests::{cantilever, clamped, free, sprung};

    fn of(blade: &Blade, dof: Dof, family: BasisFamily) -> Basis {
        let settings = Settings { basis: family, functions: 6, ..Settings::default() };
        Basis::new(blade, dof, &settings, &Wanted::at(0.0, 3), &GaussRules::new(), &Work::default()).unwrap()
    }

    const FAMILIES: [BasisFamily; 2] = [BasisFamily::Classical, BasisFamily::Piecewise];

    /// ω² = EI/m (z/l)⁴ of both families: the paper's functions are the modes, the others come to
    /// within the tolerance.
    #[test]
    fn either_family_finds_the_uniform_cantilever() {
        for family in FAMILIES {
            let basis = of(&clamped(0.5), Dof::Flap, family);
            assert!(basis.error() < TOLERANCE && basis.count() >= basis.matrices().count());
            for (index, mode) in solve(basis.matrices(), 0.0, 3).unwrap().iter().enumerate() {
                let known = cantilever(index, 1.5);
                assert!((mode.eigenvalue / known - 1.0).abs() < TOLERANCE, "{family:?} {index}: {}", mode.eigenvalue);
            }
        }
    }

    /// ∫ J u² dr = 1 and ∫ D e² dr + K t² = ω² of mass-normalised modes: sums along the span against
    /// matrices, rounded some hundred times.
    #[test]
    fn fields_of_modes_have_their_energies() {
        for blade in [clamped(0.5), free(0.5), sprung(0.5)] {
            for dof in Dof::ALL {
                for family in FAMILIES {
                    let basis = of(&blade, dof, family);
                    let modes = solve(basis.matrices(), 0.0, 3).unwrap();
                    let (grid, fields) = (basis.grid(), basis.fields(&modes));
                    let energies = Energies::new(grid, &fields);
                    let spring = if let crate::blade::RootCondition::Spring(k) = grid.condition() { k } else { 0.0 };
                    for (i, mode) in modes.iter().enumerate() {
                        assert!((energies.inertia[(i, i)] - 1.0).abs() < 1e-11, "{dof} {family:?} {i}");
                        let potential = energies.elastic[(i, i)] + spring * fields.root_rotation[i].powi(2);
                        let off = (potential - mode.eigenvalue).abs();
                        assert!(off <= 1e-10 * mode.eigenvalue, "{dof} {family:?} {i}: {off:e}");
                    }
                }
            }
        }
    }

    /// Ritz values of the paper's functions for another blade, between bounds from the converged ones.
    #[test]
    fn bounds_hold_what_is_known() {
        let (blade, rules) = (clamped(0.5), GaussRules::new());
        let found = converged(&blade, Dof::Flap, &Wanted::at(0.0, 4), &rules, &Work::default()).unwrap();
        let modes = solve(found.matrices(), 0.0, 4).unwrap();
        let reference = separated(&found, &modes);
        assert!(reference.margin < 1e-4, "counted: {}", reference.margin);
        assert_eq!(reference.eigenvalues.len(), 4);
        let basis = Basis::Piecewise(Box::new(found));
        let bounds = basis.bounds(&modes[..3], &reference, 0.0, &rules).unwrap();
        for (index, interval) in bounds.intervals.iter().enumerate() {
            // The exact number itself is a rounded fourth power.
            let (known, rounding) = (cantilever(index, 1.5), 4e-15);
            assert!(interval.lower <= known * (1.0 + rounding) && interval.upper >= known * (1.0 - rounding));
            assert!(interval.upper / interval.lower < 1.0 + 1e-9, "{index}: {interval:?}");
        }
    }

    /// What comes out to be sampled are the functions behind the matrices.
    #[test]
    fn functions_come_out_as_they_went_in() {
        for family in FAMILIES {
            let basis = of(&sprung(0.5), Dof::Lag, family);
            let count = basis.matrices().count();
            let rigid = basis.matrices().rigid().len();
            let functions = basis.into_functions();
            assert_eq!((functions.count(), rigid), (count, 0), "{family:?}: a spring leaves no motion rigid");
        }
        assert!(of(&free(0.5), Dof::Flap, BasisFamily::Piecewise).into_functions().has_rigid_motion());
    }
}
