//! Random coupled blades, each with a number and the same in every run: up to six segments with steps,
//! tapered and twisted, offsets, every root at its own radius, masses; from rest to Ω² m R⁴/EI = 400.

use super::{CoupledBlade, PointMass, Trapeze};
use crate::blades::{End, Hold, Table};
use core::f64::consts::FRAC_PI_2;

/// A random blade and the speed at which it is asked about.
#[derive(Clone, Debug)]
pub struct Case {
    /// The blade.
    pub blade: CoupledBlade,
    /// Rotor speed [rad/s].
    pub speed: f64,
}

/// SplitMix64 (Steele, Lea & Flood, OOPSLA 2014).
#[derive(Clone, Debug)]
pub(super) struct Dice(pub(super) u64);

impl Dice {
    pub(super) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 * (-53_f64).exp2()
    }

    pub(super) fn power(&mut self, low: f64, high: f64) -> f64 {
        10_f64.powf(self.between(low, high))
    }

    /// True once in so many throws.
    pub(super) fn once_in(&mut self, throws: u64) -> bool {
        self.next().is_multiple_of(throws)
    }
}

/// The blade of this number.
pub fn case(number: u64) -> Case {
    let mut dice = Dice(number);
    let radius = dice.power(-0.3, 1.0);
    let chord = radius * dice.between(0.03, 0.15);
    let stations = stations(&mut dice, radius);
    let (heavy, soft) = (dice.power(-1.0, 1.5), dice.power(0.0, 4.0));
    let (broad, twisting) = (dice.power(0.0, 1.8), dice.power(-0.5, 0.7));
    let mass = property(&mut dice, &stations, heavy, 0.5);
    let bending = [soft, soft * broad].map(|unit| property(&mut dice, &stations, unit, 0.6));
    let torsion = property(&mut dice, &stations, soft * twisting, 0.6);
    let mass_offset = offset(&mut dice, &stations, 0.2 * chord);
    let tension_offset = offset(&mut dice, &stations, 0.1 * chord);
    let radius_of_gyration = chord * dice.between(0.1, 0.35);
    let spread = heavy * radius_of_gyration * radius_of_gyration;
    let thickness = dice.power(-2.0, -0.3);
    let inertia = [spread * thickness, spread].map(|unit| property(&mut dice, &stations, unit, 0.5));
    let trapeze = trapeze(&mut dice, &stations, chord, &bending);
    let mut blade = CoupledBlade {
        mass,
        bending,
        torsion,
        inertia,
        mass_offset,
        tension_offset,
        trapeze,
        twist: twist(&mut dice, &stations),
        pitch: pitch(&mut dice),
        precone: if dice.once_in(4) { dice.between(-0.03, 0.1) } else { 0.0 },
        torque_offset: if dice.once_in(4) { radius * dice.between(-0.02, 0.02) } else { 0.0 },
        rotary: dice.once_in(4),
        spring_angle: if dice.once_in(3) { dice.between(-0.5, 1.5) } else { 0.0 },
        roots: roots(&mut dice, radius, soft / radius),
        ..CoupledBlade::uniform(radius, [1.0, 1.0])
    };
    spread_mass(&mut blade, &stations);
    if dice.once_in(4) {
        for _ in 0..=u64::from(dice.once_in(2)) {
            blade.point_masses.push(point(&mut dice, radius, heavy, chord));
        }
    }
    let reference = (soft / heavy).sqrt() / (radius * radius);
    let speed = if dice.once_in(7) { 0.0 } else { reference * dice.power(-0.5, 1.3) };
    Case { blade, speed }
}

/// Two to seven radii from the axis to the tip.
fn stations(dice: &mut Dice, radius: f64) -> Vec<f64> {
    let inner = dice.next() % 6;
    let mut stations: Vec<f64> = (0..inner).map(|_| radius * dice.between(0.05, 0.97)).collect();
    stations.extend([0.0, radius]);
    stations.sort_by(f64::total_cmp);
    stations
}

/// A positive property about `unit`, within a factor e^`decay` of it: uniform, or linear between the
/// stations with steps at some of them.
fn property(dice: &mut Dice, stations: &[f64], unit: f64, decay: f64) -> Table {
    along(dice, stations, |dice| unit * dice.between(-decay, decay).exp())
}

/// An offset of either sign; none on a third of the blades.
fn offset(dice: &mut Dice, stations: &[f64], most: f64) -> Table {
    if dice.once_in(3) { Table::uniform(0.0) } else { along(dice, stations, |dice| dice.between(-most, most)) }
}

fn along(dice: &mut Dice, stations: &[f64], value: impl Fn(&mut Dice) -> f64) -> Table {
    if dice.once_in(4) {
        return Table::uniform(value(dice));
    }
    let (mut r, mut y) = (Vec::new(), Vec::new());
    for (i, &station) in stations.iter().enumerate() {
        let step = i > 0 && i + 1 < stations.len() && dice.once_in(3);
        for _ in 0..=u8::from(step) {
            r.push(station);
            y.push(value(dice));
        }
    }
    Table { r, y }
}

/// Without steps: a blade is twisted, not broken.
fn twist(dice: &mut Dice, stations: &[f64]) -> Table {
    let most = if dice.once_in(4) { 0.0 } else { dice.between(0.0, 0.6) };
    Table { r: stations.to_vec(), y: stations.iter().map(|_| dice.between(-most, most)).collect() }
}

fn pitch(dice: &mut Dice) -> f64 {
    match dice.next() % 6 {
        0 | 1 => 0.0,
        2 => dice.between(0.0, FRAC_PI_2),
        3 if dice.once_in(2) => FRAC_PI_2,
        _ => dice.between(-0.2, 0.5),
    }
}

fn trapeze(dice: &mut Dice, stations: &[f64], chord: f64, bending: &[Table; 2]) -> Trapeze {
    let square = (chord * dice.between(0.1, 0.3)).powi(2);
    match dice.next() % 3 {
        0 => Trapeze::Off,
        1 => Trapeze::Square(property(dice, stations, square, 0.5)),
        _ => {
            let stiffness = (bending[0].y[0] + bending[1].y[0]) / square;
            Trapeze::AxialStiffness(property(dice, stations, stiffness, 0.5))
        }
    }
}

fn roots(dice: &mut Dice, radius: f64, stiffness: f64) -> [End; 3] {
    let common = if dice.once_in(3) { 0.0 } else { radius * dice.between(0.0, 0.15) };
    let apart = dice.once_in(2);
    [0, 1, 2].map(|dof| {
        let offset = if apart { radius * dice.between(0.0, 0.15) } else { common };
        let hold = match dice.next() % 4 {
            0 | 1 => Hold::Clamped,
            // A free pitch bearing is rare; a hinge is not.
            2 if dof < 2 || dice.once_in(3) => Hold::Free,
            _ => Hold::Spring(stiffness * dice.power(-2.0, 2.0)),
        };
        End { offset, hold }
    })
}

fn point(dice: &mut Dice, radius: f64, heavy: f64, chord: f64) -> PointMass {
    let r = if dice.once_in(2) { radius } else { radius * dice.between(0.2, 1.0) };
    let mass = heavy * radius * dice.power(-2.0, -0.3);
    let offset = dice.between(-0.2, 0.2) * chord;
    // About the elastic axis: no less than m e².
    let inertia = [0.05, 1.0].map(|part| mass * (offset * offset + part * dice.between(0.01, 0.1) * chord * chord));
    PointMass { r, mass, offset, inertia }
}

/// Raises the mass moments until they exceed those of the mass in its centre everywhere.
fn spread_mass(blade: &mut CoupledBlade, stations: &[f64]) {
    // Between stations m e² is a cubic: so many places see it within a few per cent.
    const PLACES: usize = 20;
    let possible = |blade: &CoupledBlade| {
        stations.windows(2).all(|ends| {
            let at = |table: &Table| super::blade::ends(table, ends[0], ends[1]);
            let [m, e, first, second] = [&blade.mass, &blade.mass_offset, &blade.inertia[0], &blade.inertia[1]].map(at);
            (0..=PLACES).all(|i| {
                let x = i as f64 / PLACES as f64;
                let [m, e, first, second] = [m, e, first, second].map(|[a, b]| a + x * (b - a));
                first + second > 1.1 * m * e * e
            })
        })
    };
    while !possible(blade) {
        blade.inertia = blade.inertia.each_ref().map(|table| table.times(1.3));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coupled::Exact;

    #[test]
    fn a_number_names_one_blade() {
        for number in 0..50 {
            assert_eq!(case(number).blade, case(number).blade);
        }
        assert_ne!(case(1).blade, case(2).blade);
    }

    /// Eigenvalues found with other panels lie within what rounding is allowed, one by one.
    #[test]
    fn two_cuts_of_a_blade_count_alike() {
        for number in 0..25 {
            let Case { blade, speed } = case(number);
            let (mut one, mut other) = (Exact::new(&blade, speed), Exact::with_shorter_panels(&blade, speed, 0.4));
            for (i, square) in one.eigenvalues(12).into_iter().enumerate() {
                assert_eq!(other.contradiction(i + 1, square, square), None, "blade {number}");
            }
        }
    }
}
