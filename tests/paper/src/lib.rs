//! The figures and tables of the paper's section 4, made anew through the command line: drawings
//! and CSV files of `docs/paper`, and the generated parts of `docs/VALIDATION.md`.
//! `scripts/reproduce-paper` writes them; `tests/paper/tests/paper.rs` compares.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "it stops where it fails")]
#![allow(clippy::format_push_string, reason = "text is put together once, and reads better so")]

extern crate alloc;

mod accuracy;
mod charts;
mod cli;
mod convergence;
mod document;
mod literature;
mod plot;
mod shapes;
mod table;
mod times;
mod uniform;

pub use cli::Cli;

use alloc::collections::BTreeMap;
use document::replace;
use std::fs;
use std::path::Path;

/// The document with the generated parts.
const DOCUMENT: &str = "docs/VALIDATION.md";

/// What the command line makes of the paper: whole files, and parts of the document by their names.
#[derive(Debug, Default)]
pub struct Output {
    /// Text by path from the root of the repository.
    pub files: BTreeMap<String, String>,
    /// Markdown by name.
    pub parts: BTreeMap<String, String>,
}

impl Output {
    /// Everything but measured times, which are read from their record under `root`.
    ///
    /// # Panics
    /// Where the command line has no answer.
    pub fn of(cli: &Cli, root: &Path) -> Self {
        let mut output = Self::default();
        uniform::figures_4_and_5(cli, &mut output);
        convergence::figures_6_and_7(cli, &mut output);
        times::figure_8(root, &mut output);
        times::speed(root, &mut output);
        charts::figure_9(cli, &mut output);
        charts::figure_11(cli, &mut output);
        charts::figure_16(cli, &mut output);
        shapes::figures(cli, &mut output);
        accuracy::tables(cli, &mut output);
        literature::tables(&mut output);
        literature::peers(root, &mut output);
        output
    }

    /// The paths of files that are not what they should be, or not there.
    ///
    /// # Panics
    /// Where the document has not the parts.
    pub fn stale(&self, root: &Path) -> Vec<String> {
        self.changes(root).into_keys().collect()
    }

    /// Writes what is not what it should be; returns the paths.
    ///
    /// # Panics
    /// Where a file cannot be written.
    pub fn write(&self, root: &Path) -> Vec<String> {
        let changes = self.changes(root);
        for (path, text) in &changes {
            fs::write(root.join(path), text).unwrap_or_else(|error| panic!("{path}: {error}"));
        }
        changes.into_keys().collect()
    }

    /// The text of every file that is not what it should be.
    fn changes(&self, root: &Path) -> BTreeMap<String, String> {
        let text = fs::read_to_string(root.join(DOCUMENT)).unwrap_or_else(|error| panic!("{DOCUMENT}: {error}"));
        let document = replace(&text, &self.parts).unwrap_or_else(|fault| panic!("{DOCUMENT}: {fault}"));
        let mut all = self.files.clone();
        all.insert(DOCUMENT.into(), document);
        all.retain(|path, text| !fs::read_to_string(root.join(path)).is_ok_and(|found| found == *text));
        all
    }

    /// Keeps the drawing of a command; returns the image for the document.
    fn draw(&mut self, cli: &Cli, name: &str, alternative: &str, command: &str) -> String {
        self.image(name, alternative, cli.draw(command))
    }

    /// Keeps a drawing; returns the image for the document.
    fn image(&mut self, name: &str, alternative: &str, svg: String) -> String {
        self.files.insert(format!("docs/paper/{name}.svg"), svg);
        format!("![{alternative}](paper/{name}.svg)\n")
    }

    /// Keeps a table of numbers; returns the link for the document.
    fn csv(&mut self, name: &str, text: String) -> String {
        self.files.insert(format!("docs/paper/{name}.csv"), text);
        format!("[{name}.csv](paper/{name}.csv)")
    }

    fn part(&mut self, name: &str, text: String) {
        self.parts.insert(name.into(), text);
    }
}
