//! The families of assumed functions.

/// The family of assumed functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum BasisFamily {
    /// Piecewise polynomials between the stations, as many as it takes: the converged answer.
    Piecewise,
    /// Modes of the uniform, non-rotating blade: the paper's.
    Classical,
}

impl BasisFamily {
    /// The name used in options and results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Piecewise => "piecewise",
            Self::Classical => "classical",
        }
    }
}
