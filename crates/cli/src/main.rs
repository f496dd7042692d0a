//! Command line of bladefan: reads a blade, asks the core, writes tables, JSON, CSV and drawings.
#![cfg_attr(
    test,
    allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")
)]

mod args;
mod commands;
mod failure;
mod help;
mod io;
mod render;

use args::Cli;
use clap::Parser;
use io::{messages, output};
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(said) => return messages::usage(said),
    };
    match commands::run(&cli.command).and_then(|made| output::write(&made)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => messages::report(&failure),
    }
}
