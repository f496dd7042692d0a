//! Elimination of a Hermitian form along the blade, from the tip: how many negative directions it has.

use super::element::{Element, STATES, Square};
use super::elimination::Roots;
use alloc::rc::Rc;
use alloc::vec::Vec;

/// A Hermitian matrix: its symmetric real and its antisymmetric imaginary part.
#[derive(Clone, Debug)]
pub struct Hermitian {
    /// Real part.
    pub re: Square,
    /// Imaginary part.
    pub im: Square,
}

impl Hermitian {
    /// Takes out a row and column by the pivot on its diagonal: whether that is negative, or `None` where it is 0
    /// or no number.
    fn eliminate(&mut self, k: usize) -> Option<bool> {
        let pivot = self.re.at(k, k);
        if !(pivot.is_finite() && pivot != 0.0) {
            return None;
        }
        let n = self.re.order();
        for j in (0..n).filter(|j| *j != k) {
            let (re, im) = (self.re.at(k, j) / pivot, self.im.at(k, j) / pivot);
            if re == 0.0 && im == 0.0 {
                continue;
            }
            for i in (0..n).filter(|i| *i != k) {
                let (a, b) = (self.re.at(i, k), self.im.at(i, k));
                *self.re.at_mut(i, j) -= a * re - b * im;
                *self.im.at_mut(i, j) -= a * im + b * re;
            }
        }
        self.clear(k);
        Some(pivot < 0.0)
    }

    fn clear(&mut self, k: usize) {
        for i in 0..self.re.order() {
            for part in [&mut self.re, &mut self.im] {
                *part.at_mut(i, k) = 0.0;
                *part.at_mut(k, i) = 0.0;
            }
        }
    }
}

/// Number of negative directions of a form; springs are multiplied by `alpha`. `None` where a pivot is 0.
pub fn negative(elements: &[Rc<Element>], forms: Vec<Hermitian>, roots: &Roots, alpha: f64) -> Option<usize> {
    let mut negative = 0;
    let mut outboard = Hermitian { re: Square::zero(STATES), im: Square::zero(STATES) };
    for (index, (element, mut form)) in elements.iter().zip(forms).enumerate().rev() {
        form.re.add_outer(&element.transfer, |p, q| outboard.re.at(p, q));
        form.im.add_outer(&element.transfer, |p, q| outboard.im.at(p, q));
        let strains = element.strains();
        for k in 0..strains {
            negative += usize::from(form.eliminate(k)?);
        }
        for p in 0..STATES {
            for q in 0..STATES {
                *outboard.re.at_mut(p, q) = form.re.at(strains + p, strains + q);
                *outboard.im.at_mut(p, q) = form.im.at(strains + p, strains + q);
            }
        }
        roots.held(index).iter().for_each(|held| outboard.clear(*held));
        let free = roots.free(index);
        for &p in free {
            for &q in free {
                *outboard.re.at_mut(p, q) += alpha * roots.spring(p, q);
            }
        }
        for &state in free {
            negative += usize::from(outboard.eliminate(state)?);
        }
    }
    Some(negative)
}
