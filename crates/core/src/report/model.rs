//! What is solved.

use crate::figures::short;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

report! {
    /// What acts in a model.
    ModelReport {
        /// `uncoupled` or `coupled`.
        kind: &'static str,
        /// Collective pitch, nose up.
        pitch_rad: f64,
        /// Precone, tip up.
        precone_rad: f64,
        /// Whether the tension of the fibres stiffens torsion.
        trapeze: bool,
        /// Whether sections have rotary inertia in bending.
        rotary: bool,
        /// Whether Coriolis terms act.
        gyroscopic: bool,
        /// Whether the blade vibrates about its steady shape at speed.
        steady: bool,
        /// `held`: the precone is the geometric one.
        cone: &'static str,
        /// `full` or `paper`.
        propeller_moment: &'static str,
        /// Paths of what the blade gives and the model does not use.
        unused: Vec<String>,
        /// The same in one plain line, which stands with every table and chart.
        words: String,
    }
}
impl ModelReport {
    /// Flap, lag and torsion each on its own.
    pub(crate) fn uncoupled(words: &str, propeller_moment: &'static str, unused: Vec<String>) -> Self {
        Self {
            kind: "uncoupled",
            pitch_rad: 0.0,
            precone_rad: 0.0,
            trapeze: false,
            rotary: false,
            gyroscopic: false,
            steady: false,
            cone: "held",
            propeller_moment,
            unused,
            words: words.to_string(),
        }
    }

    /// With its line.
    pub(crate) fn worded(self) -> Self {
        let degrees = |angle: f64| format!("{}°", short(angle.to_degrees(), 4));
        let switch = |name: &str, on: bool| format!("{name} {}", if on { "on" } else { "off" });
        let moment =
            if self.propeller_moment == "paper" { "the paper's propeller moment" } else { "full propeller moment" };
        let words = format!(
            "coupled, in vacuum, pitch {}, precone {}, {}, {}, {moment}, {} gyroscopic terms, no steady deflection",
            degrees(self.pitch_rad),
            degrees(self.precone_rad),
            switch("trapeze", self.trapeze),
            switch("rotary inertia", self.rotary),
            if self.gyroscopic { "with" } else { "no" },
        );
        Self { words, ..self }
    }
}
