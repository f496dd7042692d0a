//! Drawings: fan chart, mode shapes and convergence as SVG. Draws, computes no physics.
//!
//! ```text
//! FanChart | ShapesReport | ConvergeReport ─layout (scale, labels)→ Sheet of layers ─plotters→ SVG text
//! ```
//! The text is the same on every target: plotters never measures text here (on wasm it would ask
//! the page for it), labels are placed with a width table, ticks are decimal text, and no
//! function of the platform's mathematics library is called.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "pixels: casts from floating point saturate, and a drawing is at most 8000 wide"
)]

mod converge;
mod fan;
mod key;
mod labels;
mod line;
mod options;
mod palette;
mod panel;
mod scale;
mod shapes;
mod sheet;
#[cfg(test)]
mod tests;
mod text;

pub use converge::converge;
pub use fan::fan;
pub use options::{ChartOptions, FrequencyUnit, Theme, parse_frequencies};
pub use shapes::{coupled_shapes, shapes};

use alloc::string::String;
use alloc::vec::Vec;

/// One axis of a plot area.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Axis {
    /// Value at the left or lower end [`unit`](Self::unit).
    pub from: f64,
    /// Value at the right or upper end.
    pub to: f64,
    /// Unit; empty for a pure number.
    pub unit: &'static str,
    /// Whether equal lengths are equal ratios.
    pub log: bool,
}

/// Where a frame stands in its drawing, so that a page can lay tooltips and a speed line over it.
/// Lengths are in units of the viewBox, y downwards.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PlotArea {
    /// `fan`; `flap`, `lag`, `torsion`; `frequency`, `error`.
    pub name: &'static str,
    /// Left edge.
    pub left: f64,
    /// Upper edge.
    pub top: f64,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
    /// Axis to the right.
    pub x: Axis,
    /// Axis upwards.
    pub y: Axis,
}

/// A drawing.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Drawing {
    /// The SVG text. Branches and shapes are groups with `data-label` (`1F`, …).
    pub svg: String,
    /// Width of the viewBox.
    pub width: f64,
    /// Height of the viewBox.
    pub height: f64,
    /// The frames in it.
    pub plots: Vec<PlotArea>,
}
