//! Values of a fan chart on its axes.

use super::super::FrequencyUnit;
use super::super::panel::Panel;
use super::super::sheet::Point;
use crate::units::SpeedUnit;

/// Units of the axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Units {
    pub speed: SpeedUnit,
    pub frequency: FrequencyUnit,
}

impl Units {
    /// A rotor speed [rad/s] on the axis to the right.
    pub(super) fn speed(self, speed: f64) -> f64 {
        speed / self.speed.si()
    }

    /// Rotor speed [rad/s] of a value of that axis.
    pub(super) fn speed_si(self, speed: f64) -> f64 {
        speed * self.speed.si()
    }

    /// A frequency at a rotor speed [rad/s] on the axis upwards; per revolution there is none at rest.
    pub(super) fn frequency(self, frequency: f64, speed: f64) -> Option<f64> {
        self.frequency.of(frequency, speed)
    }

    /// Whether frequencies are counted per revolution, so that rays are level.
    pub(super) fn per_rev(self) -> bool {
        self.frequency == FrequencyUnit::PerRev
    }

    /// Where a frequency at a rotor speed is on the drawing.
    pub(super) fn point(self, panel: &Panel, speed: f64, frequency: f64) -> Option<Point> {
        panel.point(self.speed(speed), self.frequency(frequency, speed)?)
    }
}
