//! What is solved: the model in words, and what of a blade it does not use.

use crate::blade::{Blade, PointMass, Property, SpringAngle};
use crate::fault::Warning;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// What is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Model {
    words: &'static str,
    /// Properties of which something does not act, and what to say where they are not 0.
    remarks: &'static [(Property, Use, &'static str)],
    /// Whether pitch, precone, torque offset and the angle of the springs do not act, and the offset of a point mass
    /// in torsion only.
    ignores_pose: bool,
}

const NOT_USED: &str = "not used by the uncoupled solver";
const IN_TORSION: &str = "acts in torsion only";

/// How much of a property acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Use {
    Partly,
    None,
    /// Only in the polar inertia, where that is not given.
    InSum,
}

impl Model {
    /// Flap, lag and torsion apart.
    pub const UNCOUPLED: Self = Self {
        words: "uncoupled, in vacuum, zero pitch, the paper's torsion term",
        remarks: &[
            (Property::FlapInertia, Use::InSum, NOT_USED),
            (Property::LagInertia, Use::InSum, NOT_USED),
            (Property::MassOffset, Use::Partly, IN_TORSION),
            (Property::Twist, Use::None, NOT_USED),
            (Property::TensionOffset, Use::None, NOT_USED),
            (Property::AxialStiffness, Use::None, NOT_USED),
            (Property::TrapezeRadius, Use::None, NOT_USED),
        ],
        ignores_pose: true,
    };

    /// One plain line that says what the model is; it stands with every table and chart.
    pub const fn words(&self) -> &'static str {
        self.words
    }

    /// Whether a property acts at all, and not through another.
    pub fn uses(&self, property: Property) -> bool {
        !self.remarks.iter().any(|&(other, how, _)| other == property && how != Use::Partly)
    }

    /// What of a blade does not act, or not as its author may expect, because of the model.
    pub fn unused(&self, blade: &Blade) -> Vec<Warning> {
        let acts = |property: Property| blade.property(property).values().iter().any(|&value| value != 0.0);
        let remarks = self.remarks.iter().filter(|(property, ..)| acts(*property));
        let of_properties = remarks.map(|&(property, how, message)| {
            let in_sum = how == Use::InSum && !blade.gives(Property::PolarInertia);
            (format!("distribution.{}", property.key()), if in_sum { IN_TORSION } else { message })
        });
        let mut told: Vec<(String, &str)> = Vec::new();
        if self.ignores_pose {
            told.extend(pose(blade).map(|path| (path.into(), NOT_USED)));
        }
        told.extend(of_properties);
        let offset = |mass: &PointMass| mass.offset != 0.0 && mass.mass != 0.0;
        if self.ignores_pose && blade.point_masses().iter().any(offset) {
            told.push(("point_mass.offset".into(), IN_TORSION));
        }
        told.into_iter().map(|(path, message)| Warning { path, message: message.to_string() }).collect()
    }
}

/// How the blade stands on its rotor: what of it is not 0.
fn pose(blade: &Blade) -> impl Iterator<Item = &'static str> {
    [
        ("rotor.pitch", blade.pitch() != 0.0),
        ("rotor.precone", blade.precone() != 0.0),
        ("rotor.torque_offset", blade.torque_offset() != 0.0),
        ("rotor.spring_angle", blade.spring_angle() != SpringAngle::Angle(0.0)),
    ]
    .into_iter()
    .filter_map(|(path, acts)| acts.then_some(path))
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
    use crate::blade::{BladeDefinition, PointMassDefinition, RootDefinition, check};

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
    fn what_only_coupled_motion_feels_is_told() {
        let nothing = PointMassDefinition::new(1.0, 0.0).with_offset(0.1);
        let zero = blade()
            .with_pitch(0.0)
            .with_precone(-0.0)
            .with_torque_offset(0.0)
            .with_spring_angle(SpringAngle::Angle(0.0))
            .with_point_mass(nothing)
            .with(Property::FlapInertia, 0.0)
            .with(Property::LagInertia, 0.0)
            .with(Property::TensionOffset, 0.0)
            .with(Property::TrapezeRadius, 0.0);
        assert!(told(&zero).is_empty(), "0 acts nowhere: {:?}", told(&zero));
        let all = zero
            .with_pitch(0.1)
            .with_precone(0.1)
            .with_torque_offset(0.1)
            .with_spring_angle(SpringAngle::Pitch)
            .with_point_mass(PointMassDefinition::new(1.0, 2.0).with_offset(0.1))
            .with(Property::FlapInertia, 0.1)
            .with(Property::LagInertia, 0.1)
            .with(Property::TensionOffset, -0.1)
            .with(Property::TrapezeRadius, 0.1);
        let expected = [
            "rotor.pitch: not used by the uncoupled solver",
            "rotor.precone: not used by the uncoupled solver",
            "rotor.torque_offset: not used by the uncoupled solver",
            "rotor.spring_angle: not used by the uncoupled solver",
            "distribution.flap_inertia: not used by the uncoupled solver",
            "distribution.lag_inertia: not used by the uncoupled solver",
            "distribution.tension_offset: not used by the uncoupled solver",
            "distribution.trapeze_radius: not used by the uncoupled solver",
            "point_mass.offset: acts in torsion only",
        ];
        assert_eq!(told(&all), expected);
        let stiff = blade().with(Property::AxialStiffness, 5e8);
        assert_eq!(told(&stiff), ["distribution.axial_stiffness: not used by the uncoupled solver"]);
    }

    /// Where the polar inertia is their sum, that is what they are to a model without coupling.
    #[test]
    fn inertias_that_stand_for_the_polar_one_act_in_torsion() {
        let mut given = blade().with(Property::FlapInertia, 0.25).with(Property::LagInertia, 0.75);
        given.distribution.as_mut().unwrap()[Property::PolarInertia] = None;
        let expected =
            ["distribution.flap_inertia: acts in torsion only", "distribution.lag_inertia: acts in torsion only"];
        assert_eq!(told(&given), expected);
        assert!(!Model::UNCOUPLED.uses(Property::FlapInertia), "its stations are those of the sum");
        assert_eq!(
            crate::modes(&check(&given).unwrap(), &crate::Settings::default()).unwrap().modes,
            crate::modes(&check(&blade()).unwrap(), &crate::Settings::default()).unwrap().modes,
        );
    }

    #[test]
    fn what_the_model_uses_is_told_apart_from_what_it_does_not() {
        assert!(Model::UNCOUPLED.uses(Property::MassOffset) && Model::UNCOUPLED.uses(Property::Mass));
        assert!(!Model::UNCOUPLED.uses(Property::Twist));
        assert_eq!(MODEL, "uncoupled, in vacuum, zero pitch, the paper's torsion term");
    }
}
