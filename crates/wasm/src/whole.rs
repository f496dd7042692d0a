//! What a page needs once a blade is read, written or compared, and the analyses that its first view
//! does not show.

use crate::options::{self, Analysis};
use crate::reply::reply;
use crate::{Answer, read_tree, solve, tree, with};
use bladefan_core::VERSION;
use bladefan_core::analysis;
use bladefan_core::blade;
use bladefan_core::chart::FrequencyUnit;
use bladefan_core::fault::{Fault, FaultCode, Faults};
use bladefan_core::formats::{self, BladeFile, Format};
use bladefan_core::library;
use bladefan_core::units::{AngleUnit, ForceUnit, LengthUnit, MassUnit, SpeedUnit};
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// Reads a blade file's text. Without a format it is JSON where the first character that is not
/// blank is `{`, else TOML.
#[wasm_bindgen(unchecked_return_type = "Reply<Blade>")]
pub fn parse_blade(
    #[wasm_bindgen(unchecked_param_type = "string")] text: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "\"toml\" | \"json\"")] format: &JsValue,
) -> Answer {
    reply(read_text(text, format).map(|file| (file.definition, analysis::warnings(&file.blade))))
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
    reply(Faults::both(given, units).map(|(given, units)| (blade::convert(&given, units), Vec::new())))
}

/// How far each mode is from the nearest harmonic at one rotor speed; nothing at rest.
#[wasm_bindgen(unchecked_return_type = "Reply<Margin[]>")]
pub fn margins(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "ModesOptions")] options: &JsValue,
) -> Answer {
    solve(blade, options::settings(options, Analysis::Modes), |blade, settings| {
        Ok(analysis::margins(&analysis::modes(blade, settings)?))
    })
}

/// Mode shapes along the span at one rotor speed.
#[wasm_bindgen(unchecked_return_type = "Reply<ShapesReport>")]
pub fn shapes(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "ShapesOptions")] options: &JsValue,
) -> Answer {
    solve(blade, options::settings(options, Analysis::Shapes), analysis::shapes)
}

/// Frequency against the number of assumed functions at one rotor speed.
#[wasm_bindgen(unchecked_return_type = "Reply<ConvergeReport>")]
pub fn converge(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "ConvergeOptions")] options: &JsValue,
) -> Answer {
    solve(blade, options::settings(options, Analysis::Converge), analysis::converge)
}

/// Mass, inertia and static moments of a blade.
#[wasm_bindgen(unchecked_return_type = "Reply<BladeSummary>")]
pub fn check(#[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue) -> Answer {
    solve(blade, Ok(()), |blade, ()| Ok(analysis::summary(blade)))
}

/// Reads measured points (CSV with the columns label, speed, frequency, source).
#[wasm_bindgen(unchecked_return_type = "Reply<MeasuredPoint[]>")]
pub fn measured(#[wasm_bindgen(unchecked_param_type = "string")] text: &JsValue) -> Answer {
    reply(string(text, "text").and_then(|text| formats::measured::read(&text)).map(|points| (points, Vec::new())))
}

/// Sets measured points (CSV as `measured` reads it) beside the solver's answer: the frequency of each
/// point's branch at its own rotor speed.
#[wasm_bindgen(unchecked_return_type = "Reply<ComparedPoint[]>")]
pub fn compare(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "string")] csv: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "CompareOptions")] options: &JsValue,
) -> Answer {
    let points = string(csv, "csv").and_then(|text| formats::measured::read(&text));
    let given = Faults::both(points, options::settings(options, Analysis::Compare));
    solve(blade, given, |blade, (points, settings)| analysis::compare(blade, points, settings))
}

/// The built-in blades with the text of their files.
#[wasm_bindgen(unchecked_return_type = "Reply<BuiltInBlade[]>")]
pub fn built_in_blades() -> Answer {
    #[derive(Serialize)]
    struct BuiltIn {
        name: &'static str,
        title: Option<String>,
        quality: Option<String>,
        citation: Option<String>,
        toml: &'static str,
    }
    let listed = library::ENTRIES.iter().map(|&library::Entry { name, toml }| {
        let definition = formats::read(toml, Format::Toml)?.definition;
        let source = definition.source.unwrap_or_default();
        Ok(BuiltIn { name, title: definition.name, quality: source.quality, citation: source.citation, toml })
    });
    reply(listed.collect::<Result<Vec<_>, Faults>>().map(|blades| (blades, Vec::new())))
}

/// What a page says about the program: its version, its model, the units it knows.
#[wasm_bindgen(unchecked_return_type = "Reply<About>")]
pub fn about() -> Answer {
    #[derive(Serialize)]
    struct Unit {
        name: &'static str,
        rad_s: f64,
    }
    #[derive(Serialize)]
    struct About {
        version: &'static str,
        model: &'static str,
        speed_units: Vec<Unit>,
        frequency_units: Vec<&'static str>,
        units: BladeUnits,
    }
    /// The names of each quantity's units in a blade file.
    #[derive(Serialize)]
    struct BladeUnits {
        length: Vec<&'static str>,
        mass: Vec<&'static str>,
        force: Vec<&'static str>,
        angle: Vec<&'static str>,
        speed: Vec<&'static str>,
    }
    let about = About {
        version: VERSION,
        model: analysis::MODEL,
        speed_units: SpeedUnit::ALL.iter().map(|unit| Unit { name: unit.name(), rad_s: unit.si() }).collect(),
        frequency_units: FrequencyUnit::ALL.iter().map(|unit| unit.name()).collect(),
        units: BladeUnits {
            length: LengthUnit::ALL.iter().map(|unit| unit.name()).collect(),
            mass: MassUnit::ALL.iter().map(|unit| unit.name()).collect(),
            force: ForceUnit::ALL.iter().map(|unit| unit.name()).collect(),
            angle: AngleUnit::ALL.iter().map(|unit| unit.name()).collect(),
            speed: SpeedUnit::ALL.iter().map(|unit| unit.name()).collect(),
        },
    };
    reply(Ok((about, Vec::new())))
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

fn string(value: &JsValue, name: &str) -> Result<String, Faults> {
    value.as_string().ok_or_else(|| tree::fault(name, "must be text").into())
}
