//! Exact frequencies of a blade by shooting, for comparison. Shares no code and no idea with the
//! product: no assumed functions, no matrices. The differential equations are integrated from the
//! free tip to the root by Taylor series on short panels; a frequency is a zero of what the root
//! condition leaves.
//!
//! Bending: w′ = s, EI s′ = M, M′ = V + Ω² T s, V′ = λ m w with λ = ω² in flap, ω² + Ω² in lag;
//! torsion: GJ θ′ = Q, Q′ = (Ω² m Y² − ω² ρI) θ.

use crate::blades::{End, Hold, Table, TestBlade};
use bladefan_core::dof::Dof;

/// Terms of each Taylor series. With panels of at most [`REACH`] characteristic lengths the last
/// terms are below 1e-20.
const TERMS: usize = 30;
/// Longest panel in units of the shortest characteristic length of the solution.
const REACH: f64 = 1.0;
/// Longest panel as a part of the distance in which a linear stiffness would reach zero; the
/// Taylor series converge like this to the power [`TERMS`].
const TAPER: f64 = 0.2;

/// A polynomial in the local coordinate, lowest power first.
type Poly = Vec<f64>;

/// A stretch of the blade, coordinate x from its outboard end inward (x ≥ 0).
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    length: f64,
    stiffness: Poly,
    inertia: Poly,
    /// T of bending, or m Y² of torsion.
    centrifugal: Poly,
}

/// One degree of freedom of one blade, ready to be shot at.
#[derive(Clone, Debug)]
pub struct Exact {
    pub(crate) dof: Dof,
    pub(crate) root: End,
    /// From the tip inward.
    pub(crate) panels: Vec<Panel>,
    /// Scales of (displacement, slope, moment, force), so that states can be orthonormalised.
    pub(crate) scale: [f64; 4],
}

fn limits(table: &Table, r: f64) -> (f64, f64) {
    let value_between = |i: usize| {
        let (a, b) = (table.r[i], table.r[i + 1]);
        table.y[i] + (table.y[i + 1] - table.y[i]) * (r - a) / (b - a)
    };
    let last = table.r.len() - 1;
    if r < table.r[0] || last == 0 {
        return (table.y[0], table.y[0]);
    }
    if r > table.r[last] {
        return (table.y[last], table.y[last]);
    }
    let inboard = (0..last).find(|&i| table.r[i] < r && r <= table.r[i + 1]).map_or(table.y[0], value_between);
    let outboard =
        (0..last).rev().find(|&i| table.r[i] <= r && r < table.r[i + 1]).map_or(table.y[last], value_between);
    (inboard, outboard)
}

/// The table on [a, b], which holds none of its radii inside, as a polynomial in x = b − r.
fn segment(table: &Table, a: f64, b: f64) -> Poly {
    let (outer, inner) = (limits(table, b).0, limits(table, a).1);
    vec![outer, (inner - outer) / (b - a)]
}

fn product(p: &[f64], q: &[f64]) -> Poly {
    let mut out = vec![0.0; p.len() + q.len() - 1];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            out[i + j] += a * b;
        }
    }
    out
}

fn integral(p: &[f64]) -> Poly {
    let mut out = vec![0.0];
    out.extend(p.iter().enumerate().map(|(k, c)| c / (k + 1) as f64));
    out
}

fn value(p: &[f64], x: f64) -> f64 {
    p.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// Coefficients about x = `shift` instead of 0.
fn shifted(p: &[f64], shift: f64) -> Poly {
    let mut out = p.to_vec();
    for i in 0..out.len() {
        for j in (i..out.len() - 1).rev() {
            out[j] += shift * out[j + 1];
        }
    }
    out
}

impl Exact {
    /// Prepares one degree of freedom; frequencies up to `highest` [rad/s] at speeds up to
    /// `speed` [rad/s] can then be found.
    pub fn new(blade: &TestBlade, dof: Dof, speed: f64, highest: f64) -> Self {
        let root = blade.roots[dof.index()];
        let stiffness = &blade.stiffness[dof.index()];
        let mut radii: Vec<f64> = [stiffness, &blade.mass, &blade.polar_inertia, &blade.mass_offset]
            .iter()
            .flat_map(|table| table.r.iter().copied())
            .filter(|&r| r > root.offset && r < blade.radius)
            .chain([root.offset, blade.radius])
            .collect();
        radii.sort_by(f64::total_cmp);
        radii.dedup();

        let (mut panels, mut tension) = (Vec::new(), 0.0);
        let (mut softest, mut stiffest) = (f64::INFINITY, 0.0_f64);
        for ends in radii.windows(2).rev() {
            let (a, b) = (ends[0], ends[1]);
            let stiff = segment(stiffness, a, b);
            let mass = segment(&blade.mass, a, b);
            let offset = segment(&blade.mass_offset, a, b);
            // T(x) = T(b) + ∫ m (b − x) dx, x inward from b.
            let mut pull = integral(&product(&mass, &[b, -1.0]));
            pull[0] = tension;
            tension = value(&pull, b - a);
            let (inertia, centrifugal) = match dof {
                Dof::Torsion => (segment(&blade.polar_inertia, a, b), product(&mass, &product(&offset, &offset))),
                Dof::Flap | Dof::Lag => (mass, pull),
            };
            let least = stiff[0].min(value(&stiff, b - a));
            (softest, stiffest) = (softest.min(least), stiffest.max(stiff[0]));
            let heaviest = inertia[0].max(value(&inertia, b - a));
            let shortest = match dof {
                Dof::Torsion => {
                    let pulled = speed * speed * centrifugal[0].max(value(&centrifugal, b - a));
                    (least / (highest * highest * heaviest + pulled + f64::MIN_POSITIVE)).sqrt()
                }
                Dof::Flap | Dof::Lag => {
                    let wave = ((highest * highest + speed * speed) * heaviest / least).powf(0.25);
                    let pulled = (speed * speed * tension / least).sqrt();
                    1.0 / (wave + pulled + f64::MIN_POSITIVE)
                }
            };
            // From the tip inward in panels short against wave, tension layer and taper.
            let mut x = 0.0;
            while x < b - a {
                let here = value(&stiff, x);
                let taper = TAPER * here / stiff[1].abs().max(f64::MIN_POSITIVE);
                let mut length = (REACH * shortest).min(taper).min(b - a - x);
                if b - a - x - length < 1e-9 * (b - a) {
                    length = b - a - x;
                }
                panels.push(Panel {
                    length,
                    stiffness: shifted(&stiff, x),
                    inertia: shifted(&inertia, x),
                    centrifugal: shifted(&centrifugal, x),
                });
                x = if length >= b - a - x { b - a } else { x + length };
            }
        }
        let length = blade.radius - root.offset;
        let typical = (softest * stiffest).sqrt();
        let scale = [length, 1.0, typical / length, typical / (length * length)];
        Self { dof, root, panels, scale }
    }

    /// What the root condition leaves at this frequency, between −1 and 1; zero at an eigenvalue.
    pub fn mismatch(&self, speed: f64, frequency: f64) -> f64 {
        if self.dof == Dof::Torsion { self.twisting(speed, frequency) } else { self.bending(speed, frequency) }
    }

    fn twisting(&self, speed: f64, frequency: f64) -> f64 {
        let (mut theta, mut torque) = (1.0, 0.0);
        for panel in &self.panels {
            (theta, torque) = self.twist(panel, speed, frequency * frequency, theta, torque);
        }
        torque *= self.scale[2];
        match self.root.hold {
            Hold::Clamped => theta,
            Hold::Free => torque / self.scale[2],
            Hold::Spring(k) => (torque - k * theta) / self.scale[2].max(k),
        }
    }

    /// Carries angle and scaled torque over a panel and makes their length 1.
    pub(crate) fn twist(&self, panel: &Panel, speed: f64, square: f64, theta: f64, torque: f64) -> (f64, f64) {
        let (mut t, mut q) = ([0.0; TERMS + 1], [0.0; TERMS + 1]);
        (t[0], q[0]) = (theta, torque * self.scale[2]);
        for k in 0..TERMS {
            // Inward coordinate: θ′ and Q′ change sign against the outward one.
            let mut tail = -q[k];
            if k >= 1 {
                tail -= panel.stiffness[1] * k as f64 * t[k];
            }
            let mut load = 0.0;
            for (j, c) in panel.centrifugal.iter().enumerate().filter(|(j, _)| *j <= k) {
                load -= speed * speed * c * t[k - j];
            }
            for (j, c) in panel.inertia.iter().enumerate().filter(|(j, _)| *j <= k) {
                load += square * c * t[k - j];
            }
            t[k + 1] = tail / panel.stiffness[0] / (k + 1) as f64;
            q[k + 1] = load / (k + 1) as f64;
        }
        let (theta, torque) = (value(&t, panel.length), value(&q, panel.length) / self.scale[2]);
        let size = theta.hypot(torque);
        (theta / size, torque / size)
    }

    fn bending(&self, speed: f64, frequency: f64) -> f64 {
        let pull = speed * speed;
        let load = frequency * frequency + if self.dof == Dof::Lag { pull } else { 0.0 };
        let mut states = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]];
        for panel in &self.panels {
            for state in &mut states {
                for (s, scale) in state.iter_mut().zip(self.scale) {
                    *s *= scale;
                }
                *state = advance(panel, pull, load, *state);
                for (s, scale) in state.iter_mut().zip(self.scale) {
                    *s /= scale;
                }
            }
            orthonormalise(&mut states);
        }
        let condition = |s: &[f64; 4]| match self.root.hold {
            Hold::Clamped => s[1],
            Hold::Free => s[2],
            Hold::Spring(k) => (s[2] * self.scale[2] - k * s[1]) / self.scale[2].max(k),
        };
        let [a, b] = states;
        a[0] * condition(&b) - b[0] * condition(&a)
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
    Exact::new(blade, dof, speed, highest).frequencies(speed, highest, 160)
}

/// Gram–Schmidt with positive factors: the determinant keeps its sign and its digits.
pub(crate) fn orthonormalise([a, b]: &mut [[f64; 4]; 2]) {
    let dot = |x: &[f64; 4], y: &[f64; 4]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
    let size = dot(a, a).sqrt();
    *a = a.map(|v| v / size);
    for _ in 0..2 {
        let along = dot(a, b);
        b.iter_mut().zip(a.iter()).for_each(|(v, u)| *v -= along * u);
    }
    let size = dot(b, b).sqrt();
    *b = b.map(|v| v / size);
}

/// Carries (w, s, M, V) from the outboard to the inboard end of a panel.
pub(crate) fn advance(panel: &Panel, pull: f64, load: f64, state: [f64; 4]) -> [f64; 4] {
    let [mut w, mut s, mut m, mut v] = state.map(|first| {
        let mut series = [0.0; TERMS + 1];
        series[0] = first;
        series
    });
    for k in 0..TERMS {
        let next = (k + 1) as f64;
        // d/dr = −d/dx: every right-hand side changes sign.
        let mut bend = -m[k];
        if k >= 1 {
            bend -= panel.stiffness[1] * k as f64 * s[k];
        }
        let stretch: f64 = panel.centrifugal.iter().take(k + 1).enumerate().map(|(j, c)| c * s[k - j]).sum();
        let weight: f64 = panel.inertia.iter().take(k + 1).enumerate().map(|(j, c)| c * w[k - j]).sum();
        w[k + 1] = -s[k] / next;
        s[k + 1] = bend / panel.stiffness[0] / next;
        m[k + 1] = -(v[k] + pull * stretch) / next;
        v[k + 1] = -load * weight / next;
    }
    [w, s, m, v].map(|series| value(&series, panel.length))
}

#[cfg(test)]
mod tests {
    use super::*;

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
