//! Interpolation of several smooth functions at once on Chebyshev–Lobatto nodes, by the
//! barycentric formula (Berrut & Trefethen, SIAM Review 46, 2004, Eq. 4.2 and 5.4).

use crate::numerics::scalar::cos;
use alloc::vec::Vec;
use core::f64::consts::PI;

/// Node `index` of the `degree` + 1 nodes on [from, to], from the first to the last; the ends are
/// exact. The nodes of a degree are among those of twice the degree.
pub fn node(from: f64, to: f64, degree: usize, index: usize) -> f64 {
    match index {
        0 => from,
        i if i == degree => to,
        i => 0.5 * (from + to) - 0.5 * (to - from) * cos(PI * (i as f64 / degree as f64)),
    }
}

/// The interpolant at `x` of functions whose values at node k are `rows[k]`, one value each; of as many of
/// them as there are `values`, from the one with the index `first`.
pub fn interpolate(nodes: &[f64], rows: &[Vec<f64>], first: usize, x: f64, values: &mut [f64]) {
    let of = first..first + values.len();
    if let Some(row) = nodes.iter().position(|node| node.to_bits() == x.to_bits()).and_then(|index| rows.get(index)) {
        values.copy_from_slice(&row[of]);
        return;
    }
    let mut sum = 0.0;
    values.fill(0.0);
    for (index, (node, row)) in nodes.iter().zip(rows).enumerate() {
        let weight = weight(index, nodes.len()) / (x - node);
        sum += weight;
        values.iter_mut().zip(&row[of.clone()]).for_each(|(value, entry)| *value += weight * entry);
    }
    for value in values {
        *value /= sum;
    }
}

/// How near to a node, as a share of the range, slopes are not taken: the formula loses as many
/// digits there. Moving away costs as many: seven are right, enough to steer Newton's method.
const NEAR_NODE: f64 = 1e-7;

/// [`interpolate`], and the derivatives of the interpolants at `x` to about seven digits.
pub fn with_slopes(nodes: &[f64], rows: &[Vec<f64>], function: usize, x: f64, values: &mut [f64], slopes: &mut [f64]) {
    let (Some(first), Some(last)) = (nodes.first(), nodes.last()) else { return };
    interpolate(nodes, rows, function, x, values);
    let hair = NEAR_NODE * (last - first);
    let moved;
    let (x, values) = match nodes.iter().find(|node| (x - **node).abs() < hair) {
        Some(node) => {
            let beside = if node + hair <= *last { node + hair } else { node - hair };
            let mut there = slopes.to_vec();
            interpolate(nodes, rows, function, beside, &mut there);
            moved = there;
            (beside, &moved[..])
        }
        None => (x, &*values),
    };
    let of = function..function + slopes.len();
    let sum: f64 = nodes.iter().enumerate().map(|(index, node)| weight(index, nodes.len()) / (x - node)).sum();
    slopes.fill(0.0);
    for (index, (node, row)) in nodes.iter().zip(rows).enumerate() {
        let weight = weight(index, nodes.len()) / ((x - node) * (x - node) * sum);
        let each = slopes.iter_mut().zip(values).zip(&row[of.clone()]);
        each.for_each(|((slope, value), entry)| *slope += weight * (value - entry));
    }
}

/// Barycentric weight of the Lobatto nodes: alternating, half at the ends.
fn weight(index: usize, count: usize) -> f64 {
    let size = if index == 0 || index + 1 == count { 0.5 } else { 1.0 };
    if index.is_multiple_of(2) { size } else { -size }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    #[test]
    fn a_rational_function_and_its_slope_are_met() {
        let nodes: Vec<f64> = (0..=32).map(|i| node(0.0, 4.0, 32, i)).collect();
        let rows: Vec<Vec<f64>> = nodes.iter().map(|x| vec![1.0 / (2.0 + x), x * x]).collect();
        let (mut values, mut derivatives) = (vec![0.0; 2], vec![0.0; 2]);
        for i in 0..=100 {
            let x = f64::from(i) * 0.04;
            with_slopes(&nodes, &rows, 0, x, &mut values, &mut derivatives);
            let mut alone = [0.0];
            interpolate(&nodes, &rows, 1, x, &mut alone);
            assert_eq!(alone, values[1..], "one function by itself");
            assert!((values[0] - 1.0 / (2.0 + x)).abs() < 1e-15, "{x}: {}", values[0]);
            assert!((values[1] - x * x).abs() < 2e-14, "{x}: {}", values[1]);
            assert!((derivatives[1] - 2.0 * x).abs() < 4e-6, "{x}: {}", derivatives[1]);
        }
    }

    #[test]
    fn nodes_of_a_degree_are_among_those_of_twice_it_and_the_ends_are_exact() {
        let (from, to) = (0.1, 0.7);
        for degree in [4, 8, 16] {
            assert_eq!((node(from, to, degree, 0), node(from, to, degree, degree)), (from, to));
            for index in 0..=degree {
                assert_eq!(node(from, to, degree, index), node(from, to, 2 * degree, 2 * index));
            }
            assert!((0..=degree).map(|index| node(from, to, degree, index)).is_sorted());
        }
    }

    #[test]
    fn values_at_the_nodes_are_those_given() {
        let nodes: Vec<f64> = (0..=4).map(|i| node(2.0, 3.0, 4, i)).collect();
        let rows: Vec<Vec<f64>> = [3.0, -1.0, 0.1, 7.0, 1e9].map(|value| vec![value]).into();
        let mut value = [0.0];
        for (node, row) in nodes.iter().zip(&rows) {
            interpolate(&nodes, &rows, 0, *node, &mut value);
            assert_eq!(value, row[..]);
        }
        // All nodes in one place, as for a range of one speed.
        interpolate(&[5.0; 3], &[vec![1.5], vec![1.5], vec![1.5]], 0, 5.0, &mut value);
        assert_eq!(value, [1.5]);
        let mut slope = [0.5];
        with_slopes(&[], &[], 0, 1.0, &mut value, &mut slope);
        assert_eq!((value, slope), ([1.5], [0.5]), "nothing to take a slope of");
    }
}
