//! Measured points beside the solver's answer at the same rotor speed.

use super::{Settings, modes};
use crate::blade::Blade;
use crate::fault::Faults;
use crate::report::{ComparedPoint, MeasuredPoint, ModesReport};
use alloc::vec::Vec;

/// Every point with the frequency of its branch at its own rotor speed. Solves once per speed;
/// [`Settings::speed`] is not looked at.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn compare(blade: &Blade, points: &[MeasuredPoint], settings: &Settings) -> Result<Vec<ComparedPoint>, Faults> {
    settings.check()?;
    let mut solved: Vec<ModesReport> = Vec::new();
    let mut compared = Vec::with_capacity(points.len());
    for point in points {
        let same = |report: &ModesReport| report.speed_rad_s.to_bits() == point.speed_rad_s.to_bits();
        if !solved.iter().any(same) {
            solved.push(modes(blade, &Settings { speed: Some(point.speed_rad_s), ..settings.clone() })?);
        }
        let mut modes = solved.iter().filter(|report| same(report)).flat_map(|report| &report.modes);
        let computed_rad_s = modes.find(|mode| mode.label == point.label).map(|mode| mode.frequency_rad_s);
        let error = |computed: f64| 100.0 * (computed / point.frequency_rad_s - 1.0);
        let error_percent = computed_rad_s.map(error).filter(|error| error.is_finite());
        let MeasuredPoint { label, speed_rad_s, frequency_rad_s, source } = point.clone();
        compared.push(ComparedPoint { label, speed_rad_s, frequency_rad_s, source, computed_rad_s, error_percent });
    }
    Ok(compared)
}
