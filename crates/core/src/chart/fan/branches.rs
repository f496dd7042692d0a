//! Branches in the frame, and their labels.

use super::super::labels::Obstacles;
use super::super::line::{Area, clip, thin};
use super::super::palette::{Style, dashes};
use super::super::panel::{EndLabel, Panel};
use super::super::sheet::{Anchor, Face, Point, Sheet, dash_array};
use super::super::text;
use super::crossings::draw_haloed;
use super::units::Units;
use crate::dof::Dof;
use crate::numerics::scalar::{maximum, sqrt};
use crate::report::{Branch, FanChart};
use alloc::string::ToString;
use alloc::vec::Vec;

/// Per revolution a branch is drawn with about so many points, however few speeds there are.
const PER_REV_POINTS: usize = 2000;
/// And from rest to the first speed with so many.
const PER_REV_FIRST: usize = 32;

/// A branch laid out: its lines inside the frame.
#[derive(Clone, Debug)]
pub(super) struct Curve<'a> {
    pub branch: &'a Branch,
    pub parts: Vec<Vec<Point>>,
    /// The leading motion of each part.
    pub dofs: Vec<Dof>,
}

/// Where a branch ends in the frame.
#[derive(Clone, Debug)]
pub(super) enum End {
    Right(EndLabel),
    Top(Point, EndLabel),
    /// At the lower edge, or where its frequencies end.
    Inside(Point, EndLabel),
}

/// The lines of a branch; where a frequency is not a number, there is a gap.
pub(super) fn lay_out<'a>(branch: &'a Branch, chart: &FanChart, panel: &Panel, units: Units) -> Curve<'a> {
    let mut parts = Vec::new();
    let mut dofs = Vec::new();
    let mut run: Vec<Point> = Vec::new();
    let mut end = |run: &mut Vec<Point>, dof: Dof| {
        parts.extend(clip(&thin(run), &panel.area));
        dofs.resize(parts.len(), dof);
        run.clear();
    };
    let mut leading = branch.dof;
    let mut before: Option<(f64, f64)> = None;
    let steps = PER_REV_POINTS / chart.speeds_rad_s.len().max(1);
    for (&speed, &frequency) in chart.speeds_rad_s.iter().zip(&branch.frequency_rad_s) {
        if let Some(before) = before.filter(|_| units.per_rev()) {
            run.extend(between(before, (speed, frequency), steps).filter_map(|(s, f)| units.point(panel, s, f)));
        }
        before = frequency.is_finite().then_some((speed, frequency));
        let point = units.point(panel, speed, frequency);
        run.extend(point);
        let here = branch.dof_at(speed);
        if point.is_none() || here != leading {
            end(&mut run, leading);
            // The next part begins where the motion changes.
            run.extend(point);
            leading = here;
        }
    }
    end(&mut run, leading);
    Curve { branch, parts, dofs }
}

/// Points of a branch between two speeds. ω² is nearly straight over Ω² (Southwell), ω/Ω over Ω is
/// not, least of all near rest, where it comes from infinity.
fn between(from: (f64, f64), to: (f64, f64), steps: usize) -> impl Iterator<Item = (f64, f64)> {
    let steps = if from.0 > 0.0 { steps } else { steps.max(PER_REV_FIRST) };
    let square = |at: (f64, f64)| (at.0 * at.0, at.1 * at.1);
    let (a, b) = (square(from), square(to));
    let usable = a.1.is_finite() && b.1.is_finite() && b.0 > a.0;
    (0..steps).filter(move |_| usable).map(move |step| {
        // From rest as near to it as to be out of any frame, or on it where the frequency is 0 there.
        let share = if step == 0 { 1e-6 } else { step as f64 / steps as f64 };
        let speed = from.0 + (to.0 - from.0) * share;
        let along = (speed * speed - a.0) / (b.0 - a.0);
        (speed, sqrt(maximum(a.1 + along * (b.1 - a.1), 0.0)))
    })
}

pub(super) fn draw(sheet: &mut Sheet, style: &Style, curve: &Curve) {
    let branch = curve.branch;
    let label = branch.label.to_string();
    // One layer for each run of parts with one leading motion.
    let mut first = 0;
    while let Some(&dof) = curve.dofs.get(first) {
        let count = curve.dofs[first..].iter().take_while(|next| **next == dof).count();
        let (dash, class) = (dash_array(dashes(dof), style.unit), alloc::format!("branch {dof}"));
        let attributes =
            [("class", class.as_str()), ("data-label", label.as_str()), ("stroke-dasharray", dash.as_str())];
        sheet.layer(&attributes, &|pen| {
            for part in &curve.parts[first..first + count] {
                pen.line(part, style.palette.dof(dof), 2.0 * style.unit);
            }
        });
        first += count;
    }
}

/// Where a branch ends in the frame, and its label there.
pub(super) fn end_of(curve: &Curve, style: &Style, area: &Area) -> Option<End> {
    let at = *curve.parts.last()?.last()?;
    let number = curve.branch.number;
    let rank = match number {
        1 => 90,
        n if n % 10 == 0 => 80,
        n if n % 5 == 0 => 70,
        _ => 60,
    };
    let label = EndLabel {
        text: curve.branch.label.to_string(),
        from: at.0,
        target: at.1,
        // The label is that at nominal speed, and so is its colour.
        colour: style.palette.dof(curve.branch.dof),
        bold: true,
        rank,
        limit: f64::INFINITY,
        class: "branch-label",
    };
    Some(if at.0 > area.right - 1.0 {
        End::Right(label)
    } else if at.1 <= area.top + 1.0 {
        End::Top(at, label)
    } else {
        End::Inside(at, label)
    })
}

/// Labels of branches that end within the frame or at its lower edge, where they hide least.
pub(super) fn draw_inside(sheet: &mut Sheet, style: &Style, ends: &[(Point, EndLabel)], obstacles: &mut Obstacles) {
    for (at, label) in ends {
        let face = Face::new(style.tick(), label.colour, Anchor::Middle).bold();
        let size = (text::width(&label.text, face.size, true) + 4.0 * style.unit, 1.15 * face.size);
        let distances = [3.0, 9.0, 18.0].map(|distance| distance * style.unit);
        let Some(area) = obstacles.place(*at, size, &distances) else { continue };
        let middle = (0.5 * (area.left + area.right), 0.5 * (area.top + area.bottom) + face.drop());
        draw_haloed(sheet, style, (label.class, &label.text), middle, &label.text, &face);
    }
}
