//! Drawings with the results behind them.

use crate::options::{self, Analysis};
use crate::reply::reply;
use crate::{Answer, solve_in};
use bladefan_core::chart::{self, Drawing, PlotArea};
use bladefan_core::report::{ConvergeReport, CoupledShapesReport, FanChart, ShapesReport};
use bladefan_core::{Fault, FaultCode, ModelKind, Settings};
use serde::Serialize;
use wasm_bindgen::prelude::*;

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
    Shapes(ShapesReport),
    CoupledShapes(CoupledShapesReport),
    Converge(ConvergeReport),
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
    let given = options::settings_and_looks(options, analysis);
    solve_in(
        |(settings, _): &(Settings, _), blade| settings.model_for(blade),
        blade,
        given,
        |blade, (settings, looks)| {
            let looks = looks.chart_options(settings);
            Ok(match analysis {
                Analysis::Shapes if settings.model_for(blade) == ModelKind::Coupled => {
                    let report = bladefan_core::coupled_shapes(blade, settings)?;
                    Drawn::new(chart::coupled_shapes(&report, &looks), Report::CoupledShapes(report))
                }
                Analysis::Shapes => {
                    let report = bladefan_core::shapes(blade, settings)?;
                    Drawn::new(chart::shapes(&report, &looks), Report::Shapes(report))
                }
                Analysis::Converge => {
                    let report = bladefan_core::converge(blade, settings)?;
                    Drawn::new(chart::converge(&report, &looks), Report::Converge(report))
                }
                _ => {
                    let report = bladefan_core::fan(blade, settings)?;
                    Drawn::new(chart::fan(&report, &looks), Report::Fan(report))
                }
            })
        },
    )
}
