//! Whole drawings: well-formed, complete, and no text over another.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop")]

use super::line::Area;
use super::{ChartOptions, Drawing, FrequencyUnit, Theme, converge, fan, parse_frequencies, shapes, text};
use crate::analysis::MODEL;
use crate::dof::Dof;
use crate::functions::BasisFamily;
use crate::label::Label;
use crate::numerics::scalar::{sin_cos, sqrt};
use crate::report::{
    BasisReport, Branch, Coincidence, ConvergeReport, ConvergeSeries, Crossing, FanChart, FunctionCounts,
    MeasuredPoint, ModelReport, Nominal, ShapeReport, ShapesReport, Southwell,
};
use crate::units::SpeedUnit;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;
use roxmltree::{Document, Node};

/// Roughly the TM 4760 blade [rad/s]: frequency at rest, and at 69.1 rad/s.
pub(super) const BRANCHES: [(Dof, f64, f64); 9] = [
    (Dof::Flap, 0.0, 72.3),
    (Dof::Flap, 72.4, 185.9),
    (Dof::Flap, 228.6, 349.8),
    (Dof::Flap, 483.0, 608.5),
    (Dof::Lag, 9.6, 23.3),
    (Dof::Lag, 267.8, 310.6),
    (Dof::Lag, 810.0, 850.0),
    (Dof::Torsion, 645.0, 645.0),
    (Dof::Torsion, 1844.0, 1844.0),
];

fn basis() -> BasisReport {
    let functions = FunctionCounts { flap: Some(15), lag: Some(15), torsion: Some(12) };
    BasisReport { family: BasisFamily::Classical, functions }
}

fn numbered<T: Copy>(list: &[(Dof, T, T)]) -> Vec<(Dof, usize, T, T)> {
    let number = |at: usize| list[..=at].iter().filter(|entry| entry.0 == list[at].0).count();
    list.iter().enumerate().map(|(at, &(dof, a, b))| (dof, number(at), a, b)).collect()
}

pub(super) fn chart(branches: &[(Dof, f64, f64)], speeds: usize, harmonics: u32) -> FanChart {
    let nominal = 69.1;
    let speeds: Vec<f64> = (0..speeds).map(|at| 1.2 * nominal * at as f64 / (speeds - 1) as f64).collect();
    let branches: Vec<Branch> = numbered(branches)
        .into_iter()
        .map(|(dof, number, rest, turning)| {
            let k1 = (turning * turning - rest * rest) / (nominal * nominal);
            let frequency_rad_s = speeds.iter().map(|speed| sqrt(rest * rest + k1 * speed * speed)).collect();
            let southwell = Southwell { k0: rest * rest, k1 };
            Branch {
                label: Label::new(dof, number),
                dof,
                number,
                frequency_rad_s,
                southwell,
                labels: Vec::new(),
                lower_rad_s: Vec::new(),
                upper_rad_s: Vec::new(),
            }
        })
        .collect();
    let crossings = branches
        .iter()
        .enumerate()
        .flat_map(|branch| (1..=harmonics).map(move |harmonic| (branch, harmonic)))
        .filter_map(|((index, branch), harmonic)| {
            let below = f64::from(harmonic * harmonic) - branch.southwell.k1;
            let speed_rad_s = sqrt(branch.southwell.k0 / below.max(1e-9));
            let frequency_rad_s = f64::from(harmonic) * speed_rad_s;
            let met = speed_rad_s > 0.0 && speed_rad_s < 1.2 * nominal;
            met.then_some(Crossing { label: branch.label, branch: index, harmonic, speed_rad_s, frequency_rad_s })
        })
        .collect();
    FanChart {
        schema: "bladefan-fan/1",
        blade: "TM 4760 research blade".to_string(),
        blades: Some(4),
        harmonics,
        basis: basis(),
        speeds_rad_s: speeds,
        branches,
        crossings,
        coincident: vec![Coincidence { label: Label::new(Dof::Flap, 1), branch: 0, harmonic: 1 }],
        nominal: Nominal { speed_rad_s: nominal, margins: Vec::new() },
        warnings: Vec::new(),
        model: model(),
        veerings: Vec::new(),
    }
}

fn model() -> ModelReport {
    ModelReport::uncoupled(MODEL, "paper", Vec::new())
}

fn many_branches(each: u32) -> Vec<(Dof, f64, f64)> {
    let of = |dof: Dof, first: f64| {
        (1..=each).map(f64::from).map(move |n| (dof, first * (n - 0.5) * (n - 0.5), first * n * n + 70.0 * n))
    };
    of(Dof::Flap, 11.0).chain(of(Dof::Lag, 30.0)).chain(of(Dof::Torsion, 90.0)).collect()
}

fn shape_report(modes: usize) -> ShapesReport {
    let r_m: Vec<f64> = (0..=100).map(|at| 0.0762 + 1.3208 * f64::from(at) / 100.0).collect();
    let shape = |dof: Dof, number: usize| {
        let wave = |at: usize| sin_cos((number as f64 - 0.5) * core::f64::consts::PI * at as f64 / 100.0).0;
        let sign = if number % 2 == 1 { 1.0 } else { -1.0 };
        let displacement = (0..=100).map(|at| sign * wave(at)).collect();
        let (slope, moment) = (Vec::new(), Vec::new());
        ShapeReport {
            label: Label::new(dof, number),
            dof,
            number,
            frequency_rad_s: 1.0,
            orthogonality: 0.0,
            nodes_m: Vec::new(),
            displacement,
            slope,
            moment,
        }
    };
    let shapes = Dof::ALL.into_iter().flat_map(|dof| (1..=modes).map(move |number| shape(dof, number))).collect();
    ShapesReport {
        schema: "bladefan-shapes/1",
        blade: "TM 4760 research blade".to_string(),
        speed_rad_s: 69.1,
        model: model(),
        basis: basis(),
        r_m,
        radius_m: 1.397,
        shapes,
        warnings: Vec::new(),
    }
}

fn converge_report(known: bool) -> ConvergeReport {
    let series = numbered(&BRANCHES)
        .into_iter()
        .map(|(dof, number, rest, turning)| {
            let excess = |count: usize| 0.01 / ((count * count * count) as f64) * (1.0 + rest / 500.0);
            let value = |count: usize| (count >= number).then(|| turning * (1.0 + excess(count)));
            let classical_rad_s = (1..=16).map(value).collect();
            let converged_rad_s = known.then_some(turning);
            let piecewise_functions = vec![17, 33, 50, 66, 83, 99];
            let values = (1..=6).map(|order: i32| Some(turning * (1.0 + 0.1 / 100_f64.powi(order))));
            ConvergeSeries {
                label: Label::new(dof, number),
                dof,
                number,
                classical_rad_s,
                converged_rad_s,
                lower_rad_s: converged_rad_s,
                upper_rad_s: converged_rad_s,
                piecewise_functions,
                piecewise_rad_s: values.collect(),
            }
        })
        .collect();
    ConvergeReport {
        schema: "bladefan-converge/1",
        blade: "TM 4760 research blade".to_string(),
        speed_rad_s: 69.1,
        model: model(),
        functions: (1..=16).collect(),
        series,
        warnings: Vec::new(),
    }
}

pub(super) fn measured() -> Vec<MeasuredPoint> {
    let point = |label: &str, source: &str, frequency_rad_s: f64| MeasuredPoint {
        label: label.parse().unwrap(),
        speed_rad_s: 69.1,
        frequency_rad_s,
        source: source.to_string(),
    };
    vec![
        point("2F", "test", 180.0),
        point("1T", "test", 600.0),
        point("2F", "MBDyn", 185.7),
        point("9T", "test", 400.0),
    ]
}

pub(super) fn number(node: &Node, name: &str) -> f64 {
    node.attribute(name).unwrap().parse().unwrap()
}

/// The boxes of all texts, in tenths of a pixel.
pub(super) fn text_boxes(document: &Document) -> Vec<(Area, String)> {
    let texts = document.descendants().filter(|node| node.has_tag_name("text"));
    texts
        .map(|node| {
            let content = node.text().unwrap_or_default().trim().to_string();
            let size = number(&node, "font-size");
            let bold = node.attribute("font-weight").is_some();
            // Without the spare room of the table: the letters themselves.
            let width = text::width(&content, size, bold) / 1.06;
            let (x, y) = (number(&node, "x"), number(&node, "y"));
            assert_eq!(node.attribute("dy"), Some("0.76em"));
            let before = match node.attribute("text-anchor") {
                Some("middle") => 0.5 * width,
                Some("end") => width,
                _ => 0.0,
            };
            // From the top of capitals to the baseline.
            let (high, low) = (0.05 * size, 0.76 * size);
            let area = if node.attribute("transform").is_some() {
                Area { left: x + high, right: x + low, top: y + before - width, bottom: y + before }
            } else {
                Area { left: x - before, right: x - before + width, top: y + high, bottom: y + low }
            };
            (area, content)
        })
        .collect()
}

/// Checks what holds of every drawing.
pub(super) fn check(drawing: &Drawing, what: &str) {
    let document = Document::parse(&drawing.svg).unwrap_or_else(|error| panic!("{what}: {error}"));
    for node in document.descendants() {
        for attribute in node.attributes() {
            let value = attribute.value();
            assert!(!value.contains("NaN") && !value.contains("inf"), "{what}: {attribute:?}");
        }
    }
    let root = document.root_element();
    assert_eq!(root.attribute("viewBox").unwrap(), format!("0 0 {} {}", drawing.width, drawing.height));
    assert!(root.children().any(|node| node.has_tag_name("title")), "{what}: no title");
    let sheet = Area { left: 0.0, top: 0.0, right: 10.0 * drawing.width, bottom: 10.0 * drawing.height };
    let boxes = text_boxes(&document);
    for (at, (area, content)) in boxes.iter().enumerate() {
        assert!(sheet.holds(area), "{what}: {content} at {area:?} leaves the sheet {sheet:?}");
        let other = boxes[..at].iter().find(|(other, _)| other.overlaps(area));
        assert!(other.is_none(), "{what}: {content} covers {other:?}");
    }
    for plot in &drawing.plots {
        assert!(plot.width > 0.0 && plot.height > 0.0 && plot.x.from < plot.x.to && plot.y.from < plot.y.to);
    }
}

pub(super) fn groups(drawing: &Drawing, class: &str) -> Vec<String> {
    let document = Document::parse(&drawing.svg).unwrap();
    let of_class = |node: &Node| node.attribute("class").is_some_and(|classes| classes.split(' ').any(|c| c == class));
    let labels = document.descendants().filter(of_class);
    labels.map(|node| node.attribute("data-label").unwrap_or_default().to_string()).collect()
}

fn each_look(draw: impl Fn(&ChartOptions, &str)) {
    let points = measured();
    for width in [0, 600, 960, 1600, 8000] {
        for (frequency_unit, theme) in FrequencyUnit::ALL.into_iter().zip(Theme::ALL.into_iter().cycle()) {
            let options = ChartOptions { theme, width, frequency_unit, measured: &points, ..Default::default() };
            draw(&options, &format!("{width} {} {}", theme.name(), frequency_unit.name()));
        }
    }
}

#[test]
fn fan_charts_hold_up_in_every_look_and_size() {
    let charts = [
        chart(&BRANCHES, 101, 10),
        chart(&BRANCHES[..1], 101, 10),
        chart(&BRANCHES, 2, 10),
        chart(&BRANCHES, 101, 100),
        chart(&many_branches(50), 101, 10),
        chart(&many_branches(50), 11, 100),
        chart(&[(Dof::Flap, 0.0, 0.0), (Dof::Lag, 0.0, 0.0)], 101, 10),
        chart(&[], 101, 10),
    ];
    each_look(|options, look| {
        for (number, chart) in charts.iter().enumerate() {
            check(&fan(chart, options), &format!("chart {number} {look}"));
        }
    });
}

#[test]
fn a_fan_chart_has_every_branch_ray_and_crossing() {
    let chart = chart(&BRANCHES, 101, 10);
    let points = measured();
    let drawing = fan(&chart, &ChartOptions { measured: &points, ..Default::default() });
    let mut shown = groups(&drawing, "branch-label");
    shown.sort();
    assert_eq!(shown, ["1F", "1L", "1T", "2F", "2L", "3F", "3L", "4F"]);
    assert_eq!(groups(&drawing, "branch").len(), 8);
    assert_eq!(groups(&drawing, "ray-label").len(), 10);
    let inside = |crossing: &&Crossing| (0.9..=1.1).contains(&(crossing.speed_rad_s / 69.1));
    assert_eq!(groups(&drawing, "crossing").len(), chart.crossings.iter().filter(inside).count());
    assert_eq!(groups(&drawing, "measured").len(), 4);
    for said in ["1F lies on 1P", "above the chart: 2T", "15 flap, 15 lag, 12 torsion", "nominal 659.9 rpm"] {
        assert!(drawing.svg.contains(said), "{said}");
    }
}

#[test]
fn axes_lie_where_the_drawing_says() {
    let chart = chart(&BRANCHES, 101, 10);
    let drawing = fan(&chart, &ChartOptions { speed_unit: SpeedUnit::RadianPerSecond, ..Default::default() });
    let plot = &drawing.plots[0];
    assert!(plot.x.from.abs() < 1e-12 && (plot.x.to - 1.2 * 69.1).abs() < 1e-9, "{:?}", plot.x);
    let document = Document::parse(&drawing.svg).unwrap();
    let circles = document.descendants().filter(|node| node.attribute("data-crossing") == Some("3F × 5P"));
    let circle = circles.flat_map(|node| node.children()).find(|node| node.has_tag_name("circle")).unwrap();
    let crossing = chart
        .crossings
        .iter()
        .find(|crossing| crossing.label == Label::new(Dof::Flap, 3) && crossing.harmonic == 5)
        .unwrap();
    let x = plot.left + plot.width * (crossing.speed_rad_s - plot.x.from) / (plot.x.to - plot.x.from);
    let y = plot.top + plot.height * (1.0 - crossing.frequency_rad_s / plot.y.to);
    assert!((number(&circle, "cx") / 10.0 - x).abs() < 0.06, "{x}");
    assert!((number(&circle, "cy") / 10.0 - y).abs() < 0.06, "{y}");
}

/// Where a crossing's circle is [px].
fn circle_of(drawing: &Drawing, crossing: &str) -> (f64, f64) {
    let document = Document::parse(&drawing.svg).unwrap();
    let circles = document.descendants().filter(|node| node.attribute("data-crossing") == Some(crossing));
    let circle = circles.flat_map(|node| node.children()).find(|node| node.has_tag_name("circle")).unwrap();
    (number(&circle, "cx") / 10.0, number(&circle, "cy") / 10.0)
}

/// All points [px] of the lines of a class.
fn points_of(drawing: &Drawing, class: &str, label: Option<&str>) -> Vec<(f64, f64)> {
    let document = Document::parse(&drawing.svg).unwrap();
    let wanted = |node: &Node| {
        node.attribute("class").is_some_and(|classes| classes.split(' ').any(|c| c == class))
            && label.is_none_or(|label| node.attribute("data-label") == Some(label))
    };
    let lines = document.descendants().filter(wanted).flat_map(|node| node.children());
    let lines: Vec<&str> = lines.filter_map(|line| line.attribute("points")).collect();
    let pair = |pair: &str| {
        let (x, y) = pair.split_once(',').unwrap();
        (x.parse::<f64>().unwrap() / 10.0, y.parse::<f64>().unwrap() / 10.0)
    };
    lines.into_iter().flat_map(|line| line.split_whitespace().map(pair).collect::<Vec<_>>()).collect()
}

#[test]
fn per_revolution_rays_are_level_and_crossings_lie_on_them() {
    let chart = FanChart { blades: None, ..chart(&BRANCHES, 101, 10) };
    let options = ChartOptions { frequency_unit: FrequencyUnit::PerRev, ..Default::default() };
    let drawing = fan(&chart, &options);
    check(&drawing, "per rev");
    let plot = &drawing.plots[0];
    assert_eq!((plot.y.from, plot.y.to, plot.y.unit), (0.0, 10.4, "/rev"));
    assert!(drawing.svg.contains("frequency [/rev]"), "axis name");
    let height = |value: f64| plot.top + plot.height * (1.0 - value / plot.y.to);
    let rays = points_of(&drawing, "ray", None);
    assert_eq!(rays.len(), 20);
    for (harmonic, pair) in (1..).zip(rays.chunks(2)) {
        assert!((pair[0].0 - plot.left).abs() < 0.06 && (pair[1].0 - plot.left - plot.width).abs() < 0.06, "{pair:?}");
        assert!(pair.iter().all(|point| (point.1 - height(f64::from(harmonic))).abs() < 0.06), "{harmonic}: {pair:?}");
    }
    assert_eq!(groups(&drawing, "ray-label").len(), 10);
    let (_, y) = circle_of(&drawing, "3F × 5P");
    assert!((y - height(5.0)).abs() < 0.06, "{y}");
    // 1F goes with the rotor from the first speed on; 2F comes in through the top.
    let first = points_of(&drawing, "branch", Some("1F"));
    assert!(first[0].0 < plot.left + 0.1 && first.iter().all(|point| (point.1 - height(72.3 / 69.1)).abs() < 0.2));
    let second = points_of(&drawing, "branch", Some("2F"));
    assert!((second[0].1 - plot.top).abs() < 0.1 && second[0].0 > plot.left + 10.0, "{:?}", second[0]);
    // With few speeds the curve is the same, not a chain of straight pieces.
    let few = fan(&super::tests::chart(&BRANCHES, 3, 10), &options);
    let few = points_of(&few, "branch", Some("2F"));
    assert!((few[0].0 - second[0].0).abs() < 0.5 && few.len() > 10, "{:?} {:?}", few[0], second[0]);
}

#[test]
fn a_range_of_frequencies_is_shown_exactly_and_holds_all_lines() {
    let points = measured();
    for (frequency_unit, window) in [
        (FrequencyUnit::RadS, (100.0, 400.0)),
        (FrequencyUnit::RadS, (349.0, 351.0)),
        (FrequencyUnit::Hz, (0.0, 1e6)),
        (FrequencyUnit::Rpm, (0.0, 900.0)),
        (FrequencyUnit::PerRev, (2.0, 6.0)),
        (FrequencyUnit::PerRev, (0.0, 0.3)),
    ] {
        for (speeds, harmonics) in [(101, 10), (2, 100)] {
            let options =
                ChartOptions { frequency_unit, frequencies: Some(window), measured: &points, ..Default::default() };
            let drawing = fan(&chart(&BRANCHES, speeds, harmonics), &options);
            let what = format!("{} {window:?} {speeds}", frequency_unit.name());
            check(&drawing, &what);
            let plot = &drawing.plots[0];
            assert_eq!((plot.y.from, plot.y.to), window, "{what}");
            for (x, y) in points_of(&drawing, "branch", None).into_iter().chain(points_of(&drawing, "ray", None)) {
                let inside = (plot.left - 0.1..=plot.left + plot.width + 0.1).contains(&x)
                    && (plot.top - 0.1..=plot.top + plot.height + 0.1).contains(&y);
                assert!(inside, "{what}: {x} {y} in {plot:?}");
            }
        }
    }
    let drawing = fan(
        &chart(&BRANCHES, 101, 10),
        &ChartOptions { frequency_unit: FrequencyUnit::PerRev, frequencies: Some((2.0, 6.0)), ..Default::default() },
    );
    assert!(groups(&drawing, "branch-label").contains(&"1L".to_string()), "1L leaves through the lower edge");
    assert_eq!(groups(&drawing, "ray-label"), ["2P", "3P", "4P", "5P", "6P"]);
    assert!(drawing.svg.contains("below the chart: 1F"), "what is below is said");
    let default = fan(&chart(&BRANCHES, 101, 10), &ChartOptions::default());
    for none in [(5.0, 5.0), (-1.0, 5.0), (0.0, f64::INFINITY), (f64::NAN, 1.0)] {
        let options = ChartOptions { frequencies: Some(none), ..Default::default() };
        assert_eq!(fan(&chart(&BRANCHES, 101, 10), &options), default, "{none:?} is no range");
    }
}

#[test]
fn ranges_of_speeds_may_start_far_from_rest_and_miss_the_band() {
    for (from, to) in [(30.0, 50.0), (75.0, 200.0), (69.0, 69.2), (1e-3, 20.0)] {
        let mut chart = chart(&BRANCHES, 21, 10);
        for (at, speed) in chart.speeds_rad_s.iter_mut().enumerate() {
            *speed = from + (to - from) * at as f64 / 20.0;
        }
        for branch in &mut chart.branches {
            let Southwell { k0, k1 } = branch.southwell;
            branch.frequency_rad_s = chart.speeds_rad_s.iter().map(|speed| sqrt(k0 + k1 * speed * speed)).collect();
        }
        each_look(|options, look| {
            let drawing = fan(&chart, options);
            check(&drawing, &format!("{from} to {to} {look}"));
            assert_eq!(drawing.svg.contains("nominal 6"), from < 69.1 && to > 69.1, "{from} to {to}");
        });
    }
}

#[test]
fn drawings_are_as_high_as_asked_for() {
    let (chart, shape, known) = (chart(&BRANCHES, 101, 10), shape_report(5), converge_report(true));
    for (width, asked, held) in [(960, 700, 700.0), (960, 10, 384.0), (600, 5000, 960.0), (1600, 2000, 2000.0)] {
        let options = ChartOptions { width, height: Some(asked), ..Default::default() };
        let drawings = [fan(&chart, &options), shapes(&shape, &options), converge(&known, &options)];
        for (number, drawing) in drawings.iter().enumerate() {
            check(drawing, &format!("{number} at {width} × {asked}"));
            assert!((drawing.height - held).abs() < 1e-9, "{number}: {} at {width} × {asked}", drawing.height);
        }
    }
    for width in [320, 390, 8000] {
        for height in [0, 100_000] {
            for frequency_unit in FrequencyUnit::ALL {
                let options = ChartOptions { width, height: Some(height), frequency_unit, ..Default::default() };
                let what = format!("{width} × {height}");
                check(&fan(&chart, &options), &what);
                check(&shapes(&shape, &options), &what);
                check(&converge(&known, &options), &what);
            }
        }
    }
}

#[test]
fn options_of_frequencies_are_read_or_refused_with_a_rule() {
    assert_eq!(parse_frequencies("0:6.5"), Ok((0.0, 6.5)));
    for (bad, rule) in [("5", "must be FROM:TO"), ("a:b", "must be FROM:TO"), ("0:1:2", "must be FROM:TO")] {
        assert!(parse_frequencies(bad).unwrap_err().message.starts_with(rule), "{bad}");
    }
    for bad in ["5:5", "6:5", "-1:5", "0:inf", "NaN:1", "0:NaN"] {
        let fault = parse_frequencies(bad).unwrap_err();
        assert_eq!((fault.path.as_str(), fault.value.as_deref()), ("frequencies", Some(bad)));
        assert!(fault.message.starts_with("must have 0 <= FROM < TO"), "{bad}");
    }
}

#[test]
fn a_narrow_convergence_study_is_higher_than_wide() {
    let narrow = converge(&converge_report(true), &ChartOptions { width: 390, ..Default::default() });
    let [frequency, error] = narrow.plots.as_slice() else { panic!("two panels") };
    assert!(narrow.height > 1.5 * narrow.width && frequency.height >= 200.0 && error.height >= 300.0, "{narrow:?}");
    assert!(frequency.y.to < 1.3, "few percent show");
}

#[test]
fn what_is_not_a_number_is_not_drawn() {
    let mut chart = chart(&BRANCHES, 101, 10);
    for (at, branch) in chart.branches.iter_mut().enumerate() {
        branch.frequency_rad_s[10 + at] = f64::NAN;
        branch.frequency_rad_s[60] = f64::INFINITY;
        branch.frequency_rad_s[61] = 1e300;
    }
    chart.crossings.push(Crossing {
        label: Label::new(Dof::Flap, 1),
        branch: 0,
        harmonic: 1,
        speed_rad_s: 69.0,
        frequency_rad_s: f64::NAN,
    });
    check(&fan(&chart, &ChartOptions::default()), "not finite");
    chart.speeds_rad_s.fill(f64::NAN);
    chart.nominal.speed_rad_s = f64::NAN;
    check(&fan(&chart, &ChartOptions { band: (f64::NAN, f64::INFINITY), ..Default::default() }), "no speeds");
    chart.speeds_rad_s.clear();
    check(&fan(&chart, &ChartOptions::default()), "empty");
    let mut report = shape_report(2);
    report.shapes[0].displacement[3] = f64::NAN;
    report.shapes[1].displacement.fill(f64::INFINITY);
    report.radius_m = 0.0;
    check(&shapes(&report, &ChartOptions::default()), "shapes");
    let mut report = converge_report(true);
    report.series[0].classical_rad_s.fill(Some(f64::NAN));
    report.series[1].converged_rad_s = Some(0.0);
    check(&converge(&report, &ChartOptions::default()), "converge");
}

#[test]
fn hostile_names_stay_inside_their_text() {
    let mut chart = chart(&BRANCHES, 11, 10);
    chart.blade = "</text><script>alert(1)</script> & \u{0}\u{202E}\u{FFFF}]]>".repeat(30);
    let points = [MeasuredPoint { source: "<a&b>\u{1}\"'".repeat(50), ..measured()[0].clone() }];
    let drawing = fan(&chart, &ChartOptions { measured: &points, ..Default::default() });
    check(&drawing, "hostile");
    assert!(!drawing.svg.contains("<script"), "markup of a name came through");
    chart.blade = String::new();
    check(&fan(&chart, &ChartOptions::default()), "no name");
}

#[test]
fn many_speeds_need_no_more_text() {
    let few = fan(&chart(&BRANCHES, 101, 10), &ChartOptions::default()).svg.len();
    let many = fan(&chart(&BRANCHES, 100_000, 10), &ChartOptions::default()).svg.len();
    assert!(many < few + few / 4, "{few} {many}");
}

#[test]
fn shapes_and_convergence_hold_up_in_every_look_and_size() {
    let some = shape_report(5);
    let one = ShapesReport { shapes: some.shapes[..1].to_vec(), ..some.clone() };
    let none = ShapesReport { shapes: Vec::new(), ..some.clone() };
    let (known, unknown) = (converge_report(true), converge_report(false));
    let empty = ConvergeReport { series: Vec::new(), functions: Vec::new(), ..known.clone() };
    each_look(|options, look| {
        for report in [&some, &one, &none, &shape_report(50)] {
            check(&shapes(report, options), &format!("{} shapes {look}", report.shapes.len()));
        }
        for report in [&known, &unknown, &empty] {
            check(&converge(report, options), &format!("converge {look}"));
        }
    });
}

#[test]
fn every_shape_is_labelled_and_its_nodes_counted() {
    let drawing = shapes(&shape_report(5), &ChartOptions::default());
    assert_eq!(groups(&drawing, "shape-label").len(), 15);
    let names: Vec<&str> = drawing.plots.iter().map(|plot| plot.name).collect();
    assert_eq!(names, ["flap", "lag", "torsion"]);
    let document = Document::parse(&drawing.svg).unwrap();
    let shape =
        |node: &Node| node.attribute("class") == Some("shape flap") && node.attribute("data-label") == Some("4F");
    let shape = document.descendants().find(shape).unwrap();
    // Each node is a disc on a wider one of the background.
    assert_eq!(shape.children().filter(|node| node.has_tag_name("circle")).count(), 2 * 3);
}

#[test]
fn both_families_stand_on_one_axis() {
    let known = converge(&converge_report(true), &ChartOptions::default());
    assert!(known.svg.contains("error against the converged frequency [%]"), "what the error is against");
    assert!(known.svg.contains("N = 15, as in the paper"), "the paper's number of functions is marked");
    let [frequency, error] = known.plots.as_slice() else { panic!("two panels") };
    assert!(frequency.x.log && frequency.x.to > 99.0, "as many functions as the piecewise family took");
    assert!(error.y.log && error.y.from < 1e-9 && error.y.to > 1.0, "{:?}", error.y);
    assert_eq!(groups(&known, "series-label").len(), BRANCHES.len());
    let unknown = converge(&converge_report(false), &ChartOptions::default());
    assert!(unknown.svg.contains("no converged frequency"), "nothing to compare with is said");
}
