//! What the test files of this package share: blades described once for both the product and the
//! independent solution, that solution, random blades, cases kept as data, and wrong blade files.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "tests fail by panicking")]
#![allow(
    clippy::missing_panics_doc,
    clippy::excessive_precision,
    reason = "see above; reference values stand as computed"
)]

extern crate alloc;

pub mod blades;
pub mod bracket;
pub mod cases;
pub mod closed_forms;
pub mod coupled;
pub mod exact;
pub mod faults;
pub mod hostile;
pub mod random;
pub mod solve;
mod sturm;
pub mod verdict;
