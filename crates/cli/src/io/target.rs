//! What the name of an output stands for, with links followed.

use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Most links that are followed; systems follow fewer.
const LINKS: usize = 64;

/// What is written to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Target {
    /// A file, which may not exist yet: it is replaced. The path has no links.
    File(PathBuf),
    /// What is written into as it stands.
    Stream(Stream),
}

/// What others may write into as well.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Stream {
    /// Standard output by a name of its own, `/dev/stdout` say.
    Output,
    /// Standard error likewise.
    Error,
    /// A device, a pipe, or what is open under another number: it takes what is written at its end.
    Named(PathBuf),
}

impl Stream {
    pub(super) fn write(&self, bytes: &[u8]) -> io::Result<()> {
        match self {
            Self::Output => all(io::stdout().lock(), bytes),
            Self::Error => all(io::stderr().lock(), bytes),
            Self::Named(place) => all(OpenOptions::new().append(true).open(place)?, bytes),
        }
    }
}

/// Writes to the end, and says where that failed.
pub(super) fn all(mut stream: impl Write, bytes: &[u8]) -> io::Result<()> {
    stream.write_all(bytes).and_then(|()| stream.flush())
}

impl Target {
    pub(super) fn of(path: &Path) -> io::Result<Self> {
        let mut path = path.to_path_buf();
        for _ in 0..LINKS {
            let Some(name) = path.file_name() else { return Ok(Self::File(fs::canonicalize(&path)?)) };
            let folder = match path.parent() {
                Some(folder) if !folder.as_os_str().is_empty() => fs::canonicalize(folder)?,
                _ => fs::canonicalize(".")?,
            };
            let here = folder.join(name);
            if let Some(stream) = open_stream(&folder, &here) {
                return Ok(Self::Stream(stream));
            }
            let data = match fs::symlink_metadata(&here) {
                Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Self::File(here)),
                data => data?,
            };
            if !data.is_symlink() {
                let file = data.is_file() || data.is_dir();
                return Ok(if file { Self::File(here) } else { Self::Stream(Stream::Named(here)) });
            }
            path = folder.join(fs::read_link(&here)?);
        }
        Err(io::Error::other("too many links"))
    }
}

/// The stream that a name stands for where its folder lists what a program has open. A file behind
/// such a name may hold more than this program's output, and is never replaced.
fn open_stream(folder: &Path, here: &Path) -> Option<Stream> {
    let this = Path::new("/proc").join(std::process::id().to_string());
    let listed = folder.starts_with("/proc") && folder.ends_with("fd");
    let own = folder == Path::new("/dev/fd") || listed && folder.starts_with(this);
    match here.file_name()?.to_str()? {
        "1" if own => Some(Stream::Output),
        "2" if own => Some(Stream::Error),
        _ if own || listed => Some(Stream::Named(here.into())),
        _ => None,
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::os::unix::fs::symlink;

    #[test]
    fn files_need_not_exist() {
        let folder = tempfile::tempdir().unwrap();
        let place = fs::canonicalize(folder.path()).unwrap();
        for name in ["new.csv", "./new.csv"] {
            assert_eq!(Target::of(&folder.path().join(name)).unwrap(), Target::File(place.join("new.csv")));
        }
        assert_eq!(
            Target::of(&folder.path().join("..").join(place.file_name().unwrap())).unwrap(),
            Target::File(place)
        );
        let missing = Target::of(&folder.path().join("no/new.csv")).unwrap_err();
        assert_eq!(missing.kind(), io::ErrorKind::NotFound, "its folder must exist");
    }

    #[test]
    fn links_are_followed_to_where_nothing_is_yet() {
        let folder = tempfile::tempdir().unwrap();
        let place = fs::canonicalize(folder.path()).unwrap();
        fs::create_dir(place.join("below")).unwrap();
        symlink("below/second", place.join("first")).unwrap();
        symlink("../new.csv", place.join("below/second")).unwrap();
        assert_eq!(Target::of(&place.join("first")).unwrap(), Target::File(place.join("new.csv")));
    }

    #[test]
    fn a_ring_of_links_has_an_end() {
        let folder = tempfile::tempdir().unwrap();
        symlink("a", folder.path().join("b")).unwrap();
        symlink("b", folder.path().join("a")).unwrap();
        assert_eq!(Target::of(&folder.path().join("a")).unwrap_err().to_string(), "too many links");
    }

    #[test]
    fn devices_and_pipes_are_no_files() {
        assert_eq!(Target::of(Path::new("/dev/null")).unwrap(), Target::Stream(Stream::Named("/dev/null".into())));
        let folder = tempfile::tempdir().unwrap();
        let pipe = fs::canonicalize(folder.path()).unwrap().join("pipe");
        nix::unistd::mkfifo(&pipe, nix::sys::stat::Mode::S_IRWXU).unwrap();
        symlink(&pipe, folder.path().join("link")).unwrap();
        assert_eq!(Target::of(&folder.path().join("link")).unwrap(), Target::Stream(Stream::Named(pipe)));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn open_streams_have_names() {
        let folder = tempfile::tempdir().unwrap();
        symlink("/dev/stdout", folder.path().join("link")).unwrap();
        for path in [Path::new("/dev/stdout"), Path::new("/proc/self/fd/1"), &folder.path().join("link")] {
            assert_eq!(Target::of(path).unwrap(), Target::Stream(Stream::Output), "{}", path.display());
        }
        assert_eq!(Target::of(Path::new("/dev/stderr")).unwrap(), Target::Stream(Stream::Error));
        let other = Target::of(Path::new("/dev/fd/7")).unwrap();
        assert!(matches!(other, Target::Stream(Stream::Named(_))), "{other:?}");
    }
}
