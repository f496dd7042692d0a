//! Frequencies over a range of rotor speeds: curves, and where they cross the nP rays.

mod curves;
mod rays;

pub use curves::{Curves, sample};
pub use rays::{RayCrossing, Rays, meet_rays};
