//! Blade files and measured points, read and written.

use crate::reply::reply;
use crate::{Answer, read_tree, string, with};
use bladefan_core::formats::{self, BladeFile, Format};
use bladefan_core::{Fault, FaultCode, Faults};
use wasm_bindgen::prelude::*;

/// Reads a blade file's text. Without a format it is JSON where the first character that is not
/// blank is `{`, else TOML.
#[wasm_bindgen(unchecked_return_type = "Reply<Blade>")]
pub fn parse_blade(
    #[wasm_bindgen(unchecked_param_type = "string")] text: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "\"toml\" | \"json\"")] format: &JsValue,
) -> Answer {
    reply(read_text(text, format).map(|file| (file.definition, bladefan_core::warnings(&file.blade))))
}

/// The text of a blade file in TOML or JSON, which `parse_blade` reads back the same.
#[wasm_bindgen(unchecked_return_type = "Reply<string>")]
pub fn write_blade(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "\"toml\" | \"json\"")] format: &JsValue,
) -> Answer {
    let format = known_format(format).and_then(|format| format.ok_or_else(|| unknown_format(None)));
    with(blade, format, |file, format| {
        Ok(match format {
            Format::Toml => formats::to_toml(&file.definition),
            Format::Json => formats::to_json(&file.definition),
        })
    })
}

/// The same blade in other units. `units` has the keys of the blade file's `units`; where one is
/// absent the blade's own unit stays. Numbers may be missing or out of range: nothing is checked.
#[wasm_bindgen(unchecked_return_type = "Reply<Blade>")]
pub fn convert_blade(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Units")] units: &JsValue,
) -> Answer {
    let given = read_tree(blade, "blade").and_then(|tree| formats::read_definition(&tree));
    // The blade's own units stand in for absent ones; without a blade the faults are the same.
    let own = given.as_ref().map(|definition| definition.units).unwrap_or_default();
    let units = read_tree(units, "units").and_then(|tree| formats::read_units(&tree, own));
    reply(Faults::both(given, units).map(|(given, units)| (bladefan_core::convert(&given, units), Vec::new())))
}

/// Reads measured points (CSV with the columns label, speed, frequency, source).
#[wasm_bindgen(unchecked_return_type = "Reply<MeasuredPoint[]>")]
pub fn measured(#[wasm_bindgen(unchecked_param_type = "string")] text: &JsValue) -> Answer {
    reply(string(text, "text").and_then(|text| formats::measured::read(&text)).map(|points| (points, Vec::new())))
}

fn read_text(text: &JsValue, format: &JsValue) -> Result<BladeFile, Faults> {
    let text = string(text, "text")?;
    let format = known_format(format)?.unwrap_or_else(|| Format::of_text(&text));
    formats::read(&text, format)
}

/// A format by name; none where it is not given.
fn known_format(format: &JsValue) -> Result<Option<Format>, Faults> {
    match format.as_string().as_deref() {
        Some("toml") => Ok(Some(Format::Toml)),
        Some("json") => Ok(Some(Format::Json)),
        None if format.is_undefined() || format.is_null() => Ok(None),
        other => Err(unknown_format(other)),
    }
}

fn unknown_format(given: Option<&str>) -> Faults {
    let rule = "must be toml or json";
    Fault::new(FaultCode::UnknownChoice, "format", given.map(String::from), rule, rule).into()
}
