//! The solver's parts for this project's benches. Nothing here is stable.

pub use crate::converged::{Converged, Wanted, Work};
pub use crate::lagrange::{Energies, Fields, Grid, SystemMatrices, assemble, classical_functions};
pub use crate::modes::solve;
pub use crate::numerics::eigen::{ascending_values, lowest_of_plain};
pub use crate::numerics::quadrature::GaussRules;
