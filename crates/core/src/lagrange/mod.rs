//! Energies by Lagrange's equation: the one place where a blade and its assumed functions meet.

mod assembly;
mod equilibrium;
mod panels;

pub use assembly::{SystemMatrices, assemble, classical_functions, torsion_norm};
pub use equilibrium::{ShapeTables, tabulate};
