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
use crate::modes::{Mode, coordinates, eigenvalues};
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::{is_above, maximum};
use alloc::vec::Vec;

/// Most times the functions are made anew with more speeds among those that they are found at.
const MOST_ATTEMPTS: usize = 8;
/// Speeds that are added at a time.
const ADDED: usize = 6;
/// Multiplications of finding the vector of an eigenvalue, by the cube of the order.
const VECTOR_PER_CUBE: f64 = 1.0;
/// A fit takes no more than this part of the work that is left.
const FIT_SHARE: f64 = 0.75;
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
/// More functions may take this part of the work that is left, and the fit the rest.
const FUNCTIONS_SHARE: f64 = 0.5;

/// Branches of one degree of freedom.
pub(super) struct Fitted {
    pub(super) basis: Basis,
    pub(super) at_rest: Vec<Mode>,
    pub(super) curves: Curves,
    /// Estimate of the largest relative error of an eigenvalue at any speed, but for that of the curves.
    error: f64,
    /// For speeds that are solved for alone.
    alone: Work,
}

impl Fitted {
    /// The eigenvalues at Ω² = `s` in the range: read off the curves, or solved for where these do not follow
    /// the branches.
    pub(super) fn eigenvalues(&self, s: f64) -> Vec<f64> {
        if self.curves.follow(s) || self.is_tired() {
            return self.curves.eigenvalues(s);
        }
        match eigenvalues(self.basis.matrices(), s, self.at_rest.len()) {
            Ok(found) => {
                self.alone.spend(found.work);
                found.values
            }
            // The curves have met such speeds, and have an answer.
            Err(_) => self.curves.eigenvalues(s),
        }
    }

    /// Whether so many speeds were solved for that the curves take over.
    fn is_tired(&self) -> bool {
        self.alone.left() <= 0.0
    }

    /// Estimate of the largest relative error of the eigenvalues so far.
    pub(super) fn error(&self) -> f64 {
        if self.is_tired() { maximum(self.error, self.curves.error()) } else { self.error }
    }
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
    let mut last: Option<(Made, Curves, f64)> = None;
    for attempt in 1.. {
        let (curves, worst, poor) = made.look(range, &work)?;
        if let Some((made, curves, before)) = last.take_if(|(.., before)| is_above(worst, *before)) {
            // More speeds made nothing better.
            return Ok(made.fitted(curves, before));
        }
        let affordable = made.affordable(settings.modes, &work);
        if poor.is_empty() || attempt == MOST_ATTEMPTS || affordable == 0 {
            return Ok(made.fitted(curves, worst));
        }
        also_at.extend(poor.into_iter().take(affordable));
        let Ok(better) = Made::new(blade, dof, settings, highest, &also_at, rules, &work) else {
            // So many functions cannot be told apart from one another: those that could are the answer.
            return Ok(made.fitted(curves, worst));
        };
        last = Some((made, curves, worst));
        made = better;
    }
    unreachable!("the last attempt returns")
}

/// Functions of a range of rotor speeds with their modes at rest.
struct Made {
    basis: Basis,
    at_rest: Vec<Mode>,
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
        let basis = Basis::new(blade, dof, settings, &wanted, rules, work)?;
        let at_rest = solve(basis.matrices(), 0.0, settings.modes)?;
        Ok(Self { basis, at_rest })
    }

    /// At how many more speeds the functions may be sought: to find them again and to fit curves to their
    /// eigenvalues takes work.
    fn affordable(&self, modes: usize, work: &Work) -> usize {
        let Basis::Piecewise(converged) = &self.basis else { return 0 };
        let (found, modes) = (self.basis.matrices().count(), modes.max(1));
        let share = FUNCTIONS_SHARE * work.left();
        let functions = most_functions(work.left() - share).min(MOST_FUNCTIONS);
        let more = functions.saturating_sub(found) / modes;
        (0..=more).rev().find(|more| converged.work_for(found / modes + more, modes) <= share).unwrap_or(0)
    }

    /// The curves, their largest error, and where the functions are to be better. Those of the paper are what
    /// they are.
    fn look(&self, range: (f64, f64), work: &Work) -> Result<(Curves, f64, Vec<f64>), Faults> {
        let matrices = self.basis.matrices();
        // What is left over is for more functions.
        let share = FIT_SHARE * work.left();
        let curves = Curves::fit(matrices, &self.at_rest, range.0, range.1, share).map_err(unsolvable)?;
        work.spend(curves.work());
        let Basis::Piecewise(converged) = &self.basis else { return Ok((curves, 0.0, Vec::new())) };
        let n = matrices.count() as f64;
        let cube = n * n * n;
        let mut errors = Vec::new();
        for s in places(converged, range) {
            let mut values = if curves.follow(s) {
                curves.eigenvalues(s)
            } else {
                let alone = eigenvalues(matrices, s, self.at_rest.len()).map_err(unsolvable)?;
                work.spend(alone.work);
                alone.values
            };
            if let Some(step) = values.len().checked_div(LOOKED_AT).filter(|step| *step > 0) {
                // Of very many modes the last one and some others.
                values = values.into_iter().rev().step_by(step + 1).collect();
            }
            let coordinates = coordinates(matrices, s, &values).map_err(unsolvable)?;
            work.spend(VECTOR_PER_CUBE * values.len() as f64 * cube);
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
        let error = maximum(self.basis.error(), worst);
        Fitted { basis: self.basis, at_rest: self.at_rest, curves, error, alone: Work::for_range() }
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
    use crate::analysis::{ModelKind, SpeedRange, fan, modes};
    use crate::functions::BasisFamily;
    use crate::lagrange::tests::sprung;

    /// A chart over a wide range against the modes of each of its speeds alone; a warning says how
    /// far it may be off. Frequencies have half the error of eigenvalues, 1e-10 on either side.
    #[test]
    fn a_chart_is_as_good_as_the_modes_of_each_speed() {
        let blade = sprung(0.2);
        let range = SpeedRange { from: 0.0, to: 10.0 * blade.nominal_speed(), count: 20 };
        let settings = Settings { speeds: Some(range), modes: 3, ..Settings::of(ModelKind::Uncoupled) };
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
        let settings =
            Settings { basis: BasisFamily::Classical, functions: 8, modes: 4, ..Settings::of(ModelKind::Uncoupled) };
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
        let settings = Settings::of(ModelKind::Uncoupled);
        let to = 100.0 * blade.nominal_speed();
        for dof in Dof::ALL {
            let found = fitted(&blade, dof, &settings, (0.0, to * to), to * to, &rules).unwrap();
            // The work that a chart may take ends a step before the tolerance here.
            assert!(found.error() <= 2.0 * TOLERANCE, "{dof}: {:e}", found.error());
            for speed in [0.0, 40.0, 231.5, 700.0, 3000.0, to] {
                let s = speed * speed;
                let alone = Converged::new(&blade, dof, &Wanted::at(s, 6), &rules, &Work::default()).unwrap();
                let modes = solve(alone.matrices(), speed, 5).unwrap();
                for (value, mode) in found.eigenvalues(s).iter().zip(&modes) {
                    assert!((value - mode.eigenvalue).abs() <= 1e-9 * mode.eigenvalue, "{dof} at {speed}: {value}");
                }
            }
        }
    }
}
