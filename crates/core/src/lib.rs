//! Natural frequencies, mode shapes and fan charts of rotating blades.

#![no_std]
extern crate alloc;
#[cfg(test)]
extern crate std;

pub mod analysis;
pub mod blade;
#[cfg(feature = "chart")]
pub mod chart;
pub mod dof;
pub mod fault;
#[cfg(feature = "file")]
pub mod file;
#[cfg(feature = "library")]
pub mod library;
pub mod numerics;
pub mod units;

/// Version of this program, as in results and charts.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
