//! What can go wrong, in which words, and the exit code of each.

use bladefan_core::{Fault, FaultCode};
use std::io;
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

    /// What there is to say, line by line.
    pub(crate) fn lines(&self) -> &[String] {
        match self {
            Self::Input(lines) => lines,
            Self::Output(line) => core::slice::from_ref(line),
            Self::ClosedPipe => &[],
        }
    }

    /// How the program ends.
    pub(crate) fn code(&self) -> ExitCode {
        match self {
            Self::Input(_) => ExitCode::from(BAD_INPUT),
            Self::Output(_) => ExitCode::FAILURE,
            Self::ClosedPipe => ExitCode::SUCCESS,
        }
    }
}

fn option_line(fault: &Fault) -> String {
    format!("--{}: {}", fault.path.replace('_', "-"), fault.message)
}

/// An error of the system in our words where there are shorter ones, without its number.
pub(crate) fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    let text = text.split(" (os error").next().unwrap_or_default();
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_stand_under_their_file_and_options_under_their_name() {
        let mut placed = Fault::new(FaultCode::WrongType, "name", None, "rule", "must be text");
        (placed.line, placed.column) = (Some(2), Some(8));
        let whole = Fault::new(FaultCode::Unsolvable, "", None, "rule", "no answer");
        let option = Fault::new(FaultCode::Option, "up_to", None, "rule", "must be less");
        let failure = Failure::faults("a.toml", &[placed, whole, option.clone()]);
        assert_eq!(failure.lines(), ["a.toml:2:8: name: must be text", "a.toml: no answer", "--up-to: must be less"]);
        let both = Failure::both(Some(Failure::input("a")), Some(&option));
        assert_eq!(both.lines(), ["a", "--up-to: must be less"]);
    }

    #[test]
    fn errors_of_the_system_lose_their_numbers() {
        let error = io::Error::from_raw_os_error(2);
        assert_eq!(Failure::write("a", &error).lines(), ["a: cannot be written: no such file or directory"]);
    }

    #[test]
    fn a_reader_that_has_gone_is_told_nothing() {
        let gone = Failure::write("a", &io::Error::from(io::ErrorKind::BrokenPipe));
        assert!(gone.lines().is_empty() && matches!(gone, Failure::ClosedPipe), "{gone:?}");
    }
}
