//! Fields of modes, their energies, and how far their moments are from equilibrium with their loads
//! (docs/THEORY.md): a residual is a load, and a blade is statically determinate, so the moments that balance
//! it follow by integration from the tip.

use super::assembly::{Assembly, Vector};
use super::blade::CoupledBlade;
use super::element::{Element, FIELDS_OF, PointFields, STATE_FIELDS, STATES, work};
use super::gyroscopic::Gyroscopic;
use super::terms::Weights;
use crate::blade::RootCondition;
use crate::dof::Dof;
use crate::lagrange::Energy;
use crate::numerics::scalar::{sin_cos, sqrt};
use crate::numerics::vector::dot;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// Fields of modes along the whole blade.
#[derive(Clone, Debug, Default)]
pub struct ModeFields {
    /// Mode by mode, element by element.
    pub at: Vec<Vec<PointFields>>,
    /// States at the outer end of each element, mode by mode.
    outer: Vec<Vec<[f64; STATES]>>,
    /// States at the inner end of each element, mode by mode.
    inner: Vec<Vec<[f64; STATES]>>,
}

impl ModeFields {
    /// Of these functions.
    pub fn new(assembly: &Assembly, modes: &[Vector]) -> Self {
        let mut fields = Self { at: Vec::new(), outer: Vec::new(), inner: Vec::new() };
        for mode in modes {
            let (mut at, mut outer, mut inner) = (Vec::new(), Vec::new(), Vec::new());
            for ((element, functions), own) in assembly.elements.iter().zip(&assembly.functions).zip(mode) {
                at.push(element.fields(functions, own));
                outer.push(element.outer_state(own));
                inner.push(core::array::from_fn(|state| own[element.strains() + state]));
            }
            fields.at.push(at);
            fields.outer.push(outer);
            fields.inner.push(inner);
        }
        fields
    }

    /// Adds a mode without elements.
    pub fn push(&mut self) {
        self.at.push(Vec::new());
        self.outer.push(Vec::new());
        self.inner.push(Vec::new());
    }

    /// Adds the next element of a mode: fields at its points, states at its inner and outer end.
    pub fn append(&mut self, mode: usize, at: PointFields, inner: [f64; STATES], outer: [f64; STATES]) {
        self.at[mode].push(at);
        self.inner[mode].push(inner);
        self.outer[mode].push(outer);
    }

    /// The state of a mode at the outer end of an element.
    pub fn outer_state(&self, mode: usize, element: usize) -> [f64; STATES] {
        self.outer[mode][element]
    }

    /// Number of modes.
    pub fn count(&self) -> usize {
        self.at.len()
    }

    /// Sums of the modes, one for each column of `parts`.
    pub fn combined(&self, parts: &DMatrix<f64>) -> Self {
        let elements = self.at.first().map_or(0, Vec::len);
        let mut sums = Self { at: Vec::new(), outer: Vec::new(), inner: Vec::new() };
        for column in parts.column_iter() {
            let mut at: Vec<PointFields> = Vec::with_capacity(elements);
            for element in 0..elements {
                let longest = self.at.iter().flat_map(|mode| &mode[element]).map(Vec::len).max();
                let mut sum: PointFields = core::array::from_fn(|_| vec![0.0; longest.unwrap_or(0)]);
                for (mode, part) in column.iter().enumerate() {
                    for (sum, own) in sum.iter_mut().zip(&self.at[mode][element]) {
                        crate::numerics::vector::axpy(sum, *part, own);
                    }
                }
                at.push(sum);
            }
            let states = |of: &Vec<Vec<[f64; STATES]>>| -> Vec<[f64; STATES]> {
                let each = |element: usize| {
                    core::array::from_fn(|state| {
                        column.iter().enumerate().map(|(mode, part)| part * of[mode][element][state]).sum()
                    })
                };
                (0..elements).map(each).collect()
            };
            sums.at.push(at);
            sums.outer.push(states(&self.outer));
            sums.inner.push(states(&self.inner));
        }
        sums
    }
}

impl ModeFields {
    /// G between two modes.
    pub fn turned(&self, assembly: &Assembly, g: &Gyroscopic, row: usize, column: usize) -> f64 {
        let mut sum = 0.0;
        for (index, element) in assembly.elements.iter().enumerate() {
            let mut loads = PointFields::default();
            g.couplings[index].load(1.0, &self.at[column][index], &mut loads);
            for load in &mut loads {
                load.iter_mut().zip(&element.weight).for_each(|(load, w)| *load *= w);
            }
            sum += work(&self.at[row][index], &loads);
            if let Some(hung) = &g.hung[index] {
                sum += node_energy(hung, &self.outer[row][index], &self.outer[column][index]);
            }
        }
        sum
    }
}

/// The matrices in the order of their energies.
const ENERGIES: [Energy; 3] = [Energy::Elastic, Energy::Centrifugal, Energy::Inertia];

/// Energies of modes with one another, and the sum of the sizes of every term of each.
#[derive(Clone, Debug)]
pub struct ModeEnergies {
    /// K + F.
    pub elastic: DMatrix<f64>,
    /// C.
    pub centrifugal: DMatrix<f64>,
    /// M.
    pub inertia: DMatrix<f64>,
    /// Of K + F, C and M, mode by mode.
    pub sizes: Vec<[f64; 3]>,
}

/// Energies of modes, summed along the blade.
pub fn energies(assembly: &Assembly, fields: &ModeFields) -> ModeEnergies {
    let n = fields.count();
    let mut matrices = [0, 1, 2].map(|_| DMatrix::<f64>::zeros(n, n));
    let mut sizes = vec![[0.0; 3]; n];
    for (index, element) in assembly.elements.iter().enumerate() {
        for (energy, matrix) in ENERGIES.into_iter().zip(&mut matrices) {
            let kind = energy as usize;
            for j in 0..n {
                let mut loads = PointFields::default();
                element.couplings(energy).load(1.0, &fields.at[j][index], &mut loads);
                for load in &mut loads {
                    load.iter_mut().zip(&element.weight).for_each(|(load, w)| *load *= w);
                }
                for i in j..n {
                    matrix[(i, j)] += work(&fields.at[i][index], &loads);
                }
                let own = &fields.at[j][index];
                let size = |(own, load): (&Vec<f64>, &Vec<f64>)| -> f64 {
                    own.iter().zip(load).map(|(a, b)| (a * b).abs()).sum()
                };
                sizes[j][kind] += own.iter().zip(&loads).map(size).sum::<f64>();
            }
            if let Some(hung) = &element.hung {
                let weights = hung.of(energy);
                for j in 0..n {
                    for i in j..n {
                        let (a, b) = (&fields.outer[i][index], &fields.outer[j][index]);
                        matrix[(i, j)] += node_energy(weights, a, b);
                        if i == j {
                            sizes[j][kind] += node_energy(weights, a, b).abs();
                        }
                    }
                }
            }
        }
        let free = assembly.roots.free(index);
        for j in 0..n {
            for i in j..n {
                let (a, b) = (&fields.inner[i][index], &fields.inner[j][index]);
                let spring: f64 =
                    free.iter().flat_map(|p| free.iter().map(|q| assembly.roots.spring(*p, *q) * a[*p] * b[*q])).sum();
                matrices[0][(i, j)] += spring;
                if i == j {
                    sizes[j][0] += spring;
                }
            }
        }
    }
    let [mut elastic, mut centrifugal, mut inertia] = matrices;
    for matrix in [&mut elastic, &mut centrifugal, &mut inertia] {
        matrix.fill_upper_triangle_with_lower_triangle();
    }
    ModeEnergies { elastic, centrifugal, inertia, sizes }
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

/// Moments μ_w, μ_v, μ_φ at the points of an element from its loads, and what it hands on, from what it is
/// handed.
pub fn moments(element: &Element, loads: &PointFields, handed: &mut Handed) -> [Vec<f64>; 3] {
    let (outboard, half) = (&element.rule.outboard, element.half);
    let mut moments: [Vec<f64>; 3] = Default::default();
    for dof in 0..2 {
        let [displaced, rotated, strained] = [0, 1, 2].map(|i| &loads[3 * dof + i]);
        let mut shear = vec![0.0; element.points()];
        outboard.integrate(displaced, handed[2 * dof], half, &mut shear);
        shear.iter_mut().zip(rotated).for_each(|(shear, load)| *shear += load);
        let mut moment = vec![0.0; element.points()];
        outboard.integrate(&shear, handed[2 * dof + 1], half, &mut moment);
        handed[2 * dof + 1] += dot(&element.weight, &shear);
        handed[2 * dof] += dot(&element.weight, displaced);
        moment.iter_mut().zip(strained).for_each(|(moment, load)| *moment += load);
        moments[dof] = moment;
    }
    let mut moment = vec![0.0; element.points()];
    outboard.integrate(&loads[6], handed[4], half, &mut moment);
    handed[4] += dot(&element.weight, &loads[6]);
    moment.iter_mut().zip(&loads[7]).for_each(|(moment, load)| *moment += load);
    moments[2] = moment;
    moments
}

/// What concentrated masses at a node hand inboard under these weights.
pub fn hand_on(weights: &Weights, state: &[f64; STATES], handed: &mut Handed) {
    for (row, handed) in STATE_FIELDS.iter().zip(handed) {
        *handed += STATE_FIELDS.iter().zip(state).map(|(column, state)| weights[*row][*column] * state).sum::<f64>();
    }
}

/// Residual moments of modes along the blade, each as numbers whose squares sum to its energy in the inverse of
/// the stiffness.
#[derive(Clone, Debug)]
pub struct Residuals {
    /// One list per mode.
    rows: Vec<Vec<f64>>,
    /// Where the numbers of each element begin.
    starts: Vec<usize>,
}

impl Residuals {
    /// G_ij, the energies of the residual moments with one another.
    pub fn energies(&self) -> DMatrix<f64> {
        let n = self.rows.len();
        let mut energies = DMatrix::zeros(n, n);
        for j in 0..n {
            for i in j..n {
                energies[(i, j)] = dot(&self.rows[i], &self.rows[j]);
                energies[(j, i)] = energies[(i, j)];
            }
        }
        energies
    }

    /// The largest share of each element in the energies, those of each mode times a factor.
    pub fn shares(&self, factors: &[f64]) -> Vec<f64> {
        let mut shares = vec![0.0_f64; self.starts.len()];
        for (row, factor) in self.rows.iter().zip(factors) {
            for (index, share) in shares.iter_mut().enumerate() {
                let end = self.starts.get(index + 1).copied().unwrap_or(row.len());
                let own = &row[self.starts[index]..end];
                *share = share.max(factor * dot(own, own));
            }
        }
        shares
    }
}

/// Residual moments of modes with eigenvalues λ at Ω² = s.
pub fn residuals(blade: &CoupledBlade, assembly: &Assembly, fields: &ModeFields, values: &[f64], s: f64) -> Residuals {
    let mut found = Residuals { rows: Vec::new(), starts: vec![0; assembly.elements.len()] };
    for (mode, value) in values.iter().enumerate() {
        let factors = Factors { elastic: 1.0, centrifugal: s, inertia: *value };
        let parts = residual(blade, assembly, fields, mode, factors);
        let mut row = Vec::with_capacity(parts.iter().map(Vec::len).sum());
        for (index, part) in parts.iter().enumerate() {
            if let Some(start) = found.starts.get_mut(index) {
                *start = row.len();
            }
            row.extend_from_slice(part);
        }
        found.rows.push(row);
    }
    found
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

/// The residual moment of a mode at Ω² = s and λ with Coriolis loads, as one row.
pub fn residual_turned(
    blade: &CoupledBlade,
    assembly: &Assembly,
    fields: &ModeFields,
    mode: usize,
    (s, value): (f64, f64),
    turned: &Turned<'_>,
) -> Vec<f64> {
    let factors = Factors { elastic: 1.0, centrifugal: s, inertia: value };
    residual_of(blade, assembly, fields, mode, factors, Some(turned)).concat()
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

/// The residual moment of one mode, element by element and then of the roots, as numbers whose squares sum to
/// its energy in the inverse of the stiffness.
pub fn residual(
    blade: &CoupledBlade,
    assembly: &Assembly,
    fields: &ModeFields,
    mode: usize,
    factors: Factors,
) -> Vec<Vec<f64>> {
    residual_of(blade, assembly, fields, mode, factors, None)
}

fn residual_of(
    blade: &CoupledBlade,
    assembly: &Assembly,
    fields: &ModeFields,
    mode: usize,
    factors: Factors,
    turned: Option<&Turned<'_>>,
) -> Vec<Vec<f64>> {
    let mut handed: Handed = [0.0; STATES];
    let mut parts: Vec<Vec<f64>> = vec![Vec::new(); assembly.elements.len()];
    let mut at_roots = Vec::new();
    for (index, element) in assembly.elements.iter().enumerate().rev() {
        let here = &fields.at[mode][index];
        if let Some(hung) = &element.hung {
            hand_on(
                &hung.combined(0.0, -factors.centrifugal, factors.inertia),
                &fields.outer[mode][index],
                &mut handed,
            );
        }
        let mut loads: PointFields = core::array::from_fn(|_| vec![0.0; element.points()]);
        element.couplings(Energy::Centrifugal).load(-factors.centrifugal, here, &mut loads);
        element.couplings(Energy::Inertia).load(factors.inertia, here, &mut loads);
        if let Some(Turned { g, other, factor }) = turned {
            g.couplings[index].load(*factor, &fields.at[*other][index], &mut loads);
            if let Some(hung) = &g.hung[index] {
                hand_on(&hung.map(|row| row.map(|w| factor * w)), &fields.outer[*other][index], &mut handed);
            }
        }
        let moments = moments(element, &loads, &mut handed);
        parts[index] = gaps(element, &moments, here, factors.elastic);
        let free = assembly.roots.free(index);
        let state = &fields.inner[mode][index];
        for &p in free {
            let spring: f64 = free.iter().map(|q| assembly.roots.spring(p, *q) * state[*q]).sum();
            at_roots.push((p, handed[p] - factors.elastic * spring));
        }
        end_at_roots(assembly, index, &mut handed);
    }
    parts.push(root_gaps(blade, &at_roots));
    parts
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

/// The gaps between moments and strains at the points of an element, scaled by the flexibility.
fn gaps(element: &Element, moments: &[Vec<f64>; 3], fields: &PointFields, elastic: f64) -> Vec<f64> {
    let mut loads = PointFields::default();
    element.couplings(Energy::Elastic).load(-elastic, fields, &mut loads);
    let mut out = Vec::with_capacity(3 * element.points());
    for (k, (section, weight)) in element.sections.iter().zip(&element.weight).enumerate() {
        let gap = |dof: usize| moments[dof][k] + loads[FIELDS_OF[dof].end - 1].get(k).copied().unwrap_or(0.0);
        let moves = [element.moves(0), element.moves(1)];
        let parts = bending_parts(section.angle, section.stiffness, moves, gap(0), gap(1));
        out.extend(parts.map(|part| sqrt(*weight) * part));
        if element.moves(2) {
            out.push(gap(2) * sqrt(weight / section.stiffness[2]));
        }
    }
    out
}

/// Two numbers whose squares sum to the energy of bending moments in the inverse of the stiffness of the
/// directions that bend.
pub fn bending_parts(
    (s, c): (f64, f64),
    [first, second, _]: [f64; 3],
    moves: [bool; 2],
    flap: f64,
    lag: f64,
) -> [f64; 2] {
    match moves {
        [true, true] => [(c * flap - s * lag) / sqrt(first), (s * flap + c * lag) / sqrt(second)],
        [true, false] => [flap / sqrt(first * c * c + second * s * s), 0.0],
        [false, true] => [lag / sqrt(first * s * s + second * c * c), 0.0],
        [false, false] => [0.0, 0.0],
    }
}

/// The gaps at springs, scaled by their flexibility; a root without a spring stores nothing.
fn root_gaps(blade: &CoupledBlade, gaps: &[(usize, f64)]) -> Vec<f64> {
    let of = |state: usize| gaps.iter().find(|gap| gap.0 == state).map_or(0.0, |gap| gap.1);
    let (flap, lag) = (of(1), of(3));
    let (s, c) = sin_cos(blade.spring_angle);
    let scaled = |dof, gap: f64| match blade.root(dof).condition {
        RootCondition::Spring(spring) => gap / sqrt(spring),
        RootCondition::Free | RootCondition::Clamped => 0.0,
    };
    let (turned_flap, turned_lag) = (c * flap - s * lag, s * flap + c * lag);
    vec![scaled(Dof::Flap, turned_flap), scaled(Dof::Lag, turned_lag), scaled(Dof::Torsion, of(4))]
}
