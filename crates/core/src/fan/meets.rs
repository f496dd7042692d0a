//! Where one branch of a coupled blade meets the rays ω = nΩ: it is known at some rotor speeds with its slope,
//! and costs a solve at any other.

use crate::numerics::roots::{bracketed, bracketed_newton};
use crate::numerics::scalar::sqrt;
use alloc::vec::Vec;

/// A branch on a ray within this relative distance at every known speed lies on it.
const COINCIDENCE: f64 = 1e-9;

/// A branch at a rotor speed.
#[derive(Clone, Copy, Debug)]
pub struct OnBranch {
    /// Rotor speed [rad/s].
    pub speed: f64,
    /// λ [rad²/s²].
    pub value: f64,
    /// dλ/dΩ².
    pub slope: f64,
}

/// How a branch meets the rays.
#[derive(Clone, Debug, Default)]
pub struct Meets {
    /// n and rotor speed [rad/s] of every crossing, by n, then by speed.
    pub crossings: Vec<(u32, f64)>,
    /// n of the rays that the branch lies on.
    pub coincident: Vec<u32>,
}

/// Meets with the rays 1P … `harmonics` P between known speeds, which ascend; `at` gives λ at any other.
///
/// # Errors
/// Those of `at`.
pub fn meet<E>(known: &[OnBranch], harmonics: u32, at: impl Fn(f64) -> Result<f64, E>) -> Result<Meets, E> {
    let mut meets = Meets::default();
    for harmonic in 1..=harmonics {
        let square = f64::from(harmonic) * f64::from(harmonic);
        let gap = |value: f64, speed: f64| value - square * speed * speed;
        let on_ray = |at: &OnBranch| gap(at.value, at.speed).abs() <= COINCIDENCE * square * at.speed * at.speed;
        if known.iter().filter(|at| at.speed > 0.0).all(on_ray) {
            meets.coincident.push(harmonic);
            continue;
        }
        for pair in known.windows(2) {
            let [low, high] = [pair[0], pair[1]].map(|at| Point {
                s: at.speed * at.speed,
                value: gap(at.value, at.speed),
                slope: at.slope - square,
            });
            // A known speed that is a root belongs to the stretch below it.
            if !((low.value > 0.0 && high.value <= 0.0) || (low.value < 0.0 && high.value >= 0.0)) {
                continue;
            }
            let mut failed = None;
            let f = |speed: f64| match at(speed) {
                Ok(value) => gap(value, speed),
                Err(error) => {
                    failed = Some(error);
                    0.0
                }
            };
            let start = sqrt(cubic_root(low, high));
            let speed = bracketed(f, (pair[0].speed, low.value), (pair[1].speed, high.value), start);
            if let Some(error) = failed {
                return Err(error);
            }
            meets.crossings.push((harmonic, speed));
        }
    }
    Ok(meets)
}

/// A function of Ω² at a point.
#[derive(Clone, Copy)]
struct Point {
    s: f64,
    value: f64,
    slope: f64,
}

/// The root of the cubic through two points of unlike sign with their slopes.
fn cubic_root(low: Point, high: Point) -> f64 {
    let width = high.s - low.s;
    let cubic = |t: f64| {
        let (a, b) = (low.slope * width, high.slope * width);
        let rise = high.value - low.value;
        let (c2, c3) = (3.0 * rise - 2.0 * a - b, a + b - 2.0 * rise);
        (low.value + t * (a + t * (c2 + t * c3)), a + t * (2.0 * c2 + 3.0 * t * c3))
    };
    low.s + width * bracketed_newton(cubic, 0.0, 1.0, 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::cell::Cell;

    /// λ = 5 + 0.5 Ω² + 0.1 Ω⁴ meets nP where it is n² Ω².
    #[test]
    fn a_bent_branch_meets_its_rays_in_few_solves() {
        let value = |speed: f64| 5.0 + 0.5 * speed * speed + 0.1 * speed.powi(4);
        let known: Vec<OnBranch> = (0..9)
            .map(|k| f64::from(k) * 0.5)
            .map(|speed| OnBranch { speed, value: value(speed), slope: 0.5 + 0.2 * speed * speed })
            .collect();
        let solves = Cell::new(0);
        let at = |speed: f64| -> Result<f64, ()> {
            solves.set(solves.get() + 1);
            Ok(value(speed))
        };
        let meets = meet(&known, 3, at).unwrap();
        assert!(meets.coincident.is_empty());
        let mut expected = Vec::new();
        for n in 1..=3_u32 {
            let b = f64::from(n * n) - 0.5;
            let root = b * b - 2.0;
            if root >= 0.0 {
                let speeds = [5.0 * (b - root.sqrt()), 5.0 * (b + root.sqrt())].map(f64::sqrt);
                expected.extend(speeds.into_iter().filter(|speed| *speed < 4.0).map(|speed| (n, speed)));
            }
        }
        assert_eq!(meets.crossings.len(), expected.len(), "{:?} {expected:?}", meets.crossings);
        for (found, known) in meets.crossings.iter().zip(&expected) {
            assert!(found.0 == known.0 && (found.1 / known.1 - 1.0).abs() < 1e-12, "{found:?} {known:?}");
        }
        assert!(solves.get() <= 4 * expected.len(), "{} solves", solves.get());
    }

    #[test]
    fn a_branch_on_a_ray_lies_on_it() {
        let known: Vec<OnBranch> =
            (0..4).map(f64::from).map(|speed| OnBranch { speed, value: 4.0 * speed * speed, slope: 4.0 }).collect();
        let meets = meet(&known, 3, |speed| Ok::<f64, ()>(4.0 * speed * speed)).unwrap();
        assert_eq!(meets.coincident, [2]);
        assert!(meets.crossings.is_empty());
    }
}
