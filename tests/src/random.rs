//! Random valid blades for property tests: steps of up to 1000 : 1, every kind of root, offsets to
//! a tenth of the radius, each property on radii of its own, roots without inertia.

use crate::blades::{End, Hold, Table, TestBlade};
use crate::coupled::PointMass;
use bladefan_core::Dof;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};

/// All radii are multiples of this part of the tip radius, so that sampled shapes can be
/// integrated piece by piece.
pub const GRID: usize = 200;

/// The grid step at radius `r`, which is a multiple of `radius` / [`GRID`].
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to GRID")]
pub fn step_at(r: f64, radius: f64) -> usize {
    (r / radius * GRID as f64).round() as usize
}

/// Pieces of a property: where each begins (in grid steps) and its values at both ends, as powers
/// of ten; `None` is a stretch without inertia.
type Pieces = Vec<(usize, Option<(f64, f64)>)>;

/// 1 to 5 pieces with values of `decades` about 1; each piece constant or linear. Where `bare`, the
/// innermost piece of some has no inertia, as a root cut-out in real tables; never more than half the span.
fn pieces(decades: f64, bare: bool) -> impl Strategy<Value = Pieces> {
    let half = 0.5 * decades;
    let ends = (-half..half, -half..half, any::<bool>()).prop_map(|(a, b, flat)| (a, if flat { a } else { b }));
    let rest = prop::collection::vec((1..GRID, ends.clone()), 0..=4);
    (ends, rest, any::<bool>()).prop_map(move |(first, rest, cut)| {
        let mut pieces: Pieces = vec![(0, Some(first))];
        pieces.extend(rest.into_iter().map(|(from, ends)| (from, Some(ends))));
        pieces.sort_by_key(|piece| piece.0);
        pieces.dedup_by_key(|piece| piece.0);
        if bare && cut && pieces.get(1).is_some_and(|second| second.0 <= GRID / 2) {
            pieces[0].1 = None;
        }
        pieces
    })
}

fn table(pieces: &Pieces, radius: f64, unit: f64) -> Table {
    let at = |step: usize| radius * step as f64 / GRID as f64;
    let (mut r, mut y) = (Vec::new(), Vec::new());
    for (i, (from, powers)) in pieces.iter().enumerate() {
        let to = pieces.get(i + 1).map_or(GRID, |next| next.0);
        let (a, b) = powers.map_or((0.0, 0.0), |(a, b)| (unit * 10_f64.powf(a), unit * 10_f64.powf(b)));
        r.extend_from_slice(&[at(*from), at(to)]);
        y.extend_from_slice(&[a, b]);
    }
    Table { r, y }
}

fn hold() -> impl Strategy<Value = Hold> {
    prop_oneof![
        Just(Hold::Clamped),
        Just(Hold::Free),
        (-3.0..3.0).prop_map(|power: f64| Hold::Spring(10_f64.powf(power)))
    ]
}

/// A random valid blade. Its nominal speed is 0.1 to 30 times √(EI/m)/l² at mid-span: from almost
/// at rest to a blade that is nearly a string.
pub fn blade() -> impl Strategy<Value = TestBlade> {
    let roots = [(0..=GRID / 10, hold()), (0..=GRID / 10, hold()), (0..=GRID / 10, hold())];
    let properties = (
        pieces(2.0, true),
        [pieces(3.0, false), pieces(3.0, false), pieces(3.0, false)],
        pieces(2.0, true),
        pieces(1.0, true),
    );
    (0.3..12.0_f64, -1.0..2.0_f64, -1.0..5.0_f64, -1.0..1.5_f64, roots, properties).prop_map(
        |(radius, mass_power, stiffness_power, speed_power, roots, (mass, stiffness, inertia, offset))| {
            let (mass_unit, stiffness_unit) = (10_f64.powf(mass_power), 10_f64.powf(stiffness_power));
            let roots = roots.map(|(step, hold)| {
                let hold = match hold {
                    Hold::Spring(k) => Hold::Spring(k * stiffness_unit / radius),
                    other => other,
                };
                End { offset: radius * step as f64 / GRID as f64, hold }
            });
            let reference = (stiffness_unit / mass_unit).sqrt() / (radius * radius);
            TestBlade {
                radius,
                nominal_speed: reference * 10_f64.powf(speed_power),
                roots,
                mass: table(&mass, radius, mass_unit),
                stiffness: stiffness.map(|pieces| table(&pieces, radius, stiffness_unit)),
                polar_inertia: table(&inertia, radius, 1e-3 * mass_unit * radius * radius),
                mass_offset: table(&offset, radius, 1e-2 * radius),
                point_masses: Vec::new(),
                inertias: None,
            }
        },
    )
}

/// A random blade with one to three point masses, each up to ten times as heavy as an average blade.
pub fn laden() -> impl Strategy<Value = TestBlade> {
    let mass = (1..=GRID, -2.0..1.0_f64, -0.03..0.03_f64, 0.0..1.0_f64, 0.0..1.0_f64);
    (blade(), prop::collection::vec(mass, 1..=3)).prop_map(|(mut blade, masses)| {
        let last = blade.mass.y.len() - 1;
        let unit = blade.mass.y[last] * blade.radius;
        blade.point_masses.extend(masses.into_iter().map(|(step, power, offset, flap, lag)| {
            let (mass, offset) = (unit * 10_f64.powf(power), offset * blade.radius);
            let extent = 1e-3 * mass * blade.radius * blade.radius;
            let inertia = [extent * flap, mass * offset * offset + extent * lag];
            PointMass { r: blade.radius * step as f64 / GRID as f64, mass, offset, inertia }
        }));
        // A mass inboard of every root is none of the blade's.
        blade.point_masses.retain(|mass| blade.roots.iter().any(|root| mass.r >= root.offset));
        blade
    })
}

/// A random blade with point masses and both inertias, for the full propeller moment: which of them is the larger
/// may change from piece to piece.
pub fn racket() -> impl Strategy<Value = TestBlade> {
    (laden(), 0.0..1.0_f64, any::<bool>()).prop_map(|(mut blade, share, changes)| {
        let polar = &blade.polar_inertia;
        let part = |share: f64| {
            let at = |(i, y): (usize, &f64)| y * if changes && i % 4 > 1 { 1.0 - share } else { share };
            Table { r: polar.r.clone(), y: polar.y.iter().enumerate().map(at).collect() }
        };
        blade.inertias = Some([part(share), part(1.0 - share)]);
        blade
    })
}

/// A random degree of freedom.
pub fn dof() -> impl Strategy<Value = Dof> {
    prop_oneof![Just(Dof::Flap), Just(Dof::Lag), Just(Dof::Torsion)]
}

/// As many cases as a test asks for (or `PROPTEST_CASES`), from a fixed seed: a run repeats itself
/// on every machine. `PROPTEST_RNG_SEED` tries others.
pub fn cases(count: u32) -> ProptestConfig {
    part_of_cases(0, count)
}

/// The same for one of several tests that share the cases of one property: each `part` has others.
pub fn part_of_cases(part: u64, count: u32) -> ProptestConfig {
    let mut config = ProptestConfig { failure_persistence: None, ..ProptestConfig::default() };
    if std::env::var_os("PROPTEST_CASES").is_none() {
        config.cases = count;
    }
    let seed = match config.rng_seed {
        prop::test_runner::RngSeed::Fixed(seed) => seed,
        prop::test_runner::RngSeed::Random => 4021,
    };
    config.rng_seed = prop::test_runner::RngSeed::Fixed(seed.wrapping_add(part));
    config
}

/// The first `count` values of a strategy from a fixed seed: the same on every machine.
pub fn draw<S: Strategy>(strategy: &S, count: usize, seed: u64) -> Vec<S::Value> {
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
    let mut runner = TestRunner::new_with_rng(ProptestConfig::default(), rng);
    (0..count).map(|_| strategy.new_tree(&mut runner).unwrap().current()).collect()
}
