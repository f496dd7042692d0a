//! The part of all piecewise functions in which the lowest modes lie, grown by inverse iteration.

use super::Wanted;
use super::elements::{Elements, Factor};
use super::work::{Effort, Work};
use crate::blade::RootCondition;
use crate::functions::Deformation;
use crate::lagrange::Energies;
use crate::numerics::eigen::{Eigen, EigenError, lowest};
use crate::numerics::scalar::sqrt;
use crate::numerics::vector::{axpy, dot, scale};
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// A vector that keeps less than this of its length beside those there are says nothing new.
const NOTHING_NEW: f64 = 1e-8;
/// Most numbers that the functions are made of: 64 MB.
const MOST_NUMBERS: usize = 8_000_000;
/// A vector that keeps less than this of its length is made orthogonal once more.
const ONCE_MORE: f64 = 1e-2;

/// A subspace: where the root turns the rigid motion first, then clamped functions, orthonormal in
/// the clamped potential energy at the first anchor; with their energies.
pub(super) struct Subspace<'a> {
    elements: &'a Elements,
    /// Ω² of the first anchor.
    anchor: f64,
    /// 1 where the first function is the rigid motion, else 0.
    rigid: usize,
    functions: Vec<Function>,
    /// Rows of the lower triangles: elastic, centrifugal per Ω², inertia.
    elastic: Vec<Vec<f64>>,
    centrifugal: Vec<Vec<f64>>,
    inertia: Vec<Vec<f64>>,
    /// Orthonormal in the inertia: what is iterated.
    members: Vec<Displacement>,
    /// Quadrature weights times inertia.
    masses: Vec<f64>,
    work: &'a Work,
    /// Anchors and functions there may be in the end.
    most: (usize, usize),
}

/// One function of the subspace.
struct Function {
    /// Strain coefficients; none but 0 in the rigid motion.
    coefficients: Vec<f64>,
    displacement: Displacement,
    /// Derivatives of the strain energy and, per Ω², of the centrifugal energy by the coefficients.
    elastic: Vec<f64>,
    centrifugal: Vec<f64>,
    /// The same of the potential energy at the first anchor.
    potential: Vec<f64>,
}

/// A displacement at the points of the grid, and that times inertia and weight.
struct Displacement {
    values: Vec<f64>,
    weighted: Vec<f64>,
}

impl<'a> Subspace<'a> {
    pub(super) fn new(elements: &'a Elements, anchor: f64, wanted: &Wanted, work: &'a Work) -> Self {
        let grid = elements.grid();
        let mut subspace = Self {
            elements,
            anchor,
            rigid: usize::from(elements.root_rotates()),
            functions: Vec::new(),
            elastic: Vec::new(),
            centrifugal: Vec::new(),
            inertia: Vec::new(),
            members: Vec::new(),
            masses: grid.weighted(grid.inertia()).collect(),
            work,
            most: wanted.most(),
        };
        if elements.root_rotates() {
            let displacement = Displacement::new(grid.rigid_displacement(), &subspace.masses);
            let (centrifugal, own) = elements.centrifugal_on_rigid();
            subspace.elastic.push(vec![0.0]);
            subspace.centrifugal.push(vec![own]);
            subspace.inertia.push(vec![dot(&displacement.weighted, &displacement.values)]);
            let none = vec![0.0; centrifugal.len()];
            let (elastic, potential) = (none.clone(), none.clone());
            subspace.functions.push(Function { coefficients: none, displacement, elastic, centrifugal, potential });
        }
        subspace
    }

    /// Number of functions.
    pub(super) fn len(&self) -> usize {
        self.functions.len()
    }

    /// Whether there was work enough, or the functions fill the memory that they may.
    pub(super) fn is_exhausted(&self) -> bool {
        let numbers = 4 * self.elements.mesh.count() + 2 * self.elements.grid().len();
        self.work.left() < self.ending() || self.len() * numbers > MOST_NUMBERS
    }

    /// What it takes to come to an end with the functions there are.
    fn ending(&self) -> f64 {
        let (anchors, most) = self.most;
        let few = most.min(self.len());
        let effort = self.elements.effort();
        let check = Effort::modes(few) + effort.moments(few, most / anchors);
        anchors as f64 * (Effort::modes(self.len()) + check) + effort.reduction(self.len(), few)
    }

    /// The first vectors: the static shape of a rotated root, the response to the inertia of a motion
    /// one degree above the rigid one, so that no symmetry hides a mode from it, and the responses to
    /// those, until there are so many (Wilson, Yuan & Dickens 1982).
    pub(super) fn start(&mut self, factor: &Factor, speed_squared: f64, members: usize) {
        self.push_rotated_root(factor, speed_squared);
        let deformation = self.elements.grid().deformation();
        let above = |x: f64| if deformation == Deformation::Torsion { x } else { x * x };
        let start: Vec<f64> = self.elements.grid().x().map(above).collect();
        self.push_start(factor, &start);
        let mut next = 0;
        while self.members.len() < members && next < self.members.len() && !self.is_exhausted() {
            self.push_next(factor, next);
            next += 1;
        }
    }

    /// Adds the responses to the inertia of single elements, so many of them at even distances: what
    /// lives between two heavy blocks does not show in the response to a load on the whole blade.
    pub(super) fn push_loads(&mut self, factor: &Factor, elements: usize) {
        let panels = self.elements.grid().panels();
        let step = panels.len().div_ceil(elements).max(1);
        for panel in panels.iter().step_by(step) {
            if self.is_exhausted() {
                break;
            }
            let mut displacement = vec![0.0; self.elements.grid().len()];
            displacement[panel.points.clone()].fill(1.0);
            panel.lump.into_iter().for_each(|lump| displacement[lump] = 1.0);
            let response = self.elements.response_to_inertia(factor, &displacement);
            self.push(response);
        }
    }

    /// Adds the static shape of a rotated root, to be iterated.
    fn push_rotated_root(&mut self, factor: &Factor, speed_squared: f64) {
        if let Some(rigid) = self.functions.first().filter(|_| self.rigid == 1) {
            let response = self.elements.response_to_root_rotation(factor, speed_squared);
            let mut displacement = self.elements.displacement(&response);
            axpy(&mut displacement, 1.0, &rigid.displacement.values);
            self.push_member(displacement, response);
        }
    }

    /// Adds the response to the inertia of a displacement, to be iterated.
    fn push_start(&mut self, factor: &Factor, displacement: &[f64]) {
        let response = self.elements.response_to_inertia(factor, displacement);
        self.push_member(self.elements.displacement(&response), response);
    }

    /// Adds the response to the inertia of a member, to be iterated.
    fn push_next(&mut self, factor: &Factor, member: usize) {
        let response = self.elements.response_to_inertia(factor, &self.members[member].values);
        self.push_member(self.elements.displacement(&response), response);
    }

    /// Adds the response to the inertia of a displacement; returns the share of it that was new.
    pub(super) fn push_response(&mut self, factor: &Factor, displacement: &[f64]) -> f64 {
        let response = self.elements.response_to_inertia(factor, displacement);
        self.push(response)
    }

    /// Adds a displacement to be iterated, less what the members have of it, and its clamped part; neither
    /// where it is nothing new.
    fn push_member(&mut self, mut displacement: Vec<f64>, coefficients: Vec<f64>) {
        let length = |displacement: &[f64]| sqrt(self.masses.iter().zip(displacement).map(|(m, u)| m * u * u).sum());
        let before = length(&displacement);
        for known in &self.members {
            let along = dot(&known.weighted, &displacement);
            axpy(&mut displacement, -along, &known.values);
        }
        let after = length(&displacement);
        if after > NOTHING_NEW * before && after.is_finite() {
            scale(&mut displacement, 1.0 / after);
            self.members.push(Displacement::new(displacement, &self.masses));
            self.push(coefficients);
        }
    }

    /// Adds a clamped function, less what the others have of it; returns the share that was new, 0
    /// where it was too little to add.
    pub(super) fn push(&mut self, mut coefficients: Vec<f64>) -> f64 {
        let mut share = 1.0;
        loop {
            self.work.spend(self.elements.effort().function(self.len()));
            let mut taken = 0.0;
            for known in &self.functions[self.rigid..] {
                let along = dot(&known.potential, &coefficients);
                axpy(&mut coefficients, -along, &known.coefficients);
                taken += along * along;
            }
            let elastic = self.elements.elastic_gradient(&coefficients);
            let centrifugal = self.elements.centrifugal_gradient(&coefficients);
            let left = dot(&elastic, &coefficients) + self.anchor * dot(&centrifugal, &coefficients);
            let kept = sqrt(left / (left + taken));
            share *= kept;
            if !(kept > NOTHING_NEW && left.is_finite()) || share <= NOTHING_NEW {
                return 0.0;
            }
            if kept > ONCE_MORE {
                self.add(coefficients, elastic, centrifugal, 1.0 / sqrt(left));
                return share;
            }
        }
    }

    /// Adds a clamped function times a factor.
    fn add(&mut self, mut coefficients: Vec<f64>, mut elastic: Vec<f64>, mut centrifugal: Vec<f64>, factor: f64) {
        for list in [&mut coefficients, &mut elastic, &mut centrifugal] {
            scale(list, factor);
        }
        let potential = elastic.iter().zip(&centrifugal).map(|(k, c)| k + self.anchor * c).collect();
        let displacement = Displacement::new(self.elements.displacement(&coefficients), &self.masses);
        self.functions.push(Function { coefficients, displacement, elastic, centrifugal, potential });
        let Some(new) = self.functions.last() else { return };
        let row = |of: &dyn Fn(&Function) -> f64| self.functions.iter().map(of).collect();
        self.elastic.push(row(&|f| dot(&f.elastic, &new.coefficients)));
        self.centrifugal.push(row(&|f| dot(&f.centrifugal, &new.coefficients)));
        self.inertia.push(row(&|f| dot(&f.displacement.weighted, &new.displacement.values)));
    }

    /// The `count` lowest modes within the subspace; in lag those of the flap-type problem.
    pub(super) fn ritz(&self, speed_squared: f64, count: usize) -> Result<Eigen, EigenError> {
        let mut g = symmetric(&self.elastic) + symmetric(&self.centrifugal) * speed_squared;
        let m = symmetric(&self.inertia);
        if let RootCondition::Spring(spring) = self.elements.grid().condition() {
            g[(0, 0)] += spring;
        }
        self.work.spend(Effort::modes(self.len()));
        lowest(&g, &m, count)
    }

    /// The clamped strain coefficients of the `count` lowest modes within the subspace.
    pub(super) fn modes(&self, speed_squared: f64, count: usize) -> Result<Vec<Vec<f64>>, EigenError> {
        let vectors = self.ritz(speed_squared, count)?.vectors;
        let clamped = vectors.rows(self.rigid, self.len() - self.rigid).into_owned();
        Ok(self.coefficients(&clamped).column_iter().map(|column| column.iter().copied().collect()).collect())
    }

    /// The displacement of a sum of the functions at the points of the grid.
    pub(super) fn displacement(&self, coordinates: &[f64]) -> Vec<f64> {
        let mut displacement = vec![0.0; self.elements.grid().len()];
        for (function, factor) in self.functions.iter().zip(coordinates) {
            axpy(&mut displacement, *factor, &function.displacement.values);
        }
        displacement
    }

    /// Energies of all functions.
    pub(super) fn energies(&self) -> Energies {
        let mut root_rotation = vec![0.0; self.len()];
        root_rotation[..self.rigid].fill(1.0);
        Energies {
            inertia: symmetric(&self.inertia),
            elastic: symmetric(&self.elastic),
            centrifugal: symmetric(&self.centrifugal),
            first_moment: self.functions.iter().map(|f| f.displacement.weighted.iter().sum()).collect(),
            root_rotation,
        }
    }

    /// Strain coefficients of sums of the clamped functions, one column of `coordinates` per sum.
    pub(super) fn coefficients(&self, coordinates: &DMatrix<f64>) -> DMatrix<f64> {
        let elastic = &self.functions[self.rigid..];
        let columns: Vec<f64> = elastic.iter().flat_map(|f| f.coefficients.iter().copied()).collect();
        DMatrix::from_vec(self.elements.mesh.count(), elastic.len(), columns) * coordinates
    }
}

impl Displacement {
    fn new(values: Vec<f64>, masses: &[f64]) -> Self {
        let weighted = masses.iter().zip(&values).map(|(m, u)| m * u).collect();
        Self { values, weighted }
    }
}

/// The matrix whose lower triangle has these rows.
fn symmetric(rows: &[Vec<f64>]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), rows.len(), |i, j| rows[i.max(j)][i.min(j)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::converged::layout::first_layout;
    use crate::converged::tests::{converged, stepped};
    use crate::dof::Dof;
    use crate::numerics::quadrature::GaussRules;

    fn elements(dof: Dof) -> Elements {
        let blade = stepped();
        Elements::new(&blade, dof, &first_layout(&blade, dof, 1e4, 4), &GaussRules::new())
    }

    /// Orthonormal in the clamped potential energy, with the dense products as the judge. A vector that
    /// keeps a hundredth of its length keeps two digits fewer.
    #[test]
    fn functions_are_orthonormal_in_the_potential_energy() {
        for dof in Dof::ALL {
            let elements = elements(dof);
            let factor = elements.factor(1e4).unwrap();
            let work = Work::of(f64::INFINITY);
            let mut subspace = Subspace::new(&elements, 1e4, &Wanted::at(1e4, 4), &work);
            subspace.start(&factor, 1e4, 8);
            subspace.push_loads(&factor, 5);
            assert!(subspace.len() >= 10, "{dof}: {}", subspace.len());
            let functions = &subspace.functions[subspace.rigid..];
            for (i, a) in functions.iter().enumerate() {
                let (elastic, pull) =
                    (elements.elastic_gradient(&a.coefficients), elements.centrifugal_gradient(&a.coefficients));
                for (j, b) in functions.iter().enumerate() {
                    let product = dot(&elastic, &b.coefficients) + 1e4 * dot(&pull, &b.coefficients);
                    let known = if i == j { 1.0 } else { 0.0 };
                    assert!((product - known).abs() < 1e-11, "{dof}: {i} {j}: {product:e}");
                }
            }
        }
    }

    #[test]
    fn work_grows_and_ends() {
        let elements = elements(Dof::Flap);
        let factor = elements.factor(1e4).unwrap();
        let (work, wanted) = (Work::of(1e6), Wanted::at(1e4, 4));
        let mut subspace = Subspace::new(&elements, 1e4, &wanted, &work);
        let mut before = work.left();
        assert!(!subspace.is_exhausted());
        subspace.start(&factor, 1e4, 4);
        assert!(work.left() < before);
        before = work.left();
        subspace.ritz(1e4, 2).unwrap();
        assert!(work.left() < before);
        let mut rounds = 0;
        while !subspace.is_exhausted() {
            subspace.ritz(1e4, 2).unwrap();
            rounds += 1;
            assert!(rounds < 10_000, "work has an end");
        }
        assert!(work.left() > 0.0, "enough is left to end with");
        // With nothing to spend the first vectors are all there are.
        let none = Work::of(0.0);
        let mut poor = Subspace::new(&elements, 1e4, &wanted, &none);
        poor.start(&factor, 1e4, 50);
        assert!(poor.len() <= 2, "{}", poor.len());
    }

    /// Ritz values lie above the eigenvalues and fall as the space grows (Courant); what was found to
    /// 1e-10 is the reference, in lag without the shift.
    #[test]
    fn ritz_values_fall_to_the_eigenvalues() {
        let blade = stepped();
        for dof in Dof::ALL {
            let elements = elements(dof);
            let factor = elements.factor(1e4).unwrap();
            let work = Work::of(f64::INFINITY);
            let mut subspace = Subspace::new(&elements, 1e4, &Wanted::at(1e4, 4), &work);
            let shift = elements.grid().system().shift(1e4);
            let found = converged(&blade, dof, 1e4, 2);
            let exact: Vec<f64> = crate::modes::solve(found.matrices(), 1e4, 2)
                .unwrap()
                .iter()
                .map(|mode| mode.eigenvalue + shift)
                .collect();
            let mut last = vec![f64::INFINITY; 2];
            for members in [3, 5, 9] {
                subspace.start(&factor, 1e4, members);
                let values = subspace.ritz(1e4, 2).unwrap().values;
                for ((value, last), exact) in values.iter().zip(&last).zip(&exact) {
                    assert!(*value <= last * (1.0 + 1e-12) && *value > exact * (1.0 - 1e-9), "{dof}: {value} {exact}");
                }
                last = values;
            }
            // Nine vectors of inverse iteration hold two modes to the square of a thousandth.
            assert!((last[0] / exact[0] - 1.0).abs() < 1e-6, "{dof}: {last:?} {exact:?}");
        }
    }

    #[test]
    fn rows_of_a_lower_triangle_are_mirrored() {
        let found = symmetric(&[vec![1.0], vec![2.0, 3.0]]);
        assert_eq!(found, DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 2.0, 3.0]));
    }
}
