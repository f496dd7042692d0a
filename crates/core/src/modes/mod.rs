//! Modes at one speed: frequencies, mode shapes.

mod nodes;
mod shapes;
mod solve;

pub use nodes::nodes;
pub use shapes::{orthogonality, shapes};
pub use solve::{Mode, SolveError, coordinates, eigenvalues, solve};
