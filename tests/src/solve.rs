//! Short ways to the facade.

use crate::blades::TestBlade;
use bladefan_core::analysis::{ModeReport, Settings, modes};
use bladefan_core::blade::Blade;
use bladefan_core::dof::Dof;

/// Settings for one degree of freedom: `functions` classical functions, `count` modes, at `speed` [rad/s].
pub fn settings(dof: Dof, speed: f64, functions: usize, count: usize) -> Settings {
    Settings { speed: Some(speed), modes: count, functions, dofs: vec![dof], ..Settings::default() }
}

/// Modes of one degree of freedom of a checked blade.
///
/// # Panics
/// Where the product finds faults.
pub fn solve(blade: &Blade, dof: Dof, speed: f64, functions: usize, count: usize) -> Vec<ModeReport> {
    let report = modes(blade, &settings(dof, speed, functions, count)).unwrap_or_else(|faults| panic!("{faults:?}"));
    assert_eq!(report.modes.len(), count, "as many modes as asked for");
    report.modes
}

/// Frequencies [rad/s] of one degree of freedom of a test blade.
pub fn frequencies(blade: &TestBlade, dof: Dof, speed: f64, functions: usize, count: usize) -> Vec<f64> {
    solve(&blade.blade(), dof, speed, functions, count).iter().map(|mode| mode.frequency_rad_s).collect()
}
