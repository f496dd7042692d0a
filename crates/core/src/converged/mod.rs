//! The converged answer: piecewise functions, as many as it takes.
//!
//! A blade has some hundred of them. Their lowest modes at a few speeds, found by inverse iteration
//! in time proportional to the number of elements, span a small space in which those of all other
//! speeds lie to far below the tolerance; so a few functions come out, with matrices like those of
//! any others. How good they are is measured by how far their modes are from equilibrium.

mod elements;
mod mesh;
mod space;

use crate::blade::Blade;
use crate::dof::Dof;
use crate::functions::{Deformation, MOST_ORDER, PiecewiseFunctions};
use crate::lagrange::{Fields, FromTip, Grid, SystemMatrices, assemble, moment_gaps};
use crate::numerics::chain::Chain;
use crate::numerics::eigen::{EigenError, lowest};
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::{ceil, ln, sqrt};
use alloc::vec;
use alloc::vec::Vec;
use elements::Elements;
use mesh::{Layout, first_layout};
use nalgebra::DMatrix;
use space::Space;

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
/// A direction with less than this beside those there are is left out.
const NOTHING_NEW: f64 = 1e-8;

/// The lowest modes of one degree of freedom over a range of rotor speeds, as a few functions.
#[derive(Clone, Debug)]
pub struct Converged {
    elements: Elements,
    found: Reduced,
    error: f64,
}

/// The few functions that came out.
#[derive(Clone, Debug)]
struct Reduced {
    /// Their strain coefficients; the rigid motion has none.
    coefficients: DMatrix<f64>,
    matrices: SystemMatrices,
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
        let chain = elements.factor(start).ok_or(EigenError::NotPositiveDefinite)?;
        let mut space = Space::new(&elements, start);
        space.push_turned_root(&chain, start);
        // One degree above the rigid motion, so that no symmetry hides a mode from it.
        let start: Vec<f64> = elements.grid().x().map(|x| if elements.torsion { x } else { x * x }).collect();
        space.push_start(&chain, &start);
        // Fewer for a range: its ends give theirs, too.
        let wanted = if range { 2 * count } else { 2 * count + 2 };
        let mut next = 0;
        while space.members() < wanted && next < space.members() {
            space.push_next(&chain, next);
            next += 1;
        }
        let from_tip = FromTip::new(elements.fine_grid(), rules);
        let (mut settled, mut last) = (SETTLED, f64::INFINITY);
        loop {
            for (index, share) in anchors.iter().enumerate() {
                let s = at(*share);
                let there;
                let chain = if index == 0 {
                    &chain
                } else {
                    there = elements.factor(s).ok_or(EigenError::NotPositiveDefinite)?;
                    &there
                };
                iterate(&mut space, chain, s, count, settled)?;
            }
            let found = Reduced::new(&elements, &space, anchors.iter().map(|share| at(*share)), count)?;
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
                drop(space);
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
        self.elements.mesh.count() + usize::from(self.elements.root_turns())
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
        let deformation = if self.elements.torsion { Deformation::Torsion } else { Deformation::Bending };
        let mesh = self.elements.mesh.clone();
        PiecewiseFunctions::new(mesh, deformation, self.elements.root_turns(), self.found.coefficients.clone())
    }
}

/// Rounds of inverse iteration at Ω² = `s`, until what they add is less than `settled` of the modes.
fn iterate(space: &mut Space, chain: &Chain, s: f64, count: usize, settled: f64) -> Result<(), EigenError> {
    for _ in 0..MOST_ITERATIONS {
        let found = space.ritz(s, count)?;
        let mut new = 0.0_f64;
        for (q, value) in found.vectors.column_iter().zip(&found.values) {
            // A rigid mode is exact.
            if *value > 0.0 {
                let motion = space.motion(q.as_slice());
                new = new.max(space.push_response(chain, &motion));
            }
        }
        if new < settled {
            break;
        }
    }
    Ok(())
}

impl Reduced {
    /// The span of the modes at these Ω².
    fn new(
        elements: &Elements,
        space: &Space,
        anchors: impl Iterator<Item = f64>,
        count: usize,
    ) -> Result<Self, EigenError> {
        let rigid = usize::from(elements.root_turns());
        let mut out: Vec<Vec<f64>> = Vec::new();
        for s in anchors {
            for q in space.ritz(s, count)?.vectors.column_iter() {
                add_direction(&mut out, q.as_slice()[rigid..].to_vec());
            }
        }
        let clamped = DMatrix::from_fn(space.len() - rigid, out.len(), |i, j| out[j][i]);
        let mut all = DMatrix::zeros(space.len(), out.len() + rigid);
        all.view_mut((rigid, rigid), clamped.shape()).copy_from(&clamped);
        if rigid == 1 {
            all[(0, 0)] = 1.0;
        }
        let matrices = assemble(elements.grid(), space.energies(), rigid == 1).reduced(&all);
        Ok(Self { coefficients: space.coefficients(&clamped), matrices })
    }

    /// The largest relative error of an eigenvalue at Ω² = `s`; raises the share of each element to
    /// the largest error that it is to blame for.
    fn check(
        &self,
        elements: &Elements,
        s: f64,
        count: usize,
        from_tip: &FromTip,
        shares: &mut [f64],
    ) -> Result<f64, EigenError> {
        let grid = elements.fine_grid();
        let shift = if grid.dof() == Dof::Lag { s } else { 0.0 };
        let g = self.matrices.stiffness() + self.matrices.centrifugal() * s + self.matrices.mass() * shift;
        let found = lowest(&g, self.matrices.mass(), count)?;
        let rigid = found.values.iter().take_while(|value| **value == 0.0).count();
        let gaps = moment_gaps(grid, from_tip, &self.fields(elements, &found.vectors), &found.values, rigid, s);
        let energies = gaps.energies(grid);
        let mut error = 0.0_f64;
        for (mode, value) in found.values.iter().enumerate().skip(rigid) {
            error = error.max(energies[(mode, mode)] * value);
            let column = gaps.moment.column(mode);
            for (cell, share) in grid.cells().iter().zip(shares.iter_mut()) {
                let own: f64 =
                    cell.points.clone().map(|k| grid.weight()[k] * column[k] * column[k] / grid.stiffness()[k]).sum();
                *share = share.max(own * value);
            }
        }
        Ok(error)
    }

    /// What sums of the functions that came out (columns of `coordinates`) do along the span.
    fn fields(&self, elements: &Elements, coordinates: &DMatrix<f64>) -> Fields {
        let rigid = usize::from(elements.root_turns());
        let points = elements.fine_grid().len();
        let n = coordinates.ncols();
        let mut fields = Fields {
            motion: DMatrix::zeros(points, n),
            turn: DMatrix::zeros(points, n),
            strain: DMatrix::zeros(points, n),
            root_turn: vec![0.0; n],
        };
        let rigid_motion = elements.fine_grid().rigid_motion();
        for (column, q) in coordinates.column_iter().enumerate() {
            let sum = &self.coefficients * q.rows(rigid, q.nrows() - rigid);
            let vector = elements.fields(sum.as_slice());
            let root_turn = if rigid == 1 { q[0] } else { 0.0 };
            fields.root_turn[column] = root_turn;
            let at = column * points..(column + 1) * points;
            for ((out, clamped), x) in
                fields.motion.as_mut_slice()[at.clone()].iter_mut().zip(&vector.motion).zip(&rigid_motion)
            {
                *out = clamped + root_turn * x;
            }
            for (out, clamped) in fields.turn.as_mut_slice()[at.clone()].iter_mut().zip(&vector.turn) {
                *out = clamped + root_turn;
            }
            fields.strain.as_mut_slice()[at].copy_from_slice(&vector.strain);
        }
        fields
    }
}

/// Adds what a direction has beside those there are, at unit length.
fn add_direction(out: &mut Vec<Vec<f64>>, mut direction: Vec<f64>) {
    let length = |v: &[f64]| sqrt(v.iter().map(|v| v * v).sum());
    let before = length(&direction);
    for _ in 0..2 {
        for known in out.iter() {
            let along: f64 = known.iter().zip(&direction).map(|(a, b)| a * b).sum();
            direction.iter_mut().zip(known).for_each(|(v, k)| *v -= along * k);
        }
    }
    let after = length(&direction);
    if after > NOTHING_NEW * before {
        out.push(direction.into_iter().map(|v| v / after).collect());
    }
}

/// Raises the orders of the elements that are to blame; false where nothing is left to raise.
fn raise(layout: &mut Layout, shares: &[f64]) -> bool {
    let fair = 0.1 * TOLERANCE / shares.len() as f64;
    let mut raised = false;
    for (order, share) in layout.orders.iter_mut().zip(shares) {
        if *share > fair && *order < MOST_ORDER {
            // Each order more takes off a factor of ten or so, fewer where the strain turns fast.
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to some tens")]
            let more = ceil(ln(*share / fair) / 4.0).clamp(1.0, 8.0) as usize;
            *order = (*order + more).min(MOST_ORDER);
            raised = true;
        }
    }
    raised
}

#[cfg(test)]
mod tests;
