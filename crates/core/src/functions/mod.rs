//! Assumed deformation functions: what a mode shape is a sum of.

mod bending;
mod deformation;
mod family;
mod piecewise;
mod torsion;

pub use bending::{BendingRoot, ClassicalBending};
pub use deformation::Deformation;
pub use family::BasisFamily;
pub use piecewise::{MOST_ORDER, Mesh, PiecewiseFunctions};
pub use torsion::{ClassicalTorsion, TorsionRoot};

use alloc::vec;

/// An assumed function at one point, with its analytic derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// φ.
    pub value: f64,
    /// φ′ [1/m].
    pub slope: f64,
    /// φ″ [1/m²].
    pub curvature: f64,
}

/// A family of admissible functions on 0 ≤ x ≤ l, x measured from the root outward.
pub trait AssumedFunctions {
    /// How many.
    fn count(&self) -> usize;

    /// Whether the first function is the rigid motion of a free root (φ = x, or θ = 1), whose
    /// elastic energy is exactly 0.
    fn has_rigid_motion(&self) -> bool;

    /// The largest wave number β of the functions [rad/m]: no function turns by more than β h over
    /// a distance h.
    fn wave_number(&self) -> f64;

    /// Where, x from the root, a derivative may jump; none for smooth functions.
    fn joints(&self) -> &[f64] {
        &[]
    }

    /// Degree of functions that are polynomials between the joints; 0 for waves.
    fn degree(&self) -> usize {
        0
    }

    /// All functions at `x` [m]; `out` holds [`count`](Self::count) samples.
    fn sample(&self, x: f64, out: &mut [Sample]);

    /// All functions at `middle` + each of `offsets` [m], which are symmetric: the first is minus the
    /// last, and so on. `out` holds the samples function by function. Functions of waves share a
    /// sine and an exponential between the two points of a pair.
    fn sample_about(&self, middle: f64, offsets: &[f64], out: &mut [Sample]) {
        let mut samples = vec![Sample::default(); self.count()];
        for (k, offset) in offsets.iter().enumerate() {
            self.sample(middle + offset, &mut samples);
            for (i, sample) in samples.iter().enumerate() {
                out[i * offsets.len() + k] = *sample;
            }
        }
    }
}

#[cfg(test)]
mod tests;
