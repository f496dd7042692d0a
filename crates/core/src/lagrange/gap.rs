//! How far modes are from equilibrium: the moment that their inertia and pull demand against the
//! one that their strain gives. Its complementary energy is the error of a mode, and with a number
//! between two eigenvalues it makes lower bounds.

use super::grid::{Fields, Grid};
use crate::blade::RootCondition;
use crate::dof::Dof;
use crate::numerics::legendre::Outboard;
use crate::numerics::quadrature::GaussRules;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// Integration from the tip inward over the cells of a grid.
#[derive(Clone, Debug)]
pub struct FromTip {
    /// By number of points.
    rules: Vec<Option<Outboard>>,
}

impl FromTip {
    /// For the cells of one grid.
    pub fn new(grid: &Grid, rules: &GaussRules) -> Self {
        let mut out: Vec<Option<Outboard>> = Vec::new();
        for cell in grid.cells() {
            let points = cell.points.len();
            if out.len() <= points {
                out.resize(points + 1, None);
            }
            out[points].get_or_insert_with(|| Outboard::new(rules.with_points(points)));
        }
        Self { rules: out }
    }

    /// ∫ f dr from each point to the tip, and from the root; f at the points of the grid.
    fn integrate(&self, grid: &Grid, f: &[f64], out: &mut [f64]) -> f64 {
        let mut outboard = 0.0;
        for cell in grid.cells().iter().rev() {
            let span = cell.points.clone();
            if let Some(Some(rule)) = self.rules.get(span.len()) {
                rule.integrate(&f[span.clone()], outboard, cell.half(), &mut out[span.clone()]);
            }
            outboard += span.map(|k| grid.weight()[k] * f[k]).sum::<f64>();
        }
        outboard
    }

    /// What the inertia of a motion presses on the turn, per ω² and length: the shear in bending, the
    /// torque per length in torsion. `scratch` is overwritten.
    fn press(&self, grid: &Grid, motion: &[f64], out: &mut [f64], scratch: &mut [f64]) {
        out.iter_mut().zip(grid.inertia()).zip(motion).for_each(|((out, j), u)| *out = j * u);
        if grid.dof() != Dof::Torsion {
            self.integrate(grid, out, scratch);
            out.copy_from_slice(scratch);
        }
    }
}

/// Moments of some modes that their strain does not explain, per unit of ω²-fold displacement: the
/// modes' deflection under their own inertia, divided by λ, would close the gap.
#[derive(Clone, Debug)]
pub struct MomentGaps {
    /// δ = μ − D e/λ at the points of the grid (points × modes), where μ is the moment that balances
    /// J u − Ω² P t/λ outboard.
    pub moment: DMatrix<f64>,
    /// What the root adds to the complementary energy (modes × modes).
    root: DMatrix<f64>,
}

/// The gaps of modes with eigenvalues λ (in lag those of the flap-type problem, ω² + Ω²) at Ω² =
/// `speed_squared`; `fields` holds one column per mode. The first `rigid` modes have λ = 0 and no
/// gap.
pub fn moment_gaps(
    grid: &Grid,
    from_tip: &FromTip,
    fields: &Fields,
    eigenvalues: &[f64],
    rigid: usize,
    speed_squared: f64,
) -> MomentGaps {
    let (points, modes) = (grid.len(), eigenvalues.len());
    let mut moment = DMatrix::zeros(points, modes);
    let mut at_root = vec![0.0; modes];
    let (mut load, mut sum) = (vec![0.0; points], vec![0.0; points]);
    for (mode, &eigenvalue) in eigenvalues.iter().enumerate().skip(rigid) {
        let column = mode * points..(mode + 1) * points;
        let motion = &fields.motion.as_slice()[column.clone()];
        let turn = &fields.turn.as_slice()[column.clone()];
        let strain = &fields.strain.as_slice()[column.clone()];
        from_tip.press(grid, motion, &mut load, &mut sum);
        let pull = speed_squared / eigenvalue;
        load.iter_mut().zip(grid.pull()).zip(turn).for_each(|((load, p), t)| *load -= pull * p * t);
        at_root[mode] = from_tip.integrate(grid, &load, &mut sum);
        let out = &mut moment.as_mut_slice()[column];
        for (((out, sum), d), e) in out.iter_mut().zip(&sum).zip(grid.stiffness()).zip(strain) {
            *out = sum - d * e / eigenvalue;
        }
    }
    let mut root = DMatrix::zeros(modes, modes);
    match grid.condition() {
        RootCondition::Clamped => {}
        RootCondition::Spring(spring) => {
            for ((gap, turn), eigenvalue) in at_root.iter_mut().zip(&fields.root_turn).zip(eigenvalues).skip(rigid) {
                *gap -= spring * turn / eigenvalue;
            }
            root = outer(&at_root, 1.0 / spring);
        }
        RootCondition::Free => {
            // No moment may reach a free root, and none does but for rounding: the rigid motion is
            // one of the functions. What is left is taken off as the inertia of so much of it.
            from_tip.press(grid, &grid.rigid_motion(), &mut load, &mut sum);
            let total = from_tip.integrate(grid, &load, &mut sum);
            for (mode, gap) in at_root.iter().enumerate().skip(rigid) {
                let out = &mut moment.as_mut_slice()[mode * points..(mode + 1) * points];
                out.iter_mut().zip(&sum).for_each(|(out, sum)| *out -= gap / total * sum);
            }
        }
    }
    MomentGaps { moment, root }
}

impl MomentGaps {
    /// Complementary energies ∫ δ_i δ_j / D dr with what the root adds (modes × modes). The one on
    /// the diagonal times λ is about the relative error of that λ.
    pub fn energies(&self, grid: &Grid) -> DMatrix<f64> {
        let compliance = grid.weight().iter().zip(grid.stiffness()).map(|(weight, d)| weight / d);
        super::grid::gram(&self.moment, compliance) + &self.root
    }
}

fn outer(values: &[f64], factor: f64) -> DMatrix<f64> {
    DMatrix::from_fn(values.len(), values.len(), |i, j| factor * values[i] * values[j])
}
