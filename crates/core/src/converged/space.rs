//! The part of all piecewise functions in which the lowest modes lie, grown by inverse iteration.

use super::elements::Elements;
use crate::blade::RootCondition;
use crate::lagrange::{Energies, dot};
use crate::numerics::chain::Chain;
use crate::numerics::eigen::{Eigen, EigenError, lowest};
use crate::numerics::scalar::sqrt;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// A vector that keeps less than this of its length beside those there are says nothing new.
const NOTHING_NEW: f64 = 1e-8;
/// A vector that keeps less than this of its length is made orthogonal once more.
const ONCE_MORE: f64 = 1e-2;

/// A subspace: where the root turns the rigid motion first, then clamped functions, orthonormal in
/// the clamped potential energy at the first anchor; with their energies.
pub(super) struct Space<'a> {
    elements: &'a Elements,
    /// Ω² of the first anchor.
    anchor: f64,
    /// 1 where the first function is the rigid motion, else 0.
    rigid: usize,
    functions: Vec<Function>,
    /// Rows of the lower triangles: strain, pull per Ω², inertia.
    strain: Vec<Vec<f64>>,
    pull: Vec<Vec<f64>>,
    inertia: Vec<Vec<f64>>,
    /// Orthonormal in the inertia: what is iterated.
    members: Vec<Motion>,
    /// Quadrature weights times inertia.
    masses: Vec<f64>,
}

/// One function of the space.
struct Function {
    /// Strain coefficients; none but 0 in the rigid motion.
    coefficients: Vec<f64>,
    motion: Motion,
    /// Derivatives of the strain energy and, per Ω², of the pull energy by the coefficients.
    strain: Vec<f64>,
    pull: Vec<f64>,
    /// The same of the potential energy at the first anchor.
    potential: Vec<f64>,
}

/// A motion at the points of the grid, and that times inertia and weight.
struct Motion {
    values: Vec<f64>,
    weighted: Vec<f64>,
}

impl<'a> Space<'a> {
    pub(super) fn new(elements: &'a Elements, anchor: f64) -> Self {
        let grid = elements.grid();
        let mut space = Self {
            elements,
            anchor,
            rigid: usize::from(elements.root_turns()),
            functions: Vec::new(),
            strain: Vec::new(),
            pull: Vec::new(),
            inertia: Vec::new(),
            members: Vec::new(),
            masses: grid.weighted(grid.inertia()).collect(),
        };
        if elements.root_turns() {
            let motion = Motion::new(grid.rigid_motion(), &space.masses);
            let (pull, own) = elements.pull_on_turn();
            space.strain.push(vec![0.0]);
            space.pull.push(vec![own]);
            space.inertia.push(vec![dot(&motion.weighted, &motion.values)]);
            let none = vec![0.0; pull.len()];
            let (strain, potential) = (none.clone(), none.clone());
            space.functions.push(Function { coefficients: none, motion, strain, pull, potential });
        }
        space
    }

    /// Number of functions.
    pub(super) fn len(&self) -> usize {
        self.functions.len()
    }

    /// Number of vectors that can be iterated.
    pub(super) fn members(&self) -> usize {
        self.members.len()
    }

    /// Adds the static shape of a turned root, to be iterated.
    pub(super) fn push_turned_root(&mut self, chain: &Chain, speed_squared: f64) {
        if let Some(rigid) = self.functions.first().filter(|_| self.rigid == 1) {
            let response = self.elements.response_to_turn(chain, speed_squared);
            let mut motion = self.elements.motion(&response);
            subtract(&mut motion, -1.0, &rigid.motion.values);
            self.push_member(motion, response);
        }
    }

    /// Adds the response to the inertia of a motion, to be iterated.
    pub(super) fn push_start(&mut self, chain: &Chain, motion: &[f64]) {
        let response = self.elements.response_to_inertia(chain, motion);
        self.push_member(self.elements.motion(&response), response);
    }

    /// Adds the response to the inertia of a member, to be iterated.
    pub(super) fn push_next(&mut self, chain: &Chain, member: usize) {
        let response = self.elements.response_to_inertia(chain, &self.members[member].values);
        self.push_member(self.elements.motion(&response), response);
    }

    /// Adds the response to the inertia of a motion; returns the share of it that was new.
    pub(super) fn push_response(&mut self, chain: &Chain, motion: &[f64]) -> f64 {
        let response = self.elements.response_to_inertia(chain, motion);
        self.push(response)
    }

    /// Adds a motion to be iterated, less what the members have of it, and its clamped part; neither
    /// where it is nothing new.
    fn push_member(&mut self, mut motion: Vec<f64>, coefficients: Vec<f64>) {
        let length = |motion: &[f64]| sqrt(self.masses.iter().zip(motion).map(|(m, u)| m * u * u).sum());
        let before = length(&motion);
        for known in &self.members {
            let along = dot(&known.weighted, &motion);
            subtract(&mut motion, along, &known.values);
        }
        let after = length(&motion);
        if after > NOTHING_NEW * before && after.is_finite() {
            scale(&mut motion, 1.0 / after);
            self.members.push(Motion::new(motion, &self.masses));
            self.push(coefficients);
        }
    }

    /// Adds a clamped function, less what the others have of it; returns the share that was new, 0
    /// where it was too little to add.
    fn push(&mut self, mut coefficients: Vec<f64>) -> f64 {
        let mut share = 1.0;
        loop {
            let mut taken = 0.0;
            for known in &self.functions[self.rigid..] {
                let along = dot(&known.potential, &coefficients);
                subtract(&mut coefficients, along, &known.coefficients);
                taken += along * along;
            }
            let strain = self.elements.strain_gradient(&coefficients);
            let pull = self.elements.pull_gradient(&coefficients);
            let left = dot(&strain, &coefficients) + self.anchor * dot(&pull, &coefficients);
            let kept = sqrt(left / (left + taken));
            share *= kept;
            if !(kept > NOTHING_NEW && left.is_finite()) || share <= NOTHING_NEW {
                return 0.0;
            }
            if kept > ONCE_MORE {
                self.add(coefficients, strain, pull, 1.0 / sqrt(left));
                return share;
            }
        }
    }

    /// Adds a clamped function times a factor.
    fn add(&mut self, mut coefficients: Vec<f64>, mut strain: Vec<f64>, mut pull: Vec<f64>, factor: f64) {
        for list in [&mut coefficients, &mut strain, &mut pull] {
            scale(list, factor);
        }
        let potential = strain.iter().zip(&pull).map(|(strain, pull)| strain + self.anchor * pull).collect();
        let motion = Motion::new(self.elements.motion(&coefficients), &self.masses);
        self.functions.push(Function { coefficients, motion, strain, pull, potential });
        let Some(new) = self.functions.last() else { return };
        let row = |of: &dyn Fn(&Function) -> f64| self.functions.iter().map(of).collect();
        self.strain.push(row(&|f| dot(&f.strain, &new.coefficients)));
        self.pull.push(row(&|f| dot(&f.pull, &new.coefficients)));
        self.inertia.push(row(&|f| dot(&f.motion.weighted, &new.motion.values)));
    }

    /// The `count` lowest modes within the space; in lag those of the flap-type problem.
    pub(super) fn ritz(&self, speed_squared: f64, count: usize) -> Result<Eigen, EigenError> {
        let mut g = symmetric(&self.strain) + symmetric(&self.pull) * speed_squared;
        let m = symmetric(&self.inertia);
        if let RootCondition::Spring(spring) = self.elements.grid().condition() {
            g[(0, 0)] += spring;
        }
        lowest(&g, &m, count)
    }

    /// The motion of a sum of the functions at the points of the grid.
    pub(super) fn motion(&self, coordinates: &[f64]) -> Vec<f64> {
        let mut motion = vec![0.0; self.elements.grid().len()];
        for (function, factor) in self.functions.iter().zip(coordinates) {
            subtract(&mut motion, -factor, &function.motion.values);
        }
        motion
    }

    /// Energies of all functions.
    pub(super) fn energies(&self) -> Energies {
        let mut root_turn = vec![0.0; self.len()];
        root_turn[..self.rigid].fill(1.0);
        Energies {
            inertia: symmetric(&self.inertia),
            strain: symmetric(&self.strain),
            pull: symmetric(&self.pull),
            first_moment: self.functions.iter().map(|f| f.motion.weighted.iter().sum()).collect(),
            root_turn,
        }
    }

    /// Strain coefficients of sums of the clamped functions, one column of `coordinates` per sum.
    pub(super) fn coefficients(&self, coordinates: &DMatrix<f64>) -> DMatrix<f64> {
        let elastic = &self.functions[self.rigid..];
        let columns: Vec<f64> = elastic.iter().flat_map(|f| f.coefficients.iter().copied()).collect();
        DMatrix::from_vec(self.elements.mesh.count(), elastic.len(), columns) * coordinates
    }
}

impl Motion {
    fn new(values: Vec<f64>, masses: &[f64]) -> Self {
        let weighted = masses.iter().zip(&values).map(|(m, u)| m * u).collect();
        Self { values, weighted }
    }
}

/// The matrix whose lower triangle has these rows.
fn symmetric(rows: &[Vec<f64>]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), rows.len(), |i, j| rows[i.max(j)][i.min(j)])
}

fn scale(values: &mut [f64], factor: f64) {
    for value in values {
        *value *= factor;
    }
}

fn subtract(from: &mut [f64], factor: f64, values: &[f64]) {
    from.iter_mut().zip(values).for_each(|(out, value)| *out -= factor * value);
}
