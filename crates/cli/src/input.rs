//! Reading: which text `BLADE` names, and the blade in it.

use crate::failure::{Failure, reason};
use bladefan_core::formats::{self, BladeFile, Format};
use bladefan_core::library;
use std::io::Read;
use std::path::{Path, PathBuf};

/// How alike a name must be to one that exists to be suggested (Jaro-Winkler, 0 to 1).
const ALIKE: f64 = 0.7;

/// A blade and where it came from.
#[derive(Debug)]
pub(crate) struct Input {
    /// The name that faults are reported under.
    pub(crate) name: String,
    /// What the file says.
    pub(crate) file: BladeFile,
    /// The file, where there is one.
    pub(crate) path: Option<PathBuf>,
}

/// A text and where it came from.
struct Source {
    name: String,
    text: String,
    format: Format,
    path: Option<PathBuf>,
}

/// Reads the blade that `blade` names: a path, `-` for standard input, a built-in name, or a file
/// in this folder, in this order.
pub(crate) fn load(blade: &str) -> Result<Input, Failure> {
    let source = find(blade)?;
    match formats::read(&source.text, source.format) {
        Ok(file) => Ok(Input { name: source.name, file, path: source.path }),
        Err(faults) => Err(Failure::faults(&source.name, &faults)),
    }
}

fn find(blade: &str) -> Result<Source, Failure> {
    let path = Path::new(blade);
    if blade == "-" {
        let name = String::from("<stdin>");
        let mut bytes = Vec::new();
        let read = std::io::stdin().lock().read_to_end(&mut bytes);
        read.map_err(|error| Failure::input(format!("{name}: cannot be read: {}", reason(&error))))?;
        let text = decode(&name, bytes)?;
        Ok(Source { format: Format::of_text(&text), name, text, path: None })
    } else if blade.contains(std::path::is_separator) || Format::of_name(blade).is_some() {
        from_file(path)
    } else if let Some(entry) = library::find(blade) {
        Ok(Source { name: entry.name.into(), text: entry.toml.into(), format: Format::Toml, path: None })
    } else if path.is_file() {
        from_file(path)
    } else {
        Err(not_found(blade, "no built-in blade and no file of this name"))
    }
}

fn from_file(path: &Path) -> Result<Source, Failure> {
    let text = read_text(path)?;
    let name = path.display().to_string();
    let format = Format::of_name(&name).unwrap_or_else(|| Format::of_text(&text));
    Ok(Source { name, text, format, path: Some(path.into()) })
}

/// The text of a file.
pub(crate) fn read_text(path: &Path) -> Result<String, Failure> {
    let name = path.display().to_string();
    match std::fs::read(path) {
        Ok(bytes) => decode(&name, bytes),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            Err(Failure::input(format!("{name}: no such file")))
        }
        Err(error) => Err(Failure::input(format!("{name}: cannot be read: {}", reason(&error)))),
    }
}

/// Bytes as text; the fault has the place of the first byte that is none.
fn decode(name: &str, bytes: Vec<u8>) -> Result<String, Failure> {
    String::from_utf8(bytes).map_err(|error| {
        let (before, rest) = error.as_bytes().split_at(error.utf8_error().valid_up_to());
        let before = String::from_utf8_lossy(before);
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
        let byte = rest.first().copied().unwrap_or_default();
        Failure::input(format!("{name}:{line}:{column}: the text must be UTF-8 (has the byte 0x{byte:02x})"))
    })
}

/// Nothing of this name, as `message` says; adds which built-in name may have been meant.
pub(crate) fn not_found(blade: &str, message: &str) -> Failure {
    let nearest = library::ENTRIES
        .iter()
        .map(|entry| (strsim::jaro_winkler(&blade.to_lowercase(), entry.name), entry.name))
        .max_by(|a, b| a.0.total_cmp(&b.0));
    let hint = match nearest {
        Some((alike, name)) if alike >= ALIKE => format!("did you mean {name}?"),
        _ => {
            let names: Vec<_> = library::ENTRIES.iter().map(|entry| entry.name).collect();
            format!("built in are {}", names.join(", "))
        }
    };
    Failure::input(format!("{blade}: {message}; {hint}"))
}
