//! The branches of one degree of freedom over a range of rotor speeds, as good at every speed as the
//! modes of that speed alone.

use super::Settings;
use super::basis::{Basis, solve};
use super::unsolvable;
use crate::blade::Blade;
use crate::converged::{Converged, MOST_FUNCTIONS, TOLERANCE, Wanted, Work};
use crate::dof::Dof;
use crate::fan::Curves;
use crate::fault::Fault;
use crate::modes::Mode;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::{maximum, pow};
use alloc::vec::Vec;

/// Most times the functions are made anew with more speeds among those that they are found at.
const MOST_ATTEMPTS: usize = 6;
/// Speeds that are added at a time.
const ADDED: usize = 3;
/// Speeds at which what the sums of products say is looked at closely, the worst first.
const LOOKED_AT: usize = 8;
/// Added Ω² keep apart by this part of the larger.
const APART: f64 = 0.05;

/// With more functions the eigenproblems of a fit are solved without vectors, and the error is looked at
/// in a few places.
const CHECKED_EVERYWHERE: usize = 60;
/// A fit may take one part in so many of what is left.
const SHARE_OF_A_FIT: f64 = 2.0;

/// Branches of one degree of freedom.
pub(super) struct Fitted {
    pub(super) basis: Basis,
    pub(super) at_rest: Vec<Mode>,
    pub(super) curves: Curves,
    /// Estimate of the largest relative error of an eigenvalue at any speed.
    pub(super) error: f64,
}

/// Fits the branches over `range` of Ω², which the Southwell coefficients at rest and nominal speed are
/// added to where `highest` is the larger of nominal speed and the range's end, squared.
pub(super) fn fitted(
    blade: &Blade,
    dof: Dof,
    settings: &Settings,
    range: (f64, f64),
    highest: f64,
    rules: &GaussRules,
) -> Result<Fitted, Vec<Fault>> {
    let mut also_at: Vec<f64> = Vec::new();
    let mut best: Option<Fitted> = None;
    let mut work = Work::default();
    for _ in 0..MOST_ATTEMPTS {
        let wanted = Wanted { range: (0.0, highest), count: settings.modes, also_at: &also_at };
        let basis = Basis::new(blade, dof, settings, &wanted, rules, &mut work)?;
        let at_rest = solve(basis.matrices(), 0.0, settings.modes)?;
        let Basis::Piecewise(converged) = &basis else {
            let curves = Curves::fit(basis.matrices(), &at_rest, range.0, range.1, work.left()).map_err(unsolvable)?;
            let error = curves.error();
            return Ok(Fitted { basis, at_rest, curves, error });
        };
        let most = work.left() / SHARE_OF_A_FIT;
        let solved = if basis.matrices().count() <= CHECKED_EVERYWHERE {
            let residuals = converged.residuals(rules);
            let error = |mode: &Mode, s: f64| residuals.error(mode.coordinates.as_slice(), mode.eigenvalue, s);
            Curves::fit_checked(basis.matrices(), &at_rest, range, most, error)
        } else {
            let curves = Curves::fit(basis.matrices(), &at_rest, range.0, range.1, most);
            curves.map(|curves| (curves, sample(range)))
        };
        let (curves, checked) = solved.map_err(unsolvable)?;
        work.spend(curves.work());
        let (worst, poor) = poor(converged, checked, settings.modes, rules)?;
        let error = maximum(maximum(basis.error(), curves.error()), worst);
        let known = also_at.len();
        also_at.extend(poor);
        let many = basis.matrices().count() + ADDED * settings.modes > MOST_FUNCTIONS;
        let enough = error <= TOLERANCE || also_at.len() == known || many || work.left() <= 0.0;
        if best.as_ref().is_none_or(|best| error < best.error || best.error.is_nan()) {
            best = Some(Fitted { basis, at_rest, curves, error });
        }
        if enough {
            break;
        }
    }
    // The first attempt is there at least.
    best.ok_or_else(Vec::new)
}

/// The largest error at the Ω² that were looked at, and where the functions are to be better.
fn poor(
    converged: &Converged,
    mut checked: Vec<(f64, f64)>,
    count: usize,
    rules: &GaussRules,
) -> Result<(f64, Vec<f64>), Vec<Fault>> {
    checked.retain(|(_, error)| !(*error <= TOLERANCE));
    checked.sort_by(|a, b| b.1.total_cmp(&a.1));
    let (mut worst, mut poor) = (0.0, Vec::<f64>::new());
    for (s, _) in checked.into_iter().take(LOOKED_AT) {
        // What is left of large sums may be rounding alone.
        let error = converged.error_at(s, count, rules).map_err(|cause| super::basis::failed(converged, cause))?;
        worst = maximum(worst, error);
        let apart = poor.iter().all(|other| (other - s).abs() > APART * other.max(s));
        if !(error <= TOLERANCE) && apart && poor.len() < ADDED {
            poor.push(s);
        }
    }
    Ok((worst, poor))
}

/// Ω² over a range, evenly on a logarithmic scale from a thousandth of its end, each to be looked at.
fn sample((from, to): (f64, f64)) -> Vec<(f64, f64)> {
    let low = from.max(1e-3 * to);
    let at = |i: usize| low * pow(to / low, i as f64 / (LOOKED_AT - 1) as f64);
    (0..LOOKED_AT).map(|i| (at(i).min(to), f64::INFINITY)).collect()
}
