//! Fig. 6 and 7: frequencies against the number of functions, with the converged values and bounds.

use super::plot::{Axes, COLOURS, Curve, GREY, Stroke, chart};
use super::table::{cells, digits, labelled, list, number, percent, table, text};
use super::{Cli, Output};
use plotters::style::RGBColor;
use serde_json::Value;

const MODES: usize = 5;
const COUNTS: [usize; 8] = [2, 3, 4, 5, 10, 15, 30, 60];

/// The largest N of the paper's figures.
const LAST: usize = 16;

pub(super) fn figures_6_and_7(cli: &Cli, output: &mut Output) {
    for (figure, blade, speed) in [(6, "tm4760", "660rpm"), (7, "hingeless-1000", "105")] {
        let mut part = String::new();
        for (panel, dof, letter, colour) in
            [("a", "flap", 'F', COLOURS[0]), ("b", "lag", 'L', COLOURS[1]), ("c", "torsion", 'T', COLOURS[2])]
        {
            let command = |count: &str, modes: usize| {
                format!(
                    "modes {blade} --model uncoupled --speed {speed} --basis classical --functions {count} --modes {modes} --dof {dof}"
                )
            };
            let solved = |count: usize| cli.json(&command(&count.to_string(), MODES.min(count)));
            let reports: Vec<Value> = (1..=LAST).map(solved).collect();
            let name = format!("fig-{figure}{panel}");
            let drawing = panel_of(&reports, letter, colour, &format!("{}, {dof}", text(&reports[0]["blade"])));
            part +=
                &output.image(&name, &format!("{dof} frequencies per rev against the number of functions"), drawing);
            let link = output.csv(&name, csv(&reports));
            part += &format!(
                "\n`bladefan {}`, N = 1 … {LAST} (below {MODES}, as many modes), {link}\n\n",
                command("N", MODES)
            );
        }
        let command = format!("converge {blade} --model uncoupled --speed {speed} --up-to {LAST} --modes {MODES}");
        part += "The same as errors, with the piecewise functions:\n\n";
        part += &output.draw(
            cli,
            &format!("fig-{figure}-errors"),
            "Frequencies over their converged values, and errors",
            &command,
        );
        part += &format!("\n`bladefan {command}`\n\n");
        let report =
            cli.json(&format!("converge {blade} --model uncoupled --speed {speed} --up-to 60 --modes {MODES}"));
        let mut head = cells(&["mode", "converged [/rev]", "± [/rev]"]);
        head.extend(COUNTS.map(|count| format!("N = {count}")));
        let rows: Vec<Vec<String>> =
            list(&report["series"]).iter().map(|series| row(series, number(&report["speed_rad_s"]))).collect();
        part += "How far the paper's functions lie above the converged frequency, in per cent:\n\n";
        part += &table(&head, &rows);
        part += &finding(&report);
        output.part(&format!("figure {figure}"), part);
    }
}

/// The paper's drawing, with the interval between the bounds at each N and the converged values.
fn panel_of(reports: &[Value], letter: char, colour: RGBColor, title: &str) -> String {
    let speed = number(&reports[0]["speed_rad_s"]);
    let (mut curves, mut highest) = (Vec::new(), 0.0_f64);
    for mode in (1..=MODES).rev() {
        let label = format!("{mode}{letter}");
        let found =
            |report: &Value| list(&report["modes"]).iter().find(|found| found["label"] == label.as_str()).cloned();
        let modes: Vec<(f64, Value)> =
            reports.iter().zip(1..).filter_map(|(report, count)| Some((f64::from(count), found(report)?))).collect();
        let per_rev = |(count, mode): &(f64, Value), key: &str| (*count, number(&mode[key]) / speed);
        let converged = per_rev(modes.last().expect("a mode at the last N"), "converged_rad_s").1;
        highest = highest.max(converged);
        curves.push(Curve {
            label: format!("{label} {}", digits(converged, 4)),
            colour: GREY,
            stroke: Stroke::Dashed,
            points: vec![(0.0, converged), (LAST as f64, converged)],
        });
        for mode in &modes {
            let interval = vec![per_rev(mode, "lower_rad_s"), per_rev(mode, "upper_rad_s")];
            curves.push(Curve { label: String::new(), colour: GREY, stroke: Stroke::Thin, points: interval });
        }
        let points: Vec<(f64, f64)> = modes.iter().map(|mode| per_rev(mode, "frequency_rad_s")).collect();
        curves.push(Curve { label: String::new(), colour, stroke: Stroke::Solid, points: points.clone() });
        curves.push(Curve { label: String::new(), colour, stroke: Stroke::Dots, points });
    }
    let axes = Axes {
        title: title.into(),
        x: "assumed functions N",
        y: "frequency [/rev]",
        across: 0.0..LAST as f64,
        up: 0.0..1.25 * highest,
        powers: false,
    };
    chart(&axes, &curves)
}

fn csv(reports: &[Value]) -> String {
    let mut csv =
        String::from("mode,functions,frequency [rad/s],lower bound [rad/s],upper bound [rad/s],converged [rad/s]\n");
    for (report, count) in reports.iter().zip(1..) {
        for mode in list(&report["modes"]) {
            let keys = ["frequency_rad_s", "lower_rad_s", "upper_rad_s", "converged_rad_s"];
            let values = keys.map(|key| mode[key].to_string());
            csv += &format!("{},{count},{}\n", text(&mode["label"]), values.join(","));
        }
    }
    csv
}

fn row(series: &Value, speed: f64) -> Vec<String> {
    let converged = number(&series["converged_rad_s"]);
    let half = 0.5 * (number(&series["upper_rad_s"]) - number(&series["lower_rad_s"]));
    let mut row = vec![text(&series["label"]).into(), digits(converged / speed, 6), format!("{:.0e}", half / speed)];
    row.extend(COUNTS.map(|count| match series["classical_rad_s"][count - 1].as_f64() {
        Some(found) => percent(found / converged - 1.0),
        None => "–".into(),
    }));
    row
}

/// What 15 functions cost, in one line for each degree of freedom.
fn finding(report: &Value) -> String {
    let errors = |letter: char| {
        let series = (1..=MODES).map(|mode| labelled(&report["series"], &format!("{mode}{letter}")));
        let error = |series: &Value| number(&series["classical_rad_s"][14]) / number(&series["converged_rad_s"]) - 1.0;
        let all: Vec<f64> = series.map(error).collect();
        let (least, most) = (all.iter().copied().fold(f64::MAX, f64::min), all.iter().copied().fold(0.0, f64::max));
        if most > 1e-9 { format!("{} to {} %", percent(least), percent(most)) } else { "0".into() }
    };
    format!("\nWith 15 functions: flap {}, lag {}, torsion {}.\n", errors('F'), errors('L'), errors('T'))
}
