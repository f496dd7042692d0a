//! The paper's model: flap, lag and torsion are systems of their own (Eq. 42–47, 75–77).

use super::terms::{Energy, Quantity, System, Term};
use crate::dof::Dof;
use Energy::{Centrifugal, Elastic, Inertia};
use Quantity::{Displacement, Rotation, Strain};

const FLAP: &[Term] = &[
    Term::diagonal(Elastic, Dof::Flap, Strain, |s| s.stiffness[0]), // Eq. 43
    Term::diagonal(Centrifugal, Dof::Flap, Rotation, |s| s.tension), // Eq. 75
    Term::diagonal(Inertia, Dof::Flap, Displacement, |s| s.mass),   // Eq. 42
];

const LAG: &[Term] = &[
    Term::diagonal(Elastic, Dof::Lag, Strain, |s| s.stiffness[1]), // Eq. 43
    Term::diagonal(Centrifugal, Dof::Lag, Rotation, |s| s.tension), // Eq. 76, first part
    Term::diagonal(Centrifugal, Dof::Lag, Displacement, |s| -s.mass), // Eq. 76, second part
    Term::diagonal(Inertia, Dof::Lag, Displacement, |s| s.mass),   // Eq. 42
];

const TORSION: &[Term] = &[
    Term::diagonal(Elastic, Dof::Torsion, Strain, |s| s.stiffness[2]), // Eq. 46
    Term::diagonal(Centrifugal, Dof::Torsion, Rotation, |s| s.mass * s.mass_offset * s.mass_offset), // Eq. 77
    Term::diagonal(Inertia, Dof::Torsion, Displacement, |s| s.polar_inertia), // Eq. 45
];

/// The systems of the uncoupled model, in the order of [`Dof::ALL`].
pub const SYSTEMS: [System; 3] = [
    System { dofs: &[Dof::Flap], terms: FLAP },
    System { dofs: &[Dof::Lag], terms: LAG },
    System { dofs: &[Dof::Torsion], terms: TORSION },
];

/// The system of one degree of freedom.
pub const fn system(dof: Dof) -> System {
    SYSTEMS[dof.index()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blade::Section;
    use crate::lagrange::terms::Field;

    /// Numbers that no two weights share.
    const SECTION: Section = Section {
        r: 3.0,
        mass: 2.0,
        stiffness: [5.0, 7.0, 11.0],
        polar_inertia: 13.0,
        mass_offset: 0.5,
        tension: 17.0,
    };

    #[test]
    fn weights_are_those_of_the_paper() {
        let weight = |dof, energy, quantity| system(dof).weight(energy, Field { dof, quantity })(&SECTION);
        for (dof, elastic, centrifugal, inertia) in
            [(Dof::Flap, 5.0, 17.0, 2.0), (Dof::Lag, 7.0, 17.0, 2.0), (Dof::Torsion, 11.0, 2.0 * 0.25, 13.0)]
        {
            assert_eq!(weight(dof, Elastic, Strain), elastic, "{dof}");
            assert_eq!(weight(dof, Centrifugal, Rotation), centrifugal, "{dof}");
            assert_eq!(weight(dof, Inertia, Displacement), inertia, "{dof}");
        }
        assert_eq!(weight(Dof::Flap, Elastic, Rotation), 0.0, "no such term");
    }

    /// The one term on displacements takes the whole inertia, which is what the shift relies on.
    #[test]
    fn lag_alone_is_shifted_and_by_its_own_inertia() {
        assert_eq!(SYSTEMS.map(|system| system.shift(9.0)), [0.0, 9.0, 0.0]);
        let field = Field { dof: Dof::Lag, quantity: Displacement };
        let system = system(Dof::Lag);
        assert_eq!(system.weight(Centrifugal, field)(&SECTION), -system.weight(Inertia, field)(&SECTION));
    }

    #[test]
    fn every_degree_of_freedom_is_a_system_of_its_own() {
        for (dof, system) in Dof::ALL.into_iter().zip(SYSTEMS) {
            assert_eq!(system.dofs, [dof]);
            assert!(system.terms.iter().all(|term| term.row.dof == dof && term.column.dof == dof), "{dof}");
        }
    }
}
