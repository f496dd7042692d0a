//! Convergence: frequency over the converged one, and below it the error, over the number of assumed
//! functions.

use super::key::{Entry, Foot, Head, Sign, draw_background, draw_piecewise_point};
use super::line::{Area, clip};
use super::palette::{FAMILY_DASHES, Style};
use super::panel::{self, EndLabel, Panel};
use super::scale::Scale;
use super::sheet::{Anchor, Face, Point, Sheet, dash_array};
use super::{ChartOptions, Drawing, FrequencyUnit, text};
use crate::analysis::PAPER_FUNCTIONS;
use crate::dof::Dof;
use crate::figures::short_in_drawing;
use crate::functions::BasisFamily;
use crate::numerics::scalar::round;
use crate::report::{ConvergeReport, ConvergeSeries};
use crate::units::percent;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// Smaller errors [%] are not told from rounding, nor from zero.
const LEAST_ERROR: f64 = 1e-10;
/// The frequency panel ends here, so that the few percent that the paper's functions leave show; what is
/// further off is read in the error panel.
const MOST_RATIO: f64 = 1.2;
/// Most functions that stand side by side on a linear axis.
const MOST_LINEAR: f64 = 40.0;
/// Least heights [px] of both panels where no height is asked for: on a narrow drawing the share of
/// its width would press curves together.
const LEAST_HEIGHTS: [f64; 2] = [200.0, 300.0];
/// Name of the error axis.
const ERROR: &str = "error against the converged frequency [%]";

/// One mode with one family of functions: number of functions, and frequency over the converged one.
#[derive(Clone, Debug)]
struct Trace<'a> {
    series: &'a ConvergeSeries,
    family: BasisFamily,
    ratio: Vec<(f64, f64)>,
}

impl Trace<'_> {
    fn error(&self) -> Vec<(f64, f64)> {
        let error = |ratio: f64| percent(ratio, 1.0).map_or(LEAST_ERROR, |percent| percent.abs().max(LEAST_ERROR));
        self.ratio.iter().map(|&(count, ratio)| (count, error(ratio))).collect()
    }
}

/// Draws frequency and error over the number of assumed functions.
pub fn converge(report: &ConvergeReport, options: &ChartOptions) -> Drawing {
    let style = Style::of(options.theme, options.width);
    let name = text::clean(&report.blade);
    // At rest there is no frequency per revolution.
    let unit = match options.frequency_unit {
        FrequencyUnit::PerRev if report.speed_rad_s <= 0.0 => FrequencyUnit::RadS,
        unit => unit,
    };
    // Classical lines above: they are what the reader looks for.
    let traces: Vec<Trace> = [BasisFamily::Piecewise, BasisFamily::Classical]
        .into_iter()
        .flat_map(|family| report.series.iter().map(move |series| trace(report, series, family)))
        .collect();
    let list: Vec<(String, Dof)> =
        report.series.iter().map(|series| listed(series, unit, report.speed_rad_s)).collect();

    let (functions, ratios, errors) = (function_scale(report, &traces), ratio_scale(&traces), error_scale(&traces));
    let held = options.held_height(style.width);
    let shares = held.map(|height| [0.1, 0.56 * height / style.width]);
    let room = panel::y_tick_room(&style, &ratios, shares.unwrap_or([0.2, 0.4]));
    let room = room.max(panel::y_tick_room(&style, &errors, shares.unwrap_or([0.28, 0.6])));
    let left = 0.7 * style.margin() + panel::name_beside(&style) + room;
    let longest = list.iter().map(|(text, _)| text::width(text, style.tick(), true));
    let longest = longest.fold(text::width(&list_head(unit), style.small(), false), f64::max);
    let right = style.width - 0.6 * style.margin() - panel::leader_length(&style) - longest;
    let entries = Dof::ALL.into_iter().filter(|dof| report.series.iter().any(|series| series.dof == *dof));
    let entries = entries.map(|dof| Entry::new(Sign::Colour(dof), dof.name()));
    let families = [BasisFamily::Classical, BasisFamily::Piecewise];
    let families = families.map(|family| Entry::new(Sign::Family(family), format!("{} functions", family.name())));
    let head = Head::new(&style, &name, entries.chain(families).collect(), left);
    let top = head.height(&style) + 2.0 * style.small();
    let width = right - left;
    let speed = short_in_drawing(report.speed_rad_s / options.speed_unit.si(), 4);
    let speed = format!("at {speed} {}", options.speed_unit.name());
    let foot = Foot::new(&style, alloc::vec![speed.clone()], &report.model.words, &remarks(report, &traces), left);
    let between = 1.5 * style.label();
    let under = panel::ticks_below(&style) + panel::name_below(&style) + 0.5 * style.small();
    let heights = match held {
        None => [(0.3 * width).max(LEAST_HEIGHTS[0]), (0.38 * width).max(LEAST_HEIGHTS[1])],
        Some(height) => {
            let room = height - top - between - under - foot.height(&style);
            [0.44, 0.56].map(|share| (share * room).max(panel::least_height(&style)))
        }
    };
    let upper = Area { left, top, right, bottom: top + heights[0] };
    let middle = upper.bottom + between;
    let lower = Area { left, top: middle, right, bottom: middle + heights[1] };
    let panels = [Panel::new(&style, upper, functions.clone(), ratios), Panel::new(&style, lower, functions, errors)];
    let panels = panels.map(|panel| whole_ticks(&style, panel));

    let below = lower.bottom + under;
    let mut sheet = Sheet::new(style.width, panel::whole(below + foot.height(&style)));

    draw_background(&mut sheet, &style);
    head.draw(&mut sheet, &style, left);
    panels[0].draw_grid(&mut sheet, &style);
    panels[1].draw_grid(&mut sheet, &style);
    draw_paper_mark(&mut sheet, &style, &panels);
    draw_level(&mut sheet, &style, &panels[0]);
    for trace in &traces {
        draw_trace(&mut sheet, &style, &panels[0], trace, &trace.ratio);
    }
    for trace in &traces {
        draw_trace(&mut sheet, &style, &panels[1], trace, &trace.error());
    }
    draw_error_labels(&mut sheet, &style, &panels[1], &traces);
    draw_list(&mut sheet, &style, &upper, &list, unit);
    panels[0].draw_axes(&mut sheet, &style, "", "frequency / converged");
    panels[1].draw_axes(&mut sheet, &style, "number of functions N", "error [%]");
    foot.draw(&mut sheet, &style, left, below);

    let (width, height) = (sheet.width, sheet.height);
    let about = format!(
        "Frequencies of {} modes over the number of assumed functions, as shares of the converged \
         frequency, and their {ERROR}, {speed}.",
        report.series.len()
    );
    let svg = sheet.finish(&format!("{name}: convergence"), &about);
    Drawing { svg, width, height, plots: alloc::vec![panels[0].describe("frequency"), panels[1].describe("error")] }
}

fn trace<'a>(report: &ConvergeReport, series: &'a ConvergeSeries, family: BasisFamily) -> Trace<'a> {
    let (functions, values) = match family {
        BasisFamily::Classical => (&report.functions, &series.classical_rad_s),
        BasisFamily::Piecewise => (&series.piecewise_functions, &series.piecewise_rad_s),
    };
    let converged = series.converged_rad_s.filter(|converged| *converged > 0.0);
    let ratio = functions
        .iter()
        .zip(values)
        .filter_map(|(&count, &value)| Some((count as f64, value? / converged?)))
        .filter(|point| point.1.is_finite())
        .collect();
    Trace { series, family, ratio }
}

/// Logarithmic where there are many, or where one family needs more than the other was given.
fn function_scale(report: &ConvergeReport, traces: &[Trace]) -> Scale {
    let first = report.functions.iter().copied().min().unwrap_or(1) as f64;
    let classical = report.functions.iter().copied().max().unwrap_or(1) as f64;
    let last = traces.iter().flat_map(|trace| &trace.ratio).map(|point| point.0).fold(classical, f64::max);
    if last > classical.min(MOST_LINEAR) {
        Scale::log(0.92 * first, 1.08 * last, "")
    } else {
        Scale::linear(first - 0.3, f64::max(last, first + 1.0) + 0.3, "")
    }
}

fn ratio_scale(traces: &[Trace]) -> Scale {
    let values = || traces.iter().flat_map(|trace| &trace.ratio).map(|point| point.1);
    let largest = values().fold(1.0, f64::max).min(MOST_RATIO);
    let least = values().fold(1.0, f64::min).max(0.0);
    let span = (largest - least).max(1e-3);
    Scale::linear(least - 0.06 * span, largest.max(least + span) + 0.06 * span, "")
}

/// A little more than all errors, and a decade at least.
fn error_scale(traces: &[Trace]) -> Scale {
    let values = || traces.iter().flat_map(Trace::error).map(|point| point.1);
    let least = values().reduce(f64::min).unwrap_or(1e-4);
    let largest = values().reduce(f64::max).unwrap_or(100.0).max(8.0 * least);
    Scale::log(least / 1.6, largest * 1.6, "%")
}

/// Without ticks between whole numbers of functions.
fn whole_ticks(style: &Style, mut panel: Panel) -> Panel {
    if panel.x.axis.log {
        // Small numbers: their texts may stand close.
        panel.x_ticks = panel.x.ticks((panel.area.right - panel.area.left) / (40.0 * style.unit));
    }
    panel.x_ticks.retain(|tick| (tick.value - round(tick.value)).abs() < 1e-9);
    for tick in &mut panel.x_ticks {
        tick.text = format!("{:.0}", tick.value);
        tick.exponent = None;
    }
    panel
}

fn draw_trace(sheet: &mut Sheet, style: &Style, panel: &Panel, trace: &Trace, values: &[(f64, f64)]) {
    let colour = style.palette.dof(trace.series.dof);
    let points: Vec<Point> = values.iter().filter_map(|&(count, value)| panel.point(count, value)).collect();
    let (class, label) = (format!("series {}", trace.series.dof), trace.series.label.to_string());
    let piecewise = trace.family == BasisFamily::Piecewise;
    let dash = if piecewise { dash_array(&FAMILY_DASHES, style.unit) } else { String::new() };
    let attributes = [("class", class.as_str()), ("data-label", &label), ("data-family", trace.family.name())];
    let line = [&attributes[..], &[("stroke-dasharray", dash.as_str())]].concat();
    sheet.layer(&line, &|pen| {
        for part in clip(&points, &panel.area) {
            pen.line(&part, colour, if piecewise { 1.1 } else { 1.5 } * style.unit);
        }
    });
    sheet.layer(&attributes, &|pen| {
        for &point in points.iter().filter(|point| panel.area.holds_point(**point)) {
            if piecewise {
                draw_piecewise_point(pen, style, point, colour);
            } else {
                pen.disc(point, 1.9 * style.unit, colour);
            }
        }
    });
}

/// A thin line at the converged frequency.
fn draw_level(sheet: &mut Sheet, style: &Style, panel: &Panel) {
    let Some(y) = panel.y.at(1.0) else { return };
    sheet.layer(&[("class", "converged")], &|pen| {
        pen.line(&[(panel.area.left, y), (panel.area.right, y)], style.palette.frame, 0.8);
    });
}

/// Every mode's label at the height of its last classical error.
fn draw_error_labels(sheet: &mut Sheet, style: &Style, panel: &Panel, traces: &[Trace]) {
    let mut ends: Vec<EndLabel> = Vec::new();
    for trace in traces.iter().filter(|trace| trace.family == BasisFamily::Classical) {
        let Some((from, target)) = trace.error().last().and_then(|&(count, error)| panel.point(count, error)) else {
            continue;
        };
        let colour = style.palette.dof(trace.series.dof);
        let target = target.min(panel.area.bottom);
        // Where piecewise functions go on to the right, a pale line leads from the curve to its label.
        sheet.layer(&[("class", "leader")], &|pen| {
            pen.line(&[(from, target), (panel.area.right, target)], style.palette.tone(colour, 0.35), 0.7 * style.unit);
        });
        ends.push(EndLabel {
            text: trace.series.label.to_string(),
            from: panel.area.right,
            target,
            colour,
            bold: true,
            rank: if trace.series.number == 1 { 90 } else { 60 },
            limit: f64::INFINITY,
            class: "series-label",
        });
    }
    panel::draw_end_labels(sheet, style, &panel.area, &ends);
}

fn list_head(unit: FrequencyUnit) -> String {
    format!("converged [{}]", unit.symbol())
}

/// `2F 185.9`: the mode and its converged frequency.
fn listed(series: &ConvergeSeries, unit: FrequencyUnit, speed: f64) -> (String, Dof) {
    let label = series.label.to_string();
    let value = series.converged_rad_s.and_then(|value| unit.of(value, speed));
    let text = match value.filter(|value| value.is_finite()) {
        Some(value) => format!("{label} {}", short_in_drawing(value, 4)),
        None => label,
    };
    (text, series.dof)
}

/// The converged frequencies beside the panel that shows shares of them; as many as there is room for.
fn draw_list(sheet: &mut Sheet, style: &Style, area: &Area, list: &[(String, Dof)], unit: FrequencyUnit) {
    if list.is_empty() {
        return;
    }
    let x = area.right + 0.5 * panel::leader_length(style);
    let line = 1.15 * style.tick();
    let first = area.top + 0.5 * style.small();
    let rows = ((area.bottom + style.small() - first) / line).max(1.0) as usize;
    let head = Face::new(style.small(), style.palette.muted, Anchor::Start);
    sheet.layer(&[("class", "converged")], &|pen| {
        pen.text((x, first + head.drop()), &list_head(unit), &head);
        for (row, (label, dof)) in list.iter().enumerate().take(rows.saturating_sub(1)) {
            let face = Face::new(style.tick(), style.palette.dof(*dof), Anchor::Start);
            pen.text((x, first + (row as f64 + 1.0) * line + face.drop()), label, &face);
        }
    });
}

/// A line through both panels at the paper's number of functions.
fn draw_paper_mark(sheet: &mut Sheet, style: &Style, panels: &[Panel; 2]) {
    let axis = &panels[0].x.axis;
    let functions = PAPER_FUNCTIONS as f64;
    if !(axis.from..=axis.to).contains(&functions) {
        return;
    }
    let Some(x) = panels[0].x.at(functions) else { return };
    let palette = &style.palette;
    let dash = dash_array(&[2.0, 3.0], style.unit);
    sheet.layer(&[("class", "paper"), ("stroke-dasharray", &dash)], &|pen| {
        for panel in panels {
            pen.line(&[(x, panel.area.top), (x, panel.area.bottom)], palette.nominal, 1.0 * style.unit);
        }
    });
    let name = format!("N = {PAPER_FUNCTIONS}, as in the paper");
    let half = 0.5 * text::width(&name, style.small(), false);
    let middle = x.min(style.width - 0.5 * style.margin() - half).max(panels[0].area.left + half);
    let face = Face::new(style.small(), palette.nominal, Anchor::Middle);
    let baseline = panels[0].area.top - 5.0 * style.unit;
    sheet.layer(&[("class", "paper")], &|pen| pen.text((middle, baseline), &name, &face));
}

/// What the drawing cannot show.
fn remarks(report: &ConvergeReport, traces: &[Trace]) -> Vec<String> {
    let labels = |without: fn(&ConvergeSeries) -> bool| {
        let labels = report.series.iter().filter(|series| without(series)).map(|series| series.label.to_string());
        Some(labels.collect::<Vec<String>>().join(", ")).filter(|labels| !labels.is_empty())
    };
    let zero = labels(|series| series.converged_rad_s == Some(0.0)).map(|labels| format!("{labels}: frequency 0"));
    let unknown = labels(|series| series.converged_rad_s.is_none());
    let unknown = unknown.map(|labels| format!("{labels}: no converged frequency"));
    let clipped = traces.iter().flat_map(Trace::error).any(|(_, error)| error <= LEAST_ERROR);
    let clipped = clipped.then(|| "errors below 1e-10 % are shown as 1e-10 %".to_string());
    [zero, unknown, clipped].into_iter().flatten().collect()
}
