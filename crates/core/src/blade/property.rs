//! The properties of a blade along its span: one table, which the check, the conversion of units,
//! readers, writers, summaries and warnings run over. A new property is one row here.

use super::range::Range;
use crate::dof::Dof;
use crate::units::Units;

/// What the table says of one property.
pub(super) struct Row {
    /// Key of the blade file.
    pub(super) key: &'static str,
    /// What messages call it.
    pub(super) words: &'static str,
    /// How many SI units one unit of it is.
    pub(super) unit: fn(&Units) -> f64,
    /// Legal values, in SI units.
    pub(super) range: Range,
    /// Whether it must be given; else it is 0 where it is not, and one that is 0 everywhere need be
    /// known nowhere.
    pub(super) required: bool,
    /// Properties of which it is the sum where it is not given and they are.
    pub(super) sum_of: &'static [Property],
    /// A property without which it must not be given.
    pub(super) together_with: Option<Property>,
    /// A property beside which it must not be given.
    pub(super) not_beside: Option<Property>,
    /// It must be known from the innermost of these roots to the tip.
    pub(super) known_from: &'static [Dof],
    /// And from these roots where the other property is not 0 everywhere.
    pub(super) also_from: &'static [(Property, Dof)],
    /// It must be greater than 0 somewhere outboard of each of these roots.
    pub(super) acts_outboard_of: &'static [Dof],
}

/// What of a row is said only where it differs from this.
const USUAL: Row = Row {
    key: "",
    words: "",
    unit: |_| 1.0,
    range: Range::FINITE,
    required: true,
    sum_of: &[],
    together_with: None,
    not_beside: None,
    known_from: &[],
    also_from: &[],
    acts_outboard_of: &[],
};

/// Declares the properties: one row each.
macro_rules! properties {
    ($($(#[$doc:meta])* $name:ident { $($field:ident: $value:expr),+ $(,)? })+) => {
        /// A property of a blade along its span.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Property { $($(#[$doc])* $name),+ }

        impl Property {
            /// How many there are.
            pub const COUNT: usize = Self::ALL.len();
            /// Every property, in the order of the blade file.
            pub const ALL: [Self; [$(stringify!($name)),+].len()] = [$(Self::$name),+];
        }

        static ROWS: [Row; Property::COUNT] = [$(Row { $($field: $value,)+ ..USUAL }),+];
    };
}

properties! {
    /// Mass per length [mass/length].
    Mass {
        key: "mass",
        words: "mass per length",
        unit: Units::mass_per_length,
        range: Range::zero_or(1e-30, 1e30, "kg/m"),
        known_from: &[Dof::Flap, Dof::Lag],
        also_from: &[(Property::MassOffset, Dof::Torsion)],
        acts_outboard_of: &[Dof::Flap, Dof::Lag],
    }
    /// Flapwise bending stiffness [force·length²].
    FlapStiffness {
        key: "flap_stiffness",
        words: "flap stiffness",
        unit: Units::stiffness,
        range: Range::positive(1e-30, 1e30, "N·m²"),
        known_from: &[Dof::Flap],
    }
    /// Chordwise bending stiffness [force·length²].
    LagStiffness {
        key: "lag_stiffness",
        words: "lag stiffness",
        unit: Units::stiffness,
        range: Range::positive(1e-30, 1e30, "N·m²"),
        known_from: &[Dof::Lag],
    }
    /// Torsional stiffness [force·length²].
    TorsionStiffness {
        key: "torsion_stiffness",
        words: "torsion stiffness",
        unit: Units::stiffness,
        range: Range::positive(1e-30, 1e30, "N·m²"),
        known_from: &[Dof::Torsion],
    }
    /// Polar mass moment of inertia per length [mass·length].
    PolarInertia {
        key: "polar_inertia",
        words: "polar inertia",
        unit: Units::polar_inertia,
        range: Range::zero_or(1e-30, 1e30, "kg·m"),
        sum_of: &[Property::FlapInertia, Property::LagInertia],
        known_from: &[Dof::Torsion],
        acts_outboard_of: &[Dof::Torsion],
    }
    /// Mass moment of inertia per length of the extent out of the chord plane, about the elastic
    /// axis [mass·length].
    FlapInertia {
        key: "flap_inertia",
        words: "flap inertia",
        unit: Units::polar_inertia,
        range: Range::zero_or(1e-30, 1e30, "kg·m"),
        required: false,
        together_with: Some(Property::LagInertia),
        known_from: &[Dof::Flap, Dof::Lag, Dof::Torsion],
    }
    /// Mass moment of inertia per length of the extent along the chord, about the elastic axis
    /// [mass·length].
    LagInertia {
        key: "lag_inertia",
        words: "lag inertia",
        unit: Units::polar_inertia,
        range: Range::zero_or(1e-30, 1e30, "kg·m"),
        required: false,
        together_with: Some(Property::FlapInertia),
        known_from: &[Dof::Flap, Dof::Lag, Dof::Torsion],
    }
    /// Centre of mass ahead of the elastic axis, + toward the leading edge [length].
    MassOffset {
        key: "mass_offset",
        words: "mass offset",
        unit: |units| units.length.si(),
        range: Range::up_to(1e6, "m"),
        required: false,
        known_from: &[Dof::Torsion],
    }
    /// Built-in twist, + nose up [angle].
    Twist {
        key: "twist",
        words: "twist",
        unit: |units| units.angle.si(),
        range: Range::up_to(1e6, "rad"),
        required: false,
    }
    /// Tension centre ahead of the elastic axis, + toward the leading edge [length].
    TensionOffset {
        key: "tension_offset",
        words: "tension offset",
        unit: |units| units.length.si(),
        range: Range::up_to(1e6, "m"),
        required: false,
        known_from: &[Dof::Flap, Dof::Lag, Dof::Torsion],
    }
    /// Axial stiffness EA [force]; not known where it is not given.
    AxialStiffness {
        key: "axial_stiffness",
        words: "axial stiffness",
        unit: |units| units.force.si(),
        range: Range::positive(1e-30, 1e30, "N"),
        required: false,
        known_from: &[Dof::Torsion],
    }
    /// Radius of gyration of the tensioned area about the elastic axis [length].
    TrapezeRadius {
        key: "trapeze_radius",
        words: "trapeze radius",
        unit: |units| units.length.si(),
        range: Range::zero_or(1e-30, 1e6, "m"),
        required: false,
        not_beside: Some(Property::AxialStiffness),
        known_from: &[Dof::Torsion],
    }
}

impl Property {
    /// Its place in [`ALL`](Self::ALL).
    pub const fn index(self) -> usize {
        self as usize
    }

    pub(super) fn row(self) -> &'static Row {
        &ROWS[self.index()]
    }

    /// Its key in blade files.
    pub fn key(self) -> &'static str {
        self.row().key
    }

    /// The property of this key.
    pub fn from_key(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|property| property.key() == key)
    }

    /// What messages call it.
    pub fn words(self) -> &'static str {
        self.row().words
    }

    /// How many SI units one unit of it is.
    pub fn unit(self, units: &Units) -> f64 {
        (self.row().unit)(units)
    }

    /// Whether a blade with torsion must give it, or what it is the [sum of](Self::sum_of); else it is 0 where it
    /// does not.
    pub fn is_required(self) -> bool {
        self.row().required
    }

    /// Without these, and a root of torsion, a blade has flap and lag alone.
    pub const OF_TORSION: [Self; 4] = [Self::TorsionStiffness, Self::PolarInertia, Self::FlapInertia, Self::LagInertia];

    /// Properties of which it is the sum where a blade gives them and not it.
    pub fn sum_of(self) -> &'static [Self] {
        self.row().sum_of
    }

    /// The stiffness of a degree of freedom.
    pub const fn stiffness(dof: Dof) -> Self {
        match dof {
            Dof::Flap => Self::FlapStiffness,
            Dof::Lag => Self::LagStiffness,
            Dof::Torsion => Self::TorsionStiffness,
        }
    }
}

impl core::fmt::Display for Property {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.words())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::collections::BTreeSet;

    #[test]
    fn every_row_says_what_it_is() {
        for (index, property) in Property::ALL.into_iter().enumerate() {
            assert_eq!(property.index(), index, "{property:?}");
            assert_eq!(Property::from_key(property.key()), Some(property), "{property:?}");
            assert!(!property.words().is_empty(), "{property:?}");
            assert_eq!(property.unit(&Units::default()), 1.0, "{property:?} in SI units");
        }
        let keys: BTreeSet<&str> = Property::ALL.into_iter().map(Property::key).collect();
        assert_eq!(keys.len(), Property::COUNT, "no key twice");
        assert_eq!(Property::from_key("chord"), None);
    }

    /// 0 must be legal for what may be left out, as that is what it then is; but an axial stiffness
    /// that is left out is not known, and none is 0.
    #[test]
    fn what_may_be_left_out_may_be_zero() {
        for property in Property::ALL.into_iter().filter(|property| !property.is_required()) {
            let unknown = property == Property::AxialStiffness;
            assert_eq!(property.row().range.broken_by(0.0).is_some(), unknown, "{property:?}");
        }
    }

    #[test]
    fn what_belongs_together_says_so_on_either_side() {
        for property in Property::ALL {
            if let Some(other) = property.row().together_with {
                assert_eq!(other.row().together_with, Some(property), "{property:?}");
            }
        }
        assert_eq!(Property::PolarInertia.sum_of(), [Property::FlapInertia, Property::LagInertia]);
    }
}
