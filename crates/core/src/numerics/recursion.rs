//! Symmetric systems along a blade, by elimination from the tip inward.
//!
//! Unknowns stand on elements in a row; K states p run along it, all 0 at the inner end of the first
//! element. Over an element each state changes by one of its unknowns times a reach, and the
//! element's energy is ½ cᵀ Q c + pᵀ aᵀ c + ½ pᵀ α p with p at its inner end. The matrix of such a system
//! over all unknowns is full, but elimination from the last element inward leaves K × K numbers per
//! element: it costs as much as a banded matrix. Because the unknowns are relative to the inner
//! neighbour, an element that is very short or very stiff costs no digits, unlike in a system for
//! absolute positions (docs/THEORY.md).
//!
//! States are rotations and twists, which is what the centrifugal terms act on: one in an uncoupled
//! system.

use super::scalar::sqrt;
use alloc::vec;
use alloc::vec::Vec;

/// The energy of one element.
#[derive(Clone, Copy, Debug)]
pub struct Link<'a, const K: usize> {
    /// Q, n × n, by columns; the lower triangle is used.
    pub matrix: &'a [f64],
    /// a, n × K, by columns: the unknowns with each state.
    pub coupling: [&'a [f64]; K],
    /// α, by rows.
    pub own: [[f64; K]; K],
    /// The unknown that changes each state over the element, and the change per unit of it.
    pub reach: [(usize, f64); K],
}

/// The Cholesky factor of such a system.
#[derive(Clone, Debug)]
pub struct Recursion<const K: usize> {
    links: Vec<Factor<K>>,
    /// Per element L with Q = L Lᵀ, by columns, the diagonal inverted.
    factors: Vec<f64>,
    /// Per element L⁻¹ a by columns, where a couples its unknowns to the states at its inner end.
    couplings: Vec<f64>,
}

#[derive(Clone, Copy, Debug)]
struct Factor<const K: usize> {
    count: usize,
    first: usize,
    matrix: usize,
    reach: [(usize, f64); K],
}

impl<const K: usize> Recursion<K> {
    /// Factors a system given from its last element to its first; `None` where it is not positive
    /// definite (or not a number).
    pub fn factor<'a>(links_inward: impl Iterator<Item = Link<'a, K>>) -> Option<Self> {
        let mut found = Self { links: Vec::new(), factors: Vec::new(), couplings: Vec::new() };
        let mut outboard = [[0.0; K]; K];
        for link in links_inward {
            let n = link.coupling.first().map_or(0, |column| column.len());
            let (first, matrix) = (found.couplings.len(), found.factors.len());
            found.factors.extend_from_slice(&link.matrix[..n * n]);
            for column in link.coupling {
                found.couplings.extend_from_slice(column);
            }
            let (q, z) = (&mut found.factors[matrix..], &mut found.couplings[first..]);
            for (row, (i, reach)) in outboard.iter().zip(link.reach) {
                for (k, (s, (j, other))) in row.iter().zip(link.reach).enumerate() {
                    // What unknown i loads on state k outboard.
                    let load = s * reach;
                    z[k * n + i] += load;
                    if i >= j {
                        q[j * n + i] += load * other;
                    }
                }
            }
            if !cholesky(q, n) {
                return None;
            }
            for column in z.chunks_exact_mut(n) {
                forward(q, column);
            }
            let mut next = outboard;
            for (i, row) in next.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    let taken: f64 = z[i * n..(i + 1) * n].iter().zip(&z[j * n..(j + 1) * n]).map(|(a, b)| a * b).sum();
                    *entry = *entry + link.own[i][j] - taken;
                }
                // Never below 0: a sum of squares less what the element's own motion takes off it.
                if row[i] < 0.0 {
                    row[i] = 0.0;
                }
            }
            outboard = next;
            found.links.push(Factor { count: n, first, matrix, reach: link.reach });
        }
        Some(found)
    }

    /// Solves for one load on the unknowns, `load` (first element first, overwritten by the
    /// solution), and on the states at the inner end of each element, `on_state`.
    pub fn solve(&self, load: &mut [f64], on_state: &[[f64; K]]) {
        let mut carried = [0.0; K];
        let mut end = load.len();
        for (link, own) in self.links.iter().zip(on_state.iter().rev()) {
            let n = link.count;
            let f = &mut load[end - n..end];
            end -= n;
            for (carried, (i, reach)) in carried.iter().zip(link.reach) {
                f[i] += carried * reach;
            }
            forward(&self.factors[link.matrix..link.matrix + n * n], f);
            let z = self.couplings[link.first..link.first + K * n].chunks_exact(n);
            for ((carried, own), z) in carried.iter_mut().zip(own).zip(z) {
                *carried += own - z.iter().zip(f.iter()).map(|(z, f)| z * f).sum::<f64>();
            }
        }
        let (mut state, mut start) = ([0.0; K], 0);
        for link in self.links.iter().rev() {
            let n = link.count;
            let f = &mut load[start..start + n];
            start += n;
            let z = self.couplings[link.first..link.first + K * n].chunks_exact(n);
            for (state, z) in state.iter().zip(z) {
                f.iter_mut().zip(z).for_each(|(f, z)| *f -= z * state);
            }
            backward(&self.factors[link.matrix..link.matrix + n * n], f);
            for (state, (i, reach)) in state.iter_mut().zip(link.reach) {
                *state += reach * f[i];
            }
        }
    }
}
/// Overwrites the lower triangle by its Cholesky factor, the diagonal by its inverse.
fn cholesky(q: &mut [f64], n: usize) -> bool {
    let mut column = vec![0.0; n];
    for j in 0..n {
        let pivot = q[j * n + j];
        if !(pivot > 0.0 && pivot.is_finite()) {
            return false;
        }
        let inverse = 1.0 / sqrt(pivot);
        q[j * n + j] = inverse;
        for i in j + 1..n {
            q[j * n + i] *= inverse;
        }
        column[j + 1..].copy_from_slice(&q[j * n + j + 1..(j + 1) * n]);
        for k in j + 1..n {
            let factor = column[k];
            q[k * n + k..(k + 1) * n].iter_mut().zip(&column[k..]).for_each(|(q, c)| *q -= factor * c);
        }
    }
    true
}

/// f := L⁻¹ f.
fn forward(l: &[f64], f: &mut [f64]) {
    let n = f.len();
    for j in 0..n {
        let value = f[j] * l[j * n + j];
        f[j] = value;
        f[j + 1..].iter_mut().zip(&l[j * n + j + 1..]).for_each(|(f, l)| *f -= l * value);
    }
}

/// f := L⁻ᵀ f.
fn backward(l: &[f64], f: &mut [f64]) {
    let n = f.len();
    for j in (0..n).rev() {
        let sum: f64 = l[j * n + j + 1..(j + 1) * n].iter().zip(&f[j + 1..]).map(|(l, f)| l * f).sum();
        f[j] = (f[j] - sum) * l[j * n + j];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    /// The same system written out in full: matrix, and the states at the inner ends as rows.
    fn full<const K: usize>(links: &[Link<K>]) -> (DMatrix<f64>, DMatrix<f64>) {
        let counts: Vec<usize> = links.iter().map(|link| link.coupling[0].len()).collect();
        let n: usize = counts.iter().sum();
        let (mut matrix, mut states) = (DMatrix::zeros(n, n), DMatrix::zeros(K * links.len(), n));
        let mut first = 0;
        for (e, (link, &count)) in links.iter().zip(&counts).enumerate() {
            for k in 0..K {
                let mut start = 0;
                for (inner, &count) in links[..e].iter().zip(&counts) {
                    let (i, reach) = inner.reach[k];
                    states[(K * e + k, start + i)] += reach;
                    start += count;
                }
            }
            let p = states.rows(K * e, K).into_owned();
            let own = DMatrix::from_fn(K, K, |i, j| link.own[i][j]);
            matrix += p.transpose() * own * &p;
            let mut unit = DMatrix::zeros(count, n);
            for i in 0..count {
                unit[(i, first + i)] = 1.0;
            }
            let lower = |i: usize, j: usize| link.matrix[i.min(j) * count + i.max(j)];
            matrix += unit.transpose() * DMatrix::from_fn(count, count, lower) * &unit;
            let coupling = DMatrix::from_fn(count, K, |i, k| link.coupling[k][i]);
            let cross = unit.transpose() * coupling * &p;
            matrix += &cross + cross.transpose();
            first += count;
        }
        (matrix, states)
    }

    fn is_solved<const K: usize>(links: &[Link<K>], on_state: &[[f64; K]]) {
        let (matrix, states) = full(links);
        let mut load: Vec<f64> = (0..matrix.nrows()).map(|i| 1.0 - 0.7 * (i % 4) as f64).collect();
        let own: Vec<f64> = on_state.iter().flatten().copied().collect();
        let right = DVector::from_vec(load.clone()) + states.transpose() * DVector::from_vec(own);
        let expected = matrix.lu().solve(&right).unwrap();
        Recursion::factor(links.iter().rev().copied()).unwrap().solve(&mut load, on_state);
        for (found, expected) in load.iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-13, "{found} {expected}");
        }
    }

    const MATRICES: [&[f64]; 3] =
        [&[4.0, 1.0, 1.0, 3.0], &[3.5, 0.2, 0.2, 2.0], &[2.0, 0.1, 0.2, 0.1, 1.0, 0.3, 0.2, 0.3, 5.0]];
    const FIRST: [&[f64]; 3] = [&[0.2, -0.1], &[0.3, 0.0], &[0.1, 0.4, -0.2]];
    const SECOND: [&[f64]; 3] = [&[0.1, 0.2], &[-0.2, 0.1], &[0.0, 0.1, 0.3]];

    #[test]
    fn elements_with_one_state_are_solved() {
        let own = [0.7, 0.5, 0.9];
        let reach = [2.0, 0.01, 0.5];
        let link =
            |e: usize| Link { matrix: MATRICES[e], coupling: [FIRST[e]], own: [[own[e]]], reach: [(0, reach[e])] };
        is_solved(&[link(0), link(1), link(2)], &[[0.3], [-0.4], [1.1]]);
    }

    /// Two states that feel one another and are changed by different unknowns.
    #[test]
    fn elements_with_two_states_are_solved() {
        let link = |e: usize| Link {
            matrix: MATRICES[e],
            coupling: [FIRST[e], SECOND[e]],
            own: [[0.7, 0.1], [0.1, 0.6]],
            reach: [(0, 0.8), (1, -1.5)],
        };
        is_solved(&[link(0), link(1), link(2)], &[[0.3, 0.1], [-0.4, 0.2], [1.1, -0.5]]);
    }

    #[test]
    fn an_indefinite_system_is_refused() {
        let link = Link { matrix: &[-1.0], coupling: [&[0.0]], own: [[0.0]], reach: [(0, 1.0)] };
        assert!(Recursion::factor([link].into_iter()).is_none());
        let link = Link { matrix: &[f64::NAN], ..link };
        assert!(Recursion::factor([link].into_iter()).is_none());
    }
}
