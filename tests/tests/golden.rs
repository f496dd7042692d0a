//! Files of the repository that a command prints.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use bladefan_core::Settings;
use bladefan_core::chart::{self, ChartOptions};
use bladefan_core::formats::{Format, read};
use bladefan_core::library;

/// The README's picture is what its command draws now. To make it anew:
/// `cargo run --release -p bladefan -- fan tm4760 --svg docs/images/fan-tm4760.svg`
#[test]
fn the_readme_shows_what_its_command_draws() {
    let entry = library::find("tm4760").unwrap();
    let blade = read(entry.toml, Format::Toml).unwrap().blade;
    let fan = bladefan_core::fan(&blade, &Settings::default()).unwrap();
    let drawn = chart::fan(&fan, &ChartOptions::default()).svg;
    let stands = include_str!("../../docs/images/fan-tm4760.svg");
    // Not assert_eq!, which would print both drawings.
    assert!(drawn.trim_end() == stands.trim_end(), "docs/images/fan-tm4760.svg is not what the command draws");
}
