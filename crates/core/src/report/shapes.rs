//! Mode shapes.

use super::{BasisReport, ModelReport};
use crate::dof::Dof;
use crate::fault::Warning;
use crate::label::Label;
use alloc::string::String;
use alloc::vec::Vec;

report! {
    /// One mode shape.
    ShapeReport {
        /// `1F`, …
        label: Label,
        /// Degree of freedom.
        dof: Dof,
        /// Number within the degree of freedom.
        number: usize,
        /// Natural frequency.
        frequency_rad_s: f64,
        /// How far from orthogonal to the other shapes listed of its degree of freedom: the largest
        /// |∫ m X_i X_j dr| / √(∫ m X_i² dr ∫ m X_j² dr), in torsion with ρI_p for m (Eq. 84–85); 0 for one shape.
        orthogonality: f64,
        /// Radii where the displacement passes through zero between root and tip [m], ascending.
        nodes_m: Vec<f64>,
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
        /// What is solved.
        model: ModelReport,
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
