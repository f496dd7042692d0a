//! Convergence: frequency, and below it the error, over the number of assumed functions.

use super::key::{Entry, Foot, Head, draw_background};
use super::line::{Area, clip};
use super::palette::{Style, dashes};
use super::panel::{self, EndLabel, Panel};
use super::scale::Scale;
use super::sheet::{Anchor, Face, Point, Sheet, dash_array};
use super::{ChartOptions, Drawing, FrequencyUnit, text};
use crate::analysis::{ConvergeReport, ConvergeSeries};
use crate::dof::Dof;
use crate::numerics::scalar::{ceil, round};
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// What the paper calls converged.
const PAPER_FUNCTIONS: f64 = 15.0;
/// Frequencies further apart than this ratio are drawn on a logarithmic axis.
const WIDE: f64 = 12.0;
/// Errors below are not told from rounding, nor from zero.
const LEAST_ERROR: f64 = 1e-16;

/// Points of one series.
#[derive(Clone, Debug)]
struct Trace<'a> {
    series: &'a ConvergeSeries,
    frequency: Vec<(f64, f64)>,
    error: Vec<(f64, f64)>,
}

/// Draws frequency and error over the number of assumed functions.
pub fn converge(report: &ConvergeReport, options: &ChartOptions) -> Drawing {
    let style = Style::of(options.theme, options.width);
    let name = text::clean(&report.blade);
    let unit = options.frequency_unit;
    // Against the converged frequency only where every series has one: one axis, one meaning.
    let known = report.series.iter().all(|series| series.converged_rad_s.is_some()) && !report.series.is_empty();
    let traces: Vec<Trace> = report.series.iter().map(|series| trace(report, series, known, unit)).collect();
    let most = report.functions.iter().copied().max().unwrap_or(1);
    let error_name = if known { "relative error".to_string() } else { format!("change against N = {most}") };

    let frequencies = frequency_scale(&traces, unit);
    let errors = error_scale(&traces);
    let room = panel::y_tick_room(&style, &frequencies, [0.25, 0.36]);
    let room = room.max(panel::y_tick_room(&style, &errors, [0.2, 0.3]));
    let left = 0.7 * style.margin() + panel::name_beside(&style) + room;
    let longest = report.series.iter().map(|series| text::width(&text::clean(&series.label), style.tick(), true));
    let right = style.width - 0.6 * style.margin() - panel::leader_length(&style) - longest.fold(0.0, f64::max);
    let entries = Dof::ALL.into_iter().filter(|dof| report.series.iter().any(|series| series.dof == *dof));
    let head = Head::new(&style, &name, entries.map(Entry::dof).collect(), left);
    let top = head.height(&style) + 2.0 * style.small();
    let width = right - left;
    let upper = Area { left, top, right, bottom: top + 0.36 * width };
    let middle = upper.bottom + 1.5 * style.label();
    let lower = Area { left, top: middle, right, bottom: middle + 0.3 * width };
    let panels = [
        Panel::new(&style, upper, function_scale(report), frequencies),
        Panel::new(&style, lower, function_scale(report), errors),
    ];
    let panels = panels.map(whole_ticks);

    let speed = text::significant(report.speed_rad_s / options.speed_unit.si(), 4);
    let speed = format!("at {speed} {}", options.speed_unit.name());
    let notes = alloc::vec![speed.clone(), "classical functions".to_string()];
    let foot = Foot::new(&style, notes, &remarks(&traces, &panels), left);
    let below = lower.bottom + panel::ticks_below(&style) + panel::name_below(&style) + 0.5 * style.small();
    let mut sheet = Sheet::new(style.width, ceil(below + foot.height(&style)));

    draw_background(&mut sheet, &style);
    head.draw(&mut sheet, &style, left);
    panels[0].draw_grid(&mut sheet, &style);
    panels[1].draw_grid(&mut sheet, &style);
    draw_paper_mark(&mut sheet, &style, &panels);
    draw_traces(&mut sheet, &style, &panels[0], &traces, |trace| &trace.frequency, false);
    draw_traces(&mut sheet, &style, &panels[1], &traces, |trace| &trace.error, true);
    panels[0].draw_axes(&mut sheet, &style, "", &format!("frequency [{}]", unit.name()));
    panels[1].draw_axes(&mut sheet, &style, "number of functions N", &error_name);
    foot.draw(&mut sheet, &style, left, below);

    let (width, height) = (sheet.width, sheet.height);
    let about = format!(
        "Frequencies of {} modes over 1 to {most} assumed functions, and their {error_name}, {speed}.",
        traces.len()
    );
    let svg = sheet.finish(&format!("{name}: convergence"), &about);
    Drawing { svg, width, height, plots: alloc::vec![panels[0].describe("frequency"), panels[1].describe("error")] }
}

fn trace<'a>(report: &ConvergeReport, series: &'a ConvergeSeries, known: bool, unit: FrequencyUnit) -> Trace<'a> {
    let points: Vec<(f64, f64)> = report
        .functions
        .iter()
        .zip(&series.classical_rad_s)
        .filter_map(|(&count, &frequency)| Some((count as f64, frequency.filter(|value| value.is_finite())?)))
        .collect();
    let reference = if known { series.converged_rad_s } else { points.last().map(|point| point.1) };
    let last = points.last().map_or(0.0, |point| point.0);
    let error = points
        .iter()
        // The last is the reference itself.
        .filter(|point| known || point.0 < last)
        .filter_map(|&(count, frequency)| {
            let reference = reference.filter(|reference| *reference > 0.0)?;
            Some((count, (frequency / reference - 1.0).abs()))
        })
        .filter(|point| point.1.is_finite())
        .collect();
    let frequency = points.into_iter().map(|(count, frequency)| (count, unit.of(frequency))).collect();
    Trace { series, frequency, error }
}

fn function_scale(report: &ConvergeReport) -> Scale {
    let first = report.functions.iter().copied().min().unwrap_or(1) as f64;
    let last = report.functions.iter().copied().max().unwrap_or(1) as f64;
    Scale::linear(first - 0.3, f64::max(last, first + 1.0) + 0.3, "")
}

fn frequency_scale(traces: &[Trace], unit: FrequencyUnit) -> Scale {
    let values = traces.iter().flat_map(|trace| &trace.frequency).map(|point| point.1);
    let largest = values.clone().fold(0.0, f64::max);
    let least = values.filter(|value| *value > 0.0).reduce(f64::min).unwrap_or(largest);
    if largest > WIDE * least && least > 0.0 {
        Scale::log(least / 1.4, largest * 1.4, unit.name())
    } else {
        Scale::linear(0.0, if largest > 0.0 { 1.08 * largest } else { 1.0 }, unit.name())
    }
}

/// A little more than all errors, and a decade at least.
fn error_scale(traces: &[Trace]) -> Scale {
    let values = traces.iter().flat_map(|trace| &trace.error).map(|point| point.1).filter(|value| *value > 0.0);
    let least = values.clone().reduce(f64::min).unwrap_or(1e-6).max(LEAST_ERROR);
    let largest = values.reduce(f64::max).unwrap_or(1.0).max(8.0 * least);
    Scale::log(least / 1.6, largest * 1.6, "")
}

/// Without ticks between whole numbers of functions.
fn whole_ticks(mut panel: Panel) -> Panel {
    panel.x_ticks.retain(|tick| (tick.value - round(tick.value)).abs() < 1e-9);
    for tick in &mut panel.x_ticks {
        tick.text = format!("{:.0}", tick.value);
    }
    panel
}

/// Draws one value of all series; what a logarithmic axis cannot show is left out or, as an error
/// of zero is smaller than any other, stands at its foot.
fn draw_traces<'t, 'a: 't>(
    sheet: &mut Sheet,
    style: &Style,
    panel: &Panel,
    traces: &'t [Trace<'a>],
    of: impl Fn(&'t Trace<'a>) -> &'t Vec<(f64, f64)>,
    zero_at_foot: bool,
) {
    let mut ends: Vec<EndLabel> = Vec::new();
    for trace in traces {
        let series = trace.series;
        let colour = style.palette.dof(series.dof);
        let bottom = panel.area.bottom;
        let points: Vec<Point> = of(trace)
            .iter()
            .filter_map(|&(count, value)| {
                let foot = panel.x.at(count).filter(|_| zero_at_foot).map(|x| (x, bottom));
                panel.point(count, value).or(foot)
            })
            .map(|(x, y)| (x, y.min(bottom)))
            .collect();
        let (class, label) = (format!("series {}", series.dof), text::clean(&series.label));
        let dash = dash_array(dashes(series.dof), style.unit);
        let attributes = [("class", class.as_str()), ("data-label", &label), ("stroke-dasharray", &dash)];
        sheet.layer(&attributes, |pen| {
            for part in clip(&points, &panel.area) {
                pen.line(&part, colour, 1.5 * style.unit);
            }
            for &point in points.iter().filter(|point| panel.area.holds_point(**point)) {
                pen.disc(point, 1.9 * style.unit, colour);
            }
        });
        if let Some(&(from, target)) = points.last() {
            ends.push(EndLabel {
                text: label,
                from,
                target,
                colour,
                bold: true,
                rank: if series.number == 1 { 90 } else { 60 },
                limit: f64::INFINITY,
                class: "series-label",
            });
        }
    }
    panel::draw_end_labels(sheet, style, &panel.area, &ends);
}

/// A line through both panels at the paper's number of functions.
fn draw_paper_mark(sheet: &mut Sheet, style: &Style, panels: &[Panel; 2]) {
    let axis = &panels[0].x.axis;
    if !(axis.from..=axis.to).contains(&PAPER_FUNCTIONS) {
        return;
    }
    let Some(x) = panels[0].x.at(PAPER_FUNCTIONS) else { return };
    let palette = &style.palette;
    let dash = dash_array(&[2.0, 3.0], style.unit);
    sheet.layer(&[("class", "paper"), ("stroke-dasharray", &dash)], |pen| {
        for panel in panels {
            pen.line(&[(x, panel.area.top), (x, panel.area.bottom)], palette.nominal, 1.0 * style.unit);
        }
    });
    let name = "N = 15, as in the paper";
    let half = 0.5 * text::width(name, style.small(), false);
    let middle = x.min(style.width - 0.5 * style.margin() - half).max(panels[0].area.left + half);
    let face = Face::new(style.small(), palette.nominal, Anchor::Middle);
    let baseline = panels[0].area.top - 5.0 * style.unit;
    sheet.layer(&[("class", "paper")], |pen| pen.text((middle, baseline), name, &face));
}

/// Modes that a logarithmic axis cannot show.
fn remarks(traces: &[Trace], panels: &[Panel; 2]) -> Vec<String> {
    let zero = |trace: &&Trace| panels[0].y.axis.log && trace.frequency.iter().all(|point| point.1 <= 0.0);
    let zero = traces.iter().filter(zero).filter(|trace| !trace.frequency.is_empty());
    let labels: Vec<String> = zero.map(|trace| text::clean(&trace.series.label)).collect();
    if labels.is_empty() { Vec::new() } else { alloc::vec![format!("{}: frequency 0", labels.join(", "))] }
}
