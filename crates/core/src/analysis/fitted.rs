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
const MOST_ATTEMPTS: usize = 8;
/// Speeds that are added at a time.
const ADDED: usize = 3;
/// Speeds at which what the sums of products say is looked at closely, the worst first.
const LOOKED_AT: usize = 8;
/// Added Ω² keep apart by this part of the larger.
const APART: f64 = 0.05;

/// With more functions the eigenproblems of a fit are solved without vectors, and the error is looked at
/// in a few places.
const CHECKED_EVERYWHERE: usize = 60;
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
) -> Result<Fitted, Vec<Fault>> {
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
        let (curves, checked) = if basis.matrices().count() <= CHECKED_EVERYWHERE {
            let residuals = converged.residuals(rules);
            let error = |mode: &Mode, s: f64| residuals.error(mode.coordinates.as_slice(), mode.eigenvalue, s);
            let poor = if last { f64::INFINITY } else { POOR };
            Curves::fit_checked(basis.matrices(), &at_rest, range, work.left(), poor, error).map_err(unsolvable)?
        } else {
            (None, sample(range))
        };
        let (worst, poor) = poor(converged, checked, settings.modes, rules)?;
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{SpeedRange, fan, modes};
    use crate::functions::BasisFamily;
    use crate::lagrange::tests::sprung;

    /// A chart over a wide range against the modes of each of its speeds alone; a warning says how
    /// far it may be off. Frequencies have half the error of eigenvalues, 1e-10 on either side.
    #[test]
    fn a_chart_is_as_good_as_the_modes_of_each_speed() {
        let blade = sprung(0.2);
        let range = SpeedRange { from: 0.0, to: 10.0 * blade.nominal_speed(), count: 20 };
        let settings = Settings { speeds: Some(range), modes: 3, ..Settings::default() };
        let chart = fan(&blade, &settings).unwrap();
        assert!(chart.warnings.is_empty(), "{:?}", chart.warnings);
        for (i, speed) in chart.speeds_rad_s.iter().enumerate() {
            let single = modes(&blade, &Settings { speed: Some(*speed), ..settings.clone() }).unwrap();
            assert!(single.warnings.is_empty(), "{:?}", single.warnings);
            for (branch, mode) in chart.branches.iter().zip(&single.modes) {
                let (found, known) = (branch.frequency_rad_s[i], mode.frequency_rad_s);
                assert!((found / known - 1.0).abs() < 1e-9, "{} at {speed}: {found} {known}", branch.label);
            }
        }
    }

    /// The paper's functions are fitted as they are: a handful of functions against their own eigenvalues.
    #[test]
    fn curves_of_the_classical_functions_are_their_eigenvalues() {
        let (blade, rules) = (sprung(0.2), GaussRules::new());
        let settings = Settings { basis: BasisFamily::Classical, functions: 8, modes: 4, ..Settings::default() };
        for dof in Dof::ALL {
            let found = fitted(&blade, dof, &settings, (0.0, 1e4), 1e4, &rules).unwrap();
            assert!(found.error < TOLERANCE, "{dof}: {:e}", found.error);
            assert_eq!((found.basis.count(), found.at_rest.len(), found.curves.branches()), (8, 4, 4));
            for s in [0.0, 3.0, 77.0, 1234.5, 9999.0] {
                let known = solve(found.basis.matrices(), f64::sqrt(s), 4).unwrap();
                for (value, mode) in found.curves.eigenvalues(s).iter().zip(&known) {
                    assert!((value / mode.eigenvalue - 1.0).abs() < 1e-9, "{dof} at {s}: {value}");
                }
            }
        }
    }

    #[test]
    fn samples_cover_the_range_on_a_logarithmic_scale() {
        for (from, to) in [(0.0, 1e4), (1.0, 2.0)] {
            let found = sample((from, to));
            assert_eq!((found.len(), found[0].0), (LOOKED_AT, from.max(1e-3 * to)));
            assert!((found[LOOKED_AT - 1].0 / to - 1.0).abs() < 1e-14 && found[LOOKED_AT - 1].0 <= to, "to its end");
            let ratio = found[1].0 / found[0].0;
            // Powers are rounded.
            assert!(found.windows(2).all(|pair| (pair[1].0 / pair[0].0 / ratio - 1.0).abs() < 1e-13));
            assert!(found.iter().all(|(_, error)| error.is_infinite()), "each to be looked at");
        }
    }
}
