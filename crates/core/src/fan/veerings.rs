//! Branches of coupled modes over rotor speed: where sorted frequencies meet or turn away from one another.
//!
//! Branches follow from the blade and its nominal speed alone, never from the speeds that are asked for.

use crate::numerics::scalar::{ceil, maximum, sqrt};
use alloc::vec::Vec;

/// Nodes per nominal speed.
const NODES: f64 = 32.0;
/// Most nodes, where the range is many times nominal speed.
const MOST_NODES: f64 = 4000.0;
/// Neighbours nearer than this, as a share of the upper one's frequency, are looked at.
const NEAR: f64 = 0.25;
/// Branches whose frequencies come nearer than this share cross.
const CROSSING: f64 = 2e-3;
/// Most steps of the search for a least gap, and how near, as a share of the step between nodes, it ends.
const STEPS: usize = 28;
const CLOSE: f64 = 1e-7;
/// A search that stops so near to an end, as a share of the distance of both, has found none between them.
const END: f64 = 1e-2;

/// Where two neighbouring branches come nearest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Veering {
    /// Sorted position of the lower one, from 0.
    pub position: usize,
    /// Whether they cross; else they turn away.
    pub crosses: bool,
    /// Rotor speed [rad/s].
    pub speed: f64,
    /// Distance of the frequencies there [rad/s].
    pub gap: f64,
    /// Their mean there [rad/s].
    pub frequency: f64,
}

/// The branches of a blade up to a rotor speed.
#[derive(Clone, Debug)]
pub struct Branches {
    /// Rotor speeds of the nodes [rad/s], ascending from 0.
    pub nodes: Vec<f64>,
    /// λ at the nodes, ascending.
    pub values: Vec<Vec<f64>>,
    /// By ascending speed.
    pub veerings: Vec<Veering>,
    count: usize,
}

impl Branches {
    /// How far the nodes go for branches up to rotor speed `to` [rad/s].
    pub fn reach(nominal: f64, to: f64) -> f64 {
        last_node(nominal, to) * (nominal / NODES)
    }

    /// Rotor speeds of the nodes for branches up to `to` [rad/s], ascending from 0.
    pub fn nodes(nominal: f64, to: f64) -> Vec<f64> {
        let (step, last) = (nominal / NODES, last_node(nominal, to));
        let numbers = (0..u32::MAX).map(f64::from).take_while(|k| *k <= last);
        numbers.map(|k| k * step).collect()
    }

    /// The `count` lowest branches, from the sorted λ at the nodes and those at any rotor speed.
    ///
    /// # Errors
    /// Those of `spectrum`.
    pub fn new<E>(
        spectrum: &impl Fn(f64) -> Result<Vec<f64>, E>,
        nodes: Vec<f64>,
        values: Vec<Vec<f64>>,
        count: usize,
    ) -> Result<Self, E> {
        let count = values.iter().fold(count, |least, values| least.min(values.len()));
        let mut branches = Self { nodes, values, veerings: Vec::new(), count };
        branches.look(spectrum)?;
        Ok(branches)
    }

    fn look<E>(&mut self, spectrum: &impl Fn(f64) -> Result<Vec<f64>, E>) -> Result<(), E> {
        for position in 0..self.count.saturating_sub(1) {
            let gaps: Vec<f64> = self.values.iter().map(|values| relative_gap(values, position)).collect();
            for k in 1..gaps.len().saturating_sub(1) {
                if gaps[k] < NEAR && gaps[k] < gaps[k - 1] && gaps[k] <= gaps[k + 1] {
                    let between = [self.nodes[k - 1], self.nodes[k], self.nodes[k + 1]];
                    self.veerings.extend(nearest(spectrum, between, position)?);
                }
            }
        }
        self.veerings.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        Ok(())
    }

    /// Number of branches.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The branch at each sorted position at a rotor speed; at rest branches are numbered by position.
    pub fn order(&self, speed: f64) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.count).collect();
        for veering in self.veerings.iter().take_while(|veering| veering.speed <= speed) {
            if veering.crosses {
                order.swap(veering.position, veering.position + 1);
            }
        }
        order
    }

    /// The sorted position of each branch at a rotor speed.
    pub fn positions(&self, speed: f64) -> Vec<usize> {
        let mut positions = alloc::vec![0; self.count];
        for (position, branch) in self.order(speed).into_iter().enumerate() {
            positions[branch] = position;
        }
        positions
    }
}

/// One node beyond the end, so that a least gap at it is seen.
fn last_node(nominal: f64, to: f64) -> f64 {
    ceil(to / (nominal / NODES)).clamp(1.0, MOST_NODES) + 1.0
}

fn frequency(eigenvalue: f64) -> f64 {
    sqrt(maximum(eigenvalue, 0.0))
}

fn relative_gap(values: &[f64], position: usize) -> f64 {
    let (lower, upper) = (frequency(values[position]), frequency(values[position + 1]));
    if upper > 0.0 { (upper - lower) / upper } else { 1.0 }
}

/// Where two neighbours come nearest: by their distance in λ, in which straight branches cross and veer alike, else, where
/// it falls up to an end, as a share of their frequency. From rest on there is no such share of rigid motions.
fn nearest<E>(
    spectrum: &impl Fn(f64) -> Result<Vec<f64>, E>,
    between: [f64; 3],
    position: usize,
) -> Result<Option<Veering>, E> {
    let distance = |speed: f64| spectrum(speed).map(|values| values[position + 1] - values[position]);
    let share = |speed: f64| spectrum(speed).map(|values| relative_gap(&values, position));
    let mut found = least(&distance, between)?;
    if found.is_none() && between[0] > 0.0 {
        found = least(&share, between)?;
    }
    let Some(speed) = found else { return Ok(None) };
    let values = spectrum(speed)?;
    let (lower, upper) = (frequency(values[position]), frequency(values[position + 1]));
    let gap = upper - lower;
    let crosses = upper > 0.0 && gap < CROSSING * upper;
    Ok(Some(Veering { position, crosses, speed, gap, frequency: 0.5 * (lower + upper) }))
}

/// Where a distance is least between two rotor speeds, by golden section from one between them, and parabolas through
/// its square, which is one where two straight branches veer; nothing if at an end.
fn least<E>(
    distance: &impl Fn(f64) -> Result<f64, E>,
    [mut low, mut at, mut high]: [f64; 3],
) -> Result<Option<f64>, E> {
    let square = |speed: f64| distance(speed).map(|distance| distance * distance);
    let (ends, width) = ([low, high], high - low);
    let (mut below, mut here, mut above) = (square(low)?, square(at)?, square(high)?);
    for step in 0..STEPS {
        // The parabola in Ω² through three points.
        let [a, b, c] = [low * low, at * at, high * high];
        let (left, right) = ((here - below) / (b - a), (above - here) / (c - b));
        let curvature = (right - left) / (c - a);
        let vertex = 0.5 * (a + b) - 0.5 * left / curvature;
        let guess = sqrt(maximum(vertex, 0.0));
        let golden = if at - low > high - at { at - 0.381_966 * (at - low) } else { at + 0.381_966 * (high - at) };
        let inside = guess > low && guess < high && (guess - at).abs() > 1e-9 * width;
        let next = if inside && step % 3 != 2 { guess } else { golden };
        let value = square(next)?;
        let moved = (next - at).abs();
        if value <= here {
            if next < at {
                (high, above) = (at, here);
            } else {
                (low, below) = (at, here);
            }
            (at, here) = (next, value);
        } else if next < at {
            (low, below) = (next, value);
        } else {
            (high, above) = (next, value);
        }
        if moved < CLOSE * width && inside {
            break;
        }
    }
    Ok(ends.iter().all(|end| (at - end).abs() > END * width).then_some(at))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two straight branches in Ω² that meet at Ω² = 1, coupled by δ: λ = m ± √(d² + δ²).
    fn pair(coupling: f64) -> impl Fn(f64) -> Result<Vec<f64>, ()> {
        move |speed: f64| {
            let s = speed * speed;
            let (mean, half) = (4.0 + s, 0.5 * (1.0 - s));
            let root = (half * half + coupling * coupling).sqrt();
            Ok(alloc::vec![mean - root, mean + root, 100.0])
        }
    }

    fn branches(coupling: f64, to: f64) -> Branches {
        let nodes = Branches::nodes(1.5, to);
        let values = nodes.iter().map(|speed| pair(coupling)(*speed).unwrap()).collect();
        Branches::new(&pair(coupling), nodes, values, 3).unwrap()
    }

    #[test]
    fn branches_that_meet_cross_and_coupled_ones_veer() {
        for (coupling, crosses) in [(0.0, true), (1e-3, true), (0.1, false)] {
            let branches = branches(coupling, 2.0);
            assert_eq!(branches.veerings.len(), 1, "{coupling}: {:?}", branches.veerings);
            let veering = branches.veerings[0];
            assert_eq!((veering.position, veering.crosses), (0, crosses));
            assert!((veering.speed - 1.0).abs() < 1e-6, "{coupling}: {}", veering.speed);
            let exact = (5.0 + coupling).sqrt() - (5.0 - coupling).sqrt();
            assert!((veering.gap - exact).abs() < 1e-6, "{coupling}: {} {exact}", veering.gap);
            assert_eq!(branches.order(0.9), [0, 1, 2]);
            assert_eq!(branches.order(1.1), if crosses { [1, 0, 2] } else { [0, 1, 2] });
        }
    }

    /// Two rigid motions have frequencies in proportion to the rotor speed, or nearly: nowhere do they come nearest.
    #[test]
    fn motions_that_are_rigid_at_rest_do_not_veer_there() {
        let rigid = |speed: f64| -> Result<Vec<f64>, ()> {
            let s = speed * speed;
            Ok(alloc::vec![s, s * (1.2 + 0.1 * s), 100.0])
        };
        let nodes = Branches::nodes(1.5, 2.0);
        let values = nodes.iter().map(|speed| rigid(*speed).unwrap()).collect();
        assert_eq!(Branches::new(&rigid, nodes, values, 3).unwrap().veerings, []);
    }

    /// Frequencies 1 + 2 s and its like with a distance of 0.1 (1 + (s − 1)²) of the upper one: λ parts all the way.
    #[test]
    fn branches_come_nearest_as_a_share_of_their_frequency_where_they_part_in_eigenvalue() {
        let parting = |speed: f64| -> Result<Vec<f64>, ()> {
            let s = speed * speed;
            let (upper, share) = (1.0 + 2.0 * s, 0.1 * (1.0 + (s - 1.0) * (s - 1.0)));
            Ok(alloc::vec![(upper * (1.0 - share)).powi(2), upper * upper, 1e4])
        };
        let nodes = Branches::nodes(1.5, 1.4);
        let values = nodes.iter().map(|speed| parting(*speed).unwrap()).collect();
        let found = Branches::new(&parting, nodes, values, 3).unwrap().veerings;
        assert_eq!(found.len(), 1, "{found:?}");
        assert!((found[0].speed - 1.0).abs() < 1e-6 && (found[0].gap - 0.3).abs() < 1e-9, "{found:?}");
    }

    #[test]
    fn branches_do_not_depend_on_the_end_of_the_range() {
        for to in [1.2, 2.0, 3.0] {
            assert_eq!(branches(0.05, to).veerings, branches(0.05, 1.9).veerings, "{to}");
        }
    }
}
