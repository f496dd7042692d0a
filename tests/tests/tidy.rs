//! The shape of the repository: who may import whom, sizes of files, what is published, and what
//! keeps results the same on every target.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

extern crate alloc;

use alloc::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}

/// Every file under `folder` that the repository holds, leaving out what is built or installed.
fn files(folder: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![root().join(folder)];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap();
            let built = ["target", "node_modules", ".git", "screenshots", "test-results"].contains(&name)
                || name == "pkg"
                || path.ends_with("web/docs")
                || name.starts_with("pkg-");
            if path.is_dir() && !built {
                open.push(path);
            } else if path.is_file() {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

fn has_ending(path: &Path, endings: &[&str]) -> bool {
    path.extension().is_some_and(|ending| endings.iter().any(|e| ending == *e))
}

fn read(path: impl AsRef<Path>) -> String {
    fs::read_to_string(root().join(path)).unwrap()
}

fn assert_none(faults: &[String]) {
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

/// A row of the table of rooms in docs/ARCHITECTURE.md.
struct Room {
    path: String,
    may_import: Vec<String>,
}

/// The rows of the table whose first column is headed `head`.
fn rooms(head: &str) -> Vec<Room> {
    let text = read("docs/ARCHITECTURE.md");
    let quoted = |cell: &str| cell.split('`').skip(1).step_by(2).map(String::from).collect::<Vec<_>>();
    let rows = text.lines().skip_while(|line| !line.starts_with(&format!("| {head} |"))).skip(2);
    rows.take_while(|line| line.starts_with('|'))
        .map(|line| {
            let cells: Vec<&str> = line.split('|').collect();
            Room { path: quoted(cells[1]).remove(0), may_import: quoted(cells[2]) }
        })
        .collect()
}

/// Whether `path` is `outer` or lies inside it.
fn inside(path: &str, outer: &str) -> bool {
    path.strip_prefix(outer).is_some_and(|rest| rest.is_empty() || rest.starts_with("::"))
}

/// The source without comments and without its unit tests, which stand last.
fn code(source: &str) -> String {
    let source = source.split("\nmod tests {").next().unwrap();
    source.lines().map(|line| line.split("//").next().unwrap()).collect::<Vec<_>>().join("\n")
}

/// Expands what follows `prefix` at the start of `rest`, be it `a::b` or `{a, b::{c, d}}`.
fn expand<'a>(prefix: &str, mut rest: &'a str, found: &mut Vec<String>) -> &'a str {
    let joined = |name: &str| if prefix.is_empty() { name.to_string() } else { format!("{prefix}::{name}") };
    if let Some(group) = rest.strip_prefix('{') {
        rest = group.trim_start();
        while !rest.is_empty() && !rest.starts_with('}') {
            let before = rest.len();
            rest = expand(prefix, rest, found).trim_start_matches([',', ' ', '\n']);
            if rest.len() == before {
                break;
            }
        }
        return rest.strip_prefix('}').unwrap_or(rest);
    }
    let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
    let (name, after) = rest.split_at(end);
    let path = if name == "self" { prefix.to_string() } else { joined(name) };
    if let Some(after) = after.strip_prefix("::") {
        return expand(&path, after, found);
    }
    found.push(path);
    after
}

/// All paths in `code` that start with `start`, which is a whole path segment there.
fn paths_after(code: &str, start: &str, prefix: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices(start) {
        let whole = !code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == ':' || c == '.');
        if whole {
            expand(prefix, &code[at + start.len()..], &mut found);
        }
    }
    found
}

/// Names of the crates that core depends on, as written in code.
fn dependencies_of_core() -> Vec<String> {
    let manifest = read("crates/core/Cargo.toml");
    let table = manifest.split("\n[dependencies]\n").nth(1).unwrap().split("\n[").next().unwrap();
    let names = table.lines().filter_map(|line| line.split([' ', '.', '=']).next());
    names.filter(|name| !name.is_empty() && *name != "serde").map(|name| name.replace('-', "_")).collect()
}

#[test]
fn imports_of_core_follow_the_table_of_rooms() {
    let rooms = rooms("room");
    assert!(rooms.len() > 10, "the table of rooms was not found");
    let dependencies = dependencies_of_core();
    assert!(dependencies.iter().any(|name| name == "nalgebra"), "the dependencies were not found");
    let source = root().join("crates/core/src");
    let mut faults = Vec::new();
    let mut lived_in = BTreeSet::new();
    for file in files("crates/core/src") {
        let name = file.strip_prefix(&source).unwrap().with_extension("");
        let name = name.to_str().unwrap().replace('/', "::");
        if !has_ending(&file, &["rs"]) || name == "lib" || name.ends_with("::tests") {
            continue;
        }
        let module = name.strip_suffix("::mod").unwrap_or(&name);
        let Some(room) = rooms.iter().filter(|r| inside(module, &r.path)).max_by_key(|r| r.path.len()) else {
            faults.push(format!("{module} stands in no room of docs/ARCHITECTURE.md"));
            continue;
        };
        lived_in.insert(room.path.clone());
        let code = code(&fs::read_to_string(&file).unwrap());
        let parent = module.rsplit_once("::").map_or("", |(parent, _)| parent);
        let mut imports = paths_after(&code, "crate::", "");
        imports.extend(paths_after(&code, "super::", parent));
        for dependency in &dependencies {
            imports.extend(paths_after(&code, &format!("{dependency}::"), dependency));
        }
        for import in imports {
            if !inside(&import, &room.path) && !room.may_import.iter().any(|allowed| inside(&import, allowed)) {
                faults.push(format!("{module} imports {import}, which room {} may not", room.path));
            }
        }
    }
    faults.extend(rooms.iter().filter(|r| !lived_in.contains(&r.path)).map(|r| format!("room {} is empty", r.path)));
    assert_none(&faults);
}

/// Paths relative to its own folder that a module of the page names, be it to import or to start.
fn relative_paths(code: &str) -> Vec<&str> {
    let starts = code.match_indices(['"', '\'', '`']).map(|(at, _)| &code[at + 1..]);
    let relative = starts.filter(|rest| rest.starts_with("./") || rest.starts_with("../"));
    relative.map(|rest| rest.split(['"', '\'', '`', '$']).next().unwrap()).collect()
}

/// `path` as seen from the folder of `file`; both in the page's folder.
fn resolved(file: &str, path: &str) -> String {
    let mut steps: Vec<&str> = file.split('/').collect();
    steps.pop();
    for step in path.split('/').filter(|step| *step != ".") {
        if step == ".." {
            steps.pop();
        } else {
            steps.push(step);
        }
    }
    steps.join("/")
}

#[test]
fn imports_of_the_page_follow_its_table_of_rooms() {
    let rooms = rooms("room of the page");
    assert!(rooms.len() > 5, "the table of rooms of the page was not found");
    let web = root().join("web");
    let mut faults = Vec::new();
    let mut arrows = BTreeSet::new();
    for path in files("web").into_iter().filter(|path| has_ending(path, &["js"])) {
        let file = path.strip_prefix(&web).unwrap().to_str().unwrap();
        let code = fs::read_to_string(&path).unwrap();
        let Some((folder, _)) = file.split_once('/') else {
            if code.contains("\nimport ") {
                faults.push(format!("{file} imports, and stands in no room"));
            }
            continue;
        };
        let Some(room) = rooms.iter().find(|room| room.path == folder) else {
            faults.push(format!("{file} stands in no room of the page in docs/ARCHITECTURE.md"));
            continue;
        };
        for import in relative_paths(&code).into_iter().map(|import| resolved(file, import)) {
            let target = import.split('/').next().unwrap();
            if target != "pkg" && !web.join(&import).is_file() {
                faults.push(format!("{file} names {import}, which is not there"));
            }
            if target != folder && !room.may_import.iter().any(|allowed| allowed == target) {
                faults.push(format!("{file} imports {import}, which room {folder} may not"));
            }
            arrows.insert((folder.to_string(), target.to_string()));
        }
    }
    for room in &rooms {
        let unused = room.may_import.iter().filter(|to| !arrows.contains(&(room.path.clone(), (*to).clone())));
        faults.extend(unused.map(|to| format!("nothing in {} imports {to}", room.path)));
    }
    // Rooms that import only what is built already are built; where arrows lead round, some never are.
    let mut built = vec!["pkg"];
    while let Some(room) = rooms.iter().find(|room| {
        !built.contains(&room.path.as_str()) && room.may_import.iter().all(|to| built.contains(&to.as_str()))
    }) {
        built.push(&room.path);
    }
    let round = rooms.iter().filter(|room| !built.contains(&room.path.as_str()));
    faults.extend(round.map(|room| format!("arrows from {} lead round, or to no room", room.path)));
    assert_none(&faults);
}

#[test]
fn modules_of_the_page_are_read_whole() {
    let code =
        "import { a } from \"./a.js\";\nconst b = import('../b/c.js');\nnew URL(`../pkg/${name}/d.js`, x); \"e.js\"";
    assert_eq!(relative_paths(code), ["./a.js", "../b/c.js", "../pkg/"], "paths");
    assert_eq!(resolved("b/sub/f.js", "../../pkg/x.js"), "pkg/x.js", "up and down");
    assert_eq!(resolved("b/f.js", "./g.js"), "b/g.js", "beside");
}

#[test]
fn use_trees_are_read_whole() {
    let code = "use crate::{a, b::{self, c}};\nlet x = crate::d::e(1); other_crate::f(); use super::g::*;";
    assert_eq!(paths_after(code, "crate::", ""), ["a", "b", "b::c", "d::e"], "crate");
    assert_eq!(paths_after(code, "super::", "room"), ["room::g::"], "super");
    assert!(inside("numerics::scalar", "numerics"), "inside");
    assert!(!inside("numerics_more", "numerics"), "only whole names");
}

#[test]
fn core_is_no_std_and_bans_the_platforms_float_functions() {
    let lib = read("crates/core/src/lib.rs");
    assert!(lib.lines().any(|line| line == "#![no_std]"), "core without #![no_std]");
    let bans = read("crates/core/clippy.toml");
    for method in ["sin", "cos", "exp", "ln", "sqrt", "powf", "powi", "cosh", "sinh", "tanh", "mul_add"] {
        assert!(bans.contains(&format!("\"f64::{method}\"")), "crates/core/clippy.toml does not ban {method}");
    }
    let lint = "disallowed_methods";
    let sources = files("crates/core/src").into_iter().filter(|path| !path.ends_with("lib.rs"));
    let faults: Vec<String> = sources
        .filter(|path| fs::read_to_string(path).unwrap().contains(lint))
        .map(|path| format!("{} lifts the ban", path.display()))
        .collect();
    assert_none(&faults);
}

/// Crates that would make results differ between targets, or fail in a browser's worker.
#[test]
fn nothing_depends_on_a_crate_that_breaks_parity() {
    let lock = read("Cargo.lock");
    for name in ["matrixmultiply", "ab_glyph", "font-kit"] {
        assert!(!lock.contains(&format!("name = \"{name}\"\n")), "{name} is in Cargo.lock");
    }
}

#[test]
fn three_crates_are_published() {
    let manifests = files("").into_iter().filter(|path| path.ends_with("Cargo.toml"));
    let mut published: Vec<String> = manifests
        .map(|path| fs::read_to_string(path).unwrap())
        .filter(|text| text.contains("[package]") && !text.contains("publish = false"))
        .map(|text| text.split("name = \"").nth(1).unwrap().split('"').next().unwrap().to_string())
        .collect();
    published.sort();
    assert_eq!(published, ["bladefan", "bladefan-core", "bladefan-wasm"], "published crates");
}

#[test]
fn files_hold_one_idea() {
    let sources = files("").into_iter().filter(|path| has_ending(path, &["rs", "js", "mjs", "css", "html", "sh"]));
    let faults: Vec<String> = sources
        .map(|path| (fs::read_to_string(&path).unwrap().lines().count(), path))
        .filter(|(lines, _)| *lines > 600)
        .map(|(lines, path)| format!("{} has {lines} lines, more than 600", path.display()))
        .collect();
    assert_none(&faults);
}

/// A path of somebody's machine or the address of a mirror works nowhere else.
#[test]
fn nothing_names_a_machine_or_a_registry() {
    let here = format!("{}/", root().display());
    let elsewhere = ["/root/", "/home/", "/Users/", "//registry.", "//index.", "//static.rust-lang"];
    let mut faults = Vec::new();
    for path in files("") {
        let this = path.ends_with("tests/tests/tidy.rs");
        let Ok(text) = fs::read_to_string(&path) else { continue };
        for (number, line) in text.lines().enumerate().filter(|_| !this) {
            if line.contains(&here) || elsewhere.iter().any(|address| line.contains(address)) {
                faults.push(format!("{}:{}: {}", path.display(), number + 1, line.trim()));
            }
        }
        if path.ends_with("package-lock.json") && text.contains("\"resolved\"") {
            faults.push(format!("{} names where packages were downloaded", path.display()));
        }
    }
    assert_none(&faults);
}
