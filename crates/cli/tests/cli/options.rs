//! Options: the core's rules and messages under the command line's names.

use super::run;

#[test]
fn faults_of_options_have_their_names() {
    let cases: [(&[&str], &str); 14] = [
        (&["modes", "uniform", "--speed", "fast"], "--speed: must be "),
        (&["modes", "uniform", "--speed", "-5rpm"], "--speed: must be "),
        (&["modes", "uniform", "--speed", "inf"], "--speed: must be "),
        (&["modes", "uniform", "--modes", "0"], "--modes: must be "),
        (&["modes", "uniform", "--basis", "classical", "--modes", "16"], "--modes: must not be above functions (15)"),
        (&["modes", "uniform", "--functions", "201"], "--functions: must be "),
        (&["modes", "uniform", "--dof", "pitch"], "--dof: must be "),
        (&["modes", "uniform", "--basis", "smooth"], "--basis: must be "),
        (&["fan", "uniform", "--speeds", "3:1:10"], "--speeds: must "),
        (&["fan", "uniform", "--band", "1.1"], "--band: must be "),
        (&["fan", "uniform", "--svg", "a", "--frequencies", "9:5"], "--frequencies: must have 0 <= FROM < TO"),
        (&["fan", "uniform", "--svg", "a", "--frequencies", "-5"], "--frequencies: must be FROM:TO"),
        (&["shapes", "uniform", "--points", "1"], "--points: must be "),
        (&["converge", "uniform", "--up-to", "0"], "--up-to: must be "),
    ];
    for (arguments, start) in cases {
        let message = run(arguments).refused();
        assert!(message.starts_with(start) && message.lines().count() == 1, "{arguments:?}: {message}");
    }
}

#[test]
fn all_faults_of_options_come_at_once() {
    let message = run(&["fan", "uniform", "--modes", "x", "--speeds", "1", "--harmonics", "-1"]).refused();
    assert_eq!(message.lines().count(), 3, "{message}");
    let message = run(&["fan", "uniform", "--svg", "a", "--modes", "0", "--frequencies", "5"]).refused();
    assert_eq!(message.lines().count(), 2, "{message}");
}

#[test]
fn speeds_are_read_in_every_unit() {
    let frequency = |speed: &str| run(&["modes", "uniform", "--speed", speed, "--format", "csv"]).good();
    let first = |text: String| -> f64 { text.lines().nth(1).unwrap().split(',').nth(5).unwrap().parse().unwrap() };
    let expected = first(frequency("12"));
    for speed in ["12rad/s", "114.59155902616465rpm", "1.909859317102744Hz"] {
        assert!((first(frequency(speed)) - expected).abs() < 1e-12 * expected, "{speed}");
    }
    // Wright et al. 1982, EI = m = R = 1.
    assert!((expected - 13.170_15).abs() < 1e-4, "{expected}");
}

#[test]
fn a_convergence_study_takes_more_modes_than_the_other_commands_have_functions() {
    let text = run(&["converge", "uniform", "--modes", "20", "--up-to", "25", "--dof", "flap"]).good();
    assert!(text.contains("20F"), "{text}");
    assert!(run(&["converge", "uniform", "--modes", "51"]).refused().starts_with("--modes: must be from 1 to 50"));
    // Fewer functions than modes are fine: what they do not determine stays open.
    run(&["converge", "uniform", "--up-to", "3"]).good();
}

#[test]
fn degrees_of_freedom_keep_their_order() {
    let text = run(&["modes", "uniform", "--dof", "torsion,flap", "--modes", "1", "--format", "csv"]).good();
    let labels: Vec<&str> = text.lines().skip(1).filter_map(|line| line.split(',').nth(2)).collect();
    assert_eq!(labels, ["1F", "1T"]);
}

#[test]
fn options_that_do_nothing_are_told() {
    let cases: [(&[&str], &str); 4] = [
        (&["fan", "uniform", "--functions", "20"], "warning: --functions: acts with --basis classical only\n"),
        (&["shapes", "uniform", "--functions", "20"], "warning: --functions: acts with --basis classical only\n"),
        (
            &["fan", "uniform", "--harmonics", "3", "--format", "csv"],
            "warning: --harmonics: is in the table, JSON and drawings, not in CSV\n",
        ),
        (&["converge", "uniform", "--basis", "classical"], "warning: --basis: a convergence study has both families\n"),
    ];
    for (arguments, expected) in cases {
        let text = run(arguments);
        assert_eq!((text.code, text.stderr.as_str()), (Some(0), expected), "{arguments:?}");
    }
    assert!(
        run(&["converge", "uniform", "--basis", "x"]).refused().starts_with("--basis: must be "),
        "read all the same"
    );
    assert_eq!(run(&["modes", "uniform", "--functions", "20"]).stderr, "", "the paper's values are beside the others");
}
