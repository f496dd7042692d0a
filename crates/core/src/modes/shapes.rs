//! Mode shapes along the span (Eq. 83), scaled and signed.

use super::Mode;
use crate::dof::Dof;
use crate::lagrange::ShapeTables;
use crate::numerics::scalar::{maximum, sqrt};
use alloc::vec::Vec;
use nalgebra::{DMatrix, DVector};

/// One mode along the span, positive at the tip of its first component: flap up, lag forward, nose up.
#[derive(Clone, Debug)]
pub struct Shape {
    /// One per degree of freedom of the system.
    pub components: Vec<Component>,
}

/// What a mode does in one degree of freedom.
#[derive(Clone, Debug)]
pub struct Component {
    /// The degree of freedom.
    pub dof: Dof,
    /// Displacement or twist at each radius.
    pub displacement: Vec<f64>,
    /// Slope [1/m].
    pub slope: Vec<f64>,
    /// Bending or twisting moment [N·m per unit of displacement].
    pub moment: Vec<f64>,
}

/// The shapes of modes at Ω² = `speed_squared`, scaled to qᵀ N q = 1 where N = `norm` is given (M
/// makes that Eq. 86), else to a largest absolute displacement of 1 among the sampled radii.
/// `tables` holds one table per degree of freedom, whose functions follow one another in q.
pub fn shapes(tables: &[ShapeTables], modes: &[Mode], speed_squared: f64, norm: Option<&DMatrix<f64>>) -> Vec<Shape> {
    modes.iter().map(|mode| shape(tables, mode, speed_squared, norm)).collect()
}

/// For each mode the largest |q_iᵀ M q_j| with another one (Eq. 84–85): 0 but for rounding.
pub fn orthogonality(mass: &DMatrix<f64>, modes: &[Mode]) -> Vec<f64> {
    let of_mode = |(i, mode): (usize, &Mode)| {
        let loaded = mass * &mode.coordinates;
        let others = modes.iter().enumerate().filter(|&(j, _)| j != i);
        others.map(|(_, other)| other.coordinates.dot(&loaded).abs()).fold(0.0, maximum)
    };
    modes.iter().enumerate().map(of_mode).collect()
}

fn shape(tables: &[ShapeTables], mode: &Mode, speed_squared: f64, norm: Option<&DMatrix<f64>>) -> Shape {
    let q = &mode.coordinates;
    let mut first = 0;
    let parts: Vec<(&ShapeTables, DVector<f64>)> = tables
        .iter()
        .map(|table| {
            let own = q.rows(first, table.value.ncols()).into_owned();
            first += own.len();
            (table, own)
        })
        .collect();
    let displacements: Vec<DVector<f64>> = parts.iter().map(|(table, own)| &table.value * own).collect();
    let largest = || displacements.iter().map(DVector::amax).fold(0.0, f64::max);
    let size = norm.map_or_else(largest, |norm| sqrt(q.dot(&(norm * q))));
    let tip = displacements.first().and_then(|displacement| displacement.iter().next_back());
    let sign = if tip.is_some_and(|&tip| tip < 0.0) { -1.0 } else { 1.0 };
    // Divided, not multiplied by an inverse: the largest displacement is 1 to the bit.
    let along = |vector: &DVector<f64>| vector.iter().map(|&v| sign * v / size).collect();
    let components = parts.iter().zip(&displacements).map(|((table, own), displacement)| {
        let moment = &table.inertial * own * mode.eigenvalue - &table.centrifugal * own * speed_squared;
        Component {
            dof: table.dof,
            displacement: along(displacement),
            slope: along(&(&table.slope * own)),
            moment: along(&moment),
        }
    });
    Shape { components: components.collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two radii; one function of the first degree of freedom, two of the second.
    fn tables() -> [ShapeTables; 2] {
        let table = |dof, value: &[f64]| {
            let columns = value.len() / 2;
            let value = DMatrix::from_column_slice(2, columns, value);
            ShapeTables { dof, slope: &value * 2.0, inertial: &value * 8.0, centrifugal: &value * 4.0, value }
        };
        [table(Dof::Flap, &[0.5, 1.0]), table(Dof::Torsion, &[1.0, 2.0, 0.0, 4.0])]
    }

    fn mode(eigenvalue: f64, coordinates: &[f64]) -> Mode {
        let coordinates = DVector::from_column_slice(coordinates);
        Mode { eigenvalue, frequency: sqrt(eigenvalue), coordinates, southwell: 0.0, residual: 0.0 }
    }

    /// q = (−2, 1, 0.5): flap is (−1, −2), torsion (1, 4). All numbers are sums of powers of two.
    #[test]
    fn a_shape_is_scaled_to_one_and_turned_up_at_the_tip() {
        let found = shapes(&tables(), &[mode(3.0, &[-2.0, 1.0, 0.5])], 5.0, None);
        let [flap, torsion] = &found[0].components[..] else { panic!("two components") };
        assert_eq!((flap.dof, torsion.dof), (Dof::Flap, Dof::Torsion));
        // The largest of both is 4, and the tip of the first points down.
        assert_eq!(flap.displacement, [0.25, 0.5]);
        assert_eq!(torsion.displacement, [-0.25, -1.0]);
        assert_eq!(flap.slope, [0.5, 1.0]);
        assert_eq!(torsion.slope, [-0.5, -2.0]);
        // λ · 8 − Ω² · 4 = 4 times the displacement.
        assert_eq!(flap.moment, [1.0, 2.0]);
        assert_eq!(torsion.moment, [-1.0, -4.0]);
    }

    #[test]
    fn a_norm_takes_the_place_of_the_largest_displacement() {
        let norm = DMatrix::from_diagonal(&DVector::from_column_slice(&[4.0, 0.0, 0.0]));
        // √(4 · 2²) = 4.
        let found = shapes(&tables(), &[mode(3.0, &[2.0, 1.0, 0.5])], 0.0, Some(&norm));
        assert_eq!(found[0].components[0].displacement, [0.25, 0.5]);
        assert_eq!(found[0].components[1].displacement, [0.25, 1.0]);
        // λ · 8 at rest.
        assert_eq!(found[0].components[0].moment, [6.0, 12.0]);
    }

    #[test]
    fn each_mode_is_held_against_all_others() {
        let modes = [mode(1.0, &[1.0, 0.0]), mode(2.0, &[0.0, 1.0]), mode(3.0, &[0.25, -0.5])];
        let mass = DMatrix::from_diagonal(&DVector::from_column_slice(&[1.0, 4.0]));
        assert_eq!(orthogonality(&mass, &modes), [0.25, 2.0, 2.0]);
        assert_eq!(orthogonality(&mass, &modes[..1]), [0.0], "alone");
    }
}
