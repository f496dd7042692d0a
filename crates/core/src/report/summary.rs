//! What a blade is, before anything is solved.

use crate::dof::Dof;
use crate::fault::Warning;
use alloc::string::String;
use alloc::vec::Vec;

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
        /// Mass outboard of the root, point masses with it [kg].
        mass_kg: f64,
        /// ∫ m x dr about the root, x from the root, and m x of point masses [kg·m]; `None` for torsion.
        static_moment_kg_m: Option<f64>,
        /// ∫ m x² dr about the root, or ∫ ρI_p dr for torsion, and those of point masses [kg·m²].
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
