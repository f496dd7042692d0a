//! Short ways to the facade.

use crate::blades::TestBlade;
use bladefan_core::BasisFamily;
use bladefan_core::Blade;
use bladefan_core::Dof;
use bladefan_core::report::ModeReport;
use bladefan_core::{ModelKind, Settings, modes};

/// Settings for one degree of freedom: `functions` classical functions, `count` modes, at `speed` [rad/s].
pub fn settings(dof: Dof, speed: f64, functions: usize, count: usize) -> Settings {
    Settings { basis: BasisFamily::Classical, functions, ..converged_settings(dof, speed, count) }
}

/// Settings for one degree of freedom: `count` modes of the piecewise functions at `speed` [rad/s].
pub fn converged_settings(dof: Dof, speed: f64, count: usize) -> Settings {
    Settings {
        basis: BasisFamily::Piecewise,
        speed: Some(speed),
        modes: count,
        dofs: vec![dof],
        ..Settings::of(ModelKind::Uncoupled)
    }
}

/// Modes of a checked blade.
///
/// # Panics
/// Where the product finds faults.
pub fn solve_with(blade: &Blade, settings: &Settings) -> Vec<ModeReport> {
    let report = modes(blade, settings).unwrap_or_else(|faults| panic!("{faults:?}"));
    assert_eq!(report.modes.len(), settings.modes * settings.dofs.len(), "as many modes as asked for");
    report.modes
}

/// Modes of one degree of freedom of a checked blade, of `functions` classical functions.
pub fn solve(blade: &Blade, dof: Dof, speed: f64, functions: usize, count: usize) -> Vec<ModeReport> {
    solve_with(blade, &settings(dof, speed, functions, count))
}

/// Converged frequencies [rad/s] of one degree of freedom of a test blade.
pub fn converged(blade: &TestBlade, dof: Dof, speed: f64, count: usize) -> Vec<f64> {
    let modes = solve_with(&blade.blade(), &converged_settings(dof, speed, count));
    modes.iter().map(|mode| mode.frequency_rad_s).collect()
}

/// Frequencies [rad/s] of one degree of freedom of a test blade, of `functions` classical functions.
pub fn frequencies(blade: &TestBlade, dof: Dof, speed: f64, functions: usize, count: usize) -> Vec<f64> {
    solve(&blade.blade(), dof, speed, functions, count).iter().map(|mode| mode.frequency_rad_s).collect()
}
