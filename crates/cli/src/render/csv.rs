//! Results as CSV: units in the header row, numbers in the shortest form that reads back to the
//! same f64, an empty field where there is no value.
//!
//! Words come from blade files, which anybody may have written, and a spreadsheet takes a word that
//! begins like a formula for one. Such words get an apostrophe before them, as OWASP's page on CSV
//! injection says; numbers stay numbers.

use super::accuracy::percent;
use super::text::visible;
use crate::failure::Failure;
use bladefan_core::BasisFamily;
use bladefan_core::report::{
    BladeSummary, ConvergeReport, ConvergeSeries, CoupledModesReport, CoupledShapesReport, FanChart, ModesReport,
    ShapesReport,
};
use core::fmt::Display;
use csv::{QuoteStyle, WriterBuilder};

/// What a word must not begin with in a spreadsheet, which takes some wide letters for the narrow ones.
const FORMULA: [char; 11] = ['=', '+', '-', '@', '\t', '\r', '\n', '\u{FF1D}', '\u{FF0B}', '\u{FF0D}', '\u{FF20}'];

/// Room for one row before it is written.
const ROW: usize = 1024;

/// Rows under a header as one text.
fn write<R>(header: Vec<String>, rows: impl Iterator<Item = R>) -> Result<String, Failure>
where
    R: IntoIterator<Item = String>,
{
    let mut bytes = Vec::new();
    let rows = rows.map(|row| row.into_iter().collect());
    for row in core::iter::once(header).chain(rows) {
        record(&mut bytes, &row).map_err(|error| failed(&error))?;
    }
    String::from_utf8(bytes).map_err(|error| failed(&error))
}

/// One row. Where a semicolon could make a formula of what follows, as it parts fields in the
/// spreadsheets of many countries, the words are quoted, so that it parts nothing.
fn record(bytes: &mut Vec<u8>, row: &[String]) -> Result<(), csv::Error> {
    let mut after = row.iter().flat_map(|field| field.split(';').skip(1));
    let parts = after.any(|rest| rest.trim_start().starts_with(FORMULA));
    let style = if parts { QuoteStyle::NonNumeric } else { QuoteStyle::Necessary };
    let mut writer = WriterBuilder::new().quote_style(style).buffer_capacity(ROW).from_writer(bytes);
    writer.write_record(row)?;
    Ok(writer.flush()?)
}

fn failed(error: &dyn Display) -> Failure {
    Failure::Output(format!("CSV: cannot be written: {error}"))
}

fn names(header: &[&str]) -> Vec<String> {
    header.iter().map(words).collect()
}

/// A word, which neither a spreadsheet nor a terminal obeys.
fn words(text: impl AsRef<str>) -> String {
    let text = text.as_ref();
    let before = if text.starts_with(FORMULA) { "'" } else { "" };
    format!("{before}{}", visible(text))
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
                words(&report.blade),
                number(report.speed_rad_s),
                mode.label.to_string(),
                words(mode.dof.name()),
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

/// One row per mode of a coupled blade.
pub(crate) fn coupled_modes(report: &CoupledModesReport) -> Result<String, Failure> {
    let header = names(&[
        "blade",
        "rotor speed [rad/s]",
        "mode",
        "leading motion",
        "number",
        "flap share",
        "lag share",
        "torsion share",
        "frequency [rad/s]",
        "frequency [Hz]",
        "frequency [/rev]",
        "eigenvalue [1/s2]",
        "lower bound [rad/s]",
        "upper bound [rad/s]",
        "lower eigenvalue [1/s2]",
        "upper eigenvalue [1/s2]",
        "bounds missing",
        "error estimate [rad/s]",
        "separation [rad/s]",
        "classical [rad/s]",
        "converged [rad/s]",
        "nearest harmonic",
        "margin [/rev]",
    ]);
    write(
        header,
        report.modes.iter().map(|mode| {
            [
                words(&report.blade),
                number(report.speed_rad_s),
                mode.label.to_string(),
                words(mode.dof.name()),
                mode.number.to_string(),
                number(mode.shares.flap),
                number(mode.shares.lag),
                number(mode.shares.torsion),
                maybe(mode.frequency_rad_s),
                maybe(mode.frequency_hz),
                maybe(mode.per_rev),
                number(mode.eigenvalue_s2),
                maybe(mode.lower_rad_s),
                maybe(mode.upper_rad_s),
                maybe(mode.lower_eigenvalue_s2),
                maybe(mode.upper_eigenvalue_s2),
                words(mode.bounds_missing.unwrap_or_default()),
                maybe(mode.error_estimate_rad_s),
                maybe(mode.separation_rad_s),
                maybe(mode.classical_rad_s),
                maybe(mode.converged_rad_s),
                mode.nearest_harmonic.map(|harmonic| harmonic.to_string()).unwrap_or_default(),
                maybe(mode.margin_per_rev),
            ]
        }),
    )
}

/// One row per rotor speed, one column per branch.
pub(crate) fn fan(chart: &FanChart) -> Result<String, Failure> {
    let mut header = names(&["rotor speed [rad/s]"]);
    header.extend(chart.branches.iter().map(|branch| words(format!("{} [rad/s]", branch.label))));
    write(
        header,
        chart.speeds_rad_s.iter().enumerate().map(|(index, speed)| {
            let values = chart.branches.iter().map(move |branch| maybe(branch.frequency_rad_s.get(index).copied()));
            core::iter::once(number(*speed)).chain(values)
        }),
    )
}

/// One row per radius, ten columns per mode.
pub(crate) fn coupled_shapes(report: &CoupledShapesReport) -> Result<String, Failure> {
    let mut header = names(&["r [m]"]);
    let columns = [
        "flap",
        "flap slope [1/m]",
        "flap moment [N·m]",
        "flap force [N]",
        "lag",
        "lag slope [1/m]",
        "lag moment [N·m]",
        "lag force [N]",
        "torsion [rad]",
        "torsion moment [N·m]",
    ];
    for shape in &report.shapes {
        header.extend(columns.map(|name| words(format!("{} {name}", shape.label))));
    }
    write(
        header,
        report.r_m.iter().enumerate().map(|(index, radius)| {
            let values = report.shapes.iter().flat_map(move |shape| {
                let (flap, lag, torsion) = (&shape.components.flap, &shape.components.lag, &shape.components.torsion);
                let bending = [flap, lag].map(|bent| [&bent.displacement, &bent.slope, &bent.moment, &bent.force]);
                let twisted = [&torsion.twist, &torsion.moment];
                let lists = bending.into_iter().flatten().chain(twisted);
                lists.map(|list| maybe(list.get(index).copied())).collect::<Vec<_>>()
            });
            core::iter::once(number(*radius)).chain(values)
        }),
    )
}

/// One row per radius, three columns per mode.
pub(crate) fn shapes(report: &ShapesReport) -> Result<String, Failure> {
    let mut header = names(&["r [m]"]);
    for shape in &report.shapes {
        header.extend(
            ["displacement", "slope [1/m]", "moment [N·m]"].map(|name| words(format!("{} {name}", shape.label))),
        );
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
                    words(family.name()),
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
                words(&summary.blade),
                words(dof.dof.name()),
                words(dof.root),
                number(dof.offset_m),
                maybe(dof.spring_n_m),
                number(dof.mass_kg),
                maybe(dof.static_moment_kg_m),
                number(dof.inertia_kg_m2),
            ]
        }),
    )
}

/// One row per built-in blade: name, title, quality, citation.
pub(crate) fn blades<'a>(rows: impl Iterator<Item = [&'a str; 4]>) -> Result<String, Failure> {
    write(names(&["name", "title", "quality", "citation"]), rows.map(|row| row.map(words)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use bladefan_core::Dof;
    use bladefan_core::report::DofSummary;

    /// A list of one blade, without its header.
    fn listed(row: [&str; 4]) -> String {
        let text = blades([row].into_iter()).unwrap();
        text.strip_prefix("name,title,quality,citation\n").unwrap().into()
    }

    #[test]
    fn words_that_begin_like_a_formula_get_an_apostrophe() {
        let row = ["=HYPERLINK(\"http://a\",\"b\")", "+1", "-1.5", "@SUM(A1)"];
        assert_eq!(listed(row), "\"'=HYPERLINK(\"\"http://a\"\",\"\"b\"\")\",'+1,'-1.5,'@SUM(A1)\n");
        let row = ["\t=1", "\r=1", "\n=1", "\u{FF1D}1"];
        assert_eq!(listed(row), "'\\t=1,'\\r=1,'\\n=1,'\u{FF1D}1\n");
        let row = ["=cmd|' /C calc'!A0", "a=b", "1-2", "'=1"];
        assert_eq!(listed(row), "'=cmd|' /C calc'!A0,a=b,1-2,'=1\n", "inside a word they are harmless");
    }

    #[test]
    fn a_semicolon_begins_no_field() {
        assert_eq!(listed(["a; =1+1", "b", "", "c"]), "\"a; =1+1\",\"b\",\"\",\"c\"\n");
        assert_eq!(listed(["a; 1=1", "b", "", "c"]), "a; 1=1,b,,c\n", "no formula");
    }

    #[test]
    fn control_characters_are_written_out() {
        assert_eq!(listed(["\u{1b}Pa", "b\u{1b}]c", "\u{7f}", "d\ne"]), "\\u{1b}Pa,b\\u{1b}]c,\\u{7f},d\\ne\n");
    }

    #[test]
    fn numbers_stay_numbers() {
        let dof = DofSummary {
            dof: Dof::Flap,
            root: "hinged",
            offset_m: -1.5,
            spring_n_m: None,
            mass_kg: 0.1,
            static_moment_kg_m: Some(-1e-300),
            inertia_kg_m2: 1.0 / 3.0,
        };
        let report = BladeSummary { blade: "-1.5".into(), dofs: vec![dof], ..BladeSummary::default() };
        let text = summary(&report).unwrap();
        assert_eq!(text.lines().nth(1), Some("'-1.5,flap,hinged,-1.5,,0.1,-1e-300,0.3333333333333333"));
    }
}
