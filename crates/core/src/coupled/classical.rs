//! The paper's functions in the coupled equations: modes of the uniform beam for each motion, as many as are
//! asked for. The elements only say where they are summed.

use super::assembly::Assembly;
use super::blade::CoupledBlade;
use super::bounds::{Proof, lower_bounds, rounding};
use super::element::{PointFields, STATES};
use super::equilibrium::{ModeEnergies, ModeFields, energies, own_energies, residuals};
use super::range::residual_moments;
use super::reduced::Reduced;
use super::terms::FIELDS;
use super::{CoupledMode, MOST_SHIFTS, Proven, SHIFT, sample, shares};
use crate::dof::Dof;
use crate::functions::{AssumedFunctions, Sample};
use crate::numerics::eigen::{Eigen, EigenError, lowest_of_any_sign};
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::{ceil, maximum};
use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::{Cholesky, DMatrix};

/// No function turns by more than this within an element [rad], whose points then see all of it.
const TURN: f64 = 4.0;
/// Polynomials that the points of an element are enough for.
const ORDER: usize = 12;

/// Flap, lag and torsion functions of a coupled blade.
pub type Functions = [Box<dyn AssumedFunctions>; 3];

/// The coupled equations with the paper's functions.
pub struct Classical<'a> {
    blade: &'a CoupledBlade,
    functions: &'a Functions,
    assembly: Assembly,
    fields: ModeFields,
    energies: ModeEnergies,
}

/// Modes of the paper's functions with what their shapes need.
pub struct ClassicalModes {
    /// Ascending.
    pub modes: Vec<CoupledMode>,
    /// One column per mode: how much of each function, flap, lag and torsion in a row.
    vectors: DMatrix<f64>,
}

impl<'a> Classical<'a> {
    /// With these functions, each from the root of its motion outward.
    pub fn new(blade: &'a CoupledBlade, functions: &'a Functions, rules: &GaussRules) -> Self {
        let assembly = Assembly::of_order(blade, &radii(blade, functions), ORDER, rules);
        let fields = fields(&assembly, blade, functions);
        let energies = energies(&assembly, &fields);
        Self { blade, functions, assembly, fields, energies }
    }

    /// Number of functions of flap, lag and torsion.
    pub fn counts(&self) -> [usize; 3] {
        self.functions.each_ref().map(|own| own.count())
    }

    /// All functions for 0 ≤ Ω² ≤ `highest`, with a shift for the `count` lowest modes.
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn reduced(&self, highest: f64, count: usize) -> Result<Reduced, EigenError> {
        let ModeEnergies { elastic, centrifugal, inertia } = &self.energies;
        let ends = [elastic.clone(), elastic + centrifugal * highest];
        let size = available(&ends[1], inertia, count)?.values.last().map_or(0.0, |value| value.abs());
        // C enters in proportion: what is definite at both ends is definite between them.
        let definite = |sigma: &f64| ends.iter().all(|end| Cholesky::new(end + inertia * *sigma).is_some());
        let mut shifts = (0..MOST_SHIFTS).scan(SHIFT.0 * size, |sigma, _| {
            let now = *sigma;
            *sigma *= SHIFT.1;
            Some(now)
        });
        let sigma = shifts.find(definite).ok_or(EigenError::NotPositiveDefinite)?;
        let kinetic = shares::kinetic(&self.assembly, &self.fields);
        let residuals = residual_moments(self.blade, &self.assembly, &self.fields);
        Ok(Reduced::new(sigma, [elastic.clone(), centrifugal.clone(), inertia.clone()], kinetic, residuals))
    }

    /// λ of the lowest modes at Ω² = s with the first `each` functions of every motion alone.
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn values_of(&self, each: usize, s: f64, count: usize) -> Result<Vec<f64>, EigenError> {
        let mut first = 0;
        let mut kept = Vec::new();
        for own in self.counts() {
            kept.extend(first..first + own.min(each));
            first += own;
        }
        let part = |matrix: &DMatrix<f64>| matrix.select_rows(&kept).select_columns(&kept);
        let g = part(&self.energies.elastic) + part(&self.energies.centrifugal) * s;
        Ok(available(&g, &part(&self.energies.inertia), count)?.values)
    }

    /// The lowest modes at Ω² = s, bounded by what is proven of the blade.
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn modes(&self, s: f64, count: usize, proven: Option<&Proven>) -> Result<ClassicalModes, EigenError> {
        let g = &self.energies.elastic + &self.energies.centrifugal * s;
        // As many as are proven to lie below the separation are bounded together.
        let wanted = proven.map_or(count, |proven| count.max(proven.proof.below));
        let found = available(&g, &self.energies.inertia, wanted)?;
        let fields = self.fields.combined(&found.vectors);
        let energies = own_energies(&self.assembly, &fields);
        let values: Vec<f64> = energies.iter().map(|own| own.quotient(s)).collect();
        let gaps = residuals(self.blade, &self.assembly, &fields, &values, s).energies();
        let lower = proven.map(|proven| lower(&values, &gaps, proven));
        let rounding = rounding(&energies, &values, s, proven.map_or(0.0, |proven| proven.proof.sigma));
        let mode = |i: usize| CoupledMode {
            eigenvalue: values[i],
            error: gaps[(i, i)],
            bounds: lower.as_ref().and_then(|lower| {
                let least = lower[i].is_finite().then(|| lower[i].min(values[i]) - rounding[i])?;
                Some((least, values[i] + rounding[i]))
            }),
            shares: shares::own_shares(&self.assembly, &fields, i),
        };
        let count = count.min(values.len());
        Ok(ClassicalModes {
            modes: (0..count).map(mode).collect(),
            vectors: found.vectors.columns(0, count).into_owned(),
        })
    }

    /// The shapes of modes at Ω² = s at ascending radii, of unit inertia.
    pub fn samples(&self, found: &ClassicalModes, s: f64, radii: &[f64]) -> Vec<Vec<sample::Sample>> {
        let stretches = self.blade.stretches(&self.radii());
        let fields = self.fields.combined(&found.vectors);
        let values: Vec<f64> = found.modes.iter().map(|mode| mode.eigenvalue).collect();
        let at = |mode: usize, _: usize, r: f64| self.fields_at(found.vectors.column(mode).as_slice(), r);
        sample::sample(&self.assembly, &stretches, (&fields, &at), &values, s, radii)
    }

    /// Ends of the elements that it is summed on [m].
    fn radii(&self) -> Vec<f64> {
        self.assembly.elements.iter().map(|element| element.from).chain([self.blade.radius]).collect()
    }

    /// Fields of a mode at a radius.
    fn fields_at(&self, vector: &[f64], r: f64) -> [f64; FIELDS] {
        let mut out = [0.0; FIELDS];
        let mut first = 0;
        for (dof, functions) in Dof::ALL.into_iter().zip(self.functions) {
            let x = r - self.blade.root(dof).offset;
            let own = &vector[first..first + functions.count()];
            first += functions.count();
            if x < 0.0 {
                continue;
            }
            let mut samples = vec![Sample::default(); functions.count()];
            functions.sample(x, &mut samples);
            let place = 3 * dof.index();
            for (part, sample) in own.iter().zip(&samples) {
                let all = [sample.value, sample.slope, sample.curvature];
                out[place..].iter_mut().zip(all).for_each(|(out, value)| *out += part * value);
            }
        }
        out
    }
}

/// As many of the lowest modes as the functions determine.
fn available(g: &DMatrix<f64>, m: &DMatrix<f64>, count: usize) -> Result<Eigen, EigenError> {
    match lowest_of_any_sign(g, m, count.min(g.nrows())) {
        Err(EigenError::TooFewModes(left)) if left > 0 => lowest_of_any_sign(g, m, left),
        other => other,
    }
}

/// Ends of elements on which no function turns too far [m].
fn radii(blade: &CoupledBlade, functions: &Functions) -> Vec<f64> {
    let fastest = functions.iter().map(|own| own.wave_number()).fold(0.0, maximum);
    let mut radii = Vec::new();
    for ends in blade.stations().windows(2) {
        let (from, length) = (ends[0], ends[1] - ends[0]);
        let parts = ceil(fastest * length / TURN).max(1.0);
        radii.extend((0_u32..).map(f64::from).take_while(|i| *i < parts).map(|i| from + length * (i / parts)));
    }
    radii.push(blade.radius);
    radii
}

/// Every function at the points of the elements, flap, lag and torsion in a row.
fn fields(assembly: &Assembly, blade: &CoupledBlade, functions: &Functions) -> ModeFields {
    let (along, mut all) = (&assembly.along, ModeFields::default());
    for (dof, functions) in Dof::ALL.into_iter().zip(functions) {
        let count = functions.count();
        let (place, taken) = (3 * dof.index(), if dof == Dof::Torsion { 2 } else { 3 });
        let parts = |sample: &Sample| [sample.value, sample.slope, sample.curvature];
        // States are w, w′, v, v′, φ.
        let state = |sample: &Sample| {
            let mut state = [0.0; STATES];
            let own = state[2 * dof.index()..].iter_mut().zip(parts(sample)).take(taken - 1);
            own.for_each(|(state, value)| *state = value);
            state
        };
        let none: PointFields = core::array::from_fn(|_| vec![0.0; along.points()]);
        let (mut at, mut inner, mut outer) = (vec![none; count], vec![Vec::new(); count], vec![Vec::new(); count]);
        for (index, element) in assembly.elements.iter().enumerate() {
            let points = element.points();
            let from = element.from - blade.root(dof).offset;
            let mut samples = vec![Sample::default(); count * points];
            let mut ends = [vec![Sample::default(); count], vec![Sample::default(); count]];
            if element.moves(dof.index()) {
                let offsets: Vec<f64> = element.rule_nodes().map(|(node, _)| element.half * node).collect();
                functions.sample_about(from + element.half, &offsets, &mut samples);
                functions.sample(from, &mut ends[0]);
                functions.sample(from + 2.0 * element.half, &mut ends[1]);
            }
            for i in 0..count {
                let own = &samples[i * points..(i + 1) * points];
                for (field, part) in (place..place + taken).zip(0..) {
                    let here = at[i][field][along.part(index)].iter_mut().zip(own);
                    here.for_each(|(out, sample)| *out = parts(sample)[part]);
                }
                inner[i].push(state(&ends[0][i]));
                outer[i].push(state(&ends[1][i]));
            }
        }
        for ((at, inner), outer) in at.into_iter().zip(inner).zip(outer) {
            all.push(at, inner, outer);
        }
    }
    all
}

/// The best lower bounds of the eigenvalues: for every number of modes whose separation is known, by the modes that
/// lie below it together. −∞ where there is none.
fn lower(values: &[f64], gaps: &DMatrix<f64>, proven: &Proven) -> Vec<f64> {
    let mut best = vec![f64::NEG_INFINITY; values.len()];
    for below in 1..=proven.proof.below.min(values.len()) {
        // Lower bounds of the blade's own eigenvalues separate, and ρ the last.
        let rho = if below == proven.proof.below { proven.proof.rho } else { proven.lower[below] };
        let part = gaps.view((0, 0), (below, below)).into_owned();
        let found = lower_bounds(&values[..below], &part, &Proof { below, rho, ..proven.proof });
        for (best, own) in best.iter_mut().zip(found.into_iter().flatten()) {
            *best = best.max(own);
        }
    }
    // What bounds a mode bounds the next.
    for i in 1..best.len() {
        best[i] = best[i].max(best[i - 1]);
    }
    best
}
