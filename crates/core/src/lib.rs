//! Natural frequencies, mode shapes and fan charts of rotating blades, after Goulos, Pachidis &
//! Pilidis, Aeronautical Journal 118 (1206), 2014 ("Eq. n" in these pages is an equation there).
//!
//! Flap, lag and torsion are solved apart. The motion of each is a sum of assumed functions,
//! w(r, t) = Σ φ_i(r) q_i(t), and Lagrange's equation gives
//!
//! (K + F + Ω² C − ω² M) q = 0
//!
//! with M the mass, K the elastic, F the root spring and C the centrifugal matrix. None of them
//! depends on the rotor speed Ω, so a blade is integrated once and every speed is a small
//! eigenproblem. `docs/THEORY.md` has the rest.
//!
//! ```text
//! blade file ──formats::read──▶ BladeDefinition ──blade::check──▶ Blade
//!   ──lagrange::assemble──▶ SystemMatrices ──modes::solve──▶ Mode
//!   ──fan::Curves::fit──▶ Curves ──analysis──▶ ModesReport, FanChart, … ──chart──▶ SVG
//! ```
//!
//! Most callers need a [`blade::Blade`] and the facade [`analysis`]:
//!
//! ```
//! # #[cfg(feature = "library")] {
//! use bladefan_core::analysis::{Settings, modes};
//! use bladefan_core::{formats, library};
//!
//! let text = library::find("uniform").expect("built in").toml;
//! let blade = formats::read(text, formats::Format::Toml).expect("no faults").blade;
//! let at_12 = Settings { speed: Some(12.0), functions: 60, ..Settings::default() };
//! let report = modes(&blade, &at_12).expect("solvable");
//! // Wright, Smith, Thresher & Wang 1982: 13.1702.
//! assert!((report.modes[0].frequency_rad_s - 13.1702).abs() < 5e-5);
//! # }
//! ```
//!
//! `no_std` with `alloc`. Results have the same bits on every target. SI units, rad/s; other units
//! stand in a name. Features: `serde`, `formats`, `library`, `chart`.

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
pub mod converged;
pub mod dof;
pub mod fan;
pub mod fault;
#[cfg(feature = "formats")]
pub mod formats;
pub mod functions;
pub mod label;
pub mod lagrange;
#[cfg(feature = "library")]
pub mod library;
pub mod modes;
pub mod numerics;
mod order;
pub mod report;
pub mod units;

/// Version of this program, as in results and charts.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
