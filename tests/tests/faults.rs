//! One bad input per rule, each with its faults: kind, path, place and words; and inputs that are
//! meant to break the reader.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may stop")]

use bladefan_core::formats::{Entry, Format, Node, Tree, measured, read, read_tree, to_json, to_toml};
use bladefan_core::library::ENTRIES;
use bladefan_core::warnings;
use bladefan_core::{BladeDefinition, Property, PropertyDefinition};
use bladefan_core::{Fault, FaultCode, Faults};
use bladefan_tests::faults::{BASE_JSON, BASE_TOML, Case, Expected, cases};
use core::fmt::Write;
use core::time::Duration;
use std::time::Instant;

fn format(case: &Case) -> Format {
    if case.format == "json" { Format::Json } else { Format::Toml }
}

fn as_expected(fault: &Fault) -> Expected {
    Expected {
        code: fault.code,
        path: fault.path.clone(),
        line: fault.line.unwrap_or(0),
        column: fault.column.unwrap_or(0),
        message: fault.message.clone(),
    }
}

fn faults(text: &str, format: Format) -> Faults {
    read(text, format).expect_err("this file is bad")
}

#[test]
fn the_base_files_are_sound_and_the_same() {
    let toml = read(BASE_TOML, Format::Toml).unwrap();
    let json = read(BASE_JSON, Format::Json).unwrap();
    assert_eq!(toml, json);
    assert!(toml.blade.warnings().is_empty(), "{:?}", toml.blade.warnings());
}

#[test]
fn every_bad_file_gives_its_faults_where_they_stand() {
    let mut wrong = String::new();
    for case in cases() {
        let found: Vec<_> = faults(&case.text(), format(&case)).iter().map(as_expected).collect();
        if found != case.faults {
            write!(wrong, "{}:\nexpected {:#?}\nfound {found:#?}\n", case.name, case.faults).unwrap();
        }
        assert!(!case.faults.is_empty(), "{} expects nothing", case.name);
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn every_kind_of_fault_that_a_file_can_have_has_a_case() {
    let cases = cases();
    for code in [
        FaultCode::Syntax,
        FaultCode::Schema,
        FaultCode::UnknownKey,
        FaultCode::Missing,
        FaultCode::WrongType,
        FaultCode::UnknownChoice,
        FaultCode::UnknownUnit,
        FaultCode::NotFinite,
        FaultCode::OutOfRange,
        FaultCode::Length,
        FaultCode::Radii,
        FaultCode::Uncovered,
        FaultCode::Conflict,
    ] {
        let shown = |case: &Case| case.faults.iter().any(|fault| fault.code == code);
        assert!(cases.iter().any(shown), "{}", code.name());
    }
}

/// An object as a caller without a text has it.
fn tree(value: serde_json::Value) -> Tree {
    Tree::new(match value {
        serde_json::Value::Null => Node::Null,
        serde_json::Value::Bool(value) => Node::Bool(value),
        serde_json::Value::Number(value) => Node::Number(value.as_f64().unwrap()),
        serde_json::Value::String(value) => Node::Text(value),
        serde_json::Value::Array(values) => Node::List(values.into_iter().map(tree).collect()),
        serde_json::Value::Object(values) => {
            let entry = |(key, value)| Entry { key, key_span: None, value: tree(value) };
            Node::Table(values.into_iter().map(entry).collect())
        }
    })
}

#[test]
fn an_object_gives_the_same_faults_as_its_text_without_places() {
    for case in cases().iter().filter(|case| case.format == "json") {
        let Ok(value) = serde_json::from_str::<serde_json::Value>(&case.text()) else { continue };
        // serde_json keeps the last of two equal keys; a JavaScript object has only one.
        if case.faults.iter().any(|fault| fault.code == FaultCode::Syntax) {
            continue;
        }
        let found = read_tree(&tree(value)).unwrap_err();
        assert!(found.iter().all(|fault| fault.line.is_none() && fault.column.is_none()));
        let mut found: Vec<_> = found.iter().map(|fault| &fault.message).collect();
        let mut expected: Vec<_> = case.faults.iter().map(|fault| &fault.message).collect();
        found.sort();
        expected.sort();
        assert_eq!(found, expected, "{}", case.name);
    }
}

#[test]
fn what_does_not_act_is_a_warning() {
    let text = BASE_TOML
        .replace("mass_offset = 0.0", "mass_offset = [0, 0, 0, 0, -0.01]")
        .replace("twist = 0.0", "twist = { r = [0.0, 2.5], values = [0, -8] }");
    let warnings: Vec<_> =
        warnings(&read(&text, Format::Toml).unwrap().blade).iter().map(ToString::to_string).collect();
    assert_eq!(
        warnings,
        [
            "distribution.twist.r: radii beyond the tip radius do not act",
            "distribution.mass_offset: acts in torsion only",
            "distribution.twist: not used by the uncoupled solver",
        ]
    );
    let text = BASE_TOML
        .replace("mass = [3.0, 2.5, 1.0, 0.8, 0.8]", "mass = 1")
        .replace("flap_stiffness = [900.0, 400.0, 120.0, 100.0, 80.0]", "flap_stiffness = 100");
    let file = read(&text, Format::Toml).unwrap();
    assert_eq!(file.blade.warnings()[0].to_string(), "distribution.r: not used: no property is a list on these radii");
}

#[test]
fn ends_within_the_tolerance_cover() {
    let near = BASE_TOML.replace("r = [0.25, 1.0, 2.0]", "r = [0.250000001, 1.0, 1.999999999]");
    assert!(read(&near, Format::Toml).is_ok());
    let far = BASE_TOML.replace("r = [0.25, 1.0, 2.0]", "r = [0.250000003, 1.0, 2.0]");
    assert_eq!(faults(&far, Format::Toml)[0].code, FaultCode::Uncovered);
}

#[test]
fn a_byte_order_mark_and_other_line_ends_change_nothing() {
    let bad = BASE_TOML.replace("= 60.0", "= -60.0");
    let expected = faults(&bad, Format::Toml);
    assert_eq!(faults(&format!("\u{feff}{bad}"), Format::Toml), expected);
    assert_eq!(faults(&bad.replace('\n', "\r\n"), Format::Toml), expected);
    let marked = format!("\u{feff}{BASE_JSON}");
    assert_eq!(Format::of_text(&marked), Format::Json);
    assert!(read(&marked, Format::Json).is_ok());
}

/// A limit that only work growing faster than the input can pass.
const SLOW: Duration = Duration::from_secs(30);

#[test]
fn large_and_deep_inputs_end_in_faults_and_in_time() {
    let size = 10_000_000;
    let deep_toml = format!("a = {}", "[".repeat(size));
    let deep_table = format!("a = {}", "{b=".repeat(size / 3));
    let dotted = format!("{}a = 1", "a.".repeat(size / 2));
    let header = format!("[{}a]", "a.".repeat(size / 2));
    let deep_json = "[".repeat(size);
    let deep_object = "{\"a\":".repeat(size / 5);
    let long_key = format!("{} = 1", "k".repeat(size));
    let long_text = format!("name = \"{}\"", "n".repeat(size));
    let zeros = format!("radius = 0.{}", "0".repeat(size));
    let keys: String = (0..100_000).fold(String::new(), |mut text, i| {
        let _ = writeln!(text, "key{i} = {i}");
        text
    });
    let same = "a = 1\n".repeat(300_000);
    let one_line = format!("{{\"{}", keys.replace(" = ", "\":").replace('\n', ",\"")) + "a\":1}";
    let blank = " ".repeat(size);
    let nul = "\0".repeat(size);
    let quotes = "\"".repeat(size);
    let cases: [(&str, &str, Format); 16] = [
        ("lists in TOML", &deep_toml, Format::Toml),
        ("tables in TOML", &deep_table, Format::Toml),
        ("dotted key", &dotted, Format::Toml),
        ("dotted header", &header, Format::Toml),
        ("lists in JSON", &deep_json, Format::Json),
        ("objects in JSON", &deep_object, Format::Json),
        ("long key", &long_key, Format::Toml),
        ("long text", &long_text, Format::Toml),
        ("long number", &zeros, Format::Toml),
        ("many keys", &keys, Format::Toml),
        ("the same key", &same, Format::Toml),
        ("one long line", &one_line, Format::Json),
        ("blanks", &blank, Format::Json),
        ("NUL", &nul, Format::Toml),
        ("NUL in JSON", &nul, Format::Json),
        ("quotes", &quotes, Format::Toml),
    ];
    for (name, text, format) in cases {
        let start = Instant::now();
        let faults = faults(text, format);
        assert!(start.elapsed() < SLOW, "{name}: {:?}", start.elapsed());
        assert!(faults.iter().all(|fault| fault.message.len() < 400), "{name}: a message is too long");
    }
}

fn many_stations(count: usize, value: impl Fn(usize) -> f64) -> BladeDefinition {
    let mut definition = read(BASE_TOML, Format::Toml).unwrap().definition;
    let r = (0..count).map(|i| 0.1 + 1.9 * (i as f64) / (count - 1) as f64).collect();
    let distribution = definition.distribution.as_mut().unwrap();
    distribution[Property::Mass] = Some(PropertyDefinition::OwnRadii { r, values: (0..count).map(value).collect() });
    definition
}

#[test]
fn ten_thousand_stations_are_read_or_refused_one_by_one() {
    let start = Instant::now();
    let good = to_toml(&many_stations(10_000, |_| 1.0));
    assert_eq!(read(&good, Format::Toml).unwrap().blade.mass().stations().len(), 10_000);
    let bad = faults(&to_json(&many_stations(10_000, |_| -1.0)), Format::Json);
    assert_eq!(bad.len(), 10_000, "one for each value");
    assert!(start.elapsed() < SLOW, "{:?}", start.elapsed());
}

#[test]
fn more_stations_than_that_are_refused_as_a_whole() {
    let start = Instant::now();
    for text in [to_toml(&many_stations(100_000, |_| -1.0)), to_toml(&many_stations(10_001, |_| 1.0))] {
        let found: Vec<String> = faults(&text, Format::Toml).into_iter().map(|fault| fault.path).collect();
        assert_eq!(found, ["distribution.mass.r", "distribution.mass.values"]);
    }
    assert!(start.elapsed() < SLOW, "{:?}", start.elapsed());
}

#[test]
fn every_library_blade_reads_back_from_what_is_written_of_it() {
    for entry in ENTRIES {
        let file = read(entry.toml, Format::Toml).unwrap();
        assert_eq!(read(&to_toml(&file.definition), Format::Toml).unwrap(), file, "{}", entry.name);
        assert_eq!(read(&to_json(&file.definition), Format::Json).unwrap(), file, "{}", entry.name);
    }
}

#[test]
fn measured_points_are_read_in_their_units() {
    let text = "# wind tunnel\nsource, frequency [Hz], label, speed [rpm]\ntest, 11.5, 1F, 660\n\"a, b\", 0, 12T, 0\n";
    let points = measured::read(text).unwrap();
    assert_eq!(points.len(), 2);
    assert!((points[0].frequency_rad_s - 72.256_631_032_565_24).abs() < 1e-12);
    assert!((points[0].speed_rad_s - 69.115_038_378_975_45).abs() < 1e-12);
    assert_eq!((points[1].label.to_string().as_str(), points[1].source.as_str()), ("12T", "a, b"));
    let plain = measured::read("label,speed,frequency,source\n1L,2,3,me\n").unwrap();
    assert!((plain[0].speed_rad_s - 2.0).abs() < 1e-15 && (plain[0].frequency_rad_s - 3.0).abs() < 1e-15);
}

#[test]
fn faults_of_measured_points_have_places() {
    let shown = |text: &str| -> Vec<String> {
        measured::read(text).unwrap_err().iter().map(|fault| format!("{} {fault}", fault.code.name())).collect()
    };
    assert_eq!(
        shown("label,speed,frequency,source\n1F,1,2,x\nF1, fast ,-2,x\n\n3L,1,inf,\"π, e\"\n1T,1\n\"0L\",-0.5,1,x"),
        [
            "unknown-choice 3:1: points[1].label: label must be a number and F, L or T, like 1F (is \"F1\")",
            "wrong-type 3:5: points[1].speed: must be a number (is \"fast\")",
            "out-of-range 3:11: points[1].frequency: must be at least 0 (is \"-2\")",
            "not-finite 5:6: points[2].frequency: must be finite (is \"inf\")",
            "length 6:1: points[3]: must have 4 fields like the header (has 2)",
            "unknown-choice 7:1: points[4].label: label must be a number and F, L or T, like 1F (is \"0L\")",
            "out-of-range 7:6: points[4].speed: must be at least 0 (is \"-0.5\")",
        ]
    );
    assert_eq!(
        shown("label [m],speed [knots],speed,wind\n"),
        [
            "conflict 1:1: header.label: this column has no unit (is \"m\")",
            "missing 1:1: header.frequency: column frequency must be given",
            "missing 1:1: header.source: column source must be given",
            "unknown-unit 1:11: header.speed: unit must be rad/s, rpm or Hz (is \"knots\")",
            "conflict 1:25: header.speed: column must stand only once (is \"speed\")",
            "unknown-key 1:31: header[3]: column must be label, speed, frequency or source (is \"wind\")",
        ]
    );
    assert_eq!(shown(""), ["missing 1:1: header: must have a header row: label, speed, frequency, source"]);
}

/// The text of the first block of this language in the documentation.
fn documented(language: &str) -> String {
    let document = include_str!("../../docs/BLADE_FORMAT.md");
    let (_, rest) = document.split_once(&format!("```{language}\n")).unwrap();
    rest.split_once("```").unwrap().0.to_owned()
}

#[test]
fn the_documented_files_are_sound_and_the_same() {
    let toml = read(&documented("toml"), Format::Toml).unwrap();
    assert_eq!(toml, read(&documented("json"), Format::Json).unwrap());
    assert_eq!(measured::read(&documented("csv")).unwrap().len(), 3);
}
