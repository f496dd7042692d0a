//! `converge`: frequency against the number of assumed functions.

use super::{heading, speed};
use crate::args::{ConvergeArgs, Format};
use crate::failure::{Failure, warn};
use crate::output::{self, Output};
use crate::table::{Align, Cell, Table};
use crate::{csv, drawing, input, json, progress};
use bladefan_core::analysis::{self, ConvergeReport, Settings};
use bladefan_core::chart::{self, ChartOptions};
use bladefan_core::dof::Dof;

pub(super) fn run(args: &ConvergeArgs) -> Result<Output, Failure> {
    let settings = args.settings()?;
    let input = input::load(&args.blade.blade)?;
    output::check(&[input.path.as_ref()], &args.result, Some(&args.drawing))?;
    let report = progress::with("solving", || analysis::converge(&input.file.blade, &settings));
    let report = report.map_err(|faults| Failure::faults(&input.name, &faults))?;
    warn(&report.warnings);
    let text = match args.result.format {
        Format::Table => table(&report, &settings),
        Format::Json => json::line(&report)?,
        Format::Csv => csv::converge(&report)?,
    };
    let draw = || {
        let frequency_unit = args.frequency.frequency_unit;
        chart::converge(&report, &ChartOptions { frequency_unit, ..drawing::options(&args.drawing) })
    };
    Output::new(text, &args.result).draw(&args.drawing, draw)
}

/// One table per degree of freedom: a row for each number of functions, a column for each mode.
fn table(report: &ConvergeReport, settings: &Settings) -> String {
    let basis = format!("{} functions, N = 1 to {}", settings.basis.name(), settings.up_to);
    let mut text = heading(&report.blade, &format!("frequency [rad/s] at {}", speed(report.speed_rad_s)), &basis);
    let mut tables = Vec::new();
    for dof in Dof::ALL {
        let series: Vec<_> = report.series.iter().filter(|series| series.dof == dof).collect();
        if series.is_empty() {
            continue;
        }
        let labels = series.iter().map(|series| (series.label.clone(), Align::Point));
        let mut table = Table::new(core::iter::once((String::from("N"), Align::Point)).chain(labels));
        for (index, count) in report.functions.iter().enumerate() {
            let values = series.iter().map(|series| series.classical_rad_s.get(index).copied().flatten());
            let values = values.map(|value| value.map_or_else(|| Cell::text("-"), |value| Cell::number(value, 6)));
            table.row(core::iter::once(Cell::text(count.to_string())).chain(values));
        }
        tables.push(table.render());
    }
    text.push_str(&tables.join("\n"));
    text
}
