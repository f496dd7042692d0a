//! What acts at the points of the whole blade, one element after the other: long lists, so that fields of modes and
//! their energies are sums over them.

use super::assembly::starts;
use super::element::{Couplings, Element};
use crate::lagrange::Energy;
use crate::numerics::scalar::sqrt;
use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

/// Weights at all points.
#[derive(Clone, Debug)]
pub struct Along {
    /// Where the points of each element begin, and their number.
    starts: Vec<usize>,
    /// Quadrature weights [m].
    pub weight: Vec<f64>,
    /// Of K, C and M.
    couplings: [Couplings; 3],
    /// Of moments at the points.
    pub flexibility: Flexibility,
}

/// What makes of moments at points numbers whose squares sum to their energy in the inverse of the stiffness: two of
/// the bending moments, one of the torsional.
#[derive(Clone, Debug, Default)]
pub struct Flexibility {
    /// Of the moments of w and v in the first number.
    pub first: [Vec<f64>; 2],
    /// In the second.
    pub second: [Vec<f64>; 2],
    /// Of the torsional moment.
    pub torsional: Vec<f64>,
}

impl Flexibility {
    /// Adds the points of an element, with α times the stiffness and with that of trapeze at Ω² = s.
    pub fn push(&mut self, element: &Element, alpha: f64, s: f64) {
        let moves = [0, 1, 2].map(|dof| element.moves(dof));
        for (section, weight) in element.sections.iter().zip(&element.weight) {
            let root = sqrt(weight / alpha);
            let ((sin, cos), [first, second, torsional]) = (section.angle, section.stiffness);
            // Where one direction alone bends, its own stiffness counts.
            let [[a, b], [c, d]] = match (moves[0], moves[1]) {
                (true, true) => {
                    let (first, second) = (root / sqrt(first), root / sqrt(second));
                    [[cos * first, -sin * first], [sin * second, cos * second]]
                }
                (true, false) => [[root / sqrt(first * cos * cos + second * sin * sin), 0.0], [0.0; 2]],
                (false, true) => [[0.0, root / sqrt(first * sin * sin + second * cos * cos)], [0.0; 2]],
                (false, false) => [[0.0; 2]; 2],
            };
            self.first[0].push(a);
            self.first[1].push(b);
            self.second[0].push(c);
            self.second[1].push(d);
            let torsional = alpha * torsional + s * section.trapeze_stiffness();
            self.torsional.push(if moves[2] { sqrt(weight / torsional) } else { 0.0 });
        }
    }

    /// Adds the numbers of moments at all points to a list: three times as many.
    pub fn scale(&self, moments: &[Vec<f64>; 3], out: &mut Vec<f64>) {
        for [a, b] in [&self.first, &self.second] {
            let weights = a.iter().zip(b);
            out.extend(weights.zip(moments[0].iter().zip(&moments[1])).map(|((a, b), (w, v))| a * w + b * v));
        }
        out.extend(self.torsional.iter().zip(&moments[2]).map(|(a, m)| a * m));
    }
}

impl Along {
    /// Of these elements.
    pub fn new(elements: &[Rc<Element>]) -> Self {
        let starts = starts(elements.iter().map(|element| element.points()));
        let all = starts[elements.len()];
        let mut couplings: [Couplings; 3] = Default::default();
        let (mut weight, mut flexibility) = (vec![0.0; all], Flexibility::default());
        for (element, from) in elements.iter().zip(&starts) {
            for energy in [Energy::Elastic, Energy::Centrifugal, Energy::Inertia] {
                element.couplings(energy).scatter(*from, all, &mut couplings[energy as usize]);
            }
            weight[*from..from + element.points()].copy_from_slice(&element.weight);
            flexibility.push(element, 1.0, 0.0);
        }
        Self { starts, weight, couplings, flexibility }
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.weight.len()
    }

    /// The points of an element.
    pub fn part(&self, element: usize) -> Range<usize> {
        self.starts[element]..self.starts[element + 1]
    }

    /// The weights of one matrix.
    pub fn couplings(&self, energy: Energy) -> &Couplings {
        &self.couplings[energy as usize]
    }
}
