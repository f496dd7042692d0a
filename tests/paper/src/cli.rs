//! Runs the command line.

use serde_json::Value;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{self, Command};

/// The `bladefan` to run, and where.
#[derive(Debug)]
pub struct Cli {
    binary: PathBuf,
    root: PathBuf,
    scratch: PathBuf,
}

impl Drop for Cli {
    fn drop(&mut self) {
        drop(fs::remove_dir_all(&self.scratch));
    }
}

impl Cli {
    /// The binary that `BLADEFAN` names, or the one built beside this program; commands run in `root`.
    ///
    /// # Errors
    /// There is none.
    pub fn find(root: &Path) -> Result<Self, String> {
        let here = env::current_exe().map_err(|error| error.to_string())?;
        let built = here.ancestors().map(|folder| folder.join(format!("bladefan{}", env::consts::EXE_SUFFIX)));
        let binary =
            env::var_os("BLADEFAN").map_or_else(|| built.skip(1).find(|path| path.is_file()), |path| Some(path.into()));
        let binary = binary.ok_or("no bladefan to run: cargo build -p bladefan, or name one in BLADEFAN")?;
        let scratch = env::temp_dir().join(format!("bladefan-paper-{}", process::id()));
        fs::create_dir_all(&scratch).map_err(|error| format!("{}: {error}", scratch.display()))?;
        Ok(Self { binary, root: root.into(), scratch })
    }

    /// What a command prints; its words are separated by single spaces and hold none.
    pub(super) fn print(&self, command: &str) -> String {
        let output = Command::new(&self.binary).args(command.split(' ')).current_dir(&self.root).output();
        let output = output.unwrap_or_else(|error| panic!("{}: {error}", self.binary.display()));
        let fault = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "bladefan {command}: {fault}");
        String::from_utf8(output.stdout).unwrap()
    }

    /// The result of a command.
    pub(super) fn json(&self, command: &str) -> Value {
        serde_json::from_str(&self.print(&format!("{command} --format json"))).unwrap()
    }

    /// A file for a command to read.
    pub(super) fn file(&self, name: &str, text: &str) -> String {
        let path = self.scratch.join(name);
        fs::write(&path, text).unwrap();
        let path = path.to_str().expect("a path in UTF-8");
        assert!(!path.contains(' '), "the folder of temporary files has a space in its name: {path}");
        path.into()
    }

    /// The table of numbers of a command.
    pub(super) fn csv(&self, command: &str) -> String {
        self.print(&format!("{command} --format csv"))
    }

    /// The drawing of a command.
    pub(super) fn draw(&self, command: &str) -> String {
        let file = self.file("drawing.svg", "");
        self.print(&format!("{command} --svg {file}"));
        fs::read_to_string(file).unwrap()
    }
}
