//! What is said on standard error. Results never stand there.

use crate::failure::Failure;
use crate::render::text::visible;
use anstyle::{AnsiColor, Style};
use bladefan_core::Warning;
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
    say(warnings.iter().map(warning));
}

fn warning(warning: &Warning) -> String {
    let style = Style::new().fg_color(Some(AnsiColor::Yellow.into()));
    format!("{style}warning:{style:#} {}", visible(&warning.to_string()))
}

/// Prints the help, the version or what is wrong with the command, and gives the exit code.
pub(crate) fn usage(said: clap::Error) -> ExitCode {
    let said = harmless(said);
    match said.print() {
        // Of standard error there is nobody left to tell.
        Err(error) if !said.use_stderr() => report(&Failure::write("standard output", &error)),
        _ => u8::try_from(said.exit_code()).map_or(ExitCode::FAILURE, ExitCode::from),
    }
}

/// The same with what it quotes of the command written out.
fn harmless(mut said: clap::Error) -> clap::Error {
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
    said
}

/// Lines on standard error. Where even that fails there is nobody left to tell.
fn say(lines: impl Iterator<Item = String>) {
    let mut stream = anstream::stderr().lock();
    for line in lines {
        let _ = writeln!(stream, "{line}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::args::Cli;
    use clap::Parser;

    #[test]
    fn warnings_have_a_colour_and_no_other() {
        let text = warning(&Warning { path: "a\u{1b}[0m".into(), message: "b".into() });
        assert_eq!(text, "\u{1b}[33mwarning:\u{1b}[0m a\\u{1b}[0m: b");
    }

    #[test]
    fn what_is_quoted_of_a_command_is_written_out() {
        for arguments in [["bladefan", "fly\u{1b}P"], ["bladefan", "--fly\u{1b}P"]] {
            let said = harmless(Cli::try_parse_from(arguments).unwrap_err()).to_string();
            assert!(said.contains("fly\\u{1b}P'") && said.contains("Usage: "), "{said:?}");
        }
    }

    #[test]
    fn exit_codes_are_the_failures() {
        assert_eq!(report(&Failure::Output("a".into())), ExitCode::FAILURE);
        assert_eq!(report(&Failure::input("a")), ExitCode::from(2));
        assert_eq!(report(&Failure::ClosedPipe), ExitCode::SUCCESS);
        let said = |line: &str| usage(Cli::try_parse_from(line.split(' ')).unwrap_err());
        assert_eq!(said("bladefan fly"), ExitCode::from(2));
        assert_eq!(said("bladefan --version"), ExitCode::SUCCESS);
    }
}
