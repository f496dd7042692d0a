//! The branches of one degree of freedom over a range of rotor speeds, as good at every speed as the
//! modes of that speed alone.

use super::Settings;
use super::basis::{Basis, solve};
use super::unsolvable;
use crate::blade::Blade;
use crate::converged::{Converged, MOST_FUNCTIONS, TOLERANCE, Wanted, Work};
use crate::dof::Dof;
use crate::fan::{Checked, Curves, sample};
use crate::fault::Faults;
use crate::modes::Mode;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::{is_above, maximum};
use alloc::vec::Vec;

/// Most times the functions are made anew with more speeds among those that they are found at.
const MOST_ATTEMPTS: usize = 8;
/// Speeds that are added at a time.
const ADDED: usize = 6;
/// Speeds at which what the sums of products say is looked at closely, the worst first.
const LOOKED_AT: usize = 12;
/// Added Ω² keep apart by this part of the larger.
const APART: f64 = 0.05;

/// With more functions the eigenproblems of a fit are solved without vectors, and the error is looked at
/// in a few places.
const CHECKED_EVERYWHERE: usize = 120;
/// A relative error from which on curves are not worth fitting.
const POOR: f64 = 1e2 * TOLERANCE;

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
) -> Result<Fitted, Faults> {
    let mut also_at: Vec<f64> = Vec::new();
    let mut work = Work::for_range();
    let mut attempt = 0;
    loop {
        attempt += 1;
        let wanted = Wanted { range: (0.0, highest), count: settings.modes, also_at: &also_at };
        let basis = Basis::new(blade, dof, settings, &wanted, rules, &mut work)?;
        let at_rest = solve(basis.matrices(), 0.0, settings.modes)?;
        let fit = || Curves::fit(basis.matrices(), &at_rest, range.0, range.1, work.left()).map_err(unsolvable);
        let Basis::Piecewise(converged) = &basis else {
            let curves = fit()?;
            let error = curves.error();
            return Ok(Fitted { basis, at_rest, curves, error });
        };
        let many = basis.matrices().count() + ADDED * settings.modes > MOST_FUNCTIONS;
        let last = attempt == MOST_ATTEMPTS || many || work.left() <= 0.0;
        let few = basis.matrices().count() <= CHECKED_EVERYWHERE;
        let Checked { curves, errors } = if let Some(residuals) = converged.residuals().filter(|_| few) {
            let error = |q: &[f64], value: f64, s: f64| residuals.error(q, value, s);
            let poor = if last { f64::INFINITY } else { POOR };
            Curves::fit_checked(basis.matrices(), &at_rest, range, work.left(), poor, error).map_err(unsolvable)?
        } else {
            let squares = sample(&at_rest, range, LOOKED_AT);
            Checked { curves: None, errors: squares.into_iter().map(|s| (s, f64::INFINITY)).collect() }
        };
        let (worst, poor) = poor(converged, errors, settings.modes)?;
        let known = also_at.len();
        also_at.extend(poor);
        let better = also_at.len() > known && !last;
        if better {
            work.spend(curves.map_or(0.0, |curves| curves.work()));
            continue;
        }
        let curves = match curves {
            Some(curves) => curves,
            None => fit()?,
        };
        let error = maximum(maximum(basis.error(), curves.error()), worst);
        return Ok(Fitted { basis, at_rest, curves, error });
    }
}

/// The largest error at the Ω² that were looked at, and where the functions are to be better.
fn poor(converged: &Converged, mut checked: Vec<(f64, f64)>, count: usize) -> Result<(f64, Vec<f64>), Faults> {
    checked.retain(|(_, error)| is_above(*error, TOLERANCE));
    checked.sort_by(|a, b| b.1.total_cmp(&a.1));
    let (mut worst, mut poor) = (0.0, Vec::<f64>::new());
    for (s, _) in checked.into_iter().take(LOOKED_AT) {
        // What is left of large sums may be rounding alone.
        let error = converged.error_at(s, count).map_err(|cause| super::basis::failed(converged, cause))?;
        worst = maximum(worst, error);
        let apart = poor.iter().all(|other| (other - s).abs() > APART * other.max(s));
        if is_above(error, TOLERANCE) && apart && poor.len() < ADDED {
            poor.push(s);
        }
    }
    Ok((worst, poor))
}

#[cfg(all(test, feature = "library"))]
mod tests {
    use super::*;
    use crate::{formats, library};

    /// From a beam to a string: a hundred times nominal speed. The chart is as good as each speed alone,
    /// and said to be (1e-9: the tolerance of λ, of the curves, and room).
    #[test]
    fn a_range_of_many_decades_is_as_good_as_each_speed() {
        let text = library::find("tm4760").unwrap().toml;
        let blade = formats::read(text, formats::Format::Toml).unwrap().blade;
        let rules = GaussRules::new();
        let settings = Settings::default();
        let to = 100.0 * blade.nominal_speed();
        for dof in Dof::ALL {
            let found = fitted(&blade, dof, &settings, (0.0, to * to), to * to, &rules).unwrap();
            assert!(found.error <= TOLERANCE, "{dof}: {:e}", found.error);
            for speed in [0.0, 40.0, 231.5, 700.0, 3000.0, to] {
                let s = speed * speed;
                let alone = Converged::new(&blade, dof, &Wanted::at(s, 6), &rules, &mut Work::default()).unwrap();
                let modes = solve(alone.matrices(), speed, 5).unwrap();
                for (value, mode) in found.curves.eigenvalues(s).iter().zip(&modes) {
                    assert!((value - mode.eigenvalue).abs() <= 1e-9 * mode.eigenvalue, "{dof} at {speed}: {value}");
                }
            }
        }
    }
}
