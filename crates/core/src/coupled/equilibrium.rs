//! Fields of modes, their energies, and how far their moments are from equilibrium with their loads
//! (docs/THEORY.md): a residual is a load, and a blade is statically determinate, so the moments that balance
//! it follow by integration from the tip.

use super::assembly::{Assembly, Vector};
use super::blade::CoupledBlade;
use super::element::{Element, PointFields, STATE_FIELDS, STATES, STRAIN_FIELDS, work};
use super::gyroscopic::Gyroscopic;
use super::terms::Weights;
use crate::blade::RootCondition;
use crate::dof::Dof;
use crate::lagrange::Energy;
use crate::numerics::scalar::{sin_cos, sqrt};
use crate::numerics::vector::{axpy, dot, long_dot};
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// Fields of modes along the whole blade.
#[derive(Clone, Debug, Default)]
pub struct ModeFields {
    /// Mode by mode, at the points of all elements.
    pub at: Vec<PointFields>,
    /// States at the outer end of each element, mode by mode.
    outer: Vec<Vec<[f64; STATES]>>,
    /// States at the inner end of each element, mode by mode.
    inner: Vec<Vec<[f64; STATES]>>,
}

impl ModeFields {
    /// Of these functions.
    pub fn new(assembly: &Assembly, modes: &[Vector]) -> Self {
        let mut fields = Self { at: Vec::new(), outer: Vec::new(), inner: Vec::new() };
        let points = assembly.along.points();
        for mode in modes {
            let mut at: PointFields = core::array::from_fn(|_| vec![0.0; points]);
            let (mut outer, mut inner) = (Vec::new(), Vec::new());
            for (index, (element, functions)) in assembly.elements.iter().zip(&assembly.functions).enumerate() {
                let own = &mode[assembly.part(index)];
                element.add_fields(functions, own, assembly.along.part(index).start, &mut at);
                outer.push(element.outer_state(own));
                inner.push(core::array::from_fn(|state| own[element.strains() + state]));
            }
            fields.at.push(at);
            fields.outer.push(outer);
            fields.inner.push(inner);
        }
        fields
    }

    /// Adds a mode: its fields at all points, and its states at the inner and outer end of every element.
    pub fn push(&mut self, at: PointFields, inner: Vec<[f64; STATES]>, outer: Vec<[f64; STATES]>) {
        self.at.push(at);
        self.inner.push(inner);
        self.outer.push(outer);
    }

    /// Sums of the modes, one for each column of `parts`.
    pub fn combined(&self, parts: &DMatrix<f64>) -> Self {
        let mut sums = Self::default();
        for column in parts.column_iter() {
            let mut at: PointFields = self
                .at
                .first()
                .map_or_else(Default::default, |first| first.each_ref().map(|field| vec![0.0; field.len()]));
            for (part, own) in column.iter().zip(&self.at) {
                at.iter_mut().zip(own).for_each(|(sum, own)| axpy(sum, *part, own));
            }
            let states = |of: &[Vec<[f64; STATES]>]| -> Vec<[f64; STATES]> {
                let sum = |element: usize, state: usize| {
                    column.iter().zip(of).map(|(part, own)| part * own[element][state]).sum::<f64>()
                };
                let elements = 0..of.first().map_or(0, Vec::len);
                elements.map(|element| core::array::from_fn(|state| sum(element, state))).collect()
            };
            sums.push(at, states(&self.inner), states(&self.outer));
        }
        sums
    }

    /// G between two modes.
    pub fn turned(&self, assembly: &Assembly, g: &Gyroscopic, row: usize, column: usize) -> f64 {
        let mut loads = PointFields::default();
        g.along.load(1.0, &self.at[column], &mut loads);
        for load in &mut loads {
            load.iter_mut().zip(&assembly.along.weight).for_each(|(load, w)| *load *= w);
        }
        let node = |(hung, (a, b)): (&Option<Weights>, (&[f64; STATES], &[f64; STATES]))| {
            hung.as_ref().map_or(0.0, |hung| node_energy(hung, a, b))
        };
        let nodes = g.hung.iter().zip(self.outer[row].iter().zip(&self.outer[column]));
        work(&self.at[row], &loads) + nodes.map(node).sum::<f64>()
    }

    /// The state of a mode at the outer end of an element.
    pub fn outer_state(&self, mode: usize, element: usize) -> [f64; STATES] {
        self.outer[mode][element]
    }

    /// Number of modes.
    pub fn count(&self) -> usize {
        self.at.len()
    }
}

/// The matrices in the order of their energies.
const ENERGIES: [Energy; 3] = [Energy::Elastic, Energy::Centrifugal, Energy::Inertia];

/// Energies of modes with one another, summed along the blade.
#[derive(Clone, Debug)]
pub struct ModeEnergies {
    /// K + F.
    pub elastic: DMatrix<f64>,
    /// C.
    pub centrifugal: DMatrix<f64>,
    /// M.
    pub inertia: DMatrix<f64>,
}

/// Of one mode, in K + F, C and M.
#[derive(Clone, Copy, Debug, Default)]
pub struct OwnEnergies {
    /// The energies.
    pub sums: [f64; 3],
    /// The sums of the sizes of all terms.
    pub sizes: [f64; 3],
}

impl OwnEnergies {
    /// The quotient of Rayleigh at Ω² = s: λ.
    pub fn quotient(&self, s: f64) -> f64 {
        let [elastic, centrifugal, inertia] = self.sums;
        (elastic + s * centrifugal) / inertia
    }
}

/// What the fields of a mode load each field with in one matrix, with the quadrature.
fn weighted_loads(assembly: &Assembly, fields: &PointFields, energy: Energy) -> PointFields {
    let mut loads = PointFields::default();
    assembly.along.couplings(energy).load(1.0, fields, &mut loads);
    for load in &mut loads {
        load.iter_mut().zip(&assembly.along.weight).for_each(|(load, w)| *load *= w);
    }
    loads
}

/// Energies of modes with one another.
pub fn energies(assembly: &Assembly, fields: &ModeFields) -> ModeEnergies {
    let n = fields.count();
    let mut matrices = [0, 1, 2].map(|_| DMatrix::<f64>::zeros(n, n));
    for (energy, matrix) in ENERGIES.into_iter().zip(&mut matrices) {
        for j in 0..n {
            let loads = weighted_loads(assembly, &fields.at[j], energy);
            for i in j..n {
                matrix[(i, j)] = work(&fields.at[i], &loads) + at_nodes(assembly, fields, energy, i, j);
            }
        }
        matrix.fill_upper_triangle_with_lower_triangle();
    }
    let [elastic, centrifugal, inertia] = matrices;
    ModeEnergies { elastic, centrifugal, inertia }
}

/// Energies of each mode alone.
pub fn own_energies(assembly: &Assembly, fields: &ModeFields) -> Vec<OwnEnergies> {
    let own = |(mode, fields_of): (usize, &PointFields)| {
        let mut own = OwnEnergies::default();
        for (kind, energy) in ENERGIES.into_iter().enumerate() {
            let loads = weighted_loads(assembly, fields_of, energy);
            let nodes = at_nodes(assembly, fields, energy, mode, mode);
            own.sums[kind] = work(fields_of, &loads) + nodes;
            let size =
                |(own, load): (&Vec<f64>, &Vec<f64>)| -> f64 { own.iter().zip(load).map(|(a, b)| (a * b).abs()).sum() };
            own.sizes[kind] = fields_of.iter().zip(&loads).map(size).sum::<f64>() + nodes.abs();
        }
        own
    };
    fields.at.iter().enumerate().map(own).collect()
}

/// The energy of two modes in concentrated masses and springs.
fn at_nodes(assembly: &Assembly, fields: &ModeFields, energy: Energy, i: usize, j: usize) -> f64 {
    let mut sum = 0.0;
    for (index, element) in assembly.elements.iter().enumerate() {
        if let Some(hung) = &element.hung {
            sum += node_energy(hung.of(energy), &fields.outer[i][index], &fields.outer[j][index]);
        }
        if energy == Energy::Elastic {
            let (free, a, b) = (assembly.roots.free(index), &fields.inner[i][index], &fields.inner[j][index]);
            for &p in free {
                sum += free.iter().map(|q| assembly.roots.spring(p, *q) * a[p] * b[*q]).sum::<f64>();
            }
        }
    }
    sum
}

fn node_energy(weights: &Weights, a: &[f64; STATES], b: &[f64; STATES]) -> f64 {
    let mut sum = 0.0;
    for (p, a) in STATE_FIELDS.iter().zip(a) {
        for (q, b) in STATE_FIELDS.iter().zip(b) {
            sum += weights[*p][*q] * a * b;
        }
    }
    sum
}

/// Forces and moments that the outboard part of the blade hands inboard: force of w, moment of w, the same of
/// v, moment of φ.
pub type Handed = [f64; STATES];

/// Moments μ_w, μ_v, μ_φ at the points of an element from its loads, which stand with those moments at `from` … of
/// all, and what it hands on, from what it is handed.
pub fn moments(element: &Element, loads: &PointFields, from: usize, handed: &mut Handed, moments: &mut [Vec<f64>; 3]) {
    let (outboard, half) = (&element.rule.outboard, element.half);
    let all = from..from + element.points();
    let part = |field: usize| loads[field].get(all.clone()).unwrap_or(&[]);
    let add = |to: &mut [f64], load: &[f64]| to.iter_mut().zip(load).for_each(|(to, load)| *to += load);
    let sum = |load: &[f64]| if load.is_empty() { 0.0 } else { dot(&element.weight, load) };
    let mut shear = vec![0.0; element.points()];
    for dof in 0..2 {
        let [displaced, rotated, strained] = [0, 1, 2].map(|i| part(3 * dof + i));
        outboard.integrate(displaced, handed[2 * dof], half, &mut shear);
        add(&mut shear, rotated);
        let moment = &mut moments[dof][all.clone()];
        outboard.integrate(&shear, handed[2 * dof + 1], half, moment);
        add(moment, strained);
        handed[2 * dof + 1] += sum(&shear);
        handed[2 * dof] += sum(displaced);
    }
    let moment = &mut moments[2][all.clone()];
    outboard.integrate(part(6), handed[4], half, moment);
    add(moment, part(7));
    handed[4] += sum(part(6));
}

/// What concentrated masses at a node hand inboard under these weights.
pub fn hand_on(weights: &Weights, state: &[f64; STATES], handed: &mut Handed) {
    for (row, handed) in STATE_FIELDS.iter().zip(handed) {
        *handed += STATE_FIELDS.iter().zip(state).map(|(column, state)| weights[*row][*column] * state).sum::<f64>();
    }
}

/// Residual moments of modes along the blade.
#[derive(Clone, Debug)]
pub struct Residuals {
    /// One list per mode, as of [`residual`].
    rows: Vec<Vec<f64>>,
}

impl Residuals {
    /// G_ij, the energies of the residual moments with one another.
    pub fn energies(&self) -> DMatrix<f64> {
        let n = self.rows.len();
        let mut energies = DMatrix::zeros(n, n);
        for j in 0..n {
            for i in j..n {
                energies[(i, j)] = long_dot(&self.rows[i], &self.rows[j]);
                energies[(j, i)] = energies[(i, j)];
            }
        }
        energies
    }

    /// The largest share of each element in the energies, those of each mode times a factor.
    pub fn shares(&self, assembly: &Assembly, factors: &[f64]) -> Vec<f64> {
        let mut shares = vec![0.0_f64; assembly.elements.len()];
        let points = assembly.along.points();
        for (row, factor) in self.rows.iter().zip(factors) {
            for (index, share) in shares.iter_mut().enumerate() {
                let part = assembly.along.part(index);
                let own = |number: usize| &row[number * points..][part.clone()];
                let energy: f64 = [0, 1, 2].into_iter().map(own).map(|own| dot(own, own)).sum();
                *share = share.max(factor * energy);
            }
        }
        shares
    }
}

/// Residual moments of modes with eigenvalues λ at Ω² = s.
pub fn residuals(blade: &CoupledBlade, assembly: &Assembly, fields: &ModeFields, values: &[f64], s: f64) -> Residuals {
    let row = |(mode, value): (usize, &f64)| {
        residual(blade, assembly, fields, mode, Factors { elastic: 1.0, centrifugal: s, inertia: *value })
    };
    Residuals { rows: values.iter().enumerate().map(row).collect() }
}

/// Coriolis loads in a residual: `factor` times G of another mode.
#[derive(Clone, Copy, Debug)]
pub struct Turned<'a> {
    /// G.
    pub g: &'a Gyroscopic,
    /// The mode.
    pub other: usize,
    /// Its factor.
    pub factor: f64,
}

/// How much of each load is in a residual: −(K + F), −Ω²C, +λM.
#[derive(Clone, Copy, Debug, Default)]
pub struct Factors {
    /// Of K + F.
    pub elastic: f64,
    /// Of C.
    pub centrifugal: f64,
    /// Of M.
    pub inertia: f64,
}

/// The residual moment of one mode as numbers whose squares sum to its energy in the inverse of the stiffness: three
/// at every point of the blade, first all of the first, and then those of the roots.
pub fn residual(
    blade: &CoupledBlade,
    assembly: &Assembly,
    fields: &ModeFields,
    mode: usize,
    factors: Factors,
) -> Vec<f64> {
    residual_turned(blade, assembly, fields, mode, factors, None)
}

/// The same with Coriolis loads.
pub fn residual_turned(
    blade: &CoupledBlade,
    assembly: &Assembly,
    fields: &ModeFields,
    mode: usize,
    factors: Factors,
    turned: Option<&Turned<'_>>,
) -> Vec<f64> {
    let (along, here) = (&assembly.along, &fields.at[mode]);
    let parts = [(Energy::Centrifugal, -factors.centrifugal), (Energy::Inertia, factors.inertia)];
    let mut loads = PointFields::default();
    for (energy, factor) in parts.into_iter().filter(|(_, factor)| *factor != 0.0) {
        along.couplings(energy).load(factor, here, &mut loads);
    }
    if let Some(Turned { g, other, factor }) = turned {
        g.along.load(*factor, &fields.at[*other], &mut loads);
    }
    let mut gaps: [Vec<f64>; 3] = core::array::from_fn(|_| vec![0.0; along.points()]);
    let mut handed: Handed = [0.0; STATES];
    let mut at_roots = Vec::new();
    for (index, element) in assembly.elements.iter().enumerate().rev() {
        if let Some(hung) = &element.hung {
            let weights = hung.combined(0.0, -factors.centrifugal, factors.inertia);
            hand_on(&weights, &fields.outer[mode][index], &mut handed);
        }
        if let Some((Turned { other, factor, .. }, hung)) = turned.and_then(|t| Some((t, t.g.hung[index].as_ref()?))) {
            hand_on(&hung.map(|row| row.map(|w| factor * w)), &fields.outer[*other][index], &mut handed);
        }
        moments(element, &loads, along.part(index).start, &mut handed, &mut gaps);
        let free = assembly.roots.free(index);
        let state = &fields.inner[mode][index];
        for &p in free {
            let spring: f64 = free.iter().map(|q| assembly.roots.spring(p, *q) * state[*q]).sum();
            at_roots.push((p, handed[p] - factors.elastic * spring));
        }
        end_at_roots(assembly, index, &mut handed);
    }
    if factors.elastic != 0.0 {
        let mut carried = PointFields::default();
        along.couplings(Energy::Elastic).load(-factors.elastic, here, &mut carried);
        for (gap, field) in gaps.iter_mut().zip(STRAIN_FIELDS) {
            gap.iter_mut().zip(&carried[field]).for_each(|(gap, carried)| *gap += carried);
        }
    }
    let mut row = Vec::with_capacity(3 * (along.points() + 1));
    along.flexibility.scale(&gaps, &mut row);
    row.extend(root_gaps(blade, &at_roots));
    row
}

/// A motion ends at its root: nothing is handed farther inboard than the inner end of this element.
pub fn end_at_roots(assembly: &Assembly, index: usize, handed: &mut Handed) {
    for (dof, states) in STATE_RANGE.into_iter().enumerate() {
        if index == 0 || !assembly.elements[index - 1].moves(dof) {
            handed[states].fill(0.0);
        }
    }
}

/// States of each degree of freedom.
pub const STATE_RANGE: [core::ops::Range<usize>; 3] = [0..2, 2..4, 4..5];

/// The gaps at springs, scaled by their flexibility; a root without a spring stores nothing.
fn root_gaps(blade: &CoupledBlade, gaps: &[(usize, f64)]) -> [f64; 3] {
    let of = |state: usize| gaps.iter().find(|gap| gap.0 == state).map_or(0.0, |gap| gap.1);
    let (flap, lag) = (of(1), of(3));
    let (s, c) = sin_cos(blade.spring_angle);
    let scaled = |dof, gap: f64| match blade.root(dof).condition {
        RootCondition::Spring(spring) => gap / sqrt(spring),
        RootCondition::Free | RootCondition::Clamped => 0.0,
    };
    let (turned_flap, turned_lag) = (c * flap - s * lag, s * flap + c * lag);
    [scaled(Dof::Flap, turned_flap), scaled(Dof::Lag, turned_lag), scaled(Dof::Torsion, of(4))]
}
