//! Frequencies of a coupled blade at one speed.

use super::model::THIN;
use super::{Settings, margin};
use crate::blade::{Blade, PropellerMoment, Property};
use crate::coupled::{self, CoupledBlade, CoupledMode, Impossible, Missing, Options, TOLERANCE};
use crate::dof::Dof;
use crate::fault::{Fault, FaultCode, Faults, Warning};
use crate::figures::short;
use crate::label::Label;
use crate::modes::SolveError;
use crate::numerics::eigen::EigenError;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::{is_above, maximum, sqrt};
use crate::report::{CoupledModeReport, CoupledModesReport, ModelReport, Shares};
use crate::units;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// A mode is mixed where no motion has this share.
const LEADING: f64 = 0.6;
/// λ within this of 0, as a share of ρ or of the highest λ, is the rounding of a rigid motion.
const NOTHING: f64 = 1e-12;

/// The lowest modes of the whole blade at one speed, flap, lag and torsion coupled, with proven two-sided bounds.
///
/// # Errors
/// Faults in the settings, inertias that are impossible, or equations without an answer.
pub fn coupled_modes(blade: &Blade, settings: &Settings) -> Result<CoupledModesReport, Faults> {
    settings.check()?;
    let (coupled, model, mut warnings) = model(blade, settings)?;
    let speed = settings.speed_or(blade.nominal_speed());
    let found =
        coupled::modes(&coupled, speed * speed, settings.coupled_modes, &GaussRules::new()).map_err(unsolvable)?;
    note(&mut warnings, &found.modes, settings.coupled_modes);
    let highest = found.modes.last().map_or(0.0, |mode| mode.eigenvalue.abs());
    let rigid = NOTHING * found.separation.as_ref().map_or(highest, |rho| highest.max(*rho));
    let mut numbers = [0; 3];
    let mut modes = Vec::with_capacity(found.modes.len());
    for mode in &found.modes {
        let label = label(&mode.shares, &mut numbers);
        if settings.dofs.contains(&label.dof) {
            modes.push(mode_report(mode, label, speed, rigid, &found.separation));
        }
    }
    Ok(CoupledModesReport {
        schema: "bladefan-modes/1",
        blade: blade.name().to_string(),
        speed_rad_s: speed,
        model,
        functions: found.functions,
        modes,
        warnings,
    })
}

fn mode_report(
    mode: &CoupledMode,
    label: Label,
    speed: f64,
    rigid: f64,
    separation: &Result<f64, Missing>,
) -> CoupledModeReport {
    let eigenvalue = if mode.eigenvalue.abs() <= rigid { 0.0 } else { mode.eigenvalue };
    let unstable = eigenvalue < 0.0;
    let root = |value: f64| (value >= 0.0).then(|| sqrt(value));
    let frequency = root(eigenvalue);
    let per_rev = frequency.and_then(|frequency| units::per_rev(frequency, speed));
    let margin = per_rev.map(|per_rev| margin(label, per_rev));
    let bound = |value: f64| if unstable { None } else { root(value.max(0.0)) };
    let missing = separation.as_ref().err().map(|missing| match missing {
        Missing::Separation => "separation not proven",
        Missing::Shift => "no shift",
    });
    let [flap, lag, torsion] = mode.shares;
    CoupledModeReport {
        label,
        dof: label.dof,
        number: label.number,
        mixed: label.second.is_some(),
        shares: Shares { flap, lag, torsion },
        frequency_rad_s: frequency,
        frequency_hz: frequency.map(units::hz),
        per_rev,
        nearest_harmonic: margin.as_ref().map(|margin| margin.nearest_harmonic),
        margin_per_rev: margin.as_ref().map(|margin| margin.margin_per_rev),
        eigenvalue_s2: eigenvalue,
        unstable,
        lower_rad_s: mode.bounds.and_then(|(lower, _)| bound(lower)),
        upper_rad_s: mode.bounds.and_then(|(_, upper)| bound(upper)),
        lower_eigenvalue_s2: mode.bounds.map(|bounds| bounds.0),
        upper_eigenvalue_s2: mode.bounds.map(|bounds| bounds.1),
        bounds_missing: missing,
        // λ̂ − λ is about the energy of the residual moments; ω has half of it.
        error_estimate_rad_s: missing.and(frequency).filter(|f| *f > 0.0).map(|frequency| 0.5 * mode.error / frequency),
        separation_rad_s: separation.as_ref().ok().copied().and_then(root),
    }
}

/// The label of the next mode, by its leading motion.
pub(super) fn label(shares: &[f64; 3], numbers: &mut [usize; 3]) -> Label {
    let mut order = Dof::ALL;
    order.sort_by(|a, b| shares[b.index()].total_cmp(&shares[a.index()]));
    let [leading, second, _] = order;
    numbers[leading.index()] += 1;
    let number = numbers[leading.index()];
    if shares[leading.index()] < LEADING { Label::mixed(leading, number, second) } else { Label::new(leading, number) }
}

/// Says so where modes are too few or not converged.
fn note(warnings: &mut Vec<Warning>, modes: &[CoupledMode], asked: usize) {
    let highest = modes.last().map_or(0.0, |mode| mode.eigenvalue.abs());
    let size = |mode: &CoupledMode| mode.eigenvalue.abs().max(1e-4 * highest);
    let error = modes.iter().map(|mode| mode.error / size(mode)).fold(0.0, maximum);
    let mut warn = |message: String| warnings.push(Warning { path: "coupled".into(), message });
    if is_above(error, 1e2 * TOLERANCE) {
        warn(format!("frequencies are converged to {:.0e} only", 0.5 * error));
    }
    if modes.len() < asked {
        warn(format!("only {} of {asked} modes can be told from rounding", modes.len()));
    }
}

pub(super) fn unsolvable(cause: EigenError) -> Faults {
    let rule = "the coupled equations must have an answer";
    let message = SolveError { dofs: &Dof::ALL, cause }.to_string();
    Fault::new(FaultCode::Unsolvable, "coupled", None, rule, message).into()
}

/// The blade as the coupled equations see it, what acts, and what its author should know.
pub(super) fn model(blade: &Blade, settings: &Settings) -> Result<(CoupledBlade, ModelReport, Vec<Warning>), Faults> {
    settings.dofs_of(blade)?;
    let mut warnings = blade.warnings().to_vec();
    let known = blade.gives(Property::AxialStiffness) || blade.gives(Property::TrapezeRadius);
    if settings.trapeze == Some(true) && !known {
        let rule = "needs axial_stiffness or trapeze_radius of the blade";
        return Err(
            Fault::new(FaultCode::Missing, "trapeze", Some("on".into()), rule, format!("--trapeze on {rule}")).into()
        );
    }
    let on = settings.trapeze.unwrap_or(known);
    if !known && blade.has_torsion() {
        let message = "no axial stiffness: without trapeze 1T may be 2.5 % low".into();
        warnings.push(Warning { path: "distribution.axial_stiffness".into(), message });
    }
    if !blade.inertias_given() && blade.has_torsion() {
        warnings.push(Warning { path: "distribution.polar_inertia".into(), message: THIN.into() });
    }
    let paper_moment = settings.propeller_moment == Some(PropellerMoment::Paper);
    let options = Options {
        pitch: settings.pitch,
        precone: settings.precone,
        trapeze: on,
        rotary: settings.rotary,
        paper_moment,
    };
    let coupled = CoupledBlade::new(blade, &options);
    if blade.has_torsion() {
        possible(&coupled)?;
    }
    let model = ModelReport {
        kind: "coupled",
        pitch_rad: coupled.pitch,
        precone_rad: coupled.precone,
        trapeze: on,
        rotary: settings.rotary,
        gyroscopic: false,
        steady: false,
        cone: "held",
        propeller_moment: if paper_moment { "paper" } else { "full" },
        unused: Vec::new(),
    };
    Ok((coupled, model, warnings))
}

/// Refuses sections whose mass would have negative inertia about its own centre.
fn possible(blade: &CoupledBlade) -> Result<(), Faults> {
    let fault = |found: Impossible| {
        let rule = "must be at least mass times mass_offset squared in the coupled model";
        let [from, to, r, own, least] =
            [found.stretch.0, found.stretch.1, found.r, found.inertia, found.least].map(|value| short(value, 4));
        let message =
            format!("inertia of the stretch r = {from} to {to} m {rule} (at r = {r} m it is {own} kg·m, not {least})");
        Fault::new(FaultCode::OutOfRange, "distribution.polar_inertia", Some(own), rule, message)
    };
    Faults::from(blade.impossible().into_iter().map(fault).collect::<Vec<Fault>>()).none()
}
