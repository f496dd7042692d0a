//! Symmetric positive definite systems with the structure of a chain, by Cholesky's method.
//!
//! Unknowns stand on the links of a chain; one state p runs along it, 0 at the inner end of the
//! first link, and each link adds its first unknown times its reach: p_out = p_in + reach · c₀. The
//! energy of link e is ½ cᵀ A c + p aᵀ c + ½ α p² with p at its inner end. The matrix of such a
//! system over all unknowns is full, but elimination from the last link inward leaves one number
//! per link: it costs as much as a banded matrix. Because the unknowns are relative to the inner
//! neighbour, a link that is very short or very stiff costs no digits, unlike in a system for
//! absolute positions (docs/THEORY.md).

use super::scalar::sqrt;
use alloc::vec;
use alloc::vec::Vec;

/// The energy of one link.
#[derive(Clone, Copy, Debug)]
pub struct Link<'a> {
    /// A, n × n, by columns; the lower triangle is used.
    pub matrix: &'a [f64],
    /// a, n long.
    pub coupling: &'a [f64],
    /// α.
    pub own: f64,
    /// Change of p over the link per unit of its first unknown.
    pub reach: f64,
}

/// The Cholesky factor of a chain.
#[derive(Clone, Debug, Default)]
pub struct Chain {
    links: Vec<Factor>,
    /// Per link L with Q = L Lᵀ, by columns, the diagonal inverted.
    factors: Vec<f64>,
    /// Per link L⁻¹ q, where q couples its unknowns to p at its inner end.
    couplings: Vec<f64>,
}

#[derive(Clone, Copy, Debug)]
struct Factor {
    count: usize,
    first: usize,
    matrix: usize,
    reach: f64,
}

impl Chain {
    /// Factors a chain given from its last link to its first; `None` where it is not positive
    /// definite (or not a number).
    pub fn factor<'a>(links_inward: impl Iterator<Item = Link<'a>>) -> Option<Self> {
        let mut chain = Self::default();
        let mut outboard = 0.0;
        for link in links_inward {
            let n = link.coupling.len();
            let (first, matrix) = (chain.couplings.len(), chain.factors.len());
            chain.factors.extend_from_slice(&link.matrix[..n * n]);
            chain.couplings.extend_from_slice(link.coupling);
            let (q, z) = (&mut chain.factors[matrix..], &mut chain.couplings[first..]);
            q[0] += outboard * link.reach * link.reach;
            z[0] += outboard * link.reach;
            if !cholesky(q, n) {
                return None;
            }
            forward(q, z);
            let taken: f64 = z.iter().map(|v| v * v).sum();
            // Never below 0: a sum of squares less what the link's own motion takes off it.
            outboard = (outboard + link.own - taken).max(0.0);
            chain.links.push(Factor { count: n, first, matrix, reach: link.reach });
        }
        Some(chain)
    }

    /// Solves for one load on the unknowns, `load` (first link first, overwritten by the solution),
    /// and on p at the inner end of each link, `on_state`.
    pub fn solve(&self, load: &mut [f64], on_state: &[f64]) {
        let mut carried = 0.0;
        let mut end = load.len();
        for (link, own) in self.links.iter().zip(on_state.iter().rev()) {
            let f = &mut load[end - link.count..end];
            end -= link.count;
            f[0] += carried * link.reach;
            forward(&self.factors[link.matrix..link.matrix + link.count * link.count], f);
            let z = &self.couplings[link.first..link.first + link.count];
            carried += own - z.iter().zip(f.iter()).map(|(z, f)| z * f).sum::<f64>();
        }
        let (mut state, mut start) = (0.0, 0);
        for link in self.links.iter().rev() {
            let f = &mut load[start..start + link.count];
            start += link.count;
            let z = &self.couplings[link.first..link.first + link.count];
            f.iter_mut().zip(z).for_each(|(f, z)| *f -= z * state);
            backward(&self.factors[link.matrix..link.matrix + link.count * link.count], f);
            state += link.reach * f[0];
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

    /// Against the same system written out in full.
    #[test]
    fn a_chain_of_unlike_links_is_solved() {
        let counts = [2_usize, 1, 3];
        let matrices: [Vec<f64>; 3] =
            [vec![4.0, 1.0, 1.0, 3.0], vec![0.5], vec![2.0, 0.1, 0.2, 0.1, 1.0, 0.3, 0.2, 0.3, 5.0]];
        let couplings: [Vec<f64>; 3] = [vec![0.2, -0.1], vec![0.3], vec![0.1, 0.4, -0.2]];
        let (own, reach) = ([0.7, 0.5, 0.9], [2.0, 0.01, 0.5]);
        let n: usize = counts.iter().sum();
        let mut full = DMatrix::zeros(n, n);
        let mut states = DMatrix::zeros(3, n);
        let mut first = 0;
        for e in 0..3 {
            // p at the inner end as a row over all unknowns.
            let mut start = 0;
            for inner in 0..e {
                states[(e, start)] = reach[inner];
                start += counts[inner];
            }
            let p = states.row(e).into_owned();
            full += p.transpose() * &p * own[e];
            for i in 0..counts[e] {
                for j in 0..counts[e] {
                    full[(first + i, first + j)] += matrices[e][j * counts[e] + i];
                }
                let mut unit = DMatrix::zeros(1, n);
                unit[(0, first + i)] = couplings[e][i];
                full += unit.transpose() * &p + p.transpose() * &unit;
            }
            first += counts[e];
        }
        let links =
            (0..3).rev().map(|e| Link { matrix: &matrices[e], coupling: &couplings[e], own: own[e], reach: reach[e] });
        let chain = Chain::factor(links).unwrap();
        let mut load = vec![1.0, -2.0, 0.5, 3.0, 0.1, -0.7];
        let on_state = [0.3, -0.4, 1.1];
        let right = DVector::from_vec(load.clone()) + states.transpose() * DVector::from_row_slice(&on_state);
        let expected = full.lu().solve(&right).unwrap();
        chain.solve(&mut load, &on_state);
        for (found, expected) in load.iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-14, "{found} {expected}");
        }
    }

    #[test]
    fn an_indefinite_chain_is_refused() {
        let link = Link { matrix: &[-1.0], coupling: &[0.0], own: 0.0, reach: 1.0 };
        assert!(Chain::factor([link].into_iter()).is_none());
    }
}
