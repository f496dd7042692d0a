//! The questions that a blade is asked: one export per call of core's facade.

use crate::options::{self, Analysis};
use crate::{Answer, solve, solve_in, string};
use bladefan_core::formats;
use bladefan_core::{Blade, Faults, ModelKind, Settings};
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// What either model answers.
#[derive(Serialize)]
#[serde(untagged)]
enum Either<U, C> {
    Uncoupled(U),
    Coupled(C),
}

/// The answer of the model that the options choose.
fn either<U: Serialize, C: Serialize>(
    blade: &JsValue,
    options: &JsValue,
    analysis: Analysis,
    uncoupled: fn(&Blade, &Settings) -> Result<U, Faults>,
    coupled: fn(&Blade, &Settings) -> Result<C, Faults>,
) -> Answer {
    let answer = |blade: &Blade, settings: &Settings| {
        Ok(match settings.model_for(blade) {
            ModelKind::Uncoupled => Either::Uncoupled(uncoupled(blade, settings)?),
            ModelKind::Coupled => Either::Coupled(coupled(blade, settings)?),
        })
    };
    solve_in(Settings::model_for, blade, options::settings(options, analysis), answer)
}

/// Frequencies of every degree of freedom at one rotor speed.
#[wasm_bindgen(unchecked_return_type = "Reply<ModesReport | CoupledModesReport>")]
pub fn modes(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "ModesOptions")] options: &JsValue,
) -> Answer {
    either(blade, options, Analysis::Modes, bladefan_core::modes, bladefan_core::coupled_modes)
}

/// How far each mode is from the nearest harmonic at one rotor speed; nothing at rest.
#[wasm_bindgen(unchecked_return_type = "Reply<Margin[]>")]
pub fn margins(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "ModesOptions")] options: &JsValue,
) -> Answer {
    let uncoupled =
        |blade: &Blade, settings: &Settings| Ok(bladefan_core::margins(&bladefan_core::modes(blade, settings)?));
    let coupled = |blade: &Blade, settings: &Settings| Ok(bladefan_core::coupled_modes(blade, settings)?.margins());
    either(blade, options, Analysis::Modes, uncoupled, coupled)
}

/// Fan chart: branches over a range of rotor speeds, crossings, margins at nominal speed.
#[wasm_bindgen(unchecked_return_type = "Reply<FanChart>")]
pub fn fan(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "FanOptions")] options: &JsValue,
) -> Answer {
    let settings = options::settings(options, Analysis::Fan);
    solve_in(Settings::model_for, blade, settings, bladefan_core::fan)
}

/// Mode shapes along the span at one rotor speed.
#[wasm_bindgen(unchecked_return_type = "Reply<ShapesReport | CoupledShapesReport>")]
pub fn shapes(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "ShapesOptions")] options: &JsValue,
) -> Answer {
    either(blade, options, Analysis::Shapes, bladefan_core::shapes, bladefan_core::coupled_shapes)
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
        |(_, settings): &(_, Settings), blade| settings.model_for(blade),
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
