//! Tables and numbers of the document.

use serde_json::Value;

/// A Markdown table; cells hold no `|`.
pub(super) fn table(head: &[String], rows: &[Vec<String>]) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let rule = format!("|{}\n", "---|".repeat(head.len()));
    rows.iter().fold(line(head) + &rule, |text, row| text + &line(row))
}

/// Words as cells.
pub(super) fn cells(words: &[&str]) -> Vec<String> {
    words.iter().map(ToString::to_string).collect()
}

/// A difference in per cent, with its sign: two decimals, more where they would be 0.
pub(super) fn percent(part: f64) -> String {
    let value = 100.0 * part;
    let text = match value.abs() {
        size if size < 5e-7 => return "0".into(),
        size if size < 0.001 => format!("{value:+.0e}"),
        size if size < 0.1 => format!("{value:+.3}"),
        size if size < 10.0 => format!("{value:+.2}"),
        _ => format!("{value:+.1}"),
    };
    text.replace('-', "−").replace("e−", "e-")
}

/// A number with so many significant digits.
pub(super) fn digits(value: f64, count: usize) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let scientific = format!("{value:.*e}", count - 1);
    let power: isize = scientific.split_once('e').unwrap().1.parse().unwrap();
    let decimals = count.saturating_sub(1).checked_add_signed(-power).unwrap_or(0);
    format!("{value:.decimals$}")
}

/// A number of a report.
pub(super) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

/// The entries of a list of a report.
pub(super) fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value} is not a list"))
}

/// A text of a report.
pub(super) fn text(value: &Value) -> &str {
    value.as_str().unwrap_or_else(|| panic!("{value} is not a text"))
}

/// The entry of a list with this label.
pub(super) fn labelled<'a>(entries: &'a Value, label: &str) -> &'a Value {
    list(entries).iter().find(|entry| entry["label"] == label).unwrap_or_else(|| panic!("no {label}"))
}
