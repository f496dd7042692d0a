//! Whether the independent solution contradicts the bounds that the product states, on blades of any
//! kind: first in f64 and, where that disagrees, with twice the digits.

use crate::blades::TestBlade;
use crate::exact::{Double, Exact, Real};
use bladefan_core::Dof;

/// Most panels of a blade in f64 and with twice the digits: what needs more is left undecided.
const MOST: [usize; 2] = [100_000, 10_000];
/// What a square root and a square may do to a bound, relative to it.
const ROUNDING: f64 = 1e-15;
/// What counts as the eigenvalue 0, relative to the largest one that is looked at.
const ZERO: f64 = 1e-20;

/// The bounds of one mode [rad/s], where there are any.
pub type Bounds = Option<(f64, f64)>;

/// What became of the bounds of one degree of freedom.
#[derive(Clone, Debug, Default)]
pub struct Verdict {
    /// Intervals that were looked at.
    pub checked: usize,
    /// Modes without an interval.
    pub without: usize,
    /// Intervals that need more panels than are allowed.
    pub undecided: usize,
    /// What is wrong.
    pub wrong: Vec<String>,
}

impl Verdict {
    /// Adds another degree of freedom.
    pub fn add(&mut self, other: Self) {
        self.checked += other.checked;
        self.without += other.without;
        self.undecided += other.undecided;
        self.wrong.extend(other.wrong);
    }
}

/// Looks at the bounds of the lowest modes of one degree of freedom, in their order, and at the number
/// that is said to part them from the next one.
pub fn of(blade: &TestBlade, dof: Dof, speed: f64, bounds: &[Bounds], separation: Option<f64>) -> Verdict {
    let mut verdict = Verdict::default();
    let stated = || bounds.iter().flatten();
    for (lower, upper) in stated() {
        if !(0.0 <= *lower && lower <= upper && upper.is_finite()) {
            verdict.wrong.push(format!("{dof}: bounds {lower} and {upper}"));
            return verdict;
        }
    }
    verdict.without = bounds.iter().filter(|bounds| bounds.is_none()).count();
    let highest = stated().map(|bounds| bounds.1).chain(separation).fold(0.0, f64::max);
    let panels = |most| Exact::<f64>::within(blade, dof, speed, 1.001 * highest, most);
    let Some(fast) = panels(MOST[0]) else {
        verdict.undecided = stated().count();
        return verdict;
    };
    let mut precise = None;
    for (i, &(lower, upper)) in bounds.iter().enumerate().filter_map(|(i, bounds)| Some((i, bounds.as_ref()?))) {
        if counts(&fast, speed, lower, upper, highest) == Some((i, i + 1)) {
            verdict.checked += 1;
            continue;
        }
        let exact = precise.get_or_insert_with(|| Exact::<Double>::within(blade, dof, speed, 1.001 * highest, MOST[1]));
        let Some((below, above)) = exact.as_ref().and_then(|exact| counts(exact, speed, lower, upper, highest)) else {
            verdict.undecided += 1;
            continue;
        };
        verdict.checked += 1;
        if below > i || above < i + 1 {
            let by = exact.as_ref().map_or(f64::NAN, |exact| violation(exact, speed, (lower, upper), i));
            verdict.wrong.push(format!(
                "{dof} {}: {below} and {above} eigenvalues below its bounds {lower} and {upper}, wrong by about {by:.0e}",
                i + 1
            ));
        }
    }
    if let Some(separation) = separation {
        let beyond = |count: &usize| *count > bounds.len();
        let fast = fast.try_count_below(speed, squared(separation, 1.0 - ROUNDING));
        if fast.as_ref().is_none_or(beyond) {
            let exact =
                precise.get_or_insert_with(|| Exact::<Double>::within(blade, dof, speed, 1.001 * highest, MOST[1]));
            let below =
                exact.as_ref().and_then(|exact| exact.try_count_below(speed, squared(separation, 1.0 - ROUNDING)));
            if let Some(below) = below.filter(beyond) {
                let modes = bounds.len();
                verdict.wrong.push(format!(
                    "{dof}: {below} eigenvalues below {separation}, which is to part {modes} from the rest"
                ));
            }
        }
    }
    verdict
}

/// A bound as an eigenvalue, times a factor.
fn squared<T: Real>(bound: f64, factor: f64) -> T {
    T::of(bound) * T::of(bound) * T::of(factor)
}

/// How far bounds must be moved apart, relative to them, to hold the eigenvalue of this index, to a power of ten.
fn violation(exact: &Exact<Double>, speed: f64, (lower, upper): (f64, f64), index: usize) -> f64 {
    let square = |bound: f64, factor: f64| Double::of(bound * factor) * Double::of(bound * factor);
    let holds = |by: f64| {
        exact.try_count_below(speed, square(lower, 1.0 - by)).is_some_and(|count| count <= index)
            && exact.try_count_below(speed, square(upper, 1.0 + by)).is_some_and(|count| count > index)
    };
    (-15..0).map(|exponent| 10_f64.powi(exponent)).find(|by| holds(*by)).unwrap_or(1.0)
}

/// Numbers of eigenvalues below both bounds, no more and no fewer than they hold against rounding.
/// Nothing where a bound is too large to be squared.
fn counts<T: Real>(exact: &Exact<T>, speed: f64, lower: f64, upper: f64, highest: f64) -> Option<(usize, usize)> {
    let above: T =
        squared::<T>(upper, 1.0 + ROUNDING) + T::of(if upper > 0.0 { 0.0 } else { ZERO * highest * highest });
    let fits = |square: T| square.near().is_finite() && (square.near() > 1e-280 || square.near() == 0.0);
    let below: T = squared(lower, 1.0 - ROUNDING);
    if !fits(below) || !fits(above) {
        return None;
    }
    // Nothing lies below 0.
    let below = if lower > 0.0 { exact.try_count_below(speed, below)? } else { 0 };
    Some((below, exact.try_count_below(speed, above)?))
}
