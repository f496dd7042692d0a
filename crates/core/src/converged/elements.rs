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

/// Points of an element beyond its order b: the equilibrium moment of a mode has degree b + 4, and
/// its square is to be integrated exactly.
const EXTRA_POINTS: usize = 5;

/// Energies of all strain polynomials of a mesh.
#[derive(Clone, Debug)]
pub(super) struct Elements {
    pub(super) mesh: Mesh,
    pub(super) grid: Grid,
    pub(super) torsion: bool,
    /// Tables by order.
    tables: Vec<Option<Tables>>,
    /// Per element, order × order by columns: strain energy and, per Ω², pull energy.
    stiffness: Vec<f64>,
    pull: Vec<f64>,
    /// Per element: pull energy between its polynomials and a unit turn, and of the turn itself.
    coupling: Vec<f64>,
    own: Vec<f64>,
}

/// One clamped function: its strain coefficients and its fields at the points of the grid.
#[derive(Clone, Debug)]
pub(super) struct Vector {
    pub(super) coefficients: Vec<f64>,
    pub(super) motion: Vec<f64>,
    pub(super) turn: Vec<f64>,
    pub(super) strain: Vec<f64>,
}

impl Elements {
    pub(super) fn new(blade: &Blade, dof: Dof, layout: &Layout, rules: &GaussRules) -> Self {
        let mesh = layout.mesh();
        let ends = layout.radii.windows(2).zip(mesh.orders());
        let cells = ends.map(|(ends, order)| (ends[0], ends[1], order + EXTRA_POINTS));
        let grid = Grid::for_cells(blade, dof, cells, rules);
        let mut tables: Vec<Option<Tables>> = Vec::new();
        for &order in mesh.orders() {
            if tables.len() <= order {
                tables.resize(order + 1, None);
            }
            tables[order].get_or_insert_with(|| Tables::new(order, rules.with_points(order + EXTRA_POINTS)));
        }
        let mut elements = Self {
            torsion: dof == Dof::Torsion,
            stiffness: Vec::new(),
            pull: Vec::new(),
            coupling: Vec::new(),
            own: Vec::new(),
            mesh,
            grid,
            tables,
        };
        elements.add_energies();
        elements
    }

    fn table(&self, order: usize) -> &Tables {
        // Every order of the mesh has its tables.
        self.tables[order].as_ref().unwrap_or_else(|| unreachable!())
    }

    fn add_energies(&mut self) {
        let rigidities: Vec<f64> = self.grid.weighted(self.grid.stiffness()).collect();
        let pulls: Vec<f64> = self.grid.weighted(self.grid.pull()).collect();
        let size: usize = self.mesh.orders().iter().map(|order| order * order).sum();
        let (mut of_strain, mut of_pull) = (Vec::with_capacity(size), Vec::with_capacity(size));
        let mut coupling = Vec::with_capacity(self.mesh.count());
        let mut own = Vec::with_capacity(self.mesh.orders().len());
        for (cell, &order) in self.grid.cells().iter().zip(self.mesh.orders()) {
            let half = cell.half();
            let (stiffness, pull) = (&rigidities[cell.points.clone()], &pulls[cell.points.clone()]);
            let table = self.table(order);
            let triple =
                |w: &[f64], a: &[f64], b: &[f64]| -> f64 { w.iter().zip(a).zip(b).map(|((w, a), b)| w * a * b).sum() };
            for j in 0..order {
                for i in 0..order {
                    // The lower triangle is used; a linear stiffness couples neighbours only.
                    of_strain.push(if i == j || i == j + 1 {
                        triple(stiffness, table.value(i), table.value(j))
                    } else {
                        0.0
                    });
                    of_pull.push(if i >= j { half * half * triple(pull, table.first(i), table.first(j)) } else { 0.0 });
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
    pub(super) fn response_to_turn(&self, chain: &Chain, speed_squared: f64) -> Vector {
        let mut load: Vec<f64> = self.coupling.iter().map(|c| -speed_squared * c).collect();
        let on_turn: Vec<f64> = self.own.iter().map(|own| -speed_squared * own).collect();
        chain.solve(&mut load, &on_turn);
        self.vector(load)
    }

    /// The clamped response to the inertia of a motion given at the points of the grid.
    pub(super) fn response_to_inertia(&self, chain: &Chain, motion: impl Fn(usize) -> f64) -> Vector {
        let mut load = vec![0.0; self.mesh.count()];
        let mut on_turn = vec![0.0; self.own.len()];
        let mut end = load.len();
        let mut shear = 0.0;
        let mut force = Vec::new();
        for (e, cell) in self.grid.cells().iter().enumerate().rev() {
            let order = self.mesh.orders()[e];
            let half = cell.half();
            let table = self.table(order);
            force.clear();
            force.extend(cell.points.clone().map(|k| self.grid.weight()[k] * self.grid.inertia()[k] * motion(k)));
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
        self.vector(load)
    }

    /// The fields of clamped strain coefficients.
    pub(super) fn vector(&self, coefficients: Vec<f64>) -> Vector {
        let points = self.grid.len();
        let mut strain = vec![0.0; points];
        let mut turn = vec![0.0; points];
        let mut motion = if self.torsion { Vec::new() } else { vec![0.0; points] };
        let (mut t, mut u, mut first) = (0.0, 0.0, 0);
        for (cell, &order) in self.grid.cells().iter().zip(self.mesh.orders()) {
            let table = self.table(order);
            let half = cell.half();
            let c = &coefficients[first..first + order];
            first += order;
            let span = cell.points.clone();
            for (j, &c) in c.iter().enumerate() {
                add(&mut strain[span.clone()], c, table.value(j));
                add(&mut turn[span.clone()], half * c, table.first(j));
            }
            if !self.torsion {
                let motion = &mut motion[span.clone()];
                for (j, &c) in c.iter().enumerate() {
                    add(motion, half * half * c, table.second(j));
                }
                for (value, lever) in motion.iter_mut().zip(table.first(0)) {
                    *value += u + half * lever * t;
                }
                let next = c.get(1).copied().unwrap_or(0.0);
                u += 2.0 * half * (t + half * (c[0] - next / 3.0));
            }
            for value in &mut turn[span] {
                *value += t;
            }
            t += 2.0 * half * c[0];
        }
        if self.torsion {
            motion.clone_from(&turn);
        }
        Vector { coefficients, motion, turn, strain }
    }

    /// Whether the root turns: hinged, or on a spring.
    pub(super) fn root_turns(&self) -> bool {
        self.grid.condition() != RootCondition::Clamped
    }
}

fn add(out: &mut [f64], factor: f64, values: &[f64]) {
    out.iter_mut().zip(values).for_each(|(out, value)| *out += factor * value);
}
