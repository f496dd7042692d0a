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
use crate::exact::{Exact, Real, free_tip, orthonormalise, over};
use bladefan_core::Dof;

impl<T: Real> Exact<T> {
    /// Number of eigenvalues ω² below `square` [rad²/s²], among them the 0 of a free root at rest.
    pub fn count_below(&self, speed: f64, square: T) -> usize {
        self.try_count_below(speed, square).unwrap()
    }

    /// The same; nothing where the numbers on the way are too large or too small.
    pub fn try_count_below(&self, speed: f64, square: T) -> Option<usize> {
        if self.dof == Dof::Torsion { self.count_twisting(speed, square) } else { self.count_bending(speed, square) }
    }

    /// The eigenvalue ω² of this number, from 1, bisected by counting: slow, but it cannot be
    /// mistaken for another. The panels must be short enough for it.
    pub fn eigenvalue(&self, speed: f64, number: usize) -> f64 {
        let (mut low, mut high) = (0.0, 1.0);
        while self.count_below(speed, T::of(high)) < number && high < 1e200 {
            (low, high) = (high, 4.0 * high);
        }
        for _ in 0..150 {
            let middle = 0.5 * (low + high);
            if self.count_below(speed, T::of(middle)) < number {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    fn count_twisting(&self, speed: f64, square: T) -> Option<usize> {
        let pull = T::of(speed) * T::of(speed);
        let (mut state, mut count) = ([T::of(1.0), T::of(0.0)], 0);
        let zero = T::of(0.0);
        for panel in &self.panels {
            let before = state[0];
            state = panel.twist(pull, square, state);
            count += usize::from((before < zero) != (state[0] < zero));
        }
        Some(count + self.turning_root(state[0], state[1])?)
    }

    fn count_bending(&self, speed: f64, square: T) -> Option<usize> {
        let pull = T::of(speed) * T::of(speed);
        let load = if self.dof == Dof::Lag { square + pull } else { square };
        let mut states = free_tip();
        let mut count = 0;
        for panel in &self.panels {
            orthonormalise(&mut states, &panel.scale);
            let [a, b] = states.map(|state| over(state, &panel.scale));
            let forces = panel.yielding(pull, load);
            states = states.map(|state| panel.advance(pull, load, state));
            // N = U₁ U₀⁻¹ Tᵀ, positive definite without inertia; columns of U are the two states.
            let u0 = a[0] * b[1] - b[0] * a[1];
            let [c, d] = states.map(|state| over(state, &panel.scale));
            let n: [[T; 2]; 2] = core::array::from_fn(|i| {
                let (first, second) = ((c[i] * b[1] - d[i] * a[1]) / u0, (d[i] * a[0] - c[i] * b[0]) / u0);
                core::array::from_fn(|j| first * forces[0][j] + second * forces[1][j])
            });
            count += negative(n)?;
        }
        let scale = &self.root_panel().scale;
        orthonormalise(&mut states, scale);
        let [a, b] = states;
        // The motion that leaves the root where it is.
        let at = |i: usize| a[i] * b[0] - b[i] * a[0];
        Some(count + self.turning_root(at(1), at(2))?)
    }

    /// 1 where the root may turn and its own pivot is negative.
    fn turning_root(&self, turn: T, moment: T) -> Option<usize> {
        let pivot = match self.root.hold {
            Hold::Clamped => return turn.near().is_finite().then_some(0),
            Hold::Free => -moment / turn,
            Hold::Spring(k) => T::of(k) - moment / turn,
        };
        pivot.near().is_finite().then(|| usize::from(pivot < T::of(0.0)))
    }
}

/// Negative eigenvalues of a symmetric matrix.
fn negative<T: Real>([[a, b], [c, d]]: [[T; 2]; 2]) -> Option<usize> {
    let zero = T::of(0.0);
    let (product, sum) = (a * d - b * c, a + d);
    let count = match (product < zero, sum < zero) {
        (true, _) => 1,
        (false, true) => 2,
        (false, false) => 0,
    };
    (product.near().is_finite() && sum.near().is_finite()).then_some(count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blades::{End, TestBlade};
    use crate::exact::Double;

    /// Below and above each known value; the panels must suit the highest.
    fn assert_counted(blade: &TestBlade, dof: Dof, speed: f64, known: &[f64]) {
        let exact = Exact::<f64>::new(blade, dof, speed, 2.0 * known.last().unwrap());
        let precise = Exact::<Double>::new(blade, dof, speed, 2.0 * known.last().unwrap());
        for (i, f) in known.iter().enumerate() {
            let counts = [1.0 - 1e-9, 1.0 + 1e-9].map(|factor| exact.count_below(speed, (f * factor).powi(2)));
            assert_eq!(counts, [i, i + 1], "{dof} at {speed}, around {f}");
            let counts = [1.0 - 1e-12, 1.0 + 1e-12]
                .map(|factor| precise.count_below(speed, Double::of(f * factor) * Double::of(f * factor)));
            assert_eq!(counts, [i, i + 1], "{dof} at {speed}, around {f}, with twice the digits");
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
            let exact = Exact::<f64>::new(&blade, dof, 0.0, 10.0);
            assert_eq!([-1e-6, 1e-6].map(|square| exact.count_below(0.0, square)), [0, 1], "{dof}");
        }
    }
}
