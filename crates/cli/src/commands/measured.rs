//! Measured points beside the solver's answer at the same rotor speed.

use crate::failure::Failure;
use crate::input::{Input, read_text};
use bladefan_core::analysis::{self, MeasuredPoint, ModesReport, Settings};
use bladefan_core::file;
use serde::Serialize;
use std::path::Path;

/// A measured point and what the solver gives at its rotor speed.
#[derive(Debug, Serialize)]
pub(crate) struct Compared<'a> {
    #[serde(flatten)]
    pub(crate) point: &'a MeasuredPoint,
    /// Frequency of the same branch at the same rotor speed; none where the branch was not asked for.
    pub(crate) computed_rad_s: Option<f64>,
    /// `computed_rad_s` less the measured frequency, in percent of the measured one.
    pub(crate) error_percent: Option<f64>,
}

/// Reads measured points.
pub(super) fn read(path: &Path) -> Result<Vec<MeasuredPoint>, Failure> {
    let text = read_text(path)?;
    file::measured::read(&text).map_err(|faults| Failure::faults(&path.display().to_string(), &faults))
}

/// Solves at the rotor speed of every point.
pub(super) fn compare<'a>(
    points: &'a [MeasuredPoint],
    input: &Input,
    settings: &Settings,
) -> Result<Vec<Compared<'a>>, Failure> {
    let mut solved: Vec<ModesReport> = Vec::new();
    let mut compared = Vec::with_capacity(points.len());
    for point in points {
        let same = |report: &ModesReport| report.speed_rad_s.to_bits() == point.speed_rad_s.to_bits();
        if !solved.iter().any(same) {
            let settings = Settings { speed: Some(point.speed_rad_s), ..settings.clone() };
            let report = analysis::modes(&input.file.blade, &settings);
            solved.push(report.map_err(|faults| Failure::faults(&input.name, &faults))?);
        }
        let mut modes = solved.iter().filter(|report| same(report)).flat_map(|report| &report.modes);
        let computed_rad_s = modes.find(|mode| mode.label == point.label).map(|mode| mode.frequency_rad_s);
        let error = |computed: f64| 100.0 * (computed / point.frequency_rad_s - 1.0);
        let error_percent = computed_rad_s.map(error).filter(|error| error.is_finite());
        compared.push(Compared { point, computed_rad_s, error_percent });
    }
    Ok(compared)
}
