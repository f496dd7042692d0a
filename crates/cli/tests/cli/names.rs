//! Names that somebody else chose: in spreadsheets, on terminals, in messages.

use super::{finish, program, run, run_in, run_with, toml};
use serde_json::Value;
use std::fs;

/// What a terminal would obey: clear, title, device control string, application command, 8-bit forms.
const HOSTILE: [&str; 7] = ["\u{1b}[2J", "\u{1b}]0;x\u{7}", "\u{1b}P", "\u{1b}_", "\u{1b}]", "\u{9b}2J", "\u{7f}"];

/// A text as TOML may hold it between quotes.
fn quoted(text: &str) -> String {
    let letters: Vec<String> = text.chars().map(|c| format!("\\u{:04x}", u32::from(c))).collect();
    format!("\"{}\"", letters.concat())
}

/// The uniform blade under another name.
fn named(name: &str) -> String {
    toml("uniform").replace("\"uniform cantilever\"", &quoted(name))
}

#[test]
fn no_name_is_a_formula() {
    for name in ["=HYPERLINK(\"http://a.example\",\"b\")", "=cmd|' /C calc'!A0", "+1", "-1.5", "@SUM(A1)"] {
        for command in ["modes", "check"] {
            let csv = run_with(named(name), &[command, "-", "--format", "csv"]).good();
            let mut rows = 0;
            for row in csv::Reader::from_reader(csv.as_bytes()).records() {
                assert_eq!(row.unwrap()[0], format!("'{name}"), "{command}");
                rows += 1;
            }
            assert!(rows >= 3, "{command} {name}: {csv}");
        }
    }
    for name in ["\t=1", "\r=1"] {
        let csv = run_with(named(name), &["check", "-", "--format", "csv"]).good();
        let first = csv.lines().nth(1).unwrap();
        assert!(first.starts_with("'\\") && first.contains("=1,flap,"), "{csv}");
    }
    // An angle that is negative stays a number.
    let csv = run(&["shapes", "uniform", "--format", "csv"]).good();
    assert!(csv.contains(",-0.") && !csv.contains('\''), "{csv:.400}");
}

#[test]
fn no_row_is_lost_to_a_name() {
    for hostile in HOSTILE {
        let blade = named(&format!("a{hostile}b"));
        for command in ["modes", "check"] {
            let plain = run(&[command, "uniform", "--format", "csv"]).good();
            let csv = run_with(blade.clone(), &[command, "-", "--format", "csv"]).good();
            assert!(!csv.chars().any(|c| c.is_control() && c != '\n'), "{csv:?}");
            let shown: String = hostile.escape_default().to_string();
            let expected = plain.replace("uniform cantilever", &format!("a{shown}b"));
            assert_eq!(csv, expected, "{hostile:?}");
        }
    }
}

#[test]
fn json_keeps_every_character() {
    for hostile in HOSTILE {
        let name = format!("a{hostile}b");
        for command in ["modes", "fan", "check"] {
            let json = run_with(named(&name), &[command, "-", "--format", "json"]).good();
            assert!(!json.chars().any(|c| c.is_control() && c != '\n'), "{json:?}");
            assert_eq!(serde_json::from_str::<Value>(&json).unwrap()["blade"], name, "{command}");
        }
    }
}

#[test]
fn tables_show_what_a_terminal_would_obey() {
    for hostile in HOSTILE {
        for command in ["modes", "fan", "shapes", "converge", "check"] {
            let mut command = program(&[command, "-"]);
            command.write_stdin(named(&format!("a{hostile}b"))).env("CLICOLOR_FORCE", "1");
            let table = finish(command).good();
            assert!(table.starts_with(&format!("a{}b", hostile.escape_default())), "{table:?}");
        }
    }
}

#[test]
fn sources_of_measured_points_are_shown_too() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.csv"), "label,speed,frequency,source\n1F,1,2,a\u{1b}Pb\n").unwrap();
    let table = run_in(folder.path(), &["fan", "uniform", "--measured", "a.csv"]).good();
    assert!(table.ends_with("a\\u{1b}Pb\n"), "{table}");
}

#[test]
fn messages_show_what_a_terminal_would_obey() {
    for hostile in HOSTILE {
        let (name, shown) = (format!("a{hostile}b"), format!("a{}b", hostile.escape_default()));
        let message = run(&["check", &format!("./{name}")]).refused();
        assert_eq!(message, format!("./{shown}: no such file\n"));
        let message = run(&["blades", &name]).refused();
        assert!(message.starts_with(&format!("{shown}: no built-in blade of this name; ")), "{message:?}");
        for arguments in [["fly".into(), name.clone()], [name.clone(), "uniform".into()]] {
            let message = run(&arguments.each_ref().map(String::as_str)).refused();
            assert!(!message.chars().any(|c| c.is_control() && c != '\n'), "{message:?}");
            assert!(message.contains("Usage: "), "the rest of the message was lost: {message:?}");
        }
        let message = run(&["fan", "uniform", "--theme", &name, "--svg", "a"]).refused();
        assert!(message.contains(&format!("'{shown}'")) && message.contains("light"), "{message:?}");
        // A key of a file, quoted so that it may hold anything.
        let toml = format!("{}\n[{}]\n", toml("uniform"), quoted(&name));
        let message = run_with(toml, &["check", "-"]).refused();
        assert!(
            message.starts_with("<stdin>:") && !message.chars().any(|c| c.is_control() && c != '\n'),
            "{message:?}"
        );
    }
}
