//! The operations of the elements against dense matrices of the same functions, sampled one by one.

use super::*;
use crate::converged::tests::{laden, stepped};
use crate::functions::PiecewiseFunctions;
use crate::lagrange::{Energies, Fields};
use nalgebra::{DMatrix, DVector};

/// Elements over all steps, and the dense energies of every polynomial alone, the rigid motion first.
struct Both {
    dof: Dof,
    elements: Elements,
    dense: Energies,
    fields: Fields,
}

impl Both {
    /// Of each degree of freedom, without and with point masses.
    fn all() -> Vec<Self> {
        let of = |blade: Blade| Dof::ALL.map(|dof| Self::new(&blade, dof));
        [stepped(), laden()].into_iter().flat_map(of).collect()
    }

    fn new(blade: &Blade, dof: Dof) -> Self {
        let rules = GaussRules::new();
        let layout = Layout { radii: vec![0.09, 0.2, 0.3, 0.5, 0.962], orders: vec![3, 1, 2, 4], resolved: true };
        let elements = Elements::new(blade, dof, &layout, &rules);
        let identity = DMatrix::identity(10, 10);
        let functions = PiecewiseFunctions::new(layout.mesh(), Deformation::of(dof), true, identity);
        let fields = Fields::sample(elements.grid(), &functions);
        let dense = Energies::new(elements.grid(), &fields);
        Self { dof, elements, dense, fields }
    }

    /// The part of the clamped polynomials.
    fn clamped(matrix: &DMatrix<f64>) -> DMatrix<f64> {
        matrix.view((1, 1), (10, 10)).into_owned()
    }

    /// K + Ω² P of the clamped polynomials.
    fn potential(&self, square: f64) -> DMatrix<f64> {
        Self::clamped(&self.dense.elastic) + Self::clamped(&self.dense.centrifugal) * square
    }
}

/// Coefficients of no pattern.
fn coefficients() -> Vec<f64> {
    vec![1.0, -0.5, 0.3, 2.0, -1.5, 0.7, 0.2, -0.9, 1.1, 0.4]
}

fn assert_near(found: &[f64], known: &DVector<f64>, relative: f64, what: &str) {
    let found = DVector::from_column_slice(found);
    let off = (&found - known).amax();
    assert!(off < relative * known.amax(), "{what}: {off:e} of {:e}", known.amax());
}

/// Sums of some tens of products: 1e-13 of the largest entry is a thousand roundings.
#[test]
fn gradients_are_those_of_the_dense_matrices() {
    let c = coefficients();
    let q = DVector::from_column_slice(&c);
    for both in Both::all() {
        let dof = both.dof;
        let (elastic, centrifugal) = (Both::clamped(&both.dense.elastic), Both::clamped(&both.dense.centrifugal));
        assert_near(&both.elements.elastic_gradient(&c), &(elastic * &q), 1e-13, "elastic");
        assert_near(&both.elements.centrifugal_gradient(&c), &(centrifugal * &q), 1e-13, "centrifugal");
        let (row, own) = both.elements.centrifugal_on_rigid();
        let known = both.dense.centrifugal.view((1, 0), (10, 1)).column(0).into_owned();
        assert_near(&row, &known, 1e-13, "of the rigid motion");
        assert!((own / both.dense.centrifugal[(0, 0)] - 1.0).abs() < 1e-13, "{dof}: {own}");
    }
}

/// The gradient is the derivative of the energy: of a quadratic form central differences are exact but
/// for the rounding of the energy, 1e-16 of it by a step of 0.01.
#[test]
fn gradients_are_derivatives_of_the_energies() {
    let c = coefficients();
    for both in Both::all() {
        let dof = both.dof;
        let grid = both.elements.grid();
        let energy = |property: &[f64], fields: &DMatrix<f64>, c: &[f64]| -> f64 {
            let sum = fields.columns(1, 10) * DVector::from_column_slice(c);
            0.5 * grid.weighted(property).zip(sum.iter()).map(|(w, v)| w * v * v).sum::<f64>()
        };
        for (gradient, property, fields) in [
            (both.elements.elastic_gradient(&c), grid.elastic(), &both.fields.strain),
            (both.elements.centrifugal_gradient(&c), grid.centrifugal(), &both.fields.rotation),
        ] {
            let size = energy(property, fields, &c);
            for j in 0..10 {
                let (mut more, mut less) = (c.clone(), c.clone());
                (more[j], less[j]) = (c[j] + 0.01, c[j] - 0.01);
                let slope = (energy(property, fields, &more) - energy(property, fields, &less)) / 0.02;
                assert!((gradient[j] - slope).abs() < 1e-12 * size, "{dof} {j}: {} {slope}", gradient[j]);
            }
        }
    }
}

/// (K + Ω² P) x = M c by elimination along the blade and by a dense factor. The stiffness steps by a
/// factor of ninety and the elements by four in length, so both keep 1e-16 times some 1e5 digits.
#[test]
fn responses_solve_the_dense_equations() {
    let c = coefficients();
    for both in Both::all() {
        let displacement = both.elements.displacement(&c);
        let sampled = both.fields.displacement.columns(1, 10) * DVector::from_column_slice(&c);
        assert_near(&displacement, &sampled, 1e-13, "displacement");
        for square in [0.0, 1e2, 1e4] {
            let factor = both.elements.factor(square).unwrap();
            let dense = both.potential(square).cholesky().unwrap();
            let load = Both::clamped(&both.dense.inertia) * DVector::from_column_slice(&c);
            let found = both.elements.response_to_inertia(&factor, &displacement);
            assert_near(&found, &dense.solve(&load), 1e-10, "response to inertia");
            let load = both.dense.centrifugal.view((1, 0), (10, 1)) * -square;
            let found = both.elements.response_to_root_rotation(&factor, square);
            if square > 0.0 {
                let known = dense.solve(&load).column(0).into_owned();
                assert_near(&found, &known, 1e-10, "response to a rotated root");
            } else {
                assert!(found.iter().all(|c| *c == 0.0), "at rest a turned blade stays straight");
            }
        }
    }
}

/// The fine points see the same polynomials as the functions that come out.
#[test]
fn fields_are_those_of_the_functions() {
    let c = coefficients();
    for both in Both::all() {
        let dof = both.dof;
        let matrix = DMatrix::from_column_slice(10, 1, &c);
        let functions = PiecewiseFunctions::new(both.elements.mesh.clone(), Deformation::of(dof), false, matrix);
        let known = Fields::sample(both.elements.fine_grid(), &functions);
        let found = both.elements.fields(&c);
        assert_near(&found.displacement, &known.displacement.column(0).into_owned(), 1e-13, "displacement");
        assert_near(&found.rotation, &known.rotation.column(0).into_owned(), 1e-13, "rotation");
        assert_near(&found.strain, &known.strain.column(0).into_owned(), 1e-13, "strain");
    }
}
