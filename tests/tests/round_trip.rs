//! What is written reads back the same; no text makes the readers panic.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop")]

use bladefan_core::Dof;
use bladefan_core::Settings;
use bladefan_core::formats::{Format, measured, read, to_json, to_toml};
use bladefan_core::units::{AngleUnit, ForceUnit, LengthUnit, MassUnit, SpeedUnit, Units};
use bladefan_core::{
    Blade, BladeDefinition, DistributionDefinition, PointMassDefinition, Property, PropertyDefinition, RootDefinition,
    RootKind, RotorDefinition, Source, SpringAngle, check, convert,
};
use bladefan_tests::blades::without_torsion;
use bladefan_tests::faults::{BASE_JSON, BASE_TOML};
use core::ops::Range;
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use proptest::sample::select;

/// Positive numbers of 10 to a power within these.
fn powers(exponents: Range<i32>) -> impl Strategy<Value = f64> {
    (exponents, 1.0..10.0_f64).prop_map(|(exponent, m)| m * 10_f64.powi(exponent))
}

/// Numbers of any size that is legal in every unit.
fn value(property: Property) -> impl Strategy<Value = f64> {
    powers(match property {
        Property::MassOffset | Property::Twist | Property::TensionOffset => -40..5,
        Property::TrapezeRadius => -20..5,
        _ => -20..20,
    })
}

fn units() -> impl Strategy<Value = Units> {
    (
        select(LengthUnit::ALL),
        select(MassUnit::ALL),
        select(ForceUnit::ALL),
        select(AngleUnit::ALL),
        select(SpeedUnit::ALL),
    )
        .prop_map(|(length, mass, force, angle, speed)| Units { length, mass, force, angle, speed })
}

fn root(dof: Dof, radius: f64) -> impl Strategy<Value = RootDefinition> {
    (select(RootKind::choices(dof)), 0.0..0.5_f64, 0..3_u8, 0.0..1e4_f64).prop_map(move |(kind, ratio, how, spring)| {
        RootDefinition {
            root: Some(kind),
            offset: (how == 1).then_some(ratio * radius),
            offset_ratio: (how == 2).then_some(ratio),
            spring: kind.takes_spring().then_some(spring),
        }
    })
}

/// Radii from the centre to the tip as fractions that make steps now and then, and values.
fn table(radius: f64, value: impl Strategy<Value = f64>) -> impl Strategy<Value = (Vec<f64>, Vec<f64>)> {
    vec((0.001..1.0_f64, any::<bool>(), value), 2..12).prop_map(move |steps| {
        let total: f64 = steps.iter().map(|step| step.0).sum();
        let (mut r, mut values, mut at) = (Vec::new(), Vec::new(), 0.0);
        for (i, (length, twice, value)) in steps.iter().enumerate() {
            let here = if i == 0 { 0.0 } else { at };
            r.push(here * radius);
            values.push(*value);
            if *twice {
                r.push(here * radius);
                values.push(value * 0.5);
            }
            at = here + length / total;
        }
        r.push(radius);
        values.push(*values.last().unwrap());
        (r, values)
    })
}

fn property(property: Property, radius: f64, stations: usize) -> BoxedStrategy<Option<PropertyDefinition>> {
    let given = prop_oneof![
        value(property).prop_map(PropertyDefinition::Uniform),
        vec(value(property), stations).prop_map(PropertyDefinition::OnStations),
        table(radius, value(property)).prop_map(|(r, values)| PropertyDefinition::OwnRadii { r, values }),
    ];
    if property.is_required() { given.prop_map(Some).boxed() } else { option::of(given).boxed() }
}

fn distribution(radius: f64) -> impl Strategy<Value = DistributionDefinition> {
    table(radius, Just(1.0)).prop_flat_map(move |(r, _)| {
        let properties = Property::ALL.map(|each| property(each, radius, r.len()));
        (properties, Just(r), any::<bool>()).prop_map(|(properties, r, sum)| {
            let mut given = DistributionDefinition { r: Some(r), properties };
            // What goes together, and what does not.
            if given[Property::FlapInertia].is_none() || given[Property::LagInertia].is_none() {
                given[Property::FlapInertia] = None;
                given[Property::LagInertia] = None;
            } else if sum {
                given[Property::PolarInertia] = None;
            }
            if given[Property::AxialStiffness].is_some() {
                given[Property::TrapezeRadius] = None;
            }
            given
        })
    })
}

/// A rotor but for its radius. The springs are turned where the roots of flap and lag allow it.
fn rotor() -> impl Strategy<Value = RotorDefinition> {
    let angle = prop_oneof![Just(SpringAngle::Pitch), (-400.0..400.0_f64).prop_map(SpringAngle::Angle)];
    let pose =
        (option::of(-400.0..400.0_f64), option::of(-1.4..1.4_f64), option::of(powers(-40..5)), option::of(angle));
    (powers(-8..8), option::of(1..9_u8), pose).prop_map(|(speed, blades, (pitch, precone, torque_offset, angle))| {
        RotorDefinition {
            radius: None,
            nominal_speed: Some(speed),
            blades: blades.map(f64::from),
            pitch,
            precone,
            torque_offset,
            spring_angle: angle,
        }
    })
}

/// Masses outboard of every root.
fn point_masses(radius: f64) -> impl Strategy<Value = Vec<PointMassDefinition>> {
    let mass =
        (0.5..1.0_f64, powers(-5..5), option::of(powers(-3..3)), option::of(powers(-3..3)), option::of(1.0..9.0));
    vec(mass, 0..4).prop_map(move |masses| {
        let mass = |(at, mass, offset, flap_inertia, lag): (f64, f64, Option<f64>, Option<f64>, Option<f64>)| {
            let lag_inertia = lag.map(|lag| lag * mass * offset.unwrap_or(1.0) * offset.unwrap_or(1.0));
            PointMassDefinition { r: Some(at * radius), mass: Some(mass), offset, flap_inertia, lag_inertia }
        };
        masses.into_iter().map(mass).collect()
    })
}

/// One in four without torsion.
fn definition() -> impl Strategy<Value = BladeDefinition> {
    (whole(), 0..4_u8).prop_map(|(blade, which)| if which == 0 { without_torsion(blade) } else { blade })
}

fn whole() -> impl Strategy<Value = BladeDefinition> {
    powers(-3..5).prop_flat_map(|radius| {
        (
            (any::<String>(), option::of(any::<String>()), option::of(any::<String>()), any::<bool>()),
            units(),
            rotor(),
            (root(Dof::Flap, radius), root(Dof::Lag, radius), root(Dof::Torsion, radius)),
            (distribution(radius), point_masses(radius)),
        )
            .prop_map(
                move |((name, notes, citation, source), units, rotor, (flap, lag, torsion), (distribution, masses))| {
                    let place = |root: &RootDefinition| (root.offset, root.offset_ratio);
                    let one_radius = place(&flap) == place(&lag);
                    BladeDefinition {
                        name: Some(name),
                        notes,
                        source: source.then_some(Source { citation, quality: Some("example".into()) }),
                        units,
                        rotor: Some(RotorDefinition {
                            radius: Some(radius),
                            spring_angle: rotor.spring_angle.filter(|_| one_radius),
                            ..rotor
                        }),
                        flap: Some(flap),
                        lag: Some(lag),
                        torsion: Some(torsion),
                        distribution: Some(distribution),
                        point_masses: masses,
                    }
                },
            )
    })
}

/// Every number of a definition, in the order of the file.
fn numbers(definition: &BladeDefinition) -> Vec<f64> {
    fn collect(value: &serde_json::Value, into: &mut Vec<f64>) {
        match value {
            serde_json::Value::Number(number) => into.extend(number.as_f64()),
            serde_json::Value::Array(list) => list.iter().for_each(|value| collect(value, into)),
            serde_json::Value::Object(table) => table.values().for_each(|value| collect(value, into)),
            _ => {}
        }
    }
    let mut found = Vec::new();
    collect(&serde_json::from_str(&to_json(definition)).unwrap(), &mut found);
    found
}

/// A sound file with some of its characters replaced, so that the reader gets past the first line.
fn spoilt(base: &'static str) -> impl Strategy<Value = String> {
    let characters = select("[]{}=,.\"'#\\\n\t -+eE0159ainfx:_\0é".chars().collect::<Vec<_>>());
    vec((0..base.len(), characters, any::<bool>()), 1..12).prop_map(|changes| {
        let mut text: Vec<char> = base.chars().collect();
        for (at, c, insert) in changes {
            let at = at % text.len();
            if insert {
                text.insert(at, c);
            } else {
                text[at] = c;
            }
        }
        text.into_iter().collect()
    })
}

fn reads_or_has_faults(text: &str) {
    for format in [Format::Toml, Format::Json] {
        if let Err(faults) = read(text, format) {
            assert!(!faults.is_empty());
            let places: Vec<_> = faults.iter().map(|fault| (fault.line.unwrap(), fault.column.unwrap())).collect();
            assert!(places.is_sorted(), "{places:?}");
            let lines = text.split('\n').count();
            assert!(places.iter().all(|&(line, _)| line as usize <= lines), "{places:?} in {lines} lines");
        }
    }
    if let Err(faults) = measured::read(text) {
        assert!(!faults.is_empty() && faults.iter().all(|fault| fault.line.is_some()));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn definitions_read_back_the_same(definition in definition()) {
        for (text, format) in [(to_toml(&definition), Format::Toml), (to_json(&definition), Format::Json)] {
            match read(&text, format) {
                Ok(file) => prop_assert_eq!(&file.definition, &definition),
                Err(faults) => prop_assert!(false, "{faults:#?}\n{text}"),
            }
        }
    }

    /// Two roundings to 15 digits are at most 1e-14 apart, and a few of the last bits besides.
    #[test]
    fn units_convert_there_and_back(definition in definition(), other in units()) {
        let there = convert(&definition, other);
        prop_assert_eq!(there.units, other);
        let back = convert(&there, definition.units);
        let (given, found) = (numbers(&definition), numbers(&back));
        prop_assert_eq!(given.len(), found.len());
        for (a, b) in given.iter().zip(&found) {
            prop_assert!((a - b).abs() <= 1.1e-14 * a.abs(), "{a} {b}");
        }
        let equal = |definition: &BladeDefinition| {
            let r = definition.distribution.as_ref().unwrap().r.as_ref().unwrap().clone();
            r.windows(2).map(|pair| pair[0].total_cmp(&pair[1])).collect::<Vec<_>>()
        };
        prop_assert_eq!(equal(&there), equal(&definition), "steps and the order of radii");
        prop_assert_eq!(convert(&definition, definition.units), definition);
    }

    #[test]
    fn random_text_never_panics(bytes in vec(any::<u8>(), 0..300)) {
        reads_or_has_faults(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn spoilt_toml_never_panics(text in spoilt(BASE_TOML)) {
        reads_or_has_faults(&text);
    }

    #[test]
    fn spoilt_json_never_panics(text in spoilt(BASE_JSON)) {
        reads_or_has_faults(&text);
    }
}

/// All built-in blades in every unit of length, mass, force and speed.
#[test]
fn converted_blades_have_the_same_frequencies() {
    for entry in bladefan_core::library::ENTRIES {
        let given = read(entry.toml, Format::Toml).unwrap();
        let frequencies = |blade: &Blade| {
            let report = bladefan_core::modes(blade, &Settings::default()).unwrap();
            report.modes.iter().map(|mode| mode.frequency_rad_s).collect::<Vec<_>>()
        };
        let own = frequencies(&given.blade);
        for at in 0..5 {
            let units = Units {
                length: LengthUnit::ALL[at % LengthUnit::ALL.len()],
                mass: MassUnit::ALL[at % MassUnit::ALL.len()],
                force: ForceUnit::ALL[at % ForceUnit::ALL.len()],
                angle: AngleUnit::ALL[at % AngleUnit::ALL.len()],
                speed: SpeedUnit::ALL[at % SpeedUnit::ALL.len()],
            };
            let blade = check(&convert(&given.definition, units)).unwrap();
            for (found, own) in frequencies(&blade).iter().zip(&own) {
                assert!((found - own).abs() <= 1e-12 * own, "{} in {units:?}: {found} {own}", entry.name);
            }
        }
    }
}
