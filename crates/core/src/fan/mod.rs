//! Frequencies over a range of rotor speeds: curves, and their crossings with the nP rays.

mod between;
mod crossings;
mod curves;

pub use between::between;
pub use crossings::{RayCrossing, Rays, meet_rays};
pub use curves::Curves;
