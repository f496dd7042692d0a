//! Frequencies of a coupled blade at one speed.

use super::model::THIN;
use super::{Settings, margin};
use crate::blade::{Blade, PropellerMoment, Property};
use crate::coupled::{
    self, Classical, CoupledBlade, CoupledMode, CoupledModes, Functions, Impossible, Missing, Options, TOLERANCE,
};
use crate::dof::Dof;
use crate::fault::{Fault, FaultCode, Faults, Warning};
use crate::figures::short;
use crate::functions::{AssumedFunctions, BasisFamily, ClassicalTorsion, TorsionRoot};
use crate::label::Label;
use crate::lagrange::classical_functions;
use crate::modes::SolveError;
use crate::numerics::eigen::EigenError;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::{is_above, maximum, sqrt};
use crate::report::{BasisReport, CoupledModeReport, CoupledModesReport, FunctionCounts, ModelReport, Shares};
use crate::units;
use alloc::boxed::Box;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;

/// A mode is mixed where no motion has this share.
const LEADING: f64 = 0.6;
/// Precone above which Coriolis terms matter [rad], where first flap and lag are this near, as a share.
const CONED: f64 = 0.035;
const NEAR: f64 = 0.1;
/// λ within this of 0, as a share of ρ or of the highest λ, is the rounding of a rigid motion.
const NOTHING: f64 = 1e-12;

/// The lowest modes of the whole blade at one speed, flap, lag and torsion coupled, with proven two-sided bounds.
///
/// # Errors
/// Faults in the settings, inertias that are impossible, or equations without an answer.
pub fn coupled_modes(blade: &Blade, settings: &Settings) -> Result<CoupledModesReport, Faults> {
    settings.check()?;
    if settings.basis == BasisFamily::Classical {
        settings.still()?;
    }
    let (coupled, model, mut warnings) = model(blade, settings)?;
    let speed = settings.speed_or(blade.nominal_speed());
    let (square, count, rules) = (speed * speed, settings.coupled_modes, GaussRules::new());
    let turning = settings.gyroscopic && speed > 0.0;
    let found = if turning {
        coupled::turning_modes(&coupled, speed, count, &rules).map_err(unturnable)?
    } else {
        coupled::modes(&coupled, square, count, &rules).map_err(unsolvable)?
    };
    note(&mut warnings, &found.modes, count);
    note_coning(&mut warnings, &model, &found.modes);
    // The paper's functions stand beside the converged ones without Coriolis terms.
    let (mut by_paper, mut by_paper_counts) = (Vec::new(), [0; 3]);
    if !turning {
        let functions = paper_functions(blade, settings.functions);
        let paper = Classical::new(&coupled, &functions, &rules);
        by_paper = paper.modes(square, count, found.proven.as_ref()).map_err(unsolvable)?.modes;
        by_paper_counts = paper.counts();
    }
    let (shown, counts) = match settings.basis {
        BasisFamily::Piecewise => (&found.modes, found.functions),
        BasisFamily::Classical => (&by_paper, by_paper_counts),
    };
    let rigid = rigid(&found);
    let mut numbers = [0; 3];
    let mut modes = Vec::with_capacity(found.modes.len());
    for (index, mode) in shown.iter().enumerate() {
        let label = label(&mode.shares, &mut numbers);
        if settings.dofs.contains(&label.dof) {
            let root = |mode: &CoupledMode| frequency_of(mode.eigenvalue, rigid);
            modes.push(CoupledModeReport {
                classical_rad_s: by_paper.get(index).and_then(root),
                converged_rad_s: found.modes.get(index).and_then(root),
                ..mode_report(mode, label, speed, rigid, &found.separation)
            });
        }
    }
    Ok(CoupledModesReport {
        schema: "bladefan-modes/1",
        blade: blade.name().to_string(),
        speed_rad_s: speed,
        model,
        basis: BasisReport { family: settings.basis, functions: FunctionCounts::of(blade.dofs(), counts) },
        classical_functions: settings.functions,
        modes,
        warnings,
    })
}

/// λ within this of 0 is the rounding of a rigid motion [rad²/s²].
pub(super) fn rigid(found: &CoupledModes) -> f64 {
    let highest = found.modes.last().map_or(0.0, |mode| mode.eigenvalue.abs());
    NOTHING * found.separation.as_ref().map_or(highest, |rho| highest.max(*rho))
}

/// ω of an eigenvalue that is 0 within `rigid`; `None` where unstable.
pub(super) fn frequency_of(eigenvalue: f64, rigid: f64) -> Option<f64> {
    if eigenvalue.abs() <= rigid { Some(0.0) } else { (eigenvalue >= 0.0).then(|| sqrt(eigenvalue)) }
}

/// The paper's functions of all three motions.
pub(super) fn paper_functions(blade: &Blade, count: usize) -> Functions {
    let of = |dof| -> Box<dyn AssumedFunctions> {
        if blade.dofs().contains(&dof) {
            classical_functions(blade, dof, count)
        } else {
            Box::new(ClassicalTorsion::new(TorsionRoot::Clamped, 0, 1.0))
        }
    };
    Dof::ALL.map(of)
}

fn mode_report(
    mode: &CoupledMode,
    label: Label,
    speed: f64,
    rigid: f64,
    separation: &Result<f64, Missing>,
) -> CoupledModeReport {
    let nothing =
        mode.eigenvalue.abs() <= rigid && mode.bounds.is_none_or(|(lower, upper)| lower <= 0.0 && upper >= 0.0);
    let eigenvalue = if nothing { 0.0 } else { mode.eigenvalue };
    let unstable = eigenvalue < 0.0;
    let root = |value: f64| (value >= 0.0).then(|| sqrt(value));
    let frequency = root(eigenvalue);
    let per_rev = frequency.and_then(|frequency| units::per_rev(frequency, speed));
    let margin = per_rev.map(|per_rev| margin(label, per_rev));
    let bound = |value: f64| if unstable { None } else { root(value.max(0.0)) };
    let missing = separation.as_ref().err().map(|missing| match missing {
        Missing::Separation => "separation not proven",
        Missing::Shift => "no shift",
        Missing::Unstable => "statically unstable",
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
        classical_rad_s: None,
        converged_rad_s: None,
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
pub(super) fn note(warnings: &mut Vec<Warning>, modes: &[CoupledMode], asked: usize) {
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

/// Says so where Coriolis terms matter and are left out: coning, and first flap and lag near one another.
fn note_coning(warnings: &mut Vec<Warning>, model: &ModelReport, modes: &[CoupledMode]) {
    let first = |dof: Dof| modes.iter().find(|mode| mode.shares[dof.index()] >= LEADING);
    let (Some(flap), Some(lag)) = (first(Dof::Flap), first(Dof::Lag)) else { return };
    let (low, high) = (flap.eigenvalue.min(lag.eigenvalue), flap.eigenvalue.max(lag.eigenvalue));
    let near = low > 0.0 && low > (1.0 - NEAR) * (1.0 - NEAR) * high;
    if !model.gyroscopic && model.precone_rad.abs() > CONED && near {
        let message = "first flap and lag are near one another: with this precone Coriolis terms part them by per cents (--gyroscopic on)";
        warnings.push(Warning { path: "rotor.precone".into(), message: message.into() });
    }
}

/// What stands in the way of Coriolis terms.
fn unturnable(cause: EigenError) -> Faults {
    if cause != EigenError::NotPositiveDefinite {
        return unsolvable(cause);
    }
    let rule = "needs a blade that is statically stable and held in every motion";
    Fault::new(FaultCode::Option, "gyroscopic", Some("on".into()), rule, format!("{rule} (is on)")).into()
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
    let unused = if blade.inertias_given() && blade.gives(Property::PolarInertia) {
        vec!["distribution.polar_inertia".into()]
    } else {
        Vec::new()
    };
    let model = ModelReport {
        kind: "coupled",
        pitch_rad: coupled.pitch,
        precone_rad: coupled.precone,
        trapeze: on,
        rotary: settings.rotary,
        gyroscopic: settings.gyroscopic,
        steady: false,
        cone: "held",
        propeller_moment: settings.propeller_moment.unwrap_or(PropellerMoment::Full).name(),
        unused,
        words: String::new(),
    };
    Ok((coupled, model.worded(), warnings))
}

/// Refuses sections whose mass would have negative inertia about its own centre.
fn possible(blade: &CoupledBlade) -> Result<(), Faults> {
    let fault = |found: Impossible| {
        let rule = "must be at least mass times mass_offset squared in the coupled model";
        let [from, to, r, own, least] =
            [found.stretch.0, found.stretch.1, found.r, found.inertia, found.least].map(|value| short(value, 4));
        let message = format!(
            "inertia of the stretch r = {from} to {to} m {rule} (at r = {r} m it is {own} kg·m, not {least}); the uncoupled model takes it"
        );
        Fault::new(FaultCode::OutOfRange, "distribution.polar_inertia", Some(own), rule, message)
    };
    Faults::from(blade.impossible().into_iter().map(fault).collect::<Vec<Fault>>()).none()
}
