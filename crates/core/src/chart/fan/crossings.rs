//! Crossings of branches and rays inside the operating band.

use super::super::labels::{Circles, Obstacles, Placed};
use super::super::palette::Style;
use super::super::panel::Panel;
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
/// Width of the circles' lines, in units.
const LINE: f64 = 1.3;

/// A crossing that shows.
#[derive(Clone, Debug)]
pub(super) struct Mark {
    pub at: Point,
    pub name: String,
    pub label: String,
}

/// Crossings inside the band of rotor speeds and inside the frame.
pub(super) fn marks(chart: &FanChart, band: (f64, f64), panel: &Panel, units: Units) -> Vec<Mark> {
    let mark = |crossing: &Crossing| {
        let at = units.point(panel, crossing.speed_rad_s, crossing.frequency_rad_s)?;
        // The circle belongs to its branch, which may be called otherwise there.
        let branch = chart.branches.get(crossing.branch).map_or(crossing.label, |branch| branch.label);
        let name = format!("{} × {}P", crossing.label, crossing.harmonic);
        panel.area.holds_point(at).then(|| Mark { at, name, label: branch.to_string() })
    };
    chart.crossings_in(band).filter_map(mark).collect()
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
        sheet.layer(&[("class", "crossing"), ("data-label", &mark.label), ("data-crossing", &mark.name)], &|pen| {
            pen.disc(mark.at, radius, palette.background);
            pen.circle(mark.at, radius, palette.text, LINE * style.unit);
        });
    }
    let face = Face::new(style.small(), palette.text, Anchor::Middle);
    let size = |mark: &Mark| (text::width(&mark.name, face.size, false) + 4.0 * style.unit, 1.15 * face.size);
    let named = if marks.len() > MOST_NAMED { &[] } else { marks };
    let centres: Vec<Point> = marks.iter().map(|mark| mark.at).collect();
    let circles = Circles { centres: &centres, radius, line: LINE * style.unit, unit: style.unit };
    let placed = circles.label(&named.iter().map(size).collect::<Vec<_>>(), obstacles);
    for (mark, placed) in marks.iter().zip(placed) {
        let Some(Placed { area, leader }) = placed else { continue };
        if let Some(leader) = leader {
            let (class, label, name) = ("crossing-leader", &mark.label, &mark.name);
            sheet.layer(&[("class", class), ("data-label", label), ("data-crossing", name)], &|pen| {
                pen.line(&leader, palette.background, 3.0 * style.unit);
                pen.line(&leader, palette.text, 0.9 * style.unit);
            });
        }
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
