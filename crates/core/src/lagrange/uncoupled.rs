//! The paper's model: flap, lag and torsion are systems of their own (Eq. 42–47, 75–77); torsion with its propeller
//! moment or the full one.

use super::terms::{Energy, Quantity, System, Term};
use crate::blade::{Blade, Racket};
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

/// With the full propeller moment.
const TORSION_FLAT: &[Term] = &[
    Term::diagonal(Elastic, Dof::Torsion, Strain, |s| s.stiffness[2]),
    Term::diagonal(Centrifugal, Dof::Torsion, Rotation, |s| s.racket),
    Term::diagonal(Inertia, Dof::Torsion, Displacement, |s| s.polar_inertia),
];

/// The same where it is negative somewhere: 2 I₂ less the inertia, in two terms as in lag, so that no weight on the
/// rotation is negative.
const TORSION_STEEP: &[Term] = &[
    Term::diagonal(Elastic, Dof::Torsion, Strain, |s| s.stiffness[2]),
    Term::diagonal(Centrifugal, Dof::Torsion, Rotation, |s| (s.racket + s.polar_inertia).max(0.0)),
    Term::diagonal(Centrifugal, Dof::Torsion, Displacement, |s| -s.polar_inertia),
    Term::diagonal(Inertia, Dof::Torsion, Displacement, |s| s.polar_inertia),
];

/// The system of one degree of freedom of a blade.
pub fn system(blade: &Blade, dof: Dof) -> System {
    match (dof, blade.racket()) {
        (Dof::Flap, _) => System { dofs: &[Dof::Flap], terms: FLAP },
        (Dof::Lag, _) => System { dofs: &[Dof::Lag], terms: LAG },
        (Dof::Torsion, Racket::Paper) => System { dofs: &[Dof::Torsion], terms: TORSION },
        (Dof::Torsion, Racket::Flat) => System { dofs: &[Dof::Torsion], terms: TORSION_FLAT },
        (Dof::Torsion, Racket::Steep) => System { dofs: &[Dof::Torsion], terms: TORSION_STEEP },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blade::Section;
    use crate::lagrange::terms::Field;
    use crate::lagrange::tests::tapered;

    /// Numbers that no two weights share.
    const SECTION: Section = Section {
        r: 3.0,
        mass: 2.0,
        stiffness: [5.0, 7.0, 11.0],
        polar_inertia: 13.0,
        racket: -9.0,
        mass_offset: 0.5,
        tension: 17.0,
    };

    #[test]
    fn weights_are_those_of_the_paper() {
        let blade = tapered();
        let weight = |dof, energy, quantity| system(&blade, dof).weight(energy, Field { dof, quantity })(&SECTION);
        for (dof, elastic, centrifugal, inertia) in
            [(Dof::Flap, 5.0, 17.0, 2.0), (Dof::Lag, 7.0, 17.0, 2.0), (Dof::Torsion, 11.0, 2.0 * 0.25, 13.0)]
        {
            assert_eq!(weight(dof, Elastic, Strain), elastic, "{dof}");
            assert_eq!(weight(dof, Centrifugal, Rotation), centrifugal, "{dof}");
            assert_eq!(weight(dof, Inertia, Displacement), inertia, "{dof}");
        }
        assert_eq!(weight(Dof::Flap, Elastic, Rotation), 0.0, "no such term");
    }

    #[test]
    fn the_full_moment_is_that_of_the_section_however_it_is_split() {
        for (terms, shift) in [(TORSION_FLAT, 0.0), (TORSION_STEEP, 4.0)] {
            let system = System { dofs: &[Dof::Torsion], terms };
            let weights = system.of(Centrifugal).map(|term| (term.weight)(&SECTION));
            assert_eq!((weights.sum::<f64>(), system.shift(4.0)), (SECTION.racket, shift));
        }
        assert_eq!(system(&tapered().with_full_propeller_moment().unwrap(), Dof::Torsion).shift(1.0), 0.0, "thin");
    }

    /// The one term on displacements takes the whole inertia, which is what the shift relies on.
    #[test]
    fn lag_alone_is_shifted_and_by_its_own_inertia() {
        let blade = tapered();
        assert_eq!(Dof::ALL.map(|dof| system(&blade, dof).shift(9.0)), [0.0, 9.0, 0.0]);
        let shifted = [system(&blade, Dof::Lag), System { dofs: &[Dof::Torsion], terms: TORSION_STEEP }];
        for system in shifted {
            let field = Field { dof: system.dofs[0], quantity: Displacement };
            assert_eq!(system.weight(Centrifugal, field)(&SECTION), -system.weight(Inertia, field)(&SECTION));
        }
    }

    #[test]
    fn every_degree_of_freedom_is_a_system_of_its_own() {
        for dof in Dof::ALL {
            let system = system(&tapered(), dof);
            assert_eq!(system.dofs, [dof]);
            assert!(system.terms.iter().all(|term| term.row.dof == dof && term.column.dof == dof), "{dof}");
        }
    }
}
