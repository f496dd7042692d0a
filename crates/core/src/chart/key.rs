//! What stands around a frame: the title, the key of signs under it, the grey notes below.

use super::palette::{FAMILY_DASHES, Style, dashes};
use super::sheet::{Anchor, Face, Pen, Point, Sheet, dash_array};
use super::text;
use crate::VERSION;
use crate::dof::Dof;
use crate::functions::BasisFamily;
use crate::label::Label;
use crate::report::BasisReport;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use plotters::style::RGBColor;

/// Shapes of filled markers, one per source of measured points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Marker {
    Square,
    Triangle,
    Diamond,
    Disc,
    Wedge,
    Hourglass,
}

impl Marker {
    const ALL: [Self; 6] = [Self::Square, Self::Triangle, Self::Diamond, Self::Disc, Self::Wedge, Self::Hourglass];

    /// The marker of the source of this number; after six they come again.
    pub(super) const fn of_source(number: usize) -> Self {
        Self::ALL[number % Self::ALL.len()]
    }

    /// Draws it with a rim of the background, so that it stands off the lines below.
    pub(super) fn draw(self, pen: &Pen, style: &Style, centre: Point, colour: RGBColor) {
        let radius = 4.2 * style.unit;
        self.fill(pen, centre, radius + 1.6 * style.unit, style.palette.background);
        self.fill(pen, centre, radius, colour);
    }

    fn fill(self, pen: &Pen, (x, y): Point, radius: f64, colour: RGBColor) {
        let corners = |offsets: &[Point]| -> Vec<Point> {
            offsets.iter().map(|offset| (x + radius * offset.0, y + radius * offset.1)).collect()
        };
        // Sizes of equal weight to the eye.
        let offsets: &[Point] = match self {
            Self::Disc => return pen.disc((x, y), radius, colour),
            Self::Square => &[(-0.88, -0.88), (0.88, -0.88), (0.88, 0.88), (-0.88, 0.88)],
            Self::Triangle => &[(0.0, -1.25), (1.15, 0.8), (-1.15, 0.8)],
            Self::Diamond => &[(0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)],
            Self::Wedge => &[(0.0, 1.25), (1.15, -0.8), (-1.15, -0.8)],
            Self::Hourglass => &[(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)],
        };
        pen.area(&corners(offsets), colour);
    }
}

/// A sign of the key.
#[derive(Clone, Copy, Debug)]
pub(super) enum Sign {
    Branch(Dof),
    /// A degree of freedom where dashes tell something else.
    Colour(Dof),
    Family(BasisFamily),
    BladeRay,
    Crossing,
    /// A short upright bar.
    Veering,
    Band,
    Measured(Marker),
}

/// A sign and what it means.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub sign: Sign,
    pub text: String,
}

impl Entry {
    pub(super) fn new(sign: Sign, text: impl Into<String>) -> Self {
        Self { sign, text: text.into() }
    }

    /// A line of the degree of freedom.
    pub(super) fn dof(dof: Dof) -> Self {
        Self::new(Sign::Branch(dof), dof.name())
    }

    fn sign_width(&self, style: &Style) -> f64 {
        style.unit
            * match self.sign {
                Sign::Branch(_) | Sign::Family(_) => 34.0,
                Sign::BladeRay => 22.0,
                Sign::Band | Sign::Colour(_) => 14.0,
                Sign::Crossing | Sign::Veering | Sign::Measured(_) => 11.0,
            }
    }

    fn width(&self, style: &Style) -> f64 {
        self.sign_width(style) + 6.0 * style.unit + text::width(&self.text, style.tick(), false)
    }
}

/// A point of piecewise functions: a diamond, as classical ones are discs.
pub(super) fn draw_piecewise_point(pen: &Pen, style: &Style, (x, y): Point, colour: RGBColor) {
    let radius = 3.2 * style.unit;
    pen.area(&[(x, y - radius), (x + radius, y), (x, y + radius), (x - radius, y)], colour);
}

/// Title and key, laid out.
#[derive(Clone, Debug)]
pub(super) struct Head {
    title: String,
    /// Left edge [px] and entry, row by row.
    rows: Vec<Vec<(f64, Entry)>>,
}

impl Head {
    /// Title and key from `left` on.
    pub(super) fn new(style: &Style, name: &str, entries: Vec<Entry>, left: f64) -> Self {
        let right = style.width - style.margin();
        let title = text::shorten(name, right - left, style.title(), true);
        let gap = 18.0 * style.unit;
        let mut rows: Vec<Vec<(f64, Entry)>> = Vec::new();
        let mut x = right;
        for mut entry in entries {
            let room = right - left - entry.sign_width(style) - 6.0 * style.unit;
            entry.text = text::shorten(&entry.text, room, style.tick(), false);
            let width = entry.width(style);
            if x + width > right || rows.is_empty() {
                rows.push(Vec::new());
                x = left;
            }
            if let Some(row) = rows.last_mut() {
                row.push((x, entry));
            }
            x += width + gap;
        }
        Self { title, rows }
    }

    fn row_height(style: &Style) -> f64 {
        1.6 * style.tick()
    }

    /// Height [px] from the drawing's upper edge to below the key.
    pub(super) fn height(&self, style: &Style) -> f64 {
        style.margin() + 1.35 * style.title() + self.rows.len() as f64 * Self::row_height(style)
    }

    /// Draws both.
    pub(super) fn draw(&self, sheet: &mut Sheet, style: &Style, left: f64) {
        let face = Face::new(style.title(), style.palette.text, Anchor::Start).bold();
        let baseline = style.margin() + 0.8 * style.title();
        sheet.layer(&[("class", "title")], &|pen| pen.text((left, baseline), &self.title, &face));
        let first = style.margin() + 1.35 * style.title() + 0.5 * Self::row_height(style);
        for (number, row) in self.rows.iter().enumerate() {
            let middle = first + number as f64 * Self::row_height(style);
            for (x, entry) in row {
                draw_entry(sheet, style, (*x, middle), entry);
            }
        }
    }
}

fn draw_entry(sheet: &mut Sheet, style: &Style, (x, y): Point, entry: &Entry) {
    let palette = &style.palette;
    let length = entry.sign_width(style);
    let dash = match entry.sign {
        Sign::Branch(dof) => dash_array(dashes(dof), style.unit),
        Sign::Family(BasisFamily::Piecewise) => dash_array(&FAMILY_DASHES, style.unit),
        _ => String::new(),
    };
    let middle = (x + 0.5 * length, y);
    sheet.layer(&[("class", "key"), ("stroke-dasharray", &dash)], &|pen| match entry.sign {
        Sign::Branch(dof) => pen.line(&[(x, y), (x + length, y)], palette.dof(dof), 2.0 * style.unit),
        Sign::Colour(dof) => pen.line(&[(x, y), (x + length, y)], palette.dof(dof), 4.0 * style.unit),
        Sign::Family(family) => {
            pen.line(&[(x, y), (x + length, y)], palette.nominal, 1.3 * style.unit);
            match family {
                BasisFamily::Classical => pen.disc(middle, 2.2 * style.unit, palette.nominal),
                BasisFamily::Piecewise => draw_piecewise_point(pen, style, middle, palette.nominal),
            }
        }
        Sign::BladeRay => pen.line(&[(x, y), (x + length, y)], palette.blade_ray, 1.2 * style.unit),
        Sign::Crossing => pen.circle(middle, 4.2 * style.unit, palette.text, 1.3 * style.unit),
        Sign::Veering => {
            let half = 5.0 * style.unit;
            pen.line(&[(middle.0, y - half), (middle.0, y + half)], palette.text, 1.6 * style.unit);
        }
        Sign::Band => {
            let half = 6.0 * style.unit;
            pen.rectangle((x, y - half), (x + length, y + half), palette.band);
            let corners = [(x, y - half), (x + length, y - half), (x + length, y + half), (x, y + half), (x, y - half)];
            pen.line(&corners, palette.ray, 0.6);
        }
        Sign::Measured(marker) => marker.draw(pen, style, middle, palette.nominal),
    });
    let face = Face::new(style.tick(), palette.text, Anchor::Start);
    let at = (x + length + 6.0 * style.unit, y + face.drop());
    sheet.layer(&[("class", "key")], &|pen| pen.text(at, &entry.text, &face));
}

/// Grey lines at the foot.
#[derive(Clone, Debug)]
pub(super) struct Foot {
    lines: Vec<String>,
}

impl Foot {
    /// `parts` and what every drawing says: the model and the program's version; then `remarks`
    /// on lines of their own.
    pub(super) fn new(style: &Style, mut parts: Vec<String>, model: &str, remarks: &[String], left: f64) -> Self {
        let room = style.width - style.margin() - left;
        parts.push(model.to_string());
        parts.push(format!("bladefan {VERSION}"));
        let mut lines = text::flow(&parts, room, style.small());
        lines.extend(text::flow(remarks, room, style.small()));
        Self { lines }
    }

    fn row_height(style: &Style) -> f64 {
        1.4 * style.small()
    }

    /// Height [px], the lower margin included.
    pub(super) fn height(&self, style: &Style) -> f64 {
        self.lines.len() as f64 * Self::row_height(style) + 0.8 * style.margin()
    }

    /// Draws the lines from `top` on.
    pub(super) fn draw(&self, sheet: &mut Sheet, style: &Style, left: f64, top: f64) {
        let face = Face::new(style.small(), style.palette.muted, Anchor::Start);
        sheet.layer(&[("class", "notes")], &|pen| {
            for (number, line) in self.lines.iter().enumerate() {
                let baseline = top + (number as f64 + 0.5) * Self::row_height(style) + face.drop();
                pen.text((left, baseline), line, &face);
            }
        });
    }
}

/// The assumed functions in words.
pub(super) fn basis_text(basis: &BasisReport) -> String {
    let family = basis.family.name();
    let known: Vec<(Dof, usize)> = basis.functions.known().collect();
    match known.as_slice() {
        [] => format!("{family} functions"),
        [(_, first), rest @ ..] if rest.iter().all(|(_, count)| count == first) => {
            format!("{first} {family} functions")
        }
        _ => {
            let each: Vec<String> = known.iter().map(|(dof, count)| format!("{count} {dof}")).collect();
            format!("{family} functions: {}", each.join(", "))
        }
    }
}

/// Paints the background.
pub(super) fn draw_background(sheet: &mut Sheet, style: &Style) {
    let corner = (sheet.width, sheet.height);
    sheet.layer(&[("class", "background")], &|pen| pen.rectangle((0.0, 0.0), corner, style.palette.background));
}

/// "2F–5F" for runs of numbers, "2F, 4F" for others; in the order given.
pub(super) fn list_labels(branches: &[Label]) -> String {
    let mut texts: Vec<String> = Vec::new();
    let mut at = 0;
    while let Some(&first) = branches.get(at) {
        let following = |step: usize| Label::new(first.dof, first.number + step);
        let run = branches[at..].iter().enumerate().take_while(|(step, next)| **next == following(*step)).count();
        texts.push(match run {
            // A mixed mode is followed by none.
            0 | 1 => first.to_string(),
            _ => format!("{first}–{}", following(run - 1)),
        });
        at += run.max(1);
    }
    texts.join(", ")
}
