//! Where the branches meet the rays ω = nΩ, by root solving on the curves.

use super::Curves;
use crate::numerics::roots::bracketed_newton;
use crate::numerics::scalar::sqrt;
use alloc::vec::Vec;

/// A branch on a ray within this relative distance at every speed lies on it.
const COINCIDENCE: f64 = 1e-9;
/// Each stretch between two nodes of the curves is searched in so many steps.
const STEPS: usize = 2;

/// A gap whose tangents meet at this part of it does not reach 0.
const CLEARLY: f64 = 0.5;

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
                let point = curves.point(branch, s);
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

/// A place where the gap is known.
#[derive(Clone, Copy, Debug)]
struct Known {
    at: f64,
    gap: f64,
    slope: f64,
}

/// Roots greater than 0 of a function known with its slope at ascending `stations`, ascending. A
/// branch that touches a ray between two stations and turns back is found by its turning point.
fn roots(stations: &[f64], gaps: &[(f64, f64)], at: impl Fn(f64) -> (f64, f64)) -> Vec<f64> {
    let known: Vec<Known> = stations.iter().zip(gaps).map(|(&at, &(gap, slope))| Known { at, gap, slope }).collect();
    let mut found: Vec<f64> = Vec::new();
    for (index, low) in known.iter().enumerate() {
        // A station that is itself a root belongs to neither stretch beside it.
        if low.gap == 0.0 {
            found.push(low.at);
        }
        if let Some(high) = known.get(index + 1) {
            within(*low, *high, &at, &mut found);
        }
    }
    found.retain(|&s| s > 0.0);
    found.dedup();
    found
}

/// Adds the roots between two stations, ascending.
#[allow(clippy::float_cmp, reason = "signs are 1 or −1")]
fn within(low: Known, high: Known, at: &impl Fn(f64) -> (f64, f64), found: &mut Vec<f64>) {
    // Beside a station that is a root the gap has the sign that its slope gives it.
    let after_low = if low.gap == 0.0 { low.slope.signum() } else { low.gap.signum() };
    let before_high = if high.gap == 0.0 { -high.slope.signum() } else { high.gap.signum() };
    let straight = low.gap != 0.0 && high.gap != 0.0;
    let turns_back = straight
        && after_low == before_high
        && low.slope.signum() != high.slope.signum()
        && low.slope.signum() != after_low;
    // Leaving one root and meeting the next on the other side, it turns too.
    let turns_over = !straight && after_low != before_high;
    if !(turns_back || turns_over) {
        search(low, high, at, found);
        return;
    }
    if turns_back && stays_away(low, high) {
        return;
    }
    let turn = turning_point(at, low.at, high.at);
    let (gap, slope) = at(turn);
    let middle = Known { at: turn, gap, slope };
    search(low, middle, at, found);
    if gap == 0.0 {
        found.push(turn);
    }
    search(middle, high, at, found);
}

/// Whether a gap that turns back between two places clearly does not reach 0: bent towards 0 it lies beyond
/// its tangents, which meet at a good part of the smaller gap.
fn stays_away(low: Known, high: Known) -> bool {
    let width = high.at - low.at;
    let meet = (high.gap - low.gap - high.slope * width) / (low.slope - high.slope);
    let left = (low.gap + low.slope * meet) * low.gap.signum();
    left >= CLEARLY * low.gap.abs().min(high.gap.abs())
}

/// Adds the root between two places on either side of it, if they are.
fn search(low: Known, high: Known, at: &impl Fn(f64) -> (f64, f64), found: &mut Vec<f64>) {
    let roots = low.gap == 0.0 || high.gap == 0.0;
    if roots || low.gap.signum() == high.gap.signum() {
        return;
    }
    let start = low.at + (high.at - low.at) * (low.gap / (low.gap - high.gap));
    found.push(bracketed_newton(at, low.at, high.at, start));
}

/// Where the slope changes sign, by bisection.
fn turning_point(at: &impl Fn(f64) -> (f64, f64), low: f64, high: f64) -> f64 {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Curves of the one branch λ(Ω²).
    fn one(branch: impl Fn(f64) -> f64) -> Curves {
        Curves::of_functions(1, (0.0, 100.0), |s| alloc::vec![branch(s)])
    }

    fn speeds(rays: &Rays, harmonic: u32) -> Vec<f64> {
        rays.crossings.iter().filter(|crossing| crossing.harmonic == harmonic).map(|crossing| crossing.speed).collect()
    }

    #[test]
    fn a_straight_branch_meets_each_ray_where_they_are_equal() {
        // λ = 60 + Ω²/4 meets nΩ at Ω² = 60/(n² − 1/4).
        let rays = meet_rays(&one(|s| 60.0 + 0.25 * s), 4);
        assert_eq!(rays.crossings.len(), 4);
        for (harmonic, crossing) in (1..).zip(&rays.crossings) {
            let n = f64::from(harmonic);
            assert_eq!((crossing.branch, crossing.harmonic), (0, harmonic));
            assert!((crossing.speed.powi(2) / (60.0 / (n * n - 0.25)) - 1.0).abs() < 1e-9, "{crossing:?}");
            assert!((crossing.frequency - n * crossing.speed).abs() < 1e-12);
        }
    }

    /// Falling and rising through a station of the search, and touching there from either side.
    #[test]
    fn a_branch_that_meets_a_ray_at_a_station_crosses_there() {
        let mut exact = 0;
        let nodes = one(|s| s).nodes();
        for &there in &nodes[1..nodes.len() - 1] {
            for slope in [-9.0, -3.0, -0.5, 0.5, 3.0, 9.0] {
                let curves = one(|s| 4.0 * there + (4.0 + slope) * (s - there));
                // Rounding of the scale may move a station off its node.
                exact += usize::from(slope < 0.0 && curves.points(there)[0].value == 4.0 * there);
                let found = speeds(&meet_rays(&curves, 2), 2);
                assert_eq!(found.len(), 1, "slope {slope} at {there}: {found:?}");
                assert!((found[0] * found[0] / there - 1.0).abs() < 1e-9);
            }
            for bend in [-0.1, 0.1] {
                let curves = one(|s| 4.0 * s + bend * (s - there) * (s - there));
                if curves.points(there)[0].value == 4.0 * there {
                    let found = speeds(&meet_rays(&curves, 2), 2);
                    assert!((1..=2).contains(&found.len()), "touching at {there}: {found:?}");
                }
            }
        }
        assert!(exact > 3, "{exact}");
    }

    #[test]
    fn a_branch_that_dips_through_a_ray_crosses_it_twice() {
        let rays = meet_rays(&one(|s| s + 0.01 * (s - 50.0) * (s - 53.0)), 1);
        let found = speeds(&rays, 1);
        assert_eq!(found.len(), 2, "{found:?}");
        for (speed, square) in found.iter().zip([50.0, 53.0]) {
            assert!((speed * speed / square - 1.0).abs() < 1e-7, "{speed}");
        }
    }

    #[test]
    fn a_branch_on_a_ray_coincides_with_it_and_does_not_cross() {
        let rays = meet_rays(&one(|s| 9.0 * s), 4);
        assert_eq!(rays.coincident, [(0, 3)]);
        assert!(rays.crossings.is_empty(), "{:?}", rays.crossings);
    }

    #[test]
    fn a_gap_that_is_not_a_number_is_no_crossing() {
        let rays = meet_rays(&one(|_| f64::NAN), 3);
        assert_eq!(rays, Rays::default());
    }

    #[test]
    fn every_root_between_and_at_stations_is_found_once() {
        // (x − 1)(x − 2)(x − 3), with stations at some of the roots.
        let cubic = |x: f64| ((x - 1.0) * (x - 2.0) * (x - 3.0), 3.0 * x * x - 12.0 * x + 11.0);
        for stations in [
            alloc::vec![0.0, 4.0 / 3.0, 2.5, 4.0],
            alloc::vec![0.0, 1.0, 2.5, 4.0],
            alloc::vec![0.5, 1.0, 2.0, 3.0],
            alloc::vec![1.0, 2.5, 3.0],
            alloc::vec![0.0, 1.0, 2.5, 3.0, 4.0],
            alloc::vec![0.0, 1.5, 3.0],
        ] {
            for sign in [1.0, -1.0] {
                let at = |x: f64| (sign * cubic(x).0, sign * cubic(x).1);
                let gaps: Vec<(f64, f64)> = stations.iter().map(|&x| at(x)).collect();
                let found = roots(&stations, &gaps, at);
                assert_eq!(found.len(), 3, "{stations:?}: {found:?}");
                assert!(found.iter().zip([1.0, 2.0, 3.0]).all(|(root, exact)| (root - exact).abs() < 1e-12));
            }
        }
    }
}
