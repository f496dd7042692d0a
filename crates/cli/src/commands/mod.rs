//! One file per command: read, solve, render.

pub(crate) mod accuracy;
pub(crate) mod blades;
mod check;
mod converge;
mod fan;
pub(crate) mod measured;
mod modes;
mod shapes;

use crate::args::Command;
use crate::failure::Failure;
use crate::output::Output;
use crate::table::{Align, Cell, WIDTH, short, wrap};
use bladefan_core::analysis::MODEL;
use bladefan_core::dof::Dof;
use bladefan_core::functions::BasisFamily;
use bladefan_core::report::{BasisReport, Margin};
use bladefan_core::units;

/// Runs a command; what it made is still to be written.
pub(crate) fn run(command: &Command) -> Result<Output, Failure> {
    match command {
        Command::Modes(args) => modes::run(args),
        Command::Fan(args) => fan::run(args),
        Command::Shapes(args) => shapes::run(args),
        Command::Converge(args) => converge::run(args),
        Command::Check(args) => check::run(args),
        Command::Blades(args) => blades::run(args),
    }
}

/// The lines above every table: which blade at what speed, what the functions and the model are.
fn heading(blade: &str, what: &str, basis: &str) -> String {
    let together = format!("{basis}; {MODEL}");
    let fits = together.chars().count() <= WIDTH;
    let model = if fits { vec![together] } else { vec![String::from(basis), String::from(MODEL)] };
    let lines = core::iter::once(format!("{blade}, {what}")).chain(model);
    let lines: String = lines.map(|line| wrap(&line, 0, WIDTH) + "\n").collect();
    lines + "\n"
}

/// A rotor speed as in headings.
fn speed(speed: f64) -> String {
    format!("{} rad/s ({} rpm)", short(speed, 4), short(units::rpm(speed), 4))
}

/// The assumed functions as in headings.
fn basis(report: &BasisReport) -> String {
    let counts = report.functions;
    let known: Vec<(Dof, usize)> = Dof::ALL
        .into_iter()
        .zip([counts.flap, counts.lag, counts.torsion])
        .filter_map(|(dof, count)| Some((dof, count?)))
        .collect();
    // The user chose one number of classical functions for all.
    if let (BasisFamily::Classical, Some((_, count))) = (report.family, known.first()) {
        return format!("classical, {count} functions");
    }
    let each = known.iter().map(|(dof, count)| format!("{dof} {count}"));
    let words: Vec<String> = core::iter::once(format!("{} functions", report.family.name())).chain(each).collect();
    words.join(", ")
}

/// Indices of at most `most` of `len` rows: first and last, evenly spaced where that is possible.
fn pick(len: usize, most: usize) -> Vec<usize> {
    let last = len.saturating_sub(1);
    let steps = last.min(most.saturating_sub(1)).max(1);
    let even = (steps / 2 + 1..=steps).rev().find(|steps| last.is_multiple_of(*steps));
    let steps = even.unwrap_or(steps);
    let mut picked: Vec<usize> = (0..=steps).map(|step| (step * last + steps / 2) / steps).collect();
    picked.dedup();
    picked
}

/// Headers of a mode at one rotor speed.
const MODE_COLUMNS: [(&str, Align); 4] =
    [("mode", Align::Left), ("rad/s", Align::Point), ("Hz", Align::Point), ("/rev", Align::Point)];

/// Headers of what [`margin_cells`] fills.
const MARGIN_COLUMNS: [(&str, Align); 2] = [("nearest", Align::Left), ("margin\n[/rev]", Align::Point)];

/// A header beside ones that are made up.
fn own((name, align): (&str, Align)) -> (String, Align) {
    (name.into(), align)
}

/// The nearest harmonic and the margin to it; there is none at rest.
fn margin_cells(margin: Option<&Margin>) -> [Cell; 2] {
    match margin {
        Some(margin) => [Cell::text(format!("{}P", margin.nearest_harmonic)), Cell::signed(margin.margin_per_rev, 3)],
        None => [Cell::text("-"), Cell::text("-")],
    }
}

#[cfg(test)]
mod tests {
    use super::pick;

    #[test]
    fn picked_rows_are_evenly_spaced_where_possible() {
        assert_eq!(pick(101, 7), [0, 20, 40, 60, 80, 100]);
        assert_eq!(pick(101, 11), [0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100]);
        assert_eq!(pick(2, 7), [0, 1]);
        assert_eq!(pick(1, 7), [0]);
        assert_eq!(pick(12, 7), [0, 2, 4, 6, 7, 9, 11], "eleven steps have no even split into four to six");
    }
}
