//! Legal blades that ask more of a solver than any rotor does: many decades of stiffness within a
//! span, heavy blocks parted by light soft stretches, tapers to nearly nothing, speeds at which a
//! blade is a string. Each has a number and is the same in every run.

use crate::blades::{End, Hold, Table, TestBlade};
use crate::random::{self, draw};
use core::ops::Range;
use proptest::prelude::*;
use proptest::strategy::Union;

/// A hostile blade and what is asked of it.
#[derive(Clone, Debug)]
pub struct Hostile {
    /// What makes it hostile.
    pub kind: &'static str,
    /// The blade.
    pub blade: TestBlade,
    /// Rotor speed [rad/s].
    pub speed: f64,
    /// Last speed of a chart [rad/s].
    pub fastest: f64,
    /// Modes asked for.
    pub modes: usize,
}

/// What makes blades of a kind.
type Kind = fn() -> BoxedStrategy<TestBlade>;

/// The kinds, in the order in which the numbers go through them.
const KINDS: [(&str, Kind); 9] = [
    ("decades of stiffness", decades),
    ("heavy blocks", blocks),
    ("taper to nearly nothing", taper),
    ("light soft root", light),
    ("clustered torsion", clustered),
    ("string", string),
    ("all at random", anything),
    ("dense stations", dense),
    ("far from the usual units", scaled),
];

/// The hostile blade of this number.
pub fn case(number: u64) -> Hostile {
    #[allow(clippy::cast_possible_truncation, reason = "below the number of kinds")]
    let (kind, blade) = KINDS[(number % KINDS.len() as u64) as usize];
    let part = prop_oneof![2 => Just(0.0), 3 => Just(1.0), 1 => 0.0..1.5_f64];
    let fastest = prop_oneof![3 => Just(1.2), 1 => power(0.0..1.0)];
    let modes = if kind == "light soft root" { 3..=30_usize } else { 3..=8 };
    let strategy = (blade(), part, fastest, modes).prop_map(move |(blade, part, fastest, modes)| Hostile {
        kind,
        speed: part * blade.nominal_speed,
        fastest: fastest * blade.nominal_speed,
        modes,
        blade,
    });
    draw(&strategy, 1, number).remove(0)
}

/// A power of ten.
fn power(exponents: Range<f64>) -> BoxedStrategy<f64> {
    exponents.prop_map(|exponent| 10_f64.powf(exponent)).boxed()
}

/// How a root is held, with springs of any stiffness.
fn hold() -> impl Strategy<Value = Hold> {
    prop_oneof![Just(Hold::Clamped), Just(Hold::Free), power(-12.0..12.0).prop_map(Hold::Spring)]
}

/// Roots at the centre or out to some part of a unit span.
fn roots(farthest: f64) -> impl Strategy<Value = [End; 3]> {
    let end = move || {
        let offset = prop_oneof![Just(0.0), 0.0..farthest];
        (offset, hold()).prop_map(|(offset, hold)| End { offset, hold })
    };
    [end(), end(), end()]
}

/// Ends of pieces that cover a unit span, no two nearer than 1e-5.
fn cuts(pieces: core::ops::RangeInclusive<usize>) -> impl Strategy<Value = Vec<f64>> {
    let inner = *pieces.start() - 1..=*pieces.end() - 1;
    prop::collection::btree_set(1..100_000_u32, inner).prop_map(|cuts| {
        [0.0].into_iter().chain(cuts.into_iter().map(|cut| f64::from(cut) * 1e-5)).chain([1.0]).collect()
    })
}

/// Pieces along a unit span, linear between their ends, all values by one strategy; `none` in ten of
/// the inner ones are stretches of zero.
fn pieces(value: BoxedStrategy<f64>, none: u32, most: usize) -> impl Strategy<Value = Table> {
    let piece = (value.clone(), value, any::<bool>(), 0..10_u32);
    (cuts(1..=most), prop::collection::vec(piece, most)).prop_map(move |(cuts, values)| {
        let last = cuts.len() - 2;
        let (mut r, mut y) = (Vec::new(), Vec::new());
        for (i, (ends, (a, b, flat, zero))) in cuts.windows(2).zip(values).enumerate() {
            let (a, b) = if zero < none && i < last { (0.0, 0.0) } else { (a, if flat { a } else { b }) };
            r.extend_from_slice(ends);
            y.extend_from_slice(&[a, b]);
        }
        Table { r, y }
    })
}

/// A blade of unit span stretched to another radius: radii, offsets and mass offsets go with it.
fn stretched(mut blade: TestBlade, radius: f64) -> TestBlade {
    let far = |table: &mut Table| table.r.iter_mut().for_each(|r| *r *= radius);
    for table in [&mut blade.mass, &mut blade.polar_inertia, &mut blade.mass_offset] {
        far(table);
    }
    blade.stiffness.iter_mut().for_each(far);
    blade.mass_offset.y.iter_mut().for_each(|y| *y *= radius);
    blade.roots.iter_mut().for_each(|root| root.offset *= radius);
    blade.radius *= radius;
    blade
}

fn stiffnesses(one: impl Strategy<Value = Table> + Clone) -> impl Strategy<Value = [Table; 3]> {
    [one.clone(), one.clone(), one]
}

/// Up to 40 decades of stiffness in any order, jumping and running linearly.
fn decades() -> BoxedStrategy<TestBlade> {
    let range = (-20.0..18.0_f64, 0.0..1.0_f64).prop_map(|(low, part)| (low, low + 2.0 + part * (18.0 - low)));
    let stiffness = range.prop_flat_map(|(low, high)| pieces(power(low..high), 0, 6));
    let stiffness = [stiffness.clone(), stiffness.clone(), stiffness];
    (
        roots(0.7),
        pieces(power(-3.0..3.0), 2, 4),
        stiffness,
        pieces(power(-6.0..2.0), 2, 4),
        power(-1.0..2.0),
        power(-2.0..3.0),
    )
        .prop_map(|(roots, mass, stiffness, polar_inertia, radius, nominal_speed)| {
            let blade = TestBlade { nominal_speed, roots, mass, stiffness, polar_inertia, ..TestBlade::uniform(1.0) };
            stretched(blade, radius)
        })
        .boxed()
}

/// Bays that end in a short block, heavy and stiff: a mode may live in one bay and be hardly felt in
/// the others, and bays that are alike make modes that are nearly one.
fn blocks() -> BoxedStrategy<TestBlade> {
    let alike = prop_oneof![Just(0.0), power(-12.0..-2.0)];
    (1..=4_usize, power(-5.0..-1.5), power(3.0..10.0), power(1.0..6.0), alike, roots(0.05), power(-3.0..3.0))
        .prop_map(|(bays, length, heavy, stiff, unlike, roots, nominal_speed)| {
            let bay = 1.0 / bays as f64;
            let (mut radii, mut factors) = (vec![0.0], Vec::new());
            for i in 1..=bays {
                // Each bay a little longer or shorter than the last.
                let end = if i == bays { 1.0 } else { bay * i as f64 * (1.0 + unlike * 0.3 * i as f64) };
                radii.extend_from_slice(&[end - length * bay, end]);
                factors.extend_from_slice(&[false, true]);
            }
            let along = |light: f64, block: f64| {
                let values: Vec<f64> = factors.iter().map(|&heavy| if heavy { block } else { light }).collect();
                Table::steps(&radii, &values)
            };
            TestBlade {
                roots,
                nominal_speed,
                mass: along(1.0, heavy),
                stiffness: [along(1.0, stiff), along(3.0, 3.0 * stiff), along(1.0, stiff)],
                polar_inertia: along(0.1, 0.1 * heavy),
                ..TestBlade::uniform(1.0)
            }
        })
        .boxed()
}

/// Stiffness, and often mass, that tapers linearly to 1e-15 of itself and less at the tip.
fn taper() -> BoxedStrategy<TestBlade> {
    let one = |from: Range<f64>, down: Range<f64>| {
        let start = prop_oneof![Just(0.0), 0.0..0.95_f64];
        (start, power(from), power(down)).prop_map(|(start, value, part)| {
            let full = Table { r: vec![0.0, 1.0], y: vec![value, value * part] };
            if start < 1e-3 { full } else { Table { r: vec![0.0, start, 1.0], y: vec![value, value, value * part] } }
        })
    };
    let mass = prop_oneof![one(-1.0..1.0, -0.5..0.0), one(-1.0..1.0, -15.0..0.0)];
    (roots(0.1), mass, stiffnesses(one(0.0..6.0, -20.0..-2.0).boxed()), one(-3.0..-1.0, -8.0..0.0), power(-1.0..3.0))
        .prop_map(|(roots, mass, stiffness, polar_inertia, nominal_speed)| TestBlade {
            nominal_speed,
            roots,
            mass,
            stiffness,
            polar_inertia,
            ..TestBlade::uniform(1.0)
        })
        .boxed()
}

/// An inner part that is lighter and softer than the outer by up to sixteen decades.
fn light() -> BoxedStrategy<TestBlade> {
    (0.05..0.9_f64, power(-16.0..-3.0), power(-2.0..2.0), roots(0.04), power(-3.0..1.0))
        .prop_map(|(at, ratio, apart, roots, nominal_speed)| {
            let part = |inner: f64, outer: f64| Table::steps(&[0.0, at, 1.0], &[inner, outer]);
            TestBlade {
                roots,
                nominal_speed,
                mass: part(ratio, 1.0),
                stiffness: [part(ratio, 1.0), part(3.0 * ratio, 3.0), part(ratio, 1.0)],
                polar_inertia: part(0.1 * (ratio * apart).min(1.0), 0.1),
                ..TestBlade::uniform(1.0)
            }
        })
        .boxed()
}

/// A soft blade whose mass lies off its axis, turning so fast that the pull of the offset is nearly
/// all of the stiffness in torsion: modes crowd where the inertia is least pulled.
fn clustered() -> BoxedStrategy<TestBlade> {
    let soft = pieces(power(-2.0..0.5), 0, 3);
    let bending = || pieces(power(1.0..4.0), 0, 3).boxed();
    let stiffness = [bending(), bending(), soft.boxed()];
    let offset = prop_oneof![power(-3.0..-1.5), power(-3.0..-1.5).prop_map(|y| -y)];
    (roots(0.08), pieces(power(1.0..2.7), 0, 5), stiffness, pieces(power(-2.5..-1.0), 0, 6), offset, power(2.0..4.5))
        .prop_map(|(roots, mass, stiffness, polar_inertia, offset, nominal_speed)| {
            let mass_offset = Table::uniform(offset);
            let blade = TestBlade {
                nominal_speed,
                roots,
                mass,
                stiffness,
                polar_inertia,
                mass_offset,
                ..TestBlade::uniform(1.0)
            };
            stretched(blade, 2.3)
        })
        .boxed()
}

/// An ordinary random blade so fast that it is a string with thin boundary layers.
fn string() -> BoxedStrategy<TestBlade> {
    (random::blade(), power(1.0..3.5))
        .prop_map(|(blade, faster)| TestBlade { nominal_speed: blade.nominal_speed * faster, ..blade })
        .boxed()
}

/// Every property at random, running linearly between values that have nothing to do with each other.
fn anything() -> BoxedStrategy<TestBlade> {
    let any = |exponents: Range<f64>, none| pieces(power(exponents), none, 5).boxed();
    let stiffness = Union::new([any(-6.0..6.0, 0), any(-2.0..3.0, 0), any(3.0..5.0, 0)]);
    let offset = prop_oneof![Just(Table::uniform(0.0)), pieces((-0.5..1.5_f64).boxed(), 1, 3)];
    let masses = prop_oneof![any(-2.0..4.0, 1), any(-1.0..1.0, 1)];
    let inertia = prop_oneof![any(-5.0..5.0, 2), any(-3.0..-1.0, 0)];
    (roots(0.8), masses, stiffnesses(stiffness.boxed()), inertia, offset, power(-0.5..2.0), power(-2.0..4.0))
        .prop_map(|(roots, mass, stiffness, polar_inertia, mass_offset, radius, nominal_speed)| {
            let blade = TestBlade {
                nominal_speed,
                roots,
                mass,
                stiffness,
                polar_inertia,
                mass_offset,
                ..TestBlade::uniform(1.0)
            };
            stretched(blade, radius)
        })
        .boxed()
}

/// Hundreds of stations, values that jump or run up and down between them, slivers of 2e-9 of the span.
fn dense() -> BoxedStrategy<TestBlade> {
    let table = |unit: f64, wide: f64, most: usize| {
        let station = (0.5..1.5_f64, -wide..wide, 0..8_u32);
        prop::collection::vec(station, 20..most).prop_map(move |stations| {
            let total: f64 = stations.iter().map(|station| station.0).sum();
            let (mut r, mut y, mut at) = (vec![0.0], vec![unit], 0.0);
            for (step, exponent, what) in stations {
                at += step / total;
                let value = unit * 10_f64.powf(exponent);
                match what {
                    // A step, with the value before it kept; a sliver.
                    0 => {
                        r.extend_from_slice(&[at, at]);
                        y.extend_from_slice(&[y[y.len() - 1], value]);
                    }
                    1 => {
                        r.extend_from_slice(&[at, at + 2e-9]);
                        y.extend_from_slice(&[y[y.len() - 1], value]);
                    }
                    _ => {
                        r.push(at);
                        y.push(value);
                    }
                }
            }
            // What the sums rounded must not pass the tip.
            let tip = r[r.len() - 1].max(1.0);
            r.push(tip + 0.01);
            y.push(unit);
            let end = tip + 0.01;
            for x in &mut r {
                *x /= end;
            }
            Table { r, y }
        })
    };
    let stiffness = prop_oneof![table(1e3, 0.3, 800), table(1e3, 2.0, 400)];
    (roots(0.1), table(5.0, 0.5, 400), stiffnesses(stiffness.boxed()), table(0.01, 0.5, 100), power(-1.0..2.0))
        .prop_map(|(roots, mass, stiffness, polar_inertia, nominal_speed)| {
            let blade = TestBlade { nominal_speed, roots, mass, stiffness, polar_inertia, ..TestBlade::uniform(1.0) };
            stretched(blade, 6.0)
        })
        .boxed()
}

/// An ordinary blade with masses, stiffnesses and lengths that no unit is made for.
fn scaled() -> BoxedStrategy<TestBlade> {
    let exponent = || prop_oneof![2 => -20.0..20.0_f64, 1 => -120.0..120.0_f64];
    (random::blade(), power_of(exponent()), power_of(exponent()), power(-6.0..6.0))
        .prop_map(|(blade, stiffness, mass, radius)| {
            let radius = 10_f64.powf(radius.log10().round());
            let faster = (stiffness / mass).sqrt() / radius.powi(2);
            let mut blade = stretched(blade.scaled(stiffness, mass), radius);
            blade.nominal_speed *= faster;
            blade
        })
        .boxed()
}

fn power_of(exponents: impl Strategy<Value = f64> + 'static) -> BoxedStrategy<f64> {
    exponents.prop_map(|exponent| 10_f64.powf(exponent)).boxed()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hostile_blades_are_legal_and_repeat_themselves() {
        for number in 0..200 {
            let first = case(number);
            assert_eq!(format!("{first:?}"), format!("{:?}", case(number)), "number {number}");
            if first.kind != "far from the usual units" {
                let faults = bladefan_core::check(&first.blade.definition()).err();
                assert!(faults.is_none(), "number {number}, {}: {faults:?}", first.kind);
            }
        }
    }
}
