//! A blade as its author gives it: plain data, in the author's units, not yet checked.

use super::property::Property;
use crate::dof::Dof;
use crate::units::Units;
use alloc::string::String;
use alloc::vec::Vec;
use core::ops::{Index, IndexMut};

/// A blade as given. Any value is legal here; the check turns it into a [`Blade`](super::Blade)
/// or lists every fault. What the author left out is `None`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BladeDefinition {
    /// Name shown in every result.
    pub name: Option<String>,
    /// Free text.
    pub notes: Option<String>,
    /// Where the numbers come from.
    pub source: Option<Source>,
    /// Units of all numbers below.
    pub units: Units,
    /// The rotor.
    pub rotor: Option<RotorDefinition>,
    /// Root of the flap degree of freedom.
    pub flap: Option<RootDefinition>,
    /// Root of the lag degree of freedom.
    pub lag: Option<RootDefinition>,
    /// Root of the torsion degree of freedom.
    pub torsion: Option<RootDefinition>,
    /// Properties along the span.
    pub distribution: Option<DistributionDefinition>,
    /// Masses that are not spread along the span.
    pub point_masses: Vec<PointMassDefinition>,
}

impl BladeDefinition {
    /// The root of a degree of freedom.
    pub const fn root(&self, dof: Dof) -> Option<&RootDefinition> {
        match dof {
            Dof::Flap => self.flap.as_ref(),
            Dof::Lag => self.lag.as_ref(),
            Dof::Torsion => self.torsion.as_ref(),
        }
    }

    /// Whether anything of torsion is given: its root, its stiffness or an inertia. Without all of it a blade has
    /// flap and lag alone.
    pub fn has_torsion(&self) -> bool {
        let given = |property: &Property| self.distribution.as_ref().is_some_and(|given| given[*property].is_some());
        self.torsion.is_some() || Property::OF_TORSION.iter().any(given)
    }

    /// The same, to be changed.
    pub const fn root_mut(&mut self, dof: Dof) -> &mut Option<RootDefinition> {
        match dof {
            Dof::Flap => &mut self.flap,
            Dof::Lag => &mut self.lag,
            Dof::Torsion => &mut self.torsion,
        }
    }
}

/// Where a blade's numbers come from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Source {
    /// Author, title, report number, table.
    pub citation: Option<String>,
    /// One of [`QUALITIES`](Self::QUALITIES).
    pub quality: Option<String>,
}

impl Source {
    /// What a source may call itself.
    pub const QUALITIES: &'static [&'static str] = &["published", "estimated", "example"];
}

/// The rotor's own numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RotorDefinition {
    /// Tip radius [length].
    pub radius: Option<f64>,
    /// Nominal rotor speed [speed].
    pub nominal_speed: Option<f64>,
    /// Number of blades; a positive integer.
    pub blades: Option<f64>,
    /// Collective pitch, + nose up; added to the twist everywhere [angle].
    pub pitch: Option<f64>,
    /// Precone, + tip up; its apex lies on the rotor's axis [angle].
    pub precone: Option<f64>,
    /// Elastic axis ahead of the radial line through the rotor's axis, + toward the leading edge [length].
    pub torque_offset: Option<f64>,
    /// By what angle the springs of flap and lag are turned.
    pub spring_angle: Option<SpringAngle>,
}

/// By what angle the springs of flap and lag, at one radius, are turned about the elastic axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpringAngle {
    /// By this, + nose up [angle]; at 0 they act out of and in the plane of the disc.
    Angle(f64),
    /// By pitch and twist of the blade at their radius.
    Pitch,
}

impl SpringAngle {
    /// The word of the blade file for [`Pitch`](Self::Pitch).
    pub const PITCH: &'static str = "pitch";
}

impl Default for SpringAngle {
    fn default() -> Self {
        Self::Angle(0.0)
    }
}

/// A mass at one radius: a tip weight, a balance weight, a damper.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointMassDefinition {
    /// Its radius, on the blade [length].
    pub r: Option<f64>,
    /// Mass [mass].
    pub mass: Option<f64>,
    /// Its centre ahead of the elastic axis, + toward the leading edge [length].
    pub offset: Option<f64>,
    /// Moment of inertia of its extent out of the chord plane, about the elastic axis [mass·length²].
    pub flap_inertia: Option<f64>,
    /// Moment of inertia of its extent along the chord, about the elastic axis, that of the offset
    /// included [mass·length²].
    pub lag_inertia: Option<f64>,
}

/// How a degree of freedom is held at its root, as words of the blade file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RootKind {
    /// Bending, clamped (`hingeless`).
    Hingeless,
    /// Bending, free hinge (`hinged`).
    Hinged,
    /// Bending, hinge with a spring (`spring-hinged`).
    SpringHinged,
    /// Torsion, stiff pitch control (`rigid`).
    Rigid,
    /// Torsion, pitch control with a spring (`spring`).
    Spring,
}

impl RootKind {
    /// Roots of flap and lag.
    pub const BENDING: &'static [Self] = &[Self::Hingeless, Self::Hinged, Self::SpringHinged];
    /// Roots of torsion.
    pub const TORSION: &'static [Self] = &[Self::Rigid, Self::Spring];

    /// The roots that a degree of freedom can have.
    pub const fn choices(dof: Dof) -> &'static [Self] {
        match dof {
            Dof::Flap | Dof::Lag => Self::BENDING,
            Dof::Torsion => Self::TORSION,
        }
    }

    /// The word of the blade file.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Hingeless => "hingeless",
            Self::Hinged => "hinged",
            Self::SpringHinged => "spring-hinged",
            Self::Rigid => "rigid",
            Self::Spring => "spring",
        }
    }

    /// Whether a spring goes with this root.
    pub const fn takes_spring(self) -> bool {
        matches!(self, Self::SpringHinged | Self::Spring)
    }
}

/// Root of one degree of freedom.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RootDefinition {
    /// How the root is held.
    pub root: Option<RootKind>,
    /// Radius of hinge or root [length].
    pub offset: Option<f64>,
    /// The same as a ratio to the tip radius.
    pub offset_ratio: Option<f64>,
    /// Spring [force·length/rad].
    pub spring: Option<f64>,
}

/// Properties along the span, each found by its name: `distribution[Property::Mass]`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DistributionDefinition {
    /// Radii of the stations that lists without radii of their own stand on [length].
    pub r: Option<Vec<f64>>,
    /// The properties, in the order of [`Property::ALL`].
    pub properties: [Option<PropertyDefinition>; Property::COUNT],
}

impl Index<Property> for DistributionDefinition {
    type Output = Option<PropertyDefinition>;

    fn index(&self, property: Property) -> &Self::Output {
        &self.properties[property.index()]
    }
}

impl IndexMut<Property> for DistributionDefinition {
    fn index_mut(&mut self, property: Property) -> &mut Self::Output {
        &mut self.properties[property.index()]
    }
}

/// One property along the span. Linear between stations; a radius given twice is a step.
#[derive(Clone, Debug, PartialEq)]
pub enum PropertyDefinition {
    /// One number for all radii.
    Uniform(f64),
    /// Values on the radii `distribution.r`.
    OnStations(Vec<f64>),
    /// Values on radii of their own.
    OwnRadii {
        /// Radii [length].
        r: Vec<f64>,
        /// Values at these radii.
        values: Vec<f64>,
    },
}
