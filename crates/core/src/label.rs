//! What a mode is called.

use crate::dof::Dof;
use alloc::string::{String, ToString};
use core::fmt;
use core::str::FromStr;

/// The name of a mode and of its branch: `1F`, `2F`, `1L`, `1T`, …; `3F/T` where a coupled mode is mixed.
///
/// Labels are ordered as results are: by degree of freedom, then by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Label {
    /// Degree of freedom.
    pub dof: Dof,
    /// Number within the degree of freedom, from 1, by ascending frequency.
    pub number: usize,
    /// The second motion of a mixed mode, in which none has three fifths of the energy.
    pub second: Option<Dof>,
}

impl Label {
    /// The label of a mode by its number, from 1.
    pub const fn new(dof: Dof, number: usize) -> Self {
        Self { dof, number, second: None }
    }

    /// The same of a mixed mode.
    pub const fn mixed(dof: Dof, number: usize, second: Dof) -> Self {
        Self { dof, number, second: Some(second) }
    }
}

impl fmt::Display for Label {
    /// Padded as text is, so that `{label:>4}` lines up.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let second = self.second.map_or_else(String::new, |second| alloc::format!("/{}", second.letter()));
        f.pad(&alloc::format!("{}{}{second}", self.number, self.dof.letter()))
    }
}

/// A text that is no label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotALabel;

impl NotALabel {
    /// What a label must be.
    pub const RULE: &'static str = "must be a number and F, L or T, like 1F";
}

impl fmt::Display for NotALabel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a label {}", Self::RULE)
    }
}

impl core::error::Error for NotALabel {}

impl FromStr for Label {
    type Err = NotALabel;

    /// A number from 1 to 65535 without a sign or leading zeros, then the letter of a degree of freedom; then,
    /// where the mode is mixed, / and the letter of another.
    fn from_str(text: &str) -> Result<Self, NotALabel> {
        if let Some((first, second)) = text.split_once('/') {
            let label: Self = first.parse()?;
            let second = Dof::ALL.into_iter().find(|dof| second == dof.letter().to_string()).ok_or(NotALabel)?;
            return if second == label.dof { Err(NotALabel) } else { Ok(Self { second: Some(second), ..label }) };
        }
        let parts = Dof::ALL.into_iter().find_map(|dof| Some((dof, text.strip_suffix(dof.letter())?)));
        let (dof, digits) = parts.ok_or(NotALabel)?;
        if digits.starts_with(['0', '+']) {
            return Err(NotALabel);
        }
        let number = digits.parse::<u16>().map_err(|_| NotALabel)?;
        Ok(Self::new(dof, number.into()))
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Label {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Label {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        text.parse().map_err(serde::de::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::format;
    use alloc::string::ToString;

    #[test]
    fn labels_read_back_as_they_are_written() {
        for (dof, number, text) in [(Dof::Flap, 1, "1F"), (Dof::Lag, 12, "12L"), (Dof::Torsion, 65535, "65535T")] {
            let label = Label::new(dof, number);
            assert_eq!(label.to_string(), text);
            assert_eq!(text.parse(), Ok(label));
        }
        let mixed = Label::mixed(Dof::Flap, 3, Dof::Torsion);
        assert_eq!((mixed.to_string().as_str(), "3F/T".parse()), ("3F/T", Ok(mixed)));
        assert_eq!(format!("{:>4}|", Label::new(Dof::Lag, 2)), "  2L|");
    }

    #[test]
    fn other_texts_are_no_labels() {
        for text in [
            "", "F", "1", "F1", "0L", "01L", "+1F", "-1F", "1f", "1 F", "65536T", "1.0F", "1FF", "1F/F", "1F/", "/F",
            "1F/T/L",
        ] {
            assert_eq!(text.parse::<Label>(), Err(NotALabel), "{text}");
        }
    }

    #[test]
    fn labels_stand_in_the_order_of_results() {
        let texts = ["1F", "2F", "10F", "1L", "1T"];
        assert!(texts.map(|text| text.parse::<Label>().unwrap()).is_sorted());
    }
}
