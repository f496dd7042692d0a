//! Elements and orders of a coupled blade, before anything is solved: from how fast a mode can turn.

use super::blade::{CoupledBlade, CoupledStretch};
use crate::converged::{Piece, cuts, order, rates};
use crate::numerics::scalar::{ceil, ln, pow, sqrt};
use alloc::vec::Vec;
use core::f64::consts::PI;

/// Largest change of the local angle over an element [rad]: its cosine is to be nearly a polynomial.
const TURN: f64 = 0.5;
/// Largest ratio of a stiffness at the ends of an element.
const TAPER: f64 = 2.5;
/// Most elements in all, but for one per stretch between stations.
const MOST_ELEMENTS: usize = 2000;
/// Fewest and most polynomials of a strain.
const ORDERS: (usize, usize) = (4, MOST_ORDER);
/// Most polynomials of a strain.
pub const MOST_ORDER: usize = 18;
/// Polynomials beyond those that follow the taper alone.
const MORE_TAPER: usize = 2;
/// By how many an order is raised.
const RAISE: usize = 3;
/// Eigenvalues tried for the highest mode, a factor of ten to each side of f64's useful range.
const EIGENVALUES: (f64, f64) = (1e-60, 1e60);

/// Where the elements are, and how many polynomials each strain has.
#[derive(Clone, Debug)]
pub struct Layout {
    /// Ends of the elements from the innermost root to the tip [m].
    pub radii: Vec<f64>,
    /// Polynomials of w″, v″ and φ′.
    pub orders: Vec<[usize; 3]>,
    /// About the eigenvalue of the highest mode [rad²/s²].
    pub highest: f64,
}

impl Layout {
    /// The same elements with so many polynomials at most.
    pub fn with_orders_up_to(&self, most: usize) -> Self {
        let orders = self.orders.iter().map(|orders| orders.map(|order| order.min(most))).collect();
        Self { orders, ..self.clone() }
    }
}

/// One stretch as bending of the softer and of the stiffer kind, and torsion.
struct Families {
    pieces: [Piece; 3],
    /// Elements that twist and taper ask for.
    parts: f64,
}

impl Families {
    fn new(stretch: &CoupledStretch) -> Self {
        let (from, to) = (stretch.from, stretch.to);
        let (inner, outer, middle) = (stretch.section(from), stretch.section(to), stretch.section(0.5 * (from + to)));
        let ratio = |i: usize| {
            let (a, b) = (inner.stiffness[i], outer.stiffness[i]);
            a.max(b) / a.min(b)
        };
        let taper = ratio(0).max(ratio(1)).max(ratio(2));
        let parts = ceil(stretch.turn() / TURN).max(ceil(ln(taper) / ln(TAPER))).max(1.0);
        let piece = |elastic: f64, inertia: f64, centrifugal: f64| Piece {
            from,
            length: to - from,
            elastic,
            inertia,
            centrifugal,
            taper: pow(taper, 1.0 / parts),
        };
        let [first, second, torsional] = middle.stiffness;
        Self {
            pieces: [
                piece(first.min(second), middle.mass, middle.tension),
                piece(first.max(second), middle.mass, middle.tension),
                piece(torsional, middle.inertia[0] + middle.inertia[1], 0.0),
            ],
            parts,
        }
    }

    /// By how much each kind turns over the stretch at an eigenvalue λ, and its fastest part [rad/m].
    fn rates(&self, s: f64, eigenvalue: f64) -> [(f64, f64); 3] {
        [0, 1, 2].map(|kind| rates(&self.pieces[kind], kind < 2, s, eigenvalue))
    }
}

/// A layout on which the `count` lowest modes at Ω² = s should be converged.
pub fn first_layout(blade: &CoupledBlade, s: f64, count: usize) -> Layout {
    let stretches: Vec<Families> = blade.stretches(&blade.stations()).iter().map(Families::new).collect();
    let eigenvalue = highest_eigenvalue(&stretches, s, count);
    let most = (MOST_ELEMENTS / stretches.len()).max(1);
    let mut layout = Layout { radii: Vec::new(), orders: Vec::new(), highest: eigenvalue };
    for families in &stretches {
        let [soft, _, torsion] = families.rates(s, eigenvalue);
        let (slow, fast) = (soft.0.max(torsion.0), soft.1.max(torsion.1));
        let piece = &families.pieces[0];
        let mut found = cuts(piece.length, slow, fast, most);
        if (found.len() as f64) < families.parts {
            let parts = families.parts.min(most as f64);
            let part = |i: usize| (piece.length * (i as f64 / parts), fast * piece.length / parts);
            found = (0..most).take_while(|&i| (i as f64) < parts).map(part).collect();
        }
        for (x, phase) in found {
            layout.radii.push(piece.from + x);
            let share = if fast > 0.0 { (torsion.1 / fast).min(1.0) } else { 1.0 };
            // The modes follow the taper of the stiffness beside their waves, to the square root of the tolerance.
            let tapered = order(0.0, piece.taper) + MORE_TAPER;
            let [bent, twisted] =
                [phase, phase * share].map(|phase| order(phase, piece.taper).max(tapered).clamp(ORDERS.0, ORDERS.1));
            layout.orders.push([bent, bent, twisted]);
        }
    }
    layout.radii.push(blade.radius);
    layout
}

/// Where the phases of all kinds of motion over the span reach those of two modes more.
fn highest_eigenvalue(stretches: &[Families], s: f64, count: usize) -> f64 {
    let wanted = (count as f64 + 2.0) * PI;
    let phase = |eigenvalue: f64| -> f64 {
        let each = |families: &Families| -> f64 {
            families.rates(s, eigenvalue).iter().map(|rates| rates.0).sum::<f64>() * families.pieces[0].length
        };
        stretches.iter().map(each).sum()
    };
    let (mut low, mut high) = EIGENVALUES;
    while high > 1.2 * low {
        let middle = sqrt(low) * sqrt(high);
        if phase(middle) < wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// Raises the orders of the elements whose share in the error is above the tolerance; whether any could be.
pub fn raise(layout: &mut Layout, shares: &[f64], tolerance: f64) -> bool {
    let mut raised = false;
    for (orders, share) in layout.orders.iter_mut().zip(shares) {
        if share.is_nan() || *share > tolerance {
            for order in orders.iter_mut().filter(|order| **order < ORDERS.1) {
                *order = (*order + RAISE).min(ORDERS.1);
                raised = true;
            }
        }
    }
    raised
}
