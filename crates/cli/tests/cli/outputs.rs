//! Files, streams, colours.

use super::{finish, program, run, run_in, toml};
use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};

#[test]
fn results_and_drawings_go_to_files() {
    let folder = tempfile::tempdir().unwrap();
    let plain = run(&["fan", "tm4760"]).good();
    let arguments = ["fan", "tm4760", "--svg", "a.svg", "--png", "a.png"];
    assert_eq!(run_in(folder.path(), &arguments).good(), plain, "the table still goes to standard output");
    let svg = fs::read_to_string(folder.path().join("a.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("TM 4760"), "{svg:.200}");
    let png = fs::read(folder.path().join("a.png")).unwrap();
    assert!(png.starts_with(b"\x89PNG"), "not a PNG");
    // IHDR holds the width: two pixels per unit of the drawing.
    assert_eq!(png.get(16..20), Some(1920_u32.to_be_bytes().as_slice()));

    assert_eq!(run_in(folder.path(), &["fan", "tm4760", "--output", "a.txt"]).good(), "");
    assert_eq!(fs::read_to_string(folder.path().join("a.txt")).unwrap(), plain);
    let mut names: Vec<_> = fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["a.png", "a.svg", "a.txt"], "nothing else is left");
}

#[test]
fn drawings_have_themes_and_widths() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["shapes", "uniform", "--svg", "a.svg", "--png", "a.png", "--theme", "dark", "--width", "600"];
    run_in(folder.path(), &arguments).good();
    let png = fs::read(folder.path().join("a.png")).unwrap();
    assert_eq!(png.get(16..20), Some(1200_u32.to_be_bytes().as_slice()));
    let dark = fs::read_to_string(folder.path().join("a.svg")).unwrap();
    run_in(folder.path(), &["shapes", "uniform", "--svg", "b.svg", "--width", "600"]).good();
    assert_ne!(dark, fs::read_to_string(folder.path().join("b.svg")).unwrap());
    run(&["shapes", "uniform", "--svg", "c.svg", "--width", "10"]).refused();
}

#[test]
fn drawings_have_heights_and_ranges() {
    let folder = tempfile::tempdir().unwrap();
    for (command, more) in [("fan", ["--frequencies", "0:500"].as_slice()), ("shapes", &[]), ("converge", &[])] {
        let arguments = [command, "tm4760", "--png", "a.png", "--width", "600", "--height", "800"];
        run_in(folder.path(), &[&arguments, more].concat()).good();
        let png = fs::read(folder.path().join("a.png")).unwrap();
        assert_eq!(png.get(20..24), Some(1600_u32.to_be_bytes().as_slice()), "{command}");
    }
    run(&["shapes", "tm4760", "--svg", "a.svg", "--frequencies", "0:500"]).refused();
}

#[test]
fn drawings_have_units() {
    let folder = tempfile::tempdir().unwrap();
    let draw = |units: &[&str]| {
        run_in(folder.path(), &[&["fan", "tm4760", "--svg", "a.svg"], units].concat()).good();
        fs::read_to_string(folder.path().join("a.svg")).unwrap()
    };
    let svg = draw(&[]);
    assert!(svg.contains("rotor speed [rpm]") && svg.contains("frequency [rad/s]"), "the defaults");
    let svg = draw(&["--frequency-unit", "Hz", "--speed-unit", "rad/s"]);
    assert!(svg.contains("rotor speed [rad/s]") && svg.contains("frequency [Hz]"), "as asked for");
    run(&["fan", "tm4760", "--svg", "a.svg", "--frequency-unit", "/rev"]).refused();
    run(&["shapes", "tm4760", "--svg", "a.svg", "--frequency-unit", "Hz"]).refused();
    let svg = draw(&["--frequency-unit", "rpm"]);
    assert!(svg.contains("frequency [rpm]"), "cycles per minute");
    let svg = draw(&["--frequency-unit", "per-rev", "--frequencies", "1:6.5"]);
    assert!(svg.contains("frequency [/rev]"), "per revolution");
    for option in [
        ["--theme", "dark"],
        ["--width", "600"],
        ["--height", "600"],
        ["--speed-unit", "Hz"],
        ["--frequency-unit", "Hz"],
    ] {
        let message = run(&[&["converge", "tm4760"], option.as_slice()].concat()).refused();
        assert!(message.contains("--svg"), "an option of a drawing needs one: {message}");
    }
}

/// A PNG without its texts would still be a PNG.
#[test]
fn texts_are_drawn_with_the_font_that_comes_along() {
    let folder = tempfile::tempdir().unwrap();
    let draw = |blade: String, name: &str| {
        fs::write(folder.path().join("mine.toml"), blade).unwrap();
        run_in(folder.path(), &["fan", "mine.toml", "--png", name]).good();
        fs::read(folder.path().join(name)).unwrap()
    };
    let one = draw(toml("uniform").replace("uniform cantilever", "first blade Ωω×"), "one.png");
    let two = draw(toml("uniform").replace("uniform cantilever", "other blade Ωω×"), "two.png");
    assert_ne!(one, two, "the name is in the picture");
}

#[test]
fn what_cannot_be_written_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    let message =
        run_in(folder.path(), &["fan", "uniform", "--svg", "good.svg", "--output", "no/such/folder.txt"]).failed();
    assert_eq!(message, "no/such/folder.txt: cannot be written: no such file or directory\n");
    run_in(folder.path(), &["fan", "uniform", "--svg", "good.svg", "--output", "."]).failed();
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0, "no file, whole or half");
}

#[test]
fn inputs_and_other_outputs_are_not_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("mine.toml"), toml("uniform")).unwrap();
    let arguments = ["fan", "mine.toml", "--output", "./mine.toml"];
    assert!(run_in(folder.path(), &arguments).refused().starts_with("--output: must be "), "{arguments:?}");
    let arguments = ["fan", "mine.toml", "--svg", "a", "--png", "./a"];
    assert!(run_in(folder.path(), &arguments).refused().starts_with("--png: must be "), "{arguments:?}");
    assert_eq!(fs::read_to_string(folder.path().join("mine.toml")).unwrap(), toml("uniform"));
}

#[cfg(unix)]
#[test]
fn files_keep_their_permissions_and_links_stay_links() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = tempfile::tempdir().unwrap();
    let (file, link) = (folder.path().join("a.csv"), folder.path().join("link.csv"));
    fs::write(&file, "old").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    symlink(&file, &link).unwrap();
    run_in(folder.path(), &["modes", "uniform", "--format", "csv", "--output", "link.csv"]).good();
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink(), "the link was replaced");
    assert!(fs::read_to_string(&file).unwrap().starts_with("blade,"), "the file was not written");
    assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o640);
}

#[cfg(target_os = "linux")]
#[test]
fn devices_are_written_to() {
    run(&["modes", "uniform", "--output", "/dev/null"]).good();
    let message = run(&["modes", "uniform", "--output", "/dev/full"]).failed();
    assert_eq!(message, "/dev/full: cannot be written: no space left on device\n");
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("bladefan"));
    let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = command.args(["modes", "uniform"]).stdout(full).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(output.stderr, b"standard output: cannot be written: no space left on device\n");
}

#[test]
fn a_reader_may_leave() {
    let mut child = Command::new(assert_cmd::cargo::cargo_bin!("bladefan"))
        .args(["fan", "uniform", "--speeds", "0:10:20000", "--format", "csv"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut start = [0; 10];
    let mut stdout = child.stdout.take().unwrap();
    stdout.read_exact(&mut start).unwrap();
    drop(stdout);
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), b"".as_slice()));
}

#[test]
fn colours_are_for_terminals_only() {
    const ESCAPE: char = '\u{1b}';
    let text = run(&["modes", "tm4760"]);
    assert!(!text.stdout.contains(ESCAPE) && !text.stderr.contains(ESCAPE), "{text:?}");
    let mut command = program(&["modes", "tm4760"]);
    command.env("CLICOLOR_FORCE", "1");
    let coloured = finish(command);
    assert!(coloured.stdout.contains(ESCAPE) && coloured.stderr.contains(ESCAPE), "{coloured:?}");
    let mut command = program(&["modes", "tm4760"]);
    command.env("CLICOLOR_FORCE", "1").env("NO_COLOR", "1");
    assert_eq!(finish(command).good(), text.stdout);

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.txt");
    let mut command = program(&["modes", "tm4760", "--output", path.to_str().unwrap()]);
    command.env("CLICOLOR_FORCE", "1");
    finish(command).good();
    assert_eq!(fs::read_to_string(path).unwrap(), text.stdout, "files have none");
}

#[test]
fn warnings_go_to_standard_error() {
    let text = run(&["modes", "sa330"]);
    assert_eq!(text.code, Some(0));
    assert!(text.stderr.lines().count() >= 1, "{text:?}");
    assert!(text.stderr.lines().all(|line| line.starts_with("warning: distribution.")), "{text:?}");
    assert!(!text.stdout.contains("warning:"), "{text:?}");
}
