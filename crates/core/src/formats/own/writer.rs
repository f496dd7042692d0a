//! A definition to a tree, and a tree to text: what [`read`](super::read) reads back the same.

use super::SCHEMA;
use super::tree::{Entry, Node, Tree};
use crate::blade::{
    BladeDefinition, DistributionDefinition, PointMassDefinition, Property, PropertyDefinition, RootDefinition,
    RootKind, RotorDefinition, SpringAngle,
};
use crate::figures::Shortest;
use crate::units::Units;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt::Write;
use serde::{Serialize, Serializer};
use toml_writer::TomlWrite;

/// A blade file in TOML: the schema first, absent keys and SI units left out, every number in the
/// shortest form that reads back the same.
pub fn to_toml(definition: &BladeDefinition) -> String {
    let mut text = String::new();
    if let Node::Table(entries) = &tree(definition).node {
        // Writing to a string cannot fail.
        let _ = write_file(&mut text, entries);
    }
    text
}

/// The same in JSON. Numbers that are not finite, which JSON cannot hold, become `null`.
pub fn to_json(definition: &BladeDefinition) -> String {
    // A definition's tree has text keys and no dates, so this cannot fail.
    serde_json::to_string_pretty(definition).unwrap_or_default()
}

impl Serialize for BladeDefinition {
    /// In the file's own keys.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        tree(self).serialize(serializer)
    }
}

/// A table under construction, without the keys whose values are absent.
#[derive(Default)]
struct Table(Vec<Entry>);

impl Table {
    fn with(mut self, key: &str, value: Option<impl Into<Tree>>) -> Self {
        self.0.extend(value.map(|value| Entry { key: key.into(), key_span: None, value: value.into() }));
        self
    }
}

impl From<Table> for Tree {
    fn from(table: Table) -> Self {
        Self::new(Node::Table(table.0))
    }
}

impl From<f64> for Tree {
    fn from(value: f64) -> Self {
        Self::new(Node::Number(value))
    }
}

impl From<&str> for Tree {
    fn from(text: &str) -> Self {
        Self::new(Node::Text(text.into()))
    }
}

impl From<&Vec<f64>> for Tree {
    fn from(values: &Vec<f64>) -> Self {
        Self::new(Node::List(values.iter().map(|&value| value.into()).collect()))
    }
}

impl From<&PropertyDefinition> for Tree {
    fn from(property: &PropertyDefinition) -> Self {
        match property {
            PropertyDefinition::Uniform(value) => (*value).into(),
            PropertyDefinition::OnStations(values) => values.into(),
            PropertyDefinition::OwnRadii { r, values } => {
                Table::default().with("r", Some(r)).with("values", Some(values)).into()
            }
        }
    }
}

impl From<&RotorDefinition> for Tree {
    fn from(rotor: &RotorDefinition) -> Self {
        Table::default()
            .with("radius", rotor.radius)
            .with("nominal_speed", rotor.nominal_speed)
            .with("blades", rotor.blades)
            .with("pitch", rotor.pitch)
            .with("precone", rotor.precone)
            .with("torque_offset", rotor.torque_offset)
            .with("spring_angle", rotor.spring_angle)
            .into()
    }
}

impl From<SpringAngle> for Tree {
    fn from(angle: SpringAngle) -> Self {
        match angle {
            SpringAngle::Angle(angle) => angle.into(),
            SpringAngle::Pitch => SpringAngle::PITCH.into(),
        }
    }
}

impl From<&PointMassDefinition> for Tree {
    fn from(mass: &PointMassDefinition) -> Self {
        Table::default()
            .with("r", mass.r)
            .with("mass", mass.mass)
            .with("offset", mass.offset)
            .with("flap_inertia", mass.flap_inertia)
            .with("lag_inertia", mass.lag_inertia)
            .into()
    }
}

impl From<&RootDefinition> for Tree {
    fn from(root: &RootDefinition) -> Self {
        Table::default()
            .with("root", root.root.map(RootKind::name))
            .with("offset", root.offset)
            .with("offset_ratio", root.offset_ratio)
            .with("spring", root.spring)
            .into()
    }
}

impl From<&DistributionDefinition> for Tree {
    fn from(given: &DistributionDefinition) -> Self {
        let radii = Table::default().with("r", given.r.as_ref());
        let with = |table: Table, property: Property| table.with(property.key(), given[property].as_ref());
        Property::ALL.into_iter().fold(radii, with).into()
    }
}

/// Point masses; nothing where there are none.
fn point_masses(masses: &[PointMassDefinition]) -> Option<Tree> {
    (!masses.is_empty()).then(|| Tree::new(Node::List(masses.iter().map(Tree::from).collect())))
}

/// The units that are not SI; nothing where all are.
fn units(units: Units) -> Option<Tree> {
    let si = Units::default();
    let table = Table::default()
        .with("length", (units.length != si.length).then(|| units.length.name()))
        .with("mass", (units.mass != si.mass).then(|| units.mass.name()))
        .with("force", (units.force != si.force).then(|| units.force.name()))
        .with("angle", (units.angle != si.angle).then(|| units.angle.name()))
        .with("speed", (units.speed != si.speed).then(|| units.speed.name()));
    (!table.0.is_empty()).then(|| table.into())
}

fn tree(definition: &BladeDefinition) -> Tree {
    let source = definition.source.as_ref().map(|source| {
        Table::default().with("citation", source.citation.as_deref()).with("quality", source.quality.as_deref())
    });
    Table::default()
        .with("schema", Some(SCHEMA))
        .with("name", definition.name.as_deref())
        .with("notes", definition.notes.as_deref())
        .with("source", source)
        .with("units", units(definition.units))
        .with("rotor", definition.rotor.as_ref())
        .with("flap", definition.flap.as_ref())
        .with("lag", definition.lag.as_ref())
        .with("torsion", definition.torsion.as_ref())
        .with("distribution", definition.distribution.as_ref())
        .with("point_mass", point_masses(&definition.point_masses))
        .into()
}

type Written = core::fmt::Result;

fn write_file(text: &mut String, entries: &[Entry]) -> Written {
    // Every key without a table stands before the first table.
    for entry in entries {
        match &entry.value.node {
            Node::Table(entries) => {
                text.newline()?;
                text.open_table_header()?;
                text.key(entry.key.as_str())?;
                text.close_table_header()?;
                text.newline()?;
                write_lines(text, entries)?;
            }
            // A definition's only list outside its tables is one of tables.
            Node::List(tables) => {
                for table in tables {
                    let Node::Table(entries) = &table.node else { continue };
                    text.newline()?;
                    text.open_array_of_tables_header()?;
                    text.key(entry.key.as_str())?;
                    text.close_array_of_tables_header()?;
                    text.newline()?;
                    write_lines(text, entries)?;
                }
            }
            _ => write_lines(text, core::slice::from_ref(entry))?,
        }
    }
    Ok(())
}

fn write_lines(text: &mut String, entries: &[Entry]) -> Written {
    for Entry { key, value, .. } in entries {
        text.key(key.as_str())?;
        text.write_str(" = ")?;
        write_value(text, value)?;
        text.newline()?;
    }
    Ok(())
}

fn write_value(text: &mut String, value: &Tree) -> Written {
    match &value.node {
        Node::Number(value) => write_number(text, *value),
        Node::Text(value) => text.value(value.as_str()),
        Node::Bool(value) => text.value(*value),
        Node::List(values) => {
            text.open_array()?;
            for (i, value) in values.iter().enumerate() {
                if i > 0 {
                    text.write_str(", ")?;
                }
                write_value(text, value)?;
            }
            text.close_array()
        }
        Node::Table(entries) => {
            text.write_str("{ ")?;
            for (i, Entry { key, value, .. }) in entries.iter().enumerate() {
                if i > 0 {
                    text.write_str(", ")?;
                }
                text.key(key.as_str())?;
                text.write_str(" = ")?;
                write_value(text, value)?;
            }
            text.write_str(" }")
        }
        // No definition holds these.
        Node::Null | Node::Date => Ok(()),
    }
}

/// TOML reads 5, 0.5 and 5e300 alike; what is not finite it calls nan and inf.
fn write_number(text: &mut String, value: f64) -> Written {
    if value.is_finite() { write!(text, "{}", Shortest(value)) } else { text.value(value) }
}
