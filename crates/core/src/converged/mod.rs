//! The converged answer: piecewise functions, as many as it takes.
//!
//! A blade has some hundred of them. Their lowest modes at a few speeds, found by inverse iteration
//! in time proportional to the number of elements, span a small subspace in which those of all other
//! speeds lie to far below the tolerance; so a few functions come out, with matrices like those of
//! any others. How good they are is measured by how far their modes are from equilibrium.

mod elements;
mod layout;
mod reduced;
mod refine;
mod subspace;

use crate::blade::Blade;
use crate::dof::Dof;
use crate::functions::{Deformation, PiecewiseFunctions};
use crate::lagrange::{Fields, FromTip, Grid, SystemMatrices};
use crate::numerics::eigen::EigenError;
use crate::numerics::quadrature::GaussRules;
use alloc::vec;
use alloc::vec::Vec;
use elements::{Elements, Factor};
use layout::first_layout;
use nalgebra::DMatrix;
use reduced::Reduced;
use refine::raise;
use subspace::Subspace;

/// Relative error of an eigenvalue that is aimed at.
pub const TOLERANCE: f64 = 1e-10;
/// Most times the orders are raised.
const MOST_ROUNDS: usize = 8;
/// Inverse iteration ends when the share of its vectors that is new falls below this; the error of
/// an eigenvalue is then below the square of it.
const SETTLED: f64 = 1e-3;
/// Iterating on is worthwhile while it leaves less than this of the error.
const WORTHWHILE: f64 = 0.3;
/// Most rounds of inverse iteration at one speed.
const MOST_ITERATIONS: usize = 8;
/// Where the modes are sought first, and then, as shares of the range of Ω².
const ANCHORS: [f64; 6] = [0.5, 0.0, 1.0, 0.25, 0.75, 0.06];
/// So many of them at first.
const FIRST_ANCHORS: usize = 3;
/// Where the answer is checked besides, as shares of the range of Ω².
const CHECKS: [f64; 2] = [1.0, 0.2];

/// The lowest modes of one degree of freedom over a range of rotor speeds, as a few functions.
#[derive(Clone, Debug)]
pub struct Converged {
    elements: Elements,
    found: Reduced,
    error: f64,
}

impl Converged {
    /// Functions for the `count` lowest modes at every `from` ≤ Ω² ≤ `to` [rad²/s²].
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn new(
        blade: &Blade,
        dof: Dof,
        (from, to): (f64, f64),
        count: usize,
        rules: &GaussRules,
    ) -> Result<Self, EigenError> {
        let mut layout = first_layout(blade, dof, to, count);
        let mut last: Option<Self> = None;
        for _ in 0..MOST_ROUNDS {
            let elements = Elements::new(blade, dof, &layout, rules);
            let (found, shares) = Self::on(elements, (from, to), count, rules)?;
            let best = last.as_ref().is_none_or(|last| found.error < last.error);
            let error = found.error;
            if best {
                last = Some(found);
            }
            if error <= TOLERANCE || !raise(&mut layout, &shares) {
                break;
            }
        }
        last.ok_or(EigenError::NotConverged)
    }

    /// The same on given elements of `order` polynomials each: how fast the family converges.
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn with_order(
        blade: &Blade,
        dof: Dof,
        speed_squared: f64,
        count: usize,
        order: usize,
        rules: &GaussRules,
    ) -> Result<Self, EigenError> {
        let mut layout = first_layout(blade, dof, speed_squared, count);
        layout.orders.fill(order);
        let elements = Elements::new(blade, dof, &layout, rules);
        Ok(Self::on(elements, (speed_squared, speed_squared), count, rules)?.0)
    }

    /// Inverse iteration on one mesh; with the largest share that each element has in the errors.
    fn on(
        elements: Elements,
        (from, to): (f64, f64),
        count: usize,
        rules: &GaussRules,
    ) -> Result<(Self, Vec<f64>), EigenError> {
        let range = to > from;
        let at = |share: f64| if range { from + share * (to - from) } else { to };
        let mut anchors = if range { &ANCHORS[..FIRST_ANCHORS] } else { &ANCHORS[..1] };
        let start = at(ANCHORS[0]);
        let factor = elements.factor(start).ok_or(EigenError::NotPositiveDefinite)?;
        let mut subspace = Subspace::new(&elements, start);
        subspace.push_rotated_root(&factor, start);
        // One degree above the rigid motion, so that no symmetry hides a mode from it.
        let deformation = elements.grid().deformation();
        let start: Vec<f64> =
            elements.grid().x().map(|x| if deformation == Deformation::Torsion { x } else { x * x }).collect();
        subspace.push_start(&factor, &start);
        // Fewer for a range: its ends give theirs, too.
        let wanted = if range { 2 * count } else { 2 * count + 2 };
        let mut next = 0;
        while subspace.members() < wanted && next < subspace.members() {
            subspace.push_next(&factor, next);
            next += 1;
        }
        let from_tip = FromTip::new(elements.fine_grid(), rules);
        let (mut settled, mut last) = (SETTLED, f64::INFINITY);
        loop {
            for (index, share) in anchors.iter().enumerate() {
                let s = at(*share);
                let there;
                let factor = if index == 0 {
                    &factor
                } else {
                    there = elements.factor(s).ok_or(EigenError::NotPositiveDefinite)?;
                    &there
                };
                iterate(&mut subspace, factor, s, count, settled)?;
            }
            let found = Reduced::new(&elements, &subspace, anchors.iter().map(|share| at(*share)), count)?;
            let mut error = 0.0_f64;
            let mut shares = vec![0.0; elements.mesh.orders().len()];
            for share in if range { &CHECKS[..] } else { &CHECKS[..1] } {
                error = error.max(found.check(&elements, at(*share), count, &from_tip, &mut shares)?);
            }
            let helped = error <= WORTHWHILE * last;
            if error > TOLERANCE && !helped && anchors.len() == FIRST_ANCHORS {
                anchors = &ANCHORS;
                last = f64::INFINITY;
            } else if error <= TOLERANCE || !helped {
                // Where neither iterating on nor more speeds help, the elements are to blame.
                drop(subspace);
                return Ok((Self { elements, found, error }, shares));
            } else {
                last = error;
            }
            settled *= 0.01;
        }
    }

    /// The matrices of the functions that came out.
    pub fn matrices(&self) -> &SystemMatrices {
        &self.found.matrices
    }

    /// How many piecewise functions the answer is made of.
    pub fn count(&self) -> usize {
        self.elements.mesh.count() + usize::from(self.elements.root_rotates())
    }

    /// Estimate of the largest relative error of an eigenvalue; above [`TOLERANCE`] where that was
    /// not reached.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// The points at which [`fields`](Self::fields) stand.
    pub fn grid(&self) -> &Grid {
        self.elements.fine_grid()
    }

    /// What sums of the functions that came out (columns of `coordinates`) do along the span.
    pub fn fields(&self, coordinates: &DMatrix<f64>) -> Fields {
        self.found.fields(&self.elements, coordinates)
    }

    /// The functions themselves.
    pub fn functions(&self) -> PiecewiseFunctions {
        let deformation = self.elements.grid().deformation();
        let mesh = self.elements.mesh.clone();
        PiecewiseFunctions::new(mesh, deformation, self.elements.root_rotates(), self.found.coefficients.clone())
    }
}

/// Rounds of inverse iteration at Ω² = `s`, until what they add is less than `settled` of the modes.
fn iterate(subspace: &mut Subspace, factor: &Factor, s: f64, count: usize, settled: f64) -> Result<(), EigenError> {
    for _ in 0..MOST_ITERATIONS {
        let found = subspace.ritz(s, count)?;
        let mut new = 0.0_f64;
        for (q, value) in found.vectors.column_iter().zip(&found.values) {
            // A rigid mode is exact.
            if *value > 0.0 {
                let displacement = subspace.displacement(q.as_slice());
                new = new.max(subspace.push_response(factor, &displacement));
            }
        }
        if new < settled {
            break;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
