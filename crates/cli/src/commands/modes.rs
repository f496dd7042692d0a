//! `modes`: frequencies at one rotor speed.

use super::{MODE_COLUMNS, basis, heading, margin_cells, speed};
use crate::args::{Format, ModesArgs};
use crate::failure::{Failure, warn};
use crate::output::{self, Output};
use crate::table::{Align, Cell, Table};
use crate::{csv, input, json, progress};
use bladefan_core::analysis::{self, ModesReport};

pub(super) fn run(args: &ModesArgs) -> Result<Output, Failure> {
    let settings = args.settings()?;
    let input = input::load(&args.blade.blade)?;
    output::check(&[input.path.as_ref()], &args.result, None)?;
    let report = progress::with("solving", || analysis::modes(&input.file.blade, &settings));
    let report = report.map_err(|faults| Failure::faults(&input.name, &faults))?;
    warn(&report.warnings);
    let text = match args.result.format {
        Format::Table => table(&report),
        Format::Json => json::line(&report)?,
        Format::Csv => csv::modes(&report)?,
    };
    Ok(Output::new(text, &args.result))
}

fn table(report: &ModesReport) -> String {
    let mut table = Table::new(MODE_COLUMNS.into_iter().chain([("residual", Align::Point)]));
    let margins = analysis::margins(report);
    for (index, mode) in report.modes.iter().enumerate() {
        let [nearest, distance] = margin_cells(margins.get(index));
        table.row([
            Cell::label(&mode.label, Some(mode.dof)),
            Cell::number(mode.frequency_rad_s, 5),
            Cell::number(mode.frequency_hz, 5),
            Cell::maybe(mode.per_rev, 4),
            nearest,
            distance,
            Cell::number(mode.residual, 1),
        ]);
    }
    heading(&report.blade, &speed(report.speed_rad_s), &basis(&report.basis)) + &table.render()
}
