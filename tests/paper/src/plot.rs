//! Line charts for what the command line does not draw: several quantities over the number of functions.

use core::ops::Range;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Width and height [px].
const SIZE: (u32, u32) = (720, 400);
/// Space for the labels at the curves' ends [px].
const LABELS: u32 = 180;
/// Least distance of two labels [px].
const APART: i32 = 14;
const FONT: &str = "Helvetica, Arial, sans-serif";
const GRID: RGBColor = RGBColor(0xEC, 0xEE, 0xF0);

/// The colours of flap, lag and torsion, as in the charts of the command line.
pub(super) const COLOURS: [RGBColor; 3] =
    [RGBColor(0x00, 0x72, 0xB2), RGBColor(0xD5, 0x5E, 0x00), RGBColor(0x00, 0x9E, 0x73)];
/// The colour of what is there to compare with.
pub(super) const GREY: RGBColor = RGBColor(0x68, 0x6E, 0x76);

/// One curve.
pub(super) struct Curve {
    /// Name, on the right at the height of the last point; may be empty.
    pub(super) label: String,
    pub(super) colour: RGBColor,
    pub(super) stroke: Stroke,
    /// Points, both coordinates of the axes.
    pub(super) points: Vec<(f64, f64)>,
}

/// How a curve is drawn.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Stroke {
    Solid,
    Thin,
    Dashed,
    Dots,
}

/// The axes.
pub(super) struct Axes {
    pub(super) title: String,
    pub(super) x: &'static str,
    pub(super) y: &'static str,
    pub(super) across: Range<f64>,
    pub(super) up: Range<f64>,
    /// The vertical axis is that of powers of ten.
    pub(super) powers: bool,
}

/// The chart as SVG. What lies above or below the axes is cut off.
pub(super) fn chart(axes: &Axes, curves: &[Curve]) -> String {
    let height = |value: f64| if axes.powers { value.log10() } else { value };
    let up = height(axes.up.start)..height(axes.up.end);
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        area.fill(&WHITE).unwrap();
        let mut chart = ChartBuilder::on(&area)
            .caption(&axes.title, (FONT, 15))
            .margin(12)
            .margin_right(LABELS)
            .x_label_area_size(38)
            .y_label_area_size(56)
            .build_cartesian_2d(axes.across.clone(), up.clone())
            .unwrap();
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(GRID)
            .x_desc(axes.x)
            .y_desc(axes.y)
            .label_style((FONT, 12))
            .x_label_formatter(&|value| format!("{value:.0}"))
            .y_label_formatter(&|value| match axes.powers {
                // Ticks between whole powers have no short name.
                true if value.fract() != 0.0 => String::new(),
                true => format!("1e{value:.0}"),
                false => format!("{value:.0}"),
            })
            .draw()
            .unwrap();
        let mut taken: Vec<i32> = Vec::new();
        for curve in curves {
            let points = || curve.points.iter().map(|&(x, y)| (x, height(y)));
            let seen = |line: &[(f64, f64); 2]| line.iter().any(|(_, y)| up.contains(y));
            let (thin, thick) = (curve.colour.stroke_width(1), curve.colour.stroke_width(2));
            match curve.stroke {
                Stroke::Solid | Stroke::Thin => {
                    let style = if curve.stroke == Stroke::Thin { thin } else { thick };
                    let lines = points().zip(points().skip(1)).map(|(a, b)| cut([a, b], up.end)).filter(seen);
                    chart.draw_series(lines.map(|line| PathElement::new(line, style))).map(drop)
                }
                Stroke::Dashed => chart.draw_series([DashedPathElement::new(points(), 6, 4, thick)]).map(drop),
                Stroke::Dots => {
                    let dots = points().filter(|(_, y)| up.contains(y));
                    chart.draw_series(dots.map(|point| Circle::new(point, 2, curve.colour.filled()))).map(drop)
                }
            }
            .unwrap();
            if curve.label.is_empty() {
                continue;
            }
            let (_, last) = points().next_back().expect("a curve has points");
            let (x, mut y) = chart.backend_coord(&(axes.across.end, last.min(up.end)));
            while taken.iter().any(|other| (other - y).abs() < APART) {
                y += 1;
            }
            taken.push(y);
            let style = (FONT, 12).into_font().color(&curve.colour).pos(Pos::new(HPos::Left, VPos::Center));
            area.draw_text(&curve.label, &style, (x + 8, y)).unwrap();
        }
        area.present().unwrap();
    }
    svg
}

/// A line as far as it lies below `top`.
fn cut(line: [(f64, f64); 2], top: f64) -> [(f64, f64); 2] {
    let [a, b] = line;
    let at = |from: (f64, f64), to: (f64, f64)| (from.0 + (to.0 - from.0) * (top - from.1) / (to.1 - from.1), top);
    match (a.1 > top, b.1 > top) {
        (true, false) => [at(b, a), b],
        (false, true) => [a, at(a, b)],
        _ => line,
    }
}
