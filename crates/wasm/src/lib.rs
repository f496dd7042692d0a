//! Bindings of bladefan for the browser and Node: one thin export per call of core's facade.
//!
//! Plain objects in and out. A call answers `{status: "ok", value, warnings}` or
//! `{status: "error", faults}`, whatever it is given; an exception means a mistake of ours.
//! The exports' TypeScript types are in `types.ts`.

#![allow(clippy::missing_errors_doc, reason = "the same for every export, and said above")]

mod about;
mod analyses;
mod changes;
mod charts;
mod curves;
mod files;
mod options;
mod reply;
mod tree;

pub use crate::about::*;
pub use crate::analyses::*;
pub use crate::changes::*;
pub use crate::charts::*;
pub use crate::files::*;

use crate::reply::reply;
use bladefan_core::Blade;
use bladefan_core::formats::{self, BladeFile, Tree};
use bladefan_core::{Faults, ModelKind};
use serde::Serialize;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("types.ts");

/// What every export gives: a tagged object, or an exception by a mistake of ours.
type Answer = Result<JsValue, JsError>;

/// Solves with a blade and settings that may both be faulty: all faults at once.
fn solve<S, R: Serialize>(
    blade: &JsValue,
    settings: Result<S, Faults>,
    solve: impl FnOnce(&Blade, &S) -> Result<R, Faults>,
) -> Answer {
    with(blade, settings, |file, settings| solve(&file.blade, settings))
}

/// The same where the settings choose a model, which has warnings of its own.
fn solve_in<S, R: Serialize>(
    model: impl Fn(&S, &Blade) -> ModelKind,
    blade: &JsValue,
    settings: Result<S, Faults>,
    solve: impl FnOnce(&Blade, &S) -> Result<R, Faults>,
) -> Answer {
    reply(Faults::both(read_blade(blade), settings).and_then(|(file, settings)| {
        let result = solve(&file.blade, &settings)?;
        let warnings = match model(&settings, &file.blade) {
            ModelKind::Uncoupled => bladefan_core::warnings(&file.blade),
            ModelKind::Coupled => file.blade.warnings().to_vec(),
        };
        Ok((result, warnings))
    }))
}

/// The same with the blade as given and as checked.
fn with<S, R: Serialize>(
    blade: &JsValue,
    settings: Result<S, Faults>,
    answer: impl FnOnce(&BladeFile, &S) -> Result<R, Faults>,
) -> Answer {
    reply(Faults::both(read_blade(blade), settings).and_then(|(file, settings)| {
        let result = answer(&file, &settings)?;
        Ok((result, bladefan_core::warnings(&file.blade)))
    }))
}

fn read_tree(value: &JsValue, name: &str) -> Result<Tree, Faults> {
    Ok(tree::tree(value, name)?)
}

fn read_blade(blade: &JsValue) -> Result<BladeFile, Faults> {
    read_tree(blade, "blade").and_then(|tree| formats::read_tree(&tree))
}

fn string(value: &JsValue, name: &str) -> Result<String, Faults> {
    value.as_string().ok_or_else(|| tree::fault(name, "must be text").into())
}
