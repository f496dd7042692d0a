//! What is wrong with an input, and what is worth knowing about one.

use alloc::string::String;
use core::fmt;

/// The kind of a fault. Its name in results is stable; scripts may match on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum FaultCode {
    /// The text is not TOML or JSON.
    Syntax,
    /// The schema is missing or not known.
    Schema,
    /// A key that the format does not know.
    UnknownKey,
    /// A key that must be there is not.
    Missing,
    /// A value of another type than the rule asks for.
    WrongType,
    /// A word that is not one of the choices (a root, a quality).
    UnknownChoice,
    /// A unit that the format does not know.
    UnknownUnit,
    /// A number that is infinite or not a number.
    NotFinite,
    /// A number outside its range.
    OutOfRange,
    /// Two lists of different lengths, or one too short.
    Length,
    /// Radii out of order, thrice the same or too near.
    Radii,
    /// A property that does not reach from the root to the tip.
    Uncovered,
    /// Two keys that exclude each other, or one that does not belong here.
    Conflict,
    /// An option of a command that does not exist or cannot be read.
    Option,
    /// The equations have no answer for this blade.
    Unsolvable,
}

impl FaultCode {
    /// The stable name, as in JSON results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Syntax => "syntax",
            Self::Schema => "schema",
            Self::UnknownKey => "unknown-key",
            Self::Missing => "missing",
            Self::WrongType => "wrong-type",
            Self::UnknownChoice => "unknown-choice",
            Self::UnknownUnit => "unknown-unit",
            Self::NotFinite => "not-finite",
            Self::OutOfRange => "out-of-range",
            Self::Length => "length",
            Self::Radii => "radii",
            Self::Uncovered => "uncovered",
            Self::Conflict => "conflict",
            Self::Option => "option",
            Self::Unsolvable => "unsolvable",
        }
    }
}

/// One thing wrong with an input: where, what and which rule it breaks.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Fault {
    /// Kind of the fault.
    pub code: FaultCode,
    /// Where, as a path in the file (`distribution.mass[3]`) or the name of an option (`speed`);
    /// empty for the whole text.
    pub path: String,
    /// The value as given, in the units of the file; absent where there is none.
    pub value: Option<String>,
    /// The rule that the value breaks.
    pub rule: String,
    /// One line for a person, lower case, without the path.
    pub message: String,
    /// Line in the text, from 1.
    pub line: Option<u32>,
    /// Column in the text in characters, from 1.
    pub column: Option<u32>,
}

impl Fault {
    /// A fault without a place in a text.
    pub fn new(
        code: FaultCode,
        path: impl Into<String>,
        value: Option<String>,
        rule: impl Into<String>,
        message: impl Into<String>,
    ) -> Self {
        Self { code, path: path.into(), value, rule: rule.into(), message: message.into(), line: None, column: None }
    }
}

impl fmt::Display for Fault {
    /// `line:column: path: message`, without the parts that are not known.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let (Some(line), Some(column)) = (self.line, self.column) {
            write!(f, "{line}:{column}: ")?;
        }
        if !self.path.is_empty() {
            write!(f, "{}: ", self.path)?;
        }
        f.write_str(&self.message)
    }
}

impl core::error::Error for Fault {}

/// Something in a legal input that does not act as its author may expect.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Warning {
    /// Where, as a path in the blade file.
    pub path: String,
    /// One line for a person, lower case, without the path.
    pub message: String,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.path, self.message)
    }
}
