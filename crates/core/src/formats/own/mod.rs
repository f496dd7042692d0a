//! bladefan's own blade files, TOML and JSON.
//!
//! ```text
//! text ─from_toml, from_json→ Tree ─reader→ BladeDefinition ─check→ Blade
//! BladeDefinition ─writer→ Tree → TOML, JSON
//! ```
//! A [`Tree`] knows where in the text each key and value stands, so every fault has a line and a
//! column, be it found by the parser, by the reader or by the check.

mod changes;
mod from_json;
mod from_toml;
mod reader;
mod tree;
mod writer;

pub use tree::{Entry, Node, Tree};
pub use writer::{to_json, to_toml};

use super::BYTE_ORDER_MARK;
use super::place::{Placed, drop_consequences, in_order};
use crate::blade::{Blade, BladeDefinition, Change, check};
use crate::fault::Faults;
use crate::units::Units;
use alloc::vec::Vec;
use reader::Reader;

/// The schema that this version reads and writes.
pub const SCHEMA: &str = "bladefan-blade/1";

/// What a text is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// TOML 1.1.
    Toml,
    /// JSON (RFC 8259): no comments, no trailing commas.
    Json,
}

impl Format {
    /// JSON where the first character that is not blank is `{`, else TOML.
    pub fn of_text(text: &str) -> Self {
        let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
        if text.trim_start().starts_with('{') { Self::Json } else { Self::Toml }
    }

    /// By the ending of a file's name, `.toml` or `.json` in any case.
    pub fn of_name(name: &str) -> Option<Self> {
        let (_, ending) = name.rsplit_once('.')?;
        if ending.eq_ignore_ascii_case("toml") {
            Some(Self::Toml)
        } else if ending.eq_ignore_ascii_case("json") {
            Some(Self::Json)
        } else {
            None
        }
    }
}

/// A blade file that was read without a fault: as given, and as checked.
#[derive(Clone, Debug, PartialEq)]
pub struct BladeFile {
    /// What the file says, in its own units.
    pub definition: BladeDefinition,
    /// The blade in SI units.
    pub blade: Blade,
}

/// Reads a blade file.
///
/// # Errors
/// Every fault of the text, ordered by place, each with line and column: of the value or the key;
/// for a key that is missing, of its table. A text that is not TOML or JSON has only faults of
/// syntax: what else is wrong with it cannot be known.
///
/// ```
/// use bladefan_core::formats::{Format, read};
/// let faults = read("schema = \"bladefan-blade/1\"\nname = 4\n", Format::Toml).unwrap_err();
/// assert_eq!(faults.last().unwrap().to_string(), "2:8: name: name must be text (is 4)");
/// ```
pub fn read(text: &str, format: Format) -> Result<BladeFile, Faults> {
    let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
    let tree = match format {
        Format::Toml => from_toml::tree(text),
        Format::Json => from_json::tree(text),
    };
    tree.and_then(|tree| read_placed(&tree)).map_err(|faults| in_order(text, &faults).into())
}

/// Reads a blade from an object that came from elsewhere, JavaScript say, in the file's keys.
///
/// # Errors
/// Every fault, without line and column.
pub fn read_tree(tree: &Tree) -> Result<BladeFile, Faults> {
    read_placed(tree).map_err(|faults| faults.into_iter().map(|placed| placed.fault).collect())
}

/// Reads a blade as given, without the check: its numbers may be missing or out of range.
///
/// # Errors
/// Every fault of keys, types, words and units, without line and column.
pub fn read_definition(tree: &Tree) -> Result<BladeDefinition, Faults> {
    let mut reader = Reader::default();
    let definition = reader.definition(tree);
    without_places(reader, definition)
}

/// Reads a table of units in the file's keys; those that are absent are those of `absent`.
///
/// # Errors
/// Every fault, without line and column.
pub fn read_units(tree: &Tree, absent: Units) -> Result<Units, Faults> {
    let mut reader = Reader::default();
    let units = reader.units_at("units", tree, absent);
    without_places(reader, units)
}

/// Reads a list of changes of a blade; units that are absent are those of `absent`, the blade's.
///
/// # Errors
/// Every fault, without line and column; paths are `changes[0].what` and the like.
pub fn read_changes(tree: &Tree, absent: Units) -> Result<Vec<Change>, Faults> {
    let mut reader = Reader::default();
    let changes = reader.changes(tree, absent);
    without_places(reader, changes)
}

fn without_places<T>(reader: Reader, value: T) -> Result<T, Faults> {
    let faults: Faults = reader.faults.into_iter().map(|placed| placed.fault).collect();
    faults.none().map(|()| value)
}

fn read_placed(tree: &Tree) -> Result<BladeFile, Vec<Placed>> {
    let mut reader = Reader::default();
    let definition = reader.definition(tree);
    let mut faults = reader.faults;
    match check(&definition) {
        Ok(blade) if faults.is_empty() => Ok(BladeFile { definition, blade }),
        Ok(_) => Err(faults),
        Err(found) => {
            let found = drop_consequences(found, &faults);
            faults.extend(found.into_iter().map(|fault| Placed { at: tree::find(tree, &fault.path), fault }));
            Err(faults)
        }
    }
}
