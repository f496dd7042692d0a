//! Where a mode shape stands still.

use alloc::vec::Vec;

/// Displacements smaller than this share of the largest count as none.
const NOTHING: f64 = 1e-9;

/// Radii where a sampled displacement passes through zero, ascending; linear between samples. An end
/// that stands still is no node, nor is a place that is only touched.
pub fn nodes(radii: &[f64], displacement: &[f64]) -> Vec<f64> {
    let largest = displacement.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let moving = radii.iter().zip(displacement).filter(|(_, value)| value.abs() > NOTHING * largest);
    let mut nodes = Vec::new();
    let mut last: Option<(f64, f64)> = None;
    for (&radius, &value) in moving {
        if let Some((before, was)) = last
            && (was < 0.0) != (value < 0.0)
        {
            nodes.push(before + was / (was - value) * (radius - before));
        }
        last = Some((radius, value));
    }
    nodes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_node_is_where_the_sign_changes() {
        let radii = [1.0, 2.0, 3.0, 4.0, 5.0];
        assert_eq!(nodes(&radii, &[0.0, -1.0, 1.0, 3.0, -1.0]), [2.5, 4.75]);
        assert!(nodes(&radii, &[0.0, 1.0, 0.0, 1.0, 2.0]).is_empty(), "touched");
        assert_eq!(nodes(&radii, &[0.0, 1.0, 0.0, -1.0, -2.0]), [3.0], "a sample on the node");
        assert!(nodes(&radii, &[1e-12, -1e-12, 1.0, 1.0, 1.0]).is_empty(), "noise at the root");
        assert!(nodes(&radii, &[0.0; 5]).is_empty());
        assert!(nodes(&[], &[]).is_empty());
    }
}
