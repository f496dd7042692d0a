//! Coupled flap, lag and torsion: one system of equations along the blade (docs/THEORY.md).
//!
//! The functions are the piecewise ones of every strain on one mesh. Inverse iteration runs along the blade, in
//! time proportional to its elements; eigenvalues are those of the modes' own fields, and bounds follow from the
//! modes' equilibrium and a proof of their number.

mod along;
mod assembly;
mod blade;
mod bounds;
mod certificate;
mod classical;
mod element;
mod elimination;
mod equilibrium;
mod from_blade;
mod gyroscopic;
mod hermitian;
mod krylov;
mod layout;
mod range;
mod reduced;
mod sample;
mod shares;
mod terms;

pub use blade::CoupledBlade;
pub use bounds::Missing;
pub use classical::{Classical, Functions};
pub use from_blade::{Impossible, Options};
pub use gyroscopic::modes as turning_modes;
pub use range::{Bounded, Range, RangeMode};
pub use sample::Sample;

use crate::numerics::eigen::{EigenError, lowest};
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::maximum;
use alloc::vec;
use alloc::vec::Vec;
use assembly::{Assembly, Vector, sum};
use bounds::{Proof, lower_bounds, prove, rounding, settle_free};
use equilibrium::{ModeFields, OwnEnergies, energies, own_energies, residuals};
use layout::{Layout, MOST_ORDER, first_layout, raise};
use nalgebra::DMatrix;

/// Modes beyond those asked for, among which a separation is sought.
const BEYOND: usize = 6;
/// Relative error of an eigenvalue to be reached.
pub const TOLERANCE: f64 = 1e-11;
/// Most meshes tried.
const MOST_ROUNDS: usize = 4;
/// Share of the tolerance from which on an element is to blame.
const SHARE: f64 = 0.03;
/// Errors of eigenvalues below this share of the highest are measured against that share.
const FLOOR: f64 = 1e-4;
/// First shift, as a share of the highest eigenvalue, and how it grows until the form is definite. A smaller one
/// would drown all but rigid modes in rounding.
const SHIFT: (f64, f64) = (1e-4, 8.0);
/// Most shifts tried.
const MOST_SHIFTS: usize = 40;

/// Most polynomials of a strain with which a proof is tried first.
const ORDER_OF_PROOFS: usize = 5;

/// One mode of a coupled blade.
#[derive(Clone, Debug)]
pub struct CoupledMode {
    /// λ = ω² [rad²/s²], negative where unstable.
    pub eigenvalue: f64,
    /// Estimate of its error [rad²/s²]: the energy of the residual moments.
    pub error: f64,
    /// Proven bounds of λ [rad²/s²].
    pub bounds: Option<(f64, f64)>,
    /// Shares of flap, lag and torsion in its kinetic energy about the mass centre, in sum 1.
    pub shares: [f64; 3],
}

/// What was proven of a blade at one speed, whatever the functions.
#[derive(Clone, Debug)]
pub struct Proven {
    proof: Proof,
    /// Lower bounds of the eigenvalues below ρ [rad²/s²].
    lower: Vec<f64>,
}

/// The lowest modes of a coupled blade at one speed.
#[derive(Clone, Debug)]
pub struct CoupledModes {
    /// Ascending.
    pub modes: Vec<CoupledMode>,
    /// ρ of the bounds [rad²/s²], or why there are none.
    pub separation: Result<f64, Missing>,
    /// The same for functions of any kind.
    pub proven: Option<Proven>,
    /// Number of functions of flap, lag and torsion.
    pub functions: [usize; 3],
}

/// The `count` lowest modes at Ω² = s.
///
/// # Errors
/// [`EigenError`].
pub fn modes(blade: &CoupledBlade, s: f64, count: usize, rules: &GaussRules) -> Result<CoupledModes, EigenError> {
    let (layout, assembly, solved) = converged(blade, s, count, rules)?;
    Ok(solved.bounded(blade, &assembly, s, count, &layout, rules))
}

/// The modes on elements and orders that are good enough for them, or the best there are.
fn converged(
    blade: &CoupledBlade,
    s: f64,
    count: usize,
    rules: &GaussRules,
) -> Result<(Layout, Assembly, Solved), EigenError> {
    let mut layout = first_layout(blade, s, count + BEYOND);
    let mut best: Option<(Layout, Assembly, Solved)> = None;
    for _ in 0..MOST_ROUNDS {
        let known = best.as_ref().map(|(_, assembly, _)| assembly);
        let (assembly, solved) = solve(blade, &layout, s, (count, BEYOND), rules, known)?;
        let (worst, shares) = (solved.worst, solved.shares.clone());
        if best.as_ref().is_none_or(|(.., best)| worst < best.worst) {
            best = Some((layout.clone(), assembly, solved));
        }
        if worst <= TOLERANCE || !raise(&mut layout, &shares, TOLERANCE * SHARE) {
            break;
        }
    }
    best.ok_or(EigenError::NotConverged)
}

/// λ of the `count` lowest modes at Ω² = s with one polynomial of every strain on each element, two, three, … until
/// they are converged, each with the number of functions.
///
/// # Errors
/// [`EigenError`].
pub fn steps(
    blade: &CoupledBlade,
    s: f64,
    count: usize,
    rules: &GaussRules,
) -> Result<Vec<(usize, Vec<f64>)>, EigenError> {
    let first = first_layout(blade, s, count + BEYOND);
    let mut steps = Vec::new();
    for order in 1..=MOST_ORDER {
        let layout = Layout { orders: vec![[order; 3]; first.orders.len()], ..first.clone() };
        let (assembly, solved) = solve(blade, &layout, s, (count, BEYOND), rules, None)?;
        let values = solved.values[..count.min(solved.values.len())].to_vec();
        steps.push((assembly.unknowns_by_motion().iter().sum(), values));
        if solved.worst <= TOLERANCE {
            break;
        }
    }
    Ok(steps)
}

/// The lowest modes at Ω² = s with their shapes at ascending radii, of unit inertia.
///
/// # Errors
/// [`EigenError`].
pub fn shapes(
    blade: &CoupledBlade,
    s: f64,
    count: usize,
    radii: &[f64],
    rules: &GaussRules,
) -> Result<(CoupledModes, Vec<Vec<Sample>>), EigenError> {
    let (layout, assembly, solved) = converged(blade, s, count, rules)?;
    let stretches = blade.stretches(&layout.radii);
    let modes = &solved.modes[..count.min(solved.modes.len())];
    let fields = ModeFields::new(&assembly, modes);
    let at = |mode: usize, element: usize, r: f64| {
        sample::fields_at(&assembly.elements[element], &modes[mode][assembly.part(element)], r)
    };
    let samples = sample::sample(&assembly, &stretches, (&fields, &at), &solved.values, s, radii);
    Ok((solved.bounded(blade, &assembly, s, count, &layout, rules), samples))
}

/// Modes with all that their bounds need.
struct Solved {
    /// Of unit inertia.
    modes: Vec<Vector>,
    values: Vec<f64>,
    fields: ModeFields,
    energies: Vec<OwnEnergies>,
    /// Energies of the residual moments.
    gaps: DMatrix<f64>,
    /// The largest share of each element in the relative errors.
    shares: Vec<f64>,
    /// The largest relative error of the modes asked for.
    worst: f64,
}

impl Solved {
    /// From functions that span the modes at Ω² = s; `beyond` of them are not accounted for.
    fn new(
        blade: &CoupledBlade,
        assembly: &Assembly,
        found: &[Vector],
        (s, sigma): (f64, f64),
        beyond: usize,
    ) -> Result<Self, EigenError> {
        let fields = ModeFields::new(assembly, found);
        let raw = energies(assembly, &fields);
        // Ritz vectors of the shifted problem, and then the quotients of their own fields, which know no shift.
        let shifted = &raw.elastic + &raw.centrifugal * s + &raw.inertia * sigma;
        let ritz = lowest(&shifted, &raw.inertia, found.len())?;
        let modes: Vec<Vector> = ritz.vectors.column_iter().map(|parts| sum(found, parts.as_slice())).collect();
        let fields = ModeFields::new(assembly, &modes);
        let energies = own_energies(assembly, &fields);
        let values: Vec<f64> = energies.iter().map(|own| own.quotient(s)).collect();
        let residuals = residuals(blade, assembly, &fields, &values, s);
        let gaps = residuals.energies();
        let floor = FLOOR * values.last().map_or(0.0, |v| v.abs());
        let relative: Vec<f64> = values.iter().map(|value| 1.0 / value.abs().max(floor)).collect();
        let shares = residuals.shares(assembly, &relative);
        let worst = (0..relative.len().saturating_sub(beyond)).map(|i| gaps[(i, i)] * relative[i]).fold(0.0, maximum);
        Ok(Self { modes, values, fields, energies, gaps, shares, worst })
    }

    fn bounded(
        self,
        blade: &CoupledBlade,
        assembly: &Assembly,
        s: f64,
        count: usize,
        layout: &Layout,
        rules: &GaussRules,
    ) -> CoupledModes {
        let count = count.min(self.values.len());
        // What is proven holds for the blade whatever the functions; few of them are often enough.
        let coarse = layout.with_orders_up_to(ORDER_OF_PROOFS);
        let coarse = Assembly::new(blade, &coarse, rules, Some(assembly));
        let proof = prove(&coarse, &self.values, count, s).or_else(|_| prove(assembly, &self.values, count, s));
        let lower = proof.ok().and_then(|proof| {
            let below = proof.below;
            let gaps = self.gaps.view((0, 0), (below, below)).into_owned();
            lower_bounds(&self.values[..below], &gaps, &proof)
        });
        let separation = match (proof, &lower) {
            (Err(missing), _) => Err(missing),
            (Ok(_), None) => Err(Missing::Shift),
            (Ok(proof), Some(_)) => Ok(proof.rho),
        };
        let rounding = rounding(&self.energies, &self.values, s, proof.map_or(0.0, |proof| proof.sigma));
        let interval =
            |(i, lower): (usize, f64)| (lower.min(self.values[i]) - rounding[i], self.values[i] + rounding[i]);
        let mut intervals: Vec<(f64, f64)> = lower.into_iter().flatten().enumerate().map(interval).collect();
        settle_free(&mut intervals, blade.free_motions(s));
        let mode = |i: usize| CoupledMode {
            eigenvalue: if intervals.get(i) == Some(&(0.0, 0.0)) { 0.0 } else { self.values[i] },
            error: self.gaps[(i, i)],
            bounds: intervals.get(i).copied(),
            shares: shares::own_shares(assembly, &self.fields, i),
        };
        let known = proof.ok().filter(|proof| intervals.len() == proof.below);
        let proven = known.map(|proof| Proven { proof, lower: intervals.iter().map(|(lower, _)| *lower).collect() });
        CoupledModes {
            modes: (0..count).map(mode).collect(),
            separation,
            proven,
            functions: assembly.unknowns_by_motion(),
        }
    }
}

fn solve(
    blade: &CoupledBlade,
    layout: &Layout,
    s: f64,
    (count, beyond): (usize, usize),
    rules: &GaussRules,
    known: Option<&Assembly>,
) -> Result<(Assembly, Solved), EigenError> {
    let assembly = Assembly::new(blade, layout, rules, known);
    let (found, sigma) = iterate(&assembly, s, (count, beyond), SHIFT.0 * layout.highest)?;
    let solved = Solved::new(blade, &assembly, &found, (s, sigma), beyond)?;
    Ok((assembly, solved))
}

/// Modes by inverse iteration, and the shift, at least this, that leaves the form definite.
fn iterate(
    assembly: &Assembly,
    s: f64,
    (count, beyond): (usize, usize),
    mut sigma: f64,
) -> Result<(Vec<Vector>, f64), EigenError> {
    for _ in 0..MOST_SHIFTS {
        if let Some(factor) = assembly.factor(s, sigma) {
            let found = krylov::lowest(assembly, &factor, count, beyond).ok_or(EigenError::NotConverged)?;
            return Ok((found, sigma));
        }
        sigma *= SHIFT.1;
    }
    Err(EigenError::NotPositiveDefinite)
}

#[cfg(test)]
mod tests;
