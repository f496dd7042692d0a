//! What the program says of itself: its version, its units, the blades that it brings.

use crate::Answer;
use crate::reply::reply;
use bladefan_core::Faults;
use bladefan_core::VERSION;
use bladefan_core::chart::FrequencyUnit;
use bladefan_core::formats::{self, Format};
use bladefan_core::library;
use bladefan_core::units::{AngleUnit, ForceUnit, LengthUnit, MassUnit, SpeedUnit};
use serde::Serialize;
use wasm_bindgen::prelude::*;

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
        model: bladefan_core::MODEL,
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

/// Version of this program.
#[wasm_bindgen]
pub fn version() -> String {
    VERSION.into()
}
