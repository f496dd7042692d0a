//! Drawings: fan chart, mode shapes and convergence as SVG. Draws, computes no physics.
//!
//! ```text
//! FanChart | ShapesReport | ConvergeReport ─layout (scale, spread, place)→ Sheet of layers ─plotters→ SVG text
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
mod line;
mod palette;
mod panel;
mod place;
mod scale;
mod shapes;
mod sheet;
mod spread;
#[cfg(test)]
mod tests;
mod text;

pub use converge::converge;
pub use fan::fan;
pub use shapes::shapes;

use crate::analysis::MeasuredPoint;
use crate::units::{self, SpeedUnit};
use alloc::string::String;
use alloc::vec::Vec;

/// Colours for a light or a dark surrounding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// Dark on white, for paper.
    #[default]
    Light,
    /// Light on near-black.
    Dark,
}

impl Theme {
    /// Both themes.
    pub const ALL: [Self; 2] = [Self::Light, Self::Dark];

    /// The name used in options.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Light => "light",
            Self::Dark => "dark",
        }
    }

    /// The theme of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|theme| theme.name() == name)
    }
}

/// Unit of a frequency axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FrequencyUnit {
    /// Radian per second.
    #[default]
    RadS,
    /// Cycle per second.
    Hz,
}

impl FrequencyUnit {
    /// Both units.
    pub const ALL: [Self; 2] = [Self::RadS, Self::Hz];

    /// The unit as it stands in axis names.
    pub const fn name(self) -> &'static str {
        match self {
            Self::RadS => "rad/s",
            Self::Hz => "Hz",
        }
    }

    /// The unit of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|unit| unit.name() == name)
    }

    /// `frequency` [rad/s] in this unit.
    fn of(self, frequency: f64) -> f64 {
        match self {
            Self::RadS => frequency,
            Self::Hz => units::hz(frequency),
        }
    }
}

/// How a drawing should look. Any value is legal: a width is held to 320 … 8000.
#[derive(Clone, Debug, PartialEq)]
pub struct ChartOptions<'a> {
    /// Colours.
    pub theme: Theme,
    /// Width [px]; the height follows from it. 960: a page's column, and a slide's half.
    pub width: u32,
    /// Unit of rotor speeds; rpm, as rotors are spoken of.
    pub speed_unit: SpeedUnit,
    /// Unit of frequencies.
    pub frequency_unit: FrequencyUnit,
    /// Operating band as ratios of nominal speed; crossings inside are marked.
    pub band: (f64, f64),
    /// Measured frequencies to draw over a fan chart.
    pub measured: &'a [MeasuredPoint],
}

impl Default for ChartOptions<'_> {
    fn default() -> Self {
        Self {
            theme: Theme::Light,
            width: 960,
            speed_unit: SpeedUnit::Rpm,
            frequency_unit: FrequencyUnit::RadS,
            band: (0.9, 1.1),
            measured: &[],
        }
    }
}

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
