//! The three degrees of freedom of a blade section.

/// A degree of freedom; the three are solved separately (uncoupled).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum Dof {
    /// Bending out of the disc plane.
    Flap,
    /// Bending in the disc plane.
    Lag,
    /// Twisting about the elastic axis.
    Torsion,
}

impl Dof {
    /// All three, in the order of every result.
    pub const ALL: [Self; 3] = [Self::Flap, Self::Lag, Self::Torsion];

    /// The name used in files, options and results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Flap => "flap",
            Self::Lag => "lag",
            Self::Torsion => "torsion",
        }
    }

    /// The letter of a mode label: F, L or T.
    pub const fn letter(self) -> char {
        match self {
            Self::Flap => 'F',
            Self::Lag => 'L',
            Self::Torsion => 'T',
        }
    }

    /// The degree of freedom of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|dof| dof.name() == name)
    }

    /// 0 for flap, 1 for lag, 2 for torsion.
    pub const fn index(self) -> usize {
        self as usize
    }
}

impl core::fmt::Display for Dof {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.name())
    }
}
