//! Modes at one speed.

use super::{BasisReport, ModelReport};
use crate::dof::Dof;
use crate::fault::Warning;
use crate::label::Label;
use alloc::string::String;
use alloc::vec::Vec;

report! {
    /// One mode at one speed.
    ModeReport {
        /// `1F`, `2F`, `1L`, `1T`, …
        label: Label,
        /// Degree of freedom.
        dof: Dof,
        /// Number within the degree of freedom, from 1, by ascending frequency.
        number: usize,
        /// Natural frequency.
        frequency_rad_s: f64,
        /// The same in Hz.
        frequency_hz: f64,
        /// The same per revolution; `None` at rest.
        per_rev: Option<f64>,
        /// Integer nearest to `per_rev`, at least 1; `None` at rest.
        nearest_harmonic: Option<u32>,
        /// `per_rev` less `nearest_harmonic`; `None` at rest.
        margin_per_rev: Option<f64>,
        /// Lower bound, where known.
        lower_rad_s: Option<f64>,
        /// Upper bound, where known.
        upper_rad_s: Option<f64>,
        /// √ρ: the bounds of this degree of freedom hold if the mode after the last one listed is not
        /// below it; `None` where there are none.
        separation_rad_s: Option<f64>,
        /// The paper's functions, as many as `--functions` says; `None` where that is fewer than the
        /// mode's number.
        classical_rad_s: Option<f64>,
        /// The piecewise functions.
        converged_rad_s: Option<f64>,
        /// ‖Gq − ω²Mq‖ / ‖ω²Mq‖ in the scaled basis; 0 for a rigid mode.
        residual: f64,
    }
}
report! {
    /// Modes at one speed, in the order flap, lag, torsion, ascending within each.
    ModesReport {
        /// `bladefan-modes/1`.
        schema: &'static str,
        /// Name of the blade.
        blade: String,
        /// Rotor speed.
        speed_rad_s: f64,
        /// What is solved.
        model: ModelReport,
        /// Assumed functions.
        basis: BasisReport,
        /// How many of the paper's functions are behind `classical_rad_s`.
        classical_functions: usize,
        /// The modes.
        modes: Vec<ModeReport>,
        /// Warnings of the blade.
        warnings: Vec<Warning>,
    }
}
report! {
    /// How far a mode is from the nearest harmonic.
    Margin {
        /// What the mode is called.
        label: Label,
        /// Its place among the branches of a fan chart, from 0; `None` at one speed.
        #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
        branch: Option<usize>,
        /// Frequency per revolution.
        per_rev: f64,
        /// Nearest integer, at least 1.
        nearest_harmonic: u32,
        /// `per_rev` less `nearest_harmonic`.
        margin_per_rev: f64,
    }
}
