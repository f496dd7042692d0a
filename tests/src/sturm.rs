//! How many eigenvalues lie below a number, by the independent solution of
//! [`exact`](crate::exact): no eigenvalue is looked for, so none can be missed, however close two
//! of them lie.
//!
//! Cut the blade into panels so short that none of them, held at both ends, vibrates below the
//! number. Then the eigenvalues below it are as many as the negative pivots of the dynamic stiffness
//! of the nodes, eliminated from the tip inward (Wittrick & Williams, Q. J. Mech. Appl. Math. 24,
//! 1971). With U the displacement and slope of two solutions that leave the tip free, and T the
//! panel's displacements for unit forces at its outer end, the pivot of the outer node is congruent
//! to U₁ U₀⁻¹ Tᵀ, in which nothing is divided by the length of a panel.

use crate::blades::Hold;
use crate::exact::{Exact, advance, orthonormalise};
use bladefan_core::dof::Dof;

impl Exact {
    /// Number of eigenvalues ω² below `square` [rad²/s²], among them the 0 of a free root at rest.
    pub fn count_below(&self, speed: f64, square: f64) -> usize {
        if self.dof == Dof::Torsion { self.count_twisting(speed, square) } else { self.count_bending(speed, square) }
    }

    /// The eigenvalue ω² of this number, from 1, bisected by counting: slow, but it cannot be
    /// mistaken for another. The panels must be short enough for it.
    pub fn eigenvalue(&self, speed: f64, number: usize) -> f64 {
        let (mut low, mut high) = (0.0, 1.0);
        while self.count_below(speed, high) < number && high < 1e30 {
            (low, high) = (high, 4.0 * high);
        }
        for _ in 0..150 {
            let middle = 0.5 * (low + high);
            if self.count_below(speed, middle) < number {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    fn count_twisting(&self, speed: f64, square: f64) -> usize {
        let (mut theta, mut torque, mut count) = (1.0_f64, 0.0_f64, 0);
        for panel in &self.panels {
            let before = theta;
            (theta, torque) = self.twist(panel, speed, square, theta, torque);
            count += usize::from((before < 0.0) != (theta < 0.0));
        }
        count + self.turning_root(theta, torque * self.scale[2])
    }

    fn count_bending(&self, speed: f64, square: f64) -> usize {
        let pull = speed * speed;
        let load = square + if self.dof == Dof::Lag { pull } else { 0.0 };
        let mut states = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]];
        let mut count = 0;
        for panel in &self.panels {
            let carry = |state: [f64; 4]| {
                let mut state = state;
                state.iter_mut().zip(self.scale).for_each(|(v, scale)| *v *= scale);
                let mut after = advance(panel, pull, load, state);
                after.iter_mut().zip(self.scale).for_each(|(v, scale)| *v /= scale);
                after
            };
            let [a, b] = states;
            // Unit forces against w and w′, of the signs that make N positive.
            let forces = [carry([0.0, 0.0, 0.0, 1.0]), carry([0.0, 0.0, -1.0, 0.0])];
            states = states.map(carry);
            // N = U₁ U₀⁻¹ Tᵀ, positive definite without inertia; columns of U are the two states.
            let u0 = a[0] * b[1] - b[0] * a[1];
            let [c, d] = states;
            let mut n = [[0.0; 2]; 2];
            for (i, row) in n.iter_mut().enumerate() {
                let (first, second) = ((c[i] * b[1] - d[i] * a[1]) / u0, (d[i] * a[0] - c[i] * b[0]) / u0);
                for (j, entry) in row.iter_mut().enumerate() {
                    *entry = first * forces[0][j] + second * forces[1][j];
                }
            }
            count += negative(n);
            orthonormalise(&mut states);
        }
        let [a, b] = states;
        // The motion that leaves the root where it is.
        let at = |i: usize| a[i] * b[0] - b[i] * a[0];
        count + self.turning_root(at(1) * self.scale[1], at(2) * self.scale[2])
    }

    /// 1 where the root may turn and its own pivot is negative.
    fn turning_root(&self, turn: f64, moment: f64) -> usize {
        match self.root.hold {
            Hold::Clamped => 0,
            Hold::Free => usize::from(-moment / turn < 0.0),
            Hold::Spring(k) => usize::from(k - moment / turn < 0.0),
        }
    }
}

/// Negative eigenvalues of a symmetric matrix.
fn negative([[a, b], [c, d]]: [[f64; 2]; 2]) -> usize {
    if a * d - b * c < 0.0 {
        1
    } else if a + d < 0.0 {
        2
    } else {
        0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blades::{End, TestBlade};

    /// Below and above each known value; the panels must suit the highest.
    fn assert_counted(blade: &TestBlade, dof: Dof, speed: f64, known: &[f64]) {
        let exact = Exact::new(blade, dof, speed, 2.0 * known.last().unwrap());
        for (i, f) in known.iter().enumerate() {
            let counts = [1.0 - 1e-9, 1.0 + 1e-9].map(|factor| exact.count_below(speed, (f * factor).powi(2)));
            assert_eq!(counts, [i, i + 1], "{dof} at {speed}, around {f}");
            assert!((exact.eigenvalue(speed, i + 1).sqrt() / f - 1.0).abs() < 2e-11, "{dof} at {speed}, {f}");
        }
    }

    // Values: those of the tests of the shooting itself.
    #[test]
    fn known_eigenvalues_are_counted() {
        let uniform = TestBlade::uniform(1.0);
        assert_counted(
            &uniform,
            Dof::Flap,
            12.0,
            &[13.170_150_487_506_18, 37.603_112_331_191_87, 79.614_478_489_457_21],
        );
        let hinged = uniform.with_root(Dof::Flap, End::free(0.0));
        assert_counted(&hinged, Dof::Flap, 12.0, &[12.0, 33.760_301_346_797_75]);
        let stepped = [51.261_342_728_553_76, 309.123_053_635_655_4, 828.445_457_357_597_8];
        assert_counted(&TestBlade::stepped(), Dof::Flap, 0.0, &stepped);
        let twisting = [0.5, 1.5, 2.5].map(|i: f64| i * core::f64::consts::PI);
        assert_counted(&TestBlade::uniform(1.0), Dof::Torsion, 0.0, &twisting);
    }

    #[test]
    fn a_free_root_at_rest_counts() {
        let blade =
            TestBlade::uniform(1.0).with_root(Dof::Flap, End::free(0.0)).with_root(Dof::Torsion, End::spring(0.0, 0.0));
        for dof in [Dof::Flap, Dof::Torsion] {
            let exact = Exact::new(&blade, dof, 0.0, 10.0);
            assert_eq!([-1e-6, 1e-6].map(|square| exact.count_below(0.0, square)), [0, 1], "{dof}");
        }
    }
}
