//! `shapes`: mode shapes along the span.

use crate::args::{Format, ShapesArgs};
use crate::failure::Failure;
use crate::io::input;
use crate::io::messages::warn;
use crate::io::output::{self, Output};
use crate::render::columns::pick;
use crate::render::heading::{basis, heading_of, speed};
use crate::render::table::{Align, Cell, Table};
use crate::render::{csv, json, picture};
use bladefan_core::Dof;
use bladefan_core::chart;
use bladefan_core::figures::{decimals, significant};
use bladefan_core::report::{CoupledShapesReport, ShapesReport};
use bladefan_core::{Model, ModelKind, Settings, ShapeScale};
use core::fmt::Write as _;

/// Most radii of the table.
const RADII: usize = 11;

pub(super) fn run(args: &ShapesArgs) -> Result<Output, Failure> {
    let settings = args.settings()?;
    let input = input::load(&args.blade.blade)?;
    output::check(&[input.path.as_ref()], &args.result, Some(&args.drawing))?;
    warn(&args.idle(&settings));
    if settings.model == ModelKind::Coupled {
        let report = input.ask("solving", |blade| bladefan_core::coupled_shapes(blade, &settings))?;
        warn(&report.warnings);
        let text = match args.result.format {
            Format::Table => coupled_table(&report, output::width(&args.result)),
            Format::Json => json::line(&report)?,
            Format::Csv => csv::coupled_shapes(&report)?,
        };
        let draw = || chart::coupled_shapes(&report, &picture::options(&args.drawing));
        let drawings = picture::files(&args.drawing, draw)?;
        return Ok(Output::new(text, &args.result).with(drawings));
    }
    let report = input.ask("solving", |blade| bladefan_core::shapes(blade, &settings))?;
    warn(&report.warnings);
    let text = match args.result.format {
        Format::Table => table(&report, &settings, output::width(&args.result)),
        Format::Json => json::line(&report)?,
        Format::Csv => csv::shapes(&report)?,
    };
    let drawings = picture::files(&args.drawing, || chart::shapes(&report, &picture::options(&args.drawing)))?;
    Ok(Output::new(text, &args.result).with(drawings))
}

/// One table per mode: a row for each of some radii, a column for each motion.
fn coupled_table(report: &CoupledShapesReport, width: usize) -> String {
    let title = format!("mode shapes at {}", speed(report.speed_rad_s));
    let basis = format!("{} piecewise functions", report.functions);
    let mut text = heading_of(&report.blade, &title, &basis, &report.model.words(), width);
    text.push_str(
        "Flap out of the disc plane, lag in it; the largest of the leading motion is 1 with --normalise max\n",
    );
    let rows = pick(report.r_m.len(), RADII);
    for shape in &report.shapes {
        let headers = ["r [m]", "flap", "lag", "torsion\n[rad]"].map(|header| (header, Align::Point));
        let mut table = Table::new(headers);
        for &row in &rows {
            let values = Dof::ALL.iter().map(|dof| shape.components.leading(*dof).get(row));
            let cells = values.map(|value| value.map_or_else(|| Cell::text("-"), |value| Cell::fixed(*value, 5)));
            let radius = report.r_m.get(row).map(|radius| Cell::fixed(*radius, decimals(report.radius_m, 5)));
            table.row(radius.into_iter().chain(cells));
        }
        let frequency = shape
            .frequency_rad_s
            .map_or_else(|| String::from("unstable"), |frequency| format!("{} rad/s", significant(frequency, 5)));
        let _ = write!(text, "\n{}, {frequency}\n{}", shape.label, table.render(width));
    }
    text
}

/// One table per degree of freedom: a row for each of some radii, a column for each mode.
fn table(report: &ShapesReport, settings: &Settings, width: usize) -> String {
    let title = format!("mode shapes at {}", speed(report.speed_rad_s));
    let mut text = heading_of(&report.blade, &title, &basis(&report.basis), Model::of(settings).words(), width);
    text.push_str(match settings.normalise {
        ShapeScale::Max => "Displacement, 1 where it is largest\n\n",
        ShapeScale::Mass => "Displacement, scaled by mass (the paper's Eq. 86-87)\n\n",
    });
    let rows = pick(report.r_m.len(), RADII);
    let mut tables = Vec::new();
    for dof in Dof::ALL {
        let shapes: Vec<_> = report.shapes.iter().filter(|shape| shape.dof == dof).collect();
        if shapes.is_empty() {
            continue;
        }
        let labels =
            shapes.iter().map(|shape| format!("{}\n{} rad/s", shape.label, significant(shape.frequency_rad_s, 4)));
        let headers = core::iter::once(String::from("r [m]")).chain(labels);
        let mut table = Table::new(headers.map(|header| (header, Align::Point)));
        let places: Vec<usize> = shapes
            .iter()
            .map(|shape| decimals(shape.displacement.iter().fold(0.0, |most, value| f64::max(most, value.abs())), 5))
            .collect();
        for &row in &rows {
            let values = shapes.iter().zip(&places).map(|(shape, places)| {
                shape.displacement.get(row).map_or_else(|| Cell::text("-"), |value| Cell::fixed(*value, *places))
            });
            let radius = report.r_m.get(row).map(|radius| Cell::fixed(*radius, decimals(report.radius_m, 5)));
            table.row(radius.into_iter().chain(values));
        }
        tables.push(format!("{dof}\n{}", table.render(width)));
    }
    text.push_str(&tables.join("\n"));
    text
}
