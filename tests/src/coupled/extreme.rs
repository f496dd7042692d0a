//! Coupled blades that ask more of a solver than any rotor does. Each has a number and is the same in every run.

use super::random::{Case, Dice, case};
use super::{CoupledBlade, PointMass, Trapeze};
use crate::blades::{End, Table};
use core::f64::consts::FRAC_PI_2;

/// What makes an extreme of a random blade.
type Change = fn(Case, &mut Dice) -> Case;

/// The kinds, in the order in which the numbers go through them.
const KINDS: [(&str, Change); 8] = [
    ("string", string),
    ("edge on a weak pitch link", edge),
    ("mass aft of an axis that lies ahead", aft),
    ("massless stretches", massless),
    ("elements of a millimetre on 8 m", short),
    ("round rod", round),
    ("heavy tip", heavy_tip),
    ("weak hinges", weak),
];

/// The extreme blade of this number, and what makes it one.
#[allow(clippy::cast_possible_truncation, reason = "below the number of kinds")]
pub fn extreme(number: u64) -> (&'static str, Case) {
    let (kind, change) = KINDS[(number % KINDS.len() as u64) as usize];
    let mut dice = Dice(number ^ 0x5eed);
    (kind, change(case(number), &mut dice))
}

/// √(EI/m)/R², with which Ω² m R⁴/EI is 1.
fn reference(blade: &CoupledBlade) -> f64 {
    let most = |table: &Table| table.y.iter().copied().fold(0.0, f64::max);
    (most(&blade.bending[0]) / most(&blade.mass)).sqrt() / blade.radius.powi(2)
}

/// So fast that stiffness is a boundary layer: Ω² m R⁴/EI from 400 to 1e5.
fn string(case: Case, dice: &mut Dice) -> Case {
    Case { speed: reference(&case.blade) * dice.power(1.3, 2.5), ..case }
}

/// A flat section on edge, which the propeller moment turns over where no pitch link holds it: cos 2β < 0.
fn edge(mut case: Case, dice: &mut Dice) -> Case {
    case.blade.pitch = FRAC_PI_2 + dice.between(-0.4, 0.4);
    loosen(&mut case.blade, dice);
    let speed = reference(&case.blade) * dice.power(0.0, 1.5);
    Case { speed, ..case }
}

/// A pitch link of next to nothing.
fn loosen(blade: &mut CoupledBlade, dice: &mut Dice) {
    let link = blade.torsion.y[0] / blade.radius * dice.power(-6.0, -1.0);
    blade.roots[2] = End::spring(blade.roots[2].offset, link);
}

/// Mass behind an elastic axis that runs ahead of the radius, a negative spring in torsion, on a weak pitch link.
fn aft(mut case: Case, dice: &mut Dice) -> Case {
    let blade = &mut case.blade;
    blade.mass_offset = blade.mass_offset.times(-1.0);
    blade.mass_offset.y.iter_mut().for_each(|e| *e = -e.abs());
    blade.torque_offset = blade.radius * dice.between(0.1, 0.5);
    loosen(blade, dice);
    let speed = reference(blade) * dice.power(0.0, 1.5);
    Case { speed, ..case }
}

/// Two stretches, one of them at the root, without mass and inertia.
fn massless(mut case: Case, dice: &mut Dice) -> Case {
    let blade = &mut case.blade;
    let [first, from, to] = [(0.05, 0.2), (0.4, 0.6), (0.65, 0.8)].map(|(a, b)| blade.radius * dice.between(a, b));
    for table in core::iter::once(&mut blade.mass).chain(&mut blade.inertia) {
        let value = table.y.iter().copied().fold(0.0, f64::max);
        let (r, y) = (vec![0.0, first, first, from, from, to, to, blade.radius], vec![0.0, 0.0, value, value]);
        *table = Table { r, y: [y.as_slice(), &[0.0, 0.0, value, value]].concat() };
    }
    // Inertia about the mass centre stays positive.
    case.blade = case.blade.with_offsets(0.5);
    case
}

/// 8 m long, with steps of stiffness a millimetre from one another.
fn short(mut case: Case, dice: &mut Dice) -> Case {
    let blade = &mut case.blade;
    let long = blade.enlarged(8.0 / blade.radius);
    *blade = CoupledBlade { radius: 8.0, ..long };
    let places = [(0.16, 0.4), (0.5, 0.7), (0.8, 0.95)].map(|(a, b)| 8.0 * dice.between(a, b));
    let radii: Vec<f64> = places.iter().flat_map(|r| [*r, r + 1e-3]).collect();
    let ends = [&[0.0], radii.as_slice(), &[8.0]].concat();
    for table in blade.bending.iter_mut().chain([&mut blade.torsion]) {
        let unit = table.y[0];
        let values: Vec<f64> = ends[1..].iter().map(|_| unit * dice.power(-1.0, 1.0)).collect();
        *table = Table::steps(&ends, &values);
    }
    if let Trapeze::AxialStiffness(_) = blade.trapeze {
        blade.trapeze = Trapeze::Off;
    }
    case
}

/// The same about every axis: flap and lag are one at rest, and differ by Ω² at speed.
fn round(Case { blade, speed }: Case, dice: &mut Dice) -> Case {
    let mut blade = CoupledBlade { point_masses: Vec::new(), ..blade }.with_offsets(0.0);
    blade.bending[1] = blade.bending[0].clone();
    blade.inertia[1] = blade.inertia[0].clone();
    blade.roots[1] = blade.roots[0];
    Case { blade, speed: if dice.once_in(2) { 0.0 } else { speed } }
}

/// Up to a thousand times the mass of the blade at its tip.
fn heavy_tip(mut case: Case, dice: &mut Dice) -> Case {
    let blade = &mut case.blade;
    let mass = blade.mass.y[0] * blade.radius * dice.power(0.0, 3.0);
    let offset = 0.02 * blade.radius * dice.between(-1.0, 1.0);
    let inertia = [1e-5, 4e-4].map(|part| mass * (0.5 * offset * offset + part * blade.radius.powi(2)));
    blade.point_masses = vec![PointMass { r: blade.radius, mass, offset, inertia }];
    case
}

/// Springs so weak, or so strong, that they are nearly none, or clamps. From 1e7 on the exact count wavers by 5e-11, in
/// whatever panels.
fn weak(mut case: Case, dice: &mut Dice) -> Case {
    let unit = case.blade.bending[0].y[0] / case.blade.radius;
    case.blade.roots = case.blade.roots.map(|root| {
        let stiffness = if dice.once_in(2) { dice.power(-9.0, -4.0) } else { dice.power(3.0, 5.5) };
        End::spring(root.offset, unit * stiffness)
    });
    case
}
