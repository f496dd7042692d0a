//! The built-in blades: complete files, as a user would write them.

/// A built-in blade.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The name it is called by.
    pub name: &'static str,
    /// The whole blade file, in TOML.
    pub toml: &'static str,
}

/// Every built-in blade, the paper's published rotors first.
pub const ENTRIES: &[Entry] = &[
    Entry { name: "tm4760", toml: include_str!("blades/tm4760.toml") },
    Entry { name: "sa330", toml: include_str!("blades/sa330.toml") },
    Entry { name: "uh60a", toml: include_str!("blades/uh60a.toml") },
    Entry { name: "bo105", toml: include_str!("blades/bo105.toml") },
    Entry { name: "hingeless-1000", toml: include_str!("blades/hingeless-1000.toml") },
    Entry { name: "uniform", toml: include_str!("blades/uniform.toml") },
    Entry { name: "twisted", toml: include_str!("blades/twisted.toml") },
];

/// The built-in blade of this name.
pub fn find(name: &str) -> Option<&'static Entry> {
    ENTRIES.iter().find(|entry| entry.name == name)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop")]
mod tests {
    use super::*;
    use crate::formats::{Format, read};

    #[test]
    fn every_blade_reads_without_a_fault_and_says_where_it_is_from() {
        for entry in ENTRIES {
            let file = read(entry.toml, Format::Toml).unwrap_or_else(|faults| panic!("{}: {faults:#?}", entry.name));
            let source = file.definition.source.unwrap();
            assert!(source.citation.is_some() && source.quality.is_some(), "{}", entry.name);
            assert_eq!(find(entry.name), Some(entry));
        }
        assert_eq!(find("none"), None);
    }
}
