//! Per-rev rays and where they leave the frame.

use super::super::labels::{Wish, spread};
use super::super::line::{Area, clip};
use super::super::palette::Style;
use super::super::panel::{EndLabel, Panel};
use super::super::sheet::{Anchor, Face, Point, Sheet};
use super::super::text;
use super::units::Units;
use crate::report::FanChart;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

/// From the frame to the labels above it [px], room for leaders.
pub(super) const TOP_GAP: f64 = 9.0;

/// One ray in the frame.
#[derive(Clone, Debug)]
pub(super) struct Ray {
    pub harmonic: u32,
    /// Whether it is a multiple of the number of blades.
    pub blade: bool,
    /// Where it enters and leaves the frame.
    pub ends: [Point; 2],
}

impl Ray {
    pub(super) fn label(&self) -> String {
        format!("{}P", self.harmonic)
    }

    /// Multiples of the number of blades before round numbers before others.
    fn rank(&self) -> u32 {
        match self.harmonic {
            _ if self.blade => 40,
            1 => 35,
            n if n % 10 == 0 => 30,
            n if n % 5 == 0 => 20,
            _ => 10,
        }
    }
}

/// The rays 1P … nP that show.
pub(super) fn rays(chart: &FanChart, panel: &Panel, units: Units) -> Vec<Ray> {
    let axis = &panel.x.axis;
    (1..=chart.harmonics)
        .filter_map(|harmonic| {
            let frequency_at = |speed: f64| {
                let speed = units.speed_si(speed);
                units.frequency(f64::from(harmonic) * speed, speed)
            };
            let at = |speed: f64| {
                let frequency = frequency_at(speed)?;
                // Cut by value: a steep ray's far ends are beyond any whole-number pixel.
                let (bottom, top) = (panel.y.axis.from, panel.y.axis.to);
                if frequency > top {
                    return panel.point(speed * (top / frequency), top);
                }
                if frequency < bottom {
                    return panel.point(bottom / frequency_at(1.0)?, bottom);
                }
                panel.point(speed, frequency)
            };
            // On the frame's edges, which rounding must not push it over.
            let level = |speed: f64| {
                let (x, y) = panel.point(speed, f64::from(harmonic))?;
                let edges = [panel.area.top, panel.area.bottom];
                Some((x, edges.into_iter().find(|edge| (edge - y).abs() < 1e-6).unwrap_or(y)))
            };
            let ends =
                if units.per_rev() { [level(axis.from)?, level(axis.to)?] } else { [at(axis.from)?, at(axis.to)?] };
            let inside = clip(&ends, &panel.area).pop()?;
            let ends = [*inside.first()?, *inside.last()?];
            if ends[1].0 - ends[0].0 < 0.5 {
                return None;
            }
            let blade = chart.blades.is_some_and(|blades| blades > 0 && harmonic % blades == 0);
            Some(Ray { harmonic, blade, ends })
        })
        .collect()
}

/// Draws the rays, those of the number of blades last.
pub(super) fn draw(sheet: &mut Sheet, style: &Style, rays: &[Ray]) {
    let palette = &style.palette;
    for (class, blade, colour, width) in
        [("ray", false, palette.ray, 0.9), ("ray blade-ray", true, palette.blade_ray, 1.2)]
    {
        sheet.layer(&[("class", class)], &|pen| {
            for ray in rays.iter().filter(|ray| ray.blade == blade) {
                pen.line(&ray.ends, colour, width * style.unit);
            }
        });
    }
}

/// Labels of the rays that leave through the right side.
pub(super) fn end_labels(style: &Style, area: &Area, rays: &[Ray]) -> Vec<EndLabel> {
    let leaving = rays.iter().filter(|ray| ray.ends[1].0 > area.right - 0.5);
    leaving
        .map(|ray| EndLabel {
            text: ray.label(),
            from: area.right,
            target: ray.ends[1].1,
            colour: if ray.blade { style.palette.nominal } else { style.palette.muted },
            bold: false,
            rank: ray.rank(),
            limit: 26.0 * style.unit,
            class: "ray-label",
        })
        .collect()
}

/// Labels above the frame: rays that leave through the top, and branches that do.
pub(super) fn draw_top_labels(
    sheet: &mut Sheet,
    style: &Style,
    area: &Area,
    rays: &[Ray],
    branches: &[(Point, EndLabel)],
) {
    let leaving = rays.iter().filter(|ray| ray.ends[1].0 <= area.right - 0.5 && ray.ends[1].1 < area.top + 0.5);
    let labels: Vec<(f64, String, Face, u32, &str)> = leaving
        .map(|ray| {
            let colour = if ray.blade { style.palette.nominal } else { style.palette.muted };
            (ray.ends[1].0, ray.label(), Face::new(style.small(), colour, Anchor::Middle), ray.rank(), "ray-label")
        })
        .chain(branches.iter().map(|(at, label)| {
            let face = Face::new(style.tick(), label.colour, Anchor::Middle).bold();
            (at.0, label.text.clone(), face, label.rank, label.class)
        }))
        .collect();
    let wishes: Vec<Wish> = labels
        .iter()
        .map(|(x, label, face, rank, _)| Wish {
            target: *x,
            size: text::width(label, face.size, face.bold) + 5.0 * style.unit,
            limit: 40.0 * style.unit,
            rank: *rank,
        })
        .collect();
    // The corner to the right belongs to the labels there.
    let places = spread(&wishes, area.left, area.right + 4.0 * style.unit);
    for ((target, label, face, _, class), place) in labels.iter().zip(places) {
        let Some(x) = place else { continue };
        let foot = area.top - TOP_GAP * style.unit;
        sheet.layer(&[("class", class), ("data-label", label)], &|pen| {
            if (x - target).abs() > 1.0 {
                let bend = [(*target, area.top - 1.0), (x, foot + 1.5 * style.unit)];
                pen.line(&bend, style.palette.tone(face.colour, 0.6), 0.8);
            }
            pen.text((x, foot), label, face);
        });
    }
}
