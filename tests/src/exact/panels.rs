//! A blade cut into panels on which Taylor series converge, and how a state crosses one.

use super::{Real, State, TERMS, over};
use crate::blades::{Table, TestBlade};
use crate::coupled::PointMass;
use bladefan_core::Dof;

/// Longest panel in units of the shortest characteristic length of the solution on it.
pub(super) const REACH: f64 = 1.0;
/// Longest panel as a part of the distance in which a linear stiffness would reach zero; the
/// Taylor series converge like this to the power [`TERMS`].
const TAPER: f64 = 0.2;

/// A polynomial in the local coordinate, lowest power first.
type Poly<T> = Vec<T>;

/// A stretch of the blade. Its coordinate runs from 0 at the outboard end to 1 at the inboard one, so
/// that no power of a very short length is ever taken.
#[derive(Clone, Debug)]
pub(crate) struct Panel<T> {
    length: T,
    stiffness: Poly<T>,
    inertia: Poly<T>,
    /// T of bending, or m Y² of torsion.
    centrifugal: Poly<T>,
    /// Point masses at its outboard end: mass, or in torsion their inertia and what the rotor's turning adds to
    /// their stiffness.
    lump: [T; 2],
    /// Units of (displacement, slope, moment, force) that suit this panel, powers of two: in them
    /// nothing grows much on the way across it.
    pub(crate) scale: [f64; 4],
}

/// Values of a table just inboard and just outboard of a radius.
fn limits<T: Real>(table: &Table, r: f64) -> (T, T) {
    let value_between = |i: usize| {
        let (a, b) = (T::of(table.r[i]), T::of(table.r[i + 1]));
        let (first, last) = (T::of(table.y[i]), T::of(table.y[i + 1]));
        (first * (b - T::of(r)) + last * (T::of(r) - a)) / (b - a)
    };
    let last = table.r.len() - 1;
    let (first_value, last_value) = (T::of(table.y[0]), T::of(table.y[last]));
    if r < table.r[0] || last == 0 {
        return (first_value, first_value);
    }
    if r > table.r[last] {
        return (last_value, last_value);
    }
    let inboard = (0..last).find(|&i| table.r[i] < r && r <= table.r[i + 1]).map_or(first_value, value_between);
    let outboard = (0..last).rev().find(|&i| table.r[i] <= r && r < table.r[i + 1]).map_or(last_value, value_between);
    (inboard, outboard)
}

/// The table on [a, b], which holds none of its radii inside, as a polynomial in x = b − r.
fn segment<T: Real>(table: &Table, a: f64, b: f64) -> Poly<T> {
    let (outer, inner) = (limits::<T>(table, b).0, limits::<T>(table, a).1);
    vec![outer, (inner - outer) / (T::of(b) - T::of(a))]
}

fn product<T: Real>(p: &[T], q: &[T]) -> Poly<T> {
    let mut out = vec![T::of(0.0); p.len() + q.len() - 1];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            out[i + j] = out[i + j] + *a * *b;
        }
    }
    out
}

fn integral<T: Real>(p: &[T]) -> Poly<T> {
    let mut out = vec![T::of(0.0)];
    out.extend(p.iter().enumerate().map(|(k, c)| *c / T::of((k + 1) as f64)));
    out
}

pub(super) fn value<T: Real>(p: &[T], x: T) -> T {
    p.iter().rev().fold(T::of(0.0), |sum, c| sum * x + *c)
}

/// Coefficients about x = `shift` instead of 0.
fn shifted<T: Real>(p: &[T], shift: T) -> Poly<T> {
    let mut out = p.to_vec();
    for i in 0..out.len() {
        for j in (i..out.len() - 1).rev() {
            out[j] = out[j] + shift * out[j + 1];
        }
    }
    out
}

/// Coefficients in x / `length` instead of x.
fn rescaled<T: Real>(mut p: Poly<T>, length: T) -> Poly<T> {
    let mut power = T::of(1.0);
    for c in &mut p {
        *c = *c * power;
        power = power * length;
    }
    p
}

/// The power of two nearest to a positive number, among those that leave room for products.
fn power_of_two(x: f64) -> f64 {
    x.log2().round().clamp(-250.0, 250.0).exp2()
}

/// What the rotor's turning adds to the stiffness of twist on [a, b]: I2 − I1 or m Y².
fn propeller<T: Real>(blade: &TestBlade, a: f64, b: f64) -> Poly<T> {
    if let Some([flap, lag]) = &blade.inertias {
        return segment::<T>(lag, a, b).iter().zip(segment::<T>(flap, a, b)).map(|(lag, flap)| *lag - flap).collect();
    }
    let offset = segment(&blade.mass_offset, a, b);
    product(&segment(&blade.mass, a, b), &product(&offset, &offset))
}

/// What a point mass weighs, and what the rotor's turning adds by it: J, and m e² or J2 − J1, in torsion.
fn point_mass<T: Real>(mass: &PointMass, dof: Dof, full: bool) -> [T; 2] {
    let (m, offset) = (T::of(mass.mass), T::of(mass.offset));
    match dof {
        Dof::Flap | Dof::Lag => [m, T::of(0.0)],
        Dof::Torsion => {
            let [flap, lag] = mass.inertia.map(T::of);
            [flap + lag, if full { lag - flap } else { m * offset * offset }]
        }
    }
}

/// Properties between two radii where none of them has a step or a kink.
struct Stretch<T> {
    length: T,
    stiffness: Poly<T>,
    inertia: Poly<T>,
    mass: Poly<T>,
    offset: Poly<T>,
    centrifugal: Poly<T>,
}

impl<T: Real> Stretch<T> {
    /// The shortest characteristic length between two places, with each property at its worst of both.
    fn shortest(&self, dof: Dof, speed: f64, highest: f64, ends: [T; 2]) -> f64 {
        let at = |p: &[T]| ends.map(|x| value(p, x).near());
        let most = |p: &[T]| at(p).into_iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        let least = at(&self.stiffness).into_iter().fold(f64::INFINITY, f64::min);
        let heaviest = most(&self.inertia);
        if dof == Dof::Torsion {
            let paper = most(&self.mass) * most(&self.offset).powi(2);
            let pulled = speed * speed * paper.max(most(&self.centrifugal));
            (least / (highest * highest * heaviest + pulled + f64::MIN_POSITIVE)).sqrt()
        } else {
            let wave = ((highest * highest + speed * speed) * heaviest / least).powf(0.25);
            let pulled = (speed * speed * most(&self.centrifugal) / least).sqrt();
            1.0 / (wave + pulled + f64::MIN_POSITIVE)
        }
    }

    /// How far a panel from `x` may go inward, and the characteristic length there.
    fn reach(&self, dof: Dof, speed: f64, highest: f64, x: T) -> (T, f64) {
        let slope = self.stiffness[1].near().abs();
        let taper = TAPER * value(&self.stiffness, x).near() / slope.max(f64::MIN_POSITIVE);
        let rest = self.length - x;
        let mut length = if taper < rest.near() { T::of(taper) } else { rest };
        // What is heavy or pulled far from here does not shorten this panel.
        loop {
            let short = self.shortest(dof, speed, highest, [x, x + length]);
            let within = REACH * short;
            if length.near() <= within {
                return (length, short);
            }
            if length.near() <= 4.0 * within || !within.is_normal() {
                return (T::of(within), short);
            }
            length = T::of(0.25 * length.near());
        }
    }
}

/// The panels of one degree of freedom from the tip inward, if no more than `most` are needed.
pub(super) fn of<T: Real>(blade: &TestBlade, dof: Dof, speed: f64, highest: f64, most: usize) -> Option<Vec<Panel<T>>> {
    let root = blade.roots[dof.index()];
    let stiffness = &blade.stiffness[dof.index()];
    let mut radii: Vec<f64> = [stiffness, &blade.mass, &blade.polar_inertia, &blade.mass_offset]
        .iter()
        .copied()
        .chain(blade.inertias.iter().flatten())
        .flat_map(|table| table.r.iter().copied())
        .chain(blade.point_masses.iter().map(|mass| mass.r))
        .filter(|&r| r > root.offset && r < blade.radius)
        .chain([root.offset, blade.radius])
        .collect();
    radii.sort_by(f64::total_cmp);
    radii.dedup();

    let (mut panels, mut tension) = (Vec::new(), T::of(0.0));
    for ends in radii.windows(2).rev() {
        let (a, b) = (ends[0], ends[1]);
        #[allow(clippy::float_cmp, reason = "panels end at the masses to the bit")]
        let hung: Vec<&PointMass> = blade.point_masses.iter().filter(|mass| mass.r == b).collect();
        tension = hung.iter().fold(tension, |sum, mass| sum + T::of(mass.mass) * T::of(mass.r));
        let full = blade.inertias.is_some();
        let acts = |i: usize| hung.iter().fold(T::of(0.0), |sum, mass| sum + point_mass::<T>(mass, dof, full)[i]);
        let mut lump = [0, 1].map(acts);
        let mass: Poly<T> = segment(&blade.mass, a, b);
        let offset = segment(&blade.mass_offset, a, b);
        let length = T::of(b) - T::of(a);
        // T(x) = T(b) + ∫ m (b − x) dx, x inward from b.
        let mut pull = integral(&product(&mass, &[T::of(b), T::of(-1.0)]));
        pull[0] = tension;
        tension = value(&pull, length);
        let (inertia, centrifugal) = match dof {
            Dof::Torsion => (segment(&blade.polar_inertia, a, b), propeller(blade, a, b)),
            Dof::Flap | Dof::Lag => (mass.clone(), pull),
        };
        let stretch = Stretch { length, stiffness: segment(stiffness, a, b), inertia, mass, offset, centrifugal };
        let mut x = T::of(0.0);
        while x < length {
            let (mut step, short) = stretch.reach(dof, speed, highest, x);
            if (length - x - step).near() < 1e-9 * length.near() {
                step = length - x;
            }
            if panels.len() >= most || x + step <= x || !step.near().is_normal() {
                return None;
            }
            let unit = power_of_two(short.min(blade.radius));
            let stiff = power_of_two(value(&stretch.stiffness, x).near());
            panels.push(Panel {
                length: step,
                stiffness: rescaled(shifted(&stretch.stiffness, x), step),
                inertia: rescaled(shifted(&stretch.inertia, x), step),
                centrifugal: rescaled(shifted(&stretch.centrifugal, x), step),
                lump,
                scale: [unit, 1.0, stiff / unit, stiff / unit / unit],
            });
            lump = [T::of(0.0); 2];
            x = if step >= length - x { length } else { x + step };
        }
    }
    Some(panels)
}

impl<T: Real> Panel<T> {
    /// Carries (w, s, M, V) from the outboard to the inboard end.
    pub(crate) fn advance(&self, pull: T, load: T, state: State<T>) -> State<T> {
        let zero = T::of(0.0);
        let [mut w, mut s, mut m, mut v] = state.map(|first| {
            let mut series = [zero; TERMS + 1];
            series[0] = first;
            series
        });
        v[0] = v[0] - load * self.lump[0] * w[0];
        let unbent = T::of(1.0) / self.stiffness[0];
        for k in 0..TERMS {
            let next = self.length / T::of((k + 1) as f64);
            // d/dr = −d/dx: every right-hand side changes sign.
            let mut bend = -m[k];
            if k >= 1 {
                bend = bend - self.stiffness[1] / self.length * T::of(k as f64) * s[k];
            }
            let sum = |coefficients: &[T], series: &[T]| {
                coefficients.iter().take(k + 1).enumerate().fold(zero, |sum, (j, c)| sum + *c * series[k - j])
            };
            w[k + 1] = -s[k] * next;
            s[k + 1] = bend * unbent * next;
            m[k + 1] = -(v[k] + pull * sum(&self.centrifugal, &s)) * next;
            v[k + 1] = -load * sum(&self.inertia, &w) * next;
        }
        [w, s, m, v].map(|series| value(&series, T::of(1.0)))
    }

    /// Carries angle and torque from the outboard to the inboard end and makes them of size 1 in the
    /// panel's units.
    pub(crate) fn twist(&self, pull: T, square: T, [theta, torque]: [T; 2]) -> [T; 2] {
        let zero = T::of(0.0);
        let (mut t, mut q) = ([zero; TERMS + 1], [zero; TERMS + 1]);
        (t[0], q[0]) = (theta, torque + (square * self.lump[0] - pull * self.lump[1]) * theta);
        for k in 0..TERMS {
            let next = self.length / T::of((k + 1) as f64);
            // Inward coordinate: θ′ and Q′ change sign against the outward one.
            let mut tail = -q[k];
            if k >= 1 {
                tail = tail - self.stiffness[1] / self.length * T::of(k as f64) * t[k];
            }
            let sum = |coefficients: &[T]| {
                coefficients.iter().take(k + 1).enumerate().fold(zero, |sum, (j, c)| sum + *c * t[k - j])
            };
            let load = square * sum(&self.inertia) - pull * sum(&self.centrifugal);
            t[k + 1] = tail / self.stiffness[0] * next;
            q[k + 1] = load * next;
        }
        let [theta, torque] = [value(&t, T::of(1.0)), value(&q, T::of(1.0))];
        let size = T::of(1.0 / theta.near().hypot(torque.near() / self.scale[2]));
        [theta * size, torque * size]
    }

    /// The displacements that a unit force and a unit moment at the outer end leave at the inner one,
    /// in the panel's units, with the signs that make N of [`sturm`](crate::sturm) positive.
    pub(crate) fn yielding(&self, pull: T, load: T) -> [State<T>; 2] {
        let [zero, one] = [0.0, 1.0].map(T::of);
        [[zero, zero, zero, one], [zero, zero, -one, zero]]
            .map(|unit| over(self.advance(pull, load, super::times(unit, &self.scale)), &self.scale))
    }
}
