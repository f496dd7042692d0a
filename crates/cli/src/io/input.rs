//! Reading: which text `BLADE` names, and the blade in it.

use super::progress;
use crate::failure::{Failure, reason};
use bladefan_core::Blade;
use bladefan_core::Faults;
use bladefan_core::formats::{self, BladeFile, Format};
use bladefan_core::library;
use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};

/// Most bytes of an input, a thousand times those of a long table of stations.
const MOST: u64 = 64_000_000;

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

impl Input {
    /// The blade.
    pub(crate) fn blade(&self) -> &Blade {
        &self.file.blade
    }

    /// What `question` finds out about the blade, under a sign of life that says `what`.
    pub(crate) fn ask<T>(
        &self,
        what: &'static str,
        question: impl FnOnce(&Blade) -> Result<T, Faults>,
    ) -> Result<T, Failure> {
        let answer = progress::with(what, || question(&self.file.blade));
        answer.map_err(|faults| Failure::faults(&self.name, &faults))
    }
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
        let text = decode(&name, bytes(&name, io::stdin().lock())?)?;
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
    let file = File::open(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound => Failure::input(format!("{name}: no such file")),
        _ => unreadable(&name, &error),
    })?;
    // What is no file, a pipe say, has no size before it is read.
    match file.metadata() {
        Ok(data) if data.is_file() && data.len() > MOST => Err(too_large(&name, &format!("is {} bytes", data.len()))),
        _ => decode(&name, bytes(&name, file)?),
    }
}

/// Everything that `from` gives, or a refusal as soon as that is too much.
fn bytes(name: &str, from: impl Read) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    let read = from.take(MOST + 1).read_to_end(&mut bytes).map_err(|error| unreadable(name, &error))?;
    if read as u64 > MOST { Err(too_large(name, "is longer")) } else { Ok(bytes) }
}

fn unreadable(name: &str, error: &io::Error) -> Failure {
    Failure::input(format!("{name}: cannot be read: {}", reason(error)))
}

fn too_large(name: &str, is: &str) -> Failure {
    Failure::input(format!("{name}: must be at most {} MB long ({is})", MOST / 1_000_000))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_endless_input_is_refused_when_it_is_too_long() {
        let message = bytes("a", io::repeat(b' ')).unwrap_err();
        assert_eq!(message.lines(), ["a: must be at most 64 MB long (is longer)"]);
        assert_eq!(bytes("a", io::repeat(b' ').take(MOST)).unwrap().len() as u64, MOST, "the limit itself is taken");
    }

    #[test]
    fn a_large_file_is_refused_before_it_is_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("large.toml");
        // A file with a hole: its size is what it says.
        File::create(&path).unwrap().set_len(1 << 40).unwrap();
        let message = format!("{}: must be at most 64 MB long (is 1099511627776 bytes)", path.display());
        assert_eq!(read_text(&path).unwrap_err().lines(), [message]);
    }

    #[test]
    fn the_place_of_a_byte_that_is_no_text_counts_characters() {
        let message = decode("a", b"x\ny = \"\xc3\xbc\xff".to_vec()).unwrap_err();
        assert_eq!(message.lines(), ["a:2:7: the text must be UTF-8 (has the byte 0xff)"]);
    }

    #[test]
    fn the_nearest_name_is_suggested_where_one_is_near() {
        assert!(not_found("Unifrom", "no").lines()[0].ends_with("did you mean uniform?"), "near");
        assert!(not_found("qqqq", "no").lines()[0].contains("built in are "), "none is near");
    }
}
