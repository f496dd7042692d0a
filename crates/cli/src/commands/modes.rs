//! `modes`: frequencies at one rotor speed.

use crate::args::{Format, ModesArgs};
use crate::failure::Failure;
use crate::io::input;
use crate::io::messages::warn;
use crate::io::output::{self, Output};
use crate::render::accuracy::{Bounded, advice, bounds_cell, difference, difference_cell, percent};
use crate::render::columns::{MARGIN_COLUMNS, MODE_COLUMNS, margin_cells, own};
use crate::render::heading::{basis, heading_of, speed};
use crate::render::table::{Align, Cell, Table};
use crate::render::{csv, json};
use bladefan_core::report::{CoupledModeReport, CoupledModesReport, ModeReport, ModesReport};
use bladefan_core::{BasisFamily, Model, ModelKind, Settings};

pub(super) fn run(args: &ModesArgs) -> Result<Output, Failure> {
    let settings = args.settings()?;
    let input = input::load(&args.blade.blade)?;
    output::check(&[input.path.as_ref()], &args.result, None)?;
    let width = output::width(&args.result);
    let (text, warnings) = match settings.model {
        ModelKind::Uncoupled => {
            let report = input.ask("solving", |blade| bladefan_core::modes(blade, &settings))?;
            let text = match args.result.format {
                Format::Table => table(&report, &settings, width),
                Format::Json => json::line(&report)?,
                Format::Csv => csv::modes(&report)?,
            };
            (text, report.warnings)
        }
        ModelKind::Coupled => {
            let report = input.ask("solving", |blade| bladefan_core::coupled_modes(blade, &settings))?;
            let text = match args.result.format {
                Format::Table => coupled_table(&report, width),
                Format::Json => json::line(&report)?,
                Format::Csv => csv::coupled_modes(&report)?,
            };
            (text, report.warnings)
        }
    };
    warn(&args.idle(&settings));
    warn(&warnings);
    Ok(Output::new(text, &args.result))
}

fn coupled_table(report: &CoupledModesReport, width: usize) -> String {
    let shares = [("flap\n[%]", Align::Point), ("lag\n[%]", Align::Point), ("torsion\n[%]", Align::Point)];
    let bounds = [(String::from("bounds\n[rad/s]"), Align::Left)];
    let headers = MODE_COLUMNS.map(own).into_iter().chain(bounds).chain(shares.map(own)).chain(MARGIN_COLUMNS.map(own));
    let mut table = Table::new(headers);
    let bounded = |mode: &CoupledModeReport| Bounded::new(mode.frequency_rad_s, mode.lower_rad_s, mode.upper_rad_s);
    for mode in &report.modes {
        let share = |share: f64| Cell::fixed(100.0 * share, 1);
        let nearest = mode.nearest_harmonic.map_or_else(|| "-".into(), |harmonic| format!("{harmonic}P"));
        table.row([
            Cell::label(&mode.label, Some(mode.dof)),
            mode.frequency_rad_s.map_or_else(|| Cell::text("unstable"), |frequency| Cell::number(frequency, 5)),
            Cell::maybe(mode.frequency_hz, 5),
            Cell::maybe(mode.per_rev, 4),
            match mode.error_estimate_rad_s {
                Some(error) => Cell::text(format!("{} (about {error:.0e})", mode.bounds_missing.unwrap_or_default())),
                None => bounds_cell(bounded(mode)),
            },
            share(mode.shares.flap),
            share(mode.shares.lag),
            share(mode.shares.torsion),
            Cell::text(nearest),
            mode.margin_per_rev.map_or_else(|| Cell::text("-"), |margin| Cell::signed(margin, 3)),
        ]);
    }
    let basis = format!("{} piecewise functions", report.functions);
    let heading = heading_of(&report.blade, &speed(report.speed_rad_s), &basis, &report.model.words(), width);
    heading + &table.render(width)
}

fn table(report: &ModesReport, settings: &Settings, width: usize) -> String {
    let family = report.basis.family;
    // Either way it is the paper's functions against the converged frequency. Bounds far apart leave
    // no room for a unit in every row.
    let paper = match family {
        BasisFamily::Classical => String::from("error\n[%]"),
        BasisFamily::Piecewise => format!("paper\nN={}", settings.functions),
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
    let model = Model::of(settings);
    let basis = basis(&report.basis);
    let heading = heading_of(&report.blade, &speed(report.speed_rad_s), &basis, model.words(), width);
    heading + &table.render(width) + &advice(family, report.modes.iter().map(bounded), width)
}
