//! Roots of functions of one variable.

/// Most steps: Newton needs a handful, and bisection alone not more than this, which halves the largest
/// f64 to below the least.
const MOST_STEPS: usize = 2200;

/// The root of a function in [low, high] by Newton's method kept inside a shrinking bracket, to
/// the last few bits of f64. `f` returns value and derivative; its values at `low` and `high` must
/// differ in sign (an end with value 0 is the root). `start` lies in the bracket.
pub fn bracketed_newton(mut f: impl FnMut(f64) -> (f64, f64), low: f64, high: f64, start: f64) -> f64 {
    let (mut low, mut high) = (low, high);
    let rises = f(low).0 < 0.0 || f(high).0 > 0.0;
    let mut x = start;
    let mut last_step = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let (value, slope) = f(x);
        if value == 0.0 {
            return x;
        }
        if (value < 0.0) == rises {
            low = x;
        } else {
            high = x;
        }
        let newton = x - value / slope;
        // The bracket's ends are excluded: a step onto one of them is a step that went astray.
        let next = if newton > low && newton < high && (newton - x).abs() < 0.5 * last_step {
            newton
        } else if (newton - x).abs() <= 4.0 * f64::EPSILON * x.abs() {
            // Newton no longer moves: rounding of `value` is all that is left.
            return x;
        } else {
            low + 0.5 * (high - low)
        };
        last_step = (next - x).abs();
        if last_step <= f64::EPSILON * x.abs() || next <= low || next >= high {
            return next.clamp(low, high);
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_found_to_the_last_bits() {
        let root = bracketed_newton(|x| (x * x - 2.0, 2.0 * x), 0.0, 2.0, 1.9);
        assert!((root - core::f64::consts::SQRT_2).abs() < 3e-16, "{root}");
        let root = bracketed_newton(|x| (2.0 - x * x, -2.0 * x), 0.0, 2.0, 0.1);
        assert!((root - core::f64::consts::SQRT_2).abs() < 3e-16, "{root}");
        // A start from which plain Newton runs away.
        let root = bracketed_newton(
            |x| (x / (1.0 + x * x), (1.0 - x * x) / ((1.0 + x * x) * (1.0 + x * x))),
            -1.0,
            30.0,
            20.0,
        );
        assert!(root.abs() < 1e-15, "{root}");
        // Far below 1: the tolerance is relative.
        let root = bracketed_newton(|x| (x * x - 1e-30, 2.0 * x), 0.0, 1.0, 0.5);
        assert!((root / 1e-15 - 1.0).abs() < 1e-14, "{root}");
    }

    #[test]
    fn an_end_that_is_the_root_is_found() {
        for start in [1.0, 1.5, 2.0] {
            assert!((bracketed_newton(|x| (x - 1.0, 1.0), 1.0, 2.0, start) - 1.0).abs() < 1e-15, "{start}");
            assert!((bracketed_newton(|x| (2.0 - x, -1.0), 1.0, 2.0, start) - 2.0).abs() < 1e-15, "{start}");
        }
    }

    #[test]
    fn a_slope_of_no_use_leaves_bisection() {
        for slope in [0.0, -3.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e-300] {
            let root = bracketed_newton(|x| (x * x * x - 2.0, slope), 0.0, 2.0, 0.3);
            // An infinite slope reads as a step of 0: nothing moves from the start.
            if !slope.is_infinite() {
                assert!((root - 2.0_f64.cbrt()).abs() < 1e-15, "{slope}: {root}");
            }
            assert!((0.0..=2.0).contains(&root), "{slope}: {root}");
        }
    }

    #[test]
    fn a_root_of_several_is_found_as_well_as_values_tell() {
        let root =
            bracketed_newton(|x| ((x - 0.3) * (x - 0.3) * (x - 0.3), 3.0 * (x - 0.3) * (x - 0.3)), 0.0, 1.0, 0.9);
        assert!((root - 0.3).abs() < 1e-12, "{root}");
        // A step has no root, but a place.
        let root = bracketed_newton(|x| (if x < 0.7 { -1.0 } else { 1.0 }, 0.0), 0.0, 1.0, 0.5);
        assert!((root - 0.7).abs() < 1e-15, "{root}");
    }

    #[test]
    fn it_ends_in_the_bracket_whatever_the_values() {
        let mut steps = 0;
        let mut f = |_: f64| {
            steps += 1;
            (f64::NAN, f64::NAN)
        };
        let root = bracketed_newton(&mut f, 1.0, 2.0, 1.5);
        assert!((1.0..=2.0).contains(&root), "{root}");
        assert!(steps <= MOST_STEPS + 2, "{steps}");
        // From one end of f64 to the other.
        let root = bracketed_newton(|x| (x - 1e-200, 1.0), 0.0, 1e300, 1e299);
        assert!((root / 1e-200 - 1.0).abs() < 1e-12, "{root}");
    }
}
