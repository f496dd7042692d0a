//! Mass, elastic, spring and centrifugal matrices (paper Eq. 42–47, 75–77), once per blade.

use super::grid::{Fields, Grid, dot, gram};
use crate::blade::{Blade, RootCondition};
use crate::dof::Dof;
use crate::functions::{AssumedFunctions, BendingRoot, ClassicalBending, ClassicalTorsion, TorsionRoot};
use crate::numerics::quadrature::GaussRules;
use alloc::boxed::Box;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// The matrices of one degree of freedom; (K + F + Ω² C − ω² M) q = 0 (Eq. 79–80). All symmetric,
/// n × n for n assumed functions.
#[derive(Clone, Debug)]
pub struct SystemMatrices {
    dof: Dof,
    mass: DMatrix<f64>,
    stiffness: DMatrix<f64>,
    centrifugal: DMatrix<f64>,
    rigid: bool,
}

impl SystemMatrices {
    /// The matrices of sums of the functions, one column of `coordinates` per sum; where there is a
    /// rigid motion, it stays the first alone.
    #[must_use]
    pub fn reduced(&self, coordinates: &DMatrix<f64>) -> Self {
        let project = |matrix: &DMatrix<f64>| {
            let mut product = coordinates.tr_mul(&(matrix * coordinates));
            product.fill_upper_triangle_with_lower_triangle();
            product
        };
        Self {
            dof: self.dof,
            mass: project(&self.mass),
            stiffness: project(&self.stiffness),
            centrifugal: project(&self.centrifugal),
            rigid: self.rigid,
        }
    }

    /// The degree of freedom.
    pub fn dof(&self) -> Dof {
        self.dof
    }

    /// Number of assumed functions n.
    pub fn count(&self) -> usize {
        self.mass.nrows()
    }

    /// M, ∫ m φ φ dr [kg] or ∫ ρI_p φ φ dr [kg·m²] (Eq. 42, 45).
    pub fn mass(&self) -> &DMatrix<f64> {
        &self.mass
    }

    /// K + F: strain energy of the blade, ∫ EI φ″ φ″ dr or ∫ GJ φ′ φ′ dr (Eq. 43, 46), and of the
    /// root spring, K_s φ′ φ′ or K_s φ φ at the root (Eq. 44, 47).
    pub fn stiffness(&self) -> &DMatrix<f64> {
        &self.stiffness
    }

    /// C per Ω²: flap ∫ T φ′ φ′ dr, lag the same less M, torsion ∫ m Y² φ φ dr (Eq. 75–77).
    pub fn centrifugal(&self) -> &DMatrix<f64> {
        &self.centrifugal
    }

    /// Whether the first function is a rigid motion without strain energy: a free root.
    pub fn has_rigid_motion(&self) -> bool {
        self.rigid
    }

    /// The matrices of the first `count` functions alone.
    #[must_use]
    pub fn leading(&self, count: usize) -> Self {
        let n = count.min(self.count());
        let lead = |matrix: &DMatrix<f64>| matrix.view((0, 0), (n, n)).into_owned();
        Self {
            dof: self.dof,
            mass: lead(&self.mass),
            stiffness: lead(&self.stiffness),
            centrifugal: lead(&self.centrifugal),
            rigid: self.rigid,
        }
    }
}

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

/// Energies of some functions (n × n each), before what the degree of freedom makes of them.
#[derive(Clone, Debug)]
pub struct Energies {
    /// ∫ J u_i u_j dr.
    pub inertia: DMatrix<f64>,
    /// ∫ D e_i e_j dr.
    pub strain: DMatrix<f64>,
    /// ∫ P t_i t_j dr.
    pub pull: DMatrix<f64>,
    /// ∫ J u_j dr.
    pub first_moment: Vec<f64>,
    /// The turn at the root.
    pub root_turn: Vec<f64>,
}

impl Energies {
    /// Of functions that stand at the points of a grid.
    pub fn new(grid: &Grid, fields: &Fields) -> Self {
        let masses: Vec<f64> = grid.weighted(grid.inertia()).collect();
        Self {
            inertia: gram(&fields.motion, grid.weighted(grid.inertia())),
            strain: gram(&fields.strain, grid.weighted(grid.stiffness())),
            pull: gram(&fields.turn, grid.weighted(grid.pull())),
            first_moment: fields.motion.as_slice().chunks_exact(grid.len()).map(|u| dot(&masses, u)).collect(),
            root_turn: fields.root_turn.clone(),
        }
    }
}

/// The matrices of one degree of freedom; `rigid` says that the first function is the rigid motion
/// (φ = sx or θ = s), whose strain energy is exactly 0.
pub fn assemble(grid: &Grid, energies: Energies, rigid: bool) -> SystemMatrices {
    let Energies { inertia: mass, strain: mut stiffness, pull: mut centrifugal, first_moment, root_turn } = energies;
    if grid.dof() == Dof::Lag {
        centrifugal -= &mass;
        if rigid {
            // φ₁ = s x: the tension's work is ∫ T s φ_j′ dr = s ∫ m r φ_j dr (by parts), the mass's
            // s ∫ m x φ_j dr; the difference is exactly the offset times s ∫ m φ_j dr. Written so
            // nothing cancels, and a central hinge is exactly free at every speed.
            let factor = grid.root() * root_turn.first().copied().unwrap_or(0.0);
            for (j, moment) in first_moment.iter().enumerate() {
                let row = factor * moment;
                (centrifugal[(j, 0)], centrifugal[(0, j)]) = (row, row);
            }
        }
    }
    if let RootCondition::Spring(spring) = grid.condition() {
        for (j, b) in root_turn.iter().enumerate() {
            for (i, a) in root_turn.iter().enumerate() {
                stiffness[(i, j)] += spring * a * b;
            }
        }
    }
    let rigid = rigid && grid.condition() == RootCondition::Free;
    SystemMatrices { dof: grid.dof(), mass, stiffness, centrifugal, rigid }
}

/// (2/l) ∫ φ φ dr (n × n) of torsion: a mode with qᵀ N q = 1 has ∫ X² dr = l/2 (Eq. 87).
pub fn torsion_norm(blade: &Blade, functions: &dyn AssumedFunctions, rules: &GaussRules) -> DMatrix<f64> {
    let grid = Grid::for_functions(blade, Dof::Torsion, functions, rules, 0);
    let per_half_length = 2.0 / (blade.radius() - grid.root());
    gram(&Fields::sample(&grid, functions).motion, grid.weight().iter().map(|weight| per_half_length * weight))
}
