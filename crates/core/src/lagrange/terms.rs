//! The physics as a table of terms: which field times which, with which weight along the span.
//!
//! Every energy of a blade is a sum of terms ½ ∫ weight · row · column dr. A model is a list of
//! systems, and a system a list of degrees of freedom that feel one another with their terms; all
//! the rest (quadrature, assembly, piecewise functions, equilibrium, bounds) follows from the table.

use crate::blade::Section;
use crate::dof::Dof;

/// What of a degree of freedom's motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// w, v or φ.
    Displacement,
    /// w′, v′; in torsion φ itself: what the strain is the rate of.
    Rotation,
    /// w″, v″ or φ′.
    Strain,
}

/// One quantity of one degree of freedom along the span.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field {
    /// The degree of freedom.
    pub dof: Dof,
    /// What of its motion.
    pub quantity: Quantity,
}

/// Which matrix a term belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Energy {
    /// K: strain energy.
    Elastic,
    /// C: work of the centrifugal forces, per Ω².
    Centrifugal,
    /// M: kinetic energy.
    Inertia,
}

/// One term of the energy; its weight sees a section of type `S`.
#[derive(Clone, Copy, Debug)]
pub struct Term<S = Section> {
    /// The matrix it belongs to.
    pub energy: Energy,
    /// Field of the rows.
    pub row: Field,
    /// Field of the columns.
    pub column: Field,
    /// Its weight at a section; linear in stiffness and mass.
    pub weight: fn(&S) -> f64,
}

impl Term {
    /// A term of one field with itself.
    pub const fn diagonal(energy: Energy, dof: Dof, quantity: Quantity, weight: fn(&Section) -> f64) -> Self {
        let field = Field { dof, quantity };
        Self { energy, row: field, column: field, weight }
    }
}

/// Degrees of freedom that feel one another, with all terms between them.
#[derive(Clone, Copy, Debug)]
pub struct System {
    /// The degrees of freedom, in the order of the unknowns.
    pub dofs: &'static [Dof],
    /// The terms.
    pub terms: &'static [Term],
}

impl System {
    /// The terms of one matrix.
    pub fn of(&self, energy: Energy) -> impl Iterator<Item = &Term> {
        self.terms.iter().filter(move |term| term.energy == energy)
    }

    /// The weight of one matrix on the square of one field; 0 where there is no such term.
    pub fn weight(&self, energy: Energy, field: Field) -> fn(&Section) -> f64 {
        let on_field = |term: &&Term| term.row == field && term.column == field;
        self.of(energy).find(on_field).map_or(|_| 0.0, |term| term.weight)
    }

    /// What of Ω² C is −Ω² M: the share of `speed_squared` by which every eigenvalue of this system
    /// lies below that of the same system without its centrifugal terms on displacements. In lag the
    /// whole inertia moves in the plane of rotation, so it is all of Ω².
    pub fn shift(&self, speed_squared: f64) -> f64 {
        let in_plane =
            |term: &Term| term.row.quantity == Quantity::Displacement && term.column.quantity == Quantity::Displacement;
        if self.of(Energy::Centrifugal).any(in_plane) { speed_squared } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const W: Field = Field { dof: Dof::Flap, quantity: Quantity::Displacement };
    const T: Field = Field { dof: Dof::Flap, quantity: Quantity::Rotation };
    const TERMS: &[Term] = &[
        Term::diagonal(Energy::Elastic, Dof::Flap, Quantity::Displacement, |_| 3.0),
        Term { energy: Energy::Elastic, row: W, column: T, weight: |_| 7.0 },
        Term::diagonal(Energy::Inertia, Dof::Flap, Quantity::Displacement, |s| s.mass),
    ];
    const SECTION: Section = Section {
        r: 1.0,
        mass: 2.0,
        stiffness: [5.0; 3],
        polar_inertia: 1.0,
        racket: 1.0,
        mass_offset: 0.0,
        tension: 0.0,
    };

    #[test]
    fn a_weight_is_that_of_the_square_of_its_field() {
        let system = System { dofs: &[Dof::Flap], terms: TERMS };
        assert_eq!(system.of(Energy::Elastic).count(), 2);
        assert_eq!(system.weight(Energy::Elastic, W)(&SECTION), 3.0);
        assert_eq!(system.weight(Energy::Inertia, W)(&SECTION), 2.0);
        // The product of two fields is the square of neither.
        assert_eq!(system.weight(Energy::Elastic, T)(&SECTION), 0.0);
    }

    /// A centrifugal term shifts where both of its fields are displacements, and only there.
    #[test]
    fn only_a_centrifugal_term_on_displacements_shifts() {
        const ROTATIONS: &[Term] = &[Term::diagonal(Energy::Centrifugal, Dof::Flap, Quantity::Rotation, |s| s.mass)];
        const MIXED: &[Term] = &[Term { energy: Energy::Centrifugal, row: W, column: T, weight: |s| s.mass }];
        const IN_PLANE: &[Term] =
            &[Term::diagonal(Energy::Centrifugal, Dof::Flap, Quantity::Displacement, |s| -s.mass)];
        let shift = |terms| System { dofs: &[Dof::Flap], terms }.shift(4.0);
        assert_eq!([TERMS, ROTATIONS, MIXED, IN_PLANE].map(shift), [0.0, 0.0, 0.0, 4.0]);
    }
}
