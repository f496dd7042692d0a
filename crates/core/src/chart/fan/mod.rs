//! The fan chart (Southwell, Campbell diagram): natural frequencies over rotor speed, with the
//! per-rev rays they may meet.

mod crossings;
mod measured;
mod range;
mod rays;

use super::key::{Entry, Foot, Head, Sign, basis_text, draw_background, list_labels};
use super::line::{Area, clip, thin};
use super::palette::{Style, dashes};
use super::panel::{self, EndLabel, Panel};
use super::place::Obstacles;
use super::scale::Scale;
use super::sheet::{Anchor, Face, Point, Sheet, dash_array};
use super::{ChartOptions, Drawing, FrequencyUnit, text};
use crate::analysis::{Branch, FanChart};
use crate::dof::Dof;
use crate::numerics::scalar::ceil;
use crate::units::SpeedUnit;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use measured::Measured;
use range::Range;

/// Units of the axes.
#[derive(Clone, Copy, Debug)]
struct Units {
    speed: SpeedUnit,
    frequency: FrequencyUnit,
}

impl Units {
    fn speed(self, speed: f64) -> f64 {
        speed / self.speed.si()
    }

    fn speed_si(self, speed: f64) -> f64 {
        speed * self.speed.si()
    }

    fn frequency(self, frequency: f64) -> f64 {
        self.frequency.of(frequency)
    }
}

/// A branch laid out: its lines inside the frame.
#[derive(Clone, Debug)]
struct Curve<'a> {
    branch: &'a Branch,
    parts: Vec<Vec<Point>>,
}

/// Draws a fan chart.
pub fn fan(chart: &FanChart, options: &ChartOptions) -> Drawing {
    let style = Style::of(options.theme, options.width);
    let units = Units { speed: options.speed_unit, frequency: options.frequency_unit };
    let range = Range::of(chart, options.measured);
    let x = Scale::linear(units.speed(range.from_speed), units.speed(range.to_speed), units.speed.name());
    let y = Scale::linear(0.0, units.frequency(range.top), units.frequency.name());
    let name = text::clean(&chart.blade);

    // From the outside in: what stands beside the frame gives its width, the width its height.
    let left = 0.7 * style.margin() + panel::name_beside(&style) + panel::y_tick_room(&style, &y, [0.45, 0.62]);
    let longest = chart.branches.iter().map(|branch| text::width(&text::clean(&branch.label), style.tick(), true));
    let rays_room = text::width("100P", style.small(), false);
    let right = style.width - 0.6 * style.margin() - panel::leader_length(&style) - longest.fold(rays_room, f64::max);
    let head = Head::new(&style, &name, entries(chart, options, &range), left);
    let above = if range.open { rays::TOP_GAP * style.unit + 1.25 * style.small() } else { 6.0 * style.unit };
    let top = head.height(&style) + above + 1.5 * style.small();
    let area = Area { left, top, right, bottom: top + 0.625 * (right - left) };
    let panel = Panel::new(&style, area, x, y);

    let curves: Vec<Curve> = chart.branches.iter().map(|branch| lay_out(branch, chart, &panel, units)).collect();
    let measured = Measured::of(options.measured, chart, &panel, units, &style);
    let foot = Foot::new(&style, alloc::vec![basis_text(&chart.basis)], &remarks(chart, &curves, &measured), left);
    let below = area.bottom + panel::ticks_below(&style) + panel::name_below(&style) + 0.5 * style.small();
    let mut sheet = Sheet::new(style.width, ceil(below + foot.height(&style)));

    let rays = rays::rays(chart, &panel, units);
    let marks = crossings::marks(chart, options.band, &panel, units);
    draw_background(&mut sheet, &style);
    draw_band(&mut sheet, &style, chart, options.band, &panel, units);
    panel.draw_grid(&mut sheet, &style);
    rays::draw(&mut sheet, &style, &rays);
    let nominal = draw_nominal(&mut sheet, &style, chart, &panel, units, area.top - above);
    for curve in &curves {
        draw_curve(&mut sheet, &style, curve);
    }
    measured.draw(&mut sheet, &style);
    panel.draw_axes(
        &mut sheet,
        &style,
        &format!("rotor speed [{}]", units.speed.name()),
        &format!("frequency [{}]", units.frequency.name()),
    );
    let mut obstacles = Obstacles { frame: area, boxes: measured.boxes(&style).collect(), lines: Vec::new() };
    obstacles.lines.extend(curves.iter().flat_map(|curve| &curve.parts).map(|part| (part.clone(), 3.0)));
    obstacles.lines.extend(rays.iter().map(|ray| (ray.ends.to_vec(), 1.0)));
    obstacles.lines.extend(nominal.map(|line| (line.to_vec(), 2.0)));
    crossings::draw(&mut sheet, &style, &marks, &mut obstacles);

    let (mut ends, mut tops) = (rays::end_labels(&style, &area, &rays), Vec::new());
    for curve in &curves {
        match label_of(curve, &style, &area) {
            Some((at, label)) if at.0 > area.right - 1.0 => ends.push(label),
            Some((at, label)) => tops.push((at, label)),
            None => {}
        }
    }
    panel::draw_end_labels(&mut sheet, &style, &area, &ends);
    rays::draw_top_labels(&mut sheet, &style, &area, &rays, &tops);
    head.draw(&mut sheet, &style, left);
    foot.draw(&mut sheet, &style, left, below);

    let (width, height) = (sheet.width, sheet.height);
    let svg = sheet.finish(&format!("{name}: fan chart"), &description(chart, options));
    Drawing { svg, width, height, plots: alloc::vec![panel.describe("fan")] }
}

fn entries(chart: &FanChart, options: &ChartOptions, range: &Range) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Dof::ALL
        .into_iter()
        .filter(|dof| chart.branches.iter().any(|branch| branch.dof == *dof))
        .map(Entry::dof)
        .collect();
    if let Some(blades) = chart.blades.filter(|&blades| blades > 0 && blades <= chart.harmonics) {
        entries.push(Entry::new(Sign::BladeRay, format!("multiples of {blades}P")));
    }
    if range.meets(chart.nominal.speed_rad_s, options.band) {
        let (from, to) = (text::significant(options.band.0, 4), text::significant(options.band.1, 4));
        entries.push(Entry::new(Sign::Band, format!("{from} to {to} of nominal speed")));
    }
    let crossings = crossings::in_band(chart, options.band).filter(|crossing| range.holds(crossing)).count();
    if crossings > 0 {
        let plural = if crossings == 1 { "" } else { "s" };
        entries.push(Entry::new(Sign::Crossing, format!("{crossings} crossing{plural} in this band")));
    }
    entries.extend(measured::entries(options.measured));
    entries
}

/// The lines of a branch; where a frequency is not a number, there is a gap.
fn lay_out<'a>(branch: &'a Branch, chart: &FanChart, panel: &Panel, units: Units) -> Curve<'a> {
    let mut parts = Vec::new();
    let mut run: Vec<Point> = Vec::new();
    let mut end = |run: &mut Vec<Point>| {
        parts.extend(clip(&thin(run), &panel.area));
        run.clear();
    };
    for (&speed, &frequency) in chart.speeds_rad_s.iter().zip(&branch.frequency_rad_s) {
        match panel.point(units.speed(speed), units.frequency(frequency)) {
            Some(point) => run.push(point),
            None => end(&mut run),
        }
    }
    end(&mut run);
    Curve { branch, parts }
}

fn draw_curve(sheet: &mut Sheet, style: &Style, curve: &Curve) {
    let branch = curve.branch;
    let dash = dash_array(dashes(branch.dof), style.unit);
    let (class, label) = (format!("branch {}", branch.dof), text::clean(&branch.label));
    let attributes = [("class", class.as_str()), ("data-label", label.as_str()), ("stroke-dasharray", dash.as_str())];
    sheet.layer(&attributes, |pen| {
        for part in &curve.parts {
            pen.line(part, style.palette.dof(branch.dof), 2.0 * style.unit);
        }
    });
}

/// Where a branch ends in the frame, and its label there.
fn label_of(curve: &Curve, style: &Style, area: &Area) -> Option<(Point, EndLabel)> {
    let at = *curve.parts.last()?.last()?;
    // Neither at the right nor at the top: its last speeds have no frequency.
    if at.0 <= area.right - 1.0 && at.1 > area.top + 1.0 {
        return None;
    }
    let number = curve.branch.number;
    let rank = match number {
        1 => 90,
        n if n % 10 == 0 => 80,
        n if n % 5 == 0 => 70,
        _ => 60,
    };
    let label = EndLabel {
        text: text::clean(&curve.branch.label),
        from: at.0,
        target: at.1,
        colour: style.palette.dof(curve.branch.dof),
        bold: true,
        rank,
        limit: f64::INFINITY,
        class: "branch-label",
    };
    Some((at, label))
}

fn draw_band(sheet: &mut Sheet, style: &Style, chart: &FanChart, band: (f64, f64), panel: &Panel, units: Units) {
    let Area { left, top, right, bottom } = panel.area;
    let edge = |ratio: f64| panel.x.at(units.speed(ratio * chart.nominal.speed_rad_s)).map(|x| x.clamp(left, right));
    let (Some(from), Some(to)) = (edge(band.0), edge(band.1)) else { return };
    if to - from > 0.1 {
        sheet.layer(&[("class", "band")], |pen| pen.rectangle((from, top), (to, bottom), style.palette.band));
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
    let name = format!("nominal {} {}", text::significant(speed, 4), units.speed.name());
    let half = 0.5 * text::width(&name, style.small(), false);
    let face = Face::new(style.small(), style.palette.nominal, Anchor::Middle);
    let middle = x.max(area.left + half).min(style.width - 0.5 * style.margin() - half);
    sheet.layer(&[("class", "nominal")], |pen| {
        pen.line(&line, style.palette.nominal, 1.0 * style.unit);
        pen.text((middle, baseline), &name, &face);
    });
    Some(line)
}

/// What a reader would otherwise miss.
fn remarks(chart: &FanChart, curves: &[Curve], measured: &Measured) -> Vec<String> {
    let mut remarks = Vec::new();
    for coincidence in &chart.coincident {
        remarks.push(format!("{} lies on {}P", text::clean(&coincidence.label), coincidence.harmonic));
    }
    let hidden: Vec<(Dof, usize)> = curves
        .iter()
        .filter(|curve| curve.parts.is_empty())
        .map(|curve| (curve.branch.dof, curve.branch.number))
        .collect();
    if !hidden.is_empty() {
        remarks.push(format!("above the chart: {}", list_labels(&hidden)));
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
        text::significant(first, 4),
        text::significant(last, 4),
        units.speed.name(),
        chart.harmonics
    )
}
