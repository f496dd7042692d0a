//! `blades`: the built-in library.

use crate::args::{BladesArgs, Format, ResultArgs};
use crate::failure::Failure;
use crate::io::input::{self, not_found};
use crate::io::output::{self, Output};
use crate::render::table::{Align, Cell, GAP, Table};
use crate::render::text::{spaces, wrap};
use crate::render::{csv, json};
use bladefan_core::formats;
use bladefan_core::library::{self, ENTRIES};
use serde::Serialize;
use unicode_width::UnicodeWidthStr;

/// What the list says of one blade.
#[derive(Debug, Serialize)]
struct Listed {
    name: String,
    title: String,
    quality: String,
    citation: String,
}

impl Listed {
    fn cells(&self) -> [&str; 4] {
        [&self.name, &self.title, &self.quality, &self.citation].map(String::as_str)
    }
}

#[derive(Serialize)]
struct List {
    schema: &'static str,
    blades: Vec<Listed>,
}

pub(super) fn run(args: &BladesArgs) -> Result<Output, Failure> {
    output::check(&[], &args.result, None)?;
    match &args.name {
        Some(name) => Ok(Output::new(one(name, args.result.format)?, &args.result).uncoloured()),
        None => Ok(Output::new(list(&args.result)?, &args.result)),
    }
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

fn list(args: &ResultArgs) -> Result<String, Failure> {
    let blades: Result<Vec<Listed>, Failure> = ENTRIES.iter().map(|entry| listed(entry.name)).collect();
    let blades = blades?;
    match args.format {
        Format::Table => Ok(table(&blades, output::width(args))),
        Format::Json => json::line(&List { schema: "bladefan-blades/1", blades }),
        Format::Csv => csv::blades(blades.iter().map(Listed::cells)),
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
fn table(blades: &[Listed], width: usize) -> String {
    let mut names = Table::new([("name", Align::Left), ("quality", Align::Left)]);
    for blade in blades {
        names.row([&blade.name, &blade.quality].map(Cell::text));
    }
    let names = names.render(width);
    let indent = names.lines().map(UnicodeWidthStr::width).max().unwrap_or(0) + GAP.len();
    let head = ["title, source", ""];
    let beside = core::iter::once(head).chain(blades.iter().map(|blade| [blade.title.as_str(), &blade.citation]));
    let mut text = String::new();
    for (name, lines) in names.lines().zip(beside) {
        text += name;
        let mut at = name.width();
        for line in lines.into_iter().filter(|line| !line.is_empty()) {
            text += &spaces(indent - at);
            text += &wrap(line, indent, width);
            text.push('\n');
            at = 0;
        }
    }
    text
}
