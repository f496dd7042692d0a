//! What the name of an output stands for, with links followed.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Most links that are followed; systems follow fewer.
const LINKS: usize = 64;

/// What is written to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Target {
    /// Standard output by a name of its own, `/dev/stdout` say.
    Output,
    /// Standard error likewise.
    Error,
    /// A device, a pipe, or a stream open under a number: it takes what is written to its end.
    Stream(PathBuf),
    /// A file, which may not exist yet: it is replaced. The path has no links.
    File(PathBuf),
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
                return Ok(stream);
            }
            let data = match fs::symlink_metadata(&here) {
                Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Self::File(here)),
                data => data?,
            };
            if !data.is_symlink() {
                return Ok(if data.is_file() || data.is_dir() { Self::File(here) } else { Self::Stream(here) });
            }
            path = folder.join(fs::read_link(&here)?);
        }
        Err(io::Error::other("too many links"))
    }
}

/// The stream that a name stands for where its folder lists what a program has open. A file behind
/// such a name may hold more than this program's output, and is never replaced.
fn open_stream(folder: &Path, here: &Path) -> Option<Target> {
    let this = Path::new("/proc").join(std::process::id().to_string());
    let listed = folder.starts_with("/proc") && folder.ends_with("fd");
    let own = folder == Path::new("/dev/fd") || listed && folder.starts_with(this);
    match here.file_name()?.to_str()? {
        "1" if own => Some(Target::Output),
        "2" if own => Some(Target::Error),
        _ if own || listed => Some(Target::Stream(here.into())),
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
        assert_eq!(Target::of(Path::new("/dev/null")).unwrap(), Target::Stream("/dev/null".into()));
        let folder = tempfile::tempdir().unwrap();
        let pipe = fs::canonicalize(folder.path()).unwrap().join("pipe");
        nix::unistd::mkfifo(&pipe, nix::sys::stat::Mode::S_IRWXU).unwrap();
        symlink(&pipe, folder.path().join("link")).unwrap();
        assert_eq!(Target::of(&folder.path().join("link")).unwrap(), Target::Stream(pipe));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn open_streams_have_names() {
        let folder = tempfile::tempdir().unwrap();
        symlink("/dev/stdout", folder.path().join("link")).unwrap();
        for path in [Path::new("/dev/stdout"), Path::new("/proc/self/fd/1"), &folder.path().join("link")] {
            assert_eq!(Target::of(path).unwrap(), Target::Output, "{}", path.display());
        }
        assert_eq!(Target::of(Path::new("/dev/stderr")).unwrap(), Target::Error);
        let other = Target::of(Path::new("/dev/fd/7")).unwrap();
        assert!(matches!(other, Target::Stream(_)), "{other:?}");
    }
}
