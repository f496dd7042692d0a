//! Torsion modes of the uniform, non-rotating bar (paper Eq. 26–28, 30).

use super::{AssumedFunctions, Sample};
use crate::numerics::roots::bracketed_newton;
use crate::numerics::scalar::{hypot, sin_cos, sqrt};
use alloc::vec::Vec;
use core::f64::consts::PI;

/// Root of the uniform bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TorsionRoot {
    /// Rigid pitch control: θ(0) = 0.
    Clamped,
    /// Pitch free: θ′(0) = 0; the first function is θ = 1.
    Free,
    /// Pitch-control spring: GJ θ′(0) = K θ(0); here Kl/GJ, greater than 0.
    Spring(f64),
}

/// Torsion functions of the classical family: θ = a cos γx + b sin γx.
#[derive(Clone, Debug)]
pub struct ClassicalTorsion {
    functions: Vec<Function>,
    wave_number: f64,
    rigid: bool,
}

#[derive(Clone, Copy, Debug)]
struct Function {
    gamma: f64,
    a: f64,
    b: f64,
}

impl ClassicalTorsion {
    /// The first `count` modes of a uniform bar of this root and length l [m], each with
    /// ∫θ² dx = l/2 (Eq. 30), positive at the tip.
    pub fn new(root: TorsionRoot, count: usize, length: f64) -> Self {
        let functions: Vec<Function> = (0..count)
            .map(|index| {
                let (z, a, b) = match root {
                    TorsionRoot::Clamped => ((index as f64 + 0.5) * PI, 0.0, 1.0),
                    TorsionRoot::Free => (index as f64 * PI, 1.0, 0.0),
                    TorsionRoot::Spring(stiffness) => {
                        let z = spring_root(index, stiffness);
                        let size = hypot(z, stiffness);
                        (z, z / size, stiffness / size)
                    }
                };
                normalised(Function { gamma: z / length, a, b }, z, length)
            })
            .collect();
        let wave_number = functions.iter().map(|f| f.gamma).fold(0.0, f64::max);
        Self { functions, wave_number, rigid: root == TorsionRoot::Free && count > 0 }
    }
}

impl AssumedFunctions for ClassicalTorsion {
    fn count(&self) -> usize {
        self.functions.len()
    }

    fn has_rigid_motion(&self) -> bool {
        self.rigid
    }

    fn wave_number(&self) -> f64 {
        self.wave_number
    }

    fn sample(&self, x: f64, out: &mut [Sample]) {
        for (&Function { gamma, a, b }, sample) in self.functions.iter().zip(out) {
            let (sin, cos) = sin_cos(gamma * x);
            let value = a * cos + b * sin;
            *sample = Sample { value, slope: gamma * (b * cos - a * sin), curvature: -gamma * gamma * value };
        }
    }

    fn sample_about(&self, middle: f64, offsets: &[f64], out: &mut [Sample]) {
        for (&Function { gamma, a, b }, samples) in self.functions.iter().zip(out.chunks_exact_mut(offsets.len())) {
            let (sin, cos) = sin_cos(gamma * middle);
            let (c, s) = (a * cos + b * sin, b * cos - a * sin);
            let wave = |value: f64, derivative: f64| Sample {
                value,
                slope: gamma * derivative,
                curvature: -gamma * gamma * value,
            };
            let last = offsets.len() - 1;
            for k in 0..=last / 2 {
                let (sin, cos) = sin_cos(gamma * offsets[last - k]);
                samples[k] = wave(c * cos - s * sin, s * cos + c * sin);
                samples[last - k] = wave(c * cos + s * sin, s * cos - c * sin);
            }
        }
    }
}

/// Scaled to ∫θ² dx = l/2 and θ(l) > 0; z = γl.
fn normalised(function: Function, z: f64, length: f64) -> Function {
    let Function { gamma, a, b } = function;
    let (sin, cos) = sin_cos(z);
    let square = if z == 0.0 {
        a * a * length
    } else {
        length * (0.5 * (a * a + b * b) + (0.5 * (a * a - b * b) * sin * cos + a * b * sin * sin) / z)
    };
    let sign = if a * cos + b * sin < 0.0 { -1.0 } else { 1.0 };
    let factor = sign * sqrt(0.5 * length / square);
    Function { gamma, a: factor * a, b: factor * b }
}

/// Root `index` (from 0) of k cos z − z sin z = 0 (Eq. 27), k = Kl/GJ, in (index π, (index + ½) π).
/// Solved for u = z − index π, so that a soft spring keeps its digits.
fn spring_root(index: usize, stiffness: f64) -> f64 {
    let base = index as f64 * PI;
    let (of_spring, of_bar) = (stiffness / (1.0 + stiffness), 1.0 / (1.0 + stiffness));
    let f = |u: f64| {
        let (sin, cos) = sin_cos(u);
        let z = base + u;
        (of_spring * cos - of_bar * z * sin, -of_spring * sin - of_bar * (sin + z * cos))
    };
    let guess =
        if index == 0 { sqrt(stiffness / (1.0 + stiffness)) } else { (stiffness / (base + stiffness)).min(1.5) };
    base + bracketed_newton(f, 0.0, 0.5 * PI, guess)
}
