//! What must hold for every coupled blade, tried on random ones.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use bladefan_core::report::{Branch, CoupledModeReport};
use bladefan_core::units::{AngleUnit, ForceUnit, LengthUnit, MassUnit, Units};
use bladefan_core::{
    BladeDefinition, Dof, ModelKind, PropellerMoment, Settings, SpeedRange, check, coupled_modes, fan, modes,
};
use bladefan_tests::blades::{End, Table};
use bladefan_tests::coupled::random::{Case, case};
use bladefan_tests::coupled::{CoupledBlade, Trapeze};
use bladefan_tests::random::cases;
use proptest::prelude::*;

/// Modes asked for.
const MODES: usize = 10;
/// Eigenvalues of equations that differ in nothing but rounding: seen up to 8e-14 in 300 blades.
const ROUNDING: f64 = 1e-12;
/// Eigenvalues on different elements or orders, each of them converged to 1e-11: seen up to 9e-12.
const CONVERGED: f64 = 1e-10;
/// Below this share of the highest eigenvalue differences are measured against that share, as the solver measures
/// its own errors: rounding has the size of the highest.
const FLOOR: f64 = 1e-4;

type Tried<T> = Result<T, TestCaseError>;

fn settings(blade: &CoupledBlade, speed: f64) -> Settings {
    Settings {
        speed: Some(speed),
        model: Some(ModelKind::Coupled),
        coupled_modes: MODES,
        rotary: blade.rotary,
        ..Settings::default()
    }
}

fn solve_as(definition: &BladeDefinition, settings: &Settings) -> Tried<Vec<CoupledModeReport>> {
    let failed = |faults: bladefan_core::Faults| TestCaseError::fail(faults.to_string());
    let report = coupled_modes(&check(definition).map_err(failed)?, settings).map_err(failed)?;
    prop_assert_eq!(report.modes.len(), MODES);
    Ok(report.modes)
}

fn solve(blade: &CoupledBlade, speed: f64) -> Tried<Vec<CoupledModeReport>> {
    solve_as(&blade.definition(), &settings(blade, speed))
}

/// What an eigenvalue is measured against.
fn sizes(modes: &[CoupledModeReport]) -> Vec<f64> {
    let all = || modes.iter().map(|mode| mode.eigenvalue_s2.abs());
    let highest = all().fold(0.0, f64::max);
    all().map(|size| size.max(FLOOR * highest)).collect()
}

/// The eigenvalues of `after` are those of `before` times `factor`.
fn same(before: &[CoupledModeReport], after: &[CoupledModeReport], factor: f64, tolerance: f64) -> Tried<()> {
    for ((a, b), size) in before.iter().zip(after).zip(sizes(before)) {
        let (a, b) = (a.eigenvalue_s2, b.eigenvalue_s2 / factor);
        prop_assert!((a - b).abs() <= tolerance * size, "{} of {}: {} against {}", (a - b).abs() / size, size, a, b);
    }
    Ok(())
}

/// Of each mode whose eigenvalue is its own, the shares: where two are one, any mixture of them is a mode.
fn shares(modes: &[CoupledModeReport]) -> Vec<Option<[f64; 3]>> {
    let sizes = sizes(modes);
    let apart = |i: usize, j: usize| (modes[i].eigenvalue_s2 - modes[j].eigenvalue_s2).abs() > APART * sizes[i];
    let alone = |i: usize| (i == 0 || apart(i, i - 1)) && i + 1 < modes.len() && apart(i, i + 1);
    let own = |i: usize| alone(i).then(|| [modes[i].shares.flap, modes[i].shares.lag, modes[i].shares.torsion]);
    (0..modes.len()).map(own).collect()
}

/// How far, in size, an eigenvalue is from its neighbours where its mode is looked at.
const APART: f64 = 1e-3;
/// What rounding leaves of another mode in a vector, in proportion: rounding of a value over the distance to the
/// next. Shares, which are squares, change by twice that, and by its square where there was nothing.
const LEFT: f64 = ROUNDING / APART;

/// The blade with nothing that couples its motions.
fn uncoupled(blade: &CoupledBlade) -> CoupledBlade {
    CoupledBlade {
        twist: Table::uniform(0.0),
        pitch: 0.0,
        precone: 0.0,
        spring_angle: 0.0,
        trapeze: Trapeze::Off,
        rotary: false,
        point_masses: Vec::new(),
        ..blade.with_offsets(0.0)
    }
}

/// The coupled modes beside those of each motion on its own: λ to 1e-13 and what the proven intervals of both leave
/// open, and no share of another motion.
fn reduces(blade: &CoupledBlade, paper_moment: bool, alone: &CoupledBlade, speed: f64) -> Tried<()> {
    let propeller_moment = Some(if paper_moment { PropellerMoment::Paper } else { PropellerMoment::Full });
    let coupled = solve_as(&blade.definition(), &Settings { propeller_moment, ..settings(blade, speed) })?;
    let alone = check(&alone.definition()).map_err(|faults| TestCaseError::fail(faults.to_string()))?;
    let settings =
        Settings { speed: Some(speed), modes: MODES, model: Some(ModelKind::Uncoupled), ..Settings::default() };
    let mut alone = modes(&alone, &settings).unwrap().modes;
    alone.sort_by(|a, b| a.frequency_rad_s.total_cmp(&b.frequency_rad_s));
    for ((a, b), size) in coupled.iter().zip(&alone).zip(sizes(&coupled)) {
        let [low, value, up] = [b.lower_rad_s.unwrap(), b.frequency_rad_s, b.upper_rad_s.unwrap()].map(|f| f * f);
        let open = (up - low) + (a.upper_eigenvalue_s2.unwrap() - a.lower_eigenvalue_s2.unwrap());
        let off = (a.eigenvalue_s2 - value).abs();
        prop_assert!(off <= 1e-13 * size + open, "{}: {} against {}", b.label, a.eigenvalue_s2, value);
    }
    for (parts, b) in shares(&coupled).into_iter().zip(&alone) {
        let Some(parts) = parts else { continue };
        for dof in Dof::ALL.into_iter().filter(|dof| *dof != b.dof) {
            prop_assert!(parts[dof.index()].abs() < LEFT * LEFT, "{}: {:?}", b.label, parts);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(30))]

    /// In a mirror beside the blade or below it everything swings as before. Without precone the signs of angles and
    /// of offsets are free by themselves, too: −v is as good as v, −φ as good as φ.
    #[test]
    fn a_mirror_changes_nothing(number in 0..1_000_000_u64) {
        let Case { blade, speed } = case(number);
        let before = solve(&blade, speed)?;
        same(&before, &solve(&blade.mirrored_in_plane(), speed)?, 1.0, ROUNDING)?;
        same(&before, &solve(&blade.mirrored_out_of_plane(), speed)?, 1.0, ROUNDING)?;
        let flat = CoupledBlade { precone: 0.0, ..blade };
        let before = solve(&flat, speed)?;
        same(&before, &solve(&flat.with_angles(-1.0), speed)?, 1.0, ROUNDING)?;
        same(&before, &solve(&flat.with_offsets(-1.0), speed)?, 1.0, ROUNDING)?;
    }

    /// At rest no plane is distinguished: a quarter turn makes flap of lag, where their roots are exchanged. At speed
    /// the disc plane is: lag is softened by up to Ω², and some eigenvalue changes by a good part of that (seen: 0.38 at
    /// least).
    #[test]
    fn a_quarter_turn_makes_flap_of_lag_at_rest_alone(number in 0..1_000_000_u64) {
        let Case { blade, speed } = case(number);
        let turned = blade.a_quarter_turn_up().with_bending_roots_exchanged();
        let (before, after) = (solve(&blade, 0.0)?, solve(&turned, 0.0)?);
        same(&before, &after, 1.0, ROUNDING)?;
        for (before, after) in shares(&before).into_iter().zip(shares(&after)) {
            let (Some([flap, lag, torsion]), Some(after)) = (before, after) else { continue };
            for (a, b) in [lag, flap, torsion].iter().zip(after) {
                prop_assert!((a - b).abs() < 2.0 * LEFT, "{:?} against {:?}", before, after);
            }
        }
        if speed > 0.0 {
            let change = |(a, b): (&CoupledModeReport, &CoupledModeReport)| (a.eigenvalue_s2 - b.eigenvalue_s2).abs();
            let most = solve(&blade, speed)?.iter().zip(&solve(&turned, speed)?).map(change).fold(0.0, f64::max);
            prop_assert!(most > 0.1 * speed * speed, "{} of {}", most, speed * speed);
        }
    }

    /// Without offsets a quarter turn of the section is the exchange of its axes, at every speed.
    #[test]
    fn a_quarter_turn_exchanges_the_axes_of_a_section(number in 0..1_000_000_u64) {
        let Case { blade, speed } = case(number);
        let blade = blade.with_offsets(0.0);
        let turned = solve(&blade.a_quarter_turn_up(), speed)?;
        same(&turned, &solve(&blade.with_axes_exchanged(), speed)?, 1.0, ROUNDING)?;
    }

    /// A section that is the same about every axis has no angle.
    #[test]
    fn round_sections_do_not_feel_pitch_and_twist(number in 0..1_000_000_u64, pitch in -2.0..2.0_f64) {
        let Case { blade, speed } = case(number);
        let mut round = blade.with_offsets(0.0);
        round.bending[1] = round.bending[0].clone();
        round.inertia[1] = round.inertia[0].clone();
        round.point_masses.iter_mut().for_each(|mass| mass.inertia[1] = mass.inertia[0]);
        let before = solve(&round, speed)?;
        same(&before, &solve(&CoupledBlade { pitch, ..round.clone() }, speed)?, 1.0, ROUNDING)?;
        // The twist decides on the number of elements.
        same(&before, &solve(&CoupledBlade { twist: Table::uniform(0.0), ..round }, speed)?, 1.0, CONVERGED)?;
    }

    /// Turned in the disc plane about the rotor's axis, a rigid blade is where it was, whatever its angles and offsets:
    /// exactly 0 at every speed.
    #[test]
    fn rigid_lag_costs_nothing(number in 0..1_000_000_u64) {
        let Case { mut blade, speed } = case(number);
        (blade.precone, blade.spring_angle) = (0.0, 0.0);
        blade.roots[1] = End::free(0.0);
        let zero = |mode: &CoupledModeReport| {
            let bounds = [mode.lower_eigenvalue_s2, mode.upper_eigenvalue_s2, mode.lower_rad_s, mode.upper_rad_s];
            mode.eigenvalue_s2 == 0.0 && bounds == [Some(0.0); 4]
        };
        let found = solve(&blade, speed)?;
        // Of the other roots only a free one adds to it, and only at rest.
        let free = blade.roots.iter().filter(|root| root.hold == End::free(0.0).hold).count();
        let expected = if speed > 0.0 { 1 } else { free };
        prop_assert_eq!(found.iter().filter(|mode| zero(mode)).count(), expected, "{:?}", found);
        if speed > 0.0 {
            let mut definition = blade.definition();
            definition.rotor.as_mut().unwrap().nominal_speed = Some(speed);
            let speeds = Some(SpeedRange { from: 0.0, to: speed, count: 4 });
            let chart = fan(&check(&definition).unwrap(), &Settings { speeds, ..settings(&blade, speed) }).unwrap();
            for at in 0..4 {
                let here = |branch: &Branch| (branch.frequency_rad_s[at], branch.lower_rad_s[at], branch.upper_rad_s[at]);
                let zeros = chart.branches.iter().filter(|branch| here(branch) == (0.0, Some(0.0), Some(0.0))).count();
                prop_assert_eq!(zeros, if at == 0 { free } else { 1 }, "{:?}", chart.branches);
            }
        }
    }

    /// Tilted about the rotor's axis, a rigid blade flaps once per revolution, whatever its angles and offsets: its
    /// rotary inertia apart, the centrifugal forces are Ω² times its inertia.
    #[test]
    fn rigid_flap_has_the_speed_of_the_rotor(number in 0..1_000_000_u64) {
        let Case { mut blade, speed } = case(number);
        (blade.precone, blade.spring_angle, blade.rotary) = (0.0, 0.0, false);
        blade.roots[0] = End::free(0.0);
        let found = solve(&blade, speed)?;
        let square = speed * speed;
        let highest = found.iter().map(|mode| mode.eigenvalue_s2.abs()).fold(0.0, f64::max);
        let off = found.iter().map(|mode| (mode.eigenvalue_s2 - square).abs()).fold(f64::INFINITY, f64::min);
        prop_assert!(off <= ROUNDING * square.max(FLOOR * highest), "{} off {}", off, square);
    }

    /// Section 5 of the formulation: with nothing that couples, the three motions on their own.
    #[test]
    fn without_coupling_it_is_the_uncoupled_model(number in 0..1_000_000_u64) {
        let Case { blade, speed } = case(number);
        let blade = uncoupled(&blade);
        // No propeller moment on either side: no mass offset in the paper's, equal inertias in the full one.
        reduces(&blade, true, &blade, speed)?;
        let mut square = blade.clone();
        square.inertia[1] = square.inertia[0].clone();
        reduces(&square, false, &square, speed)?;
        // All mass in a line at Y: the paper's m Y² is the full moment of I₁ = 0, I₂ = m Y².
        let offset = 0.02 * blade.radius;
        let inertia = [Table::uniform(0.0), blade.mass.times(offset * offset)];
        let thin = CoupledBlade { inertia, ..blade };
        let line = CoupledBlade { mass_offset: Table::uniform(offset), ..thin.clone() };
        reduces(&thin, false, &line, speed)?;
    }

    /// Masses and stiffnesses together times anything is the same motion; stiffnesses × s² and speed × s is the same
    /// blade on a faster clock; and a blade may be built in any size.
    #[test]
    fn scales_change_what_they_should(number in 0..1_000_000_u64, s in 0.05..20.0_f64) {
        let Case { blade, speed } = case(number);
        let before = solve(&blade, speed)?;
        same(&before, &solve(&blade.scaled(s, s), speed)?, 1.0, ROUNDING)?;
        same(&before, &solve(&blade.enlarged(s), speed)?, 1.0, ROUNDING)?;
        // The grid on which eigenvalues are tried for the layout does not scale: other orders.
        same(&before, &solve(&blade.scaled(1.0, s * s), s * speed)?, s * s, CONVERGED)?;
    }

    #[test]
    fn units_of_the_definition_do_not_matter(number in 0..1_000_000_u64) {
        let Case { blade, speed } = case(number);
        let before = solve(&blade, speed)?;
        // NIST SP 811: inch, pound, standard gravity; written out here so that the product's factors are tested too.
        let (inch, pound, gravity) = (0.0254, 0.453_592_37, 9.806_65);
        let slug = pound * gravity / (12.0 * inch);
        for (length, mass, force, [si_length, si_mass, si_force]) in [
            (LengthUnit::Inch, MassUnit::Slug, ForceUnit::PoundForce, [inch, slug, pound * gravity]),
            (LengthUnit::Millimetre, MassUnit::Gram, ForceUnit::Kilonewton, [1e-3, 1e-3, 1e3]),
        ] {
            let degrees = f64::to_degrees(1.0);
            let written = blade.in_units(1.0 / si_length, 1.0 / si_mass, 1.0 / si_force).with_angles(degrees);
            let mut definition = CoupledBlade { precone: degrees * blade.precone, ..written }.definition();
            definition.units = Units { length, mass, force, angle: AngleUnit::Degree, ..Units::default() };
            same(&before, &solve_as(&definition, &settings(&blade, speed))?, 1.0, ROUNDING)?;
        }
    }
}
