//! Mode shapes along the span (Eq. 83), scaled and signed.

use super::Mode;
use crate::lagrange::ShapeTables;
use crate::numerics::scalar::{maximum, sqrt};
use alloc::vec::Vec;
use nalgebra::{DMatrix, DVector};

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

/// The shapes of modes at Ω² = `speed_squared`, scaled to qᵀ N q = 1 where N = `norm` is given (M
/// makes that Eq. 86), else to a largest absolute displacement of 1 among the sampled radii.
pub fn shapes(tables: &ShapeTables, modes: &[Mode], speed_squared: f64, norm: Option<&DMatrix<f64>>) -> Vec<Shape> {
    modes.iter().map(|mode| shape(tables, mode, speed_squared, norm)).collect()
}

/// For each mode the largest |q_iᵀ M q_j| with another one (Eq. 84–85): 0 but for rounding.
pub fn orthogonality(mass: &DMatrix<f64>, modes: &[Mode]) -> Vec<f64> {
    let of_mode = |(i, mode): (usize, &Mode)| {
        let loaded = mass * &mode.coordinates;
        let others = modes.iter().enumerate().filter(|&(j, _)| j != i);
        others.map(|(_, other)| other.coordinates.dot(&loaded).abs()).fold(0.0, maximum)
    };
    modes.iter().enumerate().map(of_mode).collect()
}

fn shape(tables: &ShapeTables, mode: &Mode, speed_squared: f64, norm: Option<&DMatrix<f64>>) -> Shape {
    let q = &mode.coordinates;
    let displacement = &tables.value * q;
    let size = norm.map_or_else(|| displacement.amax(), |norm| sqrt(q.dot(&(norm * q))));
    let sign = if displacement.iter().next_back().is_some_and(|&tip| tip < 0.0) { -1.0 } else { 1.0 };
    // Divided, not multiplied by an inverse: the largest displacement is 1 to the bit.
    let along = |vector: DVector<f64>| vector.iter().map(|&v| sign * v / size).collect();
    let moment = &tables.inertial * q * mode.eigenvalue - &tables.centrifugal * q * speed_squared;
    Shape { displacement: along(displacement), slope: along(&tables.slope * q), moment: along(moment) }
}
