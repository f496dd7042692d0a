//! Frequency against the number of assumed functions.

use super::ModelReport;
use crate::dof::Dof;
use crate::fault::Warning;
use crate::label::Label;
use alloc::string::String;
use alloc::vec::Vec;

report! {
    /// One mode against the number of assumed functions.
    ConvergeSeries {
        /// `1F`, …
        label: Label,
        /// Degree of freedom.
        dof: Dof,
        /// Number within the degree of freedom.
        number: usize,
        /// Frequency with as many functions as `functions` says; `None` where there are fewer
        /// functions than the mode's number.
        classical_rad_s: Vec<Option<f64>>,
        /// The converged frequency.
        converged_rad_s: Option<f64>,
        /// Its lower bound.
        lower_rad_s: Option<f64>,
        /// Its upper bound.
        upper_rad_s: Option<f64>,
        /// Numbers of piecewise functions: one polynomial per element, two, … until converged.
        piecewise_functions: Vec<usize>,
        /// Frequency with so many; `None` where they are too few for the mode.
        piecewise_rad_s: Vec<Option<f64>>,
    }
}
report! {
    /// Frequency against the number of assumed functions, at one speed.
    ConvergeReport {
        /// `bladefan-converge/1`.
        schema: &'static str,
        /// Name of the blade.
        blade: String,
        /// Rotor speed.
        speed_rad_s: f64,
        /// What is solved.
        model: ModelReport,
        /// Numbers of functions, 1, 2, …
        functions: Vec<usize>,
        /// One per mode.
        series: Vec<ConvergeSeries>,
        /// Warnings of the blade.
        warnings: Vec<Warning>,
    }
}
