//! Modes at one speed: frequencies, mode shapes.

mod nodes;
mod shapes;
mod solve;

pub use nodes::nodes;
pub use shapes::{orthogonality, shapes};
pub use solve::{Eigenvalues, Mode, SolveError, VALUES_PER_CUBE, coordinates, eigenvalues, solve};
