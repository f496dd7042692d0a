//! `fan`: the fan chart.

use crate::args::{FanArgs, Format};
use crate::failure::Failure;
use crate::io::messages::warn;
use crate::io::output::{self, Output};
use crate::io::{input, measured};
use crate::render::columns::{MARGIN_COLUMNS, MODE_COLUMNS, margin_cells, pick};
use crate::render::heading::{basis, heading_of, speed};
use crate::render::table::{Align, Cell, Table};
use crate::render::text::wrap;
use crate::render::{csv, json, picture};
use bladefan_core::Dof;
use bladefan_core::Label;
use bladefan_core::Model;
use bladefan_core::Settings;
use bladefan_core::chart::{self, ChartOptions};
use bladefan_core::figures::{short, significant};
use bladefan_core::report::{Coincidence, ComparedPoint, FanChart, ModelReport};
use bladefan_core::units::{hz, rpm};
use core::fmt::Write as _;
use serde::Serialize;

/// Most rotor speeds of the table.
const SPEEDS: usize = 7;

/// The chart with the measured points beside it.
#[derive(Serialize)]
struct Report<'a> {
    #[serde(flatten)]
    chart: &'a FanChart,
    #[serde(skip_serializing_if = "Option::is_none")]
    measured: Option<&'a [ComparedPoint]>,
}

pub(super) fn run(args: &FanArgs) -> Result<Output, Failure> {
    let (settings, frequencies) = args.settings()?;
    let input = input::load(&args.blade.blade)?;
    output::check(&[input.path.as_ref(), args.measured.as_ref()], &args.result, Some(&args.drawing))?;
    let points = args.measured.as_deref().map(measured::read).transpose()?;
    let chart = input.ask("solving", |blade| bladefan_core::fan(blade, &settings))?;
    warn(&args.idle(&settings));
    warn(&chart.warnings);
    let compare = |points: &Vec<_>| input.ask("comparing", |blade| bladefan_core::compare(blade, points, &settings));
    // CSV holds the branches alone.
    let compared = points.as_ref().filter(|_| args.result.format != Format::Csv).map(compare).transpose()?;
    let text = match args.result.format {
        Format::Table => table(&chart, &settings, compared.as_deref(), output::width(&args.result)),
        Format::Json => json::line(&Report { chart: &chart, measured: compared.as_deref() })?,
        Format::Csv => csv::fan(&chart)?,
    };
    let draw = || {
        let points = points.as_deref().unwrap_or_default();
        let options = ChartOptions {
            frequency_unit: args.frequency.frequency_unit,
            frequencies,
            band: settings.band,
            measured: points,
            ..picture::options(&args.drawing)
        };
        chart::fan(&chart, &options)
    };
    let drawings = picture::files(&args.drawing, draw)?;
    Ok(Output::new(text, &args.result).with(drawings))
}

fn table(chart: &FanChart, settings: &Settings, compared: Option<&[ComparedPoint]>, width: usize) -> String {
    let from = chart.speeds_rad_s.first().copied().unwrap_or_default();
    let to = chart.speeds_rad_s.last().copied().unwrap_or_default();
    let title = format!("{} speeds from {} to {}", chart.speeds_rad_s.len(), short(from, 4), speed(to));
    let model = chart.model.as_ref().map_or_else(|| Model::of(settings).words().into(), ModelReport::words);
    let mut text = heading_of(&chart.blade, &title, &basis(&chart.basis), &model, width);
    let mut section = |title: &str, table: &Table| {
        if !table.is_empty() {
            let _ = writeln!(text, "{}\n{}", wrap(title, 0, width), table.render(width));
        }
    };
    section("Frequency [rad/s] at rotor speeds", &branches(chart));
    section(&format!("At nominal speed, {}", speed(chart.nominal.speed_rad_s)), &margins(chart));
    let band = format!("{} to {} of nominal speed", settings.band.0, settings.band.1);
    section(
        &format!("Crossings: rotor speed [rpm] at which a mode meets a ray; * within {band}"),
        &all(chart, settings),
    );
    section(&format!("Crossings within {band}"), &near(chart, settings));
    section("Branches that come near one another", &veerings(chart));
    if let Some(compared) = compared {
        section("Measured points, and the solver at their rotor speeds", &points(chart, compared));
    }
    text.truncate(text.trim_end().len());
    text.push('\n');
    text
}

fn dof(chart: &FanChart, label: Label) -> Option<Dof> {
    chart.branches.iter().find(|branch| branch.label == label).map(|branch| branch.dof)
}

/// Branches at some of the rotor speeds.
fn branches(chart: &FanChart) -> Table {
    let picked = pick(chart.speeds_rad_s.len(), SPEEDS);
    let speeds = picked.iter().filter_map(|index| chart.speeds_rad_s.get(*index));
    let headers = speeds.map(|speed| (format!("{} rpm", short(rpm(*speed), 4)), Align::Point));
    let mut table = Table::new(core::iter::once((String::from("mode"), Align::Left)).chain(headers));
    for branch in &chart.branches {
        let values = picked.iter().map(|index| Cell::maybe(branch.frequency_rad_s.get(*index).copied(), 5));
        table.row(core::iter::once(Cell::label(&branch.label, Some(branch.dof))).chain(values));
    }
    table
}

/// Every branch at nominal speed with the harmonic it is nearest to, and its Southwell line.
fn margins(chart: &FanChart) -> Table {
    let southwell = [("Southwell k0\n[rad²/s²]", Align::Point), ("k1", Align::Point)];
    let mut table = Table::new(MODE_COLUMNS.into_iter().chain(MARGIN_COLUMNS).chain(southwell));
    for branch in &chart.branches {
        let margin = chart.nominal.margins.iter().find(|margin| margin.label == branch.label);
        let frequency = margin.map(|margin| margin.per_rev * chart.nominal.speed_rad_s);
        let [nearest, distance] = margin_cells(margin);
        table.row([
            Cell::label(&branch.label, Some(branch.dof)),
            Cell::maybe(frequency, 5),
            Cell::maybe(frequency.map(hz), 5),
            Cell::maybe(margin.map(|margin| margin.per_rev), 4),
            nearest,
            distance,
            Cell::number(branch.southwell.k0, 5),
            Cell::number(branch.southwell.k1, 5),
        ]);
    }
    table
}

/// All crossings: a row for each branch that has any, a column for each ray.
fn all(chart: &FanChart, settings: &Settings) -> Table {
    let rays = (1..=chart.harmonics).map(|harmonic| (format!("{harmonic}P"), Align::Point));
    let mut table = Table::new(core::iter::once((String::from("mode"), Align::Left)).chain(rays));
    for branch in &chart.branches {
        let cell = |harmonic: u32| {
            let on_ray = |on: &Coincidence| on.label == branch.label && on.harmonic == harmonic;
            if chart.coincident.iter().any(on_ray) {
                return "all".into();
            }
            let here = chart.crossings.iter().filter(|at| at.label == branch.label && at.harmonic == harmonic);
            let speeds: Vec<String> = here
                .map(|at| {
                    let mark = if chart.in_band(at.speed_rad_s, settings.band) { "*" } else { "" };
                    format!("{}{mark}", significant(rpm(at.speed_rad_s), 4))
                })
                .collect();
            speeds.join(", ")
        };
        let cells: Vec<String> = (1..=chart.harmonics).map(cell).collect();
        if cells.iter().any(|cell| !cell.is_empty()) {
            let label = Cell::label(&branch.label, Some(branch.dof));
            table.row(core::iter::once(label).chain(cells.iter().map(Cell::text)));
        }
    }
    table
}

/// Crossings inside the operating band.
fn near(chart: &FanChart, settings: &Settings) -> Table {
    let mut table = Table::new([
        ("mode", Align::Left),
        ("ray", Align::Left),
        ("rotor speed\n[rpm]", Align::Point),
        ("\n[rad/s]", Align::Point),
        ("of\nnominal", Align::Point),
        ("frequency\n[rad/s]", Align::Point),
        ("\n[Hz]", Align::Point),
    ]);
    for at in chart.crossings_in(settings.band) {
        table.row([
            Cell::label(&at.label, dof(chart, at.label)),
            Cell::text(format!("{}P", at.harmonic)),
            Cell::number(rpm(at.speed_rad_s), 5),
            Cell::number(at.speed_rad_s, 5),
            Cell::fixed(at.speed_rad_s / chart.nominal.speed_rad_s, 3),
            Cell::number(at.frequency_rad_s, 5),
            Cell::number(hz(at.frequency_rad_s), 5),
        ]);
    }
    table
}

/// Where branches of a coupled blade cross or turn away from one another.
fn veerings(chart: &FanChart) -> Table {
    let mut table = Table::new([
        ("modes", Align::Left),
        ("", Align::Left),
        ("rotor speed\n[rpm]", Align::Point),
        ("frequency\n[rad/s]", Align::Point),
        ("gap\n[rad/s]", Align::Point),
    ]);
    for veering in &chart.veerings {
        let names =
            veering.branches.map(|index| chart.branches.get(index).map_or_else(String::new, |b| b.label.to_string()));
        table.row([
            Cell::text(names.join(", ")),
            Cell::text(veering.kind),
            Cell::number(rpm(veering.speed_rad_s), 4),
            Cell::number(veering.frequency_rad_s, 5),
            Cell::number(veering.gap_rad_s, 3),
        ]);
    }
    table
}

fn points(chart: &FanChart, compared: &[ComparedPoint]) -> Table {
    let mut table = Table::new([
        ("mode", Align::Left),
        ("rotor speed\n[rpm]", Align::Point),
        ("measured\n[rad/s]", Align::Point),
        ("computed\n[rad/s]", Align::Point),
        ("error\n[%]", Align::Point),
        ("source", Align::Left),
    ]);
    for point in compared {
        table.row([
            Cell::label(&point.label, dof(chart, point.label)),
            Cell::number(rpm(point.speed_rad_s), 4),
            Cell::number(point.frequency_rad_s, 5),
            Cell::maybe(point.computed_rad_s, 5),
            point.error_percent.map_or_else(|| Cell::text("-"), |error| Cell::signed(error, 2)),
            Cell::text(&point.source),
        ]);
    }
    table
}
