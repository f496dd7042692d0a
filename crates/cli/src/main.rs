//! Command line of bladefan: reads a blade, asks the core, writes tables, JSON, CSV and drawings.

mod args;
mod commands;
mod csv;
mod drawing;
mod failure;
mod help;
mod input;
mod json;
mod output;
mod progress;
mod table;

use args::Cli;
use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = Cli::parse();
    match commands::run(&cli.command).and_then(|result| output::write(&result)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
