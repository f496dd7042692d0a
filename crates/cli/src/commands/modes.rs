//! `modes`: frequencies at one rotor speed.

use crate::args::{Format, ModesArgs};
use crate::failure::Failure;
use crate::io::input;
use crate::io::messages::warn;
use crate::io::output::{self, Output};
use crate::render::accuracy::{Bounded, advice, bounds_cell, difference, difference_cell, percent};
use crate::render::columns::{MARGIN_COLUMNS, MODE_COLUMNS, margin_cells, own};
use crate::render::heading::{basis, heading, speed};
use crate::render::table::{Align, Cell, Table};
use crate::render::{csv, json};
use bladefan_core::BasisFamily;
use bladefan_core::report::{ModeReport, ModesReport};

pub(super) fn run(args: &ModesArgs) -> Result<Output, Failure> {
    let settings = args.settings()?;
    let input = input::load(&args.blade.blade)?;
    output::check(&[input.path.as_ref()], &args.result, None)?;
    let report = input.ask("solving", |blade| bladefan_core::modes(blade, &settings))?;
    warn(&report.warnings);
    let text = match args.result.format {
        Format::Table => table(&report, settings.functions, output::width(&args.result)),
        Format::Json => json::line(&report)?,
        Format::Csv => csv::modes(&report)?,
    };
    Ok(Output::new(text, &args.result))
}

fn table(report: &ModesReport, functions: usize, width: usize) -> String {
    let family = report.basis.family;
    // Either way it is the paper's functions against the converged frequency. Bounds far apart leave
    // no room for a unit in every row.
    let paper = match family {
        BasisFamily::Classical => String::from("error\n[%]"),
        BasisFamily::Piecewise => format!("paper\nN={functions}"),
    };
    let accuracy = [(String::from("bounds\n[rad/s]"), Align::Left), (paper, Align::Point)];
    let mut table = Table::new(MODE_COLUMNS.map(own).into_iter().chain(accuracy).chain(MARGIN_COLUMNS.map(own)));
    let margins = bladefan_core::margins(report);
    let bounded = |mode: &ModeReport| Bounded::new(Some(mode.frequency_rad_s), mode.lower_rad_s, mode.upper_rad_s);
    for (index, mode) in report.modes.iter().enumerate() {
        let [nearest, distance] = margin_cells(margins.get(index));
        let error = percent(mode.classical_rad_s, mode.converged_rad_s);
        table.row([
            Cell::label(&mode.label, Some(mode.dof)),
            Cell::number(mode.frequency_rad_s, 5),
            Cell::number(mode.frequency_hz, 5),
            Cell::maybe(mode.per_rev, 4),
            bounds_cell(bounded(mode)),
            match family {
                BasisFamily::Classical => Cell::text(difference(error)),
                BasisFamily::Piecewise => difference_cell(error),
            },
            nearest,
            distance,
        ]);
    }
    let heading = heading(&report.blade, &speed(report.speed_rad_s), &basis(&report.basis), width);
    heading + &table.render(width) + &advice(family, report.modes.iter().map(bounded), width)
}
