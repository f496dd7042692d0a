//! The paper's assumed functions of a blade: the one place that sees both.

use super::fields::{Fields, gram};
use super::grid::Grid;
use crate::blade::{Blade, RootCondition};
use crate::dof::Dof;
use crate::functions::{AssumedFunctions, BendingRoot, ClassicalBending, ClassicalTorsion, TorsionRoot};
use crate::numerics::quadrature::GaussRules;
use alloc::boxed::Box;
use nalgebra::DMatrix;

/// The paper's assumed functions for one degree of freedom of a blade: `count` modes of the
/// uniform, non-rotating blade with the properties at mid-span (Eq. 17–28).
pub fn classical_functions(blade: &Blade, dof: Dof, count: usize) -> Box<dyn AssumedFunctions> {
    let root = blade.root(dof);
    let length = blade.radius() - root.offset;
    let middle = root.offset + 0.5 * length;
    let stiffness = blade.stiffness(dof).at(middle);
    if dof == Dof::Torsion {
        let condition = match root.condition {
            RootCondition::Clamped => TorsionRoot::Clamped,
            RootCondition::Free => TorsionRoot::Free,
            RootCondition::Spring(spring) => TorsionRoot::Spring(spring * length / stiffness),
        };
        return Box::new(ClassicalTorsion::new(condition, count, length));
    }
    let condition = match root.condition {
        RootCondition::Clamped => BendingRoot::Clamped,
        RootCondition::Free => BendingRoot::Free,
        RootCondition::Spring(spring) => BendingRoot::Spring(spring * length / stiffness),
    };
    Box::new(ClassicalBending::new(condition, count, length, blade.mass().at(middle)))
}

/// (2/l) ∫ φ φ dr (n × n) of torsion: a mode with qᵀ N q = 1 has ∫ X² dr = l/2 (Eq. 87).
pub fn torsion_norm(blade: &Blade, functions: &dyn AssumedFunctions, rules: &GaussRules) -> DMatrix<f64> {
    let grid = Grid::for_functions(blade, Dof::Torsion, functions, rules, 0, &[]);
    let per_half_length = 2.0 / (blade.radius() - grid.root());
    gram(&Fields::sample(&grid, functions).displacement, grid.weight().iter().map(|weight| per_half_length * weight))
}
