//! Where to integrate: panels that respect every station and every wave of the functions.

use crate::blade::Blade;
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

/// The segments of a degree of freedom from its root to the tip, inner first; `extra` radii split
/// segments too.
pub(crate) fn segments(blade: &Blade, dof: Dof, extra: &[f64]) -> Vec<Segment> {
    let (root, radius) = (blade.root(dof).offset, blade.radius());
    let properties: &[&PiecewiseLinear] = match dof {
        Dof::Flap | Dof::Lag => &[blade.mass(), blade.stiffness(dof)],
        Dof::Torsion => &[blade.mass(), blade.stiffness(dof), blade.polar_inertia(), blade.mass_offset()],
    };
    let mut ends: Vec<f64> = properties
        .iter()
        .flat_map(|property| property.stations())
        .chain(extra)
        .copied()
        .filter(|&r| r > root && r < radius)
        .collect();
    ends.push(root);
    ends.push(radius);
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    ends.windows(2).map(|pair| Segment { from: pair[0], to: pair[1] }).collect()
}
