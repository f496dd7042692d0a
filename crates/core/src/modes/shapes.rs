//! Mode shapes along the span (Eq. 83), scaled and signed.

use super::Mode;
use crate::dof::Dof;
use crate::lagrange::ShapeTables;
use crate::numerics::scalar::sqrt;
use alloc::vec::Vec;
use nalgebra::DVector;

/// What a shape is scaled to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShapeScale {
    /// Largest absolute displacement of the sampled radii 1.
    Max,
    /// ∫ m X² dr = 1 in bending (Eq. 86), ∫ X² dr = l/2 in torsion (Eq. 87).
    Mass,
}

/// One mode along the span. Positive at the tip: flap up, lag forward, nose up.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Displacement or twist at each radius.
    pub displacement: Vec<f64>,
    /// Slope [1/m].
    pub slope: Vec<f64>,
    /// Bending or twisting moment [N·m per unit of displacement].
    pub moment: Vec<f64>,
}

/// The shapes of modes of one degree of freedom at Ω² = `speed_squared`.
pub fn shapes(dof: Dof, tables: &ShapeTables, modes: &[Mode], speed_squared: f64, scale: ShapeScale) -> Vec<Shape> {
    modes.iter().map(|mode| shape(dof, tables, mode, speed_squared, scale)).collect()
}

fn shape(dof: Dof, tables: &ShapeTables, mode: &Mode, speed_squared: f64, scale: ShapeScale) -> Shape {
    let q = &mode.coordinates;
    let displacement = &tables.value * q;
    let size = match scale {
        ShapeScale::Max => displacement.amax(),
        // q has qᵀ M q = 1, which is Eq. 86.
        ShapeScale::Mass if dof == Dof::Torsion => sqrt(2.0 * q.dot(&(&tables.square * q)) / tables.length),
        ShapeScale::Mass => 1.0,
    };
    let sign = if displacement.iter().next_back().is_some_and(|&tip| tip < 0.0) { -1.0 } else { 1.0 };
    // Divided, not multiplied by an inverse: the largest displacement is 1 to the bit.
    let along = |vector: DVector<f64>| vector.iter().map(|&v| sign * v / size).collect();
    let moment = &tables.inertial * q * mode.eigenvalue - &tables.centrifugal * q * speed_squared;
    Shape { displacement: along(displacement), slope: along(&tables.slope * q), moment: along(moment) }
}
