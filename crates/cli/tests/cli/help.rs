//! `--help` and the version.

use super::run;

#[test]
fn every_command_has_an_example() {
    for command in ["modes", "fan", "shapes", "converge", "check", "blades"] {
        let help = run(&[command, "--help"]).good();
        assert!(help.contains(&format!("  bladefan {command}")), "{command}: {help}");
        assert!(help.contains("Example"), "{command}: {help}");
        assert!(help.lines().all(|line| line.chars().count() <= 100), "{command}: {help}");
    }
}

#[test]
fn help_speaks_of_units_of_speed_and_of_standard_input() {
    let help = run(&["--help"]).good();
    assert!(help.contains("660rpm") && help.contains("- for standard"), "{help}");
}

/// The examples of the help are taken from it and run, all but those with files of the user's.
#[test]
fn examples_of_the_help_run() {
    let folder = tempfile::tempdir().unwrap();
    let mut count = 0;
    for command in ["modes", "fan", "shapes", "converge", "check", "blades"] {
        let help = run(&[command, "--help"]).good();
        for line in help.lines().filter_map(|line| line.strip_prefix("  bladefan ")) {
            if line.contains("my-blade") || line.contains("test.csv") || line.contains('|') {
                continue;
            }
            let arguments: Vec<&str> = line.split(' ').collect();
            super::run_in(folder.path(), &arguments).good();
            count += 1;
        }
    }
    assert!(count >= 6, "only {count} examples");
}

#[test]
fn the_version_is_the_cores() {
    assert_eq!(run(&["--version"]).good(), format!("bladefan {}\n", bladefan_core::VERSION));
}

#[test]
fn no_command_is_bad_usage() {
    assert!(run(&[]).refused().contains("Usage"), "usage says what to write");
    run(&["fly"]).refused();
    run(&["modes"]).refused();
}
