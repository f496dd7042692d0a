//! `converge`: frequency against the number of assumed functions.

use crate::args::{ConvergeArgs, Format};
use crate::failure::Failure;
use crate::io::input;
use crate::io::messages::warn;
use crate::io::output::{self, Output};
use crate::render::accuracy::{Bounded, advice, bounds_cell, difference_cell, error_cell, percent};
use crate::render::heading::{heading, speed};
use crate::render::table::{Align, Cell, Table};
use crate::render::text::wrap;
use crate::render::{csv, json, picture};
use bladefan_core::BasisFamily;
use bladefan_core::Dof;
use bladefan_core::PAPER_FUNCTIONS;
use bladefan_core::chart::{self, ChartOptions};
use bladefan_core::report::{ConvergeReport, ConvergeSeries};
use core::fmt::Write as _;

/// Numbers of classical functions whose errors are shown, beside the largest.
const SHOWN: [usize; 9] = [1, 2, 3, 5, 7, 10, 15, 30, 100];

pub(super) fn run(args: &ConvergeArgs) -> Result<Output, Failure> {
    let settings = args.settings()?;
    let input = input::load(&args.blade.blade)?;
    output::check(&[input.path.as_ref()], &args.result, Some(&args.drawing))?;
    let report = input.ask("solving", |blade| bladefan_core::converge(blade, &settings))?;
    warn(&args.idle(settings.model_for(input.blade())));
    warn(&report.warnings);
    let text = match args.result.format {
        Format::Table => table(&report, output::width(&args.result)),
        Format::Json => json::line(&report)?,
        Format::Csv => csv::converge(&report)?,
    };
    let draw = || {
        let frequency_unit = args.frequency.frequency_unit;
        chart::converge(&report, &ChartOptions { frequency_unit, ..picture::options(&args.drawing) })
    };
    let drawings = picture::files(&args.drawing, draw)?;
    Ok(Output::new(text, &args.result).with(drawings))
}

/// The converged frequencies, then the errors of both families.
fn table(report: &ConvergeReport, width: usize) -> String {
    let most = report.functions.last().copied().unwrap_or(1);
    let functions = format!("classical functions, N = 1 to {most}; piecewise functions until converged");
    let mut text = heading(
        &report.blade,
        &format!("convergence at {}", speed(report.speed_rad_s)),
        &functions,
        &report.model.words,
        width,
    );
    text += &frequencies(report, PAPER_FUNCTIONS.min(most)).render(width);
    text += &advice(BasisFamily::Piecewise, report.series.iter().map(bounded), width);
    let mut section = |title: &str, table: &Table| {
        // Writing to a string does not fail.
        let _ = write!(text, "\n{}\n{}", wrap(title, 0, width), table.render(width));
    };
    section("Error [%] of N classical functions against the converged frequency", &classical(report, most));
    let all: Vec<_> = report.series.iter().collect();
    if report.model.kind == "coupled" && !all.is_empty() {
        section("Error [%] of N piecewise functions of all motions", &piecewise(&all));
        return text;
    }
    for dof in Dof::ALL {
        let series: Vec<_> = all.iter().copied().filter(|series| series.dof == dof).collect();
        if !series.is_empty() {
            section(&format!("Error [%] of N piecewise functions, {dof}"), &piecewise(&series));
        }
    }
    text
}

fn bounded(series: &ConvergeSeries) -> Option<Bounded> {
    Bounded::new(series.converged_rad_s, series.lower_rad_s, series.upper_rad_s)
}

/// What `count` classical functions give.
fn by_classical(report: &ConvergeReport, series: &ConvergeSeries, count: usize) -> Option<f64> {
    let index = report.functions.iter().position(|&functions| functions == count)?;
    series.classical_rad_s.get(index).copied().flatten()
}

/// Every mode between its bounds, beside what `count` classical functions give.
fn frequencies(report: &ConvergeReport, count: usize) -> Table {
    let mut table = Table::new([
        (String::from("mode"), Align::Left),
        (String::from("converged\n[rad/s]"), Align::Point),
        (String::from("bounds\n[rad/s]"), Align::Left),
        (format!("classical N={count}\n[rad/s]"), Align::Point),
        (String::from("error"), Align::Point),
    ]);
    for series in &report.series {
        let classical = by_classical(report, series, count);
        table.row([
            Cell::label(&series.label, Some(series.dof)),
            Cell::maybe(series.converged_rad_s, 6),
            bounds_cell(bounded(series)),
            Cell::maybe(classical, 6),
            difference_cell(percent(classical, series.converged_rad_s)),
        ]);
    }
    table
}

fn classical(report: &ConvergeReport, most: usize) -> Table {
    let mut shown: Vec<usize> = SHOWN.into_iter().filter(|count| *count < most).collect();
    shown.push(most);
    let mut table = Table::new(headers(&shown));
    for series in &report.series {
        let errors =
            shown.iter().map(|&count| error_cell(percent(by_classical(report, series, count), series.converged_rad_s)));
        table.row(core::iter::once(Cell::label(&series.label, Some(series.dof))).chain(errors));
    }
    table
}

/// Of one degree of freedom: each has its own numbers of functions.
fn piecewise(series: &[&ConvergeSeries]) -> Table {
    let mut table = Table::new(headers(series.first().map_or(&[], |first| &first.piecewise_functions)));
    for series in series {
        let errors = series.piecewise_rad_s.iter().map(|&value| error_cell(percent(value, series.converged_rad_s)));
        table.row(core::iter::once(Cell::label(&series.label, Some(series.dof))).chain(errors));
    }
    table
}

fn headers(counts: &[usize]) -> impl Iterator<Item = (String, Align)> {
    let counts = counts.iter().map(|count| (format!("N={count}"), Align::Point));
    core::iter::once((String::from("mode"), Align::Left)).chain(counts)
}
