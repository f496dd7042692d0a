//! What functions do at the points of a grid: displacement, rotation and strain.

use super::grid::Grid;
use crate::functions::{AssumedFunctions, Deformation, Sample};
use crate::numerics::vector::dot;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// What some functions do at the points of a grid (points × functions).
#[derive(Clone, Debug)]
pub struct Fields {
    /// w, v or φ.
    pub displacement: DMatrix<f64>,
    /// w′, v′ or φ.
    pub rotation: DMatrix<f64>,
    /// w″, v″ or φ′; 0 at point masses, where it may step.
    pub strain: DMatrix<f64>,
    /// The rotation at the root.
    pub root_rotation: Vec<f64>,
}

impl Fields {
    /// Samples assumed functions at every point.
    pub fn sample(grid: &Grid, functions: &dyn AssumedFunctions) -> Self {
        let n = functions.count();
        let mut samples = vec![Sample::default(); n];
        let mut fields = Self {
            displacement: DMatrix::zeros(grid.len(), n),
            rotation: DMatrix::zeros(grid.len(), n),
            strain: DMatrix::zeros(grid.len(), n),
            root_rotation: Vec::with_capacity(n),
        };
        let torsion = grid.deformation() == Deformation::Torsion;
        let mut about = Vec::new();
        let mut offsets = Vec::new();
        for panel in grid.panels() {
            let middle = 0.5 * (panel.from + panel.to);
            offsets.clear();
            offsets.extend(grid.radius()[panel.points.clone()].iter().map(|r| r - middle));
            about.clear();
            about.resize(n * offsets.len(), Sample::default());
            functions.sample_about(middle - grid.root(), &offsets, &mut about);
            for (i, samples) in about.chunks_exact(offsets.len()).enumerate() {
                for (point, sample) in panel.points.clone().zip(samples) {
                    fields.displacement[(point, i)] = sample.value;
                    fields.rotation[(point, i)] = if torsion { sample.value } else { sample.slope };
                    fields.strain[(point, i)] = if torsion { sample.slope } else { sample.curvature };
                }
            }
            if let Some(lump) = panel.lump {
                functions.sample(panel.to - grid.root(), &mut samples);
                for (i, sample) in samples.iter().enumerate() {
                    fields.displacement[(lump, i)] = sample.value;
                    fields.rotation[(lump, i)] = if torsion { sample.value } else { sample.slope };
                }
            }
        }
        functions.sample(0.0, &mut samples);
        fields.root_rotation.extend(samples.iter().map(|sample| if torsion { sample.value } else { sample.slope }));
        fields
    }

    /// The fields of sums of the functions: one column of `coordinates` per sum.
    #[must_use]
    pub fn combined(&self, coordinates: &DMatrix<f64>) -> Self {
        let root = nalgebra::RowDVector::from_row_slice(&self.root_rotation) * coordinates;
        Self {
            displacement: &self.displacement * coordinates,
            rotation: &self.rotation * coordinates,
            strain: &self.strain * coordinates,
            root_rotation: root.iter().copied().collect(),
        }
    }
}

/// Σ weight a_i a_j over the points (functions × functions).
pub(super) fn gram(a: &DMatrix<f64>, weight: impl ExactSizeIterator<Item = f64>) -> DMatrix<f64> {
    let (points, n) = (a.nrows(), a.ncols());
    let weight: Vec<f64> = weight.collect();
    let mut out = DMatrix::zeros(n, n);
    let mut weighted = vec![0.0; points];
    for j in 0..n {
        let column = &a.as_slice()[j * points..(j + 1) * points];
        weighted.iter_mut().zip(column).zip(&weight).for_each(|((out, a), w)| *out = a * w);
        for i in j..n {
            let value = dot(&weighted, &a.as_slice()[i * points..(i + 1) * points]);
            out[(i, j)] = value;
            out[(j, i)] = value;
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dof::Dof;
    use crate::functions::{Mesh, PiecewiseFunctions};
    use crate::lagrange::classical_functions;
    use crate::lagrange::tests::{free, tapered};
    use crate::numerics::quadrature::GaussRules;

    /// The rotation is the slope of the displacement, and the strain that of the rotation. Central
    /// differences over 2e-4 m are off by 2e-9 β³ and by 1e-12 of rounding, with β below 8.
    #[test]
    fn each_field_of_a_beam_is_the_derivative_of_the_one_before() {
        let (blade, rules, h) = (tapered(), GaussRules::new(), 1e-4);
        for dof in [Dof::Flap, Dof::Lag] {
            let functions = classical_functions(&blade, dof, 4);
            let grid = Grid::for_functions(&blade, dof, functions.as_ref(), &rules, 0, &[]);
            let fields = Fields::sample(&grid, functions.as_ref());
            let (mut before, mut after) = (vec![Sample::default(); 4], vec![Sample::default(); 4]);
            for (point, x) in grid.x().enumerate().filter(|(_, x)| *x > h && *x < 1.5 - h) {
                functions.sample(x - h, &mut before);
                functions.sample(x + h, &mut after);
                for (i, (before, after)) in before.iter().zip(&after).enumerate() {
                    let slope = (after.value - before.value) / (2.0 * h);
                    let curvature = (after.slope - before.slope) / (2.0 * h);
                    assert!((fields.rotation[(point, i)] - slope).abs() < 1e-5, "{dof} {i} at {x}");
                    assert!((fields.strain[(point, i)] - curvature).abs() < 1e-4, "{dof} {i} at {x}");
                }
            }
        }
    }

    /// w = x, and w = x² from a curvature of 2 that goes over two elements. Few roundings of size 4.
    #[test]
    fn polynomials_are_those_of_their_strain() {
        let (blade, rules) = (free(0.5), GaussRules::new());
        let mesh = Mesh::new(vec![0.0, 0.4, 1.5], vec![1, 2]);
        let strain = DMatrix::from_column_slice(3, 1, &[2.0, 2.0, 0.0]);
        for dof in Dof::ALL {
            let functions = PiecewiseFunctions::new(mesh.clone(), Deformation::of(dof), true, strain.clone());
            let grid = Grid::for_functions(&blade, dof, &functions, &rules, 0, &[]);
            let fields = Fields::sample(&grid, &functions);
            let torsion = dof == Dof::Torsion;
            let near = |a: f64, b: f64| assert!((a - b).abs() < 4e-15, "{dof}: {a} {b}");
            for (point, x) in grid.x().enumerate() {
                near(fields.displacement[(point, 0)], if torsion { 1.0 } else { x });
                near(fields.displacement[(point, 1)], if torsion { 2.0 * x } else { x * x });
                near(fields.rotation[(point, 0)], 1.0);
                near(fields.rotation[(point, 1)], 2.0 * x);
                near(fields.strain[(point, 0)], 0.0);
                near(fields.strain[(point, 1)], 2.0);
            }
            assert_eq!(fields.root_rotation, [1.0, 0.0]);
            assert!(!torsion || fields.rotation == fields.displacement, "the rotation of torsion is its displacement");
        }
    }

    #[test]
    fn sums_add_every_field() {
        let (blade, rules) = (free(0.5), GaussRules::new());
        let functions = classical_functions(&blade, Dof::Flap, 2);
        let grid = Grid::for_functions(&blade, Dof::Flap, functions.as_ref(), &rules, 0, &[]);
        let fields = Fields::sample(&grid, functions.as_ref());
        let sum = fields.combined(&DMatrix::from_column_slice(2, 1, &[2.0, -0.5]));
        // Powers of two multiply exactly; one sum is left to round.
        let of = |a: &DMatrix<f64>, k: usize| 2.0 * a[(k, 0)] - 0.5 * a[(k, 1)];
        for k in 0..grid.len() {
            assert!((sum.displacement[k] - of(&fields.displacement, k)).abs() < 1e-14);
            assert!((sum.rotation[k] - of(&fields.rotation, k)).abs() < 1e-14);
            assert!((sum.strain[k] - of(&fields.strain, k)).abs() < 1e-13);
        }
        let [a, b] = fields.root_rotation[..] else { panic!("two functions") };
        assert!((sum.root_rotation[0] - (2.0 * a - 0.5 * b)).abs() < 1e-14);
    }

    /// Σ w a_i a_j of whole numbers, which do not round.
    #[test]
    fn a_gram_matrix_is_the_sum_over_the_points() {
        let a = DMatrix::from_row_slice(3, 2, &[1.0, 2.0, 3.0, -1.0, 0.0, 4.0]);
        let found = gram(&a, [1.0, 2.0, 3.0].into_iter());
        assert_eq!(found, DMatrix::from_row_slice(2, 2, &[19.0, -4.0, -4.0, 54.0]));
    }
}
