//! What lies between the speeds of a chart.

use crate::numerics::scalar::sqrt;

/// A branch's frequency between the speeds of its chart [rad/s]: ω² is smooth in Ω², and a parabola
/// through the three nearest points follows it. None without three speeds.
pub fn between(speeds: &[f64], frequencies: &[f64], speed: f64) -> Option<f64> {
    let last = speeds.len().min(frequencies.len()).checked_sub(1).filter(|&last| last >= 2)?;
    let above = speeds[..last].partition_point(|&each| each <= speed).max(1);
    let low = above - 1;
    let nearest = if speed - speeds[low] < speeds[low + 1] - speed { low } else { low + 1 };
    let centre = nearest.clamp(1, last - 1);
    let points = [centre - 1, centre, centre + 1].map(|i| (speeds[i] * speeds[i], frequencies[i] * frequencies[i]));
    let x = speed * speed;
    let mut sum = 0.0;
    for (i, point) in points.iter().enumerate() {
        let mut term = point.1;
        for (_, other) in points.iter().enumerate().filter(|(j, _)| *j != i) {
            term *= (x - other.0) / (point.0 - other.0);
        }
        sum += term;
    }
    Some(sqrt(sum.max(0.0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_in_the_squares_is_met() {
        let speeds: [f64; 6] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0];
        let squared = |x: f64| 7.0 + 3.0 * x * x + 0.01 * x * x * x * x;
        let frequencies = speeds.map(|speed| sqrt(squared(speed)));
        for speed in [0.0, 0.3, 1.0, 2.5, 3.999, 4.7, 5.0] {
            let found = between(&speeds, &frequencies, speed).unwrap();
            assert!((found * found - squared(speed)).abs() < 1e-12 * squared(speed), "{speed}: {found}");
        }
        assert_eq!(between(&speeds, &frequencies, 3.0), Some(frequencies[3]), "a speed of the chart keeps its value");
    }

    #[test]
    fn too_few_speeds_are_no_parabola_and_a_negative_square_is_none() {
        assert_eq!(between(&[0.0, 1.0], &[1.0, 2.0], 0.5), None);
        assert_eq!(between(&[], &[], 0.5), None);
        assert_eq!(between(&[0.0, 1.0, 2.0], &[0.0, 0.0, 3.0], 0.5), Some(0.0));
    }
}
