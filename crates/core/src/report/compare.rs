//! Measured points beside computed ones.

use crate::label::Label;
use alloc::string::String;

report! {
    /// A measured frequency, or one of another program.
    MeasuredPoint {
        /// Branch it belongs to, `1F`, …
        label: Label,
        /// Rotor speed.
        speed_rad_s: f64,
        /// Frequency.
        frequency_rad_s: f64,
        /// Who measured or computed it.
        source: String,
    }
}
report! {
    /// A measured point and what the solver gives at its rotor speed.
    ComparedPoint {
        /// Branch it belongs to, `1F`, …
        label: Label,
        /// Rotor speed.
        speed_rad_s: f64,
        /// Measured frequency.
        frequency_rad_s: f64,
        /// Who measured or computed it.
        source: String,
        /// Frequency of the same branch at the same rotor speed; `None` where the branch was not asked for.
        computed_rad_s: Option<f64>,
        /// `computed_rad_s` less the measured frequency, in percent of the measured one; `None` without
        /// the one, or where the other is 0.
        error_percent: Option<f64>,
    }
}
