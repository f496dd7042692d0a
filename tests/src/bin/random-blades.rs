//! Writes random legal blades to a folder, the same ones in every run:
//! `random-blades FOLDER [--count N] [--seed N] [--hard N]`. `--hard` adds the first N hostile ones.
#![allow(clippy::print_stderr, reason = "a program speaks")]

use bladefan_core::formats::{to_json, to_toml};
use bladefan_tests::{hostile, random};
use std::path::PathBuf;
use std::process::ExitCode;
use std::{env, fs};

const USAGE: &str = "random-blades FOLDER [--count N] [--seed N] [--hard N]";

/// What was asked for.
struct Order {
    folder: PathBuf,
    count: usize,
    seed: u64,
    hard: u64,
}

fn order() -> Option<Order> {
    let mut order = Order { folder: PathBuf::new(), count: 200, seed: 4021, hard: 0 };
    let mut arguments = env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--count" => order.count = arguments.next()?.parse().ok()?,
            "--hard" => order.hard = arguments.next()?.parse().ok()?,
            "--seed" => order.seed = arguments.next()?.parse().ok()?,
            folder if !folder.starts_with('-') && order.folder.as_os_str().is_empty() => order.folder = folder.into(),
            _ => return None,
        }
    }
    (!order.folder.as_os_str().is_empty()).then_some(order)
}

fn write(order: &Order) -> std::io::Result<()> {
    fs::create_dir_all(&order.folder)?;
    for (i, blade) in random::draw(&random::blade(), order.count, order.seed).iter().enumerate() {
        let mut definition = blade.definition();
        definition.name = Some(format!("random {i}"));
        // Both formats in turn.
        let (text, ending) = if i % 2 == 0 { (to_toml(&definition), "toml") } else { (to_json(&definition), "json") };
        fs::write(order.folder.join(format!("random-{i:04}.{ending}")), text)?;
    }
    for number in 0..order.hard {
        let case = hostile::case(number);
        let mut definition = case.blade.definition();
        definition.name = Some(format!("hostile {number}: {}", case.kind));
        fs::write(order.folder.join(format!("hostile-{number:04}.json")), to_json(&definition))?;
    }
    Ok(())
}

fn main() -> ExitCode {
    let Some(order) = order() else {
        eprintln!("usage: {USAGE}");
        return ExitCode::from(2);
    };
    match write(&order) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("random-blades: {}: {error}", order.folder.display());
            ExitCode::FAILURE
        }
    }
}
