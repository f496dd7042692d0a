//! One file per command: read, ask the core, render.

mod blades;
mod check;
mod converge;
mod fan;
mod modes;
mod shapes;

use crate::args::Command;
use crate::failure::Failure;
use crate::io::output::Output;

/// Runs a command; what it made is still to be written.
pub(crate) fn run(command: &Command) -> Result<Output, Failure> {
    match command {
        Command::Modes(args) => modes::run(args),
        Command::Fan(args) => fan::run(args),
        Command::Shapes(args) => shapes::run(args),
        Command::Converge(args) => converge::run(args),
        Command::Check(args) => check::run(args),
        Command::Blades(args) => blades::run(args),
    }
}
