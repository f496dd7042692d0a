//! Modes at one speed: frequencies, mode shapes.

mod shapes;
mod solve;

pub use shapes::{Component, Shape, orthogonality, shapes};
pub use solve::{Mode, SolveError, eigenvalues, solve};
