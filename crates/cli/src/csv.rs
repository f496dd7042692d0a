//! Results as CSV: units in the header row, numbers in the shortest form that reads back to the
//! same f64, an empty field where there is no value.

use crate::commands::accuracy::percent;
use crate::commands::blades::Listed;
use crate::failure::Failure;
use bladefan_core::functions::BasisFamily;
use bladefan_core::report::{BladeSummary, ConvergeReport, ConvergeSeries, FanChart, ModesReport, ShapesReport};
use core::fmt::Display;

/// Rows under a header as one text.
fn write<R>(header: Vec<String>, rows: impl Iterator<Item = R>) -> Result<String, Failure>
where
    R: IntoIterator<Item = String>,
{
    let failed = |error: &dyn Display| Failure::Output(format!("CSV: cannot be written: {error}"));
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(header).map_err(|error| failed(&error))?;
    for row in rows {
        writer.write_record(row).map_err(|error| failed(&error))?;
    }
    let bytes = writer.into_inner().map_err(|error| failed(&error))?;
    String::from_utf8(bytes).map_err(|error| failed(&error))
}

fn names(header: &[&str]) -> Vec<String> {
    header.iter().map(|name| String::from(*name)).collect()
}

/// The shortest decimal that reads back to the same f64; never an exponent-free row of 300 zeros.
fn number(value: f64) -> String {
    format!("{value:?}")
}

fn maybe(value: Option<f64>) -> String {
    value.map(number).unwrap_or_default()
}

/// One row per mode.
pub(crate) fn modes(report: &ModesReport) -> Result<String, Failure> {
    let header = names(&[
        "blade",
        "rotor speed [rad/s]",
        "mode",
        "degree of freedom",
        "number",
        "frequency [rad/s]",
        "frequency [Hz]",
        "frequency [/rev]",
        "lower bound [rad/s]",
        "upper bound [rad/s]",
        "separation [rad/s]",
        "classical [rad/s]",
        "converged [rad/s]",
        "residual",
        "nearest harmonic",
        "margin [/rev]",
    ]);
    write(
        header,
        report.modes.iter().map(|mode| {
            [
                report.blade.clone(),
                number(report.speed_rad_s),
                mode.label.to_string(),
                mode.dof.to_string(),
                mode.number.to_string(),
                number(mode.frequency_rad_s),
                number(mode.frequency_hz),
                maybe(mode.per_rev),
                maybe(mode.lower_rad_s),
                maybe(mode.upper_rad_s),
                maybe(mode.separation_rad_s),
                maybe(mode.classical_rad_s),
                maybe(mode.converged_rad_s),
                number(mode.residual),
                mode.nearest_harmonic.map(|harmonic| harmonic.to_string()).unwrap_or_default(),
                maybe(mode.margin_per_rev),
            ]
        }),
    )
}

/// One row per rotor speed, one column per branch.
pub(crate) fn fan(chart: &FanChart) -> Result<String, Failure> {
    let mut header = names(&["rotor speed [rad/s]"]);
    header.extend(chart.branches.iter().map(|branch| format!("{} [rad/s]", branch.label)));
    write(
        header,
        chart.speeds_rad_s.iter().enumerate().map(|(index, speed)| {
            let values = chart.branches.iter().map(move |branch| maybe(branch.frequency_rad_s.get(index).copied()));
            core::iter::once(number(*speed)).chain(values)
        }),
    )
}

/// One row per radius, three columns per mode.
pub(crate) fn shapes(report: &ShapesReport) -> Result<String, Failure> {
    let mut header = names(&["r [m]"]);
    for shape in &report.shapes {
        header.extend(["displacement", "slope [1/m]", "moment [N·m]"].map(|name| format!("{} {name}", shape.label)));
    }
    write(
        header,
        report.r_m.iter().enumerate().map(|(index, radius)| {
            let values = report.shapes.iter().flat_map(move |shape| {
                [&shape.displacement, &shape.slope, &shape.moment].map(|list| maybe(list.get(index).copied()))
            });
            core::iter::once(number(*radius)).chain(values)
        }),
    )
}

/// One row per mode, family and number of functions; the error is against the converged frequency.
pub(crate) fn converge(report: &ConvergeReport) -> Result<String, Failure> {
    let header = names(&["mode", "family", "functions", "frequency [rad/s]", "error [%]"]);
    let families = |series: &ConvergeSeries| {
        [
            (BasisFamily::Classical, report.functions.clone(), series.classical_rad_s.clone()),
            (BasisFamily::Piecewise, series.piecewise_functions.clone(), series.piecewise_rad_s.clone()),
        ]
    };
    let rows = report.series.iter().flat_map(|series| {
        families(series).into_iter().flat_map(move |(family, functions, values)| {
            functions.into_iter().zip(values).map(move |(count, value)| {
                [
                    series.label.to_string(),
                    family.name().into(),
                    count.to_string(),
                    maybe(value),
                    maybe(percent(value, series.converged_rad_s)),
                ]
            })
        })
    });
    write(header, rows)
}

/// One row per degree of freedom.
pub(crate) fn summary(summary: &BladeSummary) -> Result<String, Failure> {
    let header = names(&[
        "blade",
        "degree of freedom",
        "root",
        "offset [m]",
        "spring [N·m/rad]",
        "mass [kg]",
        "static moment [kg·m]",
        "inertia [kg·m²]",
    ]);
    write(
        header,
        summary.dofs.iter().map(|dof| {
            [
                summary.blade.clone(),
                dof.dof.to_string(),
                dof.root.to_string(),
                number(dof.offset_m),
                maybe(dof.spring_n_m),
                number(dof.mass_kg),
                maybe(dof.static_moment_kg_m),
                number(dof.inertia_kg_m2),
            ]
        }),
    )
}

/// One row per built-in blade.
pub(crate) fn blades(list: &[Listed]) -> Result<String, Failure> {
    let rows = list.iter().map(|blade| [&blade.name, &blade.title, &blade.quality, &blade.citation].map(String::clone));
    write(names(&["name", "title", "quality", "citation"]), rows)
}
