//! Bounds of the product against the number of eigenvalues below them, counted by the independent
//! solution.

use crate::blades::{Hold, TestBlade};
use crate::exact::Exact;
use crate::solve::{converged_settings, settings, solve_with};
use bladefan_core::Dof;
use bladefan_core::PropellerMoment;
use bladefan_core::Settings;
use bladefan_core::report::ModeReport;
use core::fmt;

/// Rounding of the independent solution, relative to a frequency: measured up to 4e-13.
pub const ROUNDING: f64 = 2e-12;
/// Widest interval of a converged frequency, relative to it: measured 2e-10 on random blades.
pub const WIDEST: f64 = 1e-8;
/// Largest error of a converged frequency: measured 5e-11 on random blades.
pub const CONVERGED: f64 = 1e-9;

/// One degree of freedom of one blade at one speed.
#[derive(Clone, Copy, Debug)]
pub struct Case<'a> {
    /// The blade.
    pub blade: &'a TestBlade,
    /// The degree of freedom.
    pub dof: Dof,
    /// Rotor speed [rad/s].
    pub speed: f64,
    /// Modes asked for.
    pub count: usize,
}

/// What was found wrong, with the numbers.
#[derive(Debug)]
pub struct Wrong(pub String);

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Case<'_> {
    /// What rounding may have done to an eigenvalue ω² that shooting says is near `square`.
    ///
    /// The equation of lag holds ω² + Ω², so this is what rounding is relative to; so it is to the
    /// centrifugal part of a flap or torsion mode, at most of the order of Ω². A soft spring is
    /// compared with a moment that is rounded like the moments of the elastic motion.
    fn rounding(&self, square: f64, elastic: f64) -> f64 {
        let soft =
            if matches!(self.blade.roots[self.dof.index()].hold, Hold::Spring(_)) { 1e-14 * elastic } else { 0.0 };
        2.0 * ROUNDING * (square + self.speed * self.speed) + soft
    }

    fn exact(&self, modes: &[ModeReport]) -> (Exact<f64>, f64) {
        let highest = modes.iter().fold(0.0_f64, |most, mode| {
            most.max(mode.separation_rad_s.unwrap_or(0.0)).max(mode.upper_rad_s.unwrap_or(0.0))
        });
        let exact = Exact::new(self.blade, self.dof, self.speed, 1.001 * highest);
        (exact, highest * highest)
    }

    /// Checks the piecewise family: intervals hold and are narrow, values are good, and the number
    /// that separates the modes from the next one does. Returns the widest relative interval.
    ///
    /// # Errors
    /// What is wrong.
    pub fn check_converged(&self) -> Result<f64, Wrong> {
        let modes = self.modes(&converged_settings(self.dof, self.speed, self.count));
        let (exact, elastic) = self.exact(&modes);
        let wrong = |what: String| Err(Wrong(self.describe(&what, &modes, &exact)));
        let Some(separation) = modes[0].separation_rad_s else { return wrong("no separation".into()) };
        let below = exact.count_below(self.speed, separation * separation);
        if below != self.count {
            return wrong(format!("{below} eigenvalues below the separation {separation}"));
        }
        self.check_inside(&modes, &exact, elastic)?;
        let mut widest = 0.0_f64;
        for (i, mode) in modes.iter().enumerate() {
            let f = mode.frequency_rad_s;
            if f == 0.0 {
                continue;
            }
            let near = |other: f64| (other / f - 1.0).abs() < 1e-6;
            let next = modes.get(i + 1).map_or(separation, |next| next.frequency_rad_s);
            let crowded = near(next) || i > 0 && near(modes[i - 1].frequency_rad_s);
            let width = (mode.upper_rad_s.unwrap() - mode.lower_rad_s.unwrap()) / f;
            if width > WIDEST && !crowded {
                return wrong(format!("interval of mode {} is {width:e} wide", i + 1));
            }
            widest = widest.max(if crowded { 0.0 } else { width });
            let (low, high) = ((f * (1.0 - CONVERGED)).powi(2), (f * (1.0 + CONVERGED)).powi(2));
            let counts = [low, high].map(|square| exact.count_below(self.speed, square));
            if counts[0] > i || counts[1] < i + 1 {
                return wrong(format!("mode {} is off: {counts:?} eigenvalues below {CONVERGED:e} around it", i + 1));
            }
        }
        Ok(widest)
    }

    /// Checks that the intervals of the classical family hold.
    ///
    /// # Errors
    /// What is wrong.
    pub fn check_classical(&self, functions: usize) -> Result<(), Wrong> {
        let modes = self.modes(&settings(self.dof, self.speed, functions, self.count));
        let (exact, elastic) = self.exact(&modes);
        self.check_inside(&modes, &exact, elastic)
    }

    fn modes(&self, settings: &Settings) -> Vec<ModeReport> {
        let full = self.blade.inertias.is_some().then_some(PropellerMoment::Full);
        solve_with(&self.blade.blade(), &Settings { propeller_moment: full, ..settings.clone() })
    }

    /// The k-th eigenvalue is in its interval: fewer than k lie below the lower end, at least k below
    /// the upper.
    fn check_inside(&self, modes: &[ModeReport], exact: &Exact<f64>, elastic: f64) -> Result<(), Wrong> {
        for (i, mode) in modes.iter().enumerate() {
            let (Some(lower), Some(upper)) = (mode.lower_rad_s, mode.upper_rad_s) else {
                return Err(Wrong(self.describe("no bounds", modes, exact)));
            };
            let (lower, upper) = (lower * lower, upper * upper);
            let counts = [
                exact.count_below(self.speed, lower - self.rounding(lower, elastic)),
                exact.count_below(self.speed, upper + self.rounding(upper, elastic) + f64::MIN_POSITIVE),
            ];
            let ordered = lower <= upper && (lower.sqrt()..=upper.sqrt()).contains(&mode.frequency_rad_s);
            if counts[0] > i || counts[1] < i + 1 || !ordered {
                let what = format!("mode {}: {counts:?} eigenvalues below its bounds", i + 1);
                return Err(Wrong(self.describe(&what, modes, exact)));
            }
        }
        Ok(())
    }

    /// What is wrong beside everything that is needed to see why.
    fn describe(&self, what: &str, modes: &[ModeReport], exact: &Exact<f64>) -> String {
        use fmt::Write as _;
        let mut text = format!("{} at {} rad/s: {what}", self.dof, self.speed);
        for (i, mode) in modes.iter().enumerate() {
            let eigenvalue = exact.eigenvalue(self.speed, i + 1);
            let f = eigenvalue.max(0.0).sqrt();
            let off = |bound: Option<f64>| bound.unwrap_or(f64::NAN) / f - 1.0;
            let _ = write!(
                text,
                "\n  {:3} {:22.15e}, exact {f:22.15e}: {:+9.2e}, bounds {:+9.2e} {:+9.2e}; separation {:?}, residual {:.1e}",
                mode.label,
                mode.frequency_rad_s,
                off(Some(mode.frequency_rad_s)),
                off(mode.lower_rad_s),
                off(mode.upper_rad_s),
                mode.separation_rad_s,
                mode.residual
            );
        }
        let i = self.dof.index();
        let _ = write!(text, "\n  root {:?}, stiffness {:?}", self.blade.roots[i], self.blade.stiffness[i]);
        let _ = write!(text, "\n  radius {}, mass {:?}", self.blade.radius, self.blade.mass);
        let _ = write!(text, "\n  point masses {:?}", self.blade.point_masses);
        if self.dof == Dof::Torsion {
            let _ = write!(text, "\n  inertia {:?}, offset {:?}", self.blade.polar_inertia, self.blade.mass_offset);
            let _ = write!(text, "\n  inertias {:?}", self.blade.inertias);
        }
        text
    }
}
