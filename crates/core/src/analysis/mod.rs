//! The facade: what the command line and the page call. It composes the other rooms and adds no
//! formula of its own.

mod report;
mod settings;

pub use report::{
    BasisReport, BladeSummary, Branch, Coincidence, ConvergeReport, ConvergeSeries, Crossing, DofSummary, FanChart,
    FunctionCounts, Margin, MeasuredPoint, ModeReport, ModesReport, Nominal, ShapeReport, ShapesReport, Southwell,
};
pub use settings::{BasisFamily, Normalisation, Settings, SpeedRange};

use crate::blade::Blade;
use crate::fault::Fault;
use alloc::vec::Vec;

/// One plain line that says what the model is; it stands with every table and chart.
pub const MODEL: &str = "uncoupled, in vacuum, zero pitch, the paper's torsion term";

/// Frequencies of every degree of freedom asked for at one speed.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn modes(_blade: &Blade, _settings: &Settings) -> Result<ModesReport, Vec<Fault>> {
    Err(Vec::new())
}

/// Fan chart: branches over a range of speeds, crossings with the nP rays, margins at nominal
/// speed, Southwell coefficients.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn fan(_blade: &Blade, _settings: &Settings) -> Result<FanChart, Vec<Fault>> {
    Err(Vec::new())
}

/// Mode shapes along the span at one speed.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn shapes(_blade: &Blade, _settings: &Settings) -> Result<ShapesReport, Vec<Fault>> {
    Err(Vec::new())
}

/// Frequency against the number of assumed functions at one speed.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn converge(_blade: &Blade, _settings: &Settings) -> Result<ConvergeReport, Vec<Fault>> {
    Err(Vec::new())
}

/// Mass, inertia and static moments of a blade.
pub fn summary(_blade: &Blade) -> BladeSummary {
    BladeSummary::default()
}
