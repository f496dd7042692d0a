//! The cases of `tests/cases` as parts of the document.

use super::Output;
use super::table::{cells, digits, percent, table};
use bladefan_tests::cases::Case;
use std::fs;
use std::path::Path;

pub(super) fn tables(output: &mut Output) {
    for (name, case) in Case::all() {
        let compared = case.compare();
        let mut head = cells(&[case.speed_unit.as_str()]);
        head.extend(case.labels.iter().map(|label| format!("{label} [{}]", case.frequency_unit)));
        let line = |values: &[bladefan_tests::cases::Compared]| {
            let mut row = vec![values[0].speed.to_string()];
            row.extend(values.iter().map(|value| match value.expected {
                expected if expected > 0.0 => format!("{expected} {}", percent(value.found / expected - 1.0)),
                _ => format!("0, {}", digits(value.found, 2)),
            }));
            row
        };
        let rows: Vec<Vec<String>> = compared.chunks(case.labels.len()).map(line).collect();
        let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let tolerance = case.tolerance_in_words();
        output.part(
            &format!("case {name}"),
            format!(
                "**{}** (`tests/cases/{name}.toml`). Source: {}\n\n{}\nBeside each value the difference of the converged frequency from it, in per cent (0 where it is below 5e-7). Allowed: {tolerance}. {}\n",
                case.title,
                plain(&case.source),
                table(&head, &rows),
                plain(&case.why),
            ),
        );
    }
}

/// The record of other programs' runs, as `tests/peers/run` writes it.
pub(super) fn peers(root: &Path, output: &mut Output) {
    let record = "tests/peers/results.md";
    let text = fs::read_to_string(root.join(record)).unwrap_or_else(|error| panic!("{record}: {error}"));
    output.part("peers", text);
}
