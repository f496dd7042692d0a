//! How the displacement of a degree of freedom follows from its strain.

use crate::dof::Dof;

/// What the deformation is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Deformation {
    /// Strain w″, rotation w′, displacement w.
    Bending,
    /// Strain φ′, rotation and displacement φ.
    Torsion,
}

impl Deformation {
    /// That of a degree of freedom.
    pub const fn of(dof: Dof) -> Self {
        match dof {
            Dof::Flap | Dof::Lag => Self::Bending,
            Dof::Torsion => Self::Torsion,
        }
    }
}
