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

    /// ∫ f dr from each point to the tip, and from the root; f at the points of the grid, at a point mass its step.
    pub(super) fn integrate(&self, grid: &Grid, f: &[f64], out: &mut [f64]) -> f64 {
        let mut outboard = 0.0;
        for panel in grid.panels().iter().rev() {
            if let Some(lump) = panel.lump {
                outboard += f[lump];
                out[lump] = outboard;
            }
            let span = panel.points.clone();
            if let Some(Some(rule)) = self.rules.get(span.len()) {
                rule.integrate(&f[span.clone()], outboard, panel.half(), &mut out[span.clone()]);
            }
            outboard += over(grid, span, f);
        }
        outboard
    }

    /// The load on the rotation that the inertia of a displacement makes, per ω² and length: the
    /// shear in bending, the torque per length in torsion; of a point mass a torque in torsion alone. `scratch` is
    /// overwritten.
    pub(super) fn inertial_load(&self, grid: &Grid, displacement: &[f64], out: &mut [f64], scratch: &mut [f64]) {
        out.iter_mut().zip(grid.inertia()).zip(displacement).for_each(|((out, j), u)| *out = j * u);
        if grid.deformation() == Deformation::Bending {
            self.integrate(grid, out, scratch);
            out.copy_from_slice(scratch);
            // A force makes a step of the shear, and no moment by itself.
            grid.lumps().for_each(|lump| out[lump] = 0.0);
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
    /// φ (p radii × n functions); 0 inboard of the root.
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
            if let Some(lump) = panel.lump {
                at_inertia += load[lump];
                at_pull += scratch[lump];
            }
            store(panel.to, at_inertia, at_pull);
            at_inertia += over(&grid, panel.points.clone(), &load);
            at_pull += over(&grid, panel.points.clone(), &scratch);
        }
        store(root, at_inertia, at_pull);
    }
    ShapeTables { dof, value, slope, inertial, centrifugal }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lagrange::classical_functions;
    use crate::lagrange::tests::{MASS, STIFFNESS, cantilever, clamped, free, tapered};

    const RADII: [f64; 6] = [0.2, 0.5, 0.8, 1.25, 1.9, 2.0];

    /// At rest the inertia of a mode is in equilibrium with EI w″. What is integrated twice is
    /// interpolated to rounding, which grows to some hundred times 1e-16 of the root's moment.
    #[test]
    fn the_moment_of_a_cantilever_mode_is_its_curvature_times_stiffness() {
        let blade = clamped(0.5);
        let functions = classical_functions(&blade, Dof::Flap, 3);
        let table = tabulate(&blade, Dof::Flap, functions.as_ref(), &RADII, &GaussRules::new());
        let mut samples = [Sample::default(); 3];
        for mode in 0..3 {
            functions.sample(0.0, &mut samples);
            let largest = STIFFNESS[0] * samples[mode].curvature.abs();
            for (row, r) in RADII.iter().enumerate().skip(1) {
                functions.sample(r - 0.5, &mut samples);
                let moment = cantilever(mode, 1.5) * table.inertial[(row, mode)];
                let known = STIFFNESS[0] * samples[mode].curvature;
                assert!((moment - known).abs() < 1e-12 * largest, "mode {mode} at {r}: {moment} {known}");
                assert_eq!(table.value[(row, mode)], samples[mode].value);
                assert_eq!(table.slope[(row, mode)], samples[mode].slope);
            }
            assert_eq!(table.inertial[(RADII.len() - 1, mode)], 0.0, "a free tip");
            assert_eq!((table.value[(0, mode)], table.inertial[(0, mode)]), (0.0, 0.0), "nothing inboard of the root");
        }
    }

    /// No moment reaches a free hinge.
    #[test]
    fn the_moment_vanishes_at_a_free_hinge() {
        let blade = free(0.5);
        for dof in Dof::ALL {
            let functions = classical_functions(&blade, dof, 4);
            let table = tabulate(&blade, dof, functions.as_ref(), &RADII, &GaussRules::new());
            for mode in 1..4 {
                let largest = table.inertial.column(mode).amax();
                assert!(table.inertial[(1, mode)].abs() < 1e-13 * largest, "{dof} {mode}: rounding of its largest");
            }
        }
    }

    /// A rigid flap motion about the hub has ω = Ω whatever the mass: pull and inertia balance at
    /// every radius. In lag it has ω = 0, and in both the pull is the same.
    #[test]
    fn a_rigid_flap_motion_about_the_hub_turns_once_per_revolution() {
        let blade = free(0.0);
        for (dof, square) in [(Dof::Flap, 1.0), (Dof::Lag, 0.0)] {
            let functions = classical_functions(&blade, dof, 1);
            let table = tabulate(&blade, dof, functions.as_ref(), &RADII, &GaussRules::new());
            let left = &table.inertial * square - &table.centrifugal;
            // Both are integrals of a cubic over a panel or a few.
            assert!(left.amax() < 1e-14 * table.inertial.amax(), "{dof}: {:e}", left.amax());
        }
    }

    /// ∫ m ds dξ twice over of a uniform blade: the shear m (l² − x²)/2 of w = x.
    #[test]
    fn loads_are_integrated_from_the_tip() {
        let (blade, rules) = (free(0.5), GaussRules::new());
        let functions = classical_functions(&blade, Dof::Flap, 4);
        let grid = Grid::for_functions(&blade, Dof::Flap, functions.as_ref(), &rules, 2, &[0.9]);
        let from_tip = FromTip::new(&grid, &rules);
        let (mut load, mut scratch) = (vec![0.0; grid.len()], vec![0.0; grid.len()]);
        from_tip.inertial_load(&grid, &grid.rigid_displacement(), &mut load, &mut scratch);
        for (shear, x) in load.iter().zip(grid.x()) {
            assert!((shear - 0.5 * MASS * (2.25 - x * x)).abs() < 1e-14, "a few roundings of a number of size 2");
        }
        let total = from_tip.integrate(&grid, &load, &mut scratch);
        // m l³/3, the moment of inertia about the root.
        assert!((total - MASS * 1.5_f64.powi(3) / 3.0).abs() < 1e-14, "{total}");
        assert!((scratch[0] - total).abs() < 0.1 && scratch[grid.len() - 1] < 0.01, "from each point to the tip");
    }

    /// Torsion's load is its inertia times the twist, point by point.
    #[test]
    fn the_load_of_torsion_is_not_integrated() {
        let (blade, rules) = (tapered(), GaussRules::new());
        let functions = classical_functions(&blade, Dof::Torsion, 1);
        let grid = Grid::for_functions(&blade, Dof::Torsion, functions.as_ref(), &rules, 0, &[]);
        let mut load = vec![0.0; grid.len()];
        let mut scratch = load.clone();
        FromTip::new(&grid, &rules).inertial_load(&grid, &grid.rigid_displacement(), &mut load, &mut scratch);
        assert_eq!(load, grid.inertia());
    }
}
