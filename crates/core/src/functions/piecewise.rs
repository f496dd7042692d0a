//! Piecewise polynomials: functions that may bend where the stiffness steps.
//!
//! On each element the strain (curvature in bending, twist rate in torsion) is a sum of Legendre
//! polynomials P_0 … P_{b−1}, without any condition between elements; rotation and displacement follow by integration from the root. These are the hierarchical Hermite–Legendre
//! functions (cubics and bubbles, continuous with their slope) and the linear–Legendre functions of
//! the finite-element literature (Szabó & Babuška, Finite Element Analysis, 1991) in other
//! coordinates: no function is stated by absolute positions, so short elements cost no digits.

use super::{AssumedFunctions, Deformation, Sample};
use crate::numerics::legendre::{Legendre, evaluate};
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// Most polynomials on one element.
pub const MOST_ORDER: usize = 20;

/// Elements of the span and the number of strain polynomials on each.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Ends of the elements, from 0 at the root to l at the tip [m], one more than elements.
    ends: Vec<f64>,
    /// 1 … [`MOST_ORDER`] per element.
    orders: Vec<usize>,
}

impl Mesh {
    /// Elements between ascending `ends`; orders beyond 1 … [`MOST_ORDER`] take the nearest.
    pub fn new(ends: Vec<f64>, orders: Vec<usize>) -> Self {
        let orders = orders.into_iter().map(|order| order.clamp(1, MOST_ORDER)).collect();
        Self { ends, orders }
    }

    /// Polynomials per element.
    pub fn orders(&self) -> &[usize] {
        &self.orders
    }

    /// Coefficients of a strain.
    pub fn count(&self) -> usize {
        self.orders.iter().sum()
    }

    /// Inner end, length and order of each element.
    pub fn elements(&self) -> impl DoubleEndedIterator<Item = (f64, f64, usize)> + ExactSizeIterator + '_ {
        self.ends.windows(2).zip(&self.orders).map(|(ends, &order)| (ends[0], ends[1] - ends[0], order))
    }
}

/// Some functions of a mesh, each given by the coefficients of its strain.
#[derive(Clone, Debug)]
pub struct PiecewiseFunctions {
    mesh: Mesh,
    deformation: Deformation,
    rigid: bool,
    /// Function by function, element by element: strain coefficients [1/m² or 1/m].
    coefficients: DMatrix<f64>,
    /// Rotation and displacement at the inner end of each element (elements × functions).
    rotation: DMatrix<f64>,
    displacement: DMatrix<f64>,
}

impl PiecewiseFunctions {
    /// Functions with these strain coefficients ([`Mesh::count`] × functions), at rest at the root;
    /// before them, where `rigid`, the rigid motion φ = x or θ = 1.
    pub fn new(mesh: Mesh, deformation: Deformation, rigid: bool, coefficients: DMatrix<f64>) -> Self {
        let (elements, functions) = (mesh.orders.len(), coefficients.ncols());
        let mut rotation = DMatrix::zeros(elements, functions);
        let mut displacement = DMatrix::zeros(elements, functions);
        for function in 0..functions {
            let (mut t, mut u, mut first) = (0.0, 0.0, 0);
            for (e, (_, length, order)) in mesh.elements().enumerate() {
                (rotation[(e, function)], displacement[(e, function)]) = (t, u);
                let c = coefficients[(first, function)];
                let next = if order > 1 { coefficients[(first + 1, function)] } else { 0.0 };
                u += length * (t + 0.5 * length * (c - next / 3.0));
                t += length * c;
                first += order;
            }
        }
        Self { mesh, deformation, rigid, coefficients, rotation, displacement }
    }
}

impl AssumedFunctions for PiecewiseFunctions {
    fn count(&self) -> usize {
        self.coefficients.ncols() + usize::from(self.rigid)
    }

    fn has_rigid_motion(&self) -> bool {
        self.rigid
    }

    fn wave_number(&self) -> f64 {
        0.0
    }

    fn joints(&self) -> &[f64] {
        &self.mesh.ends
    }

    fn degree(&self) -> usize {
        self.mesh.orders.iter().max().map_or(0, |order| order + 1)
    }

    fn sample(&self, x: f64, out: &mut [Sample]) {
        let rigid = match self.deformation {
            Deformation::Bending => Sample { value: x, slope: 1.0, curvature: 0.0 },
            Deformation::Torsion => Sample { value: 1.0, slope: 0.0, curvature: 0.0 },
        };
        let (head, elastic) = out.split_at_mut(usize::from(self.rigid).min(out.len()));
        head.fill(rigid);
        let inner = &self.mesh.ends[1..self.mesh.ends.len() - 1];
        let e = inner.partition_point(|&end| end < x);
        let first: usize = self.mesh.orders[..e].iter().sum();
        let (from, to) = (self.mesh.ends[e], self.mesh.ends[e + 1]);
        let half = 0.5 * (to - from);
        let mut polynomials = vec![Legendre::default(); self.mesh.orders[e]];
        evaluate(((x - from) / half - 1.0).clamp(-1.0, 1.0), &mut polynomials);
        for (function, sample) in elastic.iter_mut().enumerate() {
            let (mut strain, mut rotation, mut displacement) = (0.0, 0.0, 0.0);
            for (j, p) in polynomials.iter().enumerate() {
                let c = self.coefficients[(first + j, function)];
                strain += c * p.value;
                rotation += c * p.first;
                displacement += c * p.second;
            }
            let rotation = self.rotation[(e, function)] + half * rotation;
            *sample = match self.deformation {
                Deformation::Bending => Sample {
                    value: self.displacement[(e, function)]
                        + (x - from) * self.rotation[(e, function)]
                        + half * half * displacement,
                    slope: rotation,
                    curvature: strain,
                },
                // The second derivative of a twist is nobody's energy.
                Deformation::Torsion => Sample { value: rotation, slope: strain, curvature: 0.0 },
            };
        }
    }
}
