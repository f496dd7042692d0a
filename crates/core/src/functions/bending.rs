//! Bending modes of the uniform, non-rotating beam (paper Eq. 7–25, 29), in forms that neither
//! overflow nor cancel, whatever the mode number.
//!
//! With z = βl, E = e⁻ᶻ and κ = 2EIβ/K (0 for a clamped root, ∞ for a free hinge) the paper's
//! A sin βx + B cos βx + C sinh βx + D cosh βx becomes, A = 1,
//!
//! φ = sin βx + B cos βx + P e^(βx−z) + Q e^(−βx), with d = 2E cos z + 1 + E² + κ(1 − E²) and
//! B = −(2E sin z + 1 − E²)/d, P = −(cos z + E − (1+κ) sin z)/d, Q = (1 + E(cos z + (1−κ) sin z))/d.
//!
//! A soft spring's first function is nearly φ = x; below z = 2 it is written with the
//! Krylov–Duncan functions, whose series have only positive terms.

use super::{AssumedFunctions, Sample};
use crate::numerics::roots::bracketed_newton;
use crate::numerics::scalar::{exp, fourth_root, sin_cos, sqrt};
use alloc::vec::Vec;
use core::f64::consts::PI;

/// Root of the uniform beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BendingRoot {
    /// Hingeless: φ(0) = φ′(0) = 0.
    Clamped,
    /// Freely hinged: φ(0) = φ″(0) = 0; the first function is φ = x.
    Free,
    /// Spring-hinged: φ(0) = 0, EI φ″(0) = K φ′(0); here Kl/EI, greater than 0.
    Spring(f64),
}

/// Bending functions of the classical family.
#[derive(Clone, Debug)]
pub struct ClassicalBending {
    functions: Vec<Function>,
    wave_number: f64,
    rigid: bool,
}

#[derive(Clone, Copy, Debug)]
enum Function {
    /// φ = scale · x.
    Rigid { scale: f64 },
    /// φ = a sin βx + b cos βx + p e^(βx−z) + q e^(−βx).
    Wave { beta: f64, z: f64, a: f64, b: f64, p: f64, q: f64 },
    /// φ = s₂ S₂(βx) + s₃ S₃(βx) + s₄ S₄(βx), Krylov–Duncan functions.
    Series { beta: f64, s2: f64, s3: f64, s4: f64 },
}

impl ClassicalBending {
    /// The first `count` modes of a uniform beam of this root, length l [m] and mass per length
    /// [kg/m], each with generalised mass 1 (Eq. 29), positive at the tip. A mass of 0 leaves the
    /// generalised mass out of account and scales to ∫φ² dx = 1.
    pub fn new(root: BendingRoot, count: usize, length: f64, mass: f64) -> Self {
        let density = if mass > 0.0 { mass } else { 1.0 };
        let functions: Vec<Function> = (0..count)
            .map(|index| {
                let function = match (root, index) {
                    (BendingRoot::Free, 0) => Function::Rigid { scale: 1.0 },
                    (BendingRoot::Clamped, i) => wave(clamped_root(i), 0.0, length),
                    (BendingRoot::Free, i) => wave(free_root(i), f64::INFINITY, length),
                    (BendingRoot::Spring(stiffness), i) => {
                        let z = spring_root(i, stiffness);
                        if z < SERIES_BELOW {
                            series(z, stiffness, length)
                        } else {
                            wave(z, 2.0 * z / stiffness, length)
                        }
                    }
                };
                function.normalised(length, density)
            })
            .collect();
        let wave_number = functions.iter().map(Function::wave_number).fold(0.0, f64::max);
        Self { functions, wave_number, rigid: root == BendingRoot::Free && count > 0 }
    }
}

impl AssumedFunctions for ClassicalBending {
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
        for (function, sample) in self.functions.iter().zip(out) {
            *sample = function.at(x);
        }
    }

    fn sample_about(&self, middle: f64, offsets: &[f64], out: &mut [Sample]) {
        for (function, samples) in self.functions.iter().zip(out.chunks_exact_mut(offsets.len())) {
            function.about(middle, offsets, samples);
        }
    }
}

/// Below this z = βl the series take over from the exponentials; only the first function of a
/// spring-hinged root comes here (its z < 1.8752, every other z > 3.9).
const SERIES_BELOW: f64 = 2.0;

impl Function {
    fn wave_number(&self) -> f64 {
        match *self {
            Self::Rigid { .. } => 0.0,
            Self::Wave { beta, .. } | Self::Series { beta, .. } => beta,
        }
    }

    fn at(&self, x: f64) -> Sample {
        match *self {
            Self::Rigid { scale } => Sample { value: scale * x, slope: scale, curvature: 0.0 },
            Self::Wave { beta, z, a, b, p, q } => {
                let u = beta * x;
                let (sin, cos) = sin_cos(u);
                composed(beta, a * sin + b * cos, a * cos - b * sin, p * exp(u - z), q * exp(-u))
            }
            Self::Series { beta, s2, s3, s4 } => {
                let [k1, k2, k3, k4] = krylov(beta * x);
                Sample {
                    value: s2 * k2 + s3 * k3 + s4 * k4,
                    slope: beta * (s2 * k1 + s3 * k2 + s4 * k3),
                    curvature: beta * beta * (s2 * k4 + s3 * k1 + s4 * k2),
                }
            }
        }
    }

    /// At `middle` + each of `offsets`, which are symmetric. About the middle the wave is
    /// c cos d + s sin d, so that a pair of points needs one sine, cosine and exponential.
    fn about(&self, middle: f64, offsets: &[f64], out: &mut [Sample]) {
        let Self::Wave { beta, z, a, b, p, q } = *self else {
            for (offset, sample) in offsets.iter().zip(out) {
                *sample = self.at(middle + offset);
            }
            return;
        };
        let u = beta * middle;
        let (sin, cos) = sin_cos(u);
        let (c, s) = (a * sin + b * cos, a * cos - b * sin);
        let (grown, decayed) = (p * exp(u - z), q * exp(-u));
        let last = offsets.len() - 1;
        for k in 0..=last / 2 {
            let d = beta * offsets[last - k];
            let (sin, cos) = sin_cos(d);
            let up = exp(d);
            let down = 1.0 / up;
            out[k] = composed(beta, c * cos - s * sin, s * cos + c * sin, grown * down, decayed * up);
            out[last - k] = composed(beta, c * cos + s * sin, s * cos - c * sin, grown * up, decayed * down);
        }
    }

    /// The same with ∫ density φ² dx = 1 and φ(l) > 0. For a beam mode held at x = 0 and free at l,
    /// ∫φ² dx = (l φ(l)² + φ′(0) φ″(0)/β⁴)/4 (integration by parts, R. P. Felgar 1950).
    fn normalised(self, length: f64, density: f64) -> Self {
        let tip = self.at(length).value;
        let square = match self {
            Self::Rigid { .. } => length * length * length / 3.0,
            Self::Wave { beta, .. } | Self::Series { beta, .. } => {
                let root = self.at(0.0);
                let (slope, curvature) = (root.slope / beta, root.curvature / (beta * beta));
                0.25 * (length * tip * tip + slope * curvature / beta)
            }
        };
        let f = if tip < 0.0 { -1.0 } else { 1.0 } / sqrt(density * square);
        match self {
            Self::Rigid { scale } => Self::Rigid { scale: f * scale },
            Self::Wave { beta, z, a, b, p, q } => Self::Wave { beta, z, a: f * a, b: f * b, p: f * p, q: f * q },
            Self::Series { beta, s2, s3, s4 } => Self::Series { beta, s2: f * s2, s3: f * s3, s4: f * s4 },
        }
    }
}

/// A sample from the wave, its derivative by βx, and the two exponentials.
fn composed(beta: f64, wave: f64, derivative: f64, grown: f64, decayed: f64) -> Sample {
    Sample {
        value: wave + (grown + decayed),
        slope: beta * (derivative + (grown - decayed)),
        curvature: beta * beta * ((grown + decayed) - wave),
    }
}

/// The beam mode of characteristic root z and κ = 2z/(Kl/EI); see the head of this file.
fn wave(z: f64, kappa: f64, length: f64) -> Function {
    let beta = z / length;
    let e = exp(-z);
    let (sin, cos) = sin_cos(z);
    if kappa.is_infinite() {
        let d = 1.0 - e * e;
        return Function::Wave { beta, z, a: 1.0, b: 0.0, p: sin / d, q: -e * sin / d };
    }
    // All four divided by d/(1 + κ), so that a soft spring's κ cannot overflow.
    let soft = kappa / (1.0 + kappa);
    let stiff = 1.0 / (1.0 + kappa);
    let d = stiff * (2.0 * e * cos + 1.0 + e * e) + soft * (1.0 - e * e);
    Function::Wave {
        beta,
        z,
        a: 1.0,
        b: -stiff * (2.0 * e * sin + 1.0 - e * e) / d,
        p: (sin - stiff * (cos + e)) / d,
        q: (stiff * (1.0 + e * (cos + sin)) - soft * e * sin) / d,
    }
}

/// The first mode on a soft spring. From φ(0) = 0 and the root condition φ = S₂ + (k/z) S₃ + c S₄,
/// k = Kl/EI; no shear at the tip gives c.
fn series(z: f64, stiffness: f64, length: f64) -> Function {
    let [k1, _, k3, k4] = krylov(z);
    let s3 = stiffness / z;
    Function::Series { beta: z / length, s2: 1.0, s3, s4: -(k3 + s3 * k4) / k1 }
}

/// Krylov–Duncan functions S₁ = (cosh u + cos u)/2, S₂ = (sinh u + sin u)/2, S₃ = (cosh u − cos u)/2,
/// S₄ = (sinh u − sin u)/2 by their series, for u ≤ 2. S₁′ = S₄, S₂′ = S₁, S₃′ = S₂, S₄′ = S₃.
fn krylov(u: f64) -> [f64; 4] {
    let u4 = u * u * (u * u);
    let mut terms = [1.0, u, u * u / 2.0, u * u * u / 6.0];
    let mut sums = terms;
    // At u = 2 the seventh term is below 2⁻⁵³ of the first.
    for k in 1..8_u32 {
        for (j, (term, sum)) in terms.iter_mut().zip(&mut sums).enumerate() {
            let n = f64::from(4 * k) + j as f64;
            *term *= u4 / (n * (n - 1.0) * (n - 2.0) * (n - 3.0));
            *sum += *term;
        }
    }
    sums
}

/// Root `index` (from 0) of cos z cosh z + 1 = 0 (Eq. 17), divided by cosh z.
fn clamped_root(index: usize) -> f64 {
    let middle = (index as f64 + 0.5) * PI;
    let f = |z: f64| {
        let (sin, cos) = sin_cos(z);
        let e = exp(-z);
        let sech = 2.0 * e / (1.0 + e * e);
        (cos + sech, -sin - sech * ((1.0 - e * e) / (1.0 + e * e)))
    };
    bracketed_newton(f, middle - 0.4, middle + 0.4, middle)
}

/// Root `index` (from 1; 0 is the rigid motion) of sinh z cos z − cosh z sin z = 0 (Eq. 19),
/// divided by cosh z.
fn free_root(index: usize) -> f64 {
    let guess = (index as f64 + 0.25) * PI;
    bracketed_newton(hinged_function, guess - 0.4, guess + 0.4, guess)
}

/// tanh z cos z − sin z and its derivative.
fn hinged_function(z: f64) -> (f64, f64) {
    let (sin, cos) = sin_cos(z);
    let e2 = exp(-2.0 * z);
    let tanh = (1.0 - e2) / (1.0 + e2);
    (tanh * cos - sin, (1.0 - tanh * tanh) * cos - tanh * sin - cos)
}

/// Root `index` (from 0) of the spring-hinged beam (Eq. 22), k = Kl/EI: it lies between the hinged
/// and the clamped root of that index.
fn spring_root(index: usize, stiffness: f64) -> f64 {
    let high = clamped_root(index);
    if index == 0 {
        // k (S₁² − S₂S₄) = z (S₂S₃ − S₁S₄), the same equation where cosh z and 1 are of one size.
        // For a soft spring z⁴ = 3k.
        let f = |z: f64| {
            let [k1, k2, k3, k4] = krylov(z);
            let (elastic, held) = (k2 * k3 - k1 * k4, k1 * k1 - k2 * k4);
            // d/dz: (S₂S₃ − S₁S₄)′ = S₂² − S₄², (S₁² − S₂S₄)′ = S₁S₄ − S₂S₃.
            (z * elastic - stiffness * held, elastic + z * (k2 * k2 - k4 * k4) + stiffness * elastic)
        };
        let guess = fourth_root(3.0 * stiffness / (1.0 + 3.0 * stiffness / (high * high * (high * high))));
        return bracketed_newton(f, 0.0, high * (1.0 + 1e-12), guess.min(high));
    }
    let low = free_root(index);
    let (of_spring, of_beam) = (stiffness / (1.0 + stiffness), 1.0 / (1.0 + stiffness));
    let f = |z: f64| {
        let (sin, cos) = sin_cos(z);
        let e = exp(-z);
        let (sech, tanh) = (2.0 * e / (1.0 + e * e), (1.0 - e * e) / (1.0 + e * e));
        let (free, free_slope) = hinged_function(z);
        let value = of_spring * (sech + cos) + of_beam * z * free;
        let slope = of_spring * (-sech * tanh - sin) + of_beam * (free + z * free_slope);
        (value, slope)
    };
    bracketed_newton(f, low * (1.0 - 1e-12), high * (1.0 + 1e-12), 0.5 * (low + high))
}
