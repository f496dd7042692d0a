//! The facade: what the command line and the page call. It composes the other rooms and adds no
//! formula of its own.

mod at_speed;
mod basis;
mod compare;
mod converge;
mod coupled;
mod coupled_converge;
mod coupled_fan;
mod coupled_shapes;
mod fan;
mod fitted;
mod model;
mod modes;
mod settings;
mod shapes;
mod summary;

pub use at_speed::{Curve, at_speed};
pub use compare::compare;
pub use converge::converge;
pub use coupled::coupled_modes;
pub use coupled_shapes::coupled_shapes;
pub use fan::fan;
pub use model::{MODEL, Model, warnings};
pub use modes::{margins, modes};
pub use settings::{ModelKind, PAPER_FUNCTIONS, Settings, ShapeScale, SpeedRange};
pub use shapes::shapes;
pub use summary::summary;

use crate::converged::TOLERANCE;
use crate::dof::Dof;
use crate::fault::{Fault, FaultCode, Faults, Warning};
use crate::label::Label;
use crate::lagrange::SystemMatrices;
use crate::modes::{Mode, SolveError, solve as solve_modes};
use crate::numerics::eigen::EigenError;
use crate::numerics::scalar::{is_above, maximum, round, sqrt};
use crate::report::Margin;
use alloc::format;
use alloc::string::ToString;
use alloc::vec::Vec;

/// As many modes as so few functions determine.
fn available(matrices: &SystemMatrices, speed_squared: f64, count: usize) -> Result<Vec<Mode>, SolveError> {
    match solve_modes(matrices, speed_squared, count) {
        Err(SolveError { cause: EigenError::TooFewModes(0), .. }) => Ok(Vec::new()),
        Err(SolveError { cause: EigenError::TooFewModes(left), .. }) => solve_modes(matrices, speed_squared, left),
        other => other,
    }
}

fn unsolvable(error: SolveError) -> Faults {
    let rule = "the equations of the degree of freedom must have an answer";
    let dof = error.dofs.first().map_or("", |dof| dof.name());
    Fault::new(FaultCode::Unsolvable, dof, None, rule, error.to_string()).into()
}

/// Says so where frequencies did not reach their tolerance.
fn note(warnings: &mut Vec<Warning>, dof: Dof, error: f64) {
    let message = if error.is_nan() {
        format!("{dof} frequencies are of unknown error")
    } else if error > TOLERANCE {
        // A frequency has half the error of its eigenvalue.
        format!("{dof} frequencies are converged to {:.0e} only, not to {:.0e}", 0.5 * error, 0.5 * TOLERANCE)
    } else {
        return;
    };
    warnings.push(Warning { path: dof.name().to_string(), message });
}

/// Says so where branches turn too sharply for their curves, on which crossings are found.
fn note_crossings(warnings: &mut Vec<Warning>, dof: Dof, error: f64) {
    if is_above(error, TOLERANCE) {
        let message =
            format!("{dof} crossings are found to {:.0e} only: branches turn too sharply for curves", 0.5 * error);
        warnings.push(Warning { path: dof.name().to_string(), message });
    }
}

/// ω of an eigenvalue of fitted curves. Those of one degree of freedom are not negative, or the
/// eigenproblem refuses the blade; so what lies below 0 is the rounding of a curve that is 0.
fn frequency(eigenvalue: f64) -> f64 {
    sqrt(maximum(eigenvalue, 0.0))
}

/// Says so where a degree of freedom has no bounds, and why.
fn note_bounds(warnings: &mut Vec<Warning>, dof: Dof, bounded: bool) {
    if !bounded {
        let message = format!(
            "{dof} frequencies have no bounds: the modes could not be counted along the blade to confirm that none was missed"
        );
        warnings.push(Warning { path: dof.name().to_string(), message });
    }
}

/// Says so where there are fewer modes than asked for.
fn note_fewer(warnings: &mut Vec<Warning>, dof: Dof, found: usize, asked: usize) {
    if found < asked {
        let message =
            format!("only {found} of {asked} {dof} modes can be told from rounding: mass or stiffness varies too much");
        warnings.push(Warning { path: dof.name().to_string(), message });
    }
}

fn margin(label: Label, per_rev: f64) -> Margin {
    let nearest = round(per_rev).max(1.0);
    // A frequency of more than 4 billion per revolution keeps the largest harmonic there is.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at least 1; the cast saturates")]
    let nearest_harmonic = nearest as u32;
    Margin { label, branch: None, per_rev, nearest_harmonic, margin_per_rev: per_rev - nearest }
}
