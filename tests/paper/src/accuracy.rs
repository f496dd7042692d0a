//! How far the paper's functions are from the converged frequencies of the built-in blades, and
//! what their bounds say.

use super::table::{cells, digits, labelled, list, number, percent, table};
use super::{Cli, Output};

const LABELS: [&str; 9] = ["1F", "2F", "3F", "4F", "5F", "1L", "2L", "1T", "2T"];

pub(super) fn tables(cli: &Cli, output: &mut Output) {
    let mut rows = Vec::new();
    for (blade, name) in [
        ("tm4760", "tm4760"),
        ("sa330", "sa330"),
        ("bo105", "bo105 (estimated)"),
        ("hingeless-1000", "hingeless-1000 (estimated)"),
    ] {
        for functions in [15, 60, 120] {
            let report = cli.json(&format!("modes {blade} --model uncoupled --functions {functions}"));
            let mut row = vec![name.to_string(), functions.to_string()];
            row.extend(LABELS.map(|label| {
                let mode = labelled(&report["modes"], label);
                percent(number(&mode["classical_rad_s"]) / number(&mode["converged_rad_s"]) - 1.0)
            }));
            rows.push(row);
        }
    }
    let mut head = cells(&["blade", "functions"]);
    head.extend(cells(&LABELS));
    output.part("functions too few", table(&head, &rows));

    let report = cli.json("modes hingeless-1000 --model uncoupled --basis classical");
    let labels = &LABELS[..7];
    let line = |name: &str, value: &dyn Fn(&serde_json::Value) -> String| {
        let mut row = vec![name.to_string()];
        row.extend(labels.iter().map(|label| value(labelled(&report["modes"], label))));
        row
    };
    let key = |key: &'static str| move |mode: &serde_json::Value| digits(number(&mode[key]), 5);
    let rows = [
        line("15 functions [rad/s]", &key("frequency_rad_s")),
        line("their lower bound", &key("lower_rad_s")),
        line("converged", &key("converged_rad_s")),
        line("15 functions too high by [%]", &|mode| {
            percent(number(&mode["frequency_rad_s"]) / number(&mode["converged_rad_s"]) - 1.0)
        }),
    ];
    assert!(
        list(&report["modes"]).iter().all(|mode| number(&mode["lower_rad_s"]) <= number(&mode["converged_rad_s"])),
        "a bound"
    );
    let mut head = cells(&[""]);
    head.extend(cells(labels));
    output.part("bounds of 15 functions", table(&head, &rows));
}
