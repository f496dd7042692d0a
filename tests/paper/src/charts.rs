//! Fig. 9, 11 and 16: resonance charts.

use super::table::{cells, digits, labelled, list, number, percent, table, text};
use super::{Cli, Output};
use bladefan_tests::cases::Case;
use core::fmt::Write as _;
use serde_json::Value;

const POINTS: &str = "docs/paper/fig-9-points.csv";

/// Groups of modes over which differences are averaged.
const GROUPS: [&[&str]; 5] = [&["1F", "2F", "3F", "4F"], &["2F", "3F", "4F"], &["1L", "2L"], &["2L"], &["1T"]];
/// What the paper's §4.4 says of these groups: its flap and lag averages do not say whether 1F and 1L,
/// which it compares with Euler's equation, are in them.
const PAPER: [&str; 5] = ["0.5", "0.5", "0.1", "0.1", "reaches about 2.5"];
/// The same against the experiment, which is not printed.
const EXPERIMENT: [&str; 5] = ["–", "2F 4, 3F and 4F about 9", "–", "3", "about 7"];

/// The report of a fan chart with its drawing, chart and numbers kept under `name`.
fn chart(cli: &Cli, output: &mut Output, name: &str, command: &str) -> (Value, String) {
    let report = cli.json(command);
    let alternative = format!("Fan chart, {}", text(&report["blade"]));
    let drawing = format!("{command} --speed-unit rad/s");
    let image = output.draw(cli, name, &alternative, &drawing);
    let link = output.csv(name, cli.csv(command));
    (report, format!("{image}\n`bladefan {drawing}`, {link}\n\n"))
}

pub(super) fn figure_9(cli: &Cli, output: &mut Output) {
    let case = Case::read(include_str!("../../cases/tm4760-finite-elements.toml"));
    let mut points = format!("label,speed [{}],frequency [{}],source\n", case.speed_unit, case.frequency_unit);
    for row in &case.rows {
        for (label, frequency) in case.labels.iter().zip(&row[1..]) {
            writeln!(points, "{label},{},{frequency},finite elements", row[0]).unwrap();
        }
    }
    let file = cli.file("fig-9-points.csv", &points);
    output.files.insert(POINTS.into(), points);
    let command = format!("fan tm4760 --model uncoupled --speeds 0:70:71 --measured {file}");
    let (converged, mut part) = chart(cli, output, "fig-9", &command);
    let by_count =
        [10, 15, 30, 60].map(|count| (count, cli.json(&format!("{command} --basis classical --functions {count}"))));
    let (_, fifteen) = &by_count[1];
    let found = |report: &Value, label: &str, speed: f64| -> (f64, f64) {
        let at = |point: &&Value| point["label"] == label && (number(&point["speed_rad_s"]) - speed).abs() < 1e-6;
        let point = list(&report["measured"]).iter().find(at).expect("every point of the case");
        (number(&point["computed_rad_s"]), number(&point["frequency_rad_s"]))
    };
    let off = |report: &Value, label: &str, rpm: f64| {
        let (computed, reference) = found(report, label, rpm * core::f64::consts::PI / 30.0);
        (reference > 0.0).then(|| computed / reference - 1.0)
    };
    part = part.replace(&file, POINTS);
    part +=
        "Finite elements in Hz; converged and, in brackets, with the paper's 15 functions, in per cent above them:\n\n";
    let mut head = cells(&["rpm"]);
    head.extend(case.labels.iter().cloned());
    let line = |row: &Vec<f64>| {
        let cell =
            |(label, reference): (&String, &f64)| match (off(&converged, label, row[0]), off(fifteen, label, row[0])) {
                (Some(a), Some(b)) => format!("{reference} {} ({})", percent(a), percent(b)),
                _ => "0 exactly".into(),
            };
        let mut line = vec![row[0].to_string()];
        line.extend(case.labels.iter().zip(&row[1..]).map(cell));
        line
    };
    part += &table(&head, &case.rows.iter().map(line).collect::<Vec<_>>());
    let mean = |report: &Value, labels: &&[&str]| {
        let all = labels.iter().flat_map(|label| case.rows.iter().filter_map(|row| off(report, label, row[0])));
        let sizes: Vec<f64> = all.map(f64::abs).collect();
        digits(100.0 * sizes.iter().sum::<f64>() / sizes.len() as f64, 2)
    };
    let line = |name: &str, report: &Value| {
        let mut line = vec![name.to_string()];
        line.extend(GROUPS.iter().map(|labels| mean(report, labels)));
        line
    };
    let mut rows: Vec<Vec<String>> =
        by_count.iter().map(|(count, report)| line(&format!("{count} functions"), report)).collect();
    rows.push(line("converged", &converged));
    let mut paper = cells(&["the paper, against its finite elements"]);
    paper.extend(cells(&PAPER));
    rows.push(paper);
    let mut experiment = cells(&["the paper, against the experiment"]);
    experiment.extend(cells(&EXPERIMENT));
    rows.push(experiment);
    let head = cells(&["average difference [%]", "1F to 4F", "2F to 4F", "1L, 2L", "2L", "1T"]);
    part += &format!("\n{}", table(&head, &rows));
    output.part("figure 9", part);
}

/// Where the paper's Fig. 11 has the branches at 105 rad/s [rad/s]: between which rays their labels
/// stand in its text (nP = 105 n).
const FIGURE_11: [(&str, f64, f64); 5] =
    [("1F", 105.0, 210.0), ("1L", 105.0, 210.0), ("1T", 200.0, 300.0), ("2F", 315.0, 420.0), ("3F", 735.0, 800.0)];

pub(super) fn figure_11(cli: &Cli, output: &mut Output) {
    let command = "fan hingeless-1000 --model uncoupled --speeds 0:105:106 --harmonics 8 --modes 3";
    let (_, mut part) = chart(cli, output, "fig-11", command);
    let at = |speed: &str| cli.json(&format!("modes hingeless-1000 --model uncoupled --speed {speed} --modes 3"));
    let (rest, nominal) = (at("0"), at("105"));
    let head = cells(&[
        "mode",
        "at rest [rad/s]",
        "with 15 functions",
        "at 105 rad/s",
        "with 15 functions",
        "labels in the paper's figure",
        "",
    ]);
    let rows = FIGURE_11.map(|(label, low, high)| {
        let pair = |report: &Value| {
            let mode = labelled(&report["modes"], label);
            let [converged, fifteen] = ["converged_rad_s", "classical_rad_s"].map(|key| number(&mode[key]));
            (converged, [digits(converged, 5), format!("{} %", percent(fifteen / converged - 1.0))])
        };
        let (value, turning) = pair(&nominal);
        let mut row = vec![label.to_string()];
        row.extend(pair(&rest).1);
        row.extend(turning);
        row.push(format!("{low} to {high}"));
        row.push(if (low..=high).contains(&value) { "inside".into() } else { "outside".into() });
        row
    });
    part += &table(&head, &rows);
    output.part("figure 11", part);
}

/// Known frequencies per revolution: published for the Bo 105 (ranges), finite elements for the SA 330.
const BO105: [(&str, f64, f64); 6] =
    [("1L", 0.66, 0.70), ("1F", 1.12, 1.12), ("2F", 2.75, 2.75), ("1T", 3.4, 3.7), ("2L", 4.3, 4.6), ("3F", 5.0, 5.2)];

pub(super) fn figure_16(cli: &Cli, output: &mut Output) {
    let (_, a) = chart(cli, output, "fig-16a", "fan bo105 --model uncoupled --speeds 0:50:101 --harmonics 8 --modes 4");
    let report = cli.json("modes bo105 --model uncoupled --speed 44.4 --modes 4");
    let rows = BO105.map(|(label, low, high)| {
        let value = number(&labelled(&report["modes"], label)["per_rev"]);
        let off = if value < low {
            value / low - 1.0
        } else if value > high {
            value / high - 1.0
        } else {
            0.0
        };
        let known = if low < high { format!("{low} to {high}") } else { low.to_string() };
        vec![
            label.into(),
            known,
            digits(value, 4),
            if off == 0.0 { "inside".into() } else { format!("{} %", percent(off)) },
        ]
    });
    let text_a = a + &table(&cells(&["mode", "known [/rev]", "the estimated file", "difference"]), &rows);
    let (_, b) = chart(cli, output, "fig-16b", "fan sa330 --model uncoupled --speeds 0:30:61 --harmonics 10");
    let case = Case::read(include_str!("../../cases/sa330-finite-elements.toml"));
    let report = cli.json("modes sa330 --model uncoupled --speed 27");
    let row = |(label, reference): (&String, &f64)| {
        let mode = labelled(&report["modes"], label);
        let converged = number(&mode["converged_rad_s"]);
        let off = |value: f64| format!("{} %", percent(value / reference - 1.0));
        vec![
            label.clone(),
            digits(reference / 27.0, 4),
            digits(converged / 27.0, 4),
            off(converged),
            off(number(&mode["classical_rad_s"])),
        ]
    };
    let rows: Vec<Vec<String>> = case.labels.iter().zip(&case.rows[0][1..]).map(row).collect();
    let head = cells(&["mode", "finite elements [/rev]", "converged", "difference", "with 15 functions"]);
    output.part("figure 16a", text_a);
    output.part("figure 16b", b + &table(&head, &rows));
}
