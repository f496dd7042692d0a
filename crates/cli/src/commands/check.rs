//! `check`: faults of a blade, or what it amounts to.

use crate::args::{CheckArgs, Format};
use crate::failure::Failure;
use crate::io::input;
use crate::io::messages::warn;
use crate::io::output::{self, Output};
use crate::render::heading::speed;
use crate::render::table::{Align, Cell, Table};
use crate::render::text::wrap;
use crate::render::{csv, json};
use bladefan_core::figures::short;
use bladefan_core::report::BladeSummary;

pub(super) fn run(args: &CheckArgs) -> Result<Output, Failure> {
    let input = input::load(&args.blade.blade)?;
    output::check(&[input.path.as_ref()], &args.result, None)?;
    let summary = bladefan_core::summary(&input.file.blade);
    warn(&summary.warnings);
    let text = match args.result.format {
        Format::Table => table(&summary, output::width(&args.result)),
        Format::Json => json::line(&summary)?,
        Format::Csv => csv::summary(&summary)?,
    };
    Ok(Output::new(text, &args.result))
}

fn table(summary: &BladeSummary, width: usize) -> String {
    let warnings = match summary.warnings.len() {
        0 => "no warnings".into(),
        1 => "1 warning".into(),
        count => format!("{count} warnings"),
    };
    let blades = summary.blades.map(|count| format!("{count} blades, ")).unwrap_or_default();
    let first = format!("{}: no faults, {warnings}", summary.blade);
    let second = format!(
        "radius {} m, nominal speed {}, {blades}{} stations",
        short(summary.radius_m, 5),
        speed(summary.nominal_speed_rad_s),
        summary.stations
    );
    let mut text = format!("{}\n{}\n\n", wrap(&first, 0, width), wrap(&second, 0, width));
    let mut table = Table::new([
        ("", Align::Left),
        ("root", Align::Left),
        ("offset\n[m]", Align::Point),
        ("spring\n[N·m/rad]", Align::Point),
        ("mass\n[kg]", Align::Point),
        ("static moment\n[kg·m]", Align::Point),
        ("inertia\n[kg·m²]", Align::Point),
    ]);
    for dof in &summary.dofs {
        table.row([
            Cell::label(&dof.dof, Some(dof.dof)),
            Cell::text(dof.root),
            Cell::number(dof.offset_m, 5),
            Cell::maybe(dof.spring_n_m, 5),
            Cell::number(dof.mass_kg, 5),
            Cell::maybe(dof.static_moment_kg_m, 5),
            Cell::number(dof.inertia_kg_m2, 5),
        ]);
    }
    text.push_str(&table.render(width));
    text
}
