//! Natural frequencies, mode shapes and fan charts of rotating blades.

#![no_std]
#![cfg_attr(
    test,
    allow(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::float_cmp,
        clippy::excessive_precision,
        clippy::disallowed_methods,
        reason = "a test stops where it fails; exact zeros and reference digits are meant; the platform's functions are the reference"
    )
)]
extern crate alloc;
#[cfg(test)]
extern crate std;

pub mod analysis;
pub mod blade;
#[cfg(feature = "chart")]
pub mod chart;
pub mod dof;
pub mod fan;
pub mod fault;
#[cfg(feature = "file")]
pub mod file;
pub mod functions;
pub mod lagrange;
#[cfg(feature = "library")]
pub mod library;
pub mod modes;
pub mod numerics;
pub mod units;

/// Version of this program, as in results and charts.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
