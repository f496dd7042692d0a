//! Energies by Lagrange's equation: the one place where a blade and its assumed functions meet.

mod assembly;
mod bounds;
mod equilibrium;
mod gap;
mod grid;
mod panels;

pub use assembly::{Energies, SystemMatrices, assemble, classical_functions, torsion_norm};
pub use bounds::{Bounds, Interval, bounds};
pub use equilibrium::{ShapeTables, tabulate};
pub use gap::{FromTip, MomentGaps, moment_gaps};
pub(crate) use grid::dot;
pub use grid::{Cell, Fields, Grid};
pub(crate) use panels::segments;
