//! Every command in every format on every built-in blade.

use super::{BUILT_IN, run, run_in, run_with, toml};
use bladefan_core::Blade;
use bladefan_core::formats::{self, Format};
use bladefan_core::{ModelKind, Settings};
use serde_json::Value;
use std::fs;

const SOLVERS: [&str; 4] = ["modes", "fan", "shapes", "converge"];

fn blade(name: &str) -> Blade {
    formats::read(toml(name), Format::Toml).unwrap().blade
}

#[test]
fn the_list_is_the_library() {
    let names: Vec<&str> = bladefan_core::library::ENTRIES.iter().map(|entry| entry.name).collect();
    assert_eq!(names, BUILT_IN);
    let list: Value = serde_json::from_str(&run(&["blades", "--format", "json"]).good()).unwrap();
    let listed: Vec<&str> =
        list["blades"].as_array().unwrap().iter().map(|blade| blade["name"].as_str().unwrap()).collect();
    assert_eq!(listed, BUILT_IN);
    let table = run(&["blades"]).good();
    assert!(BUILT_IN.iter().all(|name| table.contains(name)), "{table}");
    for name in BUILT_IN {
        assert_eq!(run(&["blades", name]).good(), toml(name), "the file as it stands");
    }
    run(&["blades", "uniform", "--format", "csv"]).refused();
}

#[test]
fn tables_are_as_wide_as_a_terminal_and_say_what_the_model_is() {
    for name in BUILT_IN {
        for command in SOLVERS.into_iter().chain(["check"]) {
            let table = run(&[command, name]).good();
            for line in table.lines() {
                assert!(line.chars().count() <= 100, "{command} {name}: {line}");
                assert!(line.trim_end() == line, "{command} {name}: idle space in {line:?}");
            }
            let words = table.lines().any(|line| line.contains("coupled, in vacuum, "));
            assert_eq!(words, command != "check", "{command} {name}: {table}");
            assert!(!table.contains("NaN") && !table.contains("-0.0000 "), "{command} {name}: {table}");
        }
    }
    let many = run(&["fan", "tm4760", "--harmonics", "30", "--modes", "12"]).good();
    assert!(many.lines().all(|line| line.chars().count() <= 100), "{many}");
}

/// The JSON is what the core says, number by number: the same f64.
#[test]
fn json_reads_back_to_the_same_numbers() {
    fn same(json: &str, expected: &impl serde::Serialize, what: &str) {
        let json: Value = serde_json::from_str(json).unwrap();
        assert_eq!(json, serde_json::to_value(expected).unwrap(), "{what}");
    }
    for (name, model) in BUILT_IN.into_iter().flat_map(|name| [(name, "uncoupled"), (name, "coupled")]) {
        let mut settings = Settings::default();
        settings.set("model", model).unwrap();
        let blade = blade(name);
        let json = |command: &str| {
            let chosen: &[&str] = if command == "check" { &[] } else { &["--model", model] };
            run(&[&[command, name, "--format", "json"], chosen].concat()).good()
        };
        same(&json("fan"), &bladefan_core::fan(&blade, &settings).unwrap(), name);
        if model == "coupled" {
            same(&json("modes"), &bladefan_core::coupled_modes(&blade, &settings).unwrap(), name);
            same(&json("shapes"), &bladefan_core::coupled_shapes(&blade, &settings).unwrap(), name);
            same(&json("converge"), &bladefan_core::converge(&blade, &settings).unwrap(), name);
            continue;
        }
        same(&json("modes"), &bladefan_core::modes(&blade, &settings).unwrap(), name);
        same(&json("shapes"), &bladefan_core::shapes(&blade, &settings).unwrap(), name);
        same(&json("converge"), &bladefan_core::converge(&blade, &settings).unwrap(), name);
        same(&json("check"), &bladefan_core::summary(&blade), name);
    }
}

#[test]
fn json_numbers_are_the_shortest() {
    for command in SOLVERS {
        let text = run(&[command, "tm4760", "--format", "json"]).good();
        assert!(text.ends_with("}\n") && text.lines().count() == 1, "one line");
        let mut count = 0;
        for token in text.split([',', ':', '[', ']', '{', '}']) {
            let Ok(value) = token.parse::<f64>() else { continue };
            let whole = token.parse::<u64>().is_ok();
            assert!(whole || serde_json::to_string(&value).unwrap() == token, "{command}: {token}");
            count += 1;
        }
        assert!(count > 10, "{command}: {count} numbers");
    }
}

#[test]
fn csv_has_the_same_numbers_under_headers_with_units() {
    for name in BUILT_IN {
        let blade = blade(name);
        let rows = |command: &str| {
            let model: &[&str] = if command == "check" { &[] } else { &["--model", "uncoupled"] };
            let text = run(&[&[command, name, "--format", "csv"], model].concat()).good();
            let mut reader = csv::Reader::from_reader(text.as_bytes());
            let header: Vec<String> = reader.headers().unwrap().iter().map(String::from).collect();
            let rows: Vec<Vec<String>> =
                reader.records().map(|row| row.unwrap().iter().map(String::from).collect()).collect();
            (header, rows)
        };
        let number = |text: &String| text.parse::<f64>().unwrap();

        let (header, modes) = rows("modes");
        assert_eq!((header[1].as_str(), header[5].as_str()), ("rotor speed [rad/s]", "frequency [rad/s]"));
        let report = bladefan_core::modes(&blade, &Settings::default()).unwrap();
        assert_eq!(modes.len(), report.modes.len());
        for (row, mode) in modes.iter().zip(&report.modes) {
            assert_eq!((row[0].as_str(), row[2].parse()), (blade.name(), Ok(mode.label)));
            assert_eq!(number(&row[5]).to_bits(), mode.frequency_rad_s.to_bits(), "{name} {}", mode.label);
            let (nearest, margin) = (mode.nearest_harmonic.unwrap(), mode.margin_per_rev.unwrap());
            assert_eq!((row[14].clone(), number(&row[15]).to_bits()), (nearest.to_string(), margin.to_bits()));
            assert!((f64::from(nearest) + margin - mode.per_rev.unwrap()).abs() < 1e-12, "{name} {}", mode.label);
        }

        let (header, fan) = rows("fan");
        assert_eq!((header[0].as_str(), header[1].as_str()), ("rotor speed [rad/s]", "1F [rad/s]"));
        let chart = bladefan_core::fan(&blade, &Settings::of(ModelKind::Uncoupled)).unwrap();
        assert_eq!((fan.len(), header.len()), (chart.speeds_rad_s.len(), chart.branches.len() + 1));
        for (index, row) in fan.iter().enumerate() {
            for (cell, branch) in row[1..].iter().zip(&chart.branches) {
                assert_eq!(number(cell).to_bits(), branch.frequency_rad_s[index].to_bits(), "{name} {}", branch.label);
            }
        }

        let (header, shapes) = rows("shapes");
        assert_eq!(header[..4], ["r [m]", "1F displacement", "1F slope [1/m]", "1F moment [N·m]"]);
        assert_eq!((shapes.len(), header.len()), (101, 46));
        let (header, converge) = rows("converge");
        assert_eq!(header, ["mode", "family", "functions", "frequency [rad/s]", "error [%]"]);
        let row = |mode: &str, family: &str, functions: &str| {
            converge.iter().find(|row| row[..3] == [mode, family, functions]).unwrap()
        };
        assert_eq!(row("2F", "classical", "1")[3..], ["", ""], "one function has no second mode");
        let report = bladefan_core::converge(&blade, &Settings::of(ModelKind::Uncoupled)).unwrap();
        let series = &report.series[1];
        let (paper, converged) = (series.classical_rad_s[14].unwrap(), series.converged_rad_s.unwrap());
        let paper_row = row("2F", "classical", "15");
        assert_eq!(number(&paper_row[3]).to_bits(), paper.to_bits(), "{name}");
        assert!((number(&paper_row[4]) - 100.0 * (paper / converged - 1.0)).abs() < 1e-9, "{name}");
        let steps = &series.piecewise_functions;
        row("2F", "piecewise", &steps.last().unwrap().to_string());
        assert!(converge.len() > 15 * (16 + steps.len() / 2), "{name}: every number of functions of both families");
        assert_eq!(rows("check").1.len(), 3);
    }
}

#[test]
fn modes_at_rest_have_no_harmonic() {
    let json: Value =
        serde_json::from_str(&run(&["modes", "tm4760", "--speed", "0", "--format", "json"]).good()).unwrap();
    let mode = json["modes"][0].as_object().unwrap();
    for key in ["per_rev", "nearest_harmonic", "margin_per_rev"] {
        assert_eq!(mode.get(key), Some(&Value::Null), "{key}");
    }
    let csv = run(&["modes", "tm4760", "--model", "uncoupled", "--speed", "0", "--format", "csv"]).good();
    assert!(csv.lines().next().unwrap().ends_with("residual,nearest harmonic,margin [/rev]"), "{csv}");
    assert!(csv.lines().skip(1).all(|line| line.ends_with(",,")), "{csv}");
}

#[test]
fn names_with_commas_and_quotes_stay_one_field() {
    let text = toml("uniform").replace("\"uniform cantilever\"", "'a \"b\", c'");
    let csv = run_with(text.clone(), &["modes", "-", "--format", "csv"]).good();
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    assert_eq!(&reader.records().next().unwrap().unwrap()[0], "a \"b\", c");
    let json: Value = serde_json::from_str(&run_with(text, &["modes", "-", "--format", "json"]).good()).unwrap();
    assert_eq!(json["blade"], "a \"b\", c");
}

#[test]
fn measured_points_are_compared_at_their_own_speed() {
    let folder = tempfile::tempdir().unwrap();
    let points = "label,speed [rpm],frequency [Hz],source\n1F,114.59155902616465,2.1,\"test, first\"\n9T,10,5,other\n";
    fs::write(folder.path().join("test.csv"), points).unwrap();
    let arguments = ["fan", "uniform", "--measured", "test.csv", "--svg", "a.svg"];
    let table = run_in(folder.path(), &arguments).good();
    assert!(table.contains("test, first"), "{table}");
    let svg = fs::read_to_string(folder.path().join("a.svg")).unwrap();
    assert!(svg.contains("test, first"), "the chart's legend names the source");

    let json = run_in(folder.path(), &["fan", "uniform", "--measured", "test.csv", "--format", "json"]).good();
    let json: Value = serde_json::from_str(&json).unwrap();
    let point = &json["measured"][0];
    assert_eq!((point["label"].as_str(), point["source"].as_str()), (Some("1F"), Some("test, first")));
    // Wright et al. 1982 at 12 rad/s: 13.1702; measured 2.1 Hz = 13.1947 rad/s.
    let (computed, error) = (point["computed_rad_s"].as_f64().unwrap(), point["error_percent"].as_f64().unwrap());
    assert!((computed - 13.170_15).abs() < 1e-4, "{point}");
    assert!((error - 100.0 * (computed / 13.194_689_145_077_131 - 1.0)).abs() < 1e-9, "{point}");
    assert_eq!(json["measured"][1]["computed_rad_s"], Value::Null, "a branch that was not asked for");

    fs::write(folder.path().join("bad.csv"), "label,speed,frequency\n1F,x,2\n").unwrap();
    let message = run_in(folder.path(), &["fan", "uniform", "--measured", "bad.csv"]).refused();
    assert!(message.starts_with("bad.csv:"), "{message}");
    assert_eq!(run(&["fan", "uniform", "--measured", "none.csv"]).refused(), "none.csv: no such file\n");

    let many = format!("# many\nlabel,speed,frequency,source\n{}", "1F,1,2,me\n".repeat(100_001));
    fs::write(folder.path().join("many.csv"), many).unwrap();
    let message = run_in(folder.path(), &["fan", "uniform", "--measured", "many.csv"]).refused();
    assert_eq!(message, "many.csv:100003:1: points: must be at most 100000 (are 100001)\n");
}
