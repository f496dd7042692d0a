//! What is wrong with an input, and what is worth knowing about one.

use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;
use core::ops::Deref;

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

/// Everything that is wrong with an input: at least one fault where a call failed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(transparent))]
pub struct Faults(Vec<Fault>);

impl Faults {
    /// `Ok` where there is no fault.
    ///
    /// # Errors
    /// The faults.
    pub fn none(self) -> Result<(), Self> {
        if self.0.is_empty() { Ok(()) } else { Err(self) }
    }

    /// Both results, or the faults of both.
    ///
    /// # Errors
    /// The faults of the first, then those of the second.
    pub fn both<A, B>(a: Result<A, Self>, b: Result<B, Self>) -> Result<(A, B), Self> {
        match (a, b) {
            (Ok(a), Ok(b)) => Ok((a, b)),
            (a, b) => Err(a.err().into_iter().chain(b.err()).flatten().collect()),
        }
    }
}

impl fmt::Display for Faults {
    /// One fault per line.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, fault) in self.0.iter().enumerate() {
            if i > 0 {
                f.write_str("\n")?;
            }
            write!(f, "{fault}")?;
        }
        Ok(())
    }
}

impl core::error::Error for Faults {}

impl Deref for Faults {
    type Target = [Fault];

    fn deref(&self) -> &[Fault] {
        &self.0
    }
}

impl From<Fault> for Faults {
    fn from(fault: Fault) -> Self {
        Self(vec![fault])
    }
}

impl From<Vec<Fault>> for Faults {
    fn from(faults: Vec<Fault>) -> Self {
        Self(faults)
    }
}

impl From<Faults> for Vec<Fault> {
    fn from(faults: Faults) -> Self {
        faults.0
    }
}

impl FromIterator<Fault> for Faults {
    fn from_iter<I: IntoIterator<Item = Fault>>(faults: I) -> Self {
        Self(faults.into_iter().collect())
    }
}

impl IntoIterator for Faults {
    type Item = Fault;
    type IntoIter = vec::IntoIter<Fault>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'a> IntoIterator for &'a Faults {
    type Item = &'a Fault;
    type IntoIter = core::slice::Iter<'a, Fault>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::ToString;

    fn fault(path: &str) -> Fault {
        Fault::new(FaultCode::Missing, path, None, "must be given", "it must be given")
    }

    #[test]
    fn faults_are_an_error_of_one_line_each() {
        let faults = Faults::from(vec![fault("a"), Fault { line: Some(2), column: Some(3), ..fault("b") }]);
        assert_eq!(faults.to_string(), "a: it must be given\n2:3: b: it must be given");
        let error: alloc::boxed::Box<dyn core::error::Error> = faults.clone().into();
        assert_eq!(error.to_string(), faults.to_string());
        assert_eq!((faults.len(), faults[0].path.as_str()), (2, "a"));
    }

    #[test]
    fn faults_of_two_things_are_told_at_once() {
        let (a, b): (Result<(), Faults>, Result<(), Faults>) = (Err(fault("a").into()), Err(fault("b").into()));
        assert_eq!(Faults::both(Ok(1), Ok(2)), Ok((1, 2)));
        assert_eq!(Faults::both(a.clone(), Ok(2)), Err(fault("a").into()));
        assert_eq!(Faults::both(a, b).unwrap_err().into_iter().map(|fault| fault.path).collect::<Vec<_>>(), ["a", "b"]);
    }

    #[test]
    fn no_fault_is_no_failure() {
        assert_eq!(Faults::default().none(), Ok(()));
        assert!(Faults::from(fault("a")).none().is_err());
    }
}
