//! Files, streams, colours.

use super::{finish, program, run, run_in, toml};
use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};

/// The program, to be run in the background or with streams of its own.
fn raw(arguments: &[&str]) -> Command {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("bladefan"));
    command.args(arguments);
    command
}

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
    for arguments in [["modes", "uniform"].as_slice(), &["--help"], &["--version"]] {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = raw(arguments).stdout(full).output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert_eq!(output.stderr, b"standard output: cannot be written: no space left on device\n", "{arguments:?}");
    }
}

/// A log that others write to as well keeps what they wrote.
#[cfg(target_os = "linux")]
#[test]
fn a_stream_is_written_to_by_any_of_its_names() {
    let folder = tempfile::tempdir().unwrap();
    let log = folder.path().join("log");
    let expected = run(&["check", "uniform"]).good();
    std::os::unix::fs::symlink("/dev/stdout", folder.path().join("link")).unwrap();
    for name in ["/dev/stdout", "/proc/self/fd/1", "link"] {
        fs::write(&log, "before\n").unwrap();
        let append = fs::OpenOptions::new().append(true).open(&log).unwrap();
        let mut command = raw(&["check", "uniform", "--output", name]);
        assert!(command.current_dir(folder.path()).stdout(append).status().unwrap().success(), "{name}");
        assert_eq!(fs::read_to_string(&log).unwrap(), format!("before\n{expected}"), "{name}");
    }
    // `(echo before; bladefan …; echo after) > log`: what comes after does not overwrite.
    let mut shared = fs::File::create(&log).unwrap();
    std::io::Write::write_all(&mut shared, b"before\n").unwrap();
    let mut command = raw(&["check", "uniform", "--output", "/dev/stdout"]);
    assert!(command.stdout(shared.try_clone().unwrap()).status().unwrap().success(), "written");
    std::io::Write::write_all(&mut shared, b"after\n").unwrap();
    assert_eq!(fs::read_to_string(&log).unwrap(), format!("before\n{expected}after\n"));
    // Standard error likewise, by a drawing.
    fs::write(&log, "before\n").unwrap();
    let append = fs::OpenOptions::new().append(true).open(&log).unwrap();
    let mut command = raw(&["fan", "uniform", "--svg", "/dev/stderr"]);
    assert!(command.stderr(append).stdout(Stdio::null()).status().unwrap().success(), "drawn");
    assert!(fs::read_to_string(&log).unwrap().starts_with("before\n<svg"), "the log was replaced");
}

/// A stream that is open under another number is appended to.
#[cfg(target_os = "linux")]
#[test]
fn a_stream_of_another_number_is_not_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let log = folder.path().join("log");
    fs::write(&log, "before\n").unwrap();
    let program = assert_cmd::cargo::cargo_bin!("bladefan").display();
    let line = format!("{program} check uniform --output /dev/fd/5 5>> {}", log.display());
    assert!(Command::new("sh").args(["-c", &line]).status().unwrap().success(), "{line}");
    assert!(fs::read_to_string(&log).unwrap().starts_with("before\nuniform cantilever: "), "the log was replaced");
}

#[cfg(unix)]
#[test]
fn a_link_to_nothing_yet_is_written_through() {
    use std::os::unix::fs::symlink;
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("results")).unwrap();
    symlink("results/today.csv", folder.path().join("latest.csv")).unwrap();
    run_in(folder.path(), &["modes", "uniform", "--format", "csv", "--output", "latest.csv"]).good();
    assert!(fs::symlink_metadata(folder.path().join("latest.csv")).unwrap().is_symlink(), "the link was replaced");
    let text = fs::read_to_string(folder.path().join("results/today.csv")).unwrap();
    assert!(text.starts_with("blade,"), "{text}");

    symlink("nowhere/today.csv", folder.path().join("lost.csv")).unwrap();
    let message = run_in(folder.path(), &["modes", "uniform", "--output", "lost.csv"]).failed();
    assert_eq!(message, "lost.csv: cannot be written: no such file or directory\n");
    symlink("ring", folder.path().join("ring")).unwrap();
    let message = run_in(folder.path(), &["modes", "uniform", "--output", "ring"]).failed();
    assert!(message.starts_with("ring: cannot be written: "), "{message}");
    // Two names of one file that is not there yet.
    let arguments = ["fan", "uniform", "--output", "latest.csv", "--svg", "results/today.csv"];
    assert!(run_in(folder.path(), &arguments).refused().starts_with("--svg: must be "), "{arguments:?}");
}

/// While the reader of a pipe takes its time, no half-made file waits to be left behind.
#[cfg(unix)]
#[test]
fn an_interrupt_leaves_nothing_behind() {
    use nix::sys::signal::{Signal, kill};
    use nix::unistd::{Pid, mkfifo};
    let folder = tempfile::tempdir().unwrap();
    let pipe = folder.path().join("pipe");
    mkfifo(&pipe, nix::sys::stat::Mode::S_IRWXU).unwrap();
    for signal in [Signal::SIGINT, Signal::SIGTERM] {
        // The drawing has twice as much as a pipe holds (64 kB).
        let mut command = raw(&["converge", "uniform", "--modes", "10", "--output", "a.txt", "--svg", "pipe"]);
        let mut child = command.current_dir(folder.path()).spawn().unwrap();
        let mut reader = fs::File::open(&pipe).unwrap();
        let mut start = [0; 4];
        reader.read_exact(&mut start).unwrap();
        assert_eq!((&start, child.try_wait().unwrap()), (b"<svg", None), "it waits for its reader");
        kill(Pid::from_raw(child.id().try_into().unwrap()), signal).unwrap();
        let status = child.wait().unwrap();
        assert_eq!(std::os::unix::process::ExitStatusExt::signal(&status), Some(signal as i32), "ended by the signal");
        let mut names: Vec<_> = fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        assert_eq!(names, ["a.txt", "pipe"], "something is left");
    }
}

#[cfg(unix)]
#[test]
fn a_pipe_is_written_to() {
    let folder = tempfile::tempdir().unwrap();
    let pipe = folder.path().join("pipe");
    nix::unistd::mkfifo(&pipe, nix::sys::stat::Mode::S_IRWXU).unwrap();
    let mut child = raw(&["check", "uniform", "--output", pipe.to_str().unwrap()]).spawn().unwrap();
    let text = fs::read_to_string(&pipe).unwrap();
    assert!(child.wait().unwrap().success() && text == run(&["check", "uniform"]).good(), "{text}");
}

#[test]
fn a_reader_may_leave() {
    let mut child = raw(&["fan", "uniform", "--speeds", "0:10:20000", "--format", "csv"])
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
    let text = run(&["modes", "tm4760", "--model", "uncoupled"]);
    assert!(!text.stdout.contains(ESCAPE) && !text.stderr.contains(ESCAPE), "{text:?}");
    let mut command = program(&["modes", "tm4760", "--model", "uncoupled"]);
    command.env("CLICOLOR_FORCE", "1");
    let coloured = finish(command);
    assert!(coloured.stdout.contains(ESCAPE) && coloured.stderr.contains(ESCAPE), "{coloured:?}");
    let mut command = program(&["modes", "tm4760", "--model", "uncoupled"]);
    command.env("CLICOLOR_FORCE", "1").env("NO_COLOR", "1");
    assert_eq!(finish(command).good(), text.stdout);

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.txt");
    let mut command = program(&["modes", "tm4760", "--model", "uncoupled", "--output", path.to_str().unwrap()]);
    command.env("CLICOLOR_FORCE", "1");
    finish(command).good();
    assert_eq!(fs::read_to_string(path).unwrap(), text.stdout, "files have none");
}

#[test]
fn warnings_go_to_standard_error() {
    let text = run(&["modes", "sa330", "--model", "uncoupled"]);
    assert_eq!(text.code, Some(0));
    assert!(text.stderr.lines().count() >= 1, "{text:?}");
    assert!(text.stderr.lines().all(|line| line.starts_with("warning: distribution.")), "{text:?}");
    assert!(!text.stdout.contains("warning:"), "{text:?}");
}
