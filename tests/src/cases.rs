//! Cases kept as data under `tests/cases`: source, values, tolerance and why.

use crate::blades::{Hold, TestBlade, built_in};
use alloc::collections::BTreeMap;
use bladefan_core::Blade;
use bladefan_core::Dof;
use bladefan_core::formats::{Format, read};
use bladefan_core::report::ModeReport;
use bladefan_core::units::{RAD_S_PER_RPM, hz};
use bladefan_core::{ModelKind, Settings, modes};
use core::fmt::Write as _;
use serde::Deserialize;
use std::fs;
use std::path::{Path, PathBuf};

/// Frequencies of one blade from one source.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// What blade it is.
    pub title: String,
    /// Who found the values, and how.
    pub source: String,
    /// Name of a built-in blade, or of a file in `tests/cases/blades`.
    pub blade: String,
    /// A lag spring in place of the blade's [N·m/rad].
    pub lag_spring: Option<f64>,
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

    /// Every case of `tests/cases` with its name, in the order of the names.
    ///
    /// # Panics
    /// Where the folder cannot be read, or a file in it.
    pub fn all() -> Vec<(String, Self)> {
        let toml = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "toml");
        let entries = fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path());
        let mut paths: Vec<PathBuf> = entries.filter(toml).collect();
        paths.sort();
        let name = |path: &Path| path.file_stem().unwrap().to_str().unwrap().to_string();
        paths.iter().map(|path| (name(path), Self::read(&fs::read_to_string(path).unwrap()))).collect()
    }

    /// The blade.
    ///
    /// # Panics
    /// Where there is none, or it has faults.
    pub fn blade(&self) -> Blade {
        let blade = if Path::new(&self.blade).extension().is_some() {
            let text = fs::read_to_string(folder().join("blades").join(&self.blade)).unwrap();
            read(&text, Format::Toml).unwrap_or_else(|faults| panic!("{}: {faults:?}", self.blade)).blade
        } else {
            built_in(&self.blade)
        };
        let Some(spring) = self.lag_spring else { return blade };
        let mut changed = TestBlade::from(&blade);
        changed.roots[Dof::Lag.index()].hold = Hold::Spring(spring);
        changed.blade()
    }

    /// Compares every value with the product's.
    ///
    /// # Panics
    /// Where a unit is not known or the product has no answer.
    pub fn compare(&self) -> Vec<Compared> {
        let blade = &self.blade();
        let mut compared = Vec::new();
        for row in &self.rows {
            let speed = match self.speed_unit.as_str() {
                "rpm" => row[0] * RAD_S_PER_RPM,
                "rad/s" => row[0],
                unit => panic!("unit {unit}"),
            };
            let settings = Settings { speed: Some(speed), ..Settings::of(ModelKind::Uncoupled) };
            let report = modes(blade, &settings).unwrap_or_else(|faults| panic!("{faults:?}"));
            for (label, &expected) in self.labels.iter().zip(&row[1..]) {
                let mode: &ModeReport =
                    report.modes.iter().find(|mode| mode.label.to_string() == *label).expect("a known label");
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

    /// The tolerance in words, like "1F to 3F 1 %, 1T 2 %, and 0.01 Hz".
    pub fn tolerance_in_words(&self) -> String {
        let mut parts: Vec<(&str, &str, f64)> = Vec::new();
        for label in &self.labels {
            let value = self.tolerance[label];
            match parts.last_mut() {
                Some((_, last, same)) if same.to_bits() == value.to_bits() => *last = label,
                _ => parts.push((label, label, value)),
            }
        }
        let words = |&(first, last, value): &(&str, &str, f64)| {
            let modes = if first == last { first.to_string() } else { format!("{first} to {last}") };
            if value > 0.0 { format!("{modes} {} %", per_cent(value)) } else { String::new() }
        };
        let mut all: Vec<String> = parts.iter().map(words).filter(|part| !part.is_empty()).collect();
        if self.digits > 0.0 {
            all.push(format!("{} {} for the digits printed", self.digits, self.frequency_unit));
        }
        all.join(", ")
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

/// A part in per cent, without the last digits that a conversion leaves.
fn per_cent(part: f64) -> String {
    let text = format!("{:.3e}", 100.0 * part);
    let value: f64 = text.parse().unwrap();
    if value < 1e-3 { format!("{value:e}") } else { value.to_string() }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("cases")
}
