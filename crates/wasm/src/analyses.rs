//! The questions that a blade is asked: one export per call of core's facade.

use crate::options::{self, Analysis};
use crate::{Answer, solve, solve_in, string};
use bladefan_core::formats;
use bladefan_core::{Faults, ModelKind, Settings};
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// What either model answers.
#[derive(Serialize)]
#[serde(untagged)]
enum Either<U, C> {
    Uncoupled(U),
    Coupled(C),
}

/// Frequencies of every degree of freedom at one rotor speed.
#[wasm_bindgen(unchecked_return_type = "Reply<ModesReport | CoupledModesReport>")]
pub fn modes(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "ModesOptions")] options: &JsValue,
) -> Answer {
    let settings = options::settings(options, Analysis::Modes);
    solve_in(
        |settings| settings.model,
        blade,
        settings,
        |blade, settings: &Settings| {
            Ok(match settings.model {
                ModelKind::Uncoupled => Either::Uncoupled(bladefan_core::modes(blade, settings)?),
                ModelKind::Coupled => Either::Coupled(bladefan_core::coupled_modes(blade, settings)?),
            })
        },
    )
}

/// How far each mode is from the nearest harmonic at one rotor speed; nothing at rest.
#[wasm_bindgen(unchecked_return_type = "Reply<Margin[]>")]
pub fn margins(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "ModesOptions")] options: &JsValue,
) -> Answer {
    let settings = options::settings(options, Analysis::Modes);
    solve_in(
        |settings| settings.model,
        blade,
        settings,
        |blade, settings: &Settings| {
            Ok(match settings.model {
                ModelKind::Uncoupled => bladefan_core::margins(&bladefan_core::modes(blade, settings)?),
                ModelKind::Coupled => bladefan_core::coupled_modes(blade, settings)?.margins(),
            })
        },
    )
}

/// Fan chart: branches over a range of rotor speeds, crossings, margins at nominal speed.
#[wasm_bindgen(unchecked_return_type = "Reply<FanChart>")]
pub fn fan(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "FanOptions")] options: &JsValue,
) -> Answer {
    let settings = options::settings(options, Analysis::Fan);
    solve_in(|settings: &Settings| settings.model, blade, settings, bladefan_core::fan)
}

/// Mode shapes along the span at one rotor speed.
#[wasm_bindgen(unchecked_return_type = "Reply<ShapesReport | CoupledShapesReport>")]
pub fn shapes(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "ShapesOptions")] options: &JsValue,
) -> Answer {
    let settings = options::settings(options, Analysis::Shapes);
    solve_in(
        |settings| settings.model,
        blade,
        settings,
        |blade, settings: &Settings| {
            Ok(match settings.model {
                ModelKind::Uncoupled => Either::Uncoupled(bladefan_core::shapes(blade, settings)?),
                ModelKind::Coupled => Either::Coupled(bladefan_core::coupled_shapes(blade, settings)?),
            })
        },
    )
}

/// Frequency against the number of assumed functions at one rotor speed.
#[wasm_bindgen(unchecked_return_type = "Reply<ConvergeReport>")]
pub fn converge(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "ConvergeOptions")] options: &JsValue,
) -> Answer {
    solve(blade, options::settings(options, Analysis::Converge), bladefan_core::converge)
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
    solve_in(
        |(_, settings): &(_, Settings)| settings.model,
        blade,
        given,
        |blade, (points, settings)| bladefan_core::compare(blade, points, settings),
    )
}

/// Mass, inertia and static moments of a blade.
#[wasm_bindgen(unchecked_return_type = "Reply<BladeSummary>")]
pub fn check(#[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue) -> Answer {
    solve(blade, Ok(()), |blade, ()| Ok(bladefan_core::summary(blade)))
}
