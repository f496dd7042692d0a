//! Bad blade files and the faults that each must give: `faults/cases.json`. The same cases run
//! through the core, the command line and the wasm package.

use bladefan_core::FaultCode;
use serde::Deserialize;

/// A sound file that the cases spoil.
pub const BASE_TOML: &str = include_str!("../faults/base.toml");
/// The same in JSON.
pub const BASE_JSON: &str = include_str!("../faults/base.json");

/// A bad file.
#[derive(Clone, Debug, Deserialize)]
pub struct Case {
    /// What is wrong with it.
    pub name: String,
    /// `toml` or `json`.
    pub format: String,
    /// The whole text, where it is not made from a base file.
    pub text: Option<String>,
    /// What is replaced in the base file, once each, in turn.
    #[serde(default)]
    pub replace: Vec<(String, String)>,
    /// The faults, in their order.
    #[serde(default)]
    pub faults: Vec<Expected>,
}

/// A fault that a bad file must give.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
pub struct Expected {
    /// Stable name of its kind.
    pub code: FaultCode,
    /// Path in the file.
    pub path: String,
    /// Line, from 1.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
    /// What a person reads.
    pub message: String,
}

impl Case {
    /// The text of the bad file.
    ///
    /// # Panics
    /// Where a text to replace is not in the base file.
    pub fn text(&self) -> String {
        let base = if self.format == "json" { BASE_JSON } else { BASE_TOML };
        let mut text = self.text.clone().unwrap_or_else(|| base.to_owned());
        for (from, to) in &self.replace {
            assert!(text.contains(from.as_str()), "{}: {from:?} is not in the file", self.name);
            text = text.replacen(from.as_str(), to, 1);
        }
        text
    }
}

/// Every case.
///
/// # Panics
/// Where `faults/cases.json` is not what it should be.
#[expect(clippy::expect_used, reason = "a test file of our own")]
pub fn cases() -> Vec<Case> {
    serde_json::from_str(include_str!("../faults/cases.json")).expect("faults/cases.json")
}
