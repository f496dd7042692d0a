//! Modes at one speed: frequencies, mode shapes.

mod shapes;
mod solve;

pub use shapes::{Shape, ShapeScale, shapes};
pub use solve::{Mode, SolveError, solve};
