//! Mode shapes: one panel per degree of freedom.

use super::key::{Foot, Head, basis_text, draw_background};
use super::labels::Obstacles;
use super::line::{Area, thin};
use super::palette::Style;
use super::panel::{self, Panel};
use super::scale::Scale;
use super::sheet::{Anchor, Face, Point, Sheet};
use super::{ChartOptions, Drawing, text};
use crate::dof::Dof;
use crate::figures::short_in_drawing;
use crate::report::{CoupledShapesReport, ShapeReport, ShapesReport};
use alloc::format;
use alloc::string::ToString;
use alloc::vec::Vec;
use plotters::style::RGBColor;

/// Panels stand side by side where each gets this many pixels of its row, else one below the other.
const LEAST_SHARE: f64 = 280.0;

/// A label that would cover more than a few lines is left out.
const MOST_COVERED: f64 = 14.0;

/// A motion of a coupled mode whose largest displacement is less than this of the largest of that motion in any
/// mode is left out.
const SHOWN: f64 = 0.02;

/// Draws the shapes of coupled modes over the span r/R: in the panel of each motion every mode that has some of it.
pub fn coupled_shapes(report: &CoupledShapesReport, options: &ChartOptions) -> Drawing {
    let size = |values: &[f64]| values.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let mut shapes = Vec::new();
    for dof in Dof::ALL {
        let largest = report.shapes.iter().map(|shape| size(shape.components.leading(dof))).fold(0.0, f64::max);
        for shape in &report.shapes {
            let displacement = shape.components.leading(dof);
            if size(displacement) > SHOWN * largest {
                shapes.push(ShapeReport {
                    label: shape.label,
                    dof,
                    number: shape.number,
                    frequency_rad_s: shape.frequency_rad_s.unwrap_or(f64::NAN),
                    orthogonality: 0.0,
                    nodes_m: if dof == shape.dof { shape.nodes_m.clone() } else { Vec::new() },
                    displacement: displacement.to_vec(),
                    slope: Vec::new(),
                    moment: Vec::new(),
                });
            }
        }
    }
    let plain = ShapesReport {
        schema: report.schema,
        blade: report.blade.clone(),
        speed_rad_s: report.speed_rad_s,
        model: report.model.clone(),
        basis: report.basis,
        r_m: report.r_m.clone(),
        radius_m: report.radius_m,
        shapes,
        warnings: Vec::new(),
    };
    self::shapes(&plain, options)
}

/// Draws mode shapes over the span r/R.
pub fn shapes(report: &ShapesReport, options: &ChartOptions) -> Drawing {
    let style = Style::of(options.theme, options.width);
    let name = text::clean(&report.blade);
    let dofs: Vec<Dof> =
        Dof::ALL.into_iter().filter(|dof| report.shapes.iter().any(|shape| shape.dof == *dof)).collect();
    let speed = format!(
        "at {} {}",
        short_in_drawing(report.speed_rad_s / options.speed_unit.si(), 4),
        options.speed_unit.name()
    );
    let scales: Vec<Scale> = dofs.iter().map(|&dof| y_scale(report, dof)).collect();

    // Each panel has the same room to its left, so that the frames are of one size.
    let held = options.held_height(style.width);
    let shares = held.map_or([0.15, 0.42], |height| [0.1, height / style.width]);
    let ticks = scales.iter().map(|scale| panel::y_tick_room(&style, scale, shares)).fold(0.0, f64::max);
    let beside = 0.7 * style.margin() + panel::name_beside(&style) + ticks;
    let count = dofs.len().max(1) as f64;
    let columns = if style.width / count >= LEAST_SHARE * style.unit.min(1.0) { dofs.len().max(1) } else { 1 };
    let share = (style.width - style.margin()) / columns as f64;
    let (width, ratio) = (share - beside - 0.3 * style.margin(), if columns == 1 { 0.42 } else { 0.85 });
    let caption = 1.7 * style.label();
    let below = panel::ticks_below(&style) + panel::name_below(&style);
    let row_rest = caption + below + 0.5 * style.margin();
    let rows = dofs.len().div_ceil(columns);

    let head = Head::new(&style, &name, Vec::new(), beside);
    let top = head.height(&style);
    let notes = alloc::vec![speed.clone(), "dots: nodes".to_string(), basis_text(&report.basis)];
    let foot = Foot::new(&style, notes, &report.model.words, &[], beside);
    let height = held.map_or(ratio * width, |height| {
        let room = (height - top - foot.height(&style)) / rows.max(1) as f64;
        (room - row_rest).max(panel::least_height(&style))
    });
    let row_height = row_rest + height;
    let panels: Vec<Panel> = scales
        .into_iter()
        .enumerate()
        .map(|(number, y)| {
            let left = (number % columns) as f64 * share + beside;
            let top = top + (number / columns) as f64 * row_height + caption;
            let area = Area { left, top, right: left + width, bottom: top + height };
            Panel::new(&style, area, Scale::linear(0.0, 1.0, ""), y)
        })
        .collect();
    let foot_top = top + rows as f64 * row_height;
    let mut sheet = Sheet::new(style.width, panel::whole(foot_top + foot.height(&style)));

    draw_background(&mut sheet, &style);
    head.draw(&mut sheet, &style, beside);
    for (&dof, panel) in dofs.iter().zip(&panels) {
        draw_panel(&mut sheet, &style, report, dof, panel);
    }
    foot.draw(&mut sheet, &style, beside, foot_top);
    let plots = dofs.iter().zip(&panels).map(|(dof, panel)| panel.describe(dof.name())).collect();
    let (width, height) = (sheet.width, sheet.height);
    let about = format!("{} mode shapes over the span, {speed}.", report.shapes.len());
    Drawing { svg: sheet.finish(&format!("{name}: mode shapes"), &about), width, height, plots }
}

/// Room for the largest displacement of the degree of freedom, to both sides of zero.
fn y_scale(report: &ShapesReport, dof: Dof) -> Scale {
    let shapes = report.shapes.iter().filter(|shape| shape.dof == dof);
    let values =
        shapes.flat_map(|shape| &shape.displacement).map(|value| value.abs()).filter(|value| value.is_finite());
    let largest = values.fold(0.0, f64::max);
    let largest = if largest > 0.0 { 1.2 * largest } else { 1.0 };
    Scale::linear(-largest, largest, "")
}

fn draw_panel(sheet: &mut Sheet, style: &Style, report: &ShapesReport, dof: Dof, panel: &Panel) {
    let Area { left, top, right, .. } = panel.area;
    let colour = style.palette.dof(dof);
    let caption = Face::new(style.label(), colour, Anchor::Start).bold();
    sheet.layer(&[("class", "caption")], &|pen| pen.text((left, top - 0.5 * style.label()), dof.name(), &caption));
    panel.draw_grid(sheet, style);
    let zero = panel.y.at(0.0).map(|y| [(left, y), (right, y)]);
    sheet.layer(&[("class", "zero")], &|pen| {
        if let Some(zero) = &zero {
            pen.line(zero, style.palette.frame, 1.0);
        }
    });
    panel.draw_axes(sheet, style, "span r/R", if dof == Dof::Torsion { "twist" } else { "displacement" });

    let shapes: Vec<&ShapeReport> = report.shapes.iter().filter(|shape| shape.dof == dof).collect();
    let lines: Vec<Vec<Point>> = shapes.iter().map(|shape| line(report, shape, panel)).collect();
    let mut obstacles = Obstacles::within(panel.area);
    obstacles.lines.extend(lines.iter().map(|line| (thin(line), 2.0)));
    obstacles.lines.extend(zero.map(|zero| (zero.to_vec(), 1.0)));
    let tones: Vec<RGBColor> = (0..shapes.len())
        .map(|number| {
            // The first mode in the full colour, the last still well off the background.
            let share = 1.0 - 0.42 * number as f64 / (shapes.len().max(2) - 1) as f64;
            style.palette.tone(colour, share)
        })
        .collect();
    // The first mode last, on top.
    for number in (0..shapes.len()).rev() {
        let (class, label) = (format!("shape {dof}"), shapes[number].label.to_string());
        sheet.layer(&[("class", &class), ("data-label", &label)], &|pen| {
            pen.line(&thin(&lines[number]), tones[number], 1.8 * style.unit);
            for node in nodes(&lines[number], panel) {
                pen.disc(node, 3.8 * style.unit, style.palette.background);
                pen.disc(node, 2.7 * style.unit, tones[number]);
            }
        });
    }
    for line in &lines {
        let half = 3.0 * style.unit;
        let dots = nodes(line, panel).into_iter();
        obstacles.boxes.extend(dots.map(|(x, y)| Area {
            left: x - half,
            top: y - half,
            right: x + half,
            bottom: y + half,
        }));
    }
    for (number, (shape, line)) in shapes.iter().zip(&lines).enumerate() {
        let label = shape.label.to_string();
        let face = Face::new(style.tick(), tones[number], Anchor::Middle).bold();
        let size = (text::width(&label, face.size, true) + 4.0 * style.unit, 1.1 * face.size);
        // A label may stand on its own line.
        let own = core::mem::take(&mut obstacles.lines[number].0);
        let chosen = obstacles.choose(label_areas(line, panel, size, 3.0 * style.unit), MOST_COVERED);
        obstacles.lines[number].0 = own;
        let Some(area) = chosen else { continue };
        let at = (0.5 * (area.left + area.right), 0.5 * (area.top + area.bottom) + face.drop());
        sheet.layer(&[("class", "shape-label"), ("data-label", &label)], &|pen| {
            let inset = 1.0 * style.unit;
            let corner = (area.right - inset, area.bottom - inset);
            pen.rectangle((area.left + inset, area.top + inset), corner, style.palette.background);
            pen.text(at, &label, &face);
        });
    }
}

/// The shape's points on the drawing; those that are not numbers are left out.
fn line(report: &ShapesReport, shape: &ShapeReport, panel: &Panel) -> Vec<Point> {
    let radii = report.r_m.iter().map(|r| r / report.radius_m);
    radii.zip(&shape.displacement).filter_map(|(span, &value)| panel.point(span, value)).collect()
}

/// Where the line changes sides, between its root and its tip.
fn nodes(line: &[Point], panel: &Panel) -> Vec<Point> {
    let Some(zero) = panel.y.at(0.0) else { return Vec::new() };
    let mut nodes = Vec::new();
    let mut last: Option<Point> = None;
    for &(x, y) in line.iter().filter(|point| (point.1 - zero).abs() > 1e-6) {
        if let Some((before, height)) = last
            && (height - zero) * (y - zero) < 0.0
        {
            let share = (height - zero) / (height - y);
            nodes.push((before + share * (x - before), zero));
        }
        last = Some((x, y));
    }
    nodes
}

/// Places for a shape's label, with costs that rise: beyond its antinodes from the root outwards, where
/// no two modes are alike (at the tip all are), then on its line.
fn label_areas(line: &[Point], panel: &Panel, (width, height): (f64, f64), gap: f64) -> Vec<(Area, f64)> {
    let Some(zero) = panel.y.at(0.0) else { return Vec::new() };
    let centred = |x: f64, y: f64| Area {
        left: x - 0.5 * width,
        top: y - 0.5 * height,
        right: x + 0.5 * width,
        bottom: y + 0.5 * height,
    };
    let beyond = |(x, y): Point| {
        let away = if y < zero { -1.0 } else { 1.0 };
        centred(x, y + away * (gap + 0.5 * height))
    };
    let is_antinode = |trio: &&[Point]| {
        let (a, b, c) = ((trio[0].1 - zero).abs(), (trio[1].1 - zero).abs(), (trio[2].1 - zero).abs());
        b >= a && b > c && b > 0.05 * (panel.area.bottom - panel.area.top)
    };
    let mut areas: Vec<Area> = line.windows(3).filter(is_antinode).map(|trio| beyond(trio[1])).collect();
    let on_line = [10, 9, 11, 8, 12, 7, 13, 6, 14, 5].map(|share| line.get(line.len() * share / 16));
    areas.extend(on_line.into_iter().flatten().map(|&(x, y)| centred(x, y)));
    areas.into_iter().enumerate().map(|(late, area)| (area, 0.3 * late as f64)).collect()
}
