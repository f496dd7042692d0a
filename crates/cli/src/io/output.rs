//! Writing: the result to standard output or a file, drawings to files. Everything is rendered
//! before the first byte is written, and a file gets its name only when it is whole.

use super::hold::Hold;
use super::target::{Target, all};
use crate::args::{DrawingArgs, Format, ResultArgs};
use crate::failure::Failure;
use std::fs::{self, OpenOptions, Permissions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};
use terminal_size::{Width, terminal_size_of};

/// Columns of a table where no terminal shows it, and the most that it takes of one.
const MOST_WIDTH: usize = 100;
/// The least: narrower, tables are hard to read whatever is done.
const LEAST_WIDTH: usize = 40;

/// What a command made.
#[derive(Debug)]
pub(crate) struct Output {
    text: String,
    /// Whether the text holds colours, which reach a terminal only.
    coloured: bool,
    to: Option<PathBuf>,
    drawings: Vec<(PathBuf, Vec<u8>)>,
}

impl Output {
    /// A result without drawings. Tables may hold colours; JSON and CSV are written as they are.
    pub(crate) fn new(text: String, args: &ResultArgs) -> Self {
        let coloured = args.format == Format::Table;
        Self { text, coloured, to: args.output.clone(), drawings: Vec::new() }
    }

    /// A text that is no table: without colours, and not searched for any.
    pub(crate) fn uncoloured(self) -> Self {
        Self { coloured: false, ..self }
    }

    /// The same with its drawings.
    pub(crate) fn with(self, drawings: Vec<(PathBuf, Vec<u8>)>) -> Self {
        Self { drawings, ..self }
    }
}

/// Columns that a table may take: as many as the terminal has that shows it.
pub(crate) fn width(args: &ResultArgs) -> usize {
    let terminal = if args.output.is_none() { terminal_size_of(io::stdout()) } else { None };
    terminal.map_or(MOST_WIDTH, |(Width(columns), _)| usize::from(columns).clamp(LEAST_WIDTH, MOST_WIDTH))
}

/// Refuses outputs that would overwrite an input or each other, before any work is done.
pub(crate) fn check(
    inputs: &[Option<&PathBuf>],
    result: &ResultArgs,
    drawing: Option<&DrawingArgs>,
) -> Result<(), Failure> {
    let mut taken: Vec<PathBuf> = inputs.iter().flatten().filter_map(|path| fs::canonicalize(path).ok()).collect();
    let drawings = drawing.into_iter().flat_map(|args| [("--svg", &args.svg), ("--png", &args.png)]);
    for (option, path) in [("--output", &result.output)].into_iter().chain(drawings) {
        let Some(path) = path else { continue };
        // What else is wrong with it is said where it is written.
        let Ok(Target::File(place)) = Target::of(path) else { continue };
        if taken.contains(&place) {
            let path = path.display();
            return Err(Failure::input(format!("{option}: must be a file that nothing else stands for (is {path})")));
        }
        taken.push(place);
    }
    Ok(())
}

/// Writes everything: files, then what may wait for a reader, standard output last.
pub(crate) fn write(output: &Output) -> Result<(), Failure> {
    let text = output.to.as_ref().map(|path| (path, plain(output)));
    let texts = text.iter().map(|(path, text)| (path.as_path(), text.as_bytes()));
    let drawings = output.drawings.iter().map(|(path, bytes)| (path.as_path(), bytes.as_slice()));
    let (mut files, mut streams) = (Vec::new(), Vec::new());
    for (path, bytes) in texts.chain(drawings) {
        match Target::of(path).map_err(|error| Failure::write(path.display(), &error))? {
            Target::File(place) => files.push(File { path, place, bytes }),
            Target::Stream(stream) => streams.push((path, stream, bytes)),
        }
    }
    replace(&files)?;
    for (path, stream, bytes) in streams {
        stream.write(bytes).map_err(|error| Failure::write(path.display(), &error))?;
    }
    if output.to.is_none() {
        let text = output.text.as_bytes();
        let written =
            if output.coloured { all(anstream::stdout().lock(), text) } else { all(io::stdout().lock(), text) };
        written.map_err(|error| Failure::write("standard output", &error))?;
    }
    Ok(())
}

/// The text without colours.
fn plain(output: &Output) -> String {
    if output.coloured { anstream::adapter::strip_str(&output.text).to_string() } else { output.text.clone() }
}

/// A file to be: its name as given, where that leads, and what goes into it.
struct File<'a> {
    path: &'a Path,
    place: PathBuf,
    bytes: &'a [u8],
}

/// Files first become whole under another name, then all get theirs.
fn replace(files: &[File<'_>]) -> Result<(), Failure> {
    let _hold = Hold::new();
    let failed = |file: &File<'_>, error: &io::Error| Failure::write(file.path.display(), error);
    let mut ready = Vec::new();
    for file in files {
        ready.push((file, prepare(file).map_err(|error| failed(file, &error))?));
    }
    for (file, whole) in ready {
        whole.persist(&file.place).map_err(|error| failed(file, &error.error))?;
    }
    Ok(())
}

/// A whole file beside the place that it is to take.
fn prepare(file: &File<'_>) -> io::Result<NamedTempFile> {
    // A file that may not be written to is not to be replaced either.
    let old = match OpenOptions::new().write(true).open(&file.place) {
        Ok(old) => Some(old.metadata()?.permissions()),
        Err(error) if error.kind() == io::ErrorKind::NotFound => None,
        Err(error) => return Err(error),
    };
    let mut new = create(file.place.parent().unwrap_or(Path::new(".")))?;
    new.write_all(file.bytes)?;
    if let Some(permissions) = old {
        new.as_file().set_permissions(permissions)?;
    }
    Ok(new)
}

/// A file for the time being, readable to whom new files are.
fn create(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(".bladefan-");
    #[cfg(unix)]
    builder.permissions(<Permissions as std::os::unix::fs::PermissionsExt>::from_mode(0o666));
    builder.tempfile_in(folder)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn result(format: Format, output: Option<PathBuf>) -> ResultArgs {
        ResultArgs { format, output }
    }

    #[test]
    fn only_tables_lose_what_looks_like_colours() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        for (format, kept) in [(Format::Table, "ab\n"), (Format::Json, "\u{1b}[31ma\u{7f}b\n")] {
            let args = result(format, Some(path.clone()));
            write(&Output::new("\u{1b}[31ma\u{7f}b\n".into(), &args)).unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), kept);
        }
    }

    #[test]
    fn files_are_written_together_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let drawings = vec![(folder.path().join("a.svg"), b"a".to_vec()), (folder.path().into(), b"b".to_vec())];
        let args = result(Format::Csv, Some(folder.path().join("a.csv")));
        assert!(write(&Output::new("c".into(), &args).with(drawings)).is_err(), "a folder is no file");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0, "nothing is left");
    }

    #[test]
    fn tables_have_a_width_of_their_own_in_files() {
        assert_eq!(width(&result(Format::Table, Some("a".into()))), MOST_WIDTH);
    }
}
