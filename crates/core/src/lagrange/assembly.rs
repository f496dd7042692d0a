//! Mass, elastic, spring and centrifugal matrices (paper Eq. 42–47, 75–77), once per blade.

use super::fields::{Fields, gram};
use super::grid::Grid;
use crate::blade::RootCondition;
use crate::dof::Dof;
use crate::functions::Deformation;
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
        if rigid && grid.deformation() == Deformation::Bending {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blade::Blade;
    use crate::functions::{Mesh, PiecewiseFunctions};
    use crate::lagrange::tests::{INERTIA, MASS, MASS_OFFSET, RADIUS, STIFFNESS, free, sprung};
    use crate::numerics::quadrature::GaussRules;

    /// The matrices of φ = x and φ = x² in bending, θ = 1 and θ = x in torsion.
    fn two_functions(blade: &Blade, dof: Dof) -> SystemMatrices {
        let length = RADIUS - blade.root(dof).offset;
        let strain = if dof == Dof::Torsion { 1.0 } else { 2.0 };
        let mesh = Mesh::new(vec![0.0, length], vec![1]);
        let coefficients = DMatrix::from_element(1, 1, strain);
        let functions = PiecewiseFunctions::new(mesh, Deformation::of(dof), true, coefficients);
        let grid = Grid::for_functions(blade, dof, &functions, &GaussRules::new(), 0, &[]);
        let fields = Fields::sample(&grid, &functions);
        assemble(&grid, Energies::new(&grid, &fields), true)
    }

    /// A handful of roundings of each sum over a handful of points.
    fn assert_near(found: &DMatrix<f64>, known: [f64; 3]) {
        let known = DMatrix::from_row_slice(2, 2, &[known[0], known[1], known[1], known[2]]);
        assert!((found - &known).amax() < 1e-14 * (1.0 + known.amax()), "{found} {known}");
    }

    /// ∫ T φ_i′ φ_j′ dr is by parts ∫ m r φ dr with φ′ = φ_i′ φ_j′: of x², and of 4x³/3.
    #[test]
    fn bending_of_a_uniform_blade_has_its_closed_forms() {
        for e in [0.0, 0.5] {
            let l = RADIUS - e;
            let blade = free(e);
            let mass = [l.powi(3) / 3.0, l.powi(4) / 4.0, l.powi(5) / 5.0].map(|x| MASS * x);
            let pull = [
                MASS * (e * l * l / 2.0 + l.powi(3) / 3.0),
                MASS * (e * l.powi(3) / 3.0 + l.powi(4) / 4.0),
                MASS * 4.0 / 3.0 * (e * l.powi(4) / 4.0 + l.powi(5) / 5.0),
            ];
            for dof in [Dof::Flap, Dof::Lag] {
                let found = two_functions(&blade, dof);
                assert_near(found.mass(), mass);
                assert_near(found.stiffness(), [0.0, 0.0, 4.0 * STIFFNESS[dof.index()] * l]);
                assert_eq!(found.stiffness().column(0).amax(), 0.0, "a rigid motion has no strain energy");
                assert_eq!((found.rigid(), found.dofs()), (&[0][..], &[dof][..]));
            }
            assert_near(two_functions(&blade, Dof::Flap).centrifugal(), pull);
            // In lag the offset alone holds the rigid motion back, e ∫ m φ dr; with none nothing does.
            let lag = two_functions(&blade, Dof::Lag);
            let held = [MASS * e * l * l / 2.0, MASS * e * l.powi(3) / 3.0, pull[2] - mass[2]];
            assert_near(lag.centrifugal(), held);
            assert!(e > 0.0 || lag.centrifugal().column(0).amax() == 0.0, "exactly free about the hub");
        }
    }

    #[test]
    fn torsion_of_a_uniform_blade_has_its_closed_forms() {
        let found = two_functions(&free(0.5), Dof::Torsion);
        let l: f64 = 1.5;
        let squares = [l, l * l / 2.0, l.powi(3) / 3.0];
        assert_near(found.mass(), squares.map(|x| INERTIA * x));
        assert_near(found.stiffness(), [0.0, 0.0, STIFFNESS[2] * l]);
        assert_near(found.centrifugal(), squares.map(|x| MASS * MASS_OFFSET * MASS_OFFSET * x));
        assert_eq!(found.rigid(), [0]);
    }

    /// K t tᵀ of the rotations at the root, 1 and 0; and of any two.
    #[test]
    fn a_spring_adds_the_energy_of_the_root_rotation() {
        let (blade, rules) = (sprung(0.5), GaussRules::new());
        for dof in Dof::ALL {
            let added = two_functions(&blade, dof).stiffness() - two_functions(&free(0.5), dof).stiffness();
            assert_eq!(added, DMatrix::from_row_slice(2, 2, &[40.0, 0.0, 0.0, 0.0]), "{dof}");
            assert!(two_functions(&blade, dof).rigid().is_empty(), "{dof}");
            let functions = crate::lagrange::classical_functions(&blade, dof, 2);
            let grid = Grid::for_functions(&blade, dof, functions.as_ref(), &rules, 0, &[]);
            let none = DMatrix::zeros(2, 2);
            let energies = Energies {
                inertia: none.clone(),
                elastic: none.clone(),
                centrifugal: none,
                first_moment: vec![0.0; 2],
                root_rotation: vec![2.0, -3.0],
            };
            let found = assemble(&grid, energies, false);
            assert_eq!(*found.stiffness(), DMatrix::from_row_slice(2, 2, &[160.0, -240.0, -240.0, 360.0]), "{dof}");
        }
    }

    /// (1, 0) and (1, 2): M₁₁, M₁₁ + 2 M₁₂, M₁₁ + 4 M₁₂ + 4 M₂₂.
    #[test]
    fn sums_and_leading_functions_keep_their_matrices() {
        let all = two_functions(&free(0.5), Dof::Flap);
        let sums = all.reduced(&DMatrix::from_row_slice(2, 2, &[1.0, 1.0, 0.0, 2.0]));
        for (of_sums, of_all) in
            [(sums.mass(), all.mass()), (sums.stiffness(), all.stiffness()), (sums.centrifugal(), all.centrifugal())]
        {
            let (a, b, c) = (of_all[(0, 0)], of_all[(0, 1)], of_all[(1, 1)]);
            assert_near(of_sums, [a, a + 2.0 * b, a + 4.0 * b + 4.0 * c]);
            assert_eq!(of_sums[(0, 1)], of_sums[(1, 0)], "symmetric to the bit");
        }
        assert_eq!(sums.rigid(), [0]);
        let first = all.leading(1);
        assert_eq!((first.count(), first.mass()[0], first.rigid()), (1, all.mass()[(0, 0)], &[0][..]));
        assert_eq!(all.leading(9).count(), 2);
        assert!(all.leading(0).rigid().is_empty());
    }
}
