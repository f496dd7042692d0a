//! Measured points beside the solver's answer at the same rotor speed.

use crate::failure::Failure;
use crate::input::{Input, read_text};
use bladefan_core::analysis::{self, Settings};
use bladefan_core::formats;
use bladefan_core::report::{ComparedPoint, MeasuredPoint};
use std::path::Path;

/// Reads measured points.
pub(super) fn read(path: &Path) -> Result<Vec<MeasuredPoint>, Failure> {
    let text = read_text(path)?;
    formats::measured::read(&text).map_err(|faults| Failure::faults(&path.display().to_string(), &faults))
}

/// Solves at the rotor speed of every point.
pub(super) fn compare(
    points: &[MeasuredPoint],
    input: &Input,
    settings: &Settings,
) -> Result<Vec<ComparedPoint>, Failure> {
    analysis::compare(&input.file.blade, points, settings).map_err(|faults| Failure::faults(&input.name, &faults))
}
