//! Shapes of coupled modes at any radius, with the forces and moments that balance their loads.

use super::assembly::Assembly;
use super::blade::CoupledStretch;
use super::element::{Element, PointFields, STATES};
use super::equilibrium::{Handed, ModeFields, end_at_roots, hand_on, moments};
use super::terms::{FIELDS, SectionWeights};
use crate::lagrange::Energy;
use crate::numerics::legendre::{Legendre, evaluate};
use crate::numerics::vector::dot;
use alloc::vec;
use alloc::vec::Vec;

/// A mode at one radius; what does not move there is 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// w, w′, w″, v, v′, v″, φ, φ′.
    pub fields: [f64; FIELDS],
    /// What the part outboard hands inboard: force and moment of flap, of lag, and torque, from equilibrium [N, N·m].
    pub forces: Handed,
}

/// The fields of a mode on an element at a radius.
pub type At<'a> = &'a dyn Fn(usize, usize, f64) -> [f64; FIELDS];

/// Modes with eigenvalues λ at Ω² = s, sampled at ascending radii; they are given by their fields at the points of
/// the elements and at any radius.
pub fn sample(
    assembly: &Assembly,
    stretches: &[CoupledStretch],
    (fields, at): (&ModeFields, At<'_>),
    values: &[f64],
    s: f64,
    radii: &[f64],
) -> Vec<Vec<Sample>> {
    let sampled = |(mode, value): (usize, &f64)| {
        let mut samples = vec![Sample::default(); radii.len()];
        let mut handed: Handed = [0.0; STATES];
        let mut loads = PointFields::default();
        assembly.along.couplings(Energy::Centrifugal).load(-s, &fields.at[mode], &mut loads);
        assembly.along.couplings(Energy::Inertia).load(*value, &fields.at[mode], &mut loads);
        let mut inside: [Vec<f64>; 3] = core::array::from_fn(|_| vec![0.0; assembly.along.points()]);
        for (index, element) in assembly.elements.iter().enumerate().rev() {
            if let Some(hung) = &element.hung {
                hand_on(&hung.combined(0.0, -s, *value), &fields.outer_state(mode, index), &mut handed);
            }
            let (from, to) = (element.from, element.from + 2.0 * element.half);
            let first = radii.partition_point(|r| *r < from);
            for (r, sample) in radii.iter().zip(&mut samples).skip(first) {
                let last = index + 1 == assembly.elements.len();
                if *r < to || (last && *r <= to * (1.0 + 4.0 * f64::EPSILON)) {
                    let here = |r: f64| at(mode, index, r);
                    *sample = within(element, &stretches[index], &here, (*value, s), *r, &handed);
                }
            }
            moments(element, &loads, assembly.along.part(index).start, &mut handed, &mut inside);
            end_at_roots(assembly, index, &mut handed);
        }
        samples
    };
    values.iter().take(fields.count()).enumerate().map(sampled).collect()
}

/// Fields at a radius of an element, and the forces there: those handed from outboard and those of the loads
/// between, by the element's own rule.
fn within(
    element: &Element,
    stretch: &CoupledStretch,
    at: &dyn Fn(f64) -> [f64; FIELDS],
    (value, s): (f64, f64),
    r: f64,
    outboard: &Handed,
) -> Sample {
    let to = element.from + 2.0 * element.half;
    let length = (to - r).max(0.0);
    let mut forces = *outboard;
    for (dof, moved) in [(0, 0), (1, 2)] {
        if element.moves(dof) {
            forces[moved + 1] += outboard[moved] * length;
        }
    }
    for (node, weight) in element.rule_nodes() {
        let x = r + 0.5 * length * (1.0 + node);
        let loads = loads_at(stretch, &at(x), (value, s), x);
        let weight = 0.5 * length * weight;
        for moved in [0, 2] {
            let field = 3 * moved / 2;
            forces[moved] += weight * loads[field];
            forces[moved + 1] += weight * (loads[field + 1] + (x - r) * loads[field]);
        }
        forces[4] += weight * loads[6];
    }
    let fields = at(r);
    let here = loads_at(stretch, &fields, (value, s), r);
    forces[1] += here[2];
    forces[3] += here[5];
    forces[4] += here[7];
    for dof in (0..3).filter(|dof| !element.moves(*dof)) {
        let states = super::equilibrium::STATE_RANGE[dof].clone();
        forces[states].fill(0.0);
    }
    Sample { fields, forces }
}

/// −Ω²C + λM on the fields at a radius.
fn loads_at(stretch: &CoupledStretch, fields: &[f64; FIELDS], (value, s): (f64, f64), r: f64) -> [f64; FIELDS] {
    let weights = SectionWeights::new(&stretch.section(r)).combined(0.0, -s, value);
    weights.map(|row| dot(&row, fields))
}

/// The fields of a sum of an element's functions at a radius.
pub fn fields_at(element: &Element, coefficients: &[f64], r: f64) -> [f64; FIELDS] {
    let half = element.half;
    let x = r - element.from;
    let most = element.orders.iter().fold(0, |most, order| most.max(*order));
    let mut table = vec![Legendre::default(); most];
    evaluate((x / half - 1.0).clamp(-1.0, 1.0), &mut table);
    let (mut fields, strains) = ([0.0; FIELDS], element.strains());
    let mut first = 0;
    for dof in 0..3 {
        let order = element.orders[dof];
        let own = &coefficients[first..first + order];
        first += order;
        if order == 0 {
            continue;
        }
        let sum = |of: fn(&Legendre) -> f64| -> f64 { own.iter().zip(&table).map(|(a, at)| a * of(at)).sum() };
        if dof == 2 {
            fields[6] = coefficients[strains + 4] + half * sum(|at| at.first);
            fields[7] = sum(|at| at.value);
        } else {
            let (displaced, rotated) = (coefficients[strains + 2 * dof], coefficients[strains + 2 * dof + 1]);
            fields[3 * dof] = displaced + x * rotated + half * half * sum(|at| at.second);
            fields[3 * dof + 1] = rotated + half * sum(|at| at.first);
            fields[3 * dof + 2] = sum(|at| at.value);
        }
    }
    fields
}
