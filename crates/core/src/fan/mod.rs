//! Frequencies over a range of rotor speeds: curves, and where they cross the nP rays.

mod between;
mod curves;
mod rays;

pub use between::between;
pub use curves::{Curves, most_functions, sample};
pub use rays::meet_rays;
