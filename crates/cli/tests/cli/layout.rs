//! Who may import whom: commands everybody, `io` and `render` no command, `render` nothing that reads
//! or writes. So a new command, a new form of a result and a new stream each have one place.

use std::fs;
use std::path::Path;

/// A folder or file of `src`, and those that it must not import.
const RULES: [(&str, &[&str]); 6] = [
    ("failure.rs", &["args", "commands", "io", "render"]),
    ("help.rs", &["args", "commands", "failure", "io", "render"]),
    ("args.rs", &["commands", "io", "render"]),
    ("args", &["commands", "io", "render"]),
    ("render", &["commands", "io"]),
    ("io", &["commands"]),
];

fn sources(path: &Path, found: &mut Vec<String>) {
    if path.is_dir() {
        for entry in fs::read_dir(path).unwrap() {
            sources(&entry.unwrap().path(), found);
        }
    } else {
        found.push(fs::read_to_string(path).unwrap());
    }
}

#[test]
fn imports_go_one_way() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for (room, closed) in RULES {
        let mut texts = Vec::new();
        sources(&source.join(room), &mut texts);
        assert!(!texts.is_empty(), "{room} is empty");
        for (text, other) in texts.iter().flat_map(|text| closed.iter().map(move |other| (text, other))) {
            let import = format!("crate::{other}::");
            assert!(!text.contains(&import), "{room} imports {other}: {}", text.lines().next().unwrap());
        }
    }
}

#[test]
fn commands_are_one_file_each() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/commands");
    let mut names: Vec<_> = fs::read_dir(source).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["blades.rs", "check.rs", "converge.rs", "fan.rs", "mod.rs", "modes.rs", "shapes.rs"]);
}
