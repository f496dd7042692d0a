//! A table along the span with a part of it changed.

use super::change::differ;
use alloc::vec::Vec;

/// Radii and the values there.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Piece {
    pub(super) r: Vec<f64>,
    pub(super) values: Vec<f64>,
}

/// A table with what lies between two radii changed, and a step where the change begins and ends.
/// Stations outside keep their bits. None where nothing is changed, or where the table is faulty:
/// lists of different lengths, radii that fall or values that are no numbers.
#[allow(clippy::float_cmp, reason = "a step is the same radius written twice")]
pub(super) fn restationed(
    r: &[f64],
    values: &[f64],
    (from, to): (f64, f64),
    change: impl Fn(f64) -> f64,
) -> Option<Piece> {
    let sound = r.len() == values.len()
        && r.iter().chain(values).all(|number| number.is_finite())
        && r.windows(2).all(|pair| pair[0] <= pair[1]);
    if !sound {
        return None;
    }
    let mut out = Piece::default();
    let mut changed = false;
    let mut put = |out: &mut Piece, x: f64, y: f64, inside: bool| {
        let new = if inside { change(y) } else { y };
        changed |= differ(new, y);
        out.r.push(x);
        out.values.push(new);
    };
    // The end of one piece and the beginning of the next are one station where they agree.
    let twice = |out: &Piece| matches!((&out.r[..], &out.values[..]), ([.., x, y], [.., a, b]) if !differ(*x, *y) && !differ(*a, *b));
    for i in 0..r.len().saturating_sub(1) {
        let (a, b) = (r[i], r[i + 1]);
        if a == b {
            // A step at the very beginning or end: its outer side lies outside the table.
            if i == 0 {
                put(&mut out, a, values[0], from < a && a <= to);
            }
            if i + 2 == r.len() {
                put(&mut out, b, values[i + 1], from <= b && b < to);
            }
            continue;
        }
        let step_before = i > 0 && r[i - 1] == a;
        let at = |x: f64| {
            if x == a {
                values[i]
            } else if x == b {
                values[i + 1]
            } else {
                values[i] + ((values[i + 1] - values[i]) * (x - a)) / (b - a)
            }
        };
        let cuts: Vec<f64> =
            [a].into_iter().chain([from, to].into_iter().filter(|x| *x > a && *x < b)).chain([b]).collect();
        for (k, ends) in cuts.windows(2).enumerate() {
            let inside = ends[0] >= from && ends[1] <= to;
            put(&mut out, ends[0], at(ends[0]), inside);
            // A step of the table stays one, whatever its values.
            if !(k == 0 && step_before) && twice(&out) {
                out.r.pop();
                out.values.pop();
            }
            put(&mut out, ends[1], at(ends[1]), inside);
        }
    }
    changed.then_some(out)
}
