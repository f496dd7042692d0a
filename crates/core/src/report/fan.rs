//! Fan charts.

use super::BasisReport;
use super::Margin;
use crate::dof::Dof;
use crate::fault::Warning;
use crate::label::Label;
use alloc::string::String;
use alloc::vec::Vec;

report! {
    /// ω² ≈ k0 + k1 Ω² near rest.
    #[derive(Copy, Default)]
    Southwell {
        /// ω²(0) [rad²/s²].
        k0: f64,
        /// dω²/dΩ² at rest.
        k1: f64,
    }
}
report! {
    /// One mode over all speeds.
    Branch {
        /// `1F`, …
        label: Label,
        /// Degree of freedom.
        dof: Dof,
        /// Number within the degree of freedom.
        number: usize,
        /// Frequency at each speed of the chart.
        frequency_rad_s: Vec<f64>,
        /// Southwell coefficients.
        southwell: Southwell,
    }
}
report! {
    /// Where a branch meets an nP ray.
    Crossing {
        /// Branch.
        label: Label,
        /// n of the ray ω = nΩ.
        harmonic: u32,
        /// Rotor speed there, greater than 0.
        speed_rad_s: f64,
        /// Frequency there.
        frequency_rad_s: f64,
    }
}
report! {
    /// A branch that lies on an nP ray at every speed.
    Coincidence {
        /// Branch.
        label: Label,
        /// n of the ray.
        harmonic: u32,
    }
}
report! {
    /// Margins at the nominal rotor speed.
    Nominal {
        /// Nominal rotor speed.
        speed_rad_s: f64,
        /// One per branch.
        margins: Vec<Margin>,
    }
}
report! {
    /// Fan chart of one blade.
    FanChart {
        /// `bladefan-fan/1`.
        schema: &'static str,
        /// Name of the blade.
        blade: String,
        /// Number of blades, where given; marks the b, 2b, … rays.
        blades: Option<u32>,
        /// Rays 1P … nP that were looked at.
        harmonics: u32,
        /// Assumed functions.
        basis: BasisReport,
        /// Rotor speeds, ascending.
        speeds_rad_s: Vec<f64>,
        /// Branches in the order flap, lag, torsion, ascending within each.
        branches: Vec<Branch>,
        /// Crossings, in the order of the branches, then by harmonic, then by speed.
        crossings: Vec<Crossing>,
        /// Branches that lie on a ray.
        coincident: Vec<Coincidence>,
        /// Margins at nominal speed.
        nominal: Nominal,
        /// Warnings of the blade.
        warnings: Vec<Warning>,
    }
}
report! {
    /// One branch at one speed of a chart.
    #[derive(Copy)]
    ModeAtSpeed {
        /// Branch.
        label: Label,
        /// Frequency.
        frequency_rad_s: f64,
        /// The same per revolution; `None` at rest.
        per_rev: Option<f64>,
        /// Integer nearest to `per_rev`, at least 1; `None` at rest.
        nearest_harmonic: Option<u32>,
        /// `per_rev` less `nearest_harmonic`; `None` at rest.
        margin_per_rev: Option<f64>,
    }
}
