//! The program as its users run it.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop")]

mod faults;
mod help;
mod inputs;
mod layout;
mod names;
mod options;
mod outputs;
mod results;
mod tables;

use assert_cmd::Command;
use std::path::Path;

/// What a run of the program gave.
#[derive(Debug)]
struct Run {
    code: Option<i32>,
    stdout: String,
    stderr: String,
}

/// The program, with no colour settings from outside.
fn program(arguments: &[&str]) -> Command {
    let mut command: Command = assert_cmd::cargo::cargo_bin_cmd!("bladefan");
    command.args(arguments).env_remove("NO_COLOR").env_remove("CLICOLOR_FORCE").env_remove("CLICOLOR");
    command
}

fn finish(mut command: Command) -> Run {
    let output = command.output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    Run { code: output.status.code(), stdout: text(output.stdout), stderr: text(output.stderr) }
}

/// Runs the program.
fn run(arguments: &[&str]) -> Run {
    finish(program(arguments))
}

/// Runs the program in a folder.
fn run_in(folder: &Path, arguments: &[&str]) -> Run {
    let mut command = program(arguments);
    command.current_dir(folder);
    finish(command)
}

/// Runs the program with a text on standard input.
fn run_with(input: impl Into<Vec<u8>>, arguments: &[&str]) -> Run {
    let mut command = program(arguments);
    command.write_stdin(input);
    finish(command)
}

impl Run {
    /// Standard output of a run that went well.
    fn good(self) -> String {
        assert_eq!(self.code, Some(0), "{self:#?}");
        self.stdout
    }

    /// Standard error of a run that was refused: exit code 2, nothing on standard output.
    fn refused(self) -> String {
        assert_eq!((self.code, self.stdout.as_str()), (Some(2), ""), "{self:#?}");
        self.stderr
    }

    /// Standard error of a run that could not write: exit code 1, nothing on standard output.
    fn failed(self) -> String {
        assert_eq!((self.code, self.stdout.as_str()), (Some(1), ""), "{self:#?}");
        self.stderr
    }
}

const BUILT_IN: [&str; 7] = ["tm4760", "sa330", "uh60a", "bo105", "hingeless-1000", "uniform", "twisted"];

/// The file of a built-in blade.
fn toml(name: &str) -> &'static str {
    bladefan_core::library::find(name).unwrap().toml
}
