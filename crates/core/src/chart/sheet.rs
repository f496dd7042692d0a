//! The drawing as layers: each is drawn by plotters and becomes one SVG group with attributes
//! (class, label, dashes) that plotters itself cannot write.

use super::text::{FAMILY, escape};
use crate::numerics::scalar::round;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt::Write;
use plotters::backend::SVGBackend;
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, IntoDrawingArea};
use plotters::element::{Circle, Drawable, PathElement, PointCollection, Polygon, Rectangle, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontDesc, FontFamily, FontStyle, FontTransform, RGBColor, ShapeStyle, TextStyle};

/// A point of the drawing [px], y downwards.
pub(super) type Point = (f64, f64);

/// plotters draws on whole pixels: ten of its pixels are one of the drawing's.
const FINE: f64 = 10.0;

/// Attributes of a group.
pub(super) type Attributes<'a> = &'a [(&'a str, &'a str)];

/// A drawing in the making.
#[derive(Debug)]
pub(super) struct Sheet {
    pub width: f64,
    pub height: f64,
    body: String,
}

impl Sheet {
    pub(super) fn new(width: f64, height: f64) -> Self {
        Self { width, height, body: String::new() }
    }

    /// Adds a group of what `draw` draws, unless it draws nothing.
    pub(super) fn layer(&mut self, attributes: Attributes, draw: &dyn Fn(&Pen)) {
        let mut svg = String::new();
        let size = (fine(self.width).unsigned_abs(), fine(self.height).unsigned_abs());
        // The backend closes its document when it is dropped.
        draw(&Pen { area: SVGBackend::with_string(&mut svg, size).into_drawing_area() });
        let inner = svg.split_once(">\n").and_then(|(_, rest)| rest.rsplit_once("</svg>"));
        let Some((inner, _)) = inner.filter(|(inner, _)| !inner.is_empty()) else { return };
        self.body.push_str("<g");
        for (name, value) in attributes.iter().filter(|(_, value)| !value.is_empty()) {
            // Writing to a string does not fail.
            let _ = write!(self.body, " {name}=\"{}\"", escape(value));
        }
        self.body.push_str(">\n");
        self.body.push_str(inner);
        self.body.push_str("</g>\n");
    }

    /// The SVG text.
    pub(super) fn finish(self, title: &str, description: &str) -> String {
        let Self { width, height, body } = self;
        let scale = 1.0 / FINE;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\">\n<title>{}</title>\n<desc>{}</desc>\n\
             <g transform=\"scale({scale})\" stroke-linejoin=\"round\">\n{body}</g>\n</svg>\n",
            escape(title),
            escape(description)
        )
    }
}

/// Lengths of dashes and gaps [px] as the attribute's value.
pub(super) fn dash_array(lengths: &[f64], unit: f64) -> String {
    let lengths: Vec<String> = lengths.iter().map(|length| format!("{}", fine(length * unit))).collect();
    lengths.join(" ")
}

fn fine(length: f64) -> i32 {
    round(length * FINE) as i32
}

fn fine_point((x, y): Point) -> (i32, i32) {
    (fine(x), fine(y))
}

/// Where a text's point is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// How a text looks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    pub size: f64,
    pub colour: RGBColor,
    pub anchor: Anchor,
    pub bold: bool,
}

impl Face {
    pub(super) const fn new(size: f64, colour: RGBColor, anchor: Anchor) -> Self {
        Self { size, colour, anchor, bold: false }
    }

    pub(super) const fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    /// How far below its middle a line of digits and capitals has its baseline.
    pub(super) fn drop(&self) -> f64 {
        0.36 * self.size
    }
}

/// Draws on one layer.
#[allow(missing_debug_implementations, reason = "a drawing area has none")]
pub(super) struct Pen<'a> {
    area: DrawingArea<SVGBackend<'a>, Shift>,
}

impl Pen<'_> {
    fn draw<'e, E>(&self, element: &'e E)
    where
        &'e E: PointCollection<'e, (i32, i32)>,
        for<'b> E: Drawable<SVGBackend<'b>>,
    {
        // Drawing into a string does not fail.
        let _ = self.area.draw(element);
    }

    /// An open line.
    pub(super) fn line(&self, points: &[Point], colour: RGBColor, width: f64) {
        if points.len() > 1 {
            let points: Vec<_> = points.iter().copied().map(fine_point).collect();
            self.draw(&PathElement::new(points, stroke(colour, width)));
        }
    }

    /// A filled area.
    pub(super) fn area(&self, points: &[Point], colour: RGBColor) {
        let points: Vec<_> = points.iter().copied().map(fine_point).collect();
        self.draw(&Polygon::new(points, colour.filled()));
    }

    /// A filled rectangle between two corners.
    pub(super) fn rectangle(&self, from: Point, to: Point, colour: RGBColor) {
        self.draw(&Rectangle::new([fine_point(from), fine_point(to)], colour.filled()));
    }

    /// A filled disc.
    pub(super) fn disc(&self, centre: Point, radius: f64, colour: RGBColor) {
        self.draw(&Circle::new(fine_point(centre), fine(radius), colour.filled()));
    }

    /// A circle.
    pub(super) fn circle(&self, centre: Point, radius: f64, colour: RGBColor, width: f64) {
        self.draw(&Circle::new(fine_point(centre), fine(radius), stroke(colour, width)));
    }

    /// A line of text with its baseline at `y`.
    pub(super) fn text(&self, (x, y): Point, text: &str, face: &Face) {
        self.write((x, y - 0.76 * face.size), text, face, FontTransform::None);
    }

    /// A line of text that reads upwards, its baseline at `x`.
    pub(super) fn text_upwards(&self, (x, y): Point, text: &str, face: &Face) {
        self.write((x - 0.76 * face.size, y), text, face, FontTransform::Rotate270);
    }

    fn write(&self, at: Point, text: &str, face: &Face, transform: FontTransform) {
        let horizontal = match face.anchor {
            Anchor::Start => HPos::Left,
            Anchor::Middle => HPos::Center,
            Anchor::End => HPos::Right,
        };
        let weight = if face.bold { FontStyle::Bold } else { FontStyle::Normal };
        // plotters writes size/1.24; and its only vertical position that all readers of SVG place
        // alike is the top, 0.76 em above the baseline.
        let size = f64::from(fine(face.size)) * 1.24;
        let font = FontDesc::new(FontFamily::Name(FAMILY), size, weight).transform(transform);
        let style = TextStyle::from(font).pos(Pos::new(horizontal, VPos::Top)).color(&face.colour);
        self.draw(&Text::new(text, fine_point(at), style));
    }
}

fn stroke(colour: RGBColor, width: f64) -> ShapeStyle {
    colour.stroke_width(fine(width).unsigned_abs())
}
