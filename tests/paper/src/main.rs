//! Writes the figures and tables of the paper anew; `--check` only says which would change.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program speaks")]

use bladefan_paper::{Cli, Output};
use std::env;
use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap_or(Path::new("."));
    let check = env::args().skip(1).any(|argument| argument == "--check");
    let cli = match Cli::find(root) {
        Ok(cli) => cli,
        Err(fault) => {
            eprintln!("reproduce-paper: {fault}");
            return ExitCode::FAILURE;
        }
    };
    let output = Output::of(&cli, root);
    let changed = if check { output.stale(root) } else { output.write(root) };
    for path in &changed {
        println!("{} {path}", if check { "stale:" } else { "wrote" });
    }
    println!("{} files and {} tables, {} changed", output.files.len(), output.parts.len(), changed.len());
    if check && !changed.is_empty() { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
