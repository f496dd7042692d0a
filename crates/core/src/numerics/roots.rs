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

/// Ends of a bracket nearer to one another than this, relatively, hold the root.
const CLOSE: f64 = 1e-12;

/// The root of a function between two points at which its values differ in sign, by the Illinois rule (M. Dowell &
/// P. Jarratt, BIT 11, 1971), without slopes. `start` is a guess.
pub fn bracketed(mut f: impl FnMut(f64) -> f64, low: (f64, f64), high: (f64, f64), start: f64) -> f64 {
    let ((mut a, mut at_a), (mut b, mut at_b)) = (low, high);
    if at_b == 0.0 {
        return b;
    }
    let mut kept = 0_i8;
    for step in 0..MOST_STEPS {
        if at_a == 0.0 || (b - a).abs() <= CLOSE * a.abs().max(b.abs()) {
            return a;
        }
        let line = if step == 0 { start } else { (a * at_b - b * at_a) / (at_b - at_a) };
        // Now and then in the middle, so that it ends whatever the values.
        let next = if step % 8 != 7 && line > a.min(b) && line < a.max(b) { line } else { a + 0.5 * (b - a) };
        let value = f(next);
        if value == 0.0 || (next - a).abs() <= CLOSE * next.abs() || (next - b).abs() <= CLOSE * next.abs() {
            return next;
        }
        if (value > 0.0) == (at_b > 0.0) {
            (b, at_b) = (next, value);
            at_a *= if kept == 1 { 0.5 } else { 1.0 };
            kept = 1;
        } else {
            (a, at_a) = (next, value);
            at_b *= if kept == -1 { 0.5 } else { 1.0 };
            kept = -1;
        }
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_found_without_slopes() {
        let mut count = 0;
        let root = bracketed(
            |x| {
                count += 1;
                x * x - 2.0
            },
            (0.0, -2.0),
            (2.0, 2.0),
            1.3,
        );
        assert!((root - core::f64::consts::SQRT_2).abs() < 1e-12 && count < 15, "{root} in {count}");
        assert_eq!(bracketed(|x| x - 1.0, (0.0, -1.0), (1.0, 0.0), 0.5), 1.0);
        assert_eq!(bracketed(|x| x, (0.0, 0.0), (1.0, 1.0), f64::NAN), 0.0);
        let step = bracketed(|x| if x < 0.7 { -1e9 } else { 1e-9 }, (0.0, -1e9), (1.0, 1e-9), 7.0);
        assert!((step - 0.7).abs() < 1e-12, "{step}");
    }

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
