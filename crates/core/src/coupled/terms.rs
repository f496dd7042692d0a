//! The energies of coupled flap, lag and torsion as a table of terms (docs/THEORY.md; J. C. Houbolt &
//! G. W. Brooks, NACA Report 1346, 1958, in the energy form of the paper).
//!
//! M, C and K of the equation (K + F + Ω²C − ω²M) q = 0. A term between two fields stands once and acts
//! in both places of the symmetric matrix.

use super::blade::{CoupledSection, CoupledSection as Section};
use crate::dof::Dof;
use crate::lagrange::{Energy, Field, Quantity, Term};
use Energy::{Centrifugal, Elastic, Inertia};

const fn field(dof: Dof, quantity: Quantity) -> Field {
    Field { dof, quantity }
}

const W: Field = field(Dof::Flap, Quantity::Displacement);
const W1: Field = field(Dof::Flap, Quantity::Rotation);
const W2: Field = field(Dof::Flap, Quantity::Strain);
const V: Field = field(Dof::Lag, Quantity::Displacement);
const V1: Field = field(Dof::Lag, Quantity::Rotation);
const V2: Field = field(Dof::Lag, Quantity::Strain);
const PHI: Field = field(Dof::Torsion, Quantity::Displacement);
const PHI1: Field = field(Dof::Torsion, Quantity::Strain);

/// Number of fields: w, w′, w″, v, v′, v″, φ, φ′.
pub const FIELDS: usize = 8;

/// Place of a field among the [`FIELDS`]; in torsion rotation and displacement are one.
pub const fn place(field: Field) -> usize {
    match (field.dof, field.quantity) {
        (Dof::Flap, Quantity::Displacement) => 0,
        (Dof::Flap, Quantity::Rotation) => 1,
        (Dof::Flap, Quantity::Strain) => 2,
        (Dof::Lag, Quantity::Displacement) => 3,
        (Dof::Lag, Quantity::Rotation) => 4,
        (Dof::Lag, Quantity::Strain) => 5,
        (Dof::Torsion, Quantity::Displacement | Quantity::Rotation) => 6,
        (Dof::Torsion, Quantity::Strain) => 7,
    }
}

const fn term(energy: Energy, row: Field, column: Field, weight: fn(&Section) -> f64) -> Term<Section> {
    Term { energy, row, column, weight }
}

/// Every term, options included: what is off has weight 0 at every section.
pub const TERMS: &[Term<Section>] = &[
    term(Elastic, W2, W2, |p| p.stiffness[0] * p.angle.1 * p.angle.1 + p.stiffness[1] * p.angle.0 * p.angle.0),
    term(Elastic, W2, V2, |p| (p.stiffness[1] - p.stiffness[0]) * p.angle.0 * p.angle.1),
    term(Elastic, V2, V2, |p| p.stiffness[0] * p.angle.0 * p.angle.0 + p.stiffness[1] * p.angle.1 * p.angle.1),
    term(Elastic, PHI1, PHI1, |p| p.stiffness[2]),
    // Tension, and the in-plane parts of the centrifugal force.
    term(Centrifugal, W1, W1, |p| cone_squared(p) * (p.tension - p.rotary_inertia()[0])),
    term(Centrifugal, W, W, |p| -p.precone.0 * p.precone.0 * p.mass),
    term(Centrifugal, W1, W, |p| -cone_product(p) * p.moment() * p.angle.0),
    term(Centrifugal, W, V1, |p| -cone_product(p) * p.moment() * p.angle.1),
    term(Centrifugal, V1, V1, |p| cone_squared(p) * p.tension),
    term(Centrifugal, V, V, |p| -p.mass),
    // Offsets of mass and tension.
    term(Centrifugal, W1, PHI, |p| {
        cone_squared(p) * p.moment() * p.r * p.angle.1 - cone_product(p) * p.racket() * p.double_angle().0
    }),
    term(Centrifugal, W, PHI, |p| -p.precone.0 * p.precone.0 * p.moment() * p.angle.1),
    term(Centrifugal, W2, PHI, |p| -cone_squared(p) * p.tension * p.tension_offset * p.angle.1),
    term(Centrifugal, V1, PHI, |p| {
        -cone_squared(p) * p.moment() * p.r * p.angle.0 - cone_product(p) * p.racket() * p.double_angle().1
    }),
    term(Centrifugal, V, PHI, |p| p.moment() * p.angle.0),
    term(Centrifugal, V2, PHI, |p| cone_squared(p) * p.tension * p.tension_offset * p.angle.0),
    // Propeller moment, torque offset, precone; trapeze.
    term(Centrifugal, PHI, PHI, |p| {
        cone_squared(p) * p.propeller() * p.double_angle().1 + p.torque_offset * p.moment() * p.angle.1
            - cone_product(p) * p.r * p.moment() * p.angle.0
    }),
    term(Centrifugal, PHI1, PHI1, CoupledSection::trapeze_stiffness),
    term(Inertia, W, W, |p| p.mass),
    term(Inertia, V, V, |p| p.mass),
    term(Inertia, W, PHI, |p| p.moment() * p.angle.1),
    term(Inertia, V, PHI, |p| -p.moment() * p.angle.0),
    term(Inertia, PHI, PHI, |p| p.inertia[0] + p.inertia[1]),
    term(Inertia, W1, W1, |p| p.rotary_inertia()[0]),
    term(Inertia, V1, V1, |p| p.rotary_inertia()[1]),
    term(Inertia, W1, V1, |p| p.rotary_inertia()[2]),
];

/// cos² of the precone.
fn cone_squared(p: &Section) -> f64 {
    p.precone.1 * p.precone.1
}

/// sin times cos of the precone.
fn cone_product(p: &Section) -> f64 {
    p.precone.0 * p.precone.1
}

/// The weights of one matrix at one section, field by field.
pub type Weights = [[f64; FIELDS]; FIELDS];

/// The weights of K, C and M at a section.
#[derive(Clone, Copy, Debug, Default)]
pub struct SectionWeights {
    /// Of K.
    pub elastic: Weights,
    /// Of C.
    pub centrifugal: Weights,
    /// Of M.
    pub inertia: Weights,
}

impl SectionWeights {
    /// At a section.
    pub fn new(section: &Section) -> Self {
        let mut all = Self::default();
        for term in TERMS {
            let weights = match term.energy {
                Elastic => &mut all.elastic,
                Centrifugal => &mut all.centrifugal,
                Inertia => &mut all.inertia,
            };
            let (row, column) = (place(term.row), place(term.column));
            let weight = (term.weight)(section);
            weights[row][column] += weight;
            if row != column {
                weights[column][row] += weight;
            }
        }
        all
    }

    /// α K + s C + κ M.
    pub fn combined(&self, elastic: f64, centrifugal: f64, inertia: f64) -> Weights {
        let mut sum = Weights::default();
        for (row, out) in sum.iter_mut().enumerate() {
            for (column, out) in out.iter_mut().enumerate() {
                *out = elastic * self.elastic[row][column]
                    + centrifugal * self.centrifugal[row][column]
                    + inertia * self.inertia[row][column];
            }
        }
        sum
    }
}

impl SectionWeights {
    /// Of one matrix.
    pub fn of(&self, energy: Energy) -> &Weights {
        match energy {
            Elastic => &self.elastic,
            Centrifugal => &self.centrifugal,
            Inertia => &self.inertia,
        }
    }

    /// The sum of two.
    pub fn plus(&self, other: &Self) -> Self {
        let sum = |a: &Weights, b: &Weights| core::array::from_fn(|i| core::array::from_fn(|j| a[i][j] + b[i][j]));
        Self {
            elastic: sum(&self.elastic, &other.elastic),
            centrifugal: sum(&self.centrifugal, &other.centrifugal),
            inertia: sum(&self.inertia, &other.inertia),
        }
    }
}
