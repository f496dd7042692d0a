//! JSON text to a tree.

use super::tree::{Entry, Node, Tree};
use crate::fault::{Fault, FaultCode};
use crate::formats::place::{Placed, decapitalised};
use alloc::collections::BTreeSet;
use alloc::string::ToString;
use alloc::vec;
use alloc::vec::Vec;
use jsonc_parser::ast::Value;
use jsonc_parser::common::{Range, Ranged};
use jsonc_parser::{CollectOptions, ParseOptions, parse_to_ast};

/// Deepest nesting. A blade file needs three levels; the parser recurses.
const DEEPEST: usize = 64;

/// The parser's options for JSON as RFC 8259 has it.
const STRICT: ParseOptions = ParseOptions {
    allow_comments: false,
    allow_loose_object_property_names: false,
    allow_trailing_commas: false,
    allow_missing_commas: false,
    allow_single_quoted_strings: false,
    allow_hexadecimal_numbers: false,
    allow_unary_plus_numbers: false,
    allow_bare_decimal_point_numbers: false,
    allow_non_finite_numbers: false,
    allow_extended_string_escapes: false,
};

/// Reads a JSON text; places are byte offsets into it.
pub(super) fn tree(text: &str) -> Result<Tree, Vec<Placed>> {
    if let Some(fault) = scan(text) {
        return Err(vec![fault]);
    }
    let parsed = parse_to_ast(text, &CollectOptions::default(), &STRICT)
        .map_err(|error| vec![syntax(error.range().start, &decapitalised(&error.kind().to_string()))])?;
    let Some(value) = parsed.value else {
        return Err(vec![syntax(0, "the text is empty")]);
    };
    let mut twice = Vec::new();
    let tree = value_tree(value, &mut twice);
    if twice.is_empty() { Ok(tree) } else { Err(twice) }
}

fn syntax(at: usize, message: &str) -> Placed {
    Placed { at: Some(at), fault: Fault::new(FaultCode::Syntax, "", None, "must be JSON", message) }
}

/// What the parser lets pass or could not bear: control characters in strings, blanks that are
/// not JSON's, and deep nesting.
fn scan(text: &str) -> Option<Placed> {
    let (mut inside, mut escaped, mut depth) = (false, false, 0_usize);
    for (at, c) in text.char_indices() {
        match c {
            _ if escaped => escaped = false,
            '\\' if inside => escaped = true,
            '"' => inside = !inside,
            '\0'..='\x1f' if inside => return Some(syntax(at, "a control character in a string must be escaped")),
            _ if inside => {}
            ' ' | '\t' | '\n' | '\r' => {}
            _ if c.is_whitespace() => return Some(syntax(at, "this kind of blank is not allowed outside strings")),
            '{' | '[' if depth == DEEPEST => return Some(syntax(at, "nested too deeply")),
            '{' | '[' => depth += 1,
            '}' | ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
    }
    None
}

fn value_tree(value: Value<'_>, twice: &mut Vec<Placed>) -> Tree {
    let Range { start, end } = value.range();
    let node = match value {
        Value::StringLit(text) => Node::Text(text.value.into_owned()),
        // A number too large for f64 reads as infinite, and is refused as such.
        Value::NumberLit(number) => Node::Number(number.value.parse().unwrap_or(f64::NAN)),
        Value::BooleanLit(value) => Node::Bool(value.value),
        Value::NullKeyword(_) => Node::Null,
        Value::Array(list) => Node::List(list.elements.into_iter().map(|value| value_tree(value, twice)).collect()),
        Value::Object(object) => {
            // A set of the same type as elsewhere: each other would be more code for a page to load.
            let mut keys: BTreeSet<&str> = BTreeSet::new();
            let again: Vec<bool> =
                object.properties.iter().map(|property| !keys.insert(property.name.as_str())).collect();
            let mut entries = Vec::with_capacity(object.properties.len());
            for (property, again) in object.properties.into_iter().zip(again) {
                let range = property.name.range();
                let value = value_tree(property.value, twice);
                if again {
                    twice.push(syntax(range.start, "duplicate key"));
                } else {
                    let key = property.name.into_string();
                    entries.push(Entry { key, key_span: Some(range.start..range.end), value });
                }
            }
            Node::Table(entries)
        }
    };
    Tree { node, span: Some(start..end) }
}
