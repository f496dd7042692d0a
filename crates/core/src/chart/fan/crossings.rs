//! Crossings of branches and rays inside the operating band.

use super::super::line::Area;
use super::super::palette::Style;
use super::super::panel::Panel;
use super::super::place::Obstacles;
use super::super::sheet::{Anchor, Face, Point, Sheet};
use super::super::text;
use super::units::Units;
use crate::report::{Crossing, FanChart};
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use plotters::style::RGBColor;

/// More crossings than this are counted, not named.
const MOST_NAMED: usize = 14;

/// A crossing that shows.
#[derive(Clone, Debug)]
pub(super) struct Mark {
    pub at: Point,
    pub name: String,
    pub label: String,
}

/// Crossings inside the band of rotor speeds.
pub(super) fn in_band(chart: &FanChart, band: (f64, f64)) -> impl Iterator<Item = &Crossing> {
    let nominal = chart.nominal.speed_rad_s;
    let (from, to) = (band.0 * nominal, band.1 * nominal);
    chart.crossings.iter().filter(move |crossing| crossing.speed_rad_s >= from && crossing.speed_rad_s <= to)
}

/// The same inside the frame.
pub(super) fn marks(chart: &FanChart, band: (f64, f64), panel: &Panel, units: Units) -> Vec<Mark> {
    let mark = |crossing: &Crossing| {
        let at = units.point(panel, crossing.speed_rad_s, crossing.frequency_rad_s)?;
        let label = crossing.label.to_string();
        panel.area.holds_point(at).then(|| Mark { at, name: format!("{label} × {}P", crossing.harmonic), label })
    };
    in_band(chart, band).filter_map(mark).collect()
}

/// Radius of the circles [px].
pub(super) fn radius(style: &Style) -> f64 {
    4.2 * style.unit
}

/// Draws circles, and names where they are few and there is room.
pub(super) fn draw(sheet: &mut Sheet, style: &Style, marks: &[Mark], obstacles: &mut Obstacles) {
    let radius = radius(style);
    let palette = &style.palette;
    for mark in marks {
        let (x, y) = mark.at;
        let half = radius + 1.0;
        obstacles.boxes.push(Area { left: x - half, top: y - half, right: x + half, bottom: y + half });
    }
    for mark in marks {
        sheet.layer(&[("class", "crossing"), ("data-label", &mark.label), ("data-crossing", &mark.name)], &|pen| {
            pen.disc(mark.at, radius, palette.background);
            pen.circle(mark.at, radius, palette.text, 1.3 * style.unit);
        });
    }
    if marks.len() > MOST_NAMED {
        return;
    }
    let face = Face::new(style.small(), palette.text, Anchor::Middle);
    let near = radius + 2.0 * style.unit;
    let distances = [near, near + 5.0 * style.unit, near + 10.0 * style.unit];
    for mark in marks {
        let size = (text::width(&mark.name, face.size, false) + 4.0 * style.unit, 1.15 * face.size);
        let Some(area) = obstacles.place(mark.at, size, &distances) else { continue };
        let at = (0.5 * (area.left + area.right), 0.5 * (area.top + area.bottom) + face.drop());
        draw_haloed(sheet, style, ("crossing-label", &mark.label), at, &mark.name, &face);
    }
}

/// A text with a rim of the background, so that it can be read over lines.
pub(super) fn draw_haloed(
    sheet: &mut Sheet,
    style: &Style,
    (class, label): (&str, &str),
    at: Point,
    name: &str,
    face: &Face,
) {
    let RGBColor(red, green, blue) = style.palette.background;
    let rim = format!("#{red:02X}{green:02X}{blue:02X}");
    let width = format!("{}", (30.0 * style.unit) as i32);
    let attributes = [
        ("class", class),
        ("data-label", label),
        ("stroke", &rim),
        ("stroke-width", &width),
        ("paint-order", "stroke"),
    ];
    sheet.layer(&attributes, &|pen| pen.text(at, name, face));
}
