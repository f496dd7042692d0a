//! Where to integrate: panels that respect every station and every wave of the functions.

use crate::blade::{Blade, Racket};
use crate::dof::Dof;
use crate::functions::AssumedFunctions;
use crate::numerics::PiecewiseLinear;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::{ceil, floor, ln, pow};
use alloc::vec::Vec;
use core::f64::consts::PI;

/// Largest ratio of a stiffness at the ends of a part made by [`Segment::taper_cuts`]. Strain is
/// moment by stiffness: polynomials follow 1/(1 + aξ) the more slowly the nearer its pole, and so do
/// Gauss rules; at this ratio by a factor of 4.4 per degree.
const TAPER: f64 = 2.5;
/// Most parts that tapers may add to the span. Between limits of 1e-30 and 1e30 one segment has 151.
const MOST_PARTS: f64 = 2000.0;

/// A stretch of the span within which every property is linear.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Segment {
    /// Inner end [m].
    pub(crate) from: f64,
    /// Outer end [m].
    pub(crate) to: f64,
}

impl Segment {
    /// Radii inside the segment, one of so many, that cut it where a positive property has changed by
    /// [`TAPER`] or less; by more where the parts of all segments would be too many.
    fn taper_cuts(&self, property: &PiecewiseLinear, segments: usize) -> impl Iterator<Item = f64> {
        let (from, length) = (self.from, self.to - self.from);
        let (inner, outer) = (property.limits(self.from).1, property.limits(self.to).0);
        let ratio = outer / inner;
        let parts = ceil(ln(ratio).abs() / ln(TAPER)).min(floor(MOST_PARTS / segments as f64).max(1.0));
        let share = move |i: f64| (pow(ratio, i / parts) - 1.0) / (ratio - 1.0);
        (1_u16..)
            .map(f64::from)
            .take_while(move |i| *i < parts)
            .map(move |i| from + share(i) * length)
            .scan(from, move |last, cut| {
                Some((cut > *last && cut < from + length).then(|| {
                    *last = cut;
                    cut
                }))
            })
            .flatten()
    }

    /// Calls `f(a, b, rule)` for equal panels of this segment and the Gauss rule that integrates the
    /// product of two of the functions and a cubic over each; none is longer than half a wave.
    pub(super) fn panels<'a>(
        &self,
        functions: &dyn AssumedFunctions,
        rules: &'a GaussRules,
        mut f: impl FnMut(f64, f64, &'a [(f64, f64)]),
    ) {
        if functions.degree() > 0 {
            return f(self.from, self.to, rules.with_points(functions.degree() + 2));
        }
        let wave_number = functions.wave_number();
        let length = self.to - self.from;
        let count = ceil(wave_number * length / PI).max(1.0);
        let rule = rules.for_phase(wave_number * length / count);
        // `count` is a whole number of at most some hundreds: 200 functions have 200 half waves.
        let mut a = self.from;
        let mut i = 1.0;
        while i < count {
            let b = self.from + length * (i / count);
            f(a, b, rule);
            a = b;
            i += 1.0;
        }
        f(a, self.to, rule);
    }
}

/// Radii that cut the segments of a degree of freedom where its stiffness tapers.
pub(crate) fn taper_cuts(blade: &Blade, dof: Dof) -> Vec<f64> {
    let segments = segments(blade, dof, &[]);
    let cuts = segments.iter().flat_map(|segment| segment.taper_cuts(blade.stiffness(dof), segments.len()));
    cuts.collect()
}

/// The segments of a degree of freedom from its root to the tip, inner first: they end at stations and point
/// masses; `extra` radii split them too.
pub(crate) fn segments(blade: &Blade, dof: Dof, extra: &[f64]) -> Vec<Segment> {
    let (root, radius) = (blade.root(dof).offset, blade.radius());
    let mut properties = alloc::vec![blade.mass(), blade.stiffness(dof)];
    if dof == Dof::Torsion {
        properties.extend([blade.polar_inertia(), blade.mass_offset()]);
        if blade.racket() != Racket::Paper {
            properties.extend(blade.inertias());
        }
    }
    let mut ends: Vec<f64> = properties
        .iter()
        .flat_map(|property| property.stations())
        .chain(extra)
        .copied()
        .chain(blade.point_masses().iter().map(|mass| mass.r))
        .filter(|&r| r > root && r < radius)
        .collect();
    ends.push(root);
    ends.push(radius);
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    ends.windows(2).map(|pair| Segment { from: pair[0], to: pair[1] }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lagrange::tests::tapered;
    use alloc::vec;

    fn cuts(inner: f64, outer: f64, segments: usize) -> Vec<f64> {
        let property = PiecewiseLinear::new(vec![0.0, 1.0], vec![inner, outer]).unwrap();
        Segment { from: 0.0, to: 1.0 }.taper_cuts(&property, segments).collect()
    }

    /// Where numbers can tell the radii apart: towards a soft tip they stand too near to 1. The cuts
    /// are rounded, and so is the stiffness there.
    #[test]
    fn no_part_tapers_by_more_than_asked() {
        for (inner, outer) in [(1.0, 2.6), (1.0, 100.0), (100.0, 1.0), (3e4, 1.0), (1e-30, 1e30), (1e-3, 1e9)] {
            let ends: Vec<f64> = [0.0].into_iter().chain(cuts(inner, outer, 1)).chain([1.0]).collect();
            for pair in ends.windows(2) {
                let [a, b] = [pair[0], pair[1]].map(|x| inner + (outer - inner) * x);
                let ratio = (a / b).max(b / a);
                assert!(ratio < TAPER * (1.0 + 1e-9), "{inner} to {outer}: {ratio} over {pair:?}");
            }
        }
    }

    #[test]
    fn parts_are_few_and_ascend_between_the_limits_of_any_stiffness() {
        let values = [1e-30, 1e-10, 1.0, 1e10, 1e30];
        for inner in values {
            for outer in values {
                for segments in [1, 100, 5000] {
                    let cuts = cuts(inner, outer, segments);
                    assert!(cuts.len() <= 151, "{}", cuts.len());
                    assert!((cuts.len() + 1) * segments <= 2000.max(segments), "{} cuts of {segments}", cuts.len());
                    assert!(cuts.is_sorted_by(|a, b| a < b) && cuts.iter().all(|x| *x > 0.0 && *x < 1.0));
                }
            }
        }
        assert!(cuts(7.0, 7.0, 1).is_empty(), "no taper, no cut");
    }

    #[test]
    fn segments_end_at_the_stations_and_at_the_radii_asked_for() {
        let blade = tapered();
        for dof in Dof::ALL {
            let found = segments(&blade, dof, &[1.5, 0.2, 1.0, 3.0]);
            let ends: Vec<(f64, f64)> = found.iter().map(|segment| (segment.from, segment.to)).collect();
            assert_eq!(ends, [(0.5, 1.0), (1.0, 1.5), (1.5, 2.0)], "{dof}");
        }
        // 40 to 10 is one cut, at 20: two thirds of the way.
        let [cut] = taper_cuts(&blade, Dof::Flap)[..] else { panic!("one cut") };
        assert!((cut - 5.0 / 3.0).abs() < 1e-15, "{cut}");
    }
}
