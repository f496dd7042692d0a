//! Two-sided bounds of the eigenvalues of a coupled blade (docs/THEORY.md): Rayleigh and Ritz from above, Lehmann,
//! Maehly and Goerisch from below, the separation and the shift proven.

use super::assembly::Assembly;
use super::certificate::{Form, index};
use super::equilibrium::OwnEnergies;
use crate::numerics::eigen::ascending_values;
use crate::numerics::scalar::sqrt;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// Where ρ stands between two eigenvalues.
const SEPARATION: f64 = 0.8;
/// A gap of this share of the widest is wide enough to take fewer modes.
const WIDE: f64 = 1.3;
/// θ and σ/ρ, the first proven of which is taken; each contains the one before.
pub const SHIFTS: [(f64, f64); 6] = [(0.1, 0.01), (0.25, 0.03), (0.5, 0.1), (0.65, 0.3), (0.8, 1.0), (0.9, 3.0)];
/// Relative rounding of energies that are sums over the points of a blade, generously.
pub const ROUNDING: f64 = 1e-13;
/// Allowance for the quadrature of the residual moments.
pub const SLACK: f64 = 1.001;

/// Why there are no bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Missing {
    /// At no place between eigenvalues could it be proven how many lie below.
    Separation,
    /// No θ and σ with which θ(K + F) + sC + σM is proven not to be negative.
    Shift,
    /// With Coriolis terms: that the blade is statically stable could not be proven.
    Unstable,
}

/// What was proven.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proof {
    /// Number of eigenvalues below ρ, at most.
    pub below: usize,
    /// ρ [rad²/s²].
    pub rho: f64,
    /// θ(K + F) + sC + σM is not negative.
    pub theta: f64,
    /// σ [rad²/s²].
    pub sigma: f64,
}

/// Proves a separation after one of the modes from the `wanted`-th on and a shift, on any assembly of the
/// blade. `values` are the eigenvalues found at Ω² = s, more than wanted.
///
/// # Errors
/// What could not be proven.
pub fn prove(assembly: &Assembly, values: &[f64], wanted: usize, s: f64) -> Result<Proof, Missing> {
    let (below, rho) = prove_separation(assembly, values, wanted, s).ok_or(Missing::Separation)?;
    let (theta, sigma) = prove_shift(assembly, s, rho).ok_or(Missing::Shift)?;
    Ok(Proof { below, rho, theta, sigma })
}

/// How many eigenvalues lie below ρ, at most, and ρ, between two of the values from the `wanted`-th on.
pub fn prove_separation(assembly: &Assembly, values: &[f64], wanted: usize, s: f64) -> Option<(usize, f64)> {
    separations(values, wanted).find(|&(n, rho)| {
        let form = Form { alpha: 1.0, s, kappa: -rho, turning: 0.0 };
        rho > values[n - 1] && rho > 0.0 && index(assembly, form).is_some_and(|below| below <= n)
    })
}

/// After how many values, from the `wanted`-th on, to part them and where, the widest gaps first.
pub fn separations(values: &[f64], wanted: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
    let last = values.len().saturating_sub(1);
    let gap = |n: usize| (values[n] - values[n - 1]) / values[n].abs().max(f64::MIN_POSITIVE);
    let candidates: Vec<usize> = (wanted.min(last).max(1)..=last).collect();
    let widest = candidates.iter().map(|n| gap(*n)).fold(0.0, f64::max);
    let (wide, narrow): (Vec<usize>, Vec<usize>) = candidates.into_iter().partition(|n| gap(*n) * WIDE >= widest);
    wide.into_iter().chain(narrow).map(|n| (n, (1.0 - SEPARATION) * values[n - 1] + SEPARATION * values[n]))
}

/// θ and σ, about in proportion to ρ, with which θ(K + F) + sC + σM is not negative.
pub fn prove_shift(assembly: &Assembly, s: f64, rho: f64) -> Option<(f64, f64)> {
    let shifts = SHIFTS.into_iter().map(|(theta, share)| (theta, share * rho));
    shifts
        .into_iter()
        .find(|&(theta, sigma)| index(assembly, Form { alpha: theta, s, kappa: sigma, turning: 0.0 }) == Some(0))
}

/// Lower bounds of the eigenvalues below ρ, from as many Ritz values and the energies G of their residual
/// moments as lie below it.
pub fn lower_bounds(values: &[f64], energies: &DMatrix<f64>, proof: &Proof) -> Option<Vec<f64>> {
    let Proof { rho, theta, sigma, .. } = *proof;
    let n = values.len();
    let shifted: Vec<f64> = values.iter().map(|value| value + sigma).collect();
    let share = |i: usize| 1.0 - shifted[i] / (rho + sigma);
    if shifted.iter().any(|v| *v <= 0.0) || (0..n).any(|i| share(i) <= 0.0) {
        return None;
    }
    // ν of H = Λ^-½ (I + N) Λ^-½: solved for with the factor taken out, nothing cancels.
    let h = DMatrix::from_fn(n, n, |i, j| {
        let own = if i == j { 1.0 / shifted[i] } else { 0.0 };
        own + SLACK * energies[(i, j)] / ((1.0 - theta) * shifted[i] * shifted[j] * sqrt(share(i) * share(j)))
    });
    let inverse = ascending_values(h)?;
    Some(inverse.iter().rev().map(|nu| 1.0 / nu - sigma).collect())
}

/// Where as many intervals hold 0 as there are motions that cost nothing, their eigenvalues are those: exactly 0.
pub fn settle_free(intervals: &mut [(f64, f64)], free: usize) {
    let holds = |&(lower, upper): &(f64, f64)| lower <= 0.0 && upper >= 0.0;
    if intervals.iter().filter(|interval| holds(interval)).count() == free {
        intervals.iter_mut().filter(|interval| holds(interval)).for_each(|interval| *interval = (0.0, 0.0));
    }
}

/// How far rounding may have moved each eigenvalue.
pub fn rounding(energies: &[OwnEnergies], values: &[f64], s: f64, sigma: f64) -> Vec<f64> {
    let own = |(energies, value): (&OwnEnergies, &f64)| {
        let size = (energies.sizes[0] + s * energies.sizes[1]) / energies.sums[2];
        ROUNDING * (size + value.abs() + sigma)
    };
    energies.iter().zip(values).map(own).collect()
}
