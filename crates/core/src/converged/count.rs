//! How many eigenvalues lie below a number, counted without solving for any.
//!
//! By Sylvester's law of inertia as many eigenvalues of K + Ω² C − λ M lie below 0 as elimination
//! meets negative pivots. Elimination runs along the blade from the tip: on each element the strain
//! coefficients go, and what is left is a form in the state at its inner end, displacement and
//! rotation. It knows nothing of the iteration that finds the modes, so it tells where that has
//! missed one, as between heavy blocks on a soft blade.

use super::elements::{Elements, Local};
use crate::blade::RootCondition;
use crate::functions::Deformation;
use crate::numerics::vector::dot;
use alloc::vec;
use alloc::vec::Vec;

/// A pivot that keeps less than this of the numbers it is the difference of has no certain sign.
const CERTAIN: f64 = 1e-12;

/// The number of eigenvalues below `eigenvalue` [rad²/s²] at Ω² = `speed_squared` among all sums of the
/// piecewise functions; `None` where a pivot is too near to 0 to have a sign.
pub(super) fn below(elements: &Elements, eigenvalue: f64, speed_squared: f64) -> Option<usize> {
    let grid = elements.grid();
    let states = match grid.deformation() {
        Deformation::Bending => 2,
        Deformation::Torsion => 1,
    };
    // Without the centrifugal terms on displacements every eigenvalue is higher by the shift.
    let eigenvalue = eigenvalue + grid.system().shift(speed_squared);
    let mut outboard = Form::zero(states);
    let mut count = 0;
    let locals = elements.locals();
    let ones = vec![1.0; locals.iter().map(|element| element.weight.len()).max().unwrap_or(0)];
    for element in locals.iter().rev() {
        // The first state is the displacement.
        outboard.add(0, 0, -eigenvalue * element.lump);
        let displacements = displacements(element, states, &ones);
        let mut form = form(element, &displacements, eigenvalue, speed_squared);
        form.add_outboard(&outboard, &transfer(element, states));
        let (negative, inboard) = form.eliminated(states)?;
        count += negative;
        outboard = inboard;
    }
    // At the root the displacement is 0, and the rotation free or held. The last state is the rotation.
    let held = match grid.condition() {
        RootCondition::Clamped => return Some(count),
        RootCondition::Free => 0.0,
        RootCondition::Spring(spring) => spring,
    };
    let last = states - 1;
    let (pivot, size) = (outboard.at(last, last) + held, outboard.size[last] + held);
    (pivot.abs() > CERTAIN * size).then_some(count + usize::from(pivot < 0.0))
}

/// Displacements at the points of an element, of its polynomials and then of its states, each by a factor.
fn displacements<'a>(element: &Local<'a>, states: usize, ones: &'a [f64]) -> Vec<(&'a [f64], f64)> {
    let (order, half, table) = (element.coupling.len(), element.half, element.table);
    let polynomial = |j| match states {
        1 => (table.first(j), half),
        _ => (table.second(j), half * half),
    };
    let mut rows: Vec<_> = (0..order).map(polynomial).collect();
    rows.push((&ones[..element.weight.len()], 1.0));
    if states > 1 {
        // The lever of a rotation about the inner end.
        rows.push((table.first(0), half));
    }
    rows
}

/// K + Ω² C − λ M of one element: its polynomials, then its states, the rotation last.
fn form(element: &Local, displacements: &[(&[f64], f64)], eigenvalue: f64, speed_squared: f64) -> Form {
    let (order, n) = (element.coupling.len(), displacements.len());
    let mut form = Form::zero(n);
    for j in 0..order {
        for i in j..order {
            if i < j + 2 {
                form.add(i, j, element.elastic[j * order + i]);
            }
            form.add(i, j, speed_squared * element.centrifugal[j * order + i]);
        }
        form.add(n - 1, j, speed_squared * element.coupling[j]);
    }
    form.add(n - 1, n - 1, speed_squared * element.own);
    let masses: Vec<f64> = element.weight.iter().zip(element.inertia).map(|(w, m)| w * m).collect();
    let mut load = masses.clone();
    for (j, (own, factor)) in displacements.iter().enumerate() {
        load.iter_mut().zip(&masses).zip(*own).for_each(|((load, m), u)| *load = m * u);
        for (i, (other, by)) in displacements.iter().enumerate().skip(j) {
            form.add(i, j, -eigenvalue * factor * by * dot(&load, other));
        }
    }
    form
}

/// The states at the outer end as sums of the polynomials and of the states at the inner one.
fn transfer(element: &Local, states: usize) -> Vec<Vec<f64>> {
    let (order, length) = (element.coupling.len(), 2.0 * element.half);
    let n = order + states;
    let mut rotation = vec![0.0; n];
    (rotation[0], rotation[n - 1]) = (length, 1.0);
    if states == 1 {
        return vec![rotation];
    }
    // J₀(1) = 2, J₁(1) = −2/3.
    let mut displacement = vec![0.0; n];
    displacement[0] = 0.5 * length * length;
    if order > 1 {
        displacement[1] = -length * length / 6.0;
    }
    (displacement[n - 2], displacement[n - 1]) = (1.0, length);
    vec![displacement, rotation]
}

/// A symmetric form, with the sizes of the numbers that each diagonal entry is the sum of.
#[derive(Clone, Debug)]
struct Form {
    n: usize,
    entries: Vec<f64>,
    size: Vec<f64>,
}

impl Form {
    fn zero(n: usize) -> Self {
        Self { n, entries: vec![0.0; n * n], size: vec![0.0; n] }
    }

    fn at(&self, i: usize, j: usize) -> f64 {
        self.entries[j * self.n + i]
    }

    /// Adds to the entry (i, j), i ≥ j; only this half is kept.
    fn add(&mut self, i: usize, j: usize, value: f64) {
        self.entries[j * self.n + i] += value;
        if i == j {
            self.size[i] += value.abs();
        }
    }

    /// Adds a form of the states at the outer end, which are `transfer` (states × n, by rows) times
    /// the unknowns here.
    fn add_outboard(&mut self, outboard: &Self, transfer: &[Vec<f64>]) {
        for (k, from) in transfer.iter().enumerate() {
            for (l, to) in transfer.iter().enumerate() {
                let entry = outboard.at(k.max(l), k.min(l));
                for (j, factor) in to.iter().enumerate().filter(|(_, factor)| **factor != 0.0) {
                    for (i, other) in from.iter().enumerate().skip(j) {
                        self.entries[j * self.n + i] += entry * other * factor;
                    }
                }
            }
            for (size, factor) in self.size.iter_mut().zip(from) {
                *size += outboard.size[k] * factor * factor;
            }
        }
    }

    /// Eliminates all unknowns but the last `states`: the number of negative pivots, and the form
    /// that is left.
    fn eliminated(mut self, states: usize) -> Option<(usize, Self)> {
        let n = self.n;
        let mut negative = 0;
        for k in 0..n - states {
            let pivot = self.at(k, k);
            // What is not a number has no sign either.
            if pivot.is_nan() || pivot.abs() <= CERTAIN * self.size[k] {
                return None;
            }
            negative += usize::from(pivot < 0.0);
            for j in k + 1..n {
                let factor = self.at(j, k) / pivot;
                for i in j..n {
                    self.entries[j * n + i] -= self.at(i, k) * factor;
                }
                self.size[j] += (self.at(j, k) * factor).abs();
            }
        }
        let first = n - states;
        let mut left = Self::zero(states);
        for j in 0..states {
            for i in j..states {
                left.entries[j * states + i] = self.at(first + i, first + j);
            }
            left.size[j] = self.size[first + j];
        }
        Some((negative, left))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::converged::tests::{converged, laden, stepped};
    use crate::dof::Dof;

    /// Between each two of the eigenvalues that the iteration found there are as many as it says.
    #[test]
    fn eigenvalues_are_counted_without_being_solved_for() {
        let blades = [stepped(), laden()];
        for (blade, dof) in blades.iter().flat_map(|blade| Dof::ALL.map(|dof| (blade, dof))) {
            for speed in [0.0, 105.0] {
                let square = speed * speed;
                let found = converged(blade, dof, square, 6);
                let values: Vec<f64> =
                    crate::modes::solve(found.matrices(), square, 6).unwrap().iter().map(|m| m.eigenvalue).collect();
                for (count, pair) in (1..).zip(values.windows(2)) {
                    for share in [1e-6, 0.5, 1.0 - 1e-6] {
                        let between = pair[0] + share * (pair[1] - pair[0]);
                        assert_eq!(found.count_below(between, square), Some(count), "{dof} at {speed}, {between}");
                    }
                }
            }
        }
    }
}
