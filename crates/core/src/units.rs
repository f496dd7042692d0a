//! Units: rotor speed and frequency, and the units a blade file may be written in.

use core::f64::consts::{PI, TAU};

/// rad/s of one revolution per minute.
pub const RAD_S_PER_RPM: f64 = PI / 30.0;

/// Frequency in Hz of `frequency` in rad/s.
pub fn hz(frequency: f64) -> f64 {
    frequency / TAU
}

/// Rotor speed in rpm of `speed` in rad/s.
pub fn rpm(speed: f64) -> f64 {
    speed / RAD_S_PER_RPM
}

/// Frequency per revolution of `frequency` at `speed`, both in rad/s; none at rest.
pub fn per_rev(frequency: f64, speed: f64) -> Option<f64> {
    (speed > 0.0).then(|| frequency / speed)
}

/// How far `value` is from `reference`, in percent of that; `None` where that is no number. A value of 0
/// meets a reference of 0.
pub fn percent(value: f64, reference: f64) -> Option<f64> {
    if value == 0.0 && reference == 0.0 {
        return Some(0.0);
    }
    Some(100.0 * (value / reference - 1.0)).filter(|percent| percent.is_finite())
}

/// Declares a unit enum: variant, name in files, factor to SI.
macro_rules! units {
    ($(#[$doc:meta])* $name:ident, $si:literal: $($(#[$vdoc:meta])* $variant:ident $text:literal $factor:expr),+ $(,)?) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $name { $($(#[$vdoc])* $variant),+ }

        impl $name {
            /// Every unit of this quantity, SI first.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// The unit's name in files.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $text),+ }
            }

            #[doc = concat!("How many ", $si, " one of this unit is.")]
            pub const fn si(self) -> f64 {
                match self { $(Self::$variant => $factor),+ }
            }

            /// The unit of this name.
            pub fn from_name(name: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|unit| unit.name() == name)
            }
        }

        impl core::fmt::Display for $name {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.write_str(self.name())
            }
        }

        #[cfg(feature = "serde")]
        impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str(self.name())
            }
        }
    };
}

/// Pound-mass in kg (exact, international yard and pound agreement of 1959).
const POUND: f64 = 0.453_592_37;
/// Standard gravity in m/s² (exact, CGPM 1901).
const GRAVITY: f64 = 9.806_65;
/// Foot in m (exact).
const FOOT: f64 = 0.3048;

units! {
    /// Unit of length.
    LengthUnit, "m":
    /// Metre.
    Metre "m" 1.0,
    /// Millimetre.
    Millimetre "mm" 1e-3,
    /// Centimetre.
    Centimetre "cm" 1e-2,
    /// Inch.
    Inch "in" 0.0254,
    /// Foot.
    Foot "ft" FOOT,
}
units! {
    /// Unit of mass.
    MassUnit, "kg":
    /// Kilogram.
    Kilogram "kg" 1.0,
    /// Gram.
    Gram "g" 1e-3,
    /// Pound-mass.
    Pound "lb" POUND,
    /// Slug: lbf·s²/ft.
    Slug "slug" POUND * GRAVITY / FOOT,
}
units! {
    /// Unit of force.
    ForceUnit, "N":
    /// Newton.
    Newton "N" 1.0,
    /// Kilonewton.
    Kilonewton "kN" 1e3,
    /// Pound-force.
    PoundForce "lbf" POUND * GRAVITY,
}
units! {
    /// Unit of angle.
    AngleUnit, "rad":
    /// Radian.
    Radian "rad" 1.0,
    /// Degree.
    Degree "deg" PI / 180.0,
}
units! {
    /// Unit of rotor speed.
    SpeedUnit, "rad/s":
    /// Radian per second.
    RadianPerSecond "rad/s" 1.0,
    /// Revolution per minute.
    Rpm "rpm" RAD_S_PER_RPM,
    /// Revolution per second.
    Hertz "Hz" TAU,
}

/// The units of a blade file's numbers; SI by default.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Units {
    /// Radii, offsets.
    pub length: LengthUnit,
    /// Mass; with length also inertia.
    pub mass: MassUnit,
    /// Force; with length also stiffness and springs.
    pub force: ForceUnit,
    /// Twist, pitch, precone; springs are per radian whatever this is.
    pub angle: AngleUnit,
    /// Rotor speed.
    pub speed: SpeedUnit,
}

impl Default for Units {
    fn default() -> Self {
        Self {
            length: LengthUnit::Metre,
            mass: MassUnit::Kilogram,
            force: ForceUnit::Newton,
            angle: AngleUnit::Radian,
            speed: SpeedUnit::RadianPerSecond,
        }
    }
}

impl Units {
    /// kg/m of one mass per length.
    pub fn mass_per_length(&self) -> f64 {
        self.mass.si() / self.length.si()
    }

    /// N·m² of one bending or torsional stiffness (force·length²).
    pub fn stiffness(&self) -> f64 {
        self.force.si() * self.length.si() * self.length.si()
    }

    /// N·m/rad of one spring (force·length per radian).
    pub fn spring(&self) -> f64 {
        self.force.si() * self.length.si()
    }

    /// kg·m of one mass moment of inertia per length (mass·length).
    pub fn polar_inertia(&self) -> f64 {
        self.mass.si() * self.length.si()
    }

    /// kg·m² of one mass moment of inertia (mass·length²).
    pub fn inertia(&self) -> f64 {
        self.mass.si() * self.length.si() * self.length.si()
    }
}

/// Reads a rotor speed: a bare number is rad/s; `660rpm`, `11Hz`, `69rad/s` as written.
/// Returns rad/s, or nothing where the text is none of these.
pub fn parse_speed(text: &str) -> Option<f64> {
    parse(text, SpeedUnit::ALL, SpeedUnit::name, SpeedUnit::si)
}

/// Reads an angle: a bare number is rad; `8deg`, `0.14rad` as written. Returns rad, or nothing where the text
/// is none of these.
pub fn parse_angle(text: &str) -> Option<f64> {
    parse(text, AngleUnit::ALL, AngleUnit::name, AngleUnit::si)
}

fn parse<U: Copy>(text: &str, units: &[U], name: fn(U) -> &'static str, si: fn(U) -> f64) -> Option<f64> {
    let unit = units.iter().copied().find(|unit| text.ends_with(name(*unit)));
    let (number, factor) = unit.map_or((text, 1.0), |unit| (&text[..text.len() - name(unit).len()], si(unit)));
    // `f64::from_str` also takes "inf", "NaN" and "infinity".
    if number.is_empty() || number.contains(|c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E')) {
        return None;
    }
    number.parse::<f64>().ok().map(|value| value * factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_in_percent() {
        assert_eq!(percent(1.25, 1.0), Some(25.0));
        assert_eq!(percent(0.5, 1.0), Some(-50.0));
        assert_eq!(percent(0.0, 0.0), Some(0.0));
        for (value, reference) in [(1.0, 0.0), (f64::NAN, 1.0), (1.0, f64::NAN), (f64::INFINITY, 1.0), (1e300, 1e-300)]
        {
            assert_eq!(percent(value, reference), None, "{value} {reference}");
        }
    }

    #[test]
    fn angles_are_read_in_their_units() {
        assert_eq!(parse_angle("8deg"), Some(8.0 * AngleUnit::Degree.si()));
        assert_eq!((parse_angle("-0.14rad"), parse_angle("1e-2")), (Some(-0.14), Some(0.01)));
        for text in ["", "deg", "8 degrees", "8rpm", "NaN"] {
            assert_eq!(parse_angle(text), None, "{text}");
        }
    }

    #[test]
    fn speeds_are_read_in_their_units() {
        assert_eq!(parse_speed("69.1"), Some(69.1));
        assert_eq!(parse_speed("11Hz"), Some(11.0 * TAU));
        assert_eq!(parse_speed("660rpm"), Some(660.0 * PI / 30.0));
        assert_eq!(parse_speed("1e2rad/s"), Some(100.0));
        for bad in ["", "rpm", "660 rpm", "inf", "NaN", "6x", "660Rpm"] {
            assert_eq!(parse_speed(bad), None, "{bad}");
        }
    }

    #[test]
    fn slug_and_pound_force_agree_with_their_definitions() {
        // NIST SP 811: 1 slug = 14.593 903 kg, 1 lbf = 4.448 222 N.
        assert!((MassUnit::Slug.si() - 14.593_903).abs() < 1e-6, "{}", MassUnit::Slug.si());
        assert!((ForceUnit::PoundForce.si() - 4.448_222).abs() < 1e-6, "{}", ForceUnit::PoundForce.si());
    }
}
