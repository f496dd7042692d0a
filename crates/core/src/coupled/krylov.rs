//! The lowest modes by inverse iteration along the blade: a block of three vectors and all that the inverse
//! of K + F + sC + σM makes of it, orthonormal in M.

use super::assembly::{Assembly, Vector, sum};
use super::elimination::Factor;
use crate::numerics::scalar::{cos, sqrt};
use crate::numerics::vector::{axpy, long_dot, scale};
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::{DMatrix, SymmetricEigen};

/// What is left of a mode outside the vectors, as a share of it, below which the mode is settled: its
/// eigenvalue's error is about the square of that.
const SETTLED: f64 = 1e-9;
/// The same of modes that are there to tell where the others end.
const NEARLY_SETTLED: f64 = 1e-6;
/// A vector of which so little is left beside the others is nothing new.
const NOTHING_NEW: f64 = 1e-11;
/// Where less than this share of a vector is left beside the others, they are taken off once more.
const FULL: f64 = 0.7;
/// Most vectors, per mode sought and beside.
const MOST: (usize, usize) = (6, 40);
/// The modes are looked at once in so many vectors.
const EVERY: usize = 9;
/// Most steps of the library's eigensolver, per vector.
const STEPS: usize = 60;

/// Orthonormal functions with their loads M v.
#[derive(Clone, Debug, Default)]
pub struct Krylov {
    vectors: Vec<Vector>,
    loads: Vec<Vector>,
    /// Column by column: the vectors' parts of the inverse of each vector that was iterated.
    made: Vec<Vec<f64>>,
}

/// The `count` lowest modes and `beyond` more that are not as exact, or as many as there are, of unit inertia,
/// ascending, from the factor of the shifted form.
pub fn lowest(assembly: &Assembly, factor: &Factor, count: usize, beyond: usize) -> Option<Vec<Vector>> {
    let (wanted, count) = (count, count + beyond);
    let mut krylov = Krylov::default();
    let mut waiting: usize = 0;
    let most = (MOST.0 * count + MOST.1).min(assembly.unknowns());
    for state in [0, 2, 4] {
        let mut start = start(assembly, state);
        factor.solve(&assembly.elements, &mut start);
        krylov.push(assembly, start);
    }
    loop {
        if waiting >= krylov.vectors.len() {
            break;
        }
        let mut next = krylov.loads[waiting].clone();
        factor.solve(&assembly.elements, &mut next);
        waiting += 1;
        krylov.iterate(assembly, next, krylov.vectors.len() < most);
        let enough = waiting >= 2 * count;
        if (enough && (waiting - 2 * count).is_multiple_of(EVERY)) || waiting == krylov.vectors.len() {
            let (parts, settled) = krylov.ritz(wanted, count)?;
            if settled >= count || waiting == krylov.vectors.len() {
                return Some(parts.column_iter().map(|column| sum(&krylov.vectors, column.as_slice())).collect());
            }
        }
    }
    None
}

/// Loads on one displacement everywhere, uneven so that no mode is at right angles to them.
fn start(assembly: &Assembly, state: usize) -> Vector {
    let mut shape = vec![0.0; assembly.functions()];
    for (index, element) in assembly.elements.iter().enumerate() {
        let place = assembly.part(index).start + element.strains() + state;
        shape[place] = 1.0 + 0.4 * cos(2.399 * (index as f64 + 1.0));
    }
    assembly.inertia_times(&shape)
}

impl Krylov {
    /// Adds a vector, of which the parts along the others were taken off; those parts and its length.
    fn push(&mut self, assembly: &Assembly, mut vector: Vector) -> Vec<f64> {
        let mut parts = self.take_off(&mut vector);
        let mut loads = assembly.inertia_times(&vector);
        let mut length = sqrt(long_dot(&vector, &loads).max(0.0));
        let before = sqrt(parts.iter().map(|part| part * part).sum());
        // What is left has the rounding of what was taken off.
        if length < FULL * before {
            let again = self.take_off(&mut vector);
            parts.iter_mut().zip(again).for_each(|(part, more)| *part += more);
            loads = assembly.inertia_times(&vector);
            length = sqrt(long_dot(&vector, &loads).max(0.0));
        }
        if length > NOTHING_NEW * before && length > 0.0 {
            scale(&mut vector, 1.0 / length);
            scale(&mut loads, 1.0 / length);
            self.vectors.push(vector);
            self.loads.push(loads);
            parts.push(length);
        }
        parts
    }

    fn take_off(&self, vector: &mut Vector) -> Vec<f64> {
        let parts: Vec<f64> = self.loads.iter().map(|loads| long_dot(vector, loads)).collect();
        for (part, known) in parts.iter().zip(&self.vectors) {
            axpy(vector, -part, known);
        }
        parts
    }

    fn iterate(&mut self, assembly: &Assembly, next: Vector, grows: bool) {
        let parts = if grows {
            self.push(assembly, next)
        } else {
            self.loads.iter().map(|loads| long_dot(&next, loads)).collect()
        };
        self.made.push(parts);
    }

    /// The vectors of the largest 1/(λ + σ) among the iterated ones, descending, and how many of them settled,
    /// from the first.
    fn ritz(&self, wanted: usize, count: usize) -> Option<(DMatrix<f64>, usize)> {
        let n = self.made.len();
        let part = |i: usize, j: usize| self.made[j].get(i).copied().unwrap_or(0.0);
        let projected = DMatrix::from_fn(n, n, |i, j| 0.5 * (part(i, j) + part(j, i)));
        if projected.iter().any(|v| !v.is_finite()) {
            return None;
        }
        let eigen = SymmetricEigen::try_new(projected, f64::EPSILON, STEPS * n)?;
        let mut order: Vec<usize> = (0..n).filter(|i| eigen.eigenvalues[*i] > 0.0).collect();
        order.sort_by(|a, b| eigen.eigenvalues[*b].total_cmp(&eigen.eigenvalues[*a]));
        order.truncate(count);
        let is_settled = |&(place, &index): &(usize, &usize)| {
            let vector = eigen.eigenvectors.column(index);
            let left: f64 = (n..self.vectors.len())
                .map(|i| {
                    let outside: f64 = vector.iter().enumerate().map(|(j, s)| part(i, j) * s).sum();
                    outside * outside
                })
                .sum();
            let share = if place < wanted { SETTLED } else { NEARLY_SETTLED };
            sqrt(left) <= share * eigen.eigenvalues[index]
        };
        let settled = order.iter().enumerate().take_while(is_settled).count();
        Some((eigen.eigenvectors.select_columns(&order), settled))
    }
}
