//! The piecewise functions of one blade and degree of freedom: their energies element by element,
//! and the operations of inverse iteration in time proportional to the number of elements.

use super::layout::Layout;
use super::work::Effort;
use crate::blade::{Blade, Place, RootCondition};
use crate::dof::Dof;
use crate::functions::{Deformation, Mesh};
use crate::lagrange::{Grid, Panel};
use crate::numerics::legendre::Tables;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::recursion::{Link, Recursion};
use crate::numerics::vector::axpy;
use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

/// Points of an element beyond its order b: a displacement has degree b + 1, and its square times a linear
/// mass is to be integrated exactly; so is the square of a rotation times a cubic tension.
const POINTS_FOR_ENERGIES: usize = 2;
/// The same where modes are checked: the equilibrium moment of a mode has degree b + 4, and its
/// square is to be integrated exactly.
const POINTS_FOR_MOMENTS: usize = 5;

/// The factor of a system with one state: the rotation.
pub(super) type Factor = Recursion<1>;

/// Energies of all strain polynomials of a mesh.
#[derive(Clone, Debug)]
pub(super) struct Elements {
    pub(super) mesh: Mesh,
    /// For energies.
    coarse: Points,
    /// For moments.
    fine: Points,
    /// Per element, order × order by columns: strain energy, of which the lower triangle is used, and,
    /// per Ω², centrifugal energy.
    elastic: Vec<f64>,
    centrifugal: Vec<f64>,
    /// Per element: centrifugal energy between its polynomials and a unit rotation, and of the rotation itself.
    coupling: Vec<f64>,
    own: Vec<f64>,
    effort: Effort,
}

/// The points of a mesh.
#[derive(Clone, Debug)]
struct Points {
    grid: Grid,
    /// What the polynomials are there, by order.
    tables: Vec<Option<Tables>>,
}

/// One element by itself.
#[derive(Clone, Copy, Debug)]
pub(super) struct Local<'a> {
    /// Half its length [m].
    pub(super) half: f64,
    /// The polynomials at its points.
    pub(super) table: &'a Tables,
    /// Quadrature weights and inertia at its points.
    pub(super) weight: &'a [f64],
    pub(super) inertia: &'a [f64],
    /// Strain energy (lower triangle, neighbours alone) and centrifugal energy per Ω² of its polynomials.
    pub(super) elastic: &'a [f64],
    pub(super) centrifugal: &'a [f64],
    /// Centrifugal energy between its polynomials and a unit rotation, and of the rotation itself.
    pub(super) coupling: &'a [f64],
    pub(super) own: f64,
    /// Inertia of the point masses at its outer end.
    pub(super) lump: f64,
}

/// The fields of a clamped function at the points of the fine grid.
#[derive(Clone, Debug)]
pub(super) struct Vector {
    pub(super) displacement: Vec<f64>,
    pub(super) rotation: Vec<f64>,
    pub(super) strain: Vec<f64>,
}

impl Elements {
    pub(super) fn new(blade: &Blade, dof: Dof, layout: &Layout, rules: &GaussRules) -> Self {
        let mesh = layout.mesh();
        let points = |more| Points::new(blade, dof, layout, more, rules);
        let mut elements = Self {
            coarse: points(POINTS_FOR_ENERGIES),
            fine: points(POINTS_FOR_MOMENTS),
            elastic: Vec::new(),
            centrifugal: Vec::new(),
            coupling: Vec::new(),
            own: Vec::new(),
            effort: Effort::new(mesh.orders()),
            mesh,
        };
        elements.add_energies();
        elements
    }

    /// What the steps of a solve cost.
    pub(super) fn effort(&self) -> Effort {
        self.effort
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
        let rigidities: Vec<f64> = grid.weighted(grid.elastic()).collect();
        let tensions: Vec<f64> = grid.weighted(grid.centrifugal()).collect();
        let size: usize = self.mesh.orders().iter().map(|order| order * order).sum();
        let (mut of_elastic, mut of_centrifugal) = (Vec::with_capacity(size), Vec::with_capacity(size));
        let mut coupling = Vec::with_capacity(self.mesh.count());
        let mut own = Vec::with_capacity(self.mesh.orders().len());
        for (panel, &order) in grid.panels().iter().zip(self.mesh.orders()) {
            let half = panel.half();
            let (elastic, centrifugal) = (&rigidities[panel.points.clone()], &tensions[panel.points.clone()]);
            let table = self.coarse.table(order);
            let triple =
                |w: &[f64], a: &[f64], b: &[f64]| -> f64 { w.iter().zip(a).zip(b).map(|((w, a), b)| w * a * b).sum() };
            let start = of_elastic.len();
            of_elastic.resize(start + order * order, 0.0);
            of_centrifugal.resize(start + order * order, 0.0);
            let (elastic_matrix, centrifugal_matrix) = (&mut of_elastic[start..], &mut of_centrifugal[start..]);
            for j in 0..order {
                // A linear stiffness couples neighbours only.
                for i in j..order.min(j + 2) {
                    elastic_matrix[j * order + i] = triple(elastic, table.value(i), table.value(j));
                }
                for i in j..order {
                    let value = half * half * triple(centrifugal, table.first(i), table.first(j));
                    (centrifugal_matrix[j * order + i], centrifugal_matrix[i * order + j]) = (value, value);
                }
            }
            for j in 0..order {
                let sum: f64 = centrifugal.iter().zip(table.first(j)).map(|(w, a)| w * a).sum();
                coupling.push(half * sum);
            }
            own.push(centrifugal.iter().sum());
            if let (Some(lump), Some(own)) = (panel.lump, own.last_mut()) {
                // The outer end rotates with the inner one and by the first polynomial.
                let (pull, reach) = (tensions[lump], panel.to - panel.from);
                let first = coupling.len() - order;
                of_centrifugal[start] += pull * reach * reach;
                coupling[first] += pull * reach;
                *own += pull;
            }
        }
        (self.elastic, self.centrifugal, self.coupling, self.own) = (of_elastic, of_centrifugal, coupling, own);
    }

    /// The factor of K + Ω² C of the clamped root, in lag without −Ω² M.
    pub(super) fn factor(&self, speed_squared: f64) -> Option<Factor> {
        let matrix: Vec<f64> = self.elastic.iter().zip(&self.centrifugal).map(|(k, p)| k + speed_squared * p).collect();
        let coupling: Vec<f64> = self.coupling.iter().map(|c| speed_squared * c).collect();
        let (mut first, mut start) = (coupling.len(), matrix.len());
        Recursion::factor(self.mesh.elements().zip(&self.own).rev().map(|((_, length, order), own)| {
            first -= order;
            start -= order * order;
            Link {
                matrix: &matrix[start..start + order * order],
                coupling: [&coupling[first..first + order]],
                own: [[speed_squared * own]],
                reach: [(0, length)],
            }
        }))
    }

    /// The clamped response to the centrifugal load on a unit rigid rotation: with that rotation it is the blade's
    /// static shape for a rotated root.
    pub(super) fn response_to_root_rotation(&self, factor: &Factor, speed_squared: f64) -> Vec<f64> {
        let mut load: Vec<f64> = self.coupling.iter().map(|c| -speed_squared * c).collect();
        let on_rotation: Vec<[f64; 1]> = self.own.iter().map(|own| [-speed_squared * own]).collect();
        factor.solve(&mut load, &on_rotation);
        load
    }

    /// The clamped response to the inertia of a displacement given at the points of the grid.
    pub(super) fn response_to_inertia(&self, factor: &Factor, displacement: &[f64]) -> Vec<f64> {
        let mut load = vec![0.0; self.mesh.count()];
        let mut on_rotation = vec![[0.0]; self.own.len()];
        let mut end = load.len();
        let mut shear = 0.0;
        let grid = self.grid();
        let mut force: Vec<f64> = grid.weighted(grid.inertia()).collect();
        force.iter_mut().zip(displacement).for_each(|(force, u)| *force *= u);
        for (e, panel) in grid.panels().iter().enumerate().rev() {
            let order = self.mesh.orders()[e];
            let half = panel.half();
            let table = self.coarse.table(order);
            let hung = panel.lump.map_or(0.0, |lump| force[lump]);
            let force = &force[panel.points.clone()];
            let f = &mut load[end - order..end];
            end -= order;
            let total: f64 = force.iter().sum();
            let on = |polynomial: &[f64]| -> f64 { force.iter().zip(polynomial).map(|(f, p)| f * p).sum() };
            if self.in_torsion() {
                for (j, entry) in f.iter_mut().enumerate() {
                    *entry = half * on(table.first(j));
                }
                f[0] += 2.0 * half * hung;
                on_rotation[e] = [total + hung];
            } else {
                shear += hung;
                for (j, entry) in f.iter_mut().enumerate() {
                    *entry = half * half * on(table.second(j));
                }
                // What lies outboard is carried by the displacement of the outer end: J₀(1) = 2, J₁(1) = −2/3.
                f[0] += shear * 2.0 * half * half;
                if let Some(next) = f.get_mut(1) {
                    *next -= shear * half * half * (2.0 / 3.0);
                }
                // The force's lever about the inner end is ½ (1 + ξ) times the length, I₀ = 1 + ξ.
                on_rotation[e] = [half * on(table.first(0)) + shear * 2.0 * half];
                shear += total;
            }
        }
        factor.solve(&mut load, &on_rotation);
        load
    }

    /// Derivatives of the strain energy by the strain coefficients.
    pub(super) fn elastic_gradient(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; coefficients.len()];
        let (mut first, mut start) = (0, 0);
        for &order in self.mesh.orders() {
            let c = &coefficients[first..first + order];
            let out = &mut out[first..first + order];
            let matrix = &self.elastic[start..start + order * order];
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

    /// Derivatives of the centrifugal energy per Ω² by the strain coefficients.
    pub(super) fn centrifugal_gradient(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; coefficients.len()];
        let mut on_rotation = Vec::with_capacity(self.own.len());
        let (mut rotation, mut first, mut start) = (0.0, 0, 0);
        for ((_, length, order), own) in self.mesh.elements().zip(&self.own) {
            let c = &coefficients[first..first + order];
            let coupling = &self.coupling[first..first + order];
            let out = &mut out[first..first + order];
            axpy(out, rotation, coupling);
            for (c, column) in c.iter().zip(self.centrifugal[start..start + order * order].chunks_exact(order)) {
                axpy(out, *c, column);
            }
            on_rotation.push(own * rotation + c.iter().zip(coupling).map(|(c, a)| c * a).sum::<f64>());
            rotation += length * c[0];
            first += order;
            start += order * order;
        }
        self.carry_inward(&mut out, &on_rotation);
        out
    }

    /// The same of a unit rigid rotation, and twice its own energy.
    pub(super) fn centrifugal_on_rigid(&self) -> (Vec<f64>, f64) {
        let mut out = self.coupling.clone();
        self.carry_inward(&mut out, &self.own);
        (out, self.own.iter().sum())
    }

    /// Adds to the loads on the coefficients what acts on the rotation of every element outboard.
    fn carry_inward(&self, load: &mut [f64], on_rotation: &[f64]) {
        let (mut carried, mut first) = (0.0, load.len());
        for ((_, length, order), own) in self.mesh.elements().zip(on_rotation).rev() {
            first -= order;
            load[first] += carried * length;
            carried += own;
        }
    }

    /// The displacement of clamped strain coefficients at the points of the grid.
    pub(super) fn displacement(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut displacement = vec![0.0; self.grid().len()];
        self.for_elements(&self.coarse, coefficients, |state| {
            let out = &mut displacement;
            if self.in_torsion() { state.rotation_of(out) } else { state.displacement_of(out) }
        });
        displacement
    }

    /// The fields of clamped strain coefficients at the points of the fine grid.
    pub(super) fn fields(&self, coefficients: &[f64]) -> Vector {
        let points = self.fine_grid().len();
        let (mut displacement, mut rotation, mut strain) = (vec![0.0; points], vec![0.0; points], vec![0.0; points]);
        self.for_elements(&self.fine, coefficients, |state| {
            for (j, &c) in state.coefficients.iter().enumerate() {
                axpy(&mut strain[state.points.clone()], c, state.table.value(j));
            }
            state.rotation_of(&mut rotation);
            if !self.in_torsion() {
                state.displacement_of(&mut displacement);
            }
        });
        if self.in_torsion() {
            displacement.clone_from(&rotation);
        }
        Vector { displacement, rotation, strain }
    }

    /// Every element by itself, root to tip.
    pub(super) fn locals(&self) -> Vec<Local<'_>> {
        let (mut first, mut start) = (0, 0);
        let one = |((panel, &order), &own): ((&Panel, &usize), &f64)| {
            let (matrix, row) = (start..start + order * order, first..first + order);
            first += order;
            start += order * order;
            Local {
                half: panel.half(),
                table: self.coarse.table(order),
                weight: &self.grid().weight()[panel.points.clone()],
                inertia: &self.grid().inertia()[panel.points.clone()],
                elastic: &self.elastic[matrix.clone()],
                centrifugal: &self.centrifugal[matrix],
                coupling: &self.coupling[row],
                own,
                lump: panel.lump.map_or(0.0, |lump| self.grid().inertia()[lump]),
            }
        };
        self.grid().panels().iter().zip(self.mesh.orders()).zip(&self.own).map(one).collect()
    }

    /// Visits the elements from root to tip.
    fn for_elements(&self, at: &Points, coefficients: &[f64], mut visit: impl FnMut(&State)) {
        let (mut rotation, mut displacement, mut first) = (0.0, 0.0, 0);
        for (panel, &order) in at.grid.panels().iter().zip(self.mesh.orders()) {
            let half = panel.half();
            let c = &coefficients[first..first + order];
            let table = at.table(order);
            let next = c.get(1).copied().unwrap_or(0.0);
            let outer =
                (rotation + 2.0 * half * c[0], displacement + 2.0 * half * (rotation + half * (c[0] - next / 3.0)));
            let (points, lump) = (panel.points.clone(), panel.lump);
            visit(&State { coefficients: c, table, half, rotation, displacement, outer, points, lump });
            (rotation, displacement) = outer;
            first += order;
        }
    }

    /// Whether the system is torsion, in which the displacement is the rotation itself.
    fn in_torsion(&self) -> bool {
        self.grid().deformation() == Deformation::Torsion
    }

    /// Whether the root rotates: hinged, or on a spring.
    pub(super) fn root_rotates(&self) -> bool {
        self.grid().condition() != RootCondition::Clamped
    }
}

impl Points {
    /// So many per element beyond its order.
    fn new(blade: &Blade, dof: Dof, layout: &Layout, more: usize, rules: &GaussRules) -> Self {
        let ends = layout.radii.windows(2).zip(&layout.orders);
        let panels = ends.map(|(ends, order)| (Place::whole(ends[0], ends[1]), order + more));
        let grid = Grid::for_panels(blade, dof, panels, rules);
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
    /// Turn and displacement at its inner end.
    rotation: f64,
    displacement: f64,
    /// The same at its outer end.
    outer: (f64, f64),
    /// Its points, and that of the point masses at its outer end.
    points: Range<usize>,
    lump: Option<usize>,
}

impl State<'_> {
    fn rotation_of(&self, all: &mut [f64]) {
        if let Some(lump) = self.lump {
            all[lump] = self.outer.0;
        }
        let out = &mut all[self.points.clone()];
        out.fill(self.rotation);
        for (j, &c) in self.coefficients.iter().enumerate() {
            axpy(out, self.half * c, self.table.first(j));
        }
    }

    fn displacement_of(&self, all: &mut [f64]) {
        if let Some(lump) = self.lump {
            all[lump] = self.outer.1;
        }
        let out = &mut all[self.points.clone()];
        out.fill(self.displacement);
        axpy(out, self.half * self.rotation, self.table.first(0));
        for (j, &c) in self.coefficients.iter().enumerate() {
            axpy(out, self.half * self.half * c, self.table.second(j));
        }
    }
}

#[cfg(test)]
mod tests;
