//! Mass, elastic, spring and centrifugal matrices (paper Eq. 42–47, 75–77), once per blade.

use super::fields::{Fields, gram};
use super::grid::Grid;
use crate::blade::RootCondition;
use crate::dof::Dof;
use crate::numerics::vector::dot;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// The matrices of one system; (K + F + Ω² C − ω² M) q = 0 (Eq. 79–80). All symmetric, n × n for n
/// assumed functions of all its degrees of freedom.
#[derive(Clone, Debug)]
pub struct SystemMatrices {
    dofs: &'static [Dof],
    mass: DMatrix<f64>,
    stiffness: DMatrix<f64>,
    centrifugal: DMatrix<f64>,
    rigid: Vec<usize>,
}

impl SystemMatrices {
    /// The matrices of sums of the functions, one column of `coordinates` per sum; rigid motions stay
    /// where they are and alone.
    #[must_use]
    pub fn reduced(&self, coordinates: &DMatrix<f64>) -> Self {
        let project = |matrix: &DMatrix<f64>| {
            let mut product = coordinates.tr_mul(&(matrix * coordinates));
            product.fill_upper_triangle_with_lower_triangle();
            product
        };
        Self {
            dofs: self.dofs,
            mass: project(&self.mass),
            stiffness: project(&self.stiffness),
            centrifugal: project(&self.centrifugal),
            rigid: self.rigid.clone(),
        }
    }

    /// The degrees of freedom that feel one another.
    pub fn dofs(&self) -> &'static [Dof] {
        self.dofs
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

    /// Functions that are a rigid motion without strain energy, one per free root, ascending.
    pub fn rigid(&self) -> &[usize] {
        &self.rigid
    }

    /// The matrices of the first `count` functions alone.
    #[must_use]
    pub fn leading(&self, count: usize) -> Self {
        let n = count.min(self.count());
        let lead = |matrix: &DMatrix<f64>| matrix.view((0, 0), (n, n)).into_owned();
        Self {
            dofs: self.dofs,
            mass: lead(&self.mass),
            stiffness: lead(&self.stiffness),
            centrifugal: lead(&self.centrifugal),
            rigid: self.rigid.iter().copied().filter(|&function| function < n).collect(),
        }
    }
}

/// Energies of some functions (n × n each), before what the degree of freedom makes of them.
#[derive(Clone, Debug)]
pub struct Energies {
    /// ∫ J u_i u_j dr.
    pub inertia: DMatrix<f64>,
    /// ∫ D e_i e_j dr.
    pub elastic: DMatrix<f64>,
    /// ∫ P t_i t_j dr, per Ω².
    pub centrifugal: DMatrix<f64>,
    /// ∫ J u_j dr.
    pub first_moment: Vec<f64>,
    /// The rotation at the root.
    pub root_rotation: Vec<f64>,
}

impl Energies {
    /// Of functions that stand at the points of a grid.
    pub fn new(grid: &Grid, fields: &Fields) -> Self {
        let masses: Vec<f64> = grid.weighted(grid.inertia()).collect();
        Self {
            inertia: gram(&fields.displacement, grid.weighted(grid.inertia())),
            elastic: gram(&fields.strain, grid.weighted(grid.elastic())),
            centrifugal: gram(&fields.rotation, grid.weighted(grid.centrifugal())),
            first_moment: fields.displacement.as_slice().chunks_exact(grid.len()).map(|u| dot(&masses, u)).collect(),
            root_rotation: fields.root_rotation.clone(),
        }
    }
}

/// The matrices of a system of one degree of freedom; `rigid` says that the first function is the rigid motion
/// (φ = sx or θ = s), whose strain energy is exactly 0.
pub fn assemble(grid: &Grid, energies: Energies, rigid: bool) -> SystemMatrices {
    let Energies { inertia: mass, elastic: mut stiffness, mut centrifugal, first_moment, root_rotation } = energies;
    if grid.system().shift(1.0) > 0.0 {
        // The in-plane term, −m v v: the whole inertia.
        centrifugal -= &mass;
        if rigid {
            // φ₁ = s x: the tension's work is ∫ T s φ_j′ dr = s ∫ m r φ_j dr (by parts), the mass's
            // s ∫ m x φ_j dr; the difference is exactly the offset times s ∫ m φ_j dr. Written so
            // nothing cancels, and a central hinge is exactly free at every speed.
            let factor = grid.root() * root_rotation.first().copied().unwrap_or(0.0);
            for (j, moment) in first_moment.iter().enumerate() {
                let row = factor * moment;
                (centrifugal[(j, 0)], centrifugal[(0, j)]) = (row, row);
            }
        }
    }
    if let RootCondition::Spring(spring) = grid.condition() {
        for (j, b) in root_rotation.iter().enumerate() {
            for (i, a) in root_rotation.iter().enumerate() {
                stiffness[(i, j)] += spring * a * b;
            }
        }
    }
    let rigid = if rigid && grid.condition() == RootCondition::Free { vec![0] } else { Vec::new() };
    SystemMatrices { dofs: grid.system().dofs, mass, stiffness, centrifugal, rigid }
}
