//! What TOML, JSON and JavaScript objects have in common, with the place of everything in the text.

use alloc::string::String;
use alloc::vec::Vec;
use core::ops::Range;
use serde::ser::{Serialize, SerializeMap, Serializer};

/// A value and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Tree {
    /// The value.
    pub node: Node,
    /// Bytes of the text that it stands on, where there is a text.
    pub span: Option<Range<usize>>,
}

/// A value of TOML, JSON or JavaScript.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// `null`, `undefined`.
    Null,
    /// `true`, `false`.
    Bool(bool),
    /// Any number; may be infinite or not a number.
    Number(f64),
    /// A string.
    Text(String),
    /// A date or time of TOML.
    Date,
    /// An array.
    List(Vec<Tree>),
    /// A table or object, its keys all different.
    Table(Vec<Entry>),
}

/// A key and its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The key.
    pub key: String,
    /// Bytes of the text that the key stands on, where there is a text.
    pub key_span: Option<Range<usize>>,
    /// Its value.
    pub value: Tree,
}

impl Tree {
    /// A value without a place in a text.
    pub fn new(node: Node) -> Self {
        Self { node, span: None }
    }

    /// The value of a key, where this is a table that has it.
    pub fn get(&self, key: &str) -> Option<&Self> {
        match &self.node {
            Node::Table(entries) => entries.iter().find(|entry| entry.key == key).map(|entry| &entry.value),
            _ => None,
        }
    }

    /// First byte of the text that this stands on.
    pub(super) fn at(&self) -> Option<usize> {
        self.span.as_ref().map(|span| span.start)
    }
}

impl Serialize for Tree {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match &self.node {
            Node::Null => serializer.serialize_unit(),
            Node::Bool(value) => serializer.serialize_bool(*value),
            Node::Number(value) => serializer.serialize_f64(*value),
            Node::Text(value) => serializer.serialize_str(value),
            Node::Date => Err(serde::ser::Error::custom("a date has no place in a blade file")),
            Node::List(values) => serializer.collect_seq(values),
            Node::Table(entries) => {
                let mut map = serializer.serialize_map(Some(entries.len()))?;
                for Entry { key, value, .. } in entries {
                    map.serialize_entry(key, value)?;
                }
                map.end()
            }
        }
    }
}

/// The place of a path as the check writes it (`distribution.mass[3]`): of the value, or of the
/// innermost table or list around it that is there; the text's beginning for a missing table.
pub(super) fn find(tree: &Tree, path: &str) -> Option<usize> {
    tree.span.as_ref()?;
    let mut here = tree;
    let mut at = 0;
    for step in path.split(['.', '[']) {
        let below = match step.strip_suffix(']') {
            Some(index) => match &here.node {
                Node::List(values) => index.parse().ok().and_then(|index: usize| values.get(index)),
                _ => None,
            },
            None => here.get(step),
        };
        let Some(below) = below else { break };
        at = below.at().unwrap_or(at);
        here = below;
    }
    Some(at)
}
