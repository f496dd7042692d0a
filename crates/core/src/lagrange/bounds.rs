//! Two-sided bounds of eigenvalues: Rayleigh and Ritz from above, Lehmann, Maehly and Goerisch from
//! below (docs/THEORY.md; F. Goerisch & Z. He, in: Computer Arithmetic and Self-Validating Numerical
//! Methods, 1990). A blade is statically determinate, so the lower bounds come from the same
//! functions by integrating their loads from the tip.

use super::assembly::Energies;
use super::equilibrium::FromTip;
use super::fields::Fields;
use super::grid::{Grid, Panel};
use super::residual::residual_moments;
use crate::blade::RootCondition;
use crate::numerics::eigen::lowest;
use crate::numerics::scalar::{maximum, sqrt};
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::{DMatrix, DVector};

/// Share of the gap below λ_{n+1} at which ρ stands: far above λ_n, and below λ_{n+1} by many times
/// its error.
const SEPARATION: f64 = 0.8;
/// Modes with less than this part of the last one's x/(1 − x) are bounded apart from it: the
/// eigensolver cannot tell them from 0 beside it.
const SPREAD: f64 = 1e-10;
/// Relative distance of an eigenvalue from the Rayleigh quotient of its own fields from which on it is
/// not taken for the better one.
const UNSOUND: f64 = 1e-11;
/// Relative rounding of an energy that is a sum of squares over the points of a blade, generously.
const ROUNDING: f64 = 1e-13;

/// An eigenvalue λ = ω² lies in here [rad²/s²].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// At least 0.
    pub lower: f64,
    /// At least `lower`.
    pub upper: f64,
}

/// Intervals of the lowest modes of one degree of freedom.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    /// The eigenvalues that are bounded [rad²/s²]: those given, or better ones where their own fields
    /// give others.
    pub eigenvalues: Vec<f64>,
    /// One per mode.
    pub intervals: Vec<Interval>,
    /// ρ, known to lie above the last mode that has a lower bound of its own and not above the next
    /// eigenvalue [rad²/s²]; `None` where no mode has one.
    pub separation: Option<f64>,
}

/// The converged eigenvalues of as many modes as are bounded and one more.
#[derive(Clone, Debug)]
pub struct Reference {
    /// ω² [rad²/s²], ascending.
    pub eigenvalues: Vec<f64>,
    /// How near below each of them, as a share of it, no eigenvalue was missed: counted, and more than
    /// its own error. 1 or more leaves all modes without bounds.
    pub margin: f64,
}

/// Bounds of the modes with eigenvalues `ritz` [rad²/s²] and these fields at Ω² = `speed_squared`.
/// `slack` ≥ 1 multiplies the complementary energy where its quadrature is not exact. `None` where
/// nothing separates the modes from those above.
pub fn bounds(
    grid: &Grid,
    from_tip: &FromTip,
    fields: &Fields,
    ritz: &[f64],
    reference: &Reference,
    speed_squared: f64,
    slack: f64,
) -> Option<Bounds> {
    if reference.margin >= 1.0 {
        return None;
    }
    // Bounded is the problem without the centrifugal terms on displacements.
    let shift = grid.system().shift(speed_squared);
    let given: Vec<f64> = ritz.iter().map(|value| value + shift).collect();
    let refined = refined(grid, fields, &given, speed_squared);
    let (values, fields) = refined.as_ref().map_or((&given, fields), |(values, fields)| (values, fields));
    let margin = reference.margin;
    let reference: Vec<f64> = reference.eigenvalues.iter().map(|value| value + shift).collect();
    // A mode without any potential energy is known exactly and leaves the others to themselves.
    let rigid = values.iter().take_while(|value| **value == 0.0).count();
    let energies = residual_moments(grid, from_tip, fields, values, rigid, speed_squared).energies(grid) * slack;
    let separation = |n: usize| reference[n - 1] + SEPARATION * (reference[n] - reference[n - 1]);
    let bounded = (rigid + 1..=values.len().min(reference.len().saturating_sub(1)))
        .rev()
        .find(|&n| values[n - 1] < separation(n) && separation(n) < reference[n] * (1.0 - margin));
    let rounding = rounding(grid, fields, values, speed_squared);
    let mut intervals = Vec::with_capacity(values.len());
    let lower = match bounded {
        Some(n) => lower_bounds(&values[rigid..n], &energies, rigid, separation(n)),
        None => Vec::new(),
    };
    let mut least = 0.0_f64;
    let eigenvalues: Vec<f64> = match &refined {
        // What is 0 is exact, and no other frequency may be the root of a negative rounding.
        Some((values, _)) => {
            let unshifted =
                |(value, given): (&f64, &f64)| if *given == 0.0 { 0.0 } else { maximum(value - shift, 0.0) };
            values.iter().zip(ritz).map(unshifted).collect()
        }
        None => ritz.to_vec(),
    };
    for (mode, (&value, rounding)) in eigenvalues.iter().zip(&rounding).enumerate() {
        if ritz[mode] == 0.0 {
            intervals.push(Interval { lower: 0.0, upper: 0.0 });
            continue;
        }
        // Without a bound of its own a mode is at least where the one before it is.
        if let Some(bound) = mode.checked_sub(rigid).and_then(|index| lower.get(index)) {
            least = least.max(bound.min(values[mode]) - shift - rounding);
        }
        intervals.push(Interval { lower: least.max(0.0), upper: value + rounding });
    }
    let separation = bounded.map(|n| separation(n) - shift);
    Some(Bounds { eigenvalues, intervals, separation })
}

/// Ritz values and fields of sums of the modes, from energies of their fields, where those differ from
/// the values given: the matrices of very many functions of very unlike stiffness lose digits that
/// sums of squares along the span keep.
fn refined(grid: &Grid, fields: &Fields, values: &[f64], speed_squared: f64) -> Option<(Vec<f64>, Fields)> {
    let energies = Energies::new(grid, fields);
    let mut g = energies.elastic + energies.centrifugal * speed_squared;
    if let RootCondition::Spring(spring) = grid.condition() {
        let rotation = DVector::from_column_slice(&energies.root_rotation);
        g.ger(spring, &rotation, &rotation, 1.0);
    }
    let differs = |(mode, value): (usize, &f64)| {
        (g[(mode, mode)] / energies.inertia[(mode, mode)] - value).abs() > UNSOUND * value
    };
    if !values.iter().enumerate().any(differs) {
        return None;
    }
    let found = lowest(&g, &energies.inertia, values.len()).ok()?;
    (found.values.len() == values.len()).then(|| (found.values, fields.combined(&found.vectors)))
}

/// Lower bounds ρ s/(1 + s) of eigenvalues below ρ. With x = λ/ρ the matrices of the method,
/// A0 − ρ A1 and A0 − 2ρ A1 + ρ² A2, become after scaling −diag(x/(1 − x)) and I + N,
/// N_ij = √(λ_i λ_j) E_ij / ((1 − x_i)(1 − x_j)), with E the complementary energies of the
/// residual moments: nothing cancels, and where those vanish so does the distance of the bounds. s = −t.
///
/// Modes that lie far below the rest come after them, with the lowest bound of the rest as their ρ.
fn lower_bounds(values: &[f64], energies: &DMatrix<f64>, first: usize, separation: f64) -> Vec<f64> {
    let n = values.len();
    let ratio = |value: f64| value / (separation - value);
    let far = values.iter().take_while(|value| ratio(**value) < SPREAD * ratio(values[n - 1])).count();
    let scale = |i: usize| sqrt(values[i]) / (1.0 - values[i] / separation);
    let g = DMatrix::from_fn(n - far, n - far, |i, j| {
        let own = if i == j { 1.0 } else { 0.0 };
        own + scale(far + i) * scale(far + j) * energies[(first + far + i, first + far + j)]
    });
    let m = DMatrix::from_diagonal(&DVector::from_fn(n - far, |i, _| ratio(values[far + i])));
    // (I + N) z = (1/s) diag(x/(1 − x)) z; the highest mode has the smallest 1/s.
    let Ok(eigen) = lowest(&g, &m, n - far) else { return vec![0.0; n] };
    let mut bounds: Vec<f64> = eigen.values.iter().rev().map(|inverse| separation / (1.0 + inverse)).collect();
    if far > 0 {
        let next = bounds[0];
        let below =
            if next > values[far - 1] { lower_bounds(&values[..far], energies, first, next) } else { vec![0.0; far] };
        bounds.splice(..0, below);
    }
    bounds
}

/// How far rounding may have moved each eigenvalue: that of the sums of squares, how far the eigenvalue
/// lies from the Rayleigh quotient of its own fields, and what the stiffness at the points owes to the
/// rounding of their radii. Where it tapers by many decades within a hair, that is all there is of it.
fn rounding(grid: &Grid, fields: &Fields, values: &[f64], speed_squared: f64) -> Vec<f64> {
    let points = grid.len();
    let uncertain: Vec<f64> = grid.panels().iter().flat_map(|panel| uncertainty(grid, panel)).collect();
    let energy = |a: &DMatrix<f64>, mode: usize, property: &[f64]| -> f64 {
        let column = &a.as_slice()[mode * points..(mode + 1) * points];
        grid.weight().iter().zip(property).zip(column).map(|((w, p), v)| w * p * v * v).sum()
    };
    values
        .iter()
        .enumerate()
        .map(|(mode, &value)| {
            let mut potential = energy(&fields.strain, mode, grid.elastic())
                + speed_squared * energy(&fields.rotation, mode, grid.centrifugal());
            if let RootCondition::Spring(spring) = grid.condition() {
                potential += spring * fields.root_rotation[mode] * fields.root_rotation[mode];
            }
            let inertia = energy(&fields.displacement, mode, grid.inertia());
            let quotient = potential / inertia;
            let of_radii = energy(&fields.strain, mode, &uncertain) / inertia;
            // The room to spare has enough for an ordinary taper.
            let of_radii = if of_radii > 0.1 * ROUNDING * value { of_radii } else { 0.0 };
            ROUNDING * value + (quotient - value).abs() + of_radii
        })
        .collect()
}

/// How far the stiffness at each point of a panel and of its point masses may be off because its radius is rounded.
fn uncertainty(grid: &Grid, panel: &Panel) -> Vec<f64> {
    let points = panel.points.clone();
    let elastic = &grid.elastic()[points.clone()];
    let (Some(first), Some(last)) = (elastic.first(), elastic.last()) else { return Vec::new() };
    // The stiffness is linear within a panel, and its outer points are near its ends.
    let slope = 2.0 * (last - first).abs() / (panel.to - panel.from);
    let along = grid.radius()[points].iter().map(|r| 2.0 * f64::EPSILON * r * slope);
    along.chain(panel.lump.map(|_| 0.0)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dof::Dof;
    use crate::functions::{Deformation, Mesh, PiecewiseFunctions};
    use crate::lagrange::assemble;
    use crate::lagrange::tests::{cantilever, clamped};
    use crate::modes::solve;
    use crate::numerics::quadrature::GaussRules;

    /// Bounds of three modes of the uniform cantilever from `order` polynomials over the whole span.
    fn of_polynomials(order: usize, margin: f64) -> Option<Bounds> {
        let (blade, rules) = (clamped(0.5), GaussRules::new());
        let mesh = Mesh::new(vec![0.0, 1.5], vec![order]);
        let identity = DMatrix::identity(order, order);
        let functions = PiecewiseFunctions::new(mesh, Deformation::Bending, false, identity);
        let grid = Grid::for_functions(&blade, Dof::Flap, &functions, &rules, 8, &[]);
        let fields = Fields::sample(&grid, &functions);
        let modes = solve(&assemble(&grid, Energies::new(&grid, &fields), false), 0.0, 3).unwrap();
        let q = DMatrix::from_fn(order, 3, |i, j| modes[j].coordinates[i]);
        let ritz: Vec<f64> = modes.iter().map(|mode| mode.eigenvalue).collect();
        let reference = Reference { eigenvalues: (0..4).map(|mode| cantilever(mode, 1.5)).collect(), margin };
        bounds(&grid, &FromTip::new(&grid, &rules), &fields.combined(&q), &ritz, &reference, 0.0, 1.0)
    }

    /// z = 1.8751…, 4.6941…, 7.8548… (Roark). Five polynomials or more, with ever smaller gaps.
    #[test]
    fn the_eigenvalues_of_a_cantilever_lie_within() {
        let mut widest = f64::INFINITY;
        for order in [5, 6, 8, 12] {
            let found = of_polynomials(order, 1e-6).unwrap();
            let mut width = 0.0_f64;
            for (mode, interval) in found.intervals.iter().enumerate() {
                let exact = cantilever(mode, 1.5);
                // The exact value itself is rounded, by its fourth power.
                let rounding = 4e-15 * exact;
                assert!(interval.lower <= exact + rounding, "order {order}, mode {mode}: {interval:?} {exact}");
                assert!(interval.upper >= exact - rounding, "order {order}, mode {mode}: {interval:?} {exact}");
                assert!(interval.lower > 0.5 * exact, "order {order}, mode {mode}: a bound of its own");
                width = width.max(interval.upper / interval.lower - 1.0);
            }
            assert!(width < widest, "order {order}: {width:e} after {widest:e}");
            widest = width;
            let separation = found.separation.unwrap();
            assert!(separation > cantilever(2, 1.5) && separation < cantilever(3, 1.5));
        }
        assert!(widest < 1e-8, "twelve polynomials: {widest:e}");
    }

    #[test]
    fn without_a_margin_there_are_no_bounds() {
        assert_eq!(of_polynomials(6, 1.0), None);
        assert_eq!(of_polynomials(6, f64::INFINITY), None);
        // A separation must stand below λ₄ by more than the margin: 0.2 of the gap is 0.148 of λ₄, so
        // the third mode has no bound of its own; below λ₃ it is 0.175 of it, so the second has.
        let found = of_polynomials(6, 0.16).unwrap();
        assert!(found.separation.unwrap() < cantilever(2, 1.5));
        assert_eq!(found.intervals[2].lower, found.intervals[1].lower);
    }

    /// Without complementary energy the bounds are the values, however far they lie apart.
    #[test]
    fn exact_modes_are_their_own_lower_bounds() {
        let values = [1e-15, 3.0, 4.0];
        let found = lower_bounds(&values, &DMatrix::zeros(3, 3), 0, 9.0);
        for (bound, value) in found.iter().zip(values) {
            // ρ s/(1 + s) of a rounded s.
            assert!((bound / value - 1.0).abs() < 4e-15, "{bound} {value}");
        }
    }

    /// One mode: with E the complementary energy, s = x (1 − x)/((1 − x)² + λE), the bound is ρ s/(1 + s).
    #[test]
    fn one_mode_has_the_bound_of_a_quotient() {
        let (value, energy, separation) = (2.0, 0.01, 5.0);
        let x: f64 = value / separation;
        let s = x * (1.0 - x) / ((1.0 - x).powi(2) + value * energy);
        let found = lower_bounds(&[value], &DMatrix::from_element(1, 1, energy), 0, separation);
        // A few roundings.
        assert!((found[0] - separation * s / (1.0 + s)).abs() < 4e-15, "{found:?}");
    }
}
