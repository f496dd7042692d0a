//! Writing: the result to standard output or a file, drawings to files. Everything is rendered
//! before the first byte is written, and a file gets its name only when it is whole.

use crate::args::{DrawingArgs, ResultArgs};
use crate::drawing;
use crate::failure::Failure;
use bladefan_core::chart::Drawing;
use std::fs::{self, OpenOptions, Permissions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};

/// What a command made.
#[derive(Debug)]
pub(crate) struct Output {
    text: String,
    to: Option<PathBuf>,
    files: Vec<(PathBuf, Vec<u8>)>,
}

impl Output {
    /// A result without drawings. `text` may hold colours; they reach a terminal only.
    pub(crate) fn new(text: String, args: &ResultArgs) -> Self {
        Self { text, to: args.output.clone(), files: Vec::new() }
    }

    /// Adds the drawings asked for; `draw` is called only where there are any.
    pub(crate) fn draw(mut self, args: &DrawingArgs, draw: impl FnOnce() -> Drawing) -> Result<Self, Failure> {
        if args.svg.is_some() || args.png.is_some() {
            let svg = draw().svg;
            if let Some(path) = &args.png {
                self.files.push((path.clone(), drawing::png(&svg)?));
            }
            if let Some(path) = &args.svg {
                self.files.push((path.clone(), svg.into_bytes()));
            }
        }
        Ok(self)
    }
}

/// Refuses outputs that would overwrite an input or each other, before any work is done.
pub(crate) fn check(
    inputs: &[Option<&PathBuf>],
    result: &ResultArgs,
    drawing: Option<&DrawingArgs>,
) -> Result<(), Failure> {
    let mut taken: Vec<PathBuf> = inputs.iter().flatten().map(|path| place(path)).collect();
    let drawings = drawing.into_iter().flat_map(|args| [("--svg", &args.svg), ("--png", &args.png)]);
    for (option, path) in [("--output", &result.output)].into_iter().chain(drawings) {
        let Some(path) = path else { continue };
        let place = place(path);
        if is_special(path) {
            continue;
        }
        if taken.contains(&place) {
            let path = path.display();
            return Err(Failure::input(format!("{option}: must be a file that nothing else stands for (is {path})")));
        }
        taken.push(place);
    }
    Ok(())
}

/// The one name of a file that may not exist yet.
fn place(path: &Path) -> PathBuf {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let whole = || Some(fs::canonicalize(folder).ok()?.join(path.file_name()?));
    fs::canonicalize(path).ok().or_else(whole).unwrap_or_else(|| path.into())
}

/// Whether this is a device or a pipe, which is written to and never replaced.
fn is_special(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|data| !data.is_file() && !data.is_dir())
}

/// Writes everything, standard output last: files first become whole under another name, then all
/// get theirs.
pub(crate) fn write(output: &Output) -> Result<(), Failure> {
    let stripped = output.to.as_ref().map(|path| (path, anstream::adapter::strip_str(&output.text).to_string()));
    let texts = stripped.iter().map(|(path, text)| (path.as_path(), text.as_bytes()));
    let drawings = output.files.iter().map(|(path, bytes)| (path.as_path(), bytes.as_slice()));
    let mut ready = Vec::new();
    for (path, bytes) in texts.chain(drawings) {
        ready.push((path, prepare(path, bytes).map_err(|error| Failure::write(path.display(), &error))?));
    }
    for (path, file) in ready {
        if let Some(file) = file {
            file.persist(place(path)).map_err(|error| Failure::write(path.display(), &error.error))?;
        }
    }
    if output.to.is_none() {
        let mut stdout = anstream::stdout().lock();
        let written = stdout.write_all(output.text.as_bytes()).and_then(|()| stdout.flush());
        written.map_err(|error| Failure::write("standard output", &error))?;
    }
    Ok(())
}

/// Writes `bytes` to a file beside `path` that can take its name; straight into a device.
fn prepare(path: &Path, bytes: &[u8]) -> io::Result<Option<NamedTempFile>> {
    if is_special(path) {
        OpenOptions::new().write(true).open(path)?.write_all(bytes)?;
        return Ok(None);
    }
    let place = place(path);
    // A file that may not be written to is not to be replaced either.
    let old = match OpenOptions::new().write(true).open(&place) {
        Ok(file) => Some(file.metadata()?.permissions()),
        Err(error) if error.kind() == io::ErrorKind::NotFound => None,
        Err(error) => return Err(error),
    };
    let mut file = create(place.parent().unwrap_or(Path::new(".")))?;
    file.write_all(bytes)?;
    if let Some(permissions) = old {
        file.as_file().set_permissions(permissions)?;
    }
    Ok(Some(file))
}

/// A file for the time being, readable to whom new files are.
fn create(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(".bladefan-");
    #[cfg(unix)]
    builder.permissions(<Permissions as std::os::unix::fs::PermissionsExt>::from_mode(0o666));
    builder.tempfile_in(folder)
}
