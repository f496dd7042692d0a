//! Exact frequencies of a blade by shooting, for comparison. Shares no code and no idea with the
//! product: no assumed functions, no matrices. The differential equations are integrated from the
//! free tip to the root by Taylor series on short panels; a frequency is a zero of what the root
//! condition leaves.
//!
//! Bending: w′ = s, EI s′ = M, M′ = V + Ω² T s, V′ = λ m w with λ = ω² in flap, ω² + Ω² in lag;
//! torsion: GJ θ′ = Q, Q′ = (Ω² m Y² − ω² ρI) θ.
//!
//! All of it in f64, or with twice its digits where a blade asks for them ([`Real`]).

mod panels;
mod real;

use crate::blades::{End, Hold, TestBlade};
use bladefan_core::Dof;
pub(crate) use panels::Panel;
pub use real::{Double, Real};

/// Terms of each Taylor series. With panels of at most [`panels::REACH`] characteristic lengths the
/// last terms are below 1e-30.
const TERMS: usize = 30;

/// One degree of freedom of one blade, ready to be shot at.
#[derive(Clone, Debug)]
pub struct Exact<T> {
    pub(crate) dof: Dof,
    pub(crate) root: End,
    /// From the tip inward.
    pub(crate) panels: Vec<Panel<T>>,
}

/// Displacement and slope, moment and force: (w, s, M, V).
pub(crate) type State<T> = [T; 4];

impl<T: Real> Exact<T> {
    /// Prepares one degree of freedom; frequencies up to `highest` [rad/s] at speeds up to
    /// `speed` [rad/s] can then be found.
    pub fn new(blade: &TestBlade, dof: Dof, speed: f64, highest: f64) -> Self {
        Self::within(blade, dof, speed, highest, usize::MAX).unwrap()
    }

    /// The same, where `most` panels are enough.
    pub fn within(blade: &TestBlade, dof: Dof, speed: f64, highest: f64, most: usize) -> Option<Self> {
        let panels = panels::of(blade, dof, speed, highest, most)?;
        Some(Self { dof, root: blade.roots[dof.index()], panels })
    }

    /// What the root condition leaves at this frequency, between −1 and 1; zero at an eigenvalue.
    pub fn mismatch(&self, speed: f64, frequency: f64) -> f64 {
        if self.dof == Dof::Torsion { self.twisting(speed, frequency) } else { self.bending(speed, frequency) }
    }

    fn twisting(&self, speed: f64, frequency: f64) -> f64 {
        let (pull, square) = (T::of(speed) * T::of(speed), T::of(frequency) * T::of(frequency));
        let mut state = [T::of(1.0), T::of(0.0)];
        for panel in &self.panels {
            state = panel.twist(pull, square, state);
        }
        let [theta, torque] = state;
        let unit = self.root_panel().scale[2];
        match self.root.hold {
            Hold::Clamped => theta.near(),
            Hold::Free => torque.near() / unit,
            Hold::Spring(k) => (torque - T::of(k) * theta).near() / unit.max(k),
        }
    }

    fn bending(&self, speed: f64, frequency: f64) -> f64 {
        let pull = T::of(speed) * T::of(speed);
        let square = T::of(frequency) * T::of(frequency);
        let load = if self.dof == Dof::Lag { square + pull } else { square };
        let mut states = free_tip();
        for panel in &self.panels {
            states = states.map(|state| panel.advance(pull, load, state));
            orthonormalise(&mut states, &panel.scale);
        }
        let unit = self.root_panel().scale;
        let [a, b] = states.map(|state| over(state, &unit));
        let condition = |s: &State<T>| match self.root.hold {
            Hold::Clamped => s[1],
            Hold::Free => s[2],
            Hold::Spring(k) => (s[2] * T::of(unit[2]) - T::of(k) * s[1]) * T::of(1.0 / unit[2].max(k)),
        };
        (a[0] * condition(&b) - b[0] * condition(&a)).near()
    }

    pub(crate) fn root_panel(&self) -> &Panel<T> {
        self.panels.last().unwrap()
    }

    /// Every frequency up to `highest` [rad/s], ascending, found on a grid of `samples` intervals
    /// and bisected to the last bit. At rest a free root has the frequency 0, which is not listed.
    pub fn frequencies(&self, speed: f64, highest: f64, samples: usize) -> Vec<f64> {
        let mut found = Vec::new();
        let at = |i: usize| highest * i.max(1) as f64 / samples as f64 * if i == 0 { 1e-6 } else { 1.0 };
        let mut low = (at(0), self.mismatch(speed, at(0)));
        for i in 1..=samples {
            let high = (at(i), self.mismatch(speed, at(i)));
            if (low.1 < 0.0) != (high.1 < 0.0) {
                let (mut a, mut b) = (low.0, high.0);
                for _ in 0..60 {
                    let middle = 0.5 * (a + b);
                    if (self.mismatch(speed, middle) < 0.0) == (low.1 < 0.0) {
                        a = middle;
                    } else {
                        b = middle;
                    }
                }
                found.push(0.5 * (a + b));
            }
            low = high;
        }
        found
    }
}

/// Exact frequencies of one degree of freedom up to `highest` [rad/s].
pub fn frequencies(blade: &TestBlade, dof: Dof, speed: f64, highest: f64) -> Vec<f64> {
    Exact::<f64>::new(blade, dof, speed, highest).frequencies(speed, highest, 160)
}

/// Two motions that leave the tip free.
pub(crate) fn free_tip<T: Real>() -> [State<T>; 2] {
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]].map(|state| state.map(T::of))
}

/// A state in units of a panel's scales, which are powers of two: nothing is rounded.
pub(crate) fn over<T: Real>(state: State<T>, scale: &[f64; 4]) -> State<T> {
    core::array::from_fn(|i| state[i] * T::of(1.0 / scale[i]))
}

/// The way back.
pub(crate) fn times<T: Real>(state: State<T>, scale: &[f64; 4]) -> State<T> {
    core::array::from_fn(|i| state[i] * T::of(scale[i]))
}

/// Gram–Schmidt in units of a panel's scales, with positive factors: the determinant keeps its sign
/// and its digits.
pub(crate) fn orthonormalise<T: Real>(states: &mut [State<T>; 2], scale: &[f64; 4]) {
    let dot = |x: &State<T>, y: &State<T>| x.iter().zip(y).fold(T::of(0.0), |sum, (x, y)| sum + *x * *y);
    let unit = |v: State<T>| {
        let size = T::of(1.0 / dot(&v, &v).near().sqrt());
        v.map(|x| x * size)
    };
    let [a, b] = states.map(|state| over(state, scale));
    let a = unit(a);
    let mut b = unit(b);
    for _ in 0..2 {
        let along = dot(&a, &b) / dot(&a, &a);
        b.iter_mut().zip(a).for_each(|(v, u)| *v = *v - along * u);
    }
    *states = [times(a, scale), times(unit(b), scale)];
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blades::{End, Table};

    /// Agreement asked of the shooting itself: a few hundred roundings.
    const ROUNDING: f64 = 2e-11;

    fn assert_near(found: &[f64], expected: &[f64]) {
        assert!(found.len() >= expected.len(), "{found:?}");
        for (f, e) in found.iter().zip(expected) {
            assert!((f / e - 1.0).abs() < ROUNDING, "{f} against {e}");
        }
    }

    // Expected values: power series in 40-digit arithmetic (mpmath), as in the analytical tests.
    #[test]
    fn uniform_cantilever() {
        let blade = TestBlade::uniform(1.0);
        assert_near(
            &frequencies(&blade, Dof::Flap, 12.0, 230.0),
            &[
                13.170_150_487_506_18,
                37.603_112_331_191_87,
                79.614_478_489_457_21,
                140.534_354_474_681_3,
                220.536_322_001_501,
            ],
        );
        assert_near(&frequencies(&blade, Dof::Flap, 0.0, 70.0), &[3.516_015_268_500_151, 22.034_491_564_666_77]);
    }

    #[test]
    fn stepped_hingeless_blade() {
        assert_near(
            &frequencies(&TestBlade::stepped(), Dof::Flap, 0.0, 2500.0),
            &[
                51.261_342_728_553_76,
                309.123_053_635_655_4,
                828.445_457_357_597_8,
                1_535.911_869_818_009,
                2_412.891_901_824_022,
            ],
        );
    }

    #[test]
    fn hinged_blade_turns_with_the_rotor() {
        let blade = TestBlade::uniform(1.0).with_root(Dof::Flap, End::free(0.0));
        assert_near(&frequencies(&blade, Dof::Flap, 12.0, 40.0), &[12.0, 33.760_301_346_797_75]);
    }

    #[test]
    fn springs_and_torsion() {
        let mut blade = TestBlade::uniform(2.0).with_root(Dof::Flap, End::spring(0.0, 30.0));
        blade.stiffness = [Table::uniform(50.0), Table::uniform(50.0), Table::uniform(7.0)];
        blade.roots[2] = End::spring(0.0, 3.0);
        assert_near(&frequencies(&blade, Dof::Flap, 0.0, 100.0), &[2.959_236_123_499_782, 28.978_680_210_944_11]);
        assert_near(&frequencies(&blade, Dof::Torsion, 0.0, 10.0), &[1.074_533_124_175_337, 4.483_617_241_199_461]);
    }

    #[test]
    fn linear_taper_is_not_its_steps() {
        // m and EI both 1 − x/2: ascending Frobenius values, 40 digits (mpmath), Ω = 5.
        let taper = Table { r: vec![0.0, 1.0], y: vec![1.0, 0.5] };
        let mut blade = TestBlade::uniform(1.0).with_stiffness(Dof::Flap, taper.clone());
        blade.mass = taper;
        assert_near(
            &frequencies(&blade, Dof::Flap, 5.0, 70.0),
            &[6.961_935_457_856_06, 26.368_706_094_150_77, 66.065_745_449_606_59],
        );
    }
}
