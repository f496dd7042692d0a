//! Cases kept as data under `tests/cases`: source, values, tolerance and why.

use crate::blades::built_in;
use alloc::collections::BTreeMap;
use bladefan_core::analysis::{BasisFamily, ModeReport, Settings, modes};
use bladefan_core::blade::Blade;
use bladefan_core::units::{RAD_S_PER_RPM, hz};
use core::fmt::Write as _;
use serde::Deserialize;

/// Frequencies of one blade from one source.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// Who found the values, and how.
    pub source: String,
    /// Name of the built-in blade.
    pub blade: String,
    /// Number of classical functions to compare with.
    pub functions: usize,
    /// Unit of the speeds: `rpm` or `rad/s`.
    pub speed_unit: String,
    /// Unit of the frequencies: `Hz` or `rad/s`.
    pub frequency_unit: String,
    /// What rounding to the digits that the source prints may amount to, in its unit.
    pub digits: f64,
    /// Relative difference allowed for each mode, beyond `digits`.
    pub tolerance: BTreeMap<String, f64>,
    /// Why these tolerances.
    pub why: String,
    /// Labels of the columns of `rows`, after the speed.
    pub labels: Vec<String>,
    /// Speed, then one frequency per label.
    pub rows: Vec<Vec<f64>>,
}

/// One value of a case beside the product's.
#[derive(Clone, Debug)]
pub struct Compared {
    /// Speed in the case's unit.
    pub speed: f64,
    /// Mode.
    pub label: String,
    /// The source's value, in its unit.
    pub expected: f64,
    /// The product's value, in the same unit.
    pub found: f64,
    /// Whether it is within the tolerance.
    pub holds: bool,
}

impl Case {
    /// Reads a case.
    ///
    /// # Panics
    /// Where the text is not a case.
    pub fn read(text: &str) -> Self {
        let case: Self = toml::from_str(text).unwrap_or_else(|error| panic!("{error}"));
        assert!(case.rows.iter().all(|row| row.len() == case.labels.len() + 1), "as many columns as labels");
        assert!(case.labels.iter().all(|label| case.tolerance.contains_key(label)), "a tolerance for each label");
        case
    }

    /// Compares every value with the built-in blade.
    pub fn compare(&self) -> Vec<Compared> {
        self.compare_with(&built_in(&self.blade))
    }

    /// Compares every value with another blade.
    ///
    /// # Panics
    /// Where a unit is not known or the product has no answer.
    pub fn compare_with(&self, blade: &Blade) -> Vec<Compared> {
        let mut compared = Vec::new();
        for row in &self.rows {
            let speed = match self.speed_unit.as_str() {
                "rpm" => row[0] * RAD_S_PER_RPM,
                "rad/s" => row[0],
                unit => panic!("unit {unit}"),
            };
            let settings = Settings {
                basis: BasisFamily::Classical,
                speed: Some(speed),
                functions: self.functions,
                ..Settings::default()
            };
            let report = modes(blade, &settings).unwrap_or_else(|faults| panic!("{faults:?}"));
            for (label, &expected) in self.labels.iter().zip(&row[1..]) {
                let mode: &ModeReport = report.modes.iter().find(|mode| mode.label == *label).expect("a known label");
                let found = match self.frequency_unit.as_str() {
                    "Hz" => hz(mode.frequency_rad_s),
                    "rad/s" => mode.frequency_rad_s,
                    unit => panic!("unit {unit}"),
                };
                let holds = (found - expected).abs() <= self.digits + self.tolerance[label] * expected;
                compared.push(Compared { speed: row[0], label: label.clone(), expected, found, holds });
            }
        }
        compared
    }

    /// The comparison as a table, one line per speed; printed by failing tests, and by
    /// `cargo test -p bladefan-tests --test literature -- --nocapture`.
    pub fn table(&self, compared: &[Compared]) -> String {
        let mut text = format!("{}\n{:>8}", self.source.trim(), self.speed_unit);
        for label in &self.labels {
            let _ = write!(text, " {:>25}", format!("{label} [{}]", self.frequency_unit));
        }
        for line in compared.chunks(self.labels.len()) {
            let _ = write!(text, "\n{:8}", line[0].speed);
            for value in line {
                let off = if value.expected > 0.0 { 100.0 * (value.found / value.expected - 1.0) } else { 0.0 };
                let mark = if value.holds { ' ' } else { '!' };
                let _ = write!(text, " {:9.3} {:9.3}{off:+5.1}%{mark}", value.expected, value.found);
            }
        }
        text
    }
}
