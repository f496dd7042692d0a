//! One element of the coupled blade: its own functions, their fields at the points, and its matrices.
//!
//! The functions of an element are its strains w″, v″, φ′ as Legendre polynomials, and the motion that it is
//! handed at its inner end, the state (w, w′, v, v′, φ). No unknown is a position in space, so nothing is lost
//! on short elements.

use super::blade::{CoupledSection, CoupledStretch};
use super::terms::{FIELDS, SectionWeights, TERMS, place};
use crate::dof::Dof;
use crate::lagrange::Energy;
use crate::numerics::legendre::{Outboard, Tables};
use crate::numerics::vector::{axpy, dot, long_dot};
use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;

/// Numbers of the state at an element's end: w, w′, v, v′, φ.
pub const STATES: usize = 5;
/// Place of each state among the fields.
pub const STATE_FIELDS: [usize; STATES] = [0, 1, 3, 4, 6];
/// Places of w″, v″ and φ′ among the fields.
pub const STRAIN_FIELDS: [usize; 3] = [2, 5, 7];
/// Fields of each degree of freedom.
const FIELDS_OF: [core::ops::Range<usize>; 3] = [0..3, 3..6, 6..8];

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
    /// Of one matrix on these sections.
    fn new(sections: &[CoupledSection], energy: Energy) -> Self {
        let mut pairs = Vec::new();
        for term in TERMS.iter().filter(|term| term.energy == energy) {
            let along: Vec<f64> = sections.iter().map(term.weight).collect();
            if along.iter().all(|weight| *weight == 0.0) {
                continue;
            }
            let (row, column) = (place(term.row), place(term.column));
            if row != column {
                pairs.push((column, row, along.clone()));
            }
            pairs.push((row, column, along));
        }
        Self(pairs)
    }

    /// Of an antisymmetric matrix on these sections: each pair of fields has the other sign the other way.
    pub fn skew(sections: &[CoupledSection], terms: &[SkewTerm]) -> Self {
        let mut pairs = Vec::new();
        for (row, column, weight) in terms {
            let along: Vec<f64> = sections.iter().map(weight).collect();
            pairs.push((*column, *row, along.iter().map(|weight| -weight).collect()));
            pairs.push((*row, *column, along));
        }
        Self(pairs)
    }

    /// The same at points `from` … of `all` along the blade.
    pub fn scatter(&self, from: usize, all: usize, whole: &mut Self) {
        for (row, column, along) in &self.0 {
            let at = whole.0.iter().position(|pair| (pair.0, pair.1) == (*row, *column)).unwrap_or_else(|| {
                whole.0.push((*row, *column, vec![0.0; all]));
                whole.0.len() - 1
            });
            whole.0[at].2[from..from + along.len()].copy_from_slice(along);
        }
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

/// A pair of fields of an antisymmetric matrix, row before column, and its weight.
pub type SkewTerm = (usize, usize, fn(&CoupledSection) -> f64);

/// Fields at the points of one element, or of the whole blade; what is empty is 0.
pub type PointFields = [Vec<f64>; FIELDS];

/// Functions of an element at its points: each moves one degree of freedom.
#[derive(Clone, Debug)]
pub struct Functions {
    /// Points.
    points: usize,
    /// The degree of freedom of each function; 3 where it does not move here.
    dofs: Vec<usize>,
    /// Function by function, the fields of its degree of freedom, in room for three.
    values: Vec<f64>,
}

impl Functions {
    /// Number of functions.
    pub fn count(&self) -> usize {
        self.dofs.len()
    }

    /// The fields that a function has.
    pub fn fields_of(&self, function: usize) -> core::ops::Range<usize> {
        FIELDS_OF.get(self.dofs[function]).cloned().unwrap_or(0..0)
    }

    /// A field of a function at the points, where it has it.
    pub fn field(&self, function: usize, field: usize) -> Option<&[f64]> {
        let own = self.fields_of(function);
        let from = (3 * function + field.checked_sub(own.start)?) * self.points;
        own.contains(&field).then(|| &self.values[from..from + self.points])
    }

    fn set(&mut self, function: usize, dof: usize, fields: [&[f64]; 3], factors: [f64; 3]) {
        self.dofs[function] = dof;
        let room = self.values[3 * function * self.points..].chunks_exact_mut(self.points.max(1));
        for ((out, values), factor) in room.zip(fields).zip(factors) {
            out.iter_mut().zip(values).for_each(|(out, value)| *out = factor * value);
        }
    }
}

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
    /// The state at the outer end as sums of the element's functions: each a list of place and factor.
    pub transfer: Transfer,
}

/// States as sums of functions, each a list of place and factor.
pub type Transfer = [Vec<(usize, f64)>; STATES];

impl Element {
    /// On a stretch; degrees of freedom with order 0 do not move.
    pub fn new(stretch: &CoupledStretch, orders: [usize; 3], rule: Rc<Rule>, lumps: Vec<CoupledSection>) -> Self {
        let half = 0.5 * (stretch.to - stretch.from);
        let sections: Vec<CoupledSection> =
            rule.nodes.iter().map(|(xi, _)| stretch.section(stretch.from + half * (1.0 + xi))).collect();
        Self {
            from: stretch.from,
            half,
            orders,
            weight: rule.nodes.iter().map(|(_, weight)| half * weight).collect(),
            couplings: [Energy::Elastic, Energy::Centrifugal, Energy::Inertia]
                .map(|energy| Couplings::new(&sections, energy)),
            sections,
            rule,
            hung: lumps.iter().map(SectionWeights::new).reduce(|sum, own| sum.plus(&own)),
            lumps,
            transfer: transfer(half, orders),
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
    pub fn functions(&self) -> Functions {
        let (tables, half, points) = (&self.rule.tables, self.half, self.points());
        let (ones, zeros) = (vec![1.0; points], vec![0.0; points]);
        let mut all = Functions { points, dofs: vec![3; self.count()], values: vec![0.0; 3 * self.count() * points] };
        let (states, mut first) = (self.strains(), 0);
        for dof in (0..3).filter(|dof| self.moves(*dof)) {
            for j in 0..self.orders[dof] {
                if dof == Dof::Torsion.index() {
                    all.set(first + j, dof, [tables.first(j), tables.value(j), &zeros], [half, 1.0, 0.0]);
                } else {
                    let fields = [tables.second(j), tables.first(j), tables.value(j)];
                    all.set(first + j, dof, fields, [half * half, half, 1.0]);
                }
            }
            first += self.orders[dof];
            all.set(states + 2 * dof, dof, [&ones, &zeros, &zeros], [1.0; 3]);
            if dof != Dof::Torsion.index() {
                // I₀ = 1 + ξ: the lever of a rotation about the inner end.
                all.set(states + 2 * dof + 1, dof, [tables.first(0), &ones, &zeros], [half, 1.0, 0.0]);
            }
        }
        all
    }

    /// One matrix of the element, with what hangs at its outer end.
    pub fn matrix(&self, functions: &Functions, energy: Energy) -> Square {
        let mut matrix = self.lower(functions, self.couplings(energy));
        matrix.mirror();
        if let Some(hung) = &self.hung {
            let hung = hung.of(energy);
            matrix.add_outer(&self.transfer, |p, q| hung[STATE_FIELDS[p]][STATE_FIELDS[q]]);
        }
        matrix
    }

    /// The lower triangle of a matrix of couplings at the points.
    pub fn lower(&self, functions: &Functions, couplings: &Couplings) -> Square {
        let mut matrix = Square::zero(self.count());
        let mut load = vec![0.0; self.points()];
        for (row, column, along) in &couplings.0 {
            for j in 0..functions.count() {
                let Some(own) = functions.field(j, *column) else { continue };
                let weighted = own.iter().zip(along).zip(&self.weight).map(|((own, a), w)| own * a * w);
                load.iter_mut().zip(weighted).for_each(|(load, value)| *load = value);
                for i in j..functions.count() {
                    if let Some(other) = functions.field(i, *row) {
                        *matrix.at_mut(i, j) += dot(other, &load);
                    }
                }
            }
        }
        matrix
    }

    /// The state at the outer end of a sum of functions.
    pub fn outer_state(&self, coefficients: &[f64]) -> [f64; STATES] {
        self.transfer.each_ref().map(|row| row.iter().map(|&(place, factor)| factor * coefficients[place]).sum())
    }

    /// Adds the fields of a sum of functions, at the points `from` … of all.
    pub fn add_fields(&self, functions: &Functions, coefficients: &[f64], from: usize, out: &mut PointFields) {
        for (function, factor) in coefficients.iter().enumerate().filter(|(_, factor)| **factor != 0.0) {
            for field in functions.fields_of(function) {
                if let Some(own) = functions.field(function, field) {
                    axpy(&mut out[field][from..from + self.points()], *factor, own);
                }
            }
        }
    }
}

/// The state at the outer end of an element as sums of its functions.
fn transfer(half: f64, orders: [usize; 3]) -> Transfer {
    let (length, states) = (2.0 * half, orders.iter().sum::<usize>());
    let mut transfer = Transfer::default();
    let mut first = 0;
    for dof in 0..2 {
        let order = orders[dof];
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
    if orders[2] > 0 {
        transfer[4] = vec![(states + 4, 1.0), (first, length)];
    }
    transfer
}

/// Σ of fields times loads over the points.
pub fn work(fields: &PointFields, loads: &PointFields) -> f64 {
    let parts = fields.iter().zip(loads).filter(|(field, load)| !field.is_empty() && !load.is_empty());
    parts.map(|(field, load)| long_dot(field, load)).sum()
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

    /// What stands below the diagonal above it too.
    fn mirror(&mut self) {
        for j in 0..self.n {
            for i in j + 1..self.n {
                *self.at_mut(j, i) = self.at(i, j);
            }
        }
    }

    /// Adds `factor` times another.
    pub fn add(&mut self, factor: f64, other: &Self) {
        self.entries.iter_mut().zip(&other.entries).for_each(|(a, b)| *a += factor * b);
    }

    /// Adds Σ of `weight(p, q)` times row p times row q of a transfer.
    pub fn add_outer(&mut self, transfer: &Transfer, weight: impl Fn(usize, usize) -> f64) {
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

    /// This times a vector, which is added.
    pub fn add_times(&self, x: &[f64], out: &mut [f64]) {
        for (j, x) in x.iter().enumerate() {
            axpy(out, *x, self.column(j));
        }
    }
}
