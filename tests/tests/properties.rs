//! What must hold for every blade, tried on random ones.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use bladefan_core::BasisFamily;
use bladefan_core::Dof;
use bladefan_core::FaultCode;
use bladefan_core::units::{AngleUnit, ForceUnit, LengthUnit, MassUnit, SpeedUnit, Units};
use bladefan_core::{BladeDefinition, Property, PropertyDefinition, check};
use bladefan_core::{ModelKind, Settings, ShapeScale, SpeedRange, converge, fan, modes, shapes};
use bladefan_tests::blades::{End, Hold, Table, TestBlade};
use bladefan_tests::random::{GRID, blade, cases, dof, step_at};
use bladefan_tests::solve::{frequencies, settings, solve};
use proptest::prelude::*;

/// Rounding of one frequency.
const ROUNDING: f64 = 1e-9;

/// Frequencies that are equal but for rounding.
fn same(a: &[f64], b: &[f64], tolerance: f64) -> Result<(), TestCaseError> {
    prop_assert_eq!(a.len(), b.len());
    for (x, y) in a.iter().zip(b) {
        prop_assert!((x - y).abs() <= tolerance * x.abs(), "{:?} against {:?}", a, b);
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(48))]

    /// Rayleigh and Ritz: a larger set of functions that holds the smaller cannot raise a frequency.
    #[test]
    fn more_functions_never_raise_a_frequency(blade in blade(), dof in dof(), part in 0.0..1.5_f64) {
        let speed = part * blade.nominal_speed;
        let mut before = frequencies(&blade, dof, speed, 6, 5);
        for functions in [7, 9, 12, 16, 24, 40] {
            let now = frequencies(&blade, dof, speed, functions, 5);
            for (n, b) in now.iter().zip(&before) {
                prop_assert!(*n <= b * (1.0 + ROUNDING), "{} functions: {:?} after {:?}", functions, now, before);
            }
            before = now;
        }
    }

    /// Stiffness × s² and speed × s is the same blade on a faster clock.
    #[test]
    fn stiffness_and_speed_scale_frequencies(blade in blade(), dof in dof(), s in 0.05..20.0_f64) {
        let speed = blade.nominal_speed;
        let before = frequencies(&blade, dof, speed, 15, 5);
        let after = frequencies(&blade.scaled(s * s, 1.0), dof, s * speed, 15, 5);
        same(&before.iter().map(|f| f * s).collect::<Vec<_>>(), &after, ROUNDING)?;
    }

    /// Mass and stiffness together times anything is the same motion.
    #[test]
    fn mass_and_stiffness_together_change_nothing(blade in blade(), dof in dof(), s in 0.01..100.0_f64) {
        let speed = blade.nominal_speed;
        let before = frequencies(&blade, dof, speed, 15, 5);
        same(&before, &frequencies(&blade.scaled(s, s), dof, speed, 15, 5), ROUNDING)?;
    }

    #[test]
    fn units_of_the_definition_do_not_matter(blade in blade(), dof in dof()) {
        let speed = blade.nominal_speed;
        let before = frequencies(&blade, dof, speed, 15, 5);
        let imperial = check(&in_inches(&blade)).map_err(|faults| TestCaseError::fail(format!("{faults:?}")))?;
        prop_assert!((imperial.nominal_speed() / speed - 1.0).abs() < 1e-14);
        let after: Vec<f64> = solve(&imperial, dof, speed, 15, 5).iter().map(|mode| mode.frequency_rad_s).collect();
        same(&before, &after, ROUNDING)?;
    }

    /// Centrifugal stiffening: ∫ T w′² is not negative, nor is ∫ m Y² θ².
    #[test]
    fn flap_and_torsion_rise_with_speed(blade in blade(), torsion in any::<bool>()) {
        let dof = if torsion { Dof::Torsion } else { Dof::Flap };
        let mut before = frequencies(&blade, dof, 0.0, 15, 5);
        for part in [0.1, 0.5, 1.0, 1.5] {
            let now = frequencies(&blade, dof, part * blade.nominal_speed, 15, 5);
            for (n, b) in now.iter().zip(&before) {
                prop_assert!(*n >= b * (1.0 - ROUNDING), "{:?} after {:?}", now, before);
            }
            before = now;
        }
    }

    /// Same stiffness, same root: the lag motion also loses Ω² ∫ m w².
    #[test]
    fn lag_is_flap_less_the_square_of_the_speed(mut blade in blade(), part in 0.0..1.5_f64) {
        blade.stiffness[1] = blade.stiffness[0].clone();
        blade.roots[1] = blade.roots[0];
        let speed = part * blade.nominal_speed;
        let flap = frequencies(&blade, Dof::Flap, speed, 15, 5);
        for (f, l) in flap.iter().zip(frequencies(&blade, Dof::Lag, speed, 15, 5)) {
            prop_assert!((l * l - (f * f - speed * speed)).abs() <= ROUNDING * f * f, "flap {}, lag {}, Ω {}", f, l, speed);
        }
    }

    #[test]
    fn residuals_are_small_and_numbers_finite(blade in blade(), dof in dof(), part in 0.0..1.5_f64) {
        for functions in [5, 15, 60] {
            for mode in solve(&blade.blade(), dof, part * blade.nominal_speed, functions, 5) {
                prop_assert!(mode.frequency_rad_s.is_finite() && mode.frequency_rad_s >= 0.0);
                prop_assert!(mode.residual >= 0.0 && mode.residual < RESIDUAL, "{:?}", mode);
            }
        }
    }

    /// Eq. 84–85, by the test's own sums over the sampled shapes.
    #[test]
    fn mode_shapes_are_orthogonal(mut blade in blade(), dof in dof(), part in 0.0..1.5_f64) {
        // One root radius for all, so that the samples fall on the grid of the stations.
        let offset = blade.roots[dof.index()].offset;
        blade.roots.iter_mut().for_each(|root| root.offset = offset);
        let first = step_at(offset, blade.radius);
        let settings = Settings {
            points: (GRID - first) * FINE + 1,
            normalise: ShapeScale::Mass,
            ..settings(dof, part * blade.nominal_speed, 15, 5)
        };
        let report = shapes(&blade.blade(), &settings).unwrap();
        let inertia = if dof == Dof::Torsion { &blade.polar_inertia } else { &blade.mass };
        let step = blade.radius / (GRID * FINE) as f64;
        let product = |i: usize, j: usize| -> f64 {
            (first..GRID).map(|cell| {
                let values = |k: usize| report.shapes[i].displacement[k] * report.shapes[j].displacement[k];
                let from = (cell - first) * FINE;
                simpson((0..=FINE).map(|k| values(from + k) * within(inertia, blade.radius, cell, k)), step)
            }).sum()
        };
        for i in 0..5 {
            for j in 0..i {
                let cosine = product(i, j) / (product(i, i) * product(j, j)).sqrt();
                prop_assert!(cosine.abs() < ORTHOGONAL, "modes {} and {}: {:e}", i + 1, j + 1, cosine);
            }
        }
    }

    /// Each crossing lies on its ray and on its branch, and none is missed.
    #[test]
    fn crossings_lie_on_ray_and_branch(blade in blade()) {
        let checked = blade.blade();
        let range = SpeedRange { from: 0.0, to: 1.5 * blade.nominal_speed, count: 31 };
        let settings = Settings { basis: BasisFamily::Classical, speeds: Some(range), modes: 3, ..Settings::of(ModelKind::Uncoupled) };
        let chart = fan(&checked, &settings).unwrap();
        for crossing in &chart.crossings {
            let ray = f64::from(crossing.harmonic) * crossing.speed_rad_s;
            prop_assert!(crossing.speed_rad_s > 0.0 && crossing.speed_rad_s <= range.to);
            prop_assert!((crossing.frequency_rad_s / ray - 1.0).abs() < CROSSING, "{:?}", crossing);
            let branch = chart.branches.iter().find(|branch| branch.label == crossing.label).unwrap();
            let there = solve(&checked, branch.dof, crossing.speed_rad_s, 15, 3)[branch.number - 1].frequency_rad_s;
            prop_assert!((there / ray - 1.0).abs() < CROSSING, "{:?}: branch at {}", crossing, there);
        }
        for branch in &chart.branches {
            for harmonic in 1..=chart.harmonics {
                if chart.coincident.iter().any(|c| c.label == branch.label && c.harmonic == harmonic) {
                    continue;
                }
                let above = |i: usize| branch.frequency_rad_s[i] - f64::from(harmonic) * chart.speeds_rad_s[i];
                for i in 1..chart.speeds_rad_s.len() - 1 {
                    let (low, high) = (chart.speeds_rad_s[i], chart.speeds_rad_s[i + 1]);
                    // Clear of rounding on both sides.
                    let clear = |i: usize| above(i).abs() > 1e-6 * branch.frequency_rad_s[i];
                    if clear(i) && clear(i + 1) && above(i) * above(i + 1) < 0.0 {
                        let there = chart.crossings.iter().any(|c| c.label == branch.label && c.harmonic == harmonic
                            && (low..=high).contains(&c.speed_rad_s));
                        prop_assert!(there, "{} and {}P cross between {} and {}", branch.label, harmonic, low, high);
                    }
                }
            }
        }
    }

    /// With φ = x among the functions, the Lagrange equation of that function is the balance of
    /// moments about the hinge: the moment there vanishes for any number of functions.
    #[test]
    fn no_moment_at_a_free_hinge(blade in blade(), lag in any::<bool>(), part in 0.05..1.5_f64) {
        let dof = if lag { Dof::Lag } else { Dof::Flap };
        let offset = blade.roots[dof.index()].offset;
        let mut blade = blade.with_root(dof, End::free(offset));
        blade.roots.iter_mut().for_each(|root| root.offset = offset);
        let report = shapes(&blade.blade(), &settings(dof, part * blade.nominal_speed, 15, 5)).unwrap();
        let size = |moment: &[f64]| moment.iter().fold(0.0_f64, |most, m| most.max(m.abs()));
        let all = report.shapes.iter().fold(0.0_f64, |most, shape| most.max(size(&shape.moment)));
        for shape in &report.shapes {
            // A uniform blade's first mode is straight: its moment is rounding everywhere.
            let allowed = MOMENT * size(&shape.moment) + STRAIGHT * all;
            prop_assert!(shape.moment[0].abs() <= allowed, "{}: {} of {}", shape.label, shape.moment[0], allowed);
        }
    }

    /// Chart, shapes and convergence study show what the eigenproblem at that speed gives; the chart is interpolated.
    #[test]
    fn commands_agree(blade in blade(), dof in dof(), index in 0..41_usize) {
        let checked = blade.blade();
        let range = SpeedRange { from: 0.0, to: 1.5 * blade.nominal_speed, count: 41 };
        let settings = Settings { speeds: Some(range), up_to: 15, ..settings(dof, range.speeds()[index], 15, 5) };
        let solved: Vec<f64> = solve(&checked, dof, range.speeds()[index], 15, 5).iter().map(|m| m.frequency_rad_s).collect();
        let chart: Vec<f64> = fan(&checked, &settings).unwrap().branches.iter().map(|b| b.frequency_rad_s[index]).collect();
        same(&solved, &chart, ROUNDING)?;
        let shapes: Vec<f64> = shapes(&checked, &settings).unwrap().shapes.iter().map(|s| s.frequency_rad_s).collect();
        same(&solved, &shapes, ROUNDING)?;
        let studied: Option<Vec<f64>> =
            converge(&checked, &settings).unwrap().series.iter().map(|s| s.classical_rad_s[14]).collect();
        same(&solved, &studied.unwrap(), ROUNDING)?;
    }

    /// Southwell's line starts on the branch, touches it, and stays above the first one.
    #[test]
    fn southwell_line_touches_the_branch_at_rest(blade in blade(), dof in dof()) {
        let checked = blade.blade();
        let settings = Settings {
            speeds: Some(SpeedRange { from: 0.0, to: 1.5 * blade.nominal_speed, count: 7 }),
            ..settings(dof, 0.0, 15, 3)
        };
        let chart = fan(&checked, &settings).unwrap();
        for branch in &chart.branches {
            let (k0, k1) = (branch.southwell.k0, branch.southwell.k1);
            prop_assert!((branch.frequency_rad_s[0].powi(2) - k0).abs() <= ROUNDING * k0, "{:?}", branch);
            if branch.number == 1 {
                for (f, speed) in branch.frequency_rad_s.iter().zip(&chart.speeds_rad_s) {
                    let line = k0 + k1 * speed * speed;
                    prop_assert!(f * f <= line + ROUNDING * (k0 + k1.abs() * speed * speed), "{} above {}", f * f, line);
                }
            }
            // A speed at which the centrifugal part is a thousandth of the elastic one, or any for a rigid motion.
            let step = if k0 > 0.0 { (1e-3 * k0 / k1.abs().max(1e-6)).sqrt() } else { 1e-3 * blade.nominal_speed };
            let there = frequencies(&blade, dof, step, 15, 3)[branch.number - 1].powi(2);
            let slope = (there - k0) / (step * step);
            prop_assert!((slope - k1).abs() <= 0.1 * k1.abs().max(0.1), "{}: slope {} against {}", branch.label, slope, k1);
        }
    }

    /// Blades that no one builds: numbers within twelve orders of 1, mass near the tip only. An answer in finite numbers, or a
    /// fault that says why there is none.
    #[test]
    fn hostile_numbers_end_in_an_answer_or_a_fault(
powers in prop::array::uniform5(-12.0..12.0_f64),
        step in -4.0..4.0_f64,
        bare in prop_oneof![Just(0.0), 0.5..0.999_f64],
        dof in dof(),
        hold in 0..3_usize,
        functions in prop_oneof![Just(5_usize), Just(15), Just(30)],
    ) {
        let [radius, mass, stiffness, spring, speed] = powers.map(|power| 10_f64.powf(power));
        let step = 10_f64.powf(step);
        let hold = [Hold::Clamped, Hold::Free, Hold::Spring(spring)][hold];
        let inertia = if bare > 0.0 {
            Table { r: vec![0.0, bare * radius, bare * radius, radius], y: vec![0.0, 0.0, mass, mass] }
        } else {
            Table::uniform(mass)
        };
        let stepped = Table { r: [0.0, 0.3, 0.3, 1.0].map(|x| x * radius).into(), y: vec![stiffness, stiffness, stiffness * step, stiffness * step] };
        let blade = TestBlade {
            nominal_speed: speed,
            mass: inertia.clone(),
            polar_inertia: inertia,
            stiffness: [stepped.clone(), stepped.clone(), stepped],
            ..TestBlade::uniform(radius)
        }
        .with_root(dof, End { offset: 0.0, hold });
        let Ok(checked) = check(&blade.definition()) else { return Ok(()) };
        for speed in [0.0, speed] {
            let settings = settings(dof, speed, functions, 5);
            match modes(&checked, &settings) {
                Ok(report) => {
                    let found: Vec<f64> = report.modes.iter().map(|mode| mode.frequency_rad_s).collect();
                    prop_assert!(found.iter().all(|f| f.is_finite() && *f >= 0.0), "{:?}", found);
                    prop_assert!(found.windows(2).all(|pair| pair[0] <= pair[1]), "{:?}", found);
                }
                Err(faults) => prop_assert!(!faults.is_empty() && faults.iter().all(|f| f.code == FaultCode::Unsolvable)),
            }
            if let Ok(report) = shapes(&checked, &settings) {
                for shape in &report.shapes {
                    let numbers = shape.displacement.iter().chain(&shape.slope);
                    prop_assert!(numbers.clone().all(|v| v.is_finite()), "{:?} {:?}", shape.label, shape.displacement);
                }
            }
        }
        if let Ok(chart) = fan(&checked, &Settings { speeds: None, ..settings(dof, 0.0, functions, 5) }) {
            prop_assert!(chart.branches.iter().flat_map(|b| &b.frequency_rad_s).all(|f| f.is_finite()));
            prop_assert!(chart.crossings.iter().all(|c| c.speed_rad_s.is_finite() && c.frequency_rad_s.is_finite()));
        }
    }

    /// Every command, on every blade: an answer, and only numbers in it.
    #[test]
    fn every_command_answers_with_numbers(blade in blade(), harmonics in 1..20_u32) {
        let checked = blade.blade();
        let settings = Settings {
            speeds: Some(SpeedRange { from: 0.0, to: 2.0 * blade.nominal_speed, count: 11 }),
            harmonics,
            up_to: 10,
            points: 33,
            ..Settings::of(ModelKind::Uncoupled)
        };
        let chart = fan(&checked, &settings).unwrap();
        prop_assert_eq!(chart.branches.len(), 15);
        for branch in &chart.branches {
            prop_assert!(branch.frequency_rad_s.iter().all(|f| f.is_finite() && *f >= 0.0), "{:?}", branch);
            prop_assert!(branch.southwell.k0.is_finite() && branch.southwell.k1.is_finite());
        }
        prop_assert!(chart.nominal.margins.iter().all(|m| m.per_rev.is_finite() && m.margin_per_rev.abs() <= 0.5 || m.per_rev < 1.0));
        for shape in shapes(&checked, &settings).unwrap().shapes {
            let numbers = shape.displacement.iter().chain(&shape.slope).chain(&shape.moment);
            prop_assert!(numbers.clone().all(|v| v.is_finite()), "{:?}", shape.label);
            let largest = shape.displacement.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
            prop_assert!((largest - 1.0).abs() < 1e-12);
        }
        for series in converge(&checked, &settings).unwrap().series {
            for (i, value) in series.classical_rad_s.iter().enumerate() {
                prop_assert_eq!(value.is_some(), i + 1 >= series.number);
                prop_assert!(value.is_none_or(|v| v.is_finite() && v >= 0.0));
            }
        }
    }
}

/// ‖Gq − ω²Mq‖/‖ω²Mq‖: the first modes of a blade with steps of 1000 : 1 are differences of
/// entries up to 1e8 times larger.
const RESIDUAL: f64 = 1e-6;
/// Simpson's rule on a grid of [`FINE`] parts per cell, and the orthogonality of the eigenvectors.
const ORTHOGONAL: f64 = 1e-6;
/// Crossings are solved for, not read off: the tolerance of the root and of one frequency.
const CROSSING: f64 = 1e-8;
/// Moment at the hinge against the largest one along the blade.
const MOMENT: f64 = 1e-6;
/// The same against the largest moment of any mode.
const STRAIGHT: f64 = 1e-12;
/// Samples per grid cell.
const FINE: usize = 20;

/// The property at sample `k` of a grid cell, inside the cell's limits.
fn within(table: &Table, radius: f64, cell: usize, k: usize) -> f64 {
    let at = |i: usize| step_at(table.r[i], radius);
    let piece = (0..table.r.len() - 1).find(|&i| at(i) <= cell && cell < at(i + 1)).unwrap();
    let x = (cell as f64 + k as f64 / FINE as f64 - at(piece) as f64) / (at(piece + 1) - at(piece)) as f64;
    table.y[piece] + (table.y[piece + 1] - table.y[piece]) * x
}

fn simpson(values: impl Iterator<Item = f64>, step: f64) -> f64 {
    let weight = |i: usize| {
        if i == 0 || i == FINE {
            1.0
        } else if i % 2 == 1 {
            4.0
        } else {
            2.0
        }
    };
    values.enumerate().map(|(i, v)| weight(i) * v).sum::<f64>() * step / 3.0
}

/// The same blade written in inches, pounds, pounds-force, degrees and revolutions per minute.
fn in_inches(blade: &TestBlade) -> BladeDefinition {
    let units = Units {
        length: LengthUnit::Inch,
        mass: MassUnit::Pound,
        force: ForceUnit::PoundForce,
        angle: AngleUnit::Degree,
        speed: SpeedUnit::Rpm,
    };
    // NIST SP 811: inch, pound, standard gravity; written out here so that the product's factors are tested too.
    let (inch, pound, gravity) = (0.0254, 0.453_592_37, 9.806_65);
    let length = |value: f64| value / inch;
    let property = |property: &mut Option<PropertyDefinition>, unit: f64| match property {
        Some(PropertyDefinition::Uniform(value)) => *value /= unit,
        Some(PropertyDefinition::OwnRadii { r, values }) => {
            *r = r.iter().map(|r| r / inch).collect();
            *values = values.iter().map(|value| value / unit).collect();
        }
        Some(PropertyDefinition::OnStations(_)) => unreachable!("test blades have radii of their own"),
        None => {}
    };
    let mut definition = blade.definition();
    definition.units = units;
    let rotor = definition.rotor.as_mut().unwrap();
    rotor.radius = rotor.radius.map(length);
    rotor.nominal_speed = rotor.nominal_speed.map(|speed| speed * 30.0 / core::f64::consts::PI);
    for root in [&mut definition.flap, &mut definition.lag, &mut definition.torsion] {
        let root = root.as_mut().unwrap();
        root.offset = root.offset.map(length);
        root.spring = root.spring.map(|spring| spring / (pound * gravity * inch));
    }
    let distribution = definition.distribution.as_mut().unwrap();
    property(&mut distribution[Property::Mass], pound / inch);
    let stiffness = pound * gravity * inch * inch;
    property(&mut distribution[Property::FlapStiffness], stiffness);
    property(&mut distribution[Property::LagStiffness], stiffness);
    property(&mut distribution[Property::TorsionStiffness], stiffness);
    property(&mut distribution[Property::PolarInertia], pound * inch);
    property(&mut distribution[Property::MassOffset], inch);
    definition
}

/// A spring root has no function φ = x, so its balance of moments holds in the limit only: on a
/// smooth blade the difference between moment and spring falls with the number of functions.
#[test]
fn moment_at_a_spring_is_spring_times_slope_in_the_limit() {
    let spring = 3.0;
    for (dof, speed) in [(Dof::Flap, 0.0), (Dof::Flap, 8.0), (Dof::Lag, 8.0), (Dof::Torsion, 8.0)] {
        let blade = TestBlade::uniform(1.0).with_root(dof, End { offset: 0.0, hold: Hold::Spring(spring) });
        let miss = |functions: usize| {
            let report = shapes(&blade.blade(), &settings(dof, speed, functions, 3)).unwrap();
            report.shapes.iter().fold(0.0_f64, |worst, shape| {
                let turn = if dof == Dof::Torsion { shape.displacement[0] } else { shape.slope[0] };
                let largest = shape.moment.iter().fold(0.0_f64, |most, m| most.max(m.abs()));
                worst.max((shape.moment[0] - spring * turn).abs() / largest)
            })
        };
        let (few, many) = (miss(8), miss(60));
        assert!(many < LIMIT && (many < 0.1 * few || few < ROUNDING), "{dof} at {speed}: {few:e}, then {many:e}");
    }
}

/// Difference between moment and spring on a uniform turning blade: 1.4e-3 of the largest moment with
/// 8 functions, 3e-6 with 60.
const LIMIT: f64 = 1e-5;
