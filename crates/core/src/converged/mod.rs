//! The converged answer: piecewise functions, as many as it takes.
//!
//! A blade has some hundred of them. Their lowest modes at a few speeds, found by inverse iteration
//! in time proportional to the number of elements, span a small subspace in which those of all other
//! speeds lie to far below the tolerance; so a few functions come out, with matrices like those of
//! any others. How good they are is measured by how far their modes are from equilibrium.

mod count;
mod elements;
mod layout;
mod reduced;
mod refine;
mod subspace;
mod work;

use crate::blade::Blade;
use crate::dof::Dof;
use crate::functions::PiecewiseFunctions;
use crate::lagrange::{Fields, FromTip, Grid, SystemMatrices};
use crate::numerics::eigen::EigenError;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::sqrt;
use alloc::vec::Vec;
use elements::{Elements, Factor};
use layout::first_layout;
pub(crate) use layout::{Piece, cuts, order, rates};
use nalgebra::DMatrix;
use reduced::{Checked, Reduced};
use refine::raise;
use subspace::Subspace;
pub use work::Work;

/// Relative error of an eigenvalue that is aimed at.
pub const TOLERANCE: f64 = 1e-10;
/// Most times the orders are raised.
const MOST_ROUNDS: usize = 8;
/// Inverse iteration ends when the share of its vectors that is new falls below this; the error of
/// an eigenvalue is then below the square of it.
const SETTLED: f64 = 1e-3;
/// The same where the iteration is not taken up again.
const SETTLED_AT_ONCE: f64 = 1e-5;
/// Iterating on is worthwhile while it leaves less than this of the error.
const WORTHWHILE: f64 = 0.3;
/// Another round costs this much of the last one.
const ONCE_MORE: f64 = 1.5;
/// Most rounds of inverse iteration at one speed.
const MOST_ITERATIONS: usize = 8;
/// Where the modes are sought first, and then, as shares of the range of Ω².
const ANCHORS: [f64; 6] = [0.5, 0.0, 1.0, 0.25, 0.75, 0.06];
/// So many of them at first.
const FIRST_ANCHORS: usize = 3;
/// A few more speeds make nothing of an error above this.
const TOO_WIDE: f64 = 1e-5;
/// Ω² that differ by less than this of them are one.
const SAME: f64 = 1e-6;
/// Most functions that may come out of a range: a chart solves dense problems of that order.
pub const MOST_FUNCTIONS: usize = 200;
/// Where the answer is checked besides, as shares of the range of Ω²: half way in rotor speed between the first
/// two anchors, and at the end.
const CHECKS: [f64; 2] = [0.125, 1.0];
/// How far below the last eigenvalue found the others are counted, as shares of it, one after the
/// other until a count is certain.
const COUNTED_BELOW: [f64; 3] = [1e-7, 1e-6, 1e-5];
/// So many elements are each given a load of its own where the iteration has missed a mode, once,
/// and once more.
const LOADED_ELEMENTS: [usize; 2] = [16, 64];
/// The lowest modes of one degree of freedom over a range of rotor speeds, as a few functions.
#[derive(Clone, Debug)]
pub struct Converged {
    elements: Elements,
    found: Reduced,
    error: f64,
    counted: Option<f64>,
    /// Ω² of the speeds whose modes the functions are, and of those at which these were checked.
    anchors: Vec<f64>,
    checked: Vec<f64>,
    from_tip: FromTip,
}

/// What is asked of the functions.
#[derive(Clone, Copy, Debug)]
pub struct Wanted<'a> {
    /// From and to Ω² [rad²/s²].
    pub range: (f64, f64),
    /// Modes, from the lowest.
    pub count: usize,
    /// Further Ω² in the range at which the functions are to be as good as anywhere.
    pub also_at: &'a [f64],
}

impl Wanted<'_> {
    /// At one speed.
    pub const fn at(speed_squared: f64, count: usize) -> Self {
        Self { range: (speed_squared, speed_squared), count, also_at: &[] }
    }

    fn is_range(&self) -> bool {
        self.range.1 > self.range.0
    }

    /// Whether an error is so large that the modes are to be sought at many more speeds.
    fn is_too_wide(&self, error: f64) -> bool {
        self.is_range() && self.also_at.is_empty() && error > TOO_WIDE
    }

    /// How many anchors and functions there may be in the end.
    fn most(&self) -> (usize, usize) {
        let anchors = self.anchors(true).len();
        (anchors, anchors * self.count + 1)
    }

    /// Ω² at a share of the range.
    fn share(&self, share: f64) -> f64 {
        let (from, to) = self.range;
        if self.is_range() { from + share * (to - from) } else { to }
    }

    /// Where modes are sought: at first, or at all.
    fn anchors(&self, all: bool) -> Vec<f64> {
        let shares = match (self.is_range(), all) {
            (false, _) => &ANCHORS[..1],
            (true, false) => &ANCHORS[..FIRST_ANCHORS],
            (true, true) => &ANCHORS[..],
        };
        shares.iter().map(|share| self.share(*share)).chain(self.also_at.iter().copied()).collect()
    }

    /// Where the answer is checked.
    fn checks(&self) -> Vec<f64> {
        let shares = if self.is_range() { &CHECKS[..] } else { &CHECKS[1..] };
        // Modes at the further speeds turn no faster than those at the end.
        let further = self.also_at.iter().copied().step_by(self.also_at.len() / 4 + 1);
        further.chain(shares.iter().map(|share| self.share(*share))).collect()
    }
}

impl Converged {
    /// The functions for what is wanted.
    ///
    /// # Errors
    /// [`EigenError`].
    pub fn new(blade: &Blade, dof: Dof, wanted: &Wanted, rules: &GaussRules, work: &Work) -> Result<Self, EigenError> {
        let mut layout = first_layout(blade, dof, wanted.range.1, wanted.count);
        let mut last: Option<Self> = None;
        for _ in 0..MOST_ROUNDS {
            let before = work.left();
            let elements = Elements::new(blade, dof, &layout, rules);
            work.spend(elements.effort().setup);
            let made = if wanted.also_at.is_empty() {
                Self::on(elements, wanted, rules, true, work)
            } else {
                Self::at_each(elements, wanted, rules, work)
            };
            let (mut found, shares) = match made {
                Ok(found) => found,
                // A coarser answer is better than none.
                Err(_) if last.is_some() => break,
                Err(error) => return Err(error),
            };
            if !layout.resolved {
                found.counted = None;
            }
            let error = found.error;
            // Where more polynomials do not help, it is speeds that are missing.
            let helped = last.as_ref().is_none_or(|last| error <= WORTHWHILE * last.error);
            if last.as_ref().is_none_or(|last| error < last.error) {
                last = Some(found);
            }
            let idle = wanted.is_range() && (!helped || wanted.is_too_wide(error));
            let affordable = ONCE_MORE * (before - work.left()) < work.left();
            if error <= TOLERANCE || idle || !affordable || !raise(&mut layout, &shares) {
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
        work: &Work,
    ) -> Result<Self, EigenError> {
        let mut layout = first_layout(blade, dof, speed_squared, count);
        layout.orders.fill(order);
        let elements = Elements::new(blade, dof, &layout, rules);
        Ok(Self::on(elements, &Wanted::at(speed_squared, count), rules, false, work)?.0)
    }

    /// Inverse iteration on one mesh; with the largest share that each element has in the errors.
    /// Where `counts`, it is held against the count of eigenvalues. Takes off `work` what it took.
    fn on(
        elements: Elements,
        wanted: &Wanted,
        rules: &GaussRules,
        counts: bool,
        work: &Work,
    ) -> Result<(Self, Vec<f64>), EigenError> {
        let count = wanted.count;
        let mut anchors = wanted.anchors(false);
        let start = anchors[0];
        let factor = elements.factor(start).ok_or(EigenError::NotPositiveDefinite)?;
        let mut subspace = Subspace::new(&elements, start, wanted, work);
        subspace.start(&factor, start, if wanted.is_range() { 2 * count } else { 2 * count + 2 });
        let from_tip = FromTip::new(elements.fine_grid(), rules);
        let (mut settled, mut last) = (SETTLED, f64::INFINITY);
        let (mut widened, mut loads) = (false, LOADED_ELEMENTS.iter());
        loop {
            for (index, &s) in anchors.iter().enumerate() {
                if index > 0 && subspace.is_exhausted() {
                    break;
                }
                let there;
                let factor = if index == 0 {
                    &factor
                } else {
                    there = elements.factor(s).ok_or(EigenError::NotPositiveDefinite)?;
                    work.spend(elements.effort().factor);
                    &there
                };
                iterate(&mut subspace, factor, s, count, settled)?;
            }
            let found = Reduced::new(&elements, &subspace, &anchors, count)?;
            work.spend(elements.effort().reduction(subspace.len(), found.matrices.count()));
            let Checked { error, values, shares } = found.checked(&elements, wanted, &from_tip, work)?;
            let helped = error <= WORTHWHILE * last && !subspace.is_exhausted();
            let many = count * ANCHORS.len() > MOST_FUNCTIONS;
            let wider = wanted.is_range() && !wanted.is_too_wide(error) && !widened && !many;
            if error > TOLERANCE && !helped && wider && !subspace.is_exhausted() {
                (anchors, widened) = (wanted.anchors(true), true);
                last = f64::INFINITY;
            } else if error <= TOLERANCE || !helped {
                // Where neither iterating on nor more speeds help, the elements are to blame, unless a
                // mode was missed.
                let counted = if counts { counted(&elements, &values, wanted.range.1, error, work) } else { None };
                let again = counts && counted.is_none() && !subspace.is_exhausted();
                if let Some(loaded) = loads.next().filter(|_| again) {
                    subspace.push_loads(&factor, *loaded);
                    (settled, last) = (SETTLED, f64::INFINITY);
                    continue;
                }
                drop(subspace);
                return Ok((
                    Self { elements, found, error, counted, anchors, checked: wanted.checks(), from_tip },
                    shares,
                ));
            } else {
                last = error;
            }
            settled *= 0.01;
        }
    }

    /// The same where many speeds are wanted: the modes of each are found by themselves, in time proportional to
    /// the number of speeds.
    fn at_each(
        elements: Elements,
        wanted: &Wanted,
        rules: &GaussRules,
        work: &Work,
    ) -> Result<(Self, Vec<f64>), EigenError> {
        let mut anchors = wanted.anchors(false);
        anchors.sort_by(f64::total_cmp);
        anchors.dedup();
        let from_tip = FromTip::new(elements.fine_grid(), rules);
        let mut loads = LOADED_ELEMENTS.iter();
        let mut loaded = None;
        loop {
            let mut modes = Vec::new();
            for &s in &anchors {
                let factor = elements.factor(s).ok_or(EigenError::NotPositiveDefinite)?;
                work.spend(elements.effort().factor);
                let mut subspace = Subspace::new(&elements, s, &Wanted::at(s, wanted.count), work);
                subspace.start(&factor, s, 2 * wanted.count + 2);
                if let Some(loaded) = loaded {
                    subspace.push_loads(&factor, loaded);
                }
                iterate(&mut subspace, &factor, s, wanted.count, SETTLED_AT_ONCE)?;
                modes.append(&mut subspace.modes(s, wanted.count)?);
            }
            let middle = anchors[anchors.len() / 2];
            let mut all = Subspace::new(&elements, middle, &Wanted::at(middle, modes.len()), work);
            for mode in modes {
                all.push(mode);
            }
            let found = Reduced::whole(&elements, &all);
            let Checked { error, values, shares } = found.checked(&elements, wanted, &from_tip, work)?;
            let counted = counted(&elements, &values, wanted.range.1, error, work);
            if counted.is_none() && work.left() > 0.0 {
                loaded = loads.next().copied();
                if loaded.is_some() {
                    continue;
                }
            }
            drop(all);
            return Ok((Self { elements, found, error, counted, anchors, checked: wanted.checks(), from_tip }, shares));
        }
    }

    /// How near below the last eigenvalue, as a share of it, no other was missed: so many were counted,
    /// without the iteration that found them. `None` where the counts differ or are uncertain.
    pub fn counted(&self) -> Option<f64> {
        self.counted
    }

    /// Eigenvalues below a number among all sums of the piecewise functions; `None` where rounding
    /// leaves the count uncertain.
    #[cfg(test)]
    fn count_below(&self, eigenvalue: f64, speed_squared: f64) -> Option<usize> {
        count::below(&self.elements, eigenvalue, speed_squared)
    }

    /// The largest relative error of the eigenvalues `values` of modes with these coordinates (one column each)
    /// at Ω² = `speed_squared`.
    pub fn error_of(&self, coordinates: &DMatrix<f64>, values: &[f64], speed_squared: f64, work: &Work) -> f64 {
        work.spend(self.elements.effort().moments(self.found.matrices.count(), values.len()));
        self.found.error_of(&self.elements, coordinates, values, speed_squared, &self.from_tip)
    }

    /// About what it takes to find the modes of so many speeds on these elements.
    pub fn work_for(&self, speeds: usize, count: usize) -> f64 {
        self.elements.effort().at_each(speeds, count)
    }

    /// The Ω² half way, in rotor speed, between those whose modes the functions are, but for those at which
    /// these were checked: their errors are among [`error`](Self::error).
    pub fn between(&self) -> Vec<f64> {
        let mut anchors = self.anchors.clone();
        anchors.sort_by(f64::total_cmp);
        anchors.dedup();
        let between = anchors.windows(2).map(|pair| half_way(pair[0], pair[1]));
        between.filter(|s| !self.checked.iter().any(|checked| (checked - s).abs() <= SAME * s)).collect()
    }

    /// Integration from the tip over [`grid`](Self::grid).
    pub fn integration(&self) -> &FromTip {
        &self.from_tip
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

/// The Ω² half way in rotor speed between two.
pub fn half_way(from: f64, to: f64) -> f64 {
    let speed = 0.5 * (sqrt(from) + sqrt(to));
    speed * speed
}

/// How far below the last of the eigenvalues found at Ω² = `s` (without the shift of lag), as a share of it, as
/// many were counted as were found. The share allows for their relative error.
fn counted(elements: &Elements, found: &[f64], s: f64, error: f64, work: &Work) -> Option<f64> {
    let Some(last) = found.last().filter(|last| **last > 0.0) else { return Some(0.0) };
    let shift = elements.grid().system().shift(s);
    for share in COUNTED_BELOW {
        let share = share.max(10.0 * error);
        let below = last * (1.0 - share);
        work.spend(elements.effort().count);
        if let Some(counted) = count::below(elements, below - shift, s) {
            let same = counted == found.iter().filter(|value| **value < below).count();
            return same.then_some(share);
        }
    }
    None
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
        if new < settled || subspace.is_exhausted() {
            break;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
