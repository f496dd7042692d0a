//! Elements and orders before anything is solved: from how fast a mode can turn.

use crate::blade::{Blade, tension_inside};
use crate::dof::Dof;
use crate::functions::{MOST_ORDER, Mesh};
use crate::lagrange::segments;
use crate::numerics::scalar::{ceil, pow, sqrt};
use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::PI;

/// Largest phase of an element [rad]; longer ones are cheaper cut than given still higher orders.
const PHASE: f64 = 5.0;
/// Most elements; beyond it phases grow and the estimate tells how good the answer is.
const MOST_ELEMENTS: f64 = 4000.0;
/// Part of a strain that the first orders may leave out; the eigenvalue's error is its square.
const TRUNCATION: f64 = 2e-5;

/// Where the elements are, and how many polynomials the strain of each has.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    /// Ends of the elements from root to tip [m], one more than elements.
    pub(super) radii: Vec<f64>,
    /// Polynomials per element.
    pub(super) orders: Vec<usize>,
}

impl Layout {
    /// As a mesh of x from the root.
    pub(super) fn mesh(&self) -> Mesh {
        let root = self.radii.first().copied().unwrap_or(0.0);
        Mesh::new(self.radii.iter().map(|r| r - root).collect(), self.orders.clone())
    }
}

/// A stretch to become one or more elements.
struct Piece {
    from: f64,
    length: f64,
    /// Means of stiffness, inertia and pull per Ω².
    stiffness: f64,
    inertia: f64,
    pull: f64,
    /// Largest over smallest stiffness.
    taper: f64,
}

/// A layout on which the `count` lowest modes at Ω² = `speed_squared` should be converged.
pub(super) fn first_layout(blade: &Blade, dof: Dof, speed_squared: f64, count: usize) -> Layout {
    let pieces = pieces(blade, dof);
    let bending = dof != Dof::Torsion;
    let highest = highest_eigenvalue(&pieces, bending, speed_squared, count);
    let rates: Vec<f64> = pieces.iter().map(|piece| rates(piece, bending, speed_squared, highest).1).collect();
    let wanted: f64 = pieces.iter().zip(&rates).map(|(piece, rate)| ceil(rate * piece.length / PHASE).max(1.0)).sum();
    let coarser = (wanted / MOST_ELEMENTS).max(1.0);
    let mut layout = Layout { radii: Vec::new(), orders: Vec::new() };
    for (piece, rate) in pieces.iter().zip(rates) {
        let phase = rate * piece.length;
        let parts = ceil(phase / (PHASE * coarser)).max(1.0);
        let order = order(phase / parts, piece.taper);
        let mut i = 0.0;
        while i < parts {
            layout.radii.push(piece.from + piece.length * (i / parts));
            layout.orders.push(order);
            i += 1.0;
        }
    }
    layout.radii.push(blade.radius());
    layout
}

/// Stretches with linear properties and little taper, root to tip.
fn pieces(blade: &Blade, dof: Dof) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut outboard = 0.0;
    for segment in segments(blade, dof, &[]).iter().rev() {
        let stiffness = segment.linear(blade.stiffness(dof));
        let mass = segment.linear(blade.mass());
        let inertia = segment.linear(if dof == Dof::Torsion { blade.polar_inertia() } else { blade.mass() });
        let offset = segment.linear(blade.mass_offset());
        let mut ends = vec![segment.from];
        ends.extend(segment.taper_cuts(blade.stiffness(dof)));
        ends.push(segment.to);
        for ends in ends.windows(2).rev() {
            let (from, to) = (ends[0], ends[1]);
            let middle = 0.5 * (from + to);
            let pull = if dof == Dof::Torsion {
                mass.at(middle) * offset.at(middle) * offset.at(middle)
            } else {
                outboard + tension_inside(mass.at(middle), mass.at(to), middle, to)
            };
            let (inner, outer) = (stiffness.at(from), stiffness.at(to));
            pieces.push(Piece {
                from,
                length: to - from,
                stiffness: sqrt(inner) * sqrt(outer),
                inertia: 0.5 * (inertia.at(from) + inertia.at(to)),
                pull,
                taper: inner.max(outer) / inner.min(outer),
            });
            outboard += tension_inside(mass.at(from), mass.at(to), from, to);
        }
    }
    pieces.reverse();
    pieces
}

/// The rates [rad/m] at which a mode of eigenvalue λ oscillates and at which its fastest part turns.
///
/// Bending: EI k⁴ + Ω² T k² = λ m and EI κ⁴ − Ω² T κ² = λ m of the equation with constant
/// coefficients; torsion: GJ k² = λ ρI − Ω² m Y².
fn rates(piece: &Piece, bending: bool, speed_squared: f64, eigenvalue: f64) -> (f64, f64) {
    let (pull, load) = (speed_squared * piece.pull / piece.stiffness, eigenvalue * piece.inertia / piece.stiffness);
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
fn order(phase: f64, taper: f64) -> usize {
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
