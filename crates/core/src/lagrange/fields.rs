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
    /// w″, v″ or φ′.
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
