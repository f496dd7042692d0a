//! Energies by Lagrange's equation: the one place where a blade and its assumed functions meet.

mod assembly;
mod bounds;
mod classical;
mod equilibrium;
mod fields;
mod grid;
mod residual;
mod segments;
mod terms;
mod uncoupled;

pub use assembly::{Energies, SystemMatrices, assemble};
pub use bounds::{Bounds, Reference, bounds};
pub use classical::{classical_functions, torsion_norm};
pub use equilibrium::{FromTip, ShapeTables, tabulate};
pub use fields::Fields;
pub use grid::{Grid, Panel};
pub use residual::residual_moments;
pub(crate) use segments::{segments, taper_cuts};
pub use terms::{Energy, Field, Quantity, Term};
pub use uncoupled::system;

#[cfg(test)]
pub(crate) mod tests;
