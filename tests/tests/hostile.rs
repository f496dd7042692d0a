//! Legal blades that break solvers ([`bladefan_tests::hostile`]): each question in a process of its own
//! with a limit of processor time and of memory. It may answer, warn or refuse; it may not panic, abort or
//! go on, and no bound that it states may be contradicted by the independent solution.
//!
//! 100 blades; `BLADEFAN_HOSTILE=2000` asks for more, `BLADEFAN_HOSTILE_FROM` for others. The limit is 2 s
//! in a release build, and three times as much without its optimisation.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]
#![allow(clippy::print_stdout, reason = "what was seen is worth reading when all is well, too")]

use bladefan_core::Dof;
use bladefan_core::formats::to_json;
use bladefan_tests::hostile::{Hostile, case};
use bladefan_tests::verdict::{self, Verdict};
use serde_json::Value;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// Seconds of processor time for one answer.
const SECONDS: u32 = if cfg!(debug_assertions) { 6 } else { 2 };
/// Kilobytes of memory for one answer, the program itself among them.
const KILOBYTES: u32 = 200_000;
/// Signals by which the limits end a process.
const TOO_LONG: [i32; 2] = [24, 9];

/// How a question ended.
enum Ended {
    Answered(Value),
    Refused,
    Broken(String),
}

fn ask(question: &str, file: &Path, options: &[(&str, String)]) -> Ended {
    let limits = r#"ulimit -t "$1" && ulimit -v "$2" && shift 2 && exec "$@""#;
    let limited = [SECONDS.to_string(), KILOBYTES.to_string(), env!("CARGO_BIN_EXE_answer").into(), question.into()];
    let options = options.iter().flat_map(|(name, value)| [(*name).to_string(), value.clone()]);
    let output = Command::new("sh").args(["-c", limits, "sh"]).args(limited).arg(file).args(options).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    match (output.status.code(), output.status.signal()) {
        (Some(0), _) => {
            serde_json::from_slice(&output.stdout).map_or_else(|e| Ended::Broken(e.to_string()), Ended::Answered)
        }
        (Some(2), _) if !said.trim().is_empty() => Ended::Refused,
        (_, Some(signal)) if TOO_LONG.contains(&signal) => {
            Ended::Broken(format!("more than {SECONDS} s of processor time"))
        }
        _ => Ended::Broken(said.lines().take(2).collect::<Vec<_>>().join(" ")),
    }
}

/// Options as they are typed.
fn words(options: &[(&str, String)]) -> String {
    options.iter().map(|(name, value)| format!("{name} {value}")).collect::<Vec<_>>().join(" ")
}

/// What was seen on some blades.
#[derive(Default)]
struct Seen {
    answered: usize,
    refused: usize,
    bounds: Verdict,
    broken: Vec<String>,
}

impl Seen {
    fn of(&mut self, number: u64, folder: &Path) {
        let hostile = case(number);
        let file = folder.join(format!("hostile-{number}.json"));
        fs::write(&file, to_json(&hostile.blade.definition())).unwrap();
        let before = self.broken.len();
        for basis in ["piecewise", "classical"] {
            let all = |more: &[(&'static str, String)]| -> Vec<(&str, String)> {
                let mut all = vec![("basis", basis.to_string()), ("modes", hostile.modes.to_string())];
                if basis == "classical" {
                    all.push(("functions", 15.max(hostile.modes).to_string()));
                }
                all.extend_from_slice(more);
                all
            };
            let speed = [("speed", hostile.speed.to_string())];
            let speeds = [("speeds", format!("0:{}:101", hostile.fastest))];
            for (question, options) in [("modes", all(&speed)), ("shapes", all(&speed)), ("fan", all(&speeds))] {
                let wrong = match ask(question, &file, &options) {
                    Ended::Answered(answer) => {
                        self.answered += 1;
                        if question == "modes" { self.judge(&hostile, &answer) } else { Vec::new() }
                    }
                    Ended::Refused => {
                        self.refused += 1;
                        Vec::new()
                    }
                    Ended::Broken(how) => vec![how],
                };
                let place = format!(
                    "number {number}, {}: answer {question} {} {}",
                    hostile.kind,
                    file.display(),
                    words(&options)
                );
                self.broken.extend(wrong.into_iter().map(|what| format!("{place}: {what}")));
            }
        }
        // What broke something stays, to be tried on the command line.
        if self.broken.len() == before {
            fs::remove_file(&file).unwrap();
        }
    }

    /// Counts and bounds of the modes of every degree of freedom.
    fn judge(&mut self, hostile: &Hostile, answer: &Value) -> Vec<String> {
        let warned =
            |dof: Dof| answer["warnings"].as_array().unwrap().iter().any(|warning| warning["path"] == dof.name());
        let mut wrong = Vec::new();
        for dof in Dof::ALL {
            let modes = answer["modes"].as_array().unwrap().iter().filter(|mode| mode["dof"] == dof.name());
            let modes: Vec<&Value> = modes.collect();
            if modes.len() != hostile.modes && !warned(dof) {
                wrong.push(format!("{dof}: {} of {} modes without a warning", modes.len(), hostile.modes));
            }
            let number = |mode: &Value, key: &str| mode[key].as_f64();
            let bounds: Vec<_> =
                modes.iter().map(|mode| Some((number(mode, "lower_rad_s")?, number(mode, "upper_rad_s")?))).collect();
            wrong.extend(
                modes
                    .iter()
                    .filter(|mode| number(mode, "frequency_rad_s").is_none())
                    .map(|mode| format!("{}: no frequency", mode["label"])),
            );
            let separation = modes.first().and_then(|mode| number(mode, "separation_rad_s"));
            let mut verdict = verdict::of(&hostile.blade, dof, hostile.speed, &bounds, separation);
            wrong.append(&mut verdict.wrong);
            self.bounds.add(verdict);
        }
        wrong
    }
}

/// One of several parts of all blades, so that they run side by side.
fn part(part: u64, parts: u64) {
    let asked = |name: &str, or: u64| env::var(name).map_or(or, |text| text.parse().unwrap());
    let (from, count) = (asked("BLADEFAN_HOSTILE_FROM", 0), asked("BLADEFAN_HOSTILE", 100));
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let mut seen = Seen::default();
    for number in (from..from + count).filter(|number| number % parts == part) {
        seen.of(number, &folder);
    }
    let Seen { answered, refused, bounds, broken } = seen;
    println!(
        "{answered} answers, {refused} refusals; {} intervals checked, {} undecided, {} modes without",
        bounds.checked, bounds.undecided, bounds.without
    );
    assert!(broken.is_empty(), "{} broken; files in {}:\n{}", broken.len(), folder.display(), broken.join("\n"));
    // Seen: a sixth where mass and stiffness vary by many decades, to which the independent solution is no
    // more equal than the solver is.
    assert!(4 * bounds.undecided <= bounds.checked, "{} of {} undecided", bounds.undecided, bounds.checked);
    assert!(4 * refused <= answered, "{refused} refused, {answered} answered");
}

macro_rules! parts {
    ($($name:ident: $part:literal;)+) => {$(
        #[test]
        fn $name() {
            part($part, 4);
        }
    )+};
}

parts! {
    hostile_blades_first_part: 0;
    hostile_blades_second_part: 1;
    hostile_blades_third_part: 2;
    hostile_blades_fourth_part: 3;
}
