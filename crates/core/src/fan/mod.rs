//! Frequencies over a range of rotor speeds: curves, and where they cross the nP rays.

mod between;
mod curves;
mod meets;
mod rays;
mod veerings;

pub use between::between;
pub use curves::{Curves, most_functions, sample};
pub use meets::{Meets, OnBranch, meet};
pub use rays::meet_rays;
pub use veerings::Branches;
