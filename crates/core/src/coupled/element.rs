//! One element of the coupled blade: its own functions, their fields at the points, and its matrices.
//!
//! The functions of an element are its strains w″, v″, φ′ as Legendre polynomials, and the motion that it is
//! handed at its inner end, the state (w, w′, v, v′, φ). No unknown is a position in space, so nothing is lost
//! on short elements.

use super::blade::{CoupledSection, CoupledStretch};
use super::terms::{FIELDS, SectionWeights, Weights};
use crate::dof::Dof;
use crate::lagrange::Energy;
use crate::numerics::legendre::{Outboard, Tables};
use crate::numerics::vector::{axpy, dot};
use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;

/// Numbers of the state at an element's end: w, w′, v, v′, φ.
pub const STATES: usize = 5;
/// Place of each state among the fields.
pub const STATE_FIELDS: [usize; STATES] = [0, 1, 3, 4, 6];
/// Fields of each degree of freedom.
pub const FIELDS_OF: [core::ops::Range<usize>; 3] = [0..3, 3..6, 6..8];

/// A quadrature rule with the polynomials at its points.
#[derive(Clone, Debug)]
pub struct Rule {
    nodes: Vec<(f64, f64)>,
    tables: Tables,
    /// Integrals from the points to the right end.
    pub outboard: Outboard,
}

impl Rule {
    /// For strains of up to `order` polynomials.
    pub fn new(nodes: &[(f64, f64)], order: usize) -> Self {
        Self { nodes: nodes.to_vec(), tables: Tables::new(order, nodes), outboard: Outboard::new(nodes) }
    }
}

/// The weights of one matrix along an element: the pairs of fields that it couples, row and column, with the
/// weights at the points.
#[derive(Clone, Debug, Default)]
pub struct Couplings(pub Vec<(usize, usize, Vec<f64>)>);

impl Couplings {
    fn new(weights: &[SectionWeights], of: fn(&SectionWeights) -> &Weights) -> Self {
        Self::of(&weights.iter().map(|weights| *of(weights)).collect::<Vec<_>>())
    }

    /// From the weights at every point.
    pub fn of(weights: &[Weights]) -> Self {
        let mut pairs = Vec::new();
        for row in 0..FIELDS {
            for column in 0..FIELDS {
                let along: Vec<f64> = weights.iter().map(|weights| weights[row][column]).collect();
                if along.iter().any(|weight| *weight != 0.0) {
                    pairs.push((row, column, along));
                }
            }
        }
        Self(pairs)
    }

    /// Adds `factor` times what the fields at the points load each field with.
    pub fn load(&self, factor: f64, fields: &PointFields, loads: &mut PointFields) {
        for (row, column, weights) in &self.0 {
            let values = &fields[*column];
            if values.is_empty() {
                continue;
            }
            let load = &mut loads[*row];
            load.resize(values.len(), 0.0);
            load.iter_mut().zip(weights).zip(values).for_each(|((load, w), v)| *load += factor * w * v);
        }
    }
}

/// Fields at the points of one element; what is empty is 0.
pub type PointFields = [Vec<f64>; FIELDS];

/// One element.
#[derive(Clone, Debug)]
pub struct Element {
    /// Inner end [m].
    pub from: f64,
    /// Half the length [m].
    pub half: f64,
    /// Polynomials of w″, v″ and φ′; 0 inboard of the root.
    pub orders: [usize; 3],
    /// The rule of its points.
    pub rule: Rc<Rule>,
    /// Quadrature weights [m].
    pub weight: Vec<f64>,
    /// Sections at the points.
    pub sections: Vec<CoupledSection>,
    /// Weights of the terms of K, C and M at the points.
    couplings: [Couplings; 3],
    /// Concentrated masses at the outer end.
    pub lumps: Vec<CoupledSection>,
    /// The weights of their terms.
    pub hung: Option<SectionWeights>,
}

impl Element {
    /// On a stretch; degrees of freedom with order 0 do not move.
    pub fn new(stretch: &CoupledStretch, orders: [usize; 3], rule: Rc<Rule>, lumps: Vec<CoupledSection>) -> Self {
        let half = 0.5 * (stretch.to - stretch.from);
        let sections: Vec<CoupledSection> =
            rule.nodes.iter().map(|(xi, _)| stretch.section(stretch.from + half * (1.0 + xi))).collect();
        let weights: Vec<SectionWeights> = sections.iter().map(SectionWeights::new).collect();
        let matrices: [fn(&SectionWeights) -> &Weights; 3] = [|w| &w.elastic, |w| &w.centrifugal, |w| &w.inertia];
        Self {
            from: stretch.from,
            half,
            orders,
            weight: rule.nodes.iter().map(|(_, weight)| half * weight).collect(),
            couplings: matrices.map(|of| Couplings::new(&weights, of)),
            sections,
            rule,
            hung: lumps.iter().map(SectionWeights::new).reduce(|sum, own| sum.plus(&own)),
            lumps,
        }
    }

    /// The weights of one matrix.
    pub fn couplings(&self, energy: Energy) -> &Couplings {
        &self.couplings[energy as usize]
    }

    /// Number of strain polynomials.
    pub fn strains(&self) -> usize {
        self.orders.iter().sum()
    }

    /// Number of functions: the strain polynomials, then the states.
    pub fn count(&self) -> usize {
        self.strains() + STATES
    }

    /// Nodes and weights of its rule on [−1, 1].
    pub fn rule_nodes(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.rule.nodes.iter().copied()
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.weight.len()
    }

    /// Whether a degree of freedom moves here.
    pub fn moves(&self, dof: usize) -> bool {
        self.orders[dof] > 0
    }

    /// All functions, by place; a degree of freedom that does not move leaves its states without fields.
    pub fn functions(&self) -> Vec<PointFields> {
        let mut all = vec![PointFields::default(); self.count()];
        for dof in (0..3).filter(|dof| self.moves(*dof)) {
            self.functions_of(dof, &mut all);
        }
        all
    }

    fn functions_of(&self, dof: usize, all: &mut [PointFields]) {
        let (tables, half, points) = (&self.rule.tables, self.half, self.points());
        let first: usize = self.orders[..dof].iter().sum();
        let scaled = |values: &[f64], factor: f64| values.iter().map(|v| v * factor).collect::<Vec<f64>>();
        let ones = || vec![1.0; points];
        if dof == Dof::Torsion.index() {
            for j in 0..self.orders[dof] {
                all[first + j][6] = scaled(tables.first(j), half);
                all[first + j][7] = tables.value(j).to_vec();
            }
            all[self.strains() + 4][6] = ones();
            return;
        }
        let field = 3 * dof;
        for j in 0..self.orders[dof] {
            all[first + j][field] = scaled(tables.second(j), half * half);
            all[first + j][field + 1] = scaled(tables.first(j), half);
            all[first + j][field + 2] = tables.value(j).to_vec();
        }
        all[self.strains() + 2 * dof][field] = ones();
        // I₀ = 1 + ξ: the lever of a rotation about the inner end.
        let rotated = &mut all[self.strains() + 2 * dof + 1];
        (rotated[field], rotated[field + 1]) = (scaled(tables.first(0), half), ones());
    }

    /// What each function loads each field with, as a sum of matrices times factors.
    pub fn loads(&self, functions: &[PointFields], sum: &[(Energy, f64)]) -> Vec<PointFields> {
        let load = |own: &PointFields| {
            let mut loads = PointFields::default();
            for (energy, factor) in sum {
                self.couplings(*energy).load(*factor, own, &mut loads);
            }
            loads
        };
        functions.iter().map(load).collect()
    }

    /// One matrix of the element, with what hangs at its outer end.
    pub fn matrix(&self, functions: &[PointFields], energy: Energy) -> Square {
        let mut matrix = Square::zero(self.count());
        let mut loads = self.loads(functions, &[(energy, 1.0)]);
        for load in loads.iter_mut().flatten() {
            load.iter_mut().zip(&self.weight).for_each(|(load, w)| *load *= w);
        }
        for (j, loads) in loads.iter().enumerate() {
            for (i, own) in functions.iter().enumerate().skip(j) {
                let sum = work(own, loads);
                *matrix.at_mut(i, j) = sum;
                *matrix.at_mut(j, i) = sum;
            }
        }
        if let Some(hung) = &self.hung {
            let hung = hung.of(energy);
            matrix.add_outer(&self.transfer(), |p, q| hung[STATE_FIELDS[p]][STATE_FIELDS[q]]);
        }
        matrix
    }

    /// An antisymmetric matrix of the element, of couplings at its points and of what hangs at its outer end.
    pub fn skew(&self, functions: &[PointFields], couplings: &Couplings, hung: Option<Weights>) -> Square {
        let mut matrix = Square::zero(self.count());
        for (j, own) in functions.iter().enumerate() {
            let mut loads = PointFields::default();
            couplings.load(1.0, own, &mut loads);
            for load in &mut loads {
                load.iter_mut().zip(&self.weight).for_each(|(load, w)| *load *= w);
            }
            for (i, other) in functions.iter().enumerate().skip(j + 1) {
                let sum = work(other, &loads);
                *matrix.at_mut(i, j) = sum;
                *matrix.at_mut(j, i) = -sum;
            }
        }
        if let Some(hung) = hung {
            matrix.add_outer(&self.transfer(), |p, q| hung[STATE_FIELDS[p]][STATE_FIELDS[q]]);
        }
        matrix
    }

    /// The state at the outer end as sums of the element's functions: each a list of place and factor.
    pub fn transfer(&self) -> [Vec<(usize, f64)>; STATES] {
        let (length, states) = (2.0 * self.half, self.strains());
        let mut transfer: [Vec<(usize, f64)>; STATES] = Default::default();
        let mut first = 0;
        for dof in 0..2 {
            let order = self.orders[dof];
            if order > 0 {
                let (w, w1) = (states + 2 * dof, states + 2 * dof + 1);
                // J₀(1) = 2, J₁(1) = −2/3.
                transfer[2 * dof] = vec![(w, 1.0), (w1, length), (first, 0.5 * length * length)];
                if order > 1 {
                    transfer[2 * dof].push((first + 1, -length * length / 6.0));
                }
                transfer[2 * dof + 1] = vec![(w1, 1.0), (first, length)];
            }
            first += order;
        }
        if self.orders[2] > 0 {
            transfer[4] = vec![(states + 4, 1.0), (first, length)];
        }
        transfer
    }

    /// The state at the outer end of a sum of functions.
    pub fn outer_state(&self, coefficients: &[f64]) -> [f64; STATES] {
        self.transfer().map(|row| row.iter().map(|&(place, factor)| factor * coefficients[place]).sum())
    }

    /// The fields at the points of a sum of functions.
    pub fn fields(&self, functions: &[PointFields], coefficients: &[f64]) -> PointFields {
        let mut out: PointFields = core::array::from_fn(|_| vec![0.0; self.points()]);
        for (own, factor) in functions.iter().zip(coefficients).filter(|(_, factor)| **factor != 0.0) {
            for (out, values) in out.iter_mut().zip(own) {
                axpy(out, *factor, values);
            }
        }
        out
    }
}

/// Σ of fields times loads over the points.
pub fn work(fields: &PointFields, loads: &PointFields) -> f64 {
    let parts = fields.iter().zip(loads).filter(|(field, load)| !field.is_empty() && !load.is_empty());
    parts.map(|(field, load)| dot(field, load)).sum()
}

/// A square matrix, column by column.
#[derive(Clone, Debug)]
pub struct Square {
    n: usize,
    entries: Vec<f64>,
}

impl Square {
    /// Of zeros.
    pub fn zero(n: usize) -> Self {
        Self { n, entries: vec![0.0; n * n] }
    }

    /// Its order.
    pub fn order(&self) -> usize {
        self.n
    }

    /// An entry.
    pub fn at(&self, i: usize, j: usize) -> f64 {
        self.entries[j * self.n + i]
    }

    /// The same, to be changed.
    pub fn at_mut(&mut self, i: usize, j: usize) -> &mut f64 {
        &mut self.entries[j * self.n + i]
    }

    /// A column.
    pub fn column(&self, j: usize) -> &[f64] {
        &self.entries[j * self.n..(j + 1) * self.n]
    }

    /// Two columns, the second to be changed; `j` < `k`.
    pub fn pair(&mut self, j: usize, k: usize) -> (&[f64], &mut [f64]) {
        let (left, right) = self.entries.split_at_mut(k * self.n);
        (&left[j * self.n..(j + 1) * self.n], &mut right[..self.n])
    }

    /// Adds `factor` times another.
    pub fn add(&mut self, factor: f64, other: &Self) {
        self.entries.iter_mut().zip(&other.entries).for_each(|(a, b)| *a += factor * b);
    }

    /// Adds Σ of `weight(p, q)` times row p times row q of a transfer.
    pub fn add_outer(&mut self, transfer: &[Vec<(usize, f64)>; STATES], weight: impl Fn(usize, usize) -> f64) {
        for (p, row) in transfer.iter().enumerate() {
            for (q, column) in transfer.iter().enumerate() {
                let weight = weight(p, q);
                if weight == 0.0 {
                    continue;
                }
                for (i, a) in row {
                    for (j, b) in column {
                        *self.at_mut(*i, *j) += weight * a * b;
                    }
                }
            }
        }
    }

    /// This times a vector.
    pub fn times(&self, x: &[f64], out: &mut Vec<f64>) {
        out.clear();
        out.resize(self.n, 0.0);
        for (j, x) in x.iter().enumerate() {
            out.iter_mut().zip(self.column(j)).for_each(|(out, a)| *out += x * a);
        }
    }
}
