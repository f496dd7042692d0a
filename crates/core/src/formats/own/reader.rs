//! A tree to a definition: keys, types, words and units.

use super::SCHEMA;
use super::tree::{Entry, Node, Tree};
use crate::blade::{
    BladeDefinition, DistributionDefinition, PointMassDefinition, Property, PropertyDefinition, RootDefinition,
    RootKind, RotorDefinition, Source, SpringAngle, choice_fault,
};
use crate::dof::Dof;
use crate::fault::{Fault, FaultCode};
use crate::figures::Shortest;
use crate::formats::place::Placed;
use crate::units::{AngleUnit, ForceUnit, LengthUnit, MassUnit, SpeedUnit, Units};
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// Longest piece of a file that is repeated in a message, in characters.
const LONGEST: usize = 40;
/// Keys of the whole file.
const FILE: [&str; 11] =
    ["schema", "name", "notes", "source", "units", "rotor", "flap", "lag", "torsion", "distribution", "point_mass"];
/// Keys of the rotor.
const ROTOR: [&str; 7] = ["radius", "nominal_speed", "blades", "pitch", "precone", "torque_offset", "spring_angle"];
/// Keys of a point mass.
const POINT_MASS: [&str; 5] = ["r", "mass", "offset", "flap_inertia", "lag_inertia"];
/// Keys of the table of units.
const UNITS: [&str; 5] = ["length", "mass", "force", "angle", "speed"];

/// Reads trees and keeps every fault.
///
/// A value that was refused is read as not a number, never as absent, so that the check does not
/// take a default for it.
#[derive(Default)]
pub(super) struct Reader {
    pub(super) faults: Vec<Placed>,
}

/// A table of the file and its path, with a dot at its end; empty for the whole file.
pub(super) struct Table<'t> {
    prefix: String,
    pub(super) at: Option<usize>,
    entries: &'t [Entry],
}

impl<'t> Table<'t> {
    /// The value of a key; `null` counts as absent.
    pub(super) fn get(&self, key: &str) -> Option<&'t Tree> {
        let entry = self.entries.iter().find(|entry| entry.key == key)?;
        Some(&entry.value).filter(|value| !matches!(value.node, Node::Null))
    }

    pub(super) fn path(&self, key: &str) -> String {
        format!("{}{key}", self.prefix)
    }
}

impl Reader {
    /// Reads a whole blade file.
    pub(super) fn definition(&mut self, tree: &Tree) -> BladeDefinition {
        let Some(file) = self.table("", tree, &FILE) else { return BladeDefinition::default() };
        self.schema(&file);
        BladeDefinition {
            name: self.text(&file, "name"),
            notes: self.text(&file, "notes"),
            source: self
                .sub_table(&file, "source", &["citation", "quality"])
                .map(|table| Source { citation: self.text(&table, "citation"), quality: self.text(&table, "quality") }),
            units: self
                .sub_table(&file, "units", &UNITS)
                .map_or_else(Units::default, |table| self.units(&table, Units::default())),
            rotor: self.sub_table(&file, "rotor", &ROTOR).map(|table| RotorDefinition {
                radius: self.number(&table, "radius"),
                nominal_speed: self.number(&table, "nominal_speed"),
                blades: self.number(&table, "blades"),
                pitch: self.number(&table, "pitch"),
                precone: self.number(&table, "precone"),
                torque_offset: self.number(&table, "torque_offset"),
                spring_angle: self.spring_angle(&table),
            }),
            flap: self.root(&file, Dof::Flap),
            lag: self.root(&file, Dof::Lag),
            torsion: self.root(&file, Dof::Torsion),
            distribution: self.distribution(&file),
            point_masses: self.point_masses(&file),
        }
    }

    pub(super) fn push(&mut self, at: Option<usize>, fault: Fault) {
        self.faults.push(Placed { at, fault });
    }

    pub(super) fn wrong_type(&mut self, path: &str, tree: &Tree, rule: &str) {
        let value = shown(tree);
        let subject = if path.is_empty() { "the file".into() } else { words(path) };
        let message = format!("{subject} {rule} (is {value})");
        self.push(tree.at(), Fault::new(FaultCode::WrongType, path, Some(value), rule, message));
    }

    /// The entries of a table; a fault for every key that is not known.
    pub(super) fn table<'t>(&mut self, path: &str, tree: &'t Tree, known: &[&str]) -> Option<Table<'t>> {
        let Node::Table(entries) = &tree.node else {
            self.wrong_type(path, tree, "must be a table");
            return None;
        };
        let prefix = if path.is_empty() { String::new() } else { format!("{path}.") };
        for entry in entries.iter().filter(|entry| !known.contains(&entry.key.as_str())) {
            let key = shown_key(&entry.key);
            let rule = match nearest(&entry.key, known) {
                Some(near) => format!("is not known here; the nearest known key is {near}"),
                None => format!("is not known here; known keys are {}", known.join(", ")),
            };
            let message = format!("key {key} {rule}");
            let at = entry.key_span.as_ref().map(|span| span.start);
            self.push(at, Fault::new(FaultCode::UnknownKey, format!("{prefix}{key}"), None, rule, message));
        }
        Some(Table { prefix, at: tree.at(), entries })
    }

    fn sub_table<'t>(&mut self, parent: &Table<'t>, key: &str, known: &[&str]) -> Option<Table<'t>> {
        self.table(&parent.path(key), parent.get(key)?, known)
    }

    fn schema(&mut self, file: &Table) {
        let rule = format!("must be \"{SCHEMA}\"");
        match file.get("schema") {
            Some(Tree { node: Node::Text(text), .. }) if text == SCHEMA => {}
            Some(tree) => {
                let value = shown(tree);
                let message = format!("schema {rule} (is {value})");
                self.push(tree.at(), Fault::new(FaultCode::Schema, "schema", Some(value), rule, message));
            }
            None => {
                let message = format!("schema must be given: {SCHEMA}");
                // A file without a place has no beginning either.
                self.push(file.at.map(|_| 0), Fault::new(FaultCode::Schema, "schema", None, rule, message));
            }
        }
    }

    pub(super) fn text(&mut self, table: &Table, key: &str) -> Option<String> {
        let tree = table.get(key)?;
        if let Node::Text(text) = &tree.node {
            return Some(text.clone());
        }
        self.wrong_type(&table.path(key), tree, "must be text");
        None
    }

    pub(super) fn number(&mut self, table: &Table, key: &str) -> Option<f64> {
        let tree = table.get(key)?;
        if let Node::Number(value) = tree.node {
            return Some(value);
        }
        self.wrong_type(&table.path(key), tree, "must be a number");
        Some(f64::NAN)
    }

    /// A truth value.
    pub(super) fn truth(&mut self, table: &Table, key: &str) -> Option<bool> {
        let tree = table.get(key)?;
        if let Node::Bool(value) = tree.node {
            return Some(value);
        }
        self.wrong_type(&table.path(key), tree, "must be true or false");
        None
    }

    fn numbers(&mut self, path: &str, values: &[Tree]) -> Vec<f64> {
        let number = |(i, tree): (usize, &Tree)| {
            if let Node::Number(value) = tree.node {
                return value;
            }
            self.wrong_type(&format!("{path}[{i}]"), tree, "must be a number");
            f64::NAN
        };
        values.iter().enumerate().map(number).collect()
    }

    fn list(&mut self, table: &Table, key: &str) -> Option<Vec<f64>> {
        let (path, tree) = (table.path(key), table.get(key)?);
        if let Node::List(values) = &tree.node {
            return Some(self.numbers(&path, values));
        }
        self.wrong_type(&path, tree, "must be a list of numbers");
        None
    }

    /// Units on their own; those that are absent are those of `absent`.
    pub(super) fn units_at(&mut self, path: &str, tree: &Tree, absent: Units) -> Units {
        self.table(path, tree, &UNITS).map_or(absent, |table| self.units(&table, absent))
    }

    fn units(&mut self, table: &Table, absent: Units) -> Units {
        Units {
            length: self.unit(table, "length", LengthUnit::ALL, LengthUnit::name).unwrap_or(absent.length),
            mass: self.unit(table, "mass", MassUnit::ALL, MassUnit::name).unwrap_or(absent.mass),
            force: self.unit(table, "force", ForceUnit::ALL, ForceUnit::name).unwrap_or(absent.force),
            angle: self.unit(table, "angle", AngleUnit::ALL, AngleUnit::name).unwrap_or(absent.angle),
            speed: self.unit(table, "speed", SpeedUnit::ALL, SpeedUnit::name).unwrap_or(absent.speed),
        }
    }

    fn unit<U: Copy>(&mut self, table: &Table, key: &str, all: &[U], name: fn(U) -> &'static str) -> Option<U> {
        self.choice(table, key, &format!("unit of {key}"), FaultCode::UnknownUnit, all, name)
    }

    /// One of some words.
    fn choice<C: Copy>(
        &mut self,
        table: &Table,
        key: &str,
        subject: &str,
        code: FaultCode,
        all: &[C],
        name: fn(C) -> &'static str,
    ) -> Option<C> {
        let names: Vec<&str> = all.iter().map(|&choice| name(choice)).collect();
        self.word(table, key, subject, code, &names).map(|index| all[index])
    }

    /// Which one of some words.
    fn word(&mut self, table: &Table, key: &str, subject: &str, code: FaultCode, names: &[&str]) -> Option<usize> {
        let tree = table.get(key)?;
        let Node::Text(given) = &tree.node else {
            self.wrong_type(&table.path(key), tree, "must be text");
            return None;
        };
        let found = names.iter().position(|name| name == given);
        if found.is_none() {
            let given = clipped(given);
            self.push(tree.at(), choice_fault(code, &table.path(key), subject, &given, names));
        }
        found
    }

    fn root(&mut self, file: &Table, dof: Dof) -> Option<RootDefinition> {
        let table = self.sub_table(file, dof.name(), &["root", "offset", "offset_ratio", "spring"])?;
        let (code, choices) = (FaultCode::UnknownChoice, RootKind::choices(dof));
        Some(RootDefinition {
            root: self.choice(&table, "root", &format!("{dof} root"), code, choices, RootKind::name),
            offset: self.number(&table, "offset"),
            offset_ratio: self.number(&table, "offset_ratio"),
            spring: self.number(&table, "spring"),
        })
    }

    fn spring_angle(&mut self, table: &Table) -> Option<SpringAngle> {
        let tree = table.get("spring_angle")?;
        match &tree.node {
            Node::Number(angle) => return Some(SpringAngle::Angle(*angle)),
            Node::Text(text) if text == SpringAngle::PITCH => return Some(SpringAngle::Pitch),
            _ => self.wrong_type(&table.path("spring_angle"), tree, "must be a number or \"pitch\""),
        }
        Some(SpringAngle::Angle(f64::NAN))
    }

    fn point_masses(&mut self, file: &Table) -> Vec<PointMassDefinition> {
        let Some(tree) = file.get("point_mass") else { return Vec::new() };
        let Node::List(list) = &tree.node else {
            self.wrong_type("point_mass", tree, "must be a list of tables");
            return Vec::new();
        };
        let mass = |(i, tree)| {
            let Some(table) = self.table(&format!("point_mass[{i}]"), tree, &POINT_MASS) else {
                return PointMassDefinition::default();
            };
            PointMassDefinition {
                r: self.number(&table, "r"),
                mass: self.number(&table, "mass"),
                offset: self.number(&table, "offset"),
                flap_inertia: self.number(&table, "flap_inertia"),
                lag_inertia: self.number(&table, "lag_inertia"),
            }
        };
        list.iter().enumerate().map(mass).collect()
    }

    fn distribution(&mut self, file: &Table) -> Option<DistributionDefinition> {
        let known: Vec<&str> = core::iter::once("r").chain(Property::ALL.into_iter().map(Property::key)).collect();
        let table = self.sub_table(file, "distribution", &known)?;
        Some(DistributionDefinition {
            r: self.list(&table, "r"),
            properties: Property::ALL.map(|property| self.property(&table, property.key())),
        })
    }

    fn property(&mut self, parent: &Table, key: &str) -> Option<PropertyDefinition> {
        let (path, tree) = (parent.path(key), parent.get(key)?);
        let refused = PropertyDefinition::Uniform(f64::NAN);
        Some(match &tree.node {
            Node::Number(value) => PropertyDefinition::Uniform(*value),
            Node::List(values) => PropertyDefinition::OnStations(self.numbers(&path, values)),
            Node::Table(_) => {
                let Some(table) = self.table(&path, tree, &["r", "values"]) else { return Some(refused) };
                for key in ["r", "values"] {
                    if table.get(key).is_none() {
                        let message = format!("{} of {} must be given", key, words(&path));
                        let fault = Fault::new(FaultCode::Missing, table.path(key), None, "must be given", message);
                        self.push(table.at, fault);
                    }
                }
                match (self.list(&table, "r"), self.list(&table, "values")) {
                    (Some(r), Some(values)) => PropertyDefinition::OwnRadii { r, values },
                    _ => refused,
                }
            }
            _ => {
                self.wrong_type(&path, tree, "must be a number, a list of numbers, or a table of r and values");
                refused
            }
        })
    }
}

/// The known key that an unknown one was most likely meant to be.
fn nearest<'k>(key: &str, known: &[&'k str]) -> Option<&'k str> {
    if key.chars().count() > LONGEST {
        return None;
    }
    let key = key.to_ascii_lowercase(); // as all known keys are in ASCII
    let likeness = |known: &&&str| strsim::jaro_winkler(&key, known);
    let best = known.iter().max_by(|a, b| likeness(a).total_cmp(&likeness(b)))?;
    // Below this, likeness is chance.
    (likeness(&best) > 0.75).then_some(*best)
}

/// The last key of a path in words: `distribution.flap_stiffness[3]` is flap stiffness [3].
fn words(path: &str) -> String {
    path.rsplit('.').next().unwrap_or(path).replace('_', " ").replace('[', " [")
}

/// A key as it stands in paths and messages: quoted where TOML would quote it.
fn shown_key(key: &str) -> String {
    let bare = !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
    if bare { clipped(key) } else { format!("\"{}\"", clipped(key)) }
}

/// A value as it stands in messages.
fn shown(tree: &Tree) -> String {
    match &tree.node {
        Node::Null => "null".into(),
        Node::Bool(value) => value.to_string(),
        Node::Number(value) => Shortest(*value).to_string(),
        Node::Text(text) => format!("\"{}\"", clipped(text)),
        Node::Date => "a date".into(),
        Node::List(_) => "a list".into(),
        Node::Table(_) => "a table".into(),
    }
}

/// Text of a file in a message: one line, not too long.
pub(super) fn clipped(text: &str) -> String {
    let mut short: String = text.chars().take(LONGEST).flat_map(char::escape_debug).collect();
    if text.chars().nth(LONGEST).is_some() {
        short.push('…');
    }
    short
}
