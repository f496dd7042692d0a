//! The part of all piecewise functions in which the lowest modes lie, grown by inverse iteration.

use super::elements::{Elements, Vector};
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
    rigid: Option<Vec<f64>>,
    functions: Vec<Vector>,
    /// Fields times their weights, of every function.
    weighted: Vec<Vector>,
    /// Rows of the lower triangles: strain, pull per Ω², inertia.
    strain: Vec<Vec<f64>>,
    pull: Vec<Vec<f64>>,
    inertia: Vec<Vec<f64>>,
    /// Orthonormal in the inertia: what is iterated.
    members: Vec<Member>,
    /// Quadrature weights times inertia, stiffness and pull.
    masses: Vec<f64>,
    rigidities: Vec<f64>,
    pulls: Vec<f64>,
}

/// A vector of the iteration with its rigid part.
struct Member {
    turn: f64,
    coefficients: Vec<f64>,
    motion: Vec<f64>,
    /// Motion times inertia and weight.
    weighted: Vec<f64>,
}

impl<'a> Space<'a> {
    pub(super) fn new(elements: &'a Elements, anchor: f64) -> Self {
        let grid = &elements.grid;
        let mut space = Self {
            elements,
            anchor,
            rigid: elements.root_turns().then(|| elements.grid.rigid_motion()),
            functions: Vec::new(),
            weighted: Vec::new(),
            strain: Vec::new(),
            pull: Vec::new(),
            inertia: Vec::new(),
            members: Vec::new(),
            masses: grid.weighted(grid.inertia()).collect(),
            rigidities: grid.weighted(grid.stiffness()).collect(),
            pulls: grid.weighted(grid.pull()).collect(),
        };
        if let Some(rigid) = &space.rigid {
            let points = grid.len();
            let vector = Vector {
                coefficients: vec![0.0; elements.mesh.count()],
                motion: rigid.clone(),
                turn: vec![1.0; points],
                strain: vec![0.0; points],
            };
            space.add(vector);
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
        if self.elements.root_turns() {
            let response = self.elements.response_to_turn(chain, speed_squared);
            self.push_member(1.0, response);
        }
    }

    /// Adds the response to the inertia of a motion, to be iterated.
    pub(super) fn push_start(&mut self, chain: &Chain, motion: impl Fn(usize) -> f64) -> bool {
        let response = self.elements.response_to_inertia(chain, motion);
        self.push_member(0.0, response)
    }

    /// Adds the response to the inertia of a member, to be iterated; false where it is nothing new.
    pub(super) fn push_next(&mut self, chain: &Chain, member: usize) -> bool {
        let response = self.elements.response_to_inertia(chain, |k| self.members[member].motion[k]);
        self.push_member(0.0, response)
    }

    /// Adds the response to the inertia of a motion; returns the share of it that was new.
    pub(super) fn push_response(&mut self, chain: &Chain, motion: &[f64]) -> f64 {
        let response = self.elements.response_to_inertia(chain, |k| motion[k]);
        self.push(response)
    }

    /// Adds a vector to be iterated, less what the members have of it, and its clamped part.
    fn push_member(&mut self, turn: f64, vector: Vector) -> bool {
        let mut member =
            Member { turn, coefficients: vector.coefficients, motion: vector.motion, weighted: Vec::new() };
        if let Some(rigid) = self.rigid.as_ref().filter(|_| turn != 0.0) {
            subtract(&mut member.motion, -turn, rigid);
        }
        let square = |motion: &[f64]| -> f64 { self.masses.iter().zip(motion).map(|(m, u)| m * u * u).sum() };
        let before = sqrt(square(&member.motion));
        for known in &self.members {
            let along = dot(&known.weighted, &member.motion);
            subtract(&mut member.motion, along, &known.motion);
            subtract(&mut member.coefficients, along, &known.coefficients);
            member.turn -= along * known.turn;
        }
        let after = sqrt(square(&member.motion));
        if !(after > NOTHING_NEW * before && after.is_finite()) {
            return false;
        }
        let scale = 1.0 / after;
        for list in [&mut member.motion, &mut member.coefficients] {
            scaled(list, scale);
        }
        member.turn *= scale;
        member.weighted = self.masses.iter().zip(&member.motion).map(|(m, u)| m * u).collect();
        let vector = self.elements.vector(member.coefficients.clone());
        self.members.push(member);
        self.push(vector);
        true
    }

    /// Adds a clamped function, less what the others have of it; returns the share that was new, 0
    /// where it was too little to add.
    fn push(&mut self, mut vector: Vector) -> f64 {
        let first = usize::from(self.rigid.is_some());
        let given = self.length(&vector);
        let mut before = given;
        for pass in 0..2 {
            for (known, weighted) in self.functions.iter().zip(&self.weighted).skip(first) {
                let along = dot(&weighted.strain, &vector.strain) + self.anchor * dot(&weighted.turn, &vector.turn);
                subtract(&mut vector.coefficients, along, &known.coefficients);
                subtract(&mut vector.strain, along, &known.strain);
                subtract(&mut vector.turn, along, &known.turn);
                subtract(&mut vector.motion, along, &known.motion);
            }
            let after = self.length(&vector);
            if after <= ONCE_MORE * before {
                // So much has cancelled that the fields are no longer those of the coefficients.
                vector = self.elements.vector(vector.coefficients);
            }
            if !(after > NOTHING_NEW * before && after.is_finite()) {
                return 0.0;
            }
            if after > ONCE_MORE * before || pass == 1 {
                before = after;
                break;
            }
        }
        let scale = 1.0 / before;
        for list in [&mut vector.coefficients, &mut vector.motion, &mut vector.turn, &mut vector.strain] {
            scaled(list, scale);
        }
        self.add(vector);
        before / given
    }

    /// The length in the clamped potential energy at the first anchor.
    fn length(&self, vector: &Vector) -> f64 {
        let square =
            |weights: &[f64], values: &[f64]| -> f64 { weights.iter().zip(values).map(|(w, v)| w * v * v).sum() };
        sqrt(square(&self.rigidities, &vector.strain) + self.anchor * square(&self.pulls, &vector.turn))
    }

    fn add(&mut self, vector: Vector) {
        let times =
            |weights: &[f64], values: &[f64]| -> Vec<f64> { weights.iter().zip(values).map(|(w, v)| w * v).collect() };
        let weighted = Vector {
            coefficients: Vec::new(),
            motion: times(&self.masses, &vector.motion),
            turn: times(&self.pulls, &vector.turn),
            strain: times(&self.rigidities, &vector.strain),
        };
        self.functions.push(vector);
        self.strain.push(self.functions.iter().map(|f| dot(&weighted.strain, &f.strain)).collect());
        self.pull.push(self.functions.iter().map(|f| dot(&weighted.turn, &f.turn)).collect());
        self.inertia.push(self.functions.iter().map(|f| dot(&weighted.motion, &f.motion)).collect());
        self.weighted.push(weighted);
    }

    /// The `count` lowest modes within the space; in lag those of the flap-type problem.
    pub(super) fn ritz(&self, speed_squared: f64, count: usize) -> Result<Eigen, EigenError> {
        let mut g = symmetric(&self.strain) + symmetric(&self.pull) * speed_squared;
        let m = symmetric(&self.inertia);
        if let RootCondition::Spring(spring) = self.elements.grid.condition() {
            g[(0, 0)] += spring;
        }
        lowest(&g, &m, count)
    }

    /// The motion of a sum of the functions at the points of the grid.
    pub(super) fn motion(&self, coordinates: &[f64]) -> Vec<f64> {
        let mut motion = vec![0.0; self.elements.grid.len()];
        for (function, factor) in self.functions.iter().zip(coordinates) {
            subtract(&mut motion, -factor, &function.motion);
        }
        motion
    }

    /// Energies of all functions.
    pub(super) fn energies(&self) -> Energies {
        let mut root_turn = vec![0.0; self.len()];
        if self.rigid.is_some() {
            root_turn[0] = 1.0;
        }
        Energies {
            inertia: symmetric(&self.inertia),
            strain: symmetric(&self.strain),
            pull: symmetric(&self.pull),
            first_moment: self.weighted.iter().map(|f| f.motion.iter().sum()).collect(),
            root_turn,
        }
    }

    /// Strain coefficients of sums of the clamped functions, one column of `coordinates` per sum.
    pub(super) fn coefficients(&self, coordinates: &DMatrix<f64>) -> DMatrix<f64> {
        let elastic = &self.functions[usize::from(self.rigid.is_some())..];
        let columns: Vec<f64> = elastic.iter().flat_map(|f| f.coefficients.iter().copied()).collect();
        DMatrix::from_vec(self.elements.mesh.count(), elastic.len(), columns) * coordinates
    }
}

/// The matrix whose lower triangle has these rows.
fn symmetric(rows: &[Vec<f64>]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), rows.len(), |i, j| rows[i.max(j)][i.min(j)])
}

fn scaled(values: &mut [f64], factor: f64) {
    for value in values {
        *value *= factor;
    }
}

fn subtract(from: &mut [f64], factor: f64, values: &[f64]) {
    from.iter_mut().zip(values).for_each(|(out, value)| *out -= factor * value);
}
