//! TOML text to a tree.

use super::tree::{Entry, Node, Tree};
use crate::fault::{Fault, FaultCode};
use crate::formats::place::{Placed, decapitalised};
use alloc::vec::Vec;
use toml::Spanned;
use toml::de::{DeInteger, DeTable, DeValue};

/// Most faults of syntax that are worth telling; after some the parser only guesses.
const MOST: usize = 20;

/// Reads a TOML text; places are byte offsets into it.
pub(super) fn tree(text: &str) -> Result<Tree, Vec<Placed>> {
    let (table, errors) = DeTable::parse_recoverable(text);
    if errors.is_empty() {
        return Ok(Tree { node: table_node(table.into_inner()), span: Some(0..text.len()) });
    }
    let mut faults: Vec<Placed> = Vec::new();
    for error in errors {
        let at = error.span().map_or(0, |span| span.start);
        // Recovery may report one place more than once.
        if faults.last().is_none_or(|last| last.at != Some(at)) && faults.len() < MOST {
            let message = decapitalised(error.message());
            let fault = Fault::new(FaultCode::Syntax, "", None, "must be TOML", message);
            faults.push(Placed { at: Some(at), fault });
        }
    }
    Err(faults)
}

fn table_node(table: DeTable<'_>) -> Node {
    let entry = |(key, value): (Spanned<_>, _)| Entry {
        key_span: Some(key.span()),
        key: alloc::borrow::Cow::<str>::into_owned(key.into_inner()),
        value: value_tree(value),
    };
    Node::Table(table.into_iter().map(entry).collect())
}

/// Recursion ends: the parser refuses deep nesting.
fn value_tree(value: Spanned<DeValue<'_>>) -> Tree {
    let span = Some(value.span());
    let node = match value.into_inner() {
        DeValue::String(text) => Node::Text(text.into_owned()),
        DeValue::Integer(integer) => Node::Number(number(&integer)),
        // A number too large for f64 reads as infinite, and is refused as such.
        DeValue::Float(float) => Node::Number(float.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(value) => Node::Bool(value),
        DeValue::Datetime(_) => Node::Date,
        DeValue::Array(values) => Node::List(values.into_iter().map(value_tree).collect()),
        DeValue::Table(table) => table_node(table),
    };
    Tree { node, span }
}

fn number(integer: &DeInteger<'_>) -> f64 {
    if integer.radix() == 10 {
        return integer.as_str().parse().unwrap_or(f64::NAN);
    }
    // 128 bits are more than a blade needs; beyond, infinite.
    u128::from_str_radix(integer.as_str(), integer.radix()).map_or(f64::INFINITY, |value| value as f64)
}
