//! Proof of how many negative directions the form B = α(K + F) + sC + κM has over *all* motions of the blade,
//! not only over sums of the functions (docs/THEORY.md).
//!
//! A motion is parted into sums of the functions and a rest whose strains are orthogonal to the polynomials on
//! every element. The rest is small at the displacements, so B on it is nearly αK; what couples the two is the
//! moment of the functions' residuals that no polynomial of the element takes up. Both are local.

use super::along::Flexibility;
use super::assembly::Assembly;
use super::blade::CoupledSection;
use super::element::{Couplings, Element, Functions, PointFields, STATES, STRAIN_FIELDS, Square};
use super::elimination::Factor;
use super::equilibrium::moments;
use super::gyroscopic::Gyroscopic;
use super::hermitian::{Hermitian, negative};
use crate::lagrange::Energy;
use crate::numerics::scalar::{hypot, maximum, sqrt};
use crate::numerics::vector::{axpy, dot, scale};
use alloc::vec;
use alloc::vec::Vec;

/// The form is lowered by this share, so that rounding cannot win a claim.
const ALLOWANCE: f64 = 1e-10;
/// Allowance for the quadrature of what is divided by the stiffness.
const SLACK: f64 = 1.001;
/// A linear property is a little larger or smaller at the ends of an element than at its outermost points.
const BEYOND_POINTS: f64 = 1.1;
/// Share of a polynomial that is left beside the others when it is nothing new.
const NOTHING_LEFT: f64 = 1e-12;

/// α, s and κ of a form α(K + F) + sC + κM.
#[derive(Clone, Copy, Debug)]
pub struct Form {
    /// α > 0.
    pub alpha: f64,
    /// s = Ω².
    pub s: f64,
    /// κ.
    pub kappa: f64,
    /// τ of iτG with Coriolis terms, else 0.
    pub turning: f64,
}

/// An upper bound of the number of negative directions of the form; `None` where the elements are too coarse
/// for a proof, or a pivot is too near 0.
pub fn index(assembly: &Assembly, form: Form) -> Option<usize> {
    let lowered =
        Form { alpha: form.alpha * (1.0 - ALLOWANCE), kappa: form.kappa - ALLOWANCE * form.kappa.abs(), ..form };
    let epsilon = assembly.elements.iter().map(|element| rest(element, lowered)).fold(0.0, maximum);
    if epsilon.is_nan() || epsilon >= 1.0 {
        return None;
    }
    if form.turning != 0.0 {
        return index_turning(assembly, lowered, SLACK / (1.0 - epsilon));
    }
    let mut forms = assembly.forms(lowered.alpha, lowered.s, lowered.kappa);
    for ((element, functions), form) in assembly.elements.iter().zip(&assembly.functions).zip(&mut forms) {
        form.add(-SLACK / (1.0 - epsilon), &untaken(element, functions, lowered)?);
    }
    Some(Factor::new(&assembly.elements, forms, &assembly.roots, lowered.alpha, false)?.negative())
}

/// The same of the Hermitian form α(K + F) + sC + κM + iτG, of whose untaken energy `share` is taken off.
fn index_turning(assembly: &Assembly, form: Form, share: f64) -> Option<usize> {
    let g = Gyroscopic::new(assembly);
    let mut forms = Vec::with_capacity(assembly.elements.len());
    let real = assembly.forms(form.alpha, form.s, form.kappa);
    for (index, (mut re, skew)) in real.into_iter().zip(g.matrices(assembly)).enumerate() {
        let (element, functions) = (&assembly.elements[index], &assembly.functions[index]);
        let mut im = Square::zero(re.order());
        im.add(form.turning, &skew);
        let still = left_over(element, functions, form, &still_loads(element, form), true)?;
        let moved = left_over(element, functions, form, &[(&g.couplings[index], form.turning)], false)?;
        for j in 0..re.order() {
            for i in 0..re.order() {
                *re.at_mut(i, j) -= share * (dot(&still[i], &still[j]) + dot(&moved[i], &moved[j]));
                *im.at_mut(i, j) -= share * (dot(&still[i], &moved[j]) - dot(&moved[i], &still[j]));
            }
        }
        forms.push(Hermitian { re, im });
    }
    negative(&assembly.elements, forms, &assembly.roots, form.alpha)
}

/// ε of an element: on the rest B ≥ −ε α K but for α K itself.
fn rest(element: &Element, Form { alpha, s, kappa, turning }: Form) -> f64 {
    let half = element.half;
    let bending = [element.orders[0], element.orders[1]].into_iter().filter(|order| *order > 0).min();
    // What the displacement and the rotation of a strain without its first b polynomials are at most.
    let (eta1, eta0) = match bending {
        Some(1) => return f64::INFINITY,
        Some(order) => {
            let b = order as f64;
            (half / sqrt(b * (b + 1.0)), half * half / (b * sqrt(b * b - 1.0)))
        }
        None => (0.0, 0.0),
    };
    let twist = element.orders[2] as f64;
    let eta_t = if element.moves(2) { half / sqrt(twist * (twist + 1.0)) } else { 0.0 };
    let largest = |value: fn(&CoupledSection) -> f64| element.sections.iter().map(value).fold(0.0, maximum);
    let least = |value: fn(&CoupledSection) -> f64| element.sections.iter().map(value).fold(f64::INFINITY, f64::min);
    let stiffness = alpha * least(|p| p.stiffness[0].min(p.stiffness[1]));
    let torsional = alpha * least(|p| p.stiffness[2]);
    let mass = largest(|p| p.mass);
    let moment = largest(|p| p.moment().abs());
    let arm = largest(|p| (p.moment() * p.r).abs());
    let offset = largest(|p| (p.tension * p.tension_offset).abs());
    let racket = largest(|p| p.racket().abs());
    let rotary = largest(|p| p.rotary * p.inertia[0].max(p.inertia[1]));
    let heaviest = largest(|p| p.inertia[0].max(p.inertia[1]));
    let turning = turning.abs();
    let twisting = |p: &CoupledSection| {
        -kappa * (p.inertia[0] + p.inertia[1])
            - s * (p.propeller() * p.double_angle().1 + p.torque_offset * p.moment() * p.angle.1)
    };
    let twisting = element.sections.iter().map(twisting).fold(0.0, maximum);
    let (sp, cp) = element.sections.first().map_or((0.0, 1.0), |p| p.precone);
    let (sp, product) = (sp.abs(), (sp * cp).abs());
    let p = eta0 * eta0 * (maximum(s - kappa, 0.0) + s * sp * sp) * mass
        + 2.0 * s * product * moment * eta0 * eta1
        + (maximum(-kappa, 0.0) + s * cp * cp) * rotary * eta1 * eta1
        + turning * (2.0 * sp * mass * eta0 * eta0 + 4.0 * cp * moment * eta0 * eta1);
    let q = eta_t
        * ((kappa * moment).abs() * eta0
            + s * (arm * eta1 + moment * eta0 + offset + sp * sp * moment * eta0 + product * racket * eta1)
            + 2.0 * turning * (sp * moment * eta0 + cp * heaviest * eta1));
    let z = eta_t * eta_t * (twisting + s * product * arm);
    // The top eigenvalue of [[p/D, q/√(DJ)], [q/√(DJ), z/J]]; what does not move has no part in it.
    let (p, q) = if bending.is_some() { (p / stiffness, q / sqrt(stiffness * torsional)) } else { (0.0, 0.0) };
    let (q, z) = if element.moves(2) { (q, z / torsional) } else { (0.0, 0.0) };
    BEYOND_POINTS * (0.5 * (p + z) + hypot(0.5 * (p - z), q))
}

/// E: the complementary energy of the residuals of the element's functions, less what the polynomials take up.
/// Trapeze counts as stiffness.
pub(super) fn untaken(element: &Element, functions: &Functions, form: Form) -> Option<Square> {
    let left = left_over(element, functions, form, &still_loads(element, form), true)?;
    let mut energy = Square::zero(left.len());
    for (j, row) in left.iter().enumerate() {
        for (i, other) in left.iter().enumerate().skip(j) {
            let value = dot(other, row);
            *energy.at_mut(i, j) = value;
            *energy.at_mut(j, i) = value;
        }
    }
    Some(energy)
}

/// What loads in sC + κM.
fn still_loads(element: &Element, form: Form) -> [(&Couplings, f64); 2] {
    [(element.couplings(Energy::Centrifugal), form.s), (element.couplings(Energy::Inertia), form.kappa)]
}

/// Moments of these loads on the element's functions, with or without those of their strains, less what the
/// polynomials take up, as rows whose squares sum to their energy.
fn left_over(
    element: &Element,
    functions: &Functions,
    form: Form,
    parts: &[(&Couplings, f64)],
    strained: bool,
) -> Option<Vec<Vec<f64>>> {
    let (points, count) = (element.points(), element.count());
    let mut flexibility = Flexibility::default();
    flexibility.push(element, form.alpha, form.s);
    let mut moments_of: [Vec<f64>; 3] = core::array::from_fn(|_| vec![0.0; points]);
    // The polynomials as moments of their own, orthonormal in the metric of the energy.
    let mut taken: Vec<Vec<f64>> = Vec::with_capacity(element.strains());
    for function in 0..element.strains() {
        for (moment, strain) in moments_of.iter_mut().zip(STRAIN_FIELDS) {
            match functions.field(function, strain) {
                Some(own) => moment.copy_from_slice(own),
                None => moment.fill(0.0),
            }
        }
        let mut row = Vec::with_capacity(3 * points);
        flexibility.scale(&moments_of, &mut row);
        let before = sqrt(dot(&row, &row));
        take_off(&mut row, &taken);
        take_off(&mut row, &taken);
        let length = sqrt(dot(&row, &row));
        if length <= NOTHING_LEFT * before {
            return None;
        }
        scale(&mut row, 1.0 / length);
        taken.push(row);
    }
    let mut left: Vec<Vec<f64>> = Vec::with_capacity(count);
    let mut loads: PointFields = core::array::from_fn(|_| vec![0.0; points]);
    for function in 0..count {
        for load in &mut loads {
            load.fill(0.0);
        }
        for (couplings, factor) in parts {
            add_loads(couplings, *factor, functions, function, &mut loads);
        }
        moments(element, &loads, 0, &mut [0.0; STATES], &mut moments_of);
        for strain in STRAIN_FIELDS {
            loads[strain].fill(0.0);
        }
        if strained {
            add_loads(element.couplings(Energy::Elastic), form.alpha, functions, function, &mut loads);
        }
        for (moment, strain) in moments_of.iter_mut().zip(STRAIN_FIELDS) {
            axpy(moment, 1.0, &loads[strain]);
        }
        let mut row = Vec::with_capacity(3 * points);
        flexibility.scale(&moments_of, &mut row);
        take_off(&mut row, &taken);
        left.push(row);
    }
    Some(left)
}

/// Adds `factor` times what a function loads each field with.
fn add_loads(couplings: &Couplings, factor: f64, functions: &Functions, function: usize, loads: &mut PointFields) {
    for (row, column, along) in &couplings.0 {
        if let Some(own) = functions.field(function, *column) {
            let parts = own.iter().zip(along).map(|(own, along)| factor * along * own);
            loads[*row].iter_mut().zip(parts).for_each(|(load, part)| *load += part);
        }
    }
}

/// Takes off what lies along orthonormal rows.
fn take_off(row: &mut [f64], taken: &[Vec<f64>]) {
    for known in taken {
        let along = dot(known, row);
        axpy(row, -along, known);
    }
}
