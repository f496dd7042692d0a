//! What can go wrong, how it is said on standard error, and the exit code of each.

use anstyle::{AnsiColor, Style};
use bladefan_core::fault::{Fault, FaultCode, Warning};
use std::io::{self, Write};
use std::process::ExitCode;

/// Exit code of bad usage and bad input.
const BAD_INPUT: u8 = 2;

/// Why a command ended without its result.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Bad usage or bad input, one line each.
    Input(Vec<String>),
    /// Anything else: an output that cannot be written.
    Output(String),
    /// The reader of standard output has gone; nobody is left to tell.
    ClosedPipe,
}

impl Failure {
    /// Faults of options, as `--name: message`.
    pub(crate) fn options(faults: &[Fault]) -> Self {
        Self::Input(faults.iter().map(option_line).collect())
    }

    /// A failure of options and a fault of one more; at least one of them is there.
    pub(crate) fn both(failure: Option<Self>, fault: Option<&Fault>) -> Self {
        let mut lines = match failure {
            Some(Self::Input(lines)) => lines,
            Some(other) => return other,
            None => Vec::new(),
        };
        lines.extend(fault.map(option_line));
        Self::Input(lines)
    }

    /// Faults found while working on `file`, as `file:line:column: path: message`; those of options
    /// by the option's name.
    pub(crate) fn faults(file: &str, faults: &[Fault]) -> Self {
        let line = |fault: &Fault| match fault {
            Fault { code: FaultCode::Option, .. } => option_line(fault),
            Fault { line: Some(_), column: Some(_), .. } => format!("{file}:{fault}"),
            _ => format!("{file}: {fault}"),
        };
        Self::Input(faults.iter().map(line).collect())
    }

    /// One bad input without a place in a text.
    pub(crate) fn input(message: impl Into<String>) -> Self {
        Self::Input(vec![message.into()])
    }

    /// A write that failed; `what` is the file or the stream.
    pub(crate) fn write(what: impl core::fmt::Display, error: &io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::ClosedPipe,
            _ => Self::Output(format!("{what}: cannot be written: {}", reason(error))),
        }
    }

    /// Says what went wrong and gives the exit code.
    pub(crate) fn report(&self) -> ExitCode {
        match self {
            Self::Input(lines) => {
                say(lines.iter());
                ExitCode::from(BAD_INPUT)
            }
            Self::Output(line) => {
                say([line].into_iter());
                ExitCode::FAILURE
            }
            Self::ClosedPipe => ExitCode::SUCCESS,
        }
    }
}

fn option_line(fault: &Fault) -> String {
    format!("--{}: {}", fault.path.replace('_', "-"), fault.message)
}

/// Warnings of a blade on standard error.
pub(crate) fn warn(warnings: &[Warning]) {
    let style = Style::new().fg_color(Some(AnsiColor::Yellow.into()));
    say(warnings.iter().map(|warning| format!("{style}warning:{style:#} {warning}")));
}

/// Lines on standard error. Where even that fails there is nobody left to tell.
fn say(lines: impl Iterator<Item = impl core::fmt::Display>) {
    let mut stream = anstream::stderr().lock();
    for line in lines {
        let _ = writeln!(stream, "{line}");
    }
}

/// An error of the system in our words where there are shorter ones, without its number.
pub(crate) fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    let text = text.split(" (os error").next().unwrap_or_default();
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}
