//! Labels of crossings: each tells which circle it names.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop")]

use crate::blade::{BladeDefinition, Property, RootDefinition, check};
use crate::chart::line::{Area, distance};
use crate::chart::tests::{self as drawn, BRANCHES};
use crate::chart::{ChartOptions, Drawing, FrequencyUnit, fan, text};
use crate::dof::Dof;
use crate::label::Label;
use crate::report::{Crossing, FanChart};
use crate::{Settings, analysis};
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use proptest::prelude::*;
use roxmltree::{Document, Node};

type Point = (f64, f64);

/// A crossing as it is drawn [px].
#[derive(Debug)]
struct Drawn {
    name: String,
    centre: Point,
    radius: f64,
    label: Option<Area>,
    /// From the circle to the label.
    leader: Option<[Point; 2]>,
}

fn away(area: &Area, point: Point) -> f64 {
    distance(area.nearest(point), point)
}

/// Points on a line, near enough to each other to miss nothing.
fn along([from, to]: [Point; 2]) -> impl Iterator<Item = Point> {
    let at = move |share: f64| (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1));
    (0..=200).map(move |step| at(f64::from(step) / 200.0))
}

fn crossings_of(drawing: &Drawing) -> Vec<Drawn> {
    let document = Document::parse(&drawing.svg).unwrap();
    let of_class = |class: &'static str| {
        document.descendants().filter(move |node| node.attribute("class") == Some(class)).collect::<Vec<Node>>()
    };
    let number = |node: &Node, name: &str| drawn::number(node, name) / 10.0;
    let (labels, leaders) = (of_class("crossing-label"), of_class("crossing-leader"));
    let crossings = of_class("crossing").into_iter().map(|group| {
        let name = group.attribute("data-crossing").unwrap();
        let circle = group.children().rfind(|node| node.has_tag_name("circle")).unwrap();
        let text = labels
            .iter()
            .flat_map(Node::children)
            .find(|node| node.has_tag_name("text") && node.text().unwrap().trim() == name);
        let label = text.map(|text| {
            let (x, y, size) = (number(&text, "x"), number(&text, "y"), number(&text, "font-size"));
            // From the top of the line to the middle of its digits; the box is a bit larger than the text.
            let middle = y + (0.76 - 0.36) * size;
            let (width, height) = (text::width(name, size, false) + 4.0 / 11.0 * size, 1.15 * size);
            Area {
                left: x - 0.5 * width,
                top: middle - 0.5 * height,
                right: x + 0.5 * width,
                bottom: middle + 0.5 * height,
            }
        });
        let leader = leaders.iter().find(|group| group.attribute("data-crossing") == Some(name)).map(|group| {
            let line = group.children().rfind(|node| node.has_tag_name("polyline")).unwrap();
            let points: Vec<Point> = line.attribute("points").unwrap().split_whitespace().map(point).collect();
            [points[0], *points.last().unwrap()]
        });
        Drawn {
            name: name.to_string(),
            centre: (number(&circle, "cx"), number(&circle, "cy")),
            radius: number(&circle, "r"),
            label,
            leader,
        }
    });
    crossings.collect()
}

fn point(text: &str) -> Point {
    let (x, y) = text.split_once(',').unwrap();
    (x.parse::<f64>().unwrap() / 10.0, y.parse::<f64>().unwrap() / 10.0)
}

/// What is wrong with the labels of a drawing's crossings.
fn faults(drawing: &Drawing) -> Vec<String> {
    let plot = &drawing.plots[0];
    let frame = Area { left: plot.left, top: plot.top, right: plot.left + plot.width, bottom: plot.top + plot.height };
    let crossings = crossings_of(drawing);
    let mut faults = Vec::new();
    for (at, crossing) in crossings.iter().enumerate() {
        let others = || crossings.iter().enumerate().filter(move |(other, _)| *other != at).map(|(_, other)| other);
        let mut fault = |what: String| faults.push(format!("{}: {what}", crossing.name));
        let Some(area) = crossing.label else {
            if crossing.leader.is_some() {
                fault("a leader to no label".to_string());
            }
            continue;
        };
        // A tenth of a pixel is drawn.
        let grown =
            Area { left: frame.left - 0.2, top: frame.top - 0.2, right: frame.right + 0.2, bottom: frame.bottom + 0.2 };
        if !grown.holds(&area) {
            fault(format!("{area:?} leaves the frame"));
        }
        for other in &crossings {
            if away(&area, other.centre) < other.radius {
                fault(format!("covers the circle of {}", other.name));
            }
        }
        for other in others() {
            let within = |label: &Area| {
                label.left < area.right - 0.2
                    && area.left < label.right - 0.2
                    && label.top < area.bottom - 0.2
                    && area.top < label.bottom - 0.2
            };
            if other.label.as_ref().is_some_and(within) {
                fault(format!("covers the label of {}", other.name));
            }
        }
        let Some(leader) = crossing.leader else {
            let own = away(&area, crossing.centre);
            for other in others().filter(|other| 1.5 * own > away(&area, other.centre) + 0.3) {
                fault(format!("{own:.1} px away, {} {:.1}", other.name, away(&area, other.centre)));
            }
            continue;
        };
        let start = distance(leader[0], crossing.centre);
        if (start - crossing.radius).abs() > 0.2 * crossing.radius || away(&area, leader[1]) > 0.3 {
            fault(format!("{leader:?} does not lead from the circle to the label {area:?}"));
        }
        for other in others() {
            let apart = distance(other.centre, crossing.centre);
            let from = |point: Point| distance(point, other.centre);
            // Circles on one another share what leads to them; what is drawn is rounded to tenths.
            if apart > 1.15 && (along(leader).any(|point| from(point) < other.radius) || from(leader[0]) < start) {
                fault(format!("its leader touches the circle of {}", other.name));
            }
            let inner = other.label.map(|label| Area {
                left: label.left + 0.2,
                top: label.top + 0.2,
                right: label.right - 0.2,
                bottom: label.bottom - 0.2,
            });
            if inner.is_some_and(|label| along(leader).any(|point| label.holds_point(point))) {
                fault(format!("its leader crosses the label of {}", other.name));
            }
        }
    }
    faults
}

fn look(width: u32, frequency_unit: FrequencyUnit) -> ChartOptions<'static> {
    ChartOptions { width, frequency_unit, ..Default::default() }
}

/// An articulated blade of which the third flap, second lag and first torsion frequency meet 5P near
/// nominal speed, as on a UH-60A.
fn articulated(flap: f64, torsion: f64, inertia: f64) -> FanChart {
    let blade = BladeDefinition::new("articulated", 8.0, 27.0)
        .with_flap(RootDefinition::hinged(0.4))
        .with_lag(RootDefinition::hinged(0.4))
        .with_torsion(RootDefinition::rigid(0.4))
        .with(Property::Mass, 10.0)
        .with(Property::FlapStiffness, flap)
        .with(Property::LagStiffness, 2.0e6)
        .with(Property::TorsionStiffness, torsion)
        .with(Property::PolarInertia, inertia);
    analysis::fan(&check(&blade).unwrap(), &Settings::default()).unwrap()
}

#[test]
fn labels_of_crossings_close_together_name_their_own() {
    for (flap, torsion, inertia) in [(6.5e4, 7.0e4, 0.15), (7.0e4, 7.0e4, 0.16), (6.0e4, 6.8e4, 0.17)] {
        let chart = articulated(flap, torsion, inertia);
        for width in [390, 600, 900, 960, 1600, 3000] {
            for unit in FrequencyUnit::ALL {
                let drawing = fan(&chart, &look(width, unit));
                let what = format!("{flap} at {width} px in {}", unit.name());
                drawn::check(&drawing, &what);
                assert_eq!(faults(&drawing), Vec::<String>::new(), "{what}");
                let crossings = crossings_of(&drawing);
                let close: Vec<&Drawn> = crossings.iter().filter(|at| at.name.ends_with("5P")).collect();
                assert_eq!(close.len(), 3, "{what}: {crossings:?}");
                assert!(close.iter().all(|at| at.label.is_some()), "{what}: not all are named: {crossings:?}");
            }
        }
    }
}

/// A chart with crossings wherever they are put: parts of the band and of the lowest 600 rad/s.
fn made_up(places: &[Point]) -> FanChart {
    let mut chart = drawn::chart(&BRANCHES, 21, 10);
    let crossing = |(number, &(along, up)): (usize, &Point)| Crossing {
        label: Label::new(Dof::ALL[number % 3], 1 + number / 3),
        // None of the chart's own: each has a name of its own.
        branch: usize::MAX,
        harmonic: 1 + number as u32 % 10,
        speed_rad_s: 69.1 * (0.9 + 0.2 * along),
        frequency_rad_s: 600.0 * up,
    };
    chart.crossings = places.iter().enumerate().map(crossing).collect();
    chart
}

/// Crowds: places around a few centres, some on one another.
fn crowds() -> impl Strategy<Value = Vec<Point>> {
    let centres = prop::collection::vec((0.0..=1.0, 0.0..=1.0), 1..4);
    let widths = prop_oneof![Just(0.0), 0.0..0.1, 0.0..0.4];
    let members = prop::collection::vec((0usize..3, -1.0..1.0, -0.3..0.3), 1..=14);
    (centres, widths, members).prop_map(|(centres, width, members): (Vec<Point>, f64, Vec<(usize, f64, f64)>)| {
        let place = |(crowd, along, up): (usize, f64, f64)| {
            let centre = centres[crowd % centres.len()];
            ((centre.0 + width * along).clamp(0.001, 0.999), (centre.1 + width * up).clamp(0.0, 1.0))
        };
        members.into_iter().map(place).collect()
    })
}

proptest! {
    #[test]
    fn labels_of_made_up_crossings_name_their_own(
        places in crowds(),
        width in prop::sample::select(&[320, 600, 960, 1600][..]),
        unit in prop::sample::select(&FrequencyUnit::ALL[..]),
    ) {
        let drawing = fan(&made_up(&places), &look(width, unit));
        drawn::check(&drawing, "made up");
        prop_assert_eq!(faults(&drawing), Vec::<String>::new());
    }
}

#[test]
fn a_crossing_alone_has_no_leader_and_two_on_one_another_have_one_each() {
    let leaders = |places: &[Point]| -> Vec<bool> {
        let drawing = fan(&made_up(places), &look(960, FrequencyUnit::RadS));
        let crossings = crossings_of(&drawing);
        assert!(crossings.iter().all(|at| at.label.is_some()), "{crossings:?}");
        crossings.iter().map(|at| at.leader.is_some()).collect()
    };
    assert_eq!(leaders(&[(0.5, 0.5)]), [false]);
    assert_eq!(leaders(&[(0.2, 0.3), (0.8, 0.7)]), [false, false]);
    assert_eq!(leaders(&[(0.5, 0.5), (0.5, 0.5)]), [true, true]);
}
