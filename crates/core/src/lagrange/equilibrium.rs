//! Moments from equilibrium: a blade is statically determinate, so the moment that balances any load
//! follows by integration from the free tip. It is the moment of a mode shape, and how far it is
//! from the one that the strain gives says how good a mode is.

use super::fields::Fields;
use super::grid::Grid;
use crate::blade::Blade;
use crate::dof::Dof;
use crate::functions::{AssumedFunctions, Deformation, Sample};
use crate::numerics::legendre::Outboard;
use crate::numerics::quadrature::GaussRules;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// Points beyond those that integrate products of waves: to integrate twice, the wave itself is to be
/// interpolated.
const POINTS_FOR_WAVES: usize = 8;

/// Integration from the tip inward over the panels of a grid.
#[derive(Clone, Debug)]
pub struct FromTip {
    /// By number of points.
    rules: Vec<Option<Outboard>>,
}

impl FromTip {
    /// For the panels of one grid.
    pub fn new(grid: &Grid, rules: &GaussRules) -> Self {
        let mut out: Vec<Option<Outboard>> = Vec::new();
        for panel in grid.panels() {
            let points = panel.points.len();
            if out.len() <= points {
                out.resize(points + 1, None);
            }
            out[points].get_or_insert_with(|| Outboard::new(rules.with_points(points)));
        }
        Self { rules: out }
    }

    /// ∫ f dr from each point to the tip, and from the root; f at the points of the grid.
    pub(super) fn integrate(&self, grid: &Grid, f: &[f64], out: &mut [f64]) -> f64 {
        let mut outboard = 0.0;
        for panel in grid.panels().iter().rev() {
            let span = panel.points.clone();
            if let Some(Some(rule)) = self.rules.get(span.len()) {
                rule.integrate(&f[span.clone()], outboard, panel.half(), &mut out[span.clone()]);
            }
            outboard += over(grid, span, f);
        }
        outboard
    }

    /// The load on the rotation that the inertia of a displacement makes, per ω² and length: the
    /// shear in bending, the torque per length in torsion. `scratch` is overwritten.
    pub(super) fn inertial_load(&self, grid: &Grid, displacement: &[f64], out: &mut [f64], scratch: &mut [f64]) {
        out.iter_mut().zip(grid.inertia()).zip(displacement).for_each(|((out, j), u)| *out = j * u);
        if grid.deformation() == Deformation::Bending {
            self.integrate(grid, out, scratch);
            out.copy_from_slice(scratch);
        }
    }
}

/// ∫ f dr over the points of one panel.
fn over(grid: &Grid, points: core::ops::Range<usize>, f: &[f64]) -> f64 {
    points.map(|k| grid.weight()[k] * f[k]).sum()
}

/// What every assumed function does at sampled radii. A mode Σ q_i φ_i with frequency ω at speed Ω
/// has, row for row, displacement = value · q, slope = slope · q, and the moment that keeps its
/// inertia and centrifugal forces in equilibrium,
/// (ω² · inertial − Ω² · centrifugal) q with the free tip as the start (docs/THEORY.md). That is
/// the moment to use: EI X″ and GJ θ′ of smooth functions jump where the stiffness steps.
#[derive(Clone, Debug)]
pub struct ShapeTables {
    /// The degree of freedom.
    pub dof: Dof,
    /// Radii [m], ascending, p of them.
    pub radii: Vec<f64>,
    /// φ (p × n); 0 inboard of the root.
    pub value: DMatrix<f64>,
    /// φ′ (p × n) [1/m].
    pub slope: DMatrix<f64>,
    /// Moment per ω² (p × n).
    pub inertial: DMatrix<f64>,
    /// Moment per Ω², to be subtracted (p × n).
    pub centrifugal: DMatrix<f64>,
}

/// Tabulates the functions of one degree of freedom at ascending `radii` [m].
///
/// Bending: M(r) = ∫ [ω² ∫ m X dξ − Ω² T X′] ds from r to R; in lag the centrifugal force's
/// component in the disc adds Ω² m X to the load. Torsion: M_t(r) = ∫ (ω² ρI_p − Ω² m Y²) X ds.
pub fn tabulate(
    blade: &Blade,
    dof: Dof,
    functions: &dyn AssumedFunctions,
    radii: &[f64],
    rules: &GaussRules,
) -> ShapeTables {
    let (n, p) = (functions.count(), radii.len());
    let root = blade.root(dof).offset;
    let zeros = || DMatrix::zeros(p, n);
    let (mut value, mut slope, mut inertial, mut centrifugal) = (zeros(), zeros(), zeros(), zeros());
    let mut samples = vec![Sample::default(); n];
    let outboard = radii.partition_point(|&r| r < root);
    for (row, &r) in radii.iter().enumerate().skip(outboard) {
        functions.sample(r - root, &mut samples);
        for (column, sample) in samples.iter().enumerate() {
            value[(row, column)] = sample.value;
            slope[(row, column)] = sample.slope;
        }
    }
    // Panels end at the sampled radii, so that the moments there are whole sums.
    let more = if functions.degree() > 0 { 0 } else { POINTS_FOR_WAVES };
    let grid = Grid::for_functions(blade, dof, functions, rules, more, radii);
    let fields = Fields::sample(&grid, functions);
    let from_tip = FromTip::new(&grid, rules);
    let shift = grid.system().shift(1.0);
    let (mut load, mut scratch) = (vec![0.0; grid.len()], vec![0.0; grid.len()]);
    for column in 0..n {
        let (displacement, rotation) = (fields.displacement.column(column), fields.rotation.column(column));
        from_tip.inertial_load(&grid, displacement.as_slice(), &mut load, &mut scratch);
        scratch.iter_mut().zip(grid.centrifugal()).zip(rotation.iter()).for_each(|((out, p), t)| *out = p * t);
        let (mut at_inertia, mut at_pull, mut row) = (0.0, 0.0, p);
        let mut store = |down_to: f64, at_inertia: f64, at_pull: f64| {
            while row > outboard && radii[row - 1] >= down_to {
                row -= 1;
                inertial[(row, column)] = at_inertia;
                // Part of the load is Ω² times the inertial one, counted with the centrifugal moment.
                centrifugal[(row, column)] = at_pull - shift * at_inertia;
            }
        };
        for panel in grid.panels().iter().rev() {
            store(panel.to, at_inertia, at_pull);
            at_inertia += over(&grid, panel.points.clone(), &load);
            at_pull += over(&grid, panel.points.clone(), &scratch);
        }
        store(root, at_inertia, at_pull);
    }
    ShapeTables { dof, radii: radii.to_vec(), value, slope, inertial, centrifugal }
}
