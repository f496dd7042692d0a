//! Results as users get them: the JSON of the command line and the objects of the page.
//! Frequencies and speeds are in rad/s unless the name says otherwise.

use super::settings::BasisFamily;
use crate::dof::Dof;
use crate::fault::Warning;
use alloc::string::String;
use alloc::vec::Vec;

/// Declares a result type: public fields, `Debug`, `Clone`, and `Serialize` where asked for.
macro_rules! report {
    ($(#[$doc:meta])* $name:ident { $($(#[$fdoc:meta])* $field:ident: $type:ty),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize))]
        pub struct $name { $($(#[$fdoc])* pub $field: $type),+ }
    };
}

report! {
    /// How many assumed functions each degree of freedom was given; `None` where it was not asked for.
    #[derive(Copy, Default)]
    FunctionCounts {
        /// Flap.
        flap: Option<usize>,
        /// Lag.
        lag: Option<usize>,
        /// Torsion.
        torsion: Option<usize>,
    }
}
impl FunctionCounts {
    /// Sets the number of one degree of freedom.
    pub fn set(&mut self, dof: Dof, count: usize) {
        match dof {
            Dof::Flap => self.flap = Some(count),
            Dof::Lag => self.lag = Some(count),
            Dof::Torsion => self.torsion = Some(count),
        }
    }
}
report! {
    /// The assumed functions behind a result.
    #[derive(Copy)]
    BasisReport {
        /// Family.
        family: BasisFamily,
        /// Number of functions.
        functions: FunctionCounts,
    }
}
report! {
    /// One mode at one speed.
    ModeReport {
        /// `1F`, `2F`, `1L`, `1T`, …
        label: String,
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
        label: String,
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
        label: String,
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
        label: String,
        /// n of the ray.
        harmonic: u32,
    }
}
report! {
    /// How far a mode is from the nearest harmonic.
    Margin {
        /// Branch.
        label: String,
        /// Frequency per revolution.
        per_rev: f64,
        /// Nearest integer, at least 1.
        nearest_harmonic: u32,
        /// `per_rev` less `nearest_harmonic`.
        margin_per_rev: f64,
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
    /// A measured frequency, or one of another program.
    MeasuredPoint {
        /// Branch it belongs to, `1F`, …
        label: String,
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
        label: String,
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
report! {
    /// One mode shape.
    ShapeReport {
        /// `1F`, …
        label: String,
        /// Degree of freedom.
        dof: Dof,
        /// Number within the degree of freedom.
        number: usize,
        /// Natural frequency.
        frequency_rad_s: f64,
        /// How far from orthogonal to the other shapes listed of its degree of freedom: the largest
        /// |∫ m X_i X_j dr| / √(∫ m X_i² dr ∫ m X_j² dr), in torsion with ρI_p for m (Eq. 84–85); 0 for one shape.
        orthogonality: f64,
        /// Displacement (bending) or twist (torsion) at each radius, tip positive; 0 inboard of the root.
        displacement: Vec<f64>,
        /// Slope [1/m] per metre or radian of displacement.
        slope: Vec<f64>,
        /// Bending or twisting moment [N·m] per metre or radian of displacement, from equilibrium.
        moment: Vec<f64>,
    }
}
report! {
    /// Mode shapes at one speed.
    ShapesReport {
        /// `bladefan-shapes/1`.
        schema: &'static str,
        /// Name of the blade.
        blade: String,
        /// Rotor speed.
        speed_rad_s: f64,
        /// Assumed functions.
        basis: BasisReport,
        /// Radii from the least offset to the tip, ends included.
        r_m: Vec<f64>,
        /// Tip radius.
        radius_m: f64,
        /// The shapes.
        shapes: Vec<ShapeReport>,
        /// Warnings of the blade.
        warnings: Vec<Warning>,
    }
}
report! {
    /// One mode against the number of assumed functions.
    ConvergeSeries {
        /// `1F`, …
        label: String,
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
        /// Numbers of functions, 1, 2, …
        functions: Vec<usize>,
        /// One per mode.
        series: Vec<ConvergeSeries>,
        /// Warnings of the blade.
        warnings: Vec<Warning>,
    }
}
report! {
    /// One degree of freedom in a summary.
    DofSummary {
        /// Degree of freedom.
        dof: Dof,
        /// Root in the words of the blade file.
        root: &'static str,
        /// Radius of hinge or root [m].
        offset_m: f64,
        /// Spring [N·m/rad], where there is one.
        spring_n_m: Option<f64>,
        /// Mass outboard of the root [kg].
        mass_kg: f64,
        /// ∫ m x dr about the root, x from the root [kg·m]; `None` for torsion.
        static_moment_kg_m: Option<f64>,
        /// ∫ m x² dr about the root, or ∫ ρI_p dr for torsion [kg·m²].
        inertia_kg_m2: f64,
    }
}
report! {
    /// Mass, inertia and static moments of a blade.
    #[derive(Default)]
    BladeSummary {
        /// `bladefan-check/1`.
        schema: &'static str,
        /// Name of the blade.
        blade: String,
        /// Tip radius [m].
        radius_m: f64,
        /// Nominal rotor speed.
        nominal_speed_rad_s: f64,
        /// Number of blades, where given.
        blades: Option<u32>,
        /// Number of distinct station radii of all properties.
        stations: usize,
        /// One per degree of freedom.
        dofs: Vec<DofSummary>,
        /// Warnings of the blade.
        warnings: Vec<Warning>,
    }
}
