//! How a drawing should look.

use crate::fault::{Fault, FaultCode};
use crate::report::MeasuredPoint;
use crate::units::{self, SpeedUnit};
use alloc::format;
use alloc::string::ToString;

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
    /// Cycle per minute.
    Rpm,
    /// Cycle per revolution of the rotor.
    PerRev,
}

impl FrequencyUnit {
    /// Every unit.
    pub const ALL: [Self; 4] = [Self::RadS, Self::Hz, Self::Rpm, Self::PerRev];

    /// The name used in options.
    pub const fn name(self) -> &'static str {
        match self {
            Self::RadS => "rad/s",
            Self::Hz => "Hz",
            Self::Rpm => "rpm",
            Self::PerRev => "per-rev",
        }
    }

    /// The unit as it stands in axis names.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::PerRev => "/rev",
            other => other.name(),
        }
    }

    /// The unit of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|unit| unit.name() == name)
    }

    /// `frequency` at rotor speed `speed` [both rad/s] in this unit; per revolution there is none at rest.
    pub(super) fn of(self, frequency: f64, speed: f64) -> Option<f64> {
        match self {
            Self::RadS => Some(frequency),
            Self::Hz => Some(units::hz(frequency)),
            Self::Rpm => Some(units::rpm(frequency)),
            Self::PerRev => units::per_rev(frequency, speed),
        }
    }
}

/// How a drawing should look. Any value is legal: a width is held to 320 … 8000, a height to 0.4 … 1.6 of
/// the width, and a range of frequencies that is none is not looked at.
#[derive(Clone, Debug, PartialEq)]
pub struct ChartOptions<'a> {
    /// Colours.
    pub theme: Theme,
    /// Width [px]. 960: a page's column, and a slide's half.
    pub width: u32,
    /// Height [px]; `None`: as suits the width. A drawing with more in it than fits is higher.
    pub height: Option<u32>,
    /// Unit of rotor speeds; rpm, as rotors are spoken of.
    pub speed_unit: SpeedUnit,
    /// Unit of frequencies.
    pub frequency_unit: FrequencyUnit,
    /// What the frequency axis of a fan chart shows [`frequency_unit`](Self::frequency_unit), from and to;
    /// `None`: from 0 to what the rays can meet.
    pub frequencies: Option<(f64, f64)>,
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
            height: None,
            speed_unit: SpeedUnit::Rpm,
            frequency_unit: FrequencyUnit::RadS,
            frequencies: None,
            band: (0.9, 1.1),
            measured: &[],
        }
    }
}

impl ChartOptions<'_> {
    /// The range of frequencies, if it is one.
    pub(super) fn window(&self) -> Option<(f64, f64)> {
        self.frequencies.filter(|&window| is_window(window))
    }

    /// The height asked for [px], as it is held to the width.
    pub(super) fn held_height(&self, width: f64) -> Option<f64> {
        self.height.map(|height| f64::from(height).clamp(0.4 * width, 1.6 * width))
    }
}

fn is_window((from, to): (f64, f64)) -> bool {
    // Ends so near that no tick could tell them apart are no range.
    from >= 0.0 && to.is_finite() && to - from > 1e-9 * to
}

/// Reads the option `frequencies`: FROM:TO in the unit of the frequency axis, like `0:500`.
///
/// # Errors
/// A text that is no range, or ends out of order.
pub fn parse_frequencies(text: &str) -> Result<(f64, f64), Fault> {
    let refuse = |rule: &str| {
        let message = format!("{rule} (is {text})");
        Err(Fault::new(FaultCode::Option, "frequencies", Some(text.to_string()), rule, message))
    };
    let ends = text.split_once(':').and_then(|(from, to)| Some((from.parse().ok()?, to.parse().ok()?)));
    match ends {
        Some(window) if is_window(window) => Ok(window),
        Some(_) => refuse("must have 0 <= FROM < TO, both finite"),
        None => refuse("must be FROM:TO in the unit of the frequency axis like 0:500"),
    }
}
