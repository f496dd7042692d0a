//! `blades`: the built-in library.

use crate::args::{BladesArgs, Format};
use crate::failure::Failure;
use crate::input::{self, not_found};
use crate::output::{self, Output};
use crate::table::{Align, Cell, Table, WIDTH, wrap};
use crate::{csv, json};
use bladefan_core::formats;
use bladefan_core::library::{self, ENTRIES};
use core::fmt::Write as _;
use serde::Serialize;

/// What the list says of one blade.
#[derive(Debug, Serialize)]
pub(crate) struct Listed {
    pub(crate) name: String,
    pub(crate) title: String,
    pub(crate) quality: String,
    pub(crate) citation: String,
}

#[derive(Serialize)]
struct List {
    schema: &'static str,
    blades: Vec<Listed>,
}

pub(super) fn run(args: &BladesArgs) -> Result<Output, Failure> {
    output::check(&[], &args.result, None)?;
    let text = match &args.name {
        Some(name) => one(name, args.result.format)?,
        None => list(args.result.format)?,
    };
    Ok(Output::new(text, &args.result))
}

/// The file of one blade: TOML as it stands, with its remarks, or JSON.
fn one(name: &str, format: Format) -> Result<String, Failure> {
    let entry = library::find(name).ok_or_else(|| not_found(name, "no built-in blade of this name"))?;
    match format {
        Format::Table => Ok(entry.toml.into()),
        Format::Json => Ok(formats::to_json(&input::load(name)?.file.definition)),
        Format::Csv => Err(Failure::input("--format: must be table (TOML) or json for a blade file (is csv)")),
    }
}

fn list(format: Format) -> Result<String, Failure> {
    let blades: Result<Vec<Listed>, Failure> = ENTRIES.iter().map(|entry| listed(entry.name)).collect();
    let blades = blades?;
    match format {
        Format::Table => Ok(table(&blades)),
        Format::Json => json::line(&List { schema: "bladefan-blades/1", blades }),
        Format::Csv => csv::blades(&blades),
    }
}

fn listed(name: &str) -> Result<Listed, Failure> {
    let definition = input::load(name)?.file.definition;
    let source = definition.source.unwrap_or_default();
    Ok(Listed {
        name: name.into(),
        title: definition.name.unwrap_or_default(),
        quality: source.quality.unwrap_or_default(),
        citation: source.citation.unwrap_or_default(),
    })
}

/// Names in a column, the rest in lines beside them.
fn table(blades: &[Listed]) -> String {
    let mut table = Table::new([("name", Align::Left), ("quality", Align::Left), ("title, source", Align::Left)]);
    for blade in blades {
        table.row([&blade.name, &blade.quality, &blade.title].map(Cell::text));
    }
    let rendered = table.render();
    let mut lines = rendered.lines();
    let head = lines.next().unwrap_or_default();
    let indent = head.find("title").unwrap_or(0);
    let mut text = format!("{head}\n");
    for (line, blade) in lines.zip(blades) {
        let citation = wrap(&blade.citation, indent, WIDTH);
        let _ = writeln!(text, "{line}\n{}{citation}", " ".repeat(indent));
    }
    text
}
