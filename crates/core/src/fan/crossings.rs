//! Where the branches meet the rays ω = nΩ, by root solving on the curves.

use super::Curves;
use crate::numerics::roots::bracketed_newton;
use crate::numerics::scalar::sqrt;
use alloc::vec::Vec;

/// A branch on a ray within this relative distance at every speed lies on it.
const COINCIDENCE: f64 = 1e-9;
/// Each stretch between two nodes of the curves is searched in so many steps.
const STEPS: usize = 2;

/// A branch meets a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayCrossing {
    /// Index of the branch.
    pub branch: usize,
    /// n of the ray.
    pub harmonic: u32,
    /// Rotor speed [rad/s], greater than 0.
    pub speed: f64,
    /// Frequency [rad/s].
    pub frequency: f64,
}

/// How the branches of one degree of freedom meet the rays.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rays {
    /// Crossings by branch, harmonic and speed.
    pub crossings: Vec<RayCrossing>,
    /// Branches that lie on a ray at every speed, with its n.
    pub coincident: Vec<(usize, u32)>,
}

/// Meets of every branch with the rays 1P … `harmonics` P within the curves' range.
pub fn meet_rays(curves: &Curves, harmonics: u32) -> Rays {
    let mut rays = Rays::default();
    let stations = search_points(&curves.nodes());
    let points: Vec<_> = stations.iter().map(|&s| curves.points(s)).collect();
    for branch in 0..curves.branches() {
        for harmonic in 1..=harmonics {
            let square = f64::from(harmonic) * f64::from(harmonic);
            // The gap λ − n²s, or λ/s − n² for the branch that starts at 0 with every ray.
            let gap = |s: f64, value: f64, slope: f64| {
                if curves.is_rigid(branch) { (value - square, slope) } else { (value - square * s, slope - square) }
            };
            let gaps: Vec<(f64, f64)> =
                stations.iter().zip(&points).map(|(&s, at)| gap(s, at[branch].value, at[branch].slope)).collect();
            let on_ray = |(&s, (value, _)): (&f64, &(f64, f64))| {
                let ray = if curves.is_rigid(branch) { square } else { square * s };
                value.abs() <= COINCIDENCE * ray
            };
            if stations.iter().zip(&gaps).filter(|(s, _)| **s > 0.0).all(on_ray) {
                rays.coincident.push((branch, harmonic));
                continue;
            }
            let at = |s: f64| {
                let point = curves.points(s)[branch];
                gap(s, point.value, point.slope)
            };
            for root in roots(&stations, &gaps, at) {
                let speed = sqrt(root);
                rays.crossings.push(RayCrossing { branch, harmonic, speed, frequency: f64::from(harmonic) * speed });
            }
        }
    }
    rays
}

/// Points to look for changes of sign between, ascending.
fn search_points(nodes: &[f64]) -> Vec<f64> {
    let mut points = Vec::with_capacity(nodes.len() * STEPS);
    for pair in nodes.windows(2) {
        points.extend((0..STEPS).map(|i| pair[0] + (pair[1] - pair[0]) * (i as f64 / STEPS as f64)));
    }
    points.extend(nodes.last());
    points
}

/// Roots greater than 0 of a function known with its slope at ascending `stations`, ascending. A
/// branch that touches a ray between two stations and turns back is found by its turning point.
fn roots(stations: &[f64], gaps: &[(f64, f64)], at: impl Fn(f64) -> (f64, f64)) -> Vec<f64> {
    let mut found: Vec<f64> = Vec::new();
    let mut search = |low: (f64, f64), high: (f64, f64)| {
        if low.1 == 0.0 || low.1.signum() == high.1.signum() {
            return;
        }
        let start = low.0 + (high.0 - low.0) * (low.1 / (low.1 - high.1));
        found.push(bracketed_newton(&at, low.0, high.0, start));
    };
    for (ends, values) in stations.windows(2).zip(gaps.windows(2)) {
        let (low, high) = ((ends[0], values[0].0), (ends[1], values[1].0));
        let turns = values[0].1.signum() != values[1].1.signum() && values[0].1.signum() != low.1.signum();
        if low.1.signum() == high.1.signum() && turns {
            let turn = turning_point(&at, low.0, high.0);
            let middle = (turn, at(turn).0);
            search(low, middle);
            search(middle, high);
        } else {
            search(low, high);
        }
    }
    // A station that is itself a root ends one stretch and starts the next.
    found.retain(|&s| s > 0.0);
    found.dedup();
    found
}

/// Where the slope changes sign, by bisection.
fn turning_point(at: impl Fn(f64) -> (f64, f64), low: f64, high: f64) -> f64 {
    let (mut low, mut high) = (low, high);
    let rises = at(low).1 < 0.0;
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if (at(middle).1 < 0.0) == rises {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}
