//! A frame with its axes, and labels at its right end.

use super::labels::{Wish, spread};
use super::line::Area;
use super::palette::Style;
use super::scale::{Scale, Tick};
use super::sheet::{Anchor, Face, Pen, Point, Sheet};
use super::text;
use super::{Axis, PlotArea};
use crate::numerics::scalar::ceil;
use alloc::string::String;
use alloc::vec::Vec;
use plotters::style::RGBColor;

/// A frame on the drawing.
#[derive(Clone, Debug)]
pub(super) struct Panel {
    pub area: Area,
    pub x: Scale,
    pub y: Scale,
    pub x_ticks: Vec<Tick>,
    pub y_ticks: Vec<Tick>,
}

/// Room [px] that tick texts take to the left of a frame.
fn tick_room(style: &Style, ticks: &[Tick]) -> f64 {
    let widest = ticks.iter().map(|tick| tick_width(tick, style.tick())).fold(0.0, f64::max);
    widest + 8.0 * style.unit
}

/// The same for a frame whose height is not yet known: between these shares of the drawing's width.
pub(super) fn y_tick_room(style: &Style, y: &Scale, heights: [f64; 2]) -> f64 {
    let room = |share: f64| tick_room(style, &y.ticks(y_tick_count(style, y, share * style.width)));
    let between = 0.5 * (heights[0] + heights[1]);
    room(heights[0]).max(room(between)).max(room(heights[1]))
}

/// Between which shares of the width a frame's height lies where a drawing's is `share` of it.
pub(super) fn shares_of(share: f64) -> [f64; 2] {
    [(share - 0.35).max(0.1), share]
}

/// Least height [px] of a frame, whatever the height of the drawing.
pub(super) fn least_height(style: &Style) -> f64 {
    75.0 * style.unit
}

/// The whole number of pixels that holds `height`; what is whole but for rounding stays.
pub(super) fn whole(height: f64) -> f64 {
    ceil(height - 1e-6)
}

fn y_tick_count(style: &Style, y: &Scale, height: f64) -> f64 {
    // Decades may stand closer than numbers that are read off.
    tick_count(style, height, if y.axis.log { 28.0 } else { 50.0 })
}

fn tick_width(tick: &Tick, size: f64) -> f64 {
    let raised = tick.exponent.as_ref().map_or(0.0, |text| text::width(text, 0.75 * size, false));
    text::width(&tick.text, size, false) + raised
}

/// Height [px] of tick texts below a frame, and of the axis name below them.
pub(super) fn ticks_below(style: &Style) -> f64 {
    5.0 * style.unit + 1.1 * style.tick()
}

pub(super) fn name_below(style: &Style) -> f64 {
    5.0 * style.unit + 1.2 * style.label()
}

/// Width [px] of an axis name that reads upwards.
pub(super) fn name_beside(style: &Style) -> f64 {
    1.5 * style.label()
}

/// How many ticks suit a length [px].
fn tick_count(style: &Style, length: f64, apart: f64) -> f64 {
    (length / (apart * style.unit)).max(2.0)
}

impl Panel {
    /// A frame with axes laid out on it; y upwards.
    pub(super) fn new(style: &Style, area: Area, x: Scale, y: Scale) -> Self {
        let x = x.on(area.left, area.right);
        let y = y.on(area.bottom, area.top);
        let x_ticks = x.ticks(tick_count(style, area.right - area.left, 75.0));
        let y_ticks = y.ticks(y_tick_count(style, &y, area.bottom - area.top));
        Self { area, x, y, x_ticks, y_ticks }
    }

    /// Where values are on the drawing.
    pub(super) fn point(&self, x: f64, y: f64) -> Option<Point> {
        if x.is_finite() && y.is_finite() { Some((self.x.at(x)?, self.y.at(y)?)) } else { None }
    }

    /// What a page needs to know of it.
    pub(super) fn describe(&self, name: &'static str) -> PlotArea {
        let Area { left, top, right, bottom } = self.area;
        let (x, y): (Axis, Axis) = (self.x.axis.clone(), self.y.axis.clone());
        PlotArea { name, left, top, width: right - left, height: bottom - top, x, y }
    }

    /// Light lines at the ticks.
    pub(super) fn draw_grid(&self, sheet: &mut Sheet, style: &Style) {
        let Area { left, top, right, bottom } = self.area;
        sheet.layer(&[("class", "grid")], &|pen| {
            for x in self.x_ticks.iter().filter_map(|tick| self.x.at(tick.value)) {
                pen.line(&[(x, top), (x, bottom)], style.palette.grid, 1.0);
            }
            for y in self.y_ticks.iter().filter_map(|tick| self.y.at(tick.value)) {
                pen.line(&[(left, y), (right, y)], style.palette.grid, 1.0);
            }
        });
    }

    /// Frame, tick texts and axis names; an empty x name leaves the x ticks without texts.
    pub(super) fn draw_axes(&self, sheet: &mut Sheet, style: &Style, x_name: &str, y_name: &str) {
        let Area { left, top, right, bottom } = self.area;
        let palette = &style.palette;
        let mark = 4.0 * style.unit;
        sheet.layer(&[("class", "axes")], &|pen| {
            pen.line(&[(left, top), (right, top), (right, bottom), (left, bottom), (left, top)], palette.frame, 0.8);
            for tick in &self.x_ticks {
                let Some(x) = self.x.at(tick.value) else { continue };
                pen.line(&[(x, bottom), (x, bottom - mark)], palette.frame, 0.8);
                if !x_name.is_empty() {
                    let baseline = bottom + 5.0 * style.unit + 0.8 * style.tick();
                    draw_tick(pen, style, tick, (x - 0.5 * tick_width(tick, style.tick()), baseline), true);
                }
            }
            for tick in &self.y_ticks {
                let Some(y) = self.y.at(tick.value) else { continue };
                pen.line(&[(left, y), (left + mark, y)], palette.frame, 0.8);
                draw_tick(pen, style, tick, (left - 6.0 * style.unit, y + 0.36 * style.tick()), false);
            }
            let face = Face::new(style.label(), palette.text, Anchor::Middle);
            if !x_name.is_empty() {
                let baseline = bottom + ticks_below(style) + 5.0 * style.unit + 0.8 * style.label();
                pen.text((0.5 * (left + right), baseline), x_name, &face);
            }
            if !y_name.is_empty() {
                let baseline = left - tick_room(style, &self.y_ticks) - 0.45 * style.label();
                pen.text_upwards((baseline, 0.5 * (top + bottom)), y_name, &face);
            }
        });
    }
}

/// A tick text centred on `x`'s left end where `from_left`, else ending at it.
fn draw_tick(pen: &Pen, style: &Style, tick: &Tick, (x, y): Point, from_left: bool) {
    let size = style.tick();
    let Some(exponent) = &tick.exponent else {
        let middle = 0.5 * tick_width(tick, size);
        let (anchor, x) = if from_left { (Anchor::Middle, x + middle) } else { (Anchor::End, x) };
        return pen.text((x, y), &tick.text, &Face::new(size, style.palette.text, anchor));
    };
    let raised = Face::new(0.75 * size, style.palette.text, Anchor::Start);
    let seam = if from_left {
        x + text::width(&tick.text, size, false)
    } else {
        x - text::width(exponent, raised.size, false)
    };
    pen.text((seam, y), &tick.text, &Face::new(size, style.palette.text, Anchor::End));
    pen.text((seam + 0.5, y - 0.4 * size), exponent, &raised);
}

/// A label at the right end of a frame.
#[derive(Clone, Debug)]
pub(super) struct EndLabel {
    pub text: String,
    /// x [px] of the end of what it names, at most the frame's right edge.
    pub from: f64,
    /// y [px] there.
    pub target: f64,
    pub colour: RGBColor,
    pub bold: bool,
    /// Lower ones go first where there is no room.
    pub rank: u32,
    /// Furthest [px] it may stand from its target.
    pub limit: f64,
    /// Class of its group: `branch-label`, `ray-label`.
    pub class: &'static str,
}

impl EndLabel {
    fn size(&self, style: &Style) -> f64 {
        if self.bold { style.tick() } else { style.small() }
    }
}

/// Room [px] to the right of a frame for the leaders of its end labels.
pub(super) fn leader_length(style: &Style) -> f64 {
    16.0 * style.unit
}

/// Draws labels to the right of a frame, pushed apart, with leaders where they moved; returns how
/// many found no room.
pub(super) fn draw_end_labels(sheet: &mut Sheet, style: &Style, area: &Area, labels: &[EndLabel]) -> usize {
    let wishes: Vec<Wish> = labels
        .iter()
        .map(|label| Wish {
            target: label.target,
            size: 1.15 * label.size(style),
            limit: label.limit,
            rank: label.rank,
        })
        .collect();
    let slack = 0.5 * style.label();
    let places = spread(&wishes, area.top - slack, area.bottom + slack);
    let reach = leader_length(style);
    for (label, place) in labels.iter().zip(&places) {
        let Some(y) = *place else { continue };
        sheet.layer(&[("class", label.class), ("data-label", &label.text)], &|pen| {
            let face = Face::new(label.size(style), label.colour, Anchor::Start);
            let face = if label.bold { face.bold() } else { face };
            if (y - label.target).abs() > 1.0 {
                let bend = [
                    (label.from + 1.0, label.target),
                    (area.right + 0.25 * reach, label.target),
                    (area.right + 0.75 * reach, y),
                    (area.right + 0.9 * reach, y),
                ];
                pen.line(&bend, style.palette.tone(label.colour, 0.6), 0.8);
            }
            pen.text((area.right + reach, y + face.drop()), &label.text, &face);
        });
    }
    places.iter().filter(|place| place.is_none()).count()
}
