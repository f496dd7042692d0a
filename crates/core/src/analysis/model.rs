//! What the model is, in words.

/// One plain line that says what the model is; it stands with every table and chart.
pub const MODEL: &str = "uncoupled, in vacuum, zero pitch, the paper's torsion term";
