//! Any text as a blade file in TOML.
#![no_main]

use bladefan_core::formats::Format;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| bladefan_fuzz::read_back(text, Format::Toml));
