//! A property of a blade is one row of a table in core. For every row: it is read and written, its
//! unit is converted, it can be changed, each rule of it is a fault, and the documents name it.

#![allow(clippy::unwrap_used, clippy::float_cmp, reason = "a test may stop; exact conversions are meant")]

use bladefan_core::FaultCode;
use bladefan_core::formats::{Format, read, to_json, to_toml};
use bladefan_core::units::{AngleUnit, ForceUnit, LengthUnit, MassUnit, Units};
use bladefan_core::{Amount, BladeDefinition, Change, Property, PropertyDefinition, What, change, check, convert};
use bladefan_tests::faults::{BASE_TOML, cases};
use std::fs;
use std::path::Path;

const ODD: Units = Units {
    length: LengthUnit::Inch,
    mass: MassUnit::Pound,
    force: ForceUnit::PoundForce,
    angle: AngleUnit::Degree,
    speed: bladefan_core::units::SpeedUnit::Rpm,
};

fn base() -> BladeDefinition {
    read(BASE_TOML, Format::Toml).unwrap().definition
}

/// The same with what must be given beside this property.
fn base_of(property: Property) -> BladeDefinition {
    let other = match property {
        Property::FlapInertia => Property::LagInertia,
        Property::LagInertia => Property::FlapInertia,
        _ => return base(),
    };
    base().with(other, 0.125)
}

fn of(blade: &BladeDefinition, property: Property) -> Option<PropertyDefinition> {
    blade.distribution.as_ref().unwrap()[property].clone()
}

/// The only fault of a blade with this value of a property: its code and path.
fn fault(property: Property, value: impl Into<PropertyDefinition>) -> (FaultCode, String) {
    let faults = check(&base_of(property).with(property, value)).unwrap_err();
    assert_eq!(faults.len(), 1, "{property}: {faults}");
    (faults[0].code, faults[0].path.clone())
}

#[test]
fn every_property_is_read_and_written() {
    for property in Property::ALL {
        for value in [PropertyDefinition::from(0.375), [(0.0, 0.25), (2.0, 0.5)].into()] {
            let blade = base_of(property).with(property, value);
            for (text, format) in [(to_toml(&blade), Format::Toml), (to_json(&blade), Format::Json)] {
                assert!(text.contains(property.key()), "{property}");
                assert_eq!(read(&text, format).unwrap().definition, blade, "{property}");
            }
        }
    }
}

#[test]
fn every_property_is_converted_by_its_unit() {
    for property in Property::ALL {
        let given = BladeDefinition { units: Units::default(), ..base_of(property) }.with(property, 0.375);
        let Some(PropertyDefinition::Uniform(found)) = of(&convert(&given, ODD), property) else { unreachable!() };
        // Numbers are written with 15 digits.
        assert!((found * property.unit(&ODD) - 0.375).abs() < 1e-14 * 0.375, "{property}: {found}");
        assert_ne!(found, 0.375, "{property} has no unit");
        let blade = check(&BladeDefinition { units: ODD, ..convert(&given, ODD) }).unwrap();
        assert!((blade.property(property).at(1.0) - 0.375).abs() < 1e-14 * 0.375, "{property}");
    }
}

#[test]
fn every_property_can_be_changed() {
    for property in Property::ALL {
        let given = base_of(property).with(property, 0.5);
        let changed = change(&given, &[Change::new(What::Property(property), Amount::Add(0.25)).on(1.0, 1.5)]);
        let expected = [(0.0, 0.5), (1.0, 0.5), (1.0, 0.75), (1.5, 0.75), (1.5, 0.5), (2.0, 0.5)];
        assert_eq!(of(&changed.unwrap().blade, property), Some(expected.into()), "{property}");
    }
}

#[test]
fn every_rule_of_every_property_is_a_fault() {
    for property in Property::ALL {
        let path = format!("distribution.{}", property.key());
        assert_eq!(fault(property, f64::NAN), (FaultCode::NotFinite, path.clone()), "{property}");
        assert_eq!(fault(property, 1e200), (FaultCode::OutOfRange, path.clone()), "{property}");
        let long = PropertyDefinition::OwnRadii { r: vec![0.0, 2.0], values: vec![1.0; 3] };
        assert_eq!(fault(property, long), (FaultCode::Length, format!("{path}.values")), "{property}");
        let mut without = base();
        without.distribution.as_mut().unwrap()[property] = None;
        match check(&without) {
            Ok(_) => assert!(!property.is_required(), "{property} is missing"),
            Err(faults) => {
                assert!(property.is_required(), "{property}: {faults}");
                assert_eq!((faults[0].code, &faults[0].path), (FaultCode::Missing, &path), "{property}");
            }
        }
        // Twist is not used by any solver, so it may be known anywhere.
        let short = check(&base_of(property).with(property, [(0.0, 1.0), (1.0, 1.0)]));
        let uncovered = short.err().map(|faults| (faults[0].code, faults[0].path.clone()));
        let expected = (property != Property::Twist).then(|| (FaultCode::Uncovered, path.clone()));
        assert_eq!(uncovered, expected, "{property}");
    }
}

/// The cases that every reader runs through speak of each property.
#[test]
fn every_property_has_a_bad_file() {
    let faults: Vec<String> = cases().into_iter().flat_map(|case| case.faults).map(|fault| fault.path).collect();
    for property in Property::ALL {
        let path = format!("distribution.{}", property.key());
        assert!(faults.iter().any(|fault| fault.starts_with(&path)), "{property} is in no case of faults/cases.json");
    }
}

#[test]
fn documents_and_types_name_every_property() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let format = fs::read_to_string(root.join("docs/BLADE_FORMAT.md")).unwrap();
    let types = fs::read_to_string(root.join("crates/wasm/src/types.ts")).unwrap();
    for property in Property::ALL {
        assert!(format.contains(&format!("| `distribution.{}` |", property.key())), "{property} in BLADE_FORMAT.md");
        let required = property.is_required() && !Property::OF_TORSION.contains(&property);
        let optional = if required { "" } else { "?" };
        assert!(types.contains(&format!("    {}{optional}: Property;", property.key())), "{property} in types.ts");
    }
}
