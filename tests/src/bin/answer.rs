//! One question to the library, in a process of its own, so that a test can bound its time and memory:
//! `answer modes|fan|shapes BLADE.json [OPTION VALUE]…`, options by their names on the command line. Prints
//! JSON; exit code 2 and the faults where the library refuses.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program speaks")]

use bladefan_core::Fault;
use bladefan_core::formats::{Format, read};
use bladefan_core::{ModelKind, Settings};
use std::process::ExitCode;
use std::{env, fs};

fn answer(arguments: &[String]) -> Result<String, Vec<Fault>> {
    let [question, file, options @ ..] = arguments else { return Err(Vec::new()) };
    let text = fs::read_to_string(file).unwrap_or_default();
    let blade = read(&text, Format::Json)?.blade;
    let mut settings = Settings::of(ModelKind::Uncoupled);
    for pair in options.chunks(2) {
        if let [name, value] = pair {
            settings.set(name, value).map_err(|fault| vec![fault])?;
        }
    }
    let json = match question.as_str() {
        "modes" => serde_json::to_string(&bladefan_core::modes(&blade, &settings)?),
        "fan" => serde_json::to_string(&bladefan_core::fan(&blade, &settings)?),
        "shapes" => serde_json::to_string(&bladefan_core::shapes(&blade, &settings)?),
        _ => return Err(Vec::new()),
    };
    Ok(json.unwrap_or_default())
}

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    match answer(&arguments) {
        Ok(json) => {
            println!("{json}");
            ExitCode::SUCCESS
        }
        Err(faults) => {
            for fault in faults {
                eprintln!("{fault}");
            }
            ExitCode::from(2)
        }
    }
}
