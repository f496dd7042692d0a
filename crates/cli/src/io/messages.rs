//! What is said on standard error. Results never stand there.

use crate::failure::Failure;
use crate::render::text::visible;
use anstyle::{AnsiColor, Style};
use bladefan_core::fault::Warning;
use clap::error::ContextValue;
use std::io::Write;
use std::process::ExitCode;

/// Says what went wrong and gives the exit code.
pub(crate) fn report(failure: &Failure) -> ExitCode {
    say(failure.lines().iter().map(|line| visible(line)));
    failure.code()
}

/// Warnings: of a blade, or of options that do nothing.
pub(crate) fn warn(warnings: &[Warning]) {
    let style = Style::new().fg_color(Some(AnsiColor::Yellow.into()));
    say(warnings.iter().map(|warning| format!("{style}warning:{style:#} {}", visible(&warning.to_string()))));
}

/// Prints the help, the version or what is wrong with the command, and gives the exit code.
pub(crate) fn usage(mut said: clap::Error) -> ExitCode {
    let texts: Vec<_> = said
        .context()
        .filter_map(|(kind, value)| match value {
            ContextValue::String(text) => Some((kind, visible(text))),
            _ => None,
        })
        .collect();
    for (kind, text) in texts {
        said.insert(kind, ContextValue::String(text));
    }
    match said.print() {
        // Of standard error there is nobody left to tell.
        Err(error) if !said.use_stderr() => report(&Failure::write("standard output", &error)),
        _ => u8::try_from(said.exit_code()).map_or(ExitCode::FAILURE, ExitCode::from),
    }
}

/// Lines on standard error. Where even that fails there is nobody left to tell.
fn say(lines: impl Iterator<Item = String>) {
    let mut stream = anstream::stderr().lock();
    for line in lines {
        let _ = writeln!(stream, "{line}");
    }
}
