//! The piecewise functions of one blade and degree of freedom: their energies element by element,
//! and the operations of inverse iteration in time proportional to the number of elements.

use super::mesh::Layout;
use crate::blade::{Blade, RootCondition};
use crate::dof::Dof;
use crate::functions::Mesh;
use crate::lagrange::Grid;
use crate::numerics::chain::{Chain, Link};
use crate::numerics::legendre::Tables;
use crate::numerics::quadrature::GaussRules;
use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

/// Points of an element beyond its order b: a motion has degree b + 1, and its square times a linear
/// mass is to be integrated exactly; so is the square of a turn times a cubic tension.
const POINTS_FOR_ENERGIES: usize = 2;
/// The same where modes are checked: the equilibrium moment of a mode has degree b + 4, and its
/// square is to be integrated exactly.
const POINTS_FOR_MOMENTS: usize = 5;

/// Energies of all strain polynomials of a mesh.
#[derive(Clone, Debug)]
pub(super) struct Elements {
    pub(super) mesh: Mesh,
    pub(super) torsion: bool,
    /// For energies.
    coarse: Points,
    /// For moments.
    fine: Points,
    /// Per element, order × order by columns: strain energy, of which the lower triangle is used, and,
    /// per Ω², pull energy.
    stiffness: Vec<f64>,
    pull: Vec<f64>,
    /// Per element: pull energy between its polynomials and a unit turn, and of the turn itself.
    coupling: Vec<f64>,
    own: Vec<f64>,
}

/// The points of a mesh.
#[derive(Clone, Debug)]
struct Points {
    grid: Grid,
    /// What the polynomials are there, by order.
    tables: Vec<Option<Tables>>,
}

/// The fields of a clamped function at the points of the fine grid.
#[derive(Clone, Debug)]
pub(super) struct Vector {
    pub(super) motion: Vec<f64>,
    pub(super) turn: Vec<f64>,
    pub(super) strain: Vec<f64>,
}

impl Elements {
    pub(super) fn new(blade: &Blade, dof: Dof, layout: &Layout, rules: &GaussRules) -> Self {
        let mesh = layout.mesh();
        let points = |more| Points::new(blade, dof, layout, more, rules);
        let mut elements = Self {
            torsion: dof == Dof::Torsion,
            coarse: points(POINTS_FOR_ENERGIES),
            fine: points(POINTS_FOR_MOMENTS),
            stiffness: Vec::new(),
            pull: Vec::new(),
            coupling: Vec::new(),
            own: Vec::new(),
            mesh,
        };
        elements.add_energies();
        elements
    }

    /// The points at which energies are exact.
    pub(super) fn grid(&self) -> &Grid {
        &self.coarse.grid
    }

    /// The points at which the energies of equilibrium moments are exact.
    pub(super) fn fine_grid(&self) -> &Grid {
        &self.fine.grid
    }

    fn add_energies(&mut self) {
        let grid = self.grid();
        let rigidities: Vec<f64> = grid.weighted(grid.stiffness()).collect();
        let pulls: Vec<f64> = grid.weighted(grid.pull()).collect();
        let size: usize = self.mesh.orders().iter().map(|order| order * order).sum();
        let (mut of_strain, mut of_pull) = (Vec::with_capacity(size), Vec::with_capacity(size));
        let mut coupling = Vec::with_capacity(self.mesh.count());
        let mut own = Vec::with_capacity(self.mesh.orders().len());
        for (cell, &order) in grid.cells().iter().zip(self.mesh.orders()) {
            let half = cell.half();
            let (stiffness, pull) = (&rigidities[cell.points.clone()], &pulls[cell.points.clone()]);
            let table = self.coarse.table(order);
            let triple =
                |w: &[f64], a: &[f64], b: &[f64]| -> f64 { w.iter().zip(a).zip(b).map(|((w, a), b)| w * a * b).sum() };
            let start = of_strain.len();
            of_strain.resize(start + order * order, 0.0);
            of_pull.resize(start + order * order, 0.0);
            let (strain, turn) = (&mut of_strain[start..], &mut of_pull[start..]);
            for j in 0..order {
                // A linear stiffness couples neighbours only.
                for i in j..order.min(j + 2) {
                    strain[j * order + i] = triple(stiffness, table.value(i), table.value(j));
                }
                for i in j..order {
                    let value = half * half * triple(pull, table.first(i), table.first(j));
                    (turn[j * order + i], turn[i * order + j]) = (value, value);
                }
            }
            for j in 0..order {
                let sum: f64 = pull.iter().zip(table.first(j)).map(|(w, a)| w * a).sum();
                coupling.push(half * sum);
            }
            own.push(pull.iter().sum());
        }
        (self.stiffness, self.pull, self.coupling, self.own) = (of_strain, of_pull, coupling, own);
    }

    /// The factor of K + Ω² C of the clamped root, in lag without −Ω² M.
    pub(super) fn factor(&self, speed_squared: f64) -> Option<Chain> {
        let matrix: Vec<f64> = self.stiffness.iter().zip(&self.pull).map(|(k, p)| k + speed_squared * p).collect();
        let coupling: Vec<f64> = self.coupling.iter().map(|c| speed_squared * c).collect();
        let (mut first, mut start) = (coupling.len(), matrix.len());
        Chain::factor(self.mesh.elements().zip(&self.own).rev().map(|((_, length, order), own)| {
            first -= order;
            start -= order * order;
            Link {
                matrix: &matrix[start..start + order * order],
                coupling: &coupling[first..first + order],
                own: speed_squared * own,
                reach: length,
            }
        }))
    }

    /// The clamped response to the pull on a unit rigid turn: with that turn it is the blade's
    /// static shape for a turned root.
    pub(super) fn response_to_turn(&self, chain: &Chain, speed_squared: f64) -> Vec<f64> {
        let mut load: Vec<f64> = self.coupling.iter().map(|c| -speed_squared * c).collect();
        let on_turn: Vec<f64> = self.own.iter().map(|own| -speed_squared * own).collect();
        chain.solve(&mut load, &on_turn);
        load
    }

    /// The clamped response to the inertia of a motion given at the points of the grid.
    pub(super) fn response_to_inertia(&self, chain: &Chain, motion: &[f64]) -> Vec<f64> {
        let mut load = vec![0.0; self.mesh.count()];
        let mut on_turn = vec![0.0; self.own.len()];
        let mut end = load.len();
        let mut shear = 0.0;
        let grid = self.grid();
        let mut force: Vec<f64> = grid.weighted(grid.inertia()).collect();
        force.iter_mut().zip(motion).for_each(|(force, u)| *force *= u);
        for (e, cell) in grid.cells().iter().enumerate().rev() {
            let order = self.mesh.orders()[e];
            let half = cell.half();
            let table = self.coarse.table(order);
            let force = &force[cell.points.clone()];
            let f = &mut load[end - order..end];
            end -= order;
            let total: f64 = force.iter().sum();
            let on = |polynomial: &[f64]| -> f64 { force.iter().zip(polynomial).map(|(f, p)| f * p).sum() };
            if self.torsion {
                for (j, entry) in f.iter_mut().enumerate() {
                    *entry = half * on(table.first(j));
                }
                on_turn[e] = total;
            } else {
                for (j, entry) in f.iter_mut().enumerate() {
                    *entry = half * half * on(table.second(j));
                }
                // What lies outboard is carried by the motion of the outer end: J₀(1) = 2, J₁(1) = −2/3.
                f[0] += shear * 2.0 * half * half;
                if let Some(next) = f.get_mut(1) {
                    *next -= shear * half * half * (2.0 / 3.0);
                }
                // The force's lever about the inner end is ½ (1 + ξ) times the length, I₀ = 1 + ξ.
                on_turn[e] = half * on(table.first(0)) + shear * 2.0 * half;
                shear += total;
            }
        }
        chain.solve(&mut load, &on_turn);
        load
    }

    /// Derivatives of the strain energy by the strain coefficients.
    pub(super) fn strain_gradient(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; coefficients.len()];
        let (mut first, mut start) = (0, 0);
        for &order in self.mesh.orders() {
            let c = &coefficients[first..first + order];
            let out = &mut out[first..first + order];
            let matrix = &self.stiffness[start..start + order * order];
            for j in 0..order {
                out[j] += matrix[j * order + j] * c[j];
                if j + 1 < order {
                    let beside = matrix[j * order + j + 1];
                    out[j + 1] += beside * c[j];
                    out[j] += beside * c[j + 1];
                }
            }
            first += order;
            start += order * order;
        }
        out
    }

    /// Derivatives of the pull energy per Ω² by the strain coefficients.
    pub(super) fn pull_gradient(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; coefficients.len()];
        let mut on_turn = Vec::with_capacity(self.own.len());
        let (mut turn, mut first, mut start) = (0.0, 0, 0);
        for ((_, length, order), own) in self.mesh.elements().zip(&self.own) {
            let c = &coefficients[first..first + order];
            let coupling = &self.coupling[first..first + order];
            let out = &mut out[first..first + order];
            add(out, turn, coupling);
            for (c, column) in c.iter().zip(self.pull[start..start + order * order].chunks_exact(order)) {
                add(out, *c, column);
            }
            on_turn.push(own * turn + c.iter().zip(coupling).map(|(c, a)| c * a).sum::<f64>());
            turn += length * c[0];
            first += order;
            start += order * order;
        }
        self.carry_inward(&mut out, &on_turn);
        out
    }

    /// The same of a unit rigid turn, and twice its own energy.
    pub(super) fn pull_on_turn(&self) -> (Vec<f64>, f64) {
        let mut out = self.coupling.clone();
        self.carry_inward(&mut out, &self.own);
        (out, self.own.iter().sum())
    }

    /// Adds to the loads on the coefficients what acts on the turn of every element outboard.
    fn carry_inward(&self, load: &mut [f64], on_turn: &[f64]) {
        let (mut carried, mut first) = (0.0, load.len());
        for ((_, length, order), own) in self.mesh.elements().zip(on_turn).rev() {
            first -= order;
            load[first] += carried * length;
            carried += own;
        }
    }

    /// The motion of clamped strain coefficients at the points of the grid.
    pub(super) fn motion(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut motion = vec![0.0; self.grid().len()];
        self.for_elements(&self.coarse, coefficients, |state| {
            let out = &mut motion[state.points.clone()];
            if self.torsion { state.turn_of(out) } else { state.motion_of(out) }
        });
        motion
    }

    /// The fields of clamped strain coefficients at the points of the fine grid.
    pub(super) fn fields(&self, coefficients: &[f64]) -> Vector {
        let points = self.fine_grid().len();
        let (mut motion, mut turn, mut strain) = (vec![0.0; points], vec![0.0; points], vec![0.0; points]);
        self.for_elements(&self.fine, coefficients, |state| {
            let span = state.points.clone();
            for (j, &c) in state.coefficients.iter().enumerate() {
                add(&mut strain[span.clone()], c, state.table.value(j));
            }
            state.turn_of(&mut turn[span.clone()]);
            if !self.torsion {
                state.motion_of(&mut motion[span]);
            }
        });
        if self.torsion {
            motion.clone_from(&turn);
        }
        Vector { motion, turn, strain }
    }

    /// Visits the elements from root to tip.
    fn for_elements(&self, at: &Points, coefficients: &[f64], mut visit: impl FnMut(&State)) {
        let (mut turn, mut motion, mut first) = (0.0, 0.0, 0);
        for (cell, &order) in at.grid.cells().iter().zip(self.mesh.orders()) {
            let half = cell.half();
            let c = &coefficients[first..first + order];
            let table = at.table(order);
            visit(&State { coefficients: c, table, half, turn, motion, points: cell.points.clone() });
            let next = c.get(1).copied().unwrap_or(0.0);
            motion += 2.0 * half * (turn + half * (c[0] - next / 3.0));
            turn += 2.0 * half * c[0];
            first += order;
        }
    }

    /// Whether the root turns: hinged, or on a spring.
    pub(super) fn root_turns(&self) -> bool {
        self.grid().condition() != RootCondition::Clamped
    }
}

impl Points {
    /// So many per element beyond its order.
    fn new(blade: &Blade, dof: Dof, layout: &Layout, more: usize, rules: &GaussRules) -> Self {
        let ends = layout.radii.windows(2).zip(&layout.orders);
        let cells = ends.map(|(ends, order)| (ends[0], ends[1], order + more));
        let grid = Grid::for_cells(blade, dof, cells, rules);
        let mut tables: Vec<Option<Tables>> = Vec::new();
        for &order in &layout.orders {
            if tables.len() <= order {
                tables.resize(order + 1, None);
            }
            tables[order].get_or_insert_with(|| Tables::new(order, rules.with_points(order + more)));
        }
        Self { grid, tables }
    }

    fn table(&self, order: usize) -> &Tables {
        // Every order of the mesh has its tables.
        self.tables[order].as_ref().unwrap_or_else(|| unreachable!())
    }
}

/// An element of a deformed blade.
struct State<'a> {
    coefficients: &'a [f64],
    table: &'a Tables,
    half: f64,
    /// Turn and motion at its inner end.
    turn: f64,
    motion: f64,
    points: Range<usize>,
}

impl State<'_> {
    fn turn_of(&self, out: &mut [f64]) {
        out.fill(self.turn);
        for (j, &c) in self.coefficients.iter().enumerate() {
            add(out, self.half * c, self.table.first(j));
        }
    }

    fn motion_of(&self, out: &mut [f64]) {
        out.fill(self.motion);
        add(out, self.half * self.turn, self.table.first(0));
        for (j, &c) in self.coefficients.iter().enumerate() {
            add(out, self.half * self.half * c, self.table.second(j));
        }
    }
}

fn add(out: &mut [f64], factor: f64, values: &[f64]) {
    out.iter_mut().zip(values).for_each(|(out, value)| *out += factor * value);
}
