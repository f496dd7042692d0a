//! Which blade `BLADE` names.

use super::{run, run_in, run_with, toml};
use std::fs;

#[test]
fn a_built_in_name_wins_over_a_file() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("uniform"), toml("tm4760")).unwrap();
    let name = |argument: &str| run_in(folder.path(), &["modes", argument]).good();
    assert!(name("uniform").starts_with("uniform cantilever"), "the built-in blade");
    assert!(name("./uniform").starts_with("TM 4760"), "the file");
}

#[test]
fn a_file_in_this_folder_needs_no_ending() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("mine"), toml("tm4760")).unwrap();
    assert!(run_in(folder.path(), &["modes", "mine"]).good().starts_with("TM 4760"), "read as TOML");
}

#[test]
fn endings_tell_the_format() {
    let folder = tempfile::tempdir().unwrap();
    let json = run(&["blades", "tm4760", "--format", "json"]).good();
    fs::write(folder.path().join("mine.json"), &json).unwrap();
    fs::write(folder.path().join("mine.TOML"), toml("tm4760")).unwrap();
    fs::write(folder.path().join("wrong.toml"), &json).unwrap();
    let from_json = run_in(folder.path(), &["modes", "mine.json"]).good();
    assert_eq!(from_json, run_in(folder.path(), &["modes", "mine.TOML"]).good());
    assert_eq!(from_json, run(&["modes", "tm4760"]).good(), "JSON, TOML and the built-in blade are one");
    assert!(run_in(folder.path(), &["modes", "wrong.toml"]).refused().starts_with("wrong.toml:1:"), "read as TOML");
}

#[test]
fn standard_input_is_json_where_it_begins_with_a_brace() {
    let expected = run(&["modes", "sa330"]).good();
    let json = run(&["blades", "sa330", "--format", "json"]).good();
    for text in [toml("sa330").to_owned(), json.clone(), format!("\n  {json}")] {
        assert_eq!(run_with(text, &["modes", "-"]).good(), expected);
    }
    let faults = run_with("schema = 1\n", &["check", "-"]).refused();
    assert!(faults.lines().all(|line| line.starts_with("<stdin>:")), "{faults}");
}

/// Flap and lag alone, with a line that says so; torsion by name is refused.
#[test]
fn a_blade_may_have_no_torsion() {
    let text = toml("uniform").replace("[torsion]\nroot = \"rigid\"\n", "");
    let text = text.replace("torsion_stiffness = 1\npolar_inertia = 1", "");
    for model in ["uncoupled", "coupled"] {
        let found = run_with(text.clone(), &["modes", "-", "--model", model]);
        assert!(found.stderr.contains("torsion: no torsion data: flap and lag alone"), "{found:?}");
        let table = found.good();
        assert!(table.contains("1F") && table.contains("1L") && !table.contains("1T"), "{table}");
    }
    let refused = run_with(text.clone(), &["modes", "-", "--dof", "torsion"]).refused();
    let missing = "torsion needs torsion data of the blade: [torsion], torsion_stiffness and polar_inertia";
    assert!(refused.contains(missing), "{refused}");
    let summary = run_with(text, &["check", "-"]);
    assert!(summary.stderr.contains("no torsion data"), "{summary:?}");
    assert!(!summary.good().contains("torsion"), "no row of it");
}

#[test]
fn what_is_not_there_is_said_so() {
    let message = run(&["modes", "tm476"]).refused();
    assert_eq!(message, "tm476: no built-in blade and no file of this name; did you mean tm4760?\n");
    let message = run(&["modes", "qqqq"]).refused();
    assert!(message.contains("built in are tm4760, sa330, "), "{message}");
    assert_eq!(run(&["modes", "./no/such.toml"]).refused(), "./no/such.toml: no such file\n");
    assert!(run(&["blades", "Uniform"]).refused().contains("did you mean uniform?"), "for `blades` too");
}

#[test]
fn a_folder_is_no_blade() {
    let folder = tempfile::tempdir().unwrap();
    let path = format!("{}/", folder.path().display());
    assert!(run(&["modes", &path]).refused().contains("cannot be read"), "{path}");
}

#[test]
fn text_that_is_not_utf_8_is_a_fault_with_its_place() {
    let message = run_with(b"a = 1\nb = \"\xc3\xbc\xff\"\n".to_vec(), &["check", "-"]).refused();
    assert_eq!(message, "<stdin>:2:7: the text must be UTF-8 (has the byte 0xff)\n");
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("mine.toml"), b"\xfe").unwrap();
    let message = run_in(folder.path(), &["check", "mine.toml"]).refused();
    assert!(message.starts_with("mine.toml:1:1: "), "{message}");
}

#[test]
fn an_input_that_is_too_long_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    fs::File::create(folder.path().join("large.toml")).unwrap().set_len(64_000_001).unwrap();
    let message = run_in(folder.path(), &["check", "large.toml"]).refused();
    assert_eq!(message, "large.toml: must be at most 64 MB long (is 64000001 bytes)\n");
    let message = run_in(folder.path(), &["fan", "uniform", "--measured", "large.toml"]).refused();
    assert_eq!(message, "large.toml: must be at most 64 MB long (is 64000001 bytes)\n");
}

#[cfg(target_os = "linux")]
#[test]
fn an_endless_input_is_refused() {
    let endless = fs::File::open("/dev/zero").unwrap();
    let program = assert_cmd::cargo::cargo_bin!("bladefan");
    let output = std::process::Command::new(program).args(["check", "-"]).stdin(endless).output().unwrap();
    assert_eq!((output.status.code(), output.stdout.as_slice()), (Some(2), b"".as_slice()));
    assert_eq!(output.stderr, b"<stdin>: must be at most 64 MB long (is longer)\n");
    assert_eq!(run(&["check", "/dev/zero"]).refused(), "/dev/zero: must be at most 64 MB long (is longer)\n");
}
