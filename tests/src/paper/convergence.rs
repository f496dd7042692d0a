//! Fig. 6 and 7: frequencies against the number of functions, with the converged values and bounds.

use super::table::{cells, digits, labelled, list, number, percent, table, text};
use super::{Cli, Output};
use serde_json::Value;

const MODES: usize = 5;
const COUNTS: [usize; 5] = [5, 10, 15, 30, 60];

pub(super) fn figures_6_and_7(cli: &Cli, output: &mut Output) {
    for (figure, blade, speed) in [(6, "tm4760", "660rpm"), (7, "hingeless-1000", "105")] {
        let mut part = String::new();
        for (panel, dof) in [("a", "flap"), ("b", "lag"), ("c", "torsion")] {
            let command = format!("converge {blade} --speed {speed} --up-to 16 --modes {MODES} --dof {dof}");
            let name = format!("fig-{figure}{panel}");
            let alternative = format!("{blade} at {speed}: {dof} frequencies per rev against the number of functions");
            part += &output.draw(cli, &name, &alternative, &format!("{command} --frequency-unit per-rev"));
            let link = output.csv(&name, cli.csv(&command));
            part += &format!("\n`bladefan {command} --frequency-unit per-rev`, {link}\n\n");
        }
        let report = cli.json(&format!("converge {blade} --speed {speed} --up-to 60 --modes {MODES}"));
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
