//! Texts to blades: bladefan's own files, and measured points (CSV). One file or folder per format;
//! the conventions of a format live there and nowhere else.

pub mod measured;
mod own;
mod place;

pub use own::{
    BladeFile, Entry, Format, Node, SCHEMA, Tree, read, read_changes, read_definition, read_tree, read_units, to_json,
    to_toml,
};

/// Editors may put it first; it is no part of a text.
const BYTE_ORDER_MARK: char = '\u{feff}';
