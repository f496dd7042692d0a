//! Line charts with a logarithmic axis, for what the command line does not draw.

use plotters::element::DashedPathElement;
use plotters::prelude::*;

/// Width and height [px].
const SIZE: (u32, u32) = (720, 400);
const FONT: &str = "Helvetica, Arial, sans-serif";

/// One curve.
pub(super) struct Curve {
    /// Name, at the curve's end.
    pub(super) label: String,
    /// Colour, by the degree of freedom as in the other charts.
    pub(super) colour: RGBColor,
    /// How it is drawn.
    pub(super) stroke: Stroke,
    /// Points, both coordinates of the axes.
    pub(super) points: Vec<(f64, f64)>,
}

/// How a curve is drawn.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Stroke {
    Solid,
    Dashed,
    Dots,
}

/// The axes.
pub(super) struct Axes {
    pub(super) title: &'static str,
    pub(super) x: &'static str,
    pub(super) y: &'static str,
    pub(super) across: core::ops::Range<f64>,
    pub(super) up: core::ops::Range<f64>,
}

/// The chart as SVG; space on the right is for the labels.
pub(super) fn chart(axes: &Axes, curves: &[Curve]) -> String {
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        area.fill(&WHITE).unwrap();
        let mut chart = ChartBuilder::on(&area)
            .caption(axes.title, (FONT, 15))
            .margin(12)
            .margin_right(170)
            .x_label_area_size(38)
            .y_label_area_size(64)
            .build_cartesian_2d(axes.across.clone(), axes.up.clone().log_scale())
            .unwrap();
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(RGBColor(0xEC, 0xEE, 0xF0))
            .x_desc(axes.x)
            .y_desc(axes.y)
            .label_style((FONT, 12))
            .x_label_formatter(&|value| format!("{value:.0}"))
            .y_label_formatter(&|value| format!("{value:.0e}"))
            .draw()
            .unwrap();
        let mut taken: Vec<i32> = Vec::new();
        for curve in curves {
            let points = curve.points.iter().copied();
            match curve.stroke {
                Stroke::Solid => chart
                    .draw_series(
                        points
                            .zip(curve.points.iter().copied().skip(1))
                            .map(|(a, b)| PathElement::new([a, b], curve.colour.stroke_width(2))),
                    )
                    .map(drop),
                Stroke::Dashed => {
                    chart.draw_series([DashedPathElement::new(points, 6, 4, curve.colour.stroke_width(2))]).map(drop)
                }
                Stroke::Dots => {
                    chart.draw_series(points.map(|point| Circle::new(point, 2, curve.colour.filled()))).map(drop)
                }
            }
            .unwrap();
            let last = *curve.points.last().expect("a curve has points");
            let (x, mut y) = chart.backend_coord(&(axes.across.end, last.1));
            while taken.iter().any(|other| (other - y).abs() < 14) {
                y += 2;
            }
            taken.push(y);
            let style = (FONT, 12).into_font().color(&curve.colour).pos(plotters::style::text_anchor::Pos::new(
                plotters::style::text_anchor::HPos::Left,
                plotters::style::text_anchor::VPos::Center,
            ));
            area.draw_text(&curve.label, &style, (x + 8, y)).unwrap();
        }
        area.present().unwrap();
    }
    svg
}

/// The colours of flap, lag and torsion.
pub(super) const COLOURS: [RGBColor; 3] =
    [RGBColor(0x00, 0x72, 0xB2), RGBColor(0xD5, 0x5E, 0x00), RGBColor(0x00, 0x9E, 0x73)];
