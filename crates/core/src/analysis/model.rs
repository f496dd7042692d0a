//! What is solved: the model in words, and what of a blade it does not use.

use crate::blade::{Blade, Property};
use crate::fault::Warning;
use alloc::format;
use alloc::string::ToString;
use alloc::vec::Vec;

/// What is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Model {
    words: &'static str,
    /// Properties of which something does not act, and what to say where they are not 0.
    remarks: &'static [(Property, Use, &'static str)],
}

/// How much of a property acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Use {
    Partly,
    None,
}

impl Model {
    /// Flap, lag and torsion apart.
    pub const UNCOUPLED: Self = Self {
        words: "uncoupled, in vacuum, zero pitch, the paper's torsion term",
        remarks: &[
            (Property::MassOffset, Use::Partly, "acts in torsion only"),
            (Property::Twist, Use::None, "not used by the uncoupled solver"),
        ],
    };

    /// One plain line that says what the model is; it stands with every table and chart.
    pub const fn words(&self) -> &'static str {
        self.words
    }

    /// Whether a property acts at all.
    pub fn uses(&self, property: Property) -> bool {
        !self.remarks.iter().any(|&(other, how, _)| other == property && how == Use::None)
    }

    /// What of a blade does not act, or not as its author may expect, because of the model.
    pub fn unused(&self, blade: &Blade) -> Vec<Warning> {
        let acts = |property: Property| blade.property(property).values().iter().any(|&value| value != 0.0);
        let remarks = self.remarks.iter().filter(|(property, ..)| acts(*property));
        remarks
            .map(|(property, _, message)| Warning {
                path: format!("distribution.{}", property.key()),
                message: (*message).to_string(),
            })
            .collect()
    }
}

/// [`Model::words`] of the model that is solved.
pub const MODEL: &str = Model::UNCOUPLED.words();

/// The warnings of every result: the blade's own, then what the model does not use of it.
pub fn warnings(blade: &Blade) -> Vec<Warning> {
    let mut warnings = blade.warnings().to_vec();
    warnings.extend(Model::UNCOUPLED.unused(blade));
    warnings
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blade::{BladeDefinition, RootDefinition, check};
    use alloc::string::String;

    fn blade() -> BladeDefinition {
        BladeDefinition::new("test", 1.0, 1.0)
            .with_flap(RootDefinition::hinged(0.0))
            .with_lag(RootDefinition::hinged(0.0))
            .with_torsion(RootDefinition::rigid(0.0))
            .with(Property::Mass, 1.0)
            .with(Property::FlapStiffness, 1.0)
            .with(Property::LagStiffness, 1.0)
            .with(Property::TorsionStiffness, 1.0)
            .with(Property::PolarInertia, 1.0)
    }

    fn told(blade: &BladeDefinition) -> Vec<String> {
        warnings(&check(blade).unwrap()).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn what_acts_not_at_all_or_partly_is_told_after_the_blades_own_warnings() {
        let zero = blade().with(Property::Twist, 0.0).with(Property::MassOffset, [(0.0, 0.0), (1.0, 0.0)]);
        assert!(told(&zero).is_empty(), "0 acts nowhere: {:?}", told(&zero));
        let both = zero
            .with_stations([0.0, 1.0])
            .with(Property::MassOffset, [(0.0, 0.0), (1.0, -0.1)])
            .with(Property::Twist, 0.2);
        let expected = [
            "distribution.r: not used: no property is a list on these radii",
            "distribution.mass_offset: acts in torsion only",
            "distribution.twist: not used by the uncoupled solver",
        ];
        assert_eq!(told(&both), expected);
        assert_eq!(check(&both).unwrap().twist().at(0.5), 0.2);
    }

    #[test]
    fn what_the_model_uses_is_told_apart_from_what_it_does_not() {
        assert!(Model::UNCOUPLED.uses(Property::MassOffset) && Model::UNCOUPLED.uses(Property::Mass));
        assert!(!Model::UNCOUPLED.uses(Property::Twist));
        assert_eq!(MODEL, "uncoupled, in vacuum, zero pitch, the paper's torsion term");
    }
}
