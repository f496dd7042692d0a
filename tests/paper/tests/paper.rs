//! `docs/paper` and the generated parts of `docs/VALIDATION.md` are what the command line prints now.

use bladefan_paper::{Cli, Output};
use std::env;
use std::path::Path;
use std::process::Command;

/// After a change that moves numbers on purpose: `scripts/reproduce-paper`.
#[test]
fn figures_and_tables_are_what_the_command_line_prints() -> Result<(), String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).ok_or("no root")?;
    // This package's tests alone do not build the command line, or leave an older one.
    if env::var_os("BLADEFAN").is_none() {
        let built =
            Command::new(env!("CARGO")).args(["build", "--quiet", "--locked", "--package", "bladefan"]).status();
        assert!(built.is_ok_and(|status| status.success()), "bladefan does not build");
    }
    let stale = Output::of(&Cli::find(root)?, root).stale(root);
    assert!(stale.is_empty(), "not what the command line prints now; scripts/reproduce-paper would change {stale:?}");
    Ok(())
}
