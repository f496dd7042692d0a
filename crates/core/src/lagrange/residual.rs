//! How far modes are from equilibrium: the moment that their loads demand less the one that their
//! strain gives. Its complementary energy is the error of a mode, and with a number between two
//! eigenvalues it makes lower bounds.

use super::equilibrium::FromTip;
use super::fields::{Fields, gram};
use super::grid::Grid;
use crate::blade::RootCondition;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::{DMatrix, DVectorView};

/// Residual moments of some modes, per unit of ω²-fold displacement.
#[derive(Clone, Debug)]
pub struct ResidualMoments {
    /// δ = μ − D e/λ at the points of the grid (points × modes), where μ is the moment that balances
    /// J u − Ω² P t/λ outboard.
    pub moment: DMatrix<f64>,
    /// What the root adds to the complementary energy (modes × modes).
    root: DMatrix<f64>,
}

/// The residual moments of modes with eigenvalues λ (of the problem without the shift of
/// [`System::shift`](super::System::shift)) at Ω² = `speed_squared`; `fields` holds one column per
/// mode. The first `rigid` modes have λ = 0 and none.
pub fn residual_moments(
    grid: &Grid,
    from_tip: &FromTip,
    fields: &Fields,
    eigenvalues: &[f64],
    rigid: usize,
    speed_squared: f64,
) -> ResidualMoments {
    let (points, modes) = (grid.len(), eigenvalues.len());
    let mut moment = DMatrix::zeros(points, modes);
    let mut at_root = vec![0.0; modes];
    let (mut load, mut sum) = (vec![0.0; points], vec![0.0; points]);
    for (mode, &eigenvalue) in eigenvalues.iter().enumerate().skip(rigid) {
        let column = mode * points..(mode + 1) * points;
        let displacement = &fields.displacement.as_slice()[column.clone()];
        let rotation = &fields.rotation.as_slice()[column.clone()];
        let strain = &fields.strain.as_slice()[column.clone()];
        from_tip.inertial_load(grid, displacement, &mut load, &mut sum);
        let factor = speed_squared / eigenvalue;
        load.iter_mut().zip(grid.centrifugal()).zip(rotation).for_each(|((load, p), t)| *load -= factor * p * t);
        at_root[mode] = from_tip.integrate(grid, &load, &mut sum);
        let out = &mut moment.as_mut_slice()[column];
        for (((out, sum), d), e) in out.iter_mut().zip(&sum).zip(grid.elastic()).zip(strain) {
            *out = sum - d * e / eigenvalue;
        }
    }
    let mut root = DMatrix::zeros(modes, modes);
    match grid.condition() {
        RootCondition::Clamped => {}
        RootCondition::Spring(spring) => {
            for ((left, rotation), eigenvalue) in
                at_root.iter_mut().zip(&fields.root_rotation).zip(eigenvalues).skip(rigid)
            {
                *left -= spring * rotation / eigenvalue;
            }
            root = outer(&at_root, 1.0 / spring);
        }
        RootCondition::Free => {
            // No moment may reach a free root, and none does but for rounding: the rigid motion is
            // one of the functions. What is left is taken off as the inertia of so much of it.
            from_tip.inertial_load(grid, &grid.rigid_displacement(), &mut load, &mut sum);
            let total = from_tip.integrate(grid, &load, &mut sum);
            for (mode, left) in at_root.iter().enumerate().skip(rigid) {
                let out = &mut moment.as_mut_slice()[mode * points..(mode + 1) * points];
                out.iter_mut().zip(&sum).for_each(|(out, sum)| *out -= left / total * sum);
            }
        }
    }
    ResidualMoments { moment, root }
}

impl ResidualMoments {
    /// Complementary energies ∫ δ_i δ_j / D dr with what the root adds (modes × modes). The one on
    /// the diagonal times λ is about the relative error of that λ.
    pub fn energies(&self, grid: &Grid) -> DMatrix<f64> {
        let compliance = grid.length().iter().zip(grid.elastic()).map(|(weight, d)| weight / d);
        gram(&self.moment, compliance) + &self.root
    }

    /// The energy of each mode by itself: the diagonal of [`energies`](Self::energies).
    pub fn own_energies(&self, grid: &Grid) -> Vec<f64> {
        let own = |(mode, column): (usize, DVectorView<f64>)| {
            let points = column.iter().zip(grid.length().iter().zip(grid.elastic()));
            points.map(|(moment, (weight, d))| moment * moment * weight / d).sum::<f64>() + self.root[(mode, mode)]
        };
        self.moment.column_iter().enumerate().map(own).collect()
    }
}

fn outer(values: &[f64], factor: f64) -> DMatrix<f64> {
    DMatrix::from_fn(values.len(), values.len(), |i, j| factor * values[i] * values[j])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blade::Blade;
    use crate::dof::Dof;
    use crate::lagrange::classical_functions;
    use crate::lagrange::tests::{cantilever, clamped, sprung};
    use crate::numerics::quadrature::GaussRules;

    /// The grid, integration and fields of the uniform blade's own functions, with points enough to
    /// integrate their loads twice.
    fn classical(blade: &Blade, dof: Dof, count: usize) -> (Grid, FromTip, Fields) {
        let rules = GaussRules::new();
        let functions = classical_functions(blade, dof, count);
        let grid = Grid::for_functions(blade, dof, functions.as_ref(), &rules, 8, &[]);
        let fields = Fields::sample(&grid, functions.as_ref());
        let from_tip = FromTip::new(&grid, &rules);
        (grid, from_tip, fields)
    }

    /// Rounding of 1e-13 of the moment or less, squared.
    #[test]
    fn an_exact_mode_has_no_residual_moment() {
        let (grid, from_tip, fields) = classical(&clamped(0.5), Dof::Flap, 4);
        let values: Vec<f64> = (0..4).map(|mode| cantilever(mode, 1.5)).collect();
        let energies = residual_moments(&grid, &from_tip, &fields, &values, 0, 0.0).energies(&grid);
        for (mode, value) in values.iter().enumerate() {
            let error = energies[(mode, mode)] * value;
            assert!(error < 1e-24, "mode {mode}: {error:e}");
        }
    }

    /// With ε of the second mode in the first the residual moment is ε EI w₂″ (1/λ₂ − 1/λ₁), whose
    /// energy is ε² λ₂ (1/λ₂ − 1/λ₁)² at unit generalised mass. Rounding of 1e-13 in ε = 1e-3.
    #[test]
    fn the_energy_is_the_square_of_an_error() {
        let (grid, from_tip, fields) = classical(&clamped(0.5), Dof::Flap, 2);
        let (first, second) = (cantilever(0, 1.5), cantilever(1, 1.5));
        for share in [1e-3, 2e-3, 1e-2] {
            let wrong = fields.combined(&DMatrix::from_column_slice(2, 1, &[1.0, share]));
            let energies = residual_moments(&grid, &from_tip, &wrong, &[first], 0, 0.0).energies(&grid);
            let known = share * share * second * (1.0 / second - 1.0 / first).powi(2);
            assert!((energies[(0, 0)] / known - 1.0).abs() < 1e-9, "{share}: {} {known}", energies[(0, 0)]);
        }
    }

    /// The same sums one by one, at a spring, too: a few roundings.
    #[test]
    fn own_energies_are_the_diagonal() {
        let (grid, from_tip, fields) = classical(&sprung(0.2), Dof::Flap, 3);
        let moments = residual_moments(&grid, &from_tip, &fields, &[40.0, 700.0, 9000.0], 0, 25.0);
        let energies = moments.energies(&grid);
        for (mode, own) in moments.own_energies(&grid).iter().enumerate() {
            assert!(*own > 0.0 && (own / energies[(mode, mode)] - 1.0).abs() < 1e-14, "{mode}: {own}");
        }
    }
}
