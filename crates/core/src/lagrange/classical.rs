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
    gram(&Fields::sample(&grid, functions).displacement, grid.length().iter().map(|weight| per_half_length * weight))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::functions::Sample;
    use crate::lagrange::tests::{free, sprung, tapered};

    fn assert_same(blade: &Blade, dof: Dof, known: &dyn AssumedFunctions) {
        let found = classical_functions(blade, dof, 3);
        assert_eq!((found.count(), found.has_rigid_motion()), (3, known.has_rigid_motion()), "{dof}");
        let (mut a, mut b) = ([Sample::default(); 3], [Sample::default(); 3]);
        for x in [0.0, 0.1, 0.7, 1.5] {
            found.sample(x, &mut a);
            known.sample(x, &mut b);
            assert_eq!(a, b, "{dof} at {x}");
        }
    }

    /// At 1.25 m the tapered blade has 0.875 kg/m, 65 N·m² in lag and 16.25 N·m² in torsion.
    #[test]
    fn functions_are_those_of_the_uniform_blade_at_mid_span() {
        let blade = tapered();
        assert_same(&blade, Dof::Flap, &ClassicalBending::new(BendingRoot::Clamped, 3, 1.5, 0.875));
        assert_same(&blade, Dof::Lag, &ClassicalBending::new(BendingRoot::Spring(40.0 * 1.5 / 65.0), 3, 1.5, 0.875));
        assert_same(&blade, Dof::Torsion, &ClassicalTorsion::new(TorsionRoot::Clamped, 3, 1.5));
        assert_same(&free(0.5), Dof::Flap, &ClassicalBending::new(BendingRoot::Free, 3, 1.5, 2.0));
        assert_same(&free(0.5), Dof::Torsion, &ClassicalTorsion::new(TorsionRoot::Free, 3, 1.5));
        let spring = TorsionRoot::Spring(40.0 * 1.5 / 30.0);
        assert_same(&sprung(0.5), Dof::Torsion, &ClassicalTorsion::new(spring, 3, 1.5));
    }

    /// Each has ∫ θ² dx = l/2 (Eq. 30), and sines of different modes are orthogonal; a sum over some
    /// tens of points rounds a few times.
    #[test]
    fn the_norm_of_torsion_is_one() {
        let blade = tapered();
        let functions = classical_functions(&blade, Dof::Torsion, 5);
        let norm = torsion_norm(&blade, functions.as_ref(), &GaussRules::new());
        assert!((norm - DMatrix::<f64>::identity(5, 5)).amax() < 1e-14);
    }
}
