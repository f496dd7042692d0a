//! Whole tables, as the commands in this file's test print them. After a change that is meant, run
//! them again and look at the difference: `bladefan check tm4760 > crates/cli/tests/cli/tables/check.txt`.

use super::run;

#[test]
fn tables_look_like_this() {
    let cases: [(&[&str], &str); 10] = [
        (&["check", "tm4760"], include_str!("tables/check.txt")),
        (&["modes", "tm4760", "--model", "uncoupled"], include_str!("tables/modes.txt")),
        (
            &["modes", "tm4760", "--model", "uncoupled", "--basis", "classical", "--modes", "2"],
            include_str!("tables/classical.txt"),
        ),
        (&["fan", "tm4760", "--model", "uncoupled", "--modes", "3"], include_str!("tables/fan.txt")),
        (&["modes", "twisted"], include_str!("tables/modes-coupled.txt")),
        (&["fan", "twisted", "--modes", "6"], include_str!("tables/fan-coupled.txt")),
        (&["shapes", "twisted", "--modes", "2"], include_str!("tables/shapes-coupled.txt")),
        (&["converge", "twisted", "--modes", "4", "--up-to", "5"], include_str!("tables/converge-coupled.txt")),
        (&["shapes", "uniform", "--dof", "flap"], include_str!("tables/shapes.txt")),
        (
            &["converge", "tm4760", "--model", "uncoupled", "--modes", "2", "--up-to", "5"],
            include_str!("tables/converge.txt"),
        ),
    ];
    for (arguments, expected) in cases {
        assert_eq!(run(arguments).good(), expected, "bladefan {}", arguments.join(" "));
    }
}
