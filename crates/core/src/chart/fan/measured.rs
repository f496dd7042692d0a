//! Measured points over a fan chart.

use super::super::key::{Entry, Marker, Sign};
use super::super::line::Area;
use super::super::palette::Style;
use super::super::panel::Panel;
use super::super::sheet::{Point, Sheet};
use super::super::text;
use super::units::Units;
use crate::report::{FanChart, MeasuredPoint};
use alloc::collections::BTreeMap;
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
        let (sources, numbers) = sources(points);
        let mut measured = Self { sources, ..Self::default() };
        for (point, source) in points.iter().zip(numbers) {
            let at = units.point(panel, point.speed_rad_s, point.frequency_rad_s);
            let Some(at) = at.filter(|&at| panel.area.holds_point(at)) else {
                measured.outside += 1;
                continue;
            };
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
    let sources = sources(points).0.into_iter().enumerate();
    sources.map(|(number, source)| Entry::new(Sign::Measured(Marker::of_source(number)), source)).collect()
}

/// The sources in the order they come, and of each point the number of its source.
fn sources(points: &[MeasuredPoint]) -> (Vec<String>, Vec<usize>) {
    let mut sources: Vec<String> = Vec::new();
    let mut known: BTreeMap<String, usize> = BTreeMap::new();
    let number = |point: &MeasuredPoint| {
        let source = text::clean(&point.source);
        if let Some(&number) = known.get(&source) {
            return number;
        }
        sources.push(source.clone());
        known.insert(source, sources.len() - 1);
        sources.len() - 1
    };
    let numbers = points.iter().map(number).collect();
    (sources, numbers)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dof::Dof;
    use crate::label::Label;
    use alloc::format;

    fn points(sources: impl Iterator<Item = String>) -> Vec<MeasuredPoint> {
        let label = Label::new(Dof::Flap, 1);
        sources.map(|source| MeasuredPoint { label, speed_rad_s: 1.0, frequency_rad_s: 1.0, source }).collect()
    }

    #[test]
    fn sources_are_numbered_in_the_order_they_come() {
        let given = ["test", "a\tb", "test", "", "a b"].map(ToString::to_string);
        let (names, numbers) = sources(&points(given.into_iter()));
        assert_eq!(names, ["test", "a b", ""]);
        assert_eq!(numbers, [0, 1, 0, 2, 1]);
    }

    /// Comparing each with each took a minute.
    #[test]
    fn as_many_sources_as_points_take_no_time() {
        let points = points((0..100_000).map(|number| format!("source {number}")));
        let start = std::time::Instant::now();
        let (names, numbers) = sources(&points);
        assert_eq!((names.len(), numbers.last()), (100_000, Some(&99_999)));
        assert!(start.elapsed().as_secs() < 3, "{:?}", start.elapsed());
    }
}
