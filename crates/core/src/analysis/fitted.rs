//! The branches of one degree of freedom over a range of rotor speeds, as good at every speed as the
//! modes of that speed alone.

use super::Settings;
use super::basis::{Basis, solve};
use super::unsolvable;
use crate::blade::Blade;
use crate::converged::{Converged, MOST_FUNCTIONS, TOLERANCE, Wanted, Work, half_way};
use crate::dof::Dof;
use crate::fan::{Curves, most_functions, sample};
use crate::fault::Faults;
use crate::modes::{Mode, coordinates};
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::{is_above, maximum};
use alloc::vec::Vec;

/// Most times the functions are made anew with more speeds among those that they are found at.
const MOST_ATTEMPTS: usize = 8;
/// Speeds that are added at a time.
const ADDED: usize = 6;
/// Multiplications of finding the vector of an eigenvalue, by the cube of the order.
const VECTOR_PER_CUBE: f64 = 1.0;
/// About so many modes are looked at, where there are more.
const LOOKED_AT: usize = 8;
/// A speed looked at beside rest, as a share of the first Ω² between two.
const BESIDE_REST: f64 = 0.01;
/// Added Ω² keep apart by this part of the larger.
const APART: f64 = 0.05;

/// So far from one another stand the speeds whose modes become functions, where three are not enough; in bends
/// of the branches.
const FUNCTIONS_PER_BEND: f64 = 0.8;
/// So many such speeds the usual three are a match for.
const FEW_BENDS: usize = 4;
/// To find more functions costs so many times what it took to find those there are.
const AGAIN: f64 = 1.2;
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
    let work = Work::for_range();
    let mut made = Made::new(blade, dof, settings, highest, &also_at, rules, &work)?;
    // Where the range spans much of what bends the branches, the functions of three speeds are no match for it.
    let most = made.affordable(settings.modes, &work);
    let apart = sample(&made.at_rest, (0.0, highest), FUNCTIONS_PER_BEND, most);
    if apart.len() > FEW_BENDS && matches!(made.basis, Basis::Piecewise(_)) {
        also_at.extend_from_slice(&apart[1..apart.len() - 1]);
        if let Ok(better) = Made::new(blade, dof, settings, highest, &also_at, rules, &work) {
            made = better;
        }
    }
    for attempt in 1.. {
        let affordable = made.affordable(settings.modes, &work);
        let last = attempt == MOST_ATTEMPTS || affordable == 0;
        let (curves, worst, poor) = made.look(range, &work)?;
        if last || poor.is_empty() {
            return Ok(made.fitted(curves, worst));
        }
        also_at.extend(poor.into_iter().take(affordable));
        made = match Made::new(blade, dof, settings, highest, &also_at, rules, &work) {
            Ok(better) => better,
            // So many functions cannot be told apart from one another: those that could are the answer.
            Err(_) => return Ok(made.fitted(curves, worst)),
        };
    }
    unreachable!("the last attempt returns")
}

/// Functions of a range of rotor speeds with their modes at rest.
struct Made {
    basis: Basis,
    at_rest: Vec<Mode>,
    /// Work that it took.
    cost: f64,
}

impl Made {
    fn new(
        blade: &Blade,
        dof: Dof,
        settings: &Settings,
        highest: f64,
        also_at: &[f64],
        rules: &GaussRules,
        work: &Work,
    ) -> Result<Self, Faults> {
        let wanted = Wanted { range: (0.0, highest), count: settings.modes, also_at };
        let before = work.left();
        let basis = Basis::new(blade, dof, settings, &wanted, rules, work)?;
        let at_rest = solve(basis.matrices(), 0.0, settings.modes)?;
        Ok(Self { basis, at_rest, cost: before - work.left() })
    }

    /// At how many more speeds the functions may be sought: to find them again and to fit curves to their
    /// eigenvalues takes work.
    fn affordable(&self, modes: usize, work: &Work) -> usize {
        let left = work.left() - AGAIN * self.cost;
        let functions = most_functions(left).min(MOST_FUNCTIONS);
        functions.saturating_sub(self.basis.matrices().count()) / modes.max(1)
    }

    /// The curves, their largest error, and where the functions are to be better. Those of the paper are what
    /// they are.
    fn look(&self, range: (f64, f64), work: &Work) -> Result<(Curves, f64, Vec<f64>), Faults> {
        let matrices = self.basis.matrices();
        let curves = Curves::fit(matrices, &self.at_rest, range.0, range.1, work.left()).map_err(unsolvable)?;
        work.spend(curves.work());
        let Basis::Piecewise(converged) = &self.basis else { return Ok((curves, 0.0, Vec::new())) };
        let mut errors = Vec::new();
        for s in places(converged, range) {
            let mut values = curves.eigenvalues(s);
            if let Some(step) = values.len().checked_div(LOOKED_AT).filter(|step| *step > 0) {
                // Of very many modes the last one and some others.
                values = values.into_iter().rev().step_by(step + 1).collect();
            }
            let coordinates = coordinates(matrices, s, &values).map_err(unsolvable)?;
            let n = matrices.count() as f64;
            work.spend(VECTOR_PER_CUBE * values.len() as f64 * n * n * n);
            errors.push((s, converged.error_of(&coordinates, &values, s, work)));
        }
        errors.sort_by(|a, b| b.1.total_cmp(&a.1));
        let worst = errors.iter().fold(0.0, |worst, (_, error)| maximum(worst, *error));
        let mut poor = Vec::<f64>::new();
        for (s, _) in errors.into_iter().filter(|(_, error)| is_above(*error, TOLERANCE)) {
            if poor.len() < ADDED && poor.iter().all(|other| (other - s).abs() > APART * other.max(s)) {
                poor.push(s);
            }
        }
        Ok((curves, worst, poor))
    }

    fn fitted(self, curves: Curves, worst: f64) -> Fitted {
        let error = maximum(maximum(self.basis.error(), curves.error()), worst);
        Fitted { basis: self.basis, at_rest: self.at_rest, curves, error }
    }
}

/// The Ω² of a range at which modes are looked at: between the speeds that the functions come from, and beside
/// rest, where they may be worse than at any; half way where that leaves none.
fn places(converged: &Converged, (from, to): (f64, f64)) -> Vec<f64> {
    let between = converged.between();
    let beside = BESIDE_REST * between.first().copied().unwrap_or(to);
    let mut places: Vec<f64> = between.into_iter().chain([beside]).filter(|s| (from..=to).contains(s)).collect();
    if places.is_empty() {
        places.push(half_way(from, to));
    }
    places
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
        // Of the model, and of nothing that was solved.
        let unused =
            [crate::Warning { path: "distribution.mass_offset".into(), message: "acts in torsion only".into() }];
        assert_eq!(chart.warnings, unused);
        for (i, speed) in chart.speeds_rad_s.iter().enumerate() {
            let single = modes(&blade, &Settings { speed: Some(*speed), ..settings.clone() }).unwrap();
            assert_eq!(single.warnings, unused);
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

    /// From a beam to a string: a hundred times nominal speed. The chart is as good as each speed alone,
    /// and said to be (1e-9: the tolerance of λ, of the curves, and room).
    #[cfg(feature = "library")]
    #[test]
    fn a_range_of_many_decades_is_as_good_as_each_speed() {
        let text = crate::library::find("tm4760").unwrap().toml;
        let blade = crate::formats::read(text, crate::formats::Format::Toml).unwrap().blade;
        let rules = GaussRules::new();
        let settings = Settings::default();
        let to = 100.0 * blade.nominal_speed();
        for dof in Dof::ALL {
            let found = fitted(&blade, dof, &settings, (0.0, to * to), to * to, &rules).unwrap();
            assert!(found.error <= TOLERANCE, "{dof}: {:e}", found.error);
            for speed in [0.0, 40.0, 231.5, 700.0, 3000.0, to] {
                let s = speed * speed;
                let alone = Converged::new(&blade, dof, &Wanted::at(s, 6), &rules, &Work::default()).unwrap();
                let modes = solve(alone.matrices(), speed, 5).unwrap();
                for (value, mode) in found.curves.eigenvalues(s).iter().zip(&modes) {
                    assert!((value - mode.eigenvalue).abs() <= 1e-9 * mode.eigenvalue, "{dof} at {speed}: {value}");
                }
            }
        }
    }
}
