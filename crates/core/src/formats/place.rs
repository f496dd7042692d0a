//! Where faults stand in the text, and which of them only follow from others.

use crate::fault::{Fault, FaultCode, Faults};
use crate::order::order;
use alloc::collections::BTreeSet;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

/// A fault and the byte of the text it stands at.
#[derive(Clone)]
pub(super) struct Placed {
    pub(super) at: Option<usize>,
    pub(super) fault: Fault,
}

/// Orders faults by place and gives each its line and column, both from 1, columns in characters.
pub(super) fn in_order(text: &str, faults: &[Placed]) -> Vec<Fault> {
    // Those without a place first.
    let places: Vec<f64> = faults.iter().map(|placed| placed.at.map_or(-1.0, |at| at as f64)).collect();
    let (mut line, mut column, mut reached) = (1_u32, 1_u32, 0);
    let mut rest = text.chars();
    // One walk through the text for all faults, which may be many on one long line.
    order(&places)
        .into_iter()
        .map(|index| {
            let Placed { at, mut fault } = faults[index].clone();
            let Some(at) = at else { return fault };
            while reached < at.min(text.len()) {
                let Some(c) = rest.next() else { break };
                reached += c.len_utf8();
                if c == '\n' {
                    line = line.saturating_add(1);
                    column = 1;
                } else {
                    column = column.saturating_add(1);
                }
            }
            fault.line = Some(line);
            fault.column = Some(column);
            fault
        })
        .collect()
}

/// Leaves out what the check found only because the reader had already refused a value: the same
/// path, a path below it, or something missing or unreadable around it.
pub(super) fn drop_consequences(found: Faults, refused: &[Placed]) -> Vec<Fault> {
    let paths = refused.iter().map(|placed| placed.fault.path.as_str());
    let mut refused: BTreeSet<&str> = BTreeSet::new();
    refused.extend(paths); // collecting would sort: more code for a page to load
    let starts_below = |path: &str, separator: char| {
        let prefix = format!("{path}{separator}");
        refused.range(prefix.as_str()..).next().is_some_and(|next| next.starts_with(&prefix))
    };
    let follows = |fault: &Fault| {
        let path = fault.path.as_str();
        // An empty path is the whole file.
        let ends = path.char_indices().filter(|(_, c)| matches!(c, '.' | '[')).map(|(i, _)| i);
        ends.chain([0, path.len()]).any(|end| refused.contains(&path[..end]))
            || matches!(fault.code, FaultCode::Missing | FaultCode::NotFinite)
                && (starts_below(path, '.') || starts_below(path, '['))
    };
    found.into_iter().filter(|fault| !follows(fault)).collect()
}

/// A library's message in our style: no capital at its start.
pub(super) fn decapitalised(message: &str) -> String {
    let mut message = String::from(message);
    // A word in capitals (TOML, NaN) stays.
    if !message.as_bytes().get(1).is_some_and(u8::is_ascii_uppercase) {
        message.get_mut(..1).map(str::make_ascii_lowercase);
    }
    message
}
