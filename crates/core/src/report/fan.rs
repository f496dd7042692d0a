//! Fan charts.

use super::{BasisReport, Margin, ModelReport};
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
        /// What it is called along the range; coupled alone.
        #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
        labels: Vec<BranchLabel>,
        /// Proven lower bounds at the speeds of the chart; coupled alone.
        #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
        lower_rad_s: Vec<Option<f64>>,
        /// Proven upper bounds at the speeds of the chart; coupled alone.
        #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
        upper_rad_s: Vec<Option<f64>>,
    }
}
report! {
    /// What a branch is called from a rotor speed on.
    #[derive(Copy)]
    BranchLabel {
        /// Rotor speed.
        from_rad_s: f64,
        /// By its leading motion there.
        label: Label,
    }
}
report! {
    /// Where two branches come nearest.
    #[derive(Copy)]
    VeeringReport {
        /// Indices of the branches, the lower one first.
        branches: [usize; 2],
        /// `crossing`, or `veering` where they turn away.
        kind: &'static str,
        /// Rotor speed there.
        speed_rad_s: f64,
        /// Distance of their frequencies.
        gap_rad_s: f64,
        /// Mean of their frequencies.
        frequency_rad_s: f64,
    }
}
report! {
    /// Where a branch meets an nP ray.
    Crossing {
        /// What the branch is called at this speed.
        label: Label,
        /// Its place among the branches, from 0.
        branch: usize,
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
        /// Its place among the branches, from 0.
        branch: usize,
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
        /// What is solved.
        model: ModelReport,
        /// Where branches come near one another, by rotor speed; coupled alone.
        #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
        veerings: Vec<VeeringReport>,
    }
}
report! {
    /// One branch at one speed of a chart.
    #[derive(Copy)]
    ModeAtSpeed {
        /// What the branch is called there.
        label: Label,
        /// Its place among the branches, from 0.
        branch: usize,
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

impl Branch {
    /// The leading motion at a rotor speed.
    pub fn dof_at(&self, speed_rad_s: f64) -> Dof {
        let named = self.labels.iter().rev().find(|named| named.from_rad_s <= speed_rad_s).or(self.labels.first());
        named.map_or(self.dof, |named| named.label.dof)
    }

    /// Whether a motion leads anywhere along it.
    pub fn leads(&self, dof: Dof) -> bool {
        if self.labels.is_empty() { self.dof == dof } else { self.labels.iter().any(|named| named.label.dof == dof) }
    }
}

impl FanChart {
    /// Whether a rotor speed [rad/s] lies in an operating band, which is given as ratios of nominal speed.
    pub fn in_band(&self, speed_rad_s: f64, band: (f64, f64)) -> bool {
        let nominal = self.nominal.speed_rad_s;
        (band.0 * nominal..=band.1 * nominal).contains(&speed_rad_s)
    }

    /// The crossings in an operating band, in their order.
    pub fn crossings_in(&self, band: (f64, f64)) -> impl Iterator<Item = &Crossing> {
        self.crossings.iter().filter(move |crossing| self.in_band(crossing.speed_rad_s, band))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::functions::BasisFamily;
    use crate::report::FunctionCounts;

    #[test]
    fn a_band_holds_its_ends() {
        let crossing = |speed_rad_s: f64| Crossing {
            label: Label::new(Dof::Flap, 1),
            branch: 0,
            harmonic: 1,
            speed_rad_s,
            frequency_rad_s: speed_rad_s,
        };
        let chart = FanChart {
            schema: "bladefan-fan/1",
            blade: String::new(),
            blades: None,
            harmonics: 1,
            basis: BasisReport { family: BasisFamily::Piecewise, functions: FunctionCounts::default() },
            speeds_rad_s: Vec::new(),
            branches: Vec::new(),
            crossings: [8.9, 0.9 * 10.0, 10.0, 1.1 * 10.0, 11.1, f64::NAN].map(crossing).into(),
            coincident: Vec::new(),
            nominal: Nominal { speed_rad_s: 10.0, margins: Vec::new() },
            warnings: Vec::new(),
            model: ModelReport::uncoupled("", "paper", Vec::new()),
            veerings: Vec::new(),
        };
        let speeds = |band: (f64, f64)| -> Vec<f64> { chart.crossings_in(band).map(|at| at.speed_rad_s).collect() };
        assert_eq!(speeds((0.9, 1.1)), [0.9 * 10.0, 10.0, 1.1 * 10.0]);
        assert_eq!(speeds((0.0, 0.5)), [0.0; 0]);
        assert_eq!(speeds((f64::NAN, 2.0)), [0.0; 0]);
    }
}
