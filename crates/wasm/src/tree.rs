//! A JavaScript value as a tree that core reads a blade from.
//!
//! Written out rather than derived: values from JavaScript may hold themselves, have getters that
//! throw or be proxies, and all of that must end as a fault, never as an exception.

use bladefan_core::formats::{Entry, Node, Tree};
use bladefan_core::{Fault, FaultCode};
use js_sys::{Array, Reflect};
use wasm_bindgen::prelude::*;

/// Deepest nesting; a blade file needs three levels.
const DEEPEST: usize = 16;
/// Most values in one object. A value that holds itself more than once would take for ever.
const MOST_VALUES: u32 = 2_000_000;

#[wasm_bindgen]
extern "C" {
    // js-sys has both without `catch`; a proxy may throw.
    #[wasm_bindgen(catch, js_namespace = Array, js_name = isArray)]
    fn is_array(value: &JsValue) -> Result<bool, JsValue>;
    #[wasm_bindgen(catch, js_namespace = Object, js_name = keys)]
    fn keys(value: &JsValue) -> Result<Array, JsValue>;
}

/// The keys and values of an object, in its own order.
///
/// # Errors
/// A value that is no object, or one that throws when it is looked at.
pub(crate) fn entries(value: &JsValue, path: &str) -> Result<Vec<(String, JsValue)>, Fault> {
    if !value.is_object() || is_array(value).map_err(|_| unreadable(path))? {
        return Err(not_an_object(path));
    }
    let keys = keys(value).map_err(|_| unreadable(path))?;
    keys.iter()
        .map(|key| {
            let held = Reflect::get(value, &key).map_err(|_| unreadable(path))?;
            Ok((key.as_string().unwrap_or_default(), held))
        })
        .collect()
}

/// The elements of an array; none where the value is not an array.
///
/// # Errors
/// An array that throws when it is looked at, or one that is too long.
pub(crate) fn elements(value: &JsValue, path: &str) -> Result<Option<Vec<JsValue>>, Fault> {
    if !is_array(value).map_err(|_| unreadable(path))? {
        return Ok(None);
    }
    let length = Reflect::get(value, &JsValue::from_str("length")).map_err(|_| unreadable(path))?;
    let length = length.as_f64().unwrap_or(0.0);
    if length > f64::from(MOST_VALUES) {
        return Err(too_large(path));
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to MOST_VALUES")]
    let length = length as u32;
    (0..length)
        .map(|index| Reflect::get_u32(value, index).map_err(|_| unreadable(path)))
        .collect::<Result<_, _>>()
        .map(Some)
}

/// An object as a tree; `name` is what it is called where it is none.
///
/// # Errors
/// What is not text, a number, a truth value, a list or an object; too deep, too much.
pub(crate) fn tree(value: &JsValue, name: &str) -> Result<Tree, Fault> {
    entries(value, name)?; // a plain object, and one that can be read
    Walk { left: MOST_VALUES }.tree(value, "", 0)
}

/// Any value as a tree; `name` is what it is called in paths.
///
/// # Errors
/// As for [`tree`].
pub(crate) fn any(value: &JsValue, name: &str) -> Result<Tree, Fault> {
    Walk { left: MOST_VALUES }.tree(value, name, 0)
}

/// How many more values may be read.
struct Walk {
    left: u32,
}

impl Walk {
    fn tree(&mut self, value: &JsValue, path: &str, depth: usize) -> Result<Tree, Fault> {
        self.left = self.left.checked_sub(1).ok_or_else(|| too_large(path))?;
        let node = if value.is_null() || value.is_undefined() {
            Node::Null
        } else if let Some(truth) = value.as_bool() {
            Node::Bool(truth)
        } else if let Some(number) = value.as_f64() {
            Node::Number(number)
        } else if let Some(text) = value.as_string() {
            Node::Text(text)
        } else if !value.is_object() {
            return Err(fault(path, "must be text, a number, a list or an object"));
        } else if depth == DEEPEST {
            return Err(fault(path, "must not be nested so deeply"));
        } else if let Some(list) = elements(value, path)? {
            let each = |(i, value): (usize, &JsValue)| self.tree(value, &format!("{path}[{i}]"), depth + 1);
            Node::List(list.iter().enumerate().map(each).collect::<Result<_, _>>()?)
        } else {
            Node::Table(self.table(value, path, depth)?)
        };
        Ok(Tree::new(node))
    }

    fn table(&mut self, value: &JsValue, path: &str, depth: usize) -> Result<Vec<Entry>, Fault> {
        let mut table = Vec::new();
        for (key, held) in entries(value, path)? {
            // As in JSON, a key that is undefined is a key that is not there.
            if !held.is_undefined() {
                let below = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
                table.push(Entry { key, key_span: None, value: self.tree(&held, &below, depth + 1)? });
            }
        }
        Ok(table)
    }
}

/// A value of the wrong type at a path.
pub(crate) fn fault(path: &str, rule: &str) -> Fault {
    Fault::new(FaultCode::WrongType, path, None, rule, rule)
}

fn not_an_object(path: &str) -> Fault {
    fault(path, "must be an object")
}

fn unreadable(path: &str) -> Fault {
    fault(path, "must be plain data (it throws when it is read)")
}

fn too_large(path: &str) -> Fault {
    let rule = format!("must hold at most {MOST_VALUES} values");
    Fault::new(FaultCode::Length, path, None, rule.as_str(), rule.as_str())
}
