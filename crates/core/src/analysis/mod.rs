//! The facade: what the command line and the page call. It composes the other rooms and adds no
//! formula of its own.

mod at_speed;
mod basis;
mod compare;
mod converge;
mod fan;
mod model;
mod modes;
mod settings;
mod shapes;
mod summary;

pub use at_speed::at_speed;
pub use compare::compare;
pub use converge::converge;
pub use fan::fan;
pub use model::{MODEL, Model, warnings};
pub use modes::{margins, modes};
pub use settings::{Settings, ShapeScale, SpeedRange};
pub use shapes::shapes;
pub use summary::summary;

use crate::converged::TOLERANCE;
use crate::dof::Dof;
use crate::fault::{Fault, FaultCode, Faults, Warning};
use crate::label::Label;
use crate::lagrange::SystemMatrices;
use crate::modes::{Mode, SolveError, solve as solve_modes};
use crate::numerics::eigen::EigenError;
use crate::numerics::scalar::round;
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
    Fault::new(FaultCode::Unsolvable, error.dof.name(), None, rule, error.to_string()).into()
}

/// Says so where the piecewise functions did not reach their tolerance.
fn note(warnings: &mut Vec<Warning>, dof: Dof, error: f64) {
    if error > TOLERANCE {
        warnings.push(Warning {
            path: dof.name().to_string(),
            message: format!("{dof} frequencies are converged to {:.0e} only, not to {TOLERANCE:.0e}", 0.5 * error),
        });
    }
}

fn margin(label: Label, per_rev: f64) -> Margin {
    let nearest = round(per_rev).max(1.0);
    // A frequency of more than 4 billion per revolution keeps the largest harmonic there is.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at least 1; the cast saturates")]
    let nearest_harmonic = nearest as u32;
    Margin { label, per_rev, nearest_harmonic, margin_per_rev: per_rev - nearest }
}
