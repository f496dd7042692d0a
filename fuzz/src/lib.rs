//! What the fuzz targets share: what must hold of a blade file, and a blade file made of bytes.

mod blade;

pub use blade::{Question, question};

use bladefan_core::formats::{Format, read, to_json, to_toml};

/// Reads a text as a blade file; what it reads must be written and read back the same.
pub fn read_back(text: &str, format: Format) {
    match read(text, format) {
        Ok(file) => {
            for (format, text) in [(Format::Toml, to_toml(&file.definition)), (Format::Json, to_json(&file.definition))] {
                let again = read(&text, format).unwrap_or_else(|faults| panic!("{faults:?} in {text}"));
                assert_eq!(again.definition, file.definition, "{text}");
            }
        }
        Err(faults) => {
            assert!(!faults.is_empty(), "refused without a reason");
            for fault in faults {
                assert!(!fault.message.is_empty(), "{fault:?}");
                let lines = u32::try_from(text.lines().count().max(1)).unwrap_or(u32::MAX);
                assert!(fault.line.is_none_or(|line| (1..=lines + 1).contains(&line)), "{fault:?}");
            }
        }
    }
}
