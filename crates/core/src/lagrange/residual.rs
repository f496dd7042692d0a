//! How far modes are from equilibrium: the moment that their loads demand less the one that their
//! strain gives. Its complementary energy is the error of a mode, and with a number between two
//! eigenvalues it makes lower bounds.

use super::equilibrium::FromTip;
use super::fields::{Fields, gram};
use super::grid::Grid;
use crate::blade::RootCondition;
use crate::numerics::scalar::sqrt;
use crate::numerics::vector::dot;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

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
        let compliance = grid.weight().iter().zip(grid.elastic()).map(|(weight, d)| weight / d);
        gram(&self.moment, compliance) + &self.root
    }
}

fn outer(values: &[f64], factor: f64) -> DMatrix<f64> {
    DMatrix::from_fn(values.len(), values.len(), |i, j| factor * values[i] * values[j])
}

/// The residual moments of all sums of some functions at every speed: a sum with the coordinates x
/// and the eigenvalue λ has the residual moment λ μ_M x − Ω² μ_C x − D e x, and none of the three
/// fields depends on the speed, so their products are summed once.
#[derive(Clone, Debug)]
pub struct Residuals {
    /// Complementary energies between the fields of μ_M, then μ_C, then D e.
    products: DMatrix<f64>,
    shift: f64,
}

impl Residuals {
    /// Of functions that stand at the points of a grid.
    pub fn new(grid: &Grid, from_tip: &FromTip, fields: &Fields) -> Self {
        let (points, n) = (grid.len(), fields.displacement.ncols());
        let compliance: Vec<f64> = grid.weight().iter().zip(grid.elastic()).map(|(w, d)| sqrt(w / d)).collect();
        let at_root = match grid.condition() {
            RootCondition::Spring(spring) => Some(spring),
            // A clamped root takes any moment, and none reaches a free one: the rigid motion is among
            // the functions.
            RootCondition::Clamped | RootCondition::Free => None,
        };
        let rows = points + usize::from(at_root.is_some());
        let mut all = DMatrix::zeros(rows, 3 * n);
        let (mut load, mut sum) = (vec![0.0; points], vec![0.0; points]);
        for j in 0..n {
            let mut store = |block: usize, moment: &[f64], root: f64| {
                let mut column = all.column_mut(block * n + j);
                column.iter_mut().zip(moment).zip(&compliance).for_each(|((out, m), c)| *out = m * c);
                if let Some(spring) = at_root {
                    column[points] = root / sqrt(spring);
                }
            };
            from_tip.inertial_load(grid, fields.displacement.column(j).as_slice(), &mut load, &mut sum);
            let root = from_tip.integrate(grid, &load, &mut sum);
            store(0, &sum, root);
            load.iter_mut()
                .zip(grid.centrifugal())
                .zip(fields.rotation.column(j).iter())
                .for_each(|((load, p), t)| *load = p * t);
            let root = from_tip.integrate(grid, &load, &mut sum);
            store(1, &sum, root);
            sum.iter_mut()
                .zip(grid.elastic())
                .zip(fields.strain.column(j).iter())
                .for_each(|((out, d), e)| *out = d * e);
            store(2, &sum, at_root.map_or(0.0, |spring| spring * fields.root_rotation[j]));
        }
        let product = |i: usize, j: usize| dot(all.column(i).as_slice(), all.column(j).as_slice());
        let mut products = DMatrix::from_fn(3 * n, 3 * n, |i, j| if i < j { 0.0 } else { product(i, j) });
        products.fill_upper_triangle_with_lower_triangle();
        Self { products, shift: grid.system().shift(1.0) }
    }

    /// About the relative error of a mode's eigenvalue at Ω² = `speed_squared`; 0 for a rigid mode.
    pub fn error(&self, coordinates: &[f64], eigenvalue: f64, speed_squared: f64) -> f64 {
        let eigenvalue = eigenvalue + self.shift * speed_squared;
        if eigenvalue == 0.0 {
            return 0.0;
        }
        let n = coordinates.len();
        let mut y = vec![0.0; 3 * n];
        for (j, x) in coordinates.iter().enumerate() {
            (y[j], y[n + j], y[2 * n + j]) = (eigenvalue * x, -speed_squared * x, -x);
        }
        let energy: f64 =
            y.iter().enumerate().map(|(j, value)| value * dot(self.products.column(j).as_slice(), &y)).sum();
        // The rounding of what is left of large numbers may be below 0.
        (energy / eigenvalue).abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blade::Blade;
    use crate::dof::Dof;
    use crate::lagrange::tests::{cantilever, clamped, free, sprung};
    use crate::lagrange::{Energies, assemble, classical_functions};
    use crate::modes::solve;
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

    /// The sums of products against the fields of each mode. At rest the functions are the modes, and
    /// what is left of sums of size 1 over some hundred points is rounding; at speed both see the
    /// same errors.
    #[test]
    fn products_say_the_same_as_the_fields() {
        for blade in [clamped(0.2), free(0.2), sprung(0.2)] {
            for dof in Dof::ALL {
                let (grid, from_tip, fields) = classical(&blade, dof, 5);
                let rigid_motion = blade.root(dof).condition == RootCondition::Free;
                let matrices = assemble(&grid, Energies::new(&grid, &fields), rigid_motion);
                let products = Residuals::new(&grid, &from_tip, &fields);
                for speed in [0.0, 4.0, 15.0] {
                    let square = speed * speed;
                    let modes = solve(&matrices, square, 3).unwrap();
                    let shift = grid.system().shift(square);
                    let values: Vec<f64> = modes.iter().map(|mode| mode.eigenvalue + shift).collect();
                    let rigid = values.iter().take_while(|value| **value == 0.0).count();
                    let q = DMatrix::from_fn(5, 3, |i, j| modes[j].coordinates[i]);
                    let moments = residual_moments(&grid, &from_tip, &fields.combined(&q), &values, rigid, square);
                    let energies = moments.energies(&grid);
                    for (i, mode) in modes.iter().enumerate() {
                        let found = products.error(mode.coordinates.as_slice(), mode.eigenvalue, square);
                        let known = if i < rigid { 0.0 } else { energies[(i, i)] * values[i] };
                        let condition = blade.root(dof).condition;
                        assert!(
                            (found - known).abs() < 1e-11 + 1e-9 * known,
                            "{dof} {condition:?} at {speed}, mode {i}: {found:e} {known:e}"
                        );
                        assert!(
                            speed < 15.0 || dof == Dof::Torsion || i < 1 || known > 1e-8,
                            "{dof}: something to see"
                        );
                    }
                }
            }
        }
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
}
