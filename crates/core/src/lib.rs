#![doc = include_str!("../README.md")]
//!
//! # The method
//!
//! "Eq. n" in these pages is an equation of the paper. The motion of each degree of freedom is a sum of
//! assumed functions, w(r, t) = Σ φ_i(r) q_i(t), and Lagrange's equation gives
//!
//! (K + F + Ω² C − ω² M) q = 0
//!
//! with M the mass, K the elastic, F the root spring and C the centrifugal matrix. None of them
//! depends on the rotor speed Ω, so a blade is integrated once and every speed is a small
//! eigenproblem. `docs/THEORY.md` has the rest.
//!
//! ```text
//! blade file ──formats::read──▶ BladeDefinition ──check──▶ Blade
//!   ──assembled──▶ M, K + F, C ──solved──▶ modes ──fitted over Ω²──▶ curves
//!   ──modes, fan, shapes, …──▶ ModesReport, FanChart, … ──chart──▶ SVG
//! ```
//!
//! Numbers are in SI units and rad/s; any other unit stands in a name.
//!
//! ```
//! # #[cfg(feature = "library")] {
//! use bladefan_core::{Settings, formats, library, modes};
//!
//! let text = library::find("uniform").expect("built in").toml;
//! let blade = formats::read(text, formats::Format::Toml)?.blade;
//! let at_12 = Settings { speed: Some(12.0), functions: 60, ..Settings::default() };
//! // Wright, Smith, Thresher & Wang 1982: 13.1702.
//! assert!((modes(&blade, &at_12)?.modes[0].frequency_rad_s - 13.1702).abs() < 5e-5);
//! # }
//! # Ok::<(), bladefan_core::Faults>(())
//! ```

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

mod analysis;
mod blade;
#[cfg(feature = "chart")]
pub mod chart;
mod converged;
mod coupled;
mod dof;
mod fan;
mod fault;
pub mod figures;
#[cfg(feature = "formats")]
pub mod formats;
mod functions;
#[cfg(feature = "internals")]
#[doc(hidden)]
pub mod internals;
mod label;
mod lagrange;
#[cfg(feature = "library")]
pub mod library;
mod modes;
mod numerics;
pub mod report;
pub mod units;

pub use analysis::{
    Curve, MODEL, Model, ModelKind, PAPER_FUNCTIONS, Settings, ShapeScale, SpeedRange, at_speed, compare, converge,
    coupled_modes, coupled_shapes, fan, margins, modes, shapes, summary, warnings,
};
pub use blade::{
    Amount, Blade, BladeDefinition, Change, Changed, DistributionDefinition, Part, PointMass, PointMassDefinition,
    PropellerMoment, Property, PropertyDefinition, Root, RootCondition, RootDefinition, RootKind, RotorDefinition,
    Source, SpringAngle, What, change, check, convert,
};
pub use dof::Dof;
pub use fault::{Fault, FaultCode, Faults, Warning};
pub use functions::BasisFamily;
pub use label::{Label, NotALabel};
pub use numerics::{Linear, PiecewiseLinear};
pub use units::Units;

/// Version of this program, as in results and charts.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
