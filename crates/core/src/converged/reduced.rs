//! The few functions that come out of the many: the span of the modes at some speeds.

use super::Wanted;
use super::elements::Elements;
use super::subspace::Subspace;
use super::work::{Effort, Work};
use crate::lagrange::{Fields, FromTip, SystemMatrices, assemble, residual_moments};
use crate::numerics::eigen::{EigenError, lowest};
use crate::numerics::scalar::{maximum, sqrt};
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// A direction with less than this beside those there are is left out.
const NOTHING_NEW: f64 = 1e-8;

/// The few functions that came out.
#[derive(Clone, Debug)]
pub(super) struct Reduced {
    /// Their strain coefficients; the rigid motion has none.
    pub(super) coefficients: DMatrix<f64>,
    pub(super) matrices: SystemMatrices,
}

/// How good the modes are where they were checked.
pub(super) struct Checked {
    /// The largest relative error of an eigenvalue.
    pub(super) error: f64,
    /// The eigenvalues at the last speed, the end of the range, where the modes are counted, too; in lag with
    /// the shift.
    pub(super) values: Vec<f64>,
    /// The largest error that each element is to blame for.
    pub(super) shares: Vec<f64>,
}

impl Reduced {
    /// The span of the modes at these Ω².
    pub(super) fn new(
        elements: &Elements,
        subspace: &Subspace,
        anchors: &[f64],
        count: usize,
    ) -> Result<Self, EigenError> {
        let rigid = usize::from(elements.root_rotates());
        let mut out: Vec<Vec<f64>> = Vec::new();
        for &s in anchors {
            for q in subspace.ritz(s, count)?.vectors.column_iter() {
                add_direction(&mut out, q.as_slice()[rigid..].to_vec());
            }
        }
        let clamped = DMatrix::from_fn(subspace.len() - rigid, out.len(), |i, j| out[j][i]);
        let mut all = DMatrix::zeros(subspace.len(), out.len() + rigid);
        all.view_mut((rigid, rigid), clamped.shape()).copy_from(&clamped);
        if rigid == 1 {
            all[(0, 0)] = 1.0;
        }
        let matrices = assemble(elements.grid(), subspace.energies(), rigid == 1).reduced(&all);
        Ok(Self { coefficients: subspace.coefficients(&clamped), matrices })
    }

    /// All functions of a subspace.
    pub(super) fn whole(elements: &Elements, subspace: &Subspace) -> Self {
        let rigid = usize::from(elements.root_rotates());
        let n = subspace.len();
        let matrices = assemble(elements.grid(), subspace.energies(), rigid == 1);
        Self { coefficients: subspace.coefficients(&DMatrix::identity(n - rigid, n - rigid)), matrices }
    }

    /// The modes at all speeds where they are to be checked.
    pub(super) fn checked(
        &self,
        elements: &Elements,
        wanted: &Wanted,
        from_tip: &FromTip,
        work: &Work,
    ) -> Result<Checked, EigenError> {
        let shares = vec![0.0; elements.mesh.orders().len()];
        let mut checked = Checked { error: 0.0, values: Vec::new(), shares };
        for s in wanted.checks() {
            let own;
            (own, checked.values) = self.check(elements, s, wanted.count, from_tip, &mut checked.shares, work)?;
            checked.error = checked.error.max(own);
        }
        Ok(checked)
    }

    /// The largest relative error of the `count` lowest eigenvalues at Ω² = `s`, and these, in lag with the
    /// shift; raises the share of each element to the largest error that it is to blame for.
    pub(super) fn check(
        &self,
        elements: &Elements,
        s: f64,
        count: usize,
        from_tip: &FromTip,
        shares: &mut [f64],
        work: &Work,
    ) -> Result<(f64, Vec<f64>), EigenError> {
        let n = self.matrices.count();
        work.spend(Effort::modes(n) + elements.effort().moments(n, count));
        let grid = elements.fine_grid();
        let shift = grid.system().shift(s);
        let g = self.matrices.stiffness() + self.matrices.centrifugal() * s + self.matrices.mass() * shift;
        let found = lowest(&g, self.matrices.mass(), count)?;
        let rigid = found.values.iter().take_while(|value| **value == 0.0).count();
        let fields = self.fields(elements, &found.vectors);
        let residuals = residual_moments(grid, from_tip, &fields, &found.values, rigid, s);
        let energies = residuals.energies(grid);
        let mut error = 0.0_f64;
        for (mode, value) in found.values.iter().enumerate().skip(rigid) {
            let own = energies[(mode, mode)] * value;
            // What is not a number is no small error.
            error = error.max(if own.is_nan() { f64::INFINITY } else { own });
            let column = residuals.moment.column(mode);
            for (panel, share) in grid.panels().iter().zip(shares.iter_mut()) {
                let own: f64 =
                    panel.points.clone().map(|k| grid.weight()[k] * column[k] * column[k] / grid.elastic()[k]).sum();
                *share = share.max(own * value);
            }
        }
        Ok((error, found.values))
    }

    /// The largest relative error of modes at Ω² = `s` that were found elsewhere.
    pub(super) fn error_of(
        &self,
        elements: &Elements,
        coordinates: &DMatrix<f64>,
        values: &[f64],
        s: f64,
        from_tip: &FromTip,
    ) -> f64 {
        let grid = elements.fine_grid();
        let shift = grid.system().shift(s);
        let shifted: Vec<f64> = values.iter().map(|value| value + shift).collect();
        let rigid = shifted.iter().take_while(|value| **value == 0.0).count();
        let fields = self.fields(elements, coordinates);
        let own = residual_moments(grid, from_tip, &fields, &shifted, rigid, s).own_energies(grid);
        own.iter().zip(&shifted).skip(rigid).fold(0.0, |worst, (energy, value)| maximum(worst, energy * value))
    }

    /// What sums of the functions that came out (columns of `coordinates`) do along the span.
    pub(super) fn fields(&self, elements: &Elements, coordinates: &DMatrix<f64>) -> Fields {
        let rigid = usize::from(elements.root_rotates());
        let points = elements.fine_grid().len();
        let n = coordinates.ncols();
        let mut fields = Fields {
            displacement: DMatrix::zeros(points, n),
            rotation: DMatrix::zeros(points, n),
            strain: DMatrix::zeros(points, n),
            root_rotation: vec![0.0; n],
        };
        let rigid_displacement = elements.fine_grid().rigid_displacement();
        for (column, q) in coordinates.column_iter().enumerate() {
            let sum = &self.coefficients * q.rows(rigid, q.nrows() - rigid);
            let vector = elements.fields(sum.as_slice());
            let root_rotation = if rigid == 1 { q[0] } else { 0.0 };
            fields.root_rotation[column] = root_rotation;
            let at = column * points..(column + 1) * points;
            for ((out, clamped), x) in fields.displacement.as_mut_slice()[at.clone()]
                .iter_mut()
                .zip(&vector.displacement)
                .zip(&rigid_displacement)
            {
                *out = clamped + root_rotation * x;
            }
            for (out, clamped) in fields.rotation.as_mut_slice()[at.clone()].iter_mut().zip(&vector.rotation) {
                *out = clamped + root_rotation;
            }
            fields.strain.as_mut_slice()[at].copy_from_slice(&vector.strain);
        }
        fields
    }
}

/// Adds what a direction has beside those there are, at unit length.
fn add_direction(out: &mut Vec<Vec<f64>>, mut direction: Vec<f64>) {
    let length = |v: &[f64]| sqrt(v.iter().map(|v| v * v).sum());
    let before = length(&direction);
    for _ in 0..2 {
        for known in out.iter() {
            let along: f64 = known.iter().zip(&direction).map(|(a, b)| a * b).sum();
            direction.iter_mut().zip(known).for_each(|(v, k)| *v -= along * k);
        }
    }
    let after = length(&direction);
    if after > NOTHING_NEW * before {
        out.push(direction.into_iter().map(|v| v / after).collect());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::converged::Converged;
    use crate::converged::tests::stepped;
    use crate::dof::Dof;
    use crate::numerics::quadrature::GaussRules;

    #[test]
    fn directions_are_orthonormal_and_nothing_counts_twice() {
        let mut out = Vec::new();
        for direction in [[3.0, 4.0, 0.0], [6.0, 8.0, 0.0], [1.0, 1.0, 0.0], [1.0, 2.0, 1e-9], [0.0, 0.0, 0.0]] {
            add_direction(&mut out, direction.to_vec());
        }
        // The fourth differs from the first two by less than the limit.
        assert_eq!(out.len(), 2);
        for (i, a) in out.iter().enumerate() {
            for (j, b) in out.iter().enumerate() {
                let product: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
                let known = if i == j { 1.0 } else { 0.0 };
                // Three products of numbers below 1.
                assert!((product - known).abs() < 1e-15, "{i} {j}: {product}");
            }
        }
    }

    /// The shares of the elements are parts of one sum of squares: with one mode and a clamped root
    /// they are the error.
    #[test]
    fn the_shares_of_the_elements_make_up_the_error() {
        let (blade, rules) = (stepped(), GaussRules::new());
        let found = Converged::with_order(&blade, Dof::Flap, 1e4, 1, 3, &rules, &Work::default()).unwrap();
        let elements = &found.elements;
        let from_tip = FromTip::new(elements.fine_grid(), &rules);
        let mut shares = vec![0.0; elements.mesh.orders().len()];
        let (error, _) = found.found.check(elements, 1e4, 1, &from_tip, &mut shares, &Work::default()).unwrap();
        let sum: f64 = shares.iter().sum();
        assert!(error > 1e-12 && (sum / error - 1.0).abs() < 1e-12, "{error:e} {sum:e}");
        // A share that is larger already stays.
        let mut large = vec![1.0; shares.len()];
        found.found.check(elements, 1e4, 1, &from_tip, &mut large, &Work::default()).unwrap();
        assert!(large.iter().all(|share| *share == 1.0));
    }

    /// M of mass-normalised modes is the identity, whatever sums of functions they are.
    #[test]
    fn fields_carry_the_energies_of_the_matrices() {
        let (blade, rules) = (stepped(), GaussRules::new());
        for dof in Dof::ALL {
            let found = Converged::with_order(&blade, dof, 1e4, 3, 8, &rules, &Work::default()).unwrap();
            let grid = found.elements.fine_grid();
            let n = found.found.matrices.count();
            let fields = found.found.fields(&found.elements, &DMatrix::identity(n, n));
            let sampled = assemble(grid, crate::lagrange::Energies::new(grid, &fields), found.elements.root_rotates());
            for (a, b) in [
                (sampled.mass(), found.matrices().mass()),
                (sampled.stiffness(), found.matrices().stiffness()),
                (sampled.centrifugal(), found.matrices().centrifugal()),
            ] {
                // The same polynomials on other points.
                assert!((a - b).amax() < 1e-11 * b.amax(), "{dof}: {:e}", (a - b).amax() / b.amax());
            }
        }
    }
}
