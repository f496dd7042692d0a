//! The fan chart (Southwell, Campbell diagram): natural frequencies over rotor speed, with the
//! per-rev rays they may meet.

mod branches;
mod crossings;
mod measured;
mod range;
mod rays;
#[cfg(test)]
mod tests;
mod units;
mod veerings;

use super::key::{Entry, Foot, Head, Sign, basis_text, draw_background, list_labels};
use super::labels::Obstacles;
use super::line::Area;
use super::palette::Style;
use super::panel::{self, Panel};
use super::scale::Scale;
use super::sheet::{Anchor, Face, Point, Sheet};
use super::{ChartOptions, Drawing, text};
use crate::dof::Dof;
use crate::figures::short_in_drawing;
use crate::label::Label;
use crate::report::FanChart;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use branches::{Curve, End};
use measured::Measured;
use range::Range;
use units::Units;

/// Height of the frame over its width, where no height is asked for.
const RATIO: f64 = 0.625;

/// Draws a fan chart.
pub fn fan(chart: &FanChart, options: &ChartOptions) -> Drawing {
    let style = Style::of(options.theme, options.width);
    let units = Units { speed: options.speed_unit, frequency: options.frequency_unit };
    let range = Range::of(chart, options, units);
    let x = Scale::linear(units.speed(range.from_speed), units.speed(range.to_speed), units.speed.name());
    let y = Scale::linear(range.bottom, range.top, units.frequency.symbol());
    let name = text::clean(&chart.blade);

    // From the outside in: what stands beside the frame gives its width, the width its height.
    let held = options.held_height(style.width);
    let shares = held.map_or([0.45, 0.62], |height| panel::shares_of(height / style.width));
    let left = 0.7 * style.margin() + panel::name_beside(&style) + panel::y_tick_room(&style, &y, shares);
    let longest = chart.branches.iter().map(|branch| text::width(&branch.label.to_string(), style.tick(), true));
    let rays_room = text::width("100P", style.small(), false);
    let right = style.width - 0.6 * style.margin() - panel::leader_length(&style) - longest.fold(rays_room, f64::max);
    let head = Head::new(&style, &name, entries(chart, options, &range, units), left);
    let above = if range.open { rays::TOP_GAP * style.unit + 1.25 * style.small() } else { 6.0 * style.unit };
    let top = head.height(&style) + above + 1.5 * style.small();
    let lay_out = |height: f64| {
        let area = Area { left, top, right, bottom: top + height };
        let panel = Panel::new(&style, area, x.clone(), y.clone());
        let curves: Vec<Curve> =
            chart.branches.iter().map(|branch| branches::lay_out(branch, chart, &panel, units)).collect();
        let measured = Measured::of(options.measured, chart, &panel, units, &style);
        (panel, curves, measured)
    };
    let usual = RATIO * (right - left);
    let (mut panel, mut curves, mut measured) = lay_out(usual);
    let remarks = remarks(chart, &curves, &measured, &range, units);
    let foot = Foot::new(&style, alloc::vec![basis_text(&chart.basis)], &chart.model.words, &remarks, left);
    let under = panel::ticks_below(&style) + panel::name_below(&style) + 0.5 * style.small();
    if let Some(height) = held {
        let room = height - top - under - foot.height(&style);
        (panel, curves, measured) = lay_out(room.max(panel::least_height(&style)));
    }
    let area = panel.area;
    let below = area.bottom + under;
    let mut sheet = Sheet::new(style.width, panel::whole(below + foot.height(&style)));

    let rays = rays::rays(chart, &panel, units);
    let marks = crossings::marks(chart, options.band, &panel, units);
    draw_background(&mut sheet, &style);
    draw_band(&mut sheet, &style, chart, options.band, &panel, units);
    panel.draw_grid(&mut sheet, &style);
    rays::draw(&mut sheet, &style, &rays);
    let nominal = draw_nominal(&mut sheet, &style, chart, &panel, units, area.top - above);
    for curve in &curves {
        branches::draw(&mut sheet, &style, curve);
    }
    measured.draw(&mut sheet, &style);
    panel.draw_axes(
        &mut sheet,
        &style,
        &format!("rotor speed [{}]", units.speed.name()),
        &format!("frequency [{}]", units.frequency.symbol()),
    );
    let mut obstacles = Obstacles { boxes: measured.boxes(&style).collect(), ..Obstacles::within(area) };
    obstacles.lines.extend(curves.iter().flat_map(|curve| &curve.parts).map(|part| (part.clone(), 3.0)));
    obstacles.lines.extend(rays.iter().map(|ray| (ray.ends.to_vec(), 1.0)));
    obstacles.lines.extend(nominal.map(|line| (line.to_vec(), 2.0)));
    crossings::draw(&mut sheet, &style, &marks, &mut obstacles);

    let (mut ends, mut tops, mut inside) = (rays::end_labels(&style, &area, &rays), Vec::new(), Vec::new());
    for curve in &curves {
        match branches::end_of(curve, &style, &area) {
            Some(End::Right(label)) => ends.push(label),
            Some(End::Top(at, label)) => tops.push((at, label)),
            Some(End::Inside(at, label)) => inside.push((at, label)),
            None => {}
        }
    }
    veerings::draw(&mut sheet, &style, chart, &panel, units);
    branches::draw_inside(&mut sheet, &style, &inside, &mut obstacles);
    panel::draw_end_labels(&mut sheet, &style, &area, &ends);
    rays::draw_top_labels(&mut sheet, &style, &area, &rays, &tops);
    head.draw(&mut sheet, &style, left);
    foot.draw(&mut sheet, &style, left, below);

    let (width, height) = (sheet.width, sheet.height);
    let svg = sheet.finish(&format!("{name}: fan chart"), &description(chart, options));
    Drawing { svg, width, height, plots: alloc::vec![panel.describe("fan")] }
}

fn entries(chart: &FanChart, options: &ChartOptions, range: &Range, units: Units) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Dof::ALL
        .into_iter()
        .filter(|dof| chart.branches.iter().any(|branch| branch.leads(*dof)))
        .map(Entry::dof)
        .collect();
    if let Some(blades) = chart.blades.filter(|&blades| blades > 0 && blades <= chart.harmonics) {
        entries.push(Entry::new(Sign::BladeRay, format!("multiples of {blades}P")));
    }
    if range.meets(chart.nominal.speed_rad_s, options.band) {
        let (from, to) = (short_in_drawing(options.band.0, 4), short_in_drawing(options.band.1, 4));
        entries.push(Entry::new(Sign::Band, format!("{from} to {to} of nominal speed")));
    }
    let crossings = chart.crossings_in(options.band).filter(|crossing| range.holds(crossing, units)).count();
    if crossings > 0 {
        let plural = if crossings == 1 { "" } else { "s" };
        entries.push(Entry::new(Sign::Crossing, format!("{crossings} crossing{plural} in this band")));
    }
    if chart.veerings.iter().any(|veering| veering.kind == "veering") {
        entries.push(Entry::new(Sign::Veering, "veering".to_string()));
    }
    entries.extend(measured::entries(options.measured));
    entries
}

fn draw_band(sheet: &mut Sheet, style: &Style, chart: &FanChart, band: (f64, f64), panel: &Panel, units: Units) {
    let Area { left, top, right, bottom } = panel.area;
    let edge = |ratio: f64| panel.x.at(units.speed(ratio * chart.nominal.speed_rad_s)).map(|x| x.clamp(left, right));
    let (Some(from), Some(to)) = (edge(band.0), edge(band.1)) else { return };
    if to - from > 0.1 {
        sheet.layer(&[("class", "band")], &|pen| pen.rectangle((from, top), (to, bottom), style.palette.band));
    }
}

/// Draws the nominal speed and, at `baseline`, its name; returns the line.
fn draw_nominal(
    sheet: &mut Sheet,
    style: &Style,
    chart: &FanChart,
    panel: &Panel,
    units: Units,
    baseline: f64,
) -> Option<[Point; 2]> {
    let area = &panel.area;
    let speed = units.speed(chart.nominal.speed_rad_s);
    let x = panel.x.at(speed).filter(|x| *x >= area.left && *x <= area.right && speed > 0.0)?;
    let line = [(x, area.top), (x, area.bottom)];
    let name = format!("nominal {} {}", short_in_drawing(speed, 4), units.speed.name());
    let half = 0.5 * text::width(&name, style.small(), false);
    let face = Face::new(style.small(), style.palette.nominal, Anchor::Middle);
    let middle = x.max(area.left + half).min(style.width - 0.5 * style.margin() - half);
    sheet.layer(&[("class", "nominal")], &|pen| {
        pen.line(&line, style.palette.nominal, 1.0 * style.unit);
        pen.text((middle, baseline), &name, &face);
    });
    Some(line)
}

/// What a reader would otherwise miss.
fn remarks(chart: &FanChart, curves: &[Curve], measured: &Measured, range: &Range, units: Units) -> Vec<String> {
    let mut remarks = Vec::new();
    for coincidence in &chart.coincident {
        remarks.push(format!("{} lies on {}P", coincidence.label, coincidence.harmonic));
    }
    let under = |curve: &Curve| {
        let mut points = chart.speeds_rad_s.iter().zip(&curve.branch.frequency_rad_s);
        points.all(|(&speed, &frequency)| units.frequency(frequency, speed).is_none_or(|value| value < range.bottom))
    };
    for (place, below) in [("above", false), ("below", true)] {
        let hidden = curves.iter().filter(|curve| curve.parts.is_empty() && under(curve) == below);
        let hidden: Vec<Label> = hidden.map(|curve| curve.branch.label).collect();
        if !hidden.is_empty() {
            remarks.push(format!("{place} the chart: {}", list_labels(&hidden)));
        }
    }
    match measured.outside {
        0 => {}
        1 => remarks.push("1 measured point outside the chart".to_string()),
        count => remarks.push(format!("{count} measured points outside the chart")),
    }
    remarks
}

fn description(chart: &FanChart, options: &ChartOptions) -> String {
    let units = Units { speed: options.speed_unit, frequency: options.frequency_unit };
    let first = chart.speeds_rad_s.first().map_or(0.0, |&speed| units.speed(speed));
    let last = chart.speeds_rad_s.last().map_or(0.0, |&speed| units.speed(speed));
    format!(
        "Natural frequencies of {} modes over rotor speed from {} to {} {}, with the per-rev rays 1P to {}P.",
        chart.branches.len(),
        short_in_drawing(first, 4),
        short_in_drawing(last, 4),
        units.speed.name(),
        chart.harmonics
    )
}
