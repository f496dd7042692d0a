//! Elements and orders before anything is solved: from how fast a mode can turn.

use crate::blade::{Blade, Place, Section, Stretch, stretches};
use crate::dof::Dof;
use crate::functions::{Deformation, MOST_ORDER, Mesh};
use crate::lagrange::{Energy, Field, Quantity, segments, system, taper_cuts};
use crate::numerics::scalar::{ceil, pow, sqrt};
use alloc::vec::Vec;
use core::f64::consts::PI;

/// Largest phase of an element [rad]; longer ones are cheaper cut than given still higher orders.
const PHASE: f64 = 5.0;
/// From this phase of the fastest part on, only the ends of a stretch are resolved to it.
const LAYERED: f64 = 4.0 * PHASE;
/// Phase of an element that lies beyond the boundary layers but is as long as its distance to one.
const BESIDE: f64 = 2.5;
/// Most elements of a stretch; beyond it phases grow and the estimate tells how good the answer is.
const MOST_PARTS: usize = 400;
/// Most elements in all, but for one per stretch between stations: what a solve costs is
/// proportional to them.
const MOST_ELEMENTS: usize = 2000;
/// Most polynomials in all; a strain that needs more is not converged, and said to be so.
pub(super) const MOST_UNKNOWNS: usize = 30_000;
/// A layer thinner than this part of a stretch is beyond what numbers of 53 bits resolve there.
const THINNEST: f64 = 1e-9;
/// A stiffness that tapers by more over an element is not resolved: cuts that would part it fall together
/// in numbers of 53 bits, or would be too many. Two of the usual parts.
const STEEPEST: f64 = 6.25;
/// Part of a strain that the first orders may leave out; the eigenvalue's error is its square.
const TRUNCATION: f64 = 2e-5;

/// Where the elements are, and how many polynomials the strain of each has.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    /// Ends of the elements from root to tip [m], one more than elements.
    pub(super) radii: Vec<f64>,
    /// Polynomials per element.
    pub(super) orders: Vec<usize>,
    /// Whether the stiffness of no element tapers by more than [`STEEPEST`].
    pub(super) resolved: bool,
}

impl Layout {
    /// Polynomials in all.
    pub(super) fn unknowns(&self) -> usize {
        self.orders.iter().sum()
    }

    /// As a mesh of x from the root.
    pub(super) fn mesh(&self) -> Mesh {
        let root = self.radii.first().copied().unwrap_or(0.0);
        Mesh::new(self.radii.iter().map(|r| r - root).collect(), self.orders.clone())
    }
}

/// Where the elements of a stretch begin, from its inner end, and the phase that each is to follow.
///
/// Under high tension a mode is a string's, but for boundary layers at the ends of the stretch that
/// decay like e^(−fast·x): elements that double in length towards the middle follow both.
///
/// No more than `most` elements at an even length, and a layer of [`THINNEST`] at the thinnest.
pub(crate) fn cuts(length: f64, slow: f64, fast: f64, most: usize) -> Vec<(f64, f64)> {
    let fast = fast.min(PHASE / (THINNEST * length));
    let slow = slow.min(fast);
    if fast * length <= LAYERED || slow > 0.5 * fast {
        let parts = ceil(fast * length / PHASE).clamp(1.0, most as f64);
        let part = |i: usize| (length * (i as f64 / parts), fast * length / parts);
        return (0..most).take_while(|&i| (i as f64) < parts).map(part).collect();
    }
    let longest = (PHASE / slow).max(length / most as f64);
    let mut inner = Vec::new();
    let (mut x, mut step) = (0.0, PHASE / fast);
    while x + step < 0.5 * length {
        // Two elements see the layer; e^−15 of it is left beyond.
        inner.push((x, if inner.len() < 2 { PHASE } else { BESIDE.max(slow * step) }));
        x += step;
        step = (2.0 * step).min(longest);
    }
    let ends = inner.iter().skip(1).map(|cut| cut.0).chain([x]);
    let outer: Vec<(f64, f64)> = ends.zip(&inner).map(|(end, cut)| (length - end, cut.1)).collect();
    let middle = (x, BESIDE.max(slow * (length - 2.0 * x)));
    inner.into_iter().chain([middle]).chain(outer.into_iter().rev()).collect()
}

/// A stretch to become one or more elements.
pub(crate) struct Piece {
    pub(crate) from: f64,
    pub(crate) length: f64,
    /// Means of the elastic weight, the inertia and the centrifugal weight per Ω².
    pub(crate) elastic: f64,
    pub(crate) inertia: f64,
    pub(crate) centrifugal: f64,
    /// Largest over smallest stiffness.
    pub(crate) taper: f64,
}

/// A layout on which the `count` lowest modes at Ω² = `speed_squared` should be converged.
pub(super) fn first_layout(blade: &Blade, dof: Dof, speed_squared: f64, count: usize) -> Layout {
    let pieces = pieces(blade, dof);
    let bending = Deformation::of(dof) == Deformation::Bending;
    let highest = highest_eigenvalue(&pieces, bending, speed_squared, count);
    let resolved = pieces.iter().all(|piece| piece.taper <= STEEPEST);
    let mut layout = Layout { radii: Vec::new(), orders: Vec::new(), resolved };
    let most = (MOST_ELEMENTS / pieces.len()).clamp(1, MOST_PARTS);
    for piece in &pieces {
        let (slow, fast) = rates(piece, bending, speed_squared, highest);
        for (x, phase) in cuts(piece.length, slow, fast, most) {
            layout.radii.push(piece.from + x);
            layout.orders.push(order(phase, piece.taper));
        }
    }
    layout.radii.push(blade.radius());
    let highest = (MOST_UNKNOWNS / layout.orders.len()).max(2);
    for order in &mut layout.orders {
        *order = (*order).min(highest);
    }
    layout
}

/// Stretches with linear properties and little taper, root to tip.
fn pieces(blade: &Blade, dof: Dof) -> Vec<Piece> {
    let cut = segments(blade, dof, &taper_cuts(blade, dof));
    let places: Vec<Place> = cut.iter().map(|segment| Place::whole(segment.from, segment.to)).collect();
    let weight = |energy, quantity| system(blade, dof).weight(energy, Field { dof, quantity });
    let inertia = weight(Energy::Inertia, Quantity::Displacement);
    let elastic = weight(Energy::Elastic, Quantity::Strain);
    let centrifugal = weight(Energy::Centrifugal, Quantity::Rotation);
    let piece = |stretch: &Stretch| {
        let (from, to) = (stretch.from, stretch.to);
        let (inner, outer): (Section, Section) = (stretch.section(from), stretch.section(to));
        Piece {
            from,
            length: to - from,
            elastic: sqrt(elastic(&inner)) * sqrt(elastic(&outer)),
            inertia: 0.5 * (inertia(&inner) + inertia(&outer)),
            centrifugal: centrifugal(&stretch.section(0.5 * (from + to))),
            taper: elastic(&inner).max(elastic(&outer)) / elastic(&inner).min(elastic(&outer)),
        }
    };
    stretches(blade, &places).iter().map(piece).collect()
}

/// The rates [rad/m] at which a mode of eigenvalue λ oscillates and at which its fastest part turns.
///
/// Bending: EI k⁴ + Ω² T k² = λ m and EI κ⁴ − Ω² T κ² = λ m of the equation with constant
/// coefficients; torsion: GJ k² = λ ρI − Ω² m Y².
pub(crate) fn rates(piece: &Piece, bending: bool, speed_squared: f64, eigenvalue: f64) -> (f64, f64) {
    let (pull, load) = (speed_squared * piece.centrifugal / piece.elastic, eigenvalue * piece.inertia / piece.elastic);
    if bending {
        let root = sqrt(pull * pull + 4.0 * load);
        // (root − pull)/2 without its cancellation.
        let slow = if root > 0.0 { 2.0 * load / (root + pull) } else { 0.0 };
        (sqrt(slow), sqrt(0.5 * (root + pull)))
    } else {
        (sqrt((load - pull).max(0.0)), sqrt(load.max(pull)))
    }
}

/// A little above the eigenvalue of mode `count`: where the phase over the span reaches
/// (`count` + 1) π, as in the Wentzel–Kramers–Brillouin approximation.
fn highest_eigenvalue(pieces: &[Piece], bending: bool, speed_squared: f64, count: usize) -> f64 {
    let wanted = (count as f64 + 1.0) * PI;
    let phase = |eigenvalue: f64| -> f64 {
        pieces.iter().map(|piece| rates(piece, bending, speed_squared, eigenvalue).0 * piece.length).sum()
    };
    // Without pull the phase grows as λ^¼ or λ^½: from there by ever better guesses on a log scale.
    let power = if bending { 4.0 } else { 2.0 };
    let alone: f64 = pieces.iter().map(|piece| rates(piece, bending, 0.0, 1.0).0 * piece.length).sum();
    let mut low = pow(wanted / alone, power);
    if !low.is_finite() {
        return 0.0;
    }
    let mut high = low;
    let mut guard = 0;
    while phase(high) < wanted && guard < 200 {
        (low, high) = (high, 4.0 * high);
        guard += 1;
    }
    for _ in 0..6 {
        let middle = sqrt(low) * sqrt(high);
        if phase(middle) < wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// Polynomials for a strain that turns by `phase` over the element while the stiffness changes by
/// `taper`: coefficients of e^(±phase ξ/2) fall like (phase/4)ᵇ/b!, those of 1/(1 + aξ) like ϱ⁻ᵇ.
pub(crate) fn order(phase: f64, taper: f64) -> usize {
    let a = (taper - 1.0) / (taper + 1.0);
    let pole = if a > 0.0 { a / (1.0 + sqrt(1.0 - a * a)) } else { 0.0 };
    let (mut wave, mut tail) = (1.0, a);
    for b in 1..MOST_ORDER {
        wave *= 0.25 * phase / b as f64;
        tail *= pole;
        if wave + tail <= TRUNCATION {
            return b;
        }
    }
    MOST_ORDER
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::converged::tests::stepped;
    use crate::lagrange::tests::{INERTIA, MASS, RADIUS, STIFFNESS, clamped};

    /// However fast and however slow a mode turns: few elements, in order, each with a phase.
    #[test]
    fn elements_are_bounded_for_any_rates() {
        let rates = [0.0, 1e-300, 1e-3, 1.0, 17.0, 1e3, 1e9, 1e300, f64::INFINITY];
        for length in [1e-9, 0.3, 1.0, 1e6] {
            for slow in rates {
                for fast in rates {
                    for most in [1, 7, MOST_PARTS] {
                        let found = cuts(length, slow, fast, most);
                        // Elements that double from the thinnest layer to half the stretch are 29 to a side.
                        assert!(found.len() <= most + 2 * 30, "{length} {slow} {fast} {most}: {}", found.len());
                        assert_eq!(found[0].0, 0.0);
                        assert!(found.is_sorted_by(|a, b| a.0 < b.0), "{length} {slow} {fast} {most}");
                        assert!(found.iter().all(|(x, phase)| *x < length && *phase >= 0.0 && phase.is_finite()));
                    }
                }
            }
        }
    }

    /// The layers at both ends are as thin as the fast part asks, and the elements beyond double.
    #[test]
    fn boundary_layers_are_resolved_at_both_ends() {
        let (slow, fast) = (1.0, 1e4);
        let mut ends: Vec<f64> = cuts(1.0, slow, fast, MOST_PARTS).iter().map(|cut| cut.0).collect();
        ends.push(1.0);
        let lengths: Vec<f64> = ends.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let last = lengths.len() - 1;
        // Differences of radii up to 1.
        assert!((lengths[0] - PHASE / fast).abs() < 1e-15 && (lengths[last] - PHASE / fast).abs() < 1e-15);
        for (i, pair) in lengths[..last / 2].windows(2).enumerate() {
            assert!((pair[1] / pair[0] - 2.0).abs() < 1e-9, "{lengths:?}");
            assert!((lengths[i] - lengths[last - i]).abs() < 1e-12, "as the inner end so the outer");
        }
    }

    /// Wave and decay satisfy the equations with constant coefficients that they are the rates of. A
    /// difference of large numbers is left: of the sum of their sizes, rounded.
    #[test]
    fn rates_solve_their_equations() {
        let piece = Piece { from: 0.0, length: 1.0, elastic: 50.0, inertia: 2.0, centrifugal: 3.0, taper: 1.0 };
        for (square, eigenvalue) in [(0.0, 9.0), (225.0, 9.0), (1e6, 1e7), (4.0, 0.0)] {
            let (slow, fast) = rates(&piece, true, square, eigenvalue);
            let (k2, f2) = (slow * slow, fast * fast);
            let (pull, load) = (square * 3.0, eigenvalue * 2.0);
            assert!((50.0 * k2 * k2 + pull * k2 - load).abs() <= 1e-14 * load, "{square} {eigenvalue}");
            let size = 50.0 * f2 * f2 + pull * f2;
            assert!((50.0 * f2 * f2 - pull * f2 - load).abs() <= 1e-14 * size, "{square} {eigenvalue}");
            let (slow, fast) = rates(&piece, false, square, eigenvalue);
            let known = ((load - pull) / 50.0).max(0.0);
            assert!((slow * slow - known).abs() <= 1e-15 * (1.0 + known), "{slow}");
            assert!(fast >= slow && fast * fast * 50.0 <= load.max(pull) * (1.0 + 1e-15));
        }
    }

    /// (n + 1) π over the span: √(λ ρI/GJ) l in torsion, (λ m/EI)^¼ l in flap at rest. It stands above
    /// by 4^(1/64) at the most, where the first guess was a rounding too low.
    #[test]
    fn the_highest_eigenvalue_is_where_the_phase_reaches_the_next_mode() {
        let blade = clamped(0.5);
        let phase = 4.0 * PI / (RADIUS - 0.5);
        for (dof, known) in
            [(Dof::Flap, STIFFNESS[0] / MASS * phase.powi(4)), (Dof::Torsion, STIFFNESS[2] / INERTIA * phase.powi(2))]
        {
            let found = highest_eigenvalue(&pieces(&blade, dof), dof != Dof::Torsion, 0.0, 3);
            let ratio = found / known;
            assert!(ratio > 1.0 - 1e-13 && ratio < 1.03, "{dof}: {ratio}");
        }
    }

    #[test]
    fn orders_stay_within_their_limits() {
        for taper in [1.0, 1.5, 2.5, 1e9, 1e300, f64::INFINITY] {
            let orders: Vec<usize> = [0.0, 0.1, 1.0, PHASE, 1e2, 1e300, f64::INFINITY]
                .into_iter()
                .map(|phase| order(phase, taper))
                .collect();
            assert!(orders.iter().all(|order| (1..=MOST_ORDER).contains(order)), "{taper}: {orders:?}");
            assert!(orders.is_sorted(), "{taper}: a faster wave needs no fewer: {orders:?}");
        }
        assert_eq!(order(0.0, 1.0), 1, "a constant strain");
    }

    #[test]
    fn a_layout_goes_from_root_to_tip_over_every_station() {
        let blade = stepped();
        for dof in Dof::ALL {
            for speed in [0.0, 105.0, 1e4, 1e9] {
                for count in [1, 5, 50] {
                    let found = first_layout(&blade, dof, speed * speed, count);
                    assert_eq!(found.radii.len(), found.orders.len() + 1);
                    assert_eq!((found.radii[0], found.radii[found.radii.len() - 1]), (0.09, 0.962));
                    assert!(found.radii.is_sorted_by(|a, b| a < b), "{dof} at {speed}");
                    assert!(found.radii.contains(&0.2) && found.radii.contains(&0.3), "{dof} at {speed}");
                    assert!(found.orders.iter().all(|order| (1..=MOST_ORDER).contains(order)));
                    assert!(found.unknowns() <= MOST_UNKNOWNS, "{}", found.unknowns());
                    assert_eq!(found.mesh().count(), found.unknowns());
                }
            }
        }
    }
}
