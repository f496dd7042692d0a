//! Where labels stand: along a line, beside a point, or beside the nearest of many circles.

mod circles;
mod place;
mod spread;

pub(super) use circles::{Circles, Placed};
pub(super) use place::Obstacles;
pub(super) use spread::{Wish, spread};
