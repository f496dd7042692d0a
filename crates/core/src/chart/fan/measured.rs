//! Measured points over a fan chart.

use super::super::key::{Entry, Marker, Sign};
use super::super::line::Area;
use super::super::palette::Style;
use super::super::panel::Panel;
use super::super::sheet::{Point, Sheet};
use super::super::text;
use super::units::Units;
use crate::report::{FanChart, MeasuredPoint};
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use plotters::style::RGBColor;

/// Measured points that show, by source.
#[derive(Clone, Debug, Default)]
pub(super) struct Measured {
    /// Sources in the order they come.
    sources: Vec<String>,
    points: Vec<(Point, usize, RGBColor, String)>,
    /// How many lie outside the frame.
    pub outside: usize,
}

impl Measured {
    /// Sorts the points out by source.
    pub(super) fn of(points: &[MeasuredPoint], chart: &FanChart, panel: &Panel, units: Units, style: &Style) -> Self {
        let mut measured = Self { sources: sources(points), ..Self::default() };
        for point in points {
            let at = units.point(panel, point.speed_rad_s, point.frequency_rad_s);
            let Some(at) = at.filter(|&at| panel.area.holds_point(at)) else {
                measured.outside += 1;
                continue;
            };
            let source = text::clean(&point.source);
            let Some(source) = measured.sources.iter().position(|known| *known == source) else { continue };
            let branch = chart.branches.iter().find(|branch| branch.label == point.label);
            // A point of a branch that is not in the chart is in no branch's colour.
            let colour = branch.map_or(style.palette.nominal, |branch| style.palette.dof(branch.dof));
            measured.points.push((at, source, colour, point.label.to_string()));
        }
        measured
    }

    pub(super) fn draw(&self, sheet: &mut Sheet, style: &Style) {
        for (at, source, colour, label) in &self.points {
            let attributes = [("class", "measured"), ("data-label", label), ("data-source", &self.sources[*source])];
            sheet.layer(&attributes, &|pen| Marker::of_source(*source).draw(pen, style, *at, *colour));
        }
    }

    /// What labels must not cover.
    pub(super) fn boxes(&self, style: &Style) -> impl Iterator<Item = Area> {
        let half = 5.0 * style.unit;
        self.points.iter().map(move |&((x, y), ..)| Area {
            left: x - half,
            top: y - half,
            right: x + half,
            bottom: y + half,
        })
    }
}

/// The key's entries, one per source.
pub(super) fn entries(points: &[MeasuredPoint]) -> Vec<Entry> {
    let sources = sources(points).into_iter().enumerate();
    sources.map(|(number, source)| Entry::new(Sign::Measured(Marker::of_source(number)), source)).collect()
}

fn sources(points: &[MeasuredPoint]) -> Vec<String> {
    let mut sources: Vec<String> = Vec::new();
    for point in points {
        let source = text::clean(&point.source);
        if !sources.contains(&source) {
            sources.push(source);
        }
    }
    sources
}
