//! Bindings of bladefan for the browser and Node: one thin export per call of core's facade.
//!
//! Plain objects in and out. A call answers `{status: "ok", value, warnings}` or
//! `{status: "error", faults}`, whatever it is given; an exception means a mistake of ours.
//! The exports' TypeScript types are in `types.ts`.

#![allow(clippy::missing_errors_doc, reason = "the same for every export, and said above")]

mod chart;
mod options;
mod reply;
mod tree;
#[cfg(feature = "whole")]
mod whole;
#[cfg(feature = "whole")]
pub use whole::*;

use crate::options::Analysis;
use crate::reply::reply;
use bladefan_core::VERSION;
use bladefan_core::analysis;
use bladefan_core::blade::{self, Blade};
use bladefan_core::chart::{self as draw, Drawing, PlotArea};
use bladefan_core::fault::{Fault, FaultCode, Faults};
use bladefan_core::formats::{self, BladeFile, Tree};
use bladefan_core::report::FanChart;
#[cfg(feature = "whole")]
use bladefan_core::report::{ConvergeReport, ShapesReport};
use serde::Serialize;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("types.ts");

/// A drawing and what it shows, so that a page that draws need not solve again.
#[derive(Serialize)]
struct Drawn {
    svg: String,
    width: f64,
    height: f64,
    plots: Vec<PlotArea>,
    report: Report,
}

impl Drawn {
    fn new(Drawing { svg, width, height, plots }: Drawing, report: Report) -> Self {
        Self { svg, width, height, plots, report }
    }
}

/// The result behind a drawing.
#[derive(Serialize)]
#[serde(untagged)]
enum Report {
    Fan(FanChart),
    #[cfg(feature = "whole")]
    Shapes(ShapesReport),
    #[cfg(feature = "whole")]
    Converge(ConvergeReport),
}

/// What every export gives: a tagged object, or an exception by a mistake of ours.
type Answer = Result<JsValue, JsError>;

/// Frequencies of every degree of freedom at one rotor speed.
#[wasm_bindgen(unchecked_return_type = "Reply<ModesReport>")]
pub fn modes(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "ModesOptions")] options: &JsValue,
) -> Answer {
    solve(blade, options::settings(options, Analysis::Modes), analysis::modes)
}

/// Fan chart: branches over a range of rotor speeds, crossings, margins at nominal speed.
#[wasm_bindgen(unchecked_return_type = "Reply<FanChart>")]
pub fn fan(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "FanOptions")] options: &JsValue,
) -> Answer {
    solve(blade, options::settings(options, Analysis::Fan), analysis::fan)
}

/// Draws a chart: its SVG text, size and plot areas, and the result that was drawn.
#[wasm_bindgen(unchecked_return_type = "Reply<Drawing<ChartReport>>")]
pub fn chart_svg(
    #[wasm_bindgen(unchecked_param_type = "ChartKind")] kind: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "ChartOptions")] options: &JsValue,
) -> Answer {
    let Some(analysis) = kind.as_string().and_then(|name| Analysis::of_chart(&name)) else {
        let rule = "must be fan, shapes or converge";
        return reply::<()>(Err(Fault::new(FaultCode::UnknownChoice, "kind", kind.as_string(), rule, rule).into()));
    };
    solve(blade, options::settings_and_looks(options, analysis), |blade, (settings, looks)| {
        let looks = looks.chart_options(settings);
        Ok(match analysis {
            #[cfg(feature = "whole")]
            Analysis::Shapes => {
                let report = analysis::shapes(blade, settings)?;
                Drawn::new(draw::shapes(&report, &looks), Report::Shapes(report))
            }
            #[cfg(feature = "whole")]
            Analysis::Converge => {
                let report = analysis::converge(blade, settings)?;
                Drawn::new(draw::converge(&report, &looks), Report::Converge(report))
            }
            _ => {
                let report = analysis::fan(blade, settings)?;
                Drawn::new(draw::fan(&report, &looks), Report::Fan(report))
            }
        })
    })
}

/// A blade with changes, one after the other: what-if, sweeps and sensitivities are made of these.
/// The changed blade is not checked; a blade that cannot be read gives the faults of its reading and
/// its check.
#[wasm_bindgen(unchecked_return_type = "Reply<ChangedBlade>")]
pub fn change_blade(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Change[]")] changes: &JsValue,
) -> Answer {
    let given = read_tree(blade, "blade").and_then(|tree| {
        formats::read_definition(&tree).map_err(|faults| formats::read_tree(&tree).err().unwrap_or(faults))
    });
    // Without a blade the faults of the changes are the same.
    let units = given.as_ref().map(|definition| definition.units).unwrap_or_default();
    let changes = tree::any(changes, "changes").map_err(Faults::from);
    let changes = changes.and_then(|tree| formats::read_changes(&tree, units));
    let changed = Faults::both(given, changes).and_then(|(given, changes)| blade::change(&given, &changes));
    reply(changed.map(|changed| (changed, Vec::new())))
}

/// The branches of a fan chart, as `fan` gave it, at one rotor speed [rad/s] within it: read off between
/// its speeds, nothing is solved. Empty for a chart of fewer than three speeds.
#[wasm_bindgen(unchecked_return_type = "Reply<ModeAtSpeed[]>")]
pub fn at_speed(
    #[wasm_bindgen(unchecked_param_type = "FanChart")] chart: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "number")] speed: &JsValue,
) -> Answer {
    let speed = speed.as_f64().filter(|speed| speed.is_finite() && *speed >= 0.0);
    let speed = speed.ok_or_else(|| tree::fault("speed", "must be a number of at least 0").into());
    reply(Faults::both(chart::curves(chart), speed).map(|(chart, speed)| {
        let branches = chart.branches.iter().map(|(label, frequencies)| (*label, frequencies.as_slice()));
        (analysis::at_speed(&chart.speeds, branches, speed), Vec::new())
    }))
}

/// Version of this program.
#[wasm_bindgen]
pub fn version() -> String {
    VERSION.into()
}

/// Solves with a blade and settings that may both be faulty: all faults at once.
fn solve<S, R: Serialize>(
    blade: &JsValue,
    settings: Result<S, Faults>,
    solve: impl FnOnce(&Blade, &S) -> Result<R, Faults>,
) -> Answer {
    with(blade, settings, |file, settings| solve(&file.blade, settings))
}

/// The same with the blade as given and as checked.
fn with<S, R: Serialize>(
    blade: &JsValue,
    settings: Result<S, Faults>,
    answer: impl FnOnce(&BladeFile, &S) -> Result<R, Faults>,
) -> Answer {
    reply(Faults::both(read_blade(blade), settings).and_then(|(file, settings)| {
        let result = answer(&file, &settings)?;
        Ok((result, analysis::warnings(&file.blade)))
    }))
}

fn read_tree(value: &JsValue, name: &str) -> Result<Tree, Faults> {
    Ok(tree::tree(value, name)?)
}

// Not into every export that takes a blade.
#[inline(never)]
fn read_blade(blade: &JsValue) -> Result<Box<BladeFile>, Faults> {
    read_tree(blade, "blade").and_then(|tree| formats::read_tree(&tree)).map(Box::new)
}
