//! Bindings of bladefan for the browser and Node: one thin export per call of core's facade.
//!
//! Plain objects in and out. A call answers `{status: "ok", value, warnings}` or
//! `{status: "error", faults}`, whatever it is given; an exception means a mistake of ours.
//! The exports' TypeScript types are in `types.ts`.

#![allow(clippy::missing_errors_doc, reason = "the same for every export, and said above")]

mod about;
mod analyses;
mod charts;
mod files;
mod options;
mod reply;
mod tree;

pub use crate::about::*;
pub use crate::analyses::*;
pub use crate::charts::*;
pub use crate::files::*;

use crate::reply::reply;
use bladefan_core::blade::Blade;
use bladefan_core::fault::Fault;
use bladefan_core::formats::{self, BladeFile, Tree};
use serde::Serialize;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("types.ts");

/// What every export gives: a tagged object, or an exception by a mistake of ours.
type Answer = Result<JsValue, JsError>;

/// Solves with a blade and settings that may both be faulty: all faults at once.
fn solve<S, R: Serialize>(
    blade: &JsValue,
    settings: Result<S, Vec<Fault>>,
    solve: impl FnOnce(&Blade, &S) -> Result<R, Vec<Fault>>,
) -> Answer {
    with(blade, settings, |file, settings| solve(&file.blade, settings))
}

/// The same with the blade as given and as checked.
fn with<S, R: Serialize>(
    blade: &JsValue,
    settings: Result<S, Vec<Fault>>,
    answer: impl FnOnce(&BladeFile, &S) -> Result<R, Vec<Fault>>,
) -> Answer {
    reply(both(read_blade(blade), settings).and_then(|(file, settings)| {
        let result = answer(&file, &settings)?;
        Ok((result, file.blade.warnings().to_vec()))
    }))
}

/// Both, or the faults of both.
fn both<A, B>(a: Result<A, Vec<Fault>>, b: Result<B, Vec<Fault>>) -> Result<(A, B), Vec<Fault>> {
    match (a, b) {
        (Ok(a), Ok(b)) => Ok((a, b)),
        (a, b) => Err([a.err().unwrap_or_default(), b.err().unwrap_or_default()].concat()),
    }
}

fn read_tree(value: &JsValue, name: &str) -> Result<Tree, Vec<Fault>> {
    tree::tree(value, name).map_err(|fault| vec![fault])
}

fn read_blade(blade: &JsValue) -> Result<BladeFile, Vec<Fault>> {
    read_tree(blade, "blade").and_then(|tree| formats::read_tree(&tree))
}

fn string(value: &JsValue, name: &str) -> Result<String, Vec<Fault>> {
    value.as_string().ok_or_else(|| vec![tree::fault(name, "must be text")])
}
