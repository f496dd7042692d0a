//! What is solved: the model in words, and what of a blade it does not use.

use super::Settings;
use crate::blade::{Blade, PointMass, PropellerMoment, Property, Racket, SpringAngle};
use crate::fault::{Fault, FaultCode, Faults, Warning};
use crate::figures::short;
use crate::report::ModelReport;
use alloc::borrow::Cow;
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
/// What polar inertia alone is to the full propeller moment.
pub(super) const THIN: &str = "taken for a thin section: all of it in the chord plane";

/// How much of a property acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Use {
    Partly,
    None,
    /// Only in the polar inertia, where that is not given.
    InSum,
}

impl Model {
    /// Flap, lag and torsion apart, with the paper's propeller moment.
    pub const UNCOUPLED: Self = Self::uncoupled(PropellerMoment::Paper);

    /// Flap, lag and torsion apart.
    pub const fn uncoupled(moment: PropellerMoment) -> Self {
        match moment {
            PropellerMoment::Paper => Self::PAPER,
            PropellerMoment::Full => Self {
                words: "uncoupled, in vacuum, zero pitch, no rotary inertia, no trapeze, full propeller moment",
                ..Self::PAPER
            },
        }
    }

    /// The uncoupled model with what settings ask for.
    pub fn of(settings: &Settings) -> Self {
        Self::uncoupled(settings.propeller_moment.unwrap_or(PropellerMoment::Paper))
    }

    const PAPER: Self = Self {
        words: "uncoupled, in vacuum, zero pitch, no rotary inertia, no trapeze, the paper's torsion term",
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
        let full = blade.racket() != Racket::Paper;
        let partly = if blade.has_torsion() { IN_TORSION } else { NOT_USED };
        let acts = |property: Property| blade.property(property).values().iter().any(|&value| value != 0.0);
        let remarks = self.remarks.iter().filter(|(property, ..)| acts(*property));
        let of_properties = remarks.map(|&(property, how, message)| {
            let unused = how == Use::Partly && (full || !blade.has_torsion());
            let message = if unused { NOT_USED } else { message };
            let in_sum = how == Use::InSum && (!blade.gives(Property::PolarInertia) || full);
            (format!("distribution.{}", property.key()), if in_sum { IN_TORSION } else { message })
        });
        let mut told: Vec<(String, &str)> = Vec::new();
        if self.ignores_pose {
            told.extend(pose(blade).map(|path| (path.into(), NOT_USED)));
        }
        told.extend(of_properties);
        if full && !blade.inertias_given() && blade.has_torsion() {
            told.push(("distribution.polar_inertia".into(), THIN));
        }
        let offset = |mass: &PointMass| mass.offset != 0.0 && mass.mass != 0.0;
        if self.ignores_pose && blade.point_masses().iter().any(offset) {
            told.push(("point_mass.offset".into(), partly));
        }
        told.into_iter().map(|(path, message)| Warning { path, message: message.to_string() }).collect()
    }
}

/// Whether flap, lag and torsion of a blade feel one another, at the blade's own pitch and precone or at these.
pub fn couples(blade: &Blade, pitch: Option<f64>, precone: Option<f64>) -> bool {
    let acts = |property: &Property| blade.property(*property).values().iter().any(|value| *value != 0.0);
    let turned = match blade.spring_angle() {
        SpringAngle::Angle(angle) => angle != 0.0,
        // With twist or pitch, which couple anyway.
        SpringAngle::Pitch => false,
    };
    [Property::Twist, Property::MassOffset, Property::TensionOffset].iter().any(acts)
        || pitch.unwrap_or_else(|| blade.pitch()) != 0.0
        || precone.unwrap_or_else(|| blade.precone()) != 0.0
        || blade.torque_offset() != 0.0
        || turned
        || blade.point_masses().iter().any(|mass| mass.mass != 0.0 && mass.offset != 0.0)
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

/// The uncoupled model of a blade.
pub(super) fn uncoupled(blade: &Blade, settings: &Settings) -> ModelReport {
    let unused = warnings(blade).into_iter().skip(blade.warnings().len()).map(|warning| warning.path).collect();
    let moment = settings.propeller_moment.unwrap_or(PropellerMoment::Paper);
    ModelReport::uncoupled(Model::of(settings).words(), moment.name(), unused)
}

/// A blade as the uncoupled model takes it: with the propeller moment of the settings.
///
/// # Errors
/// Inertias of no section, of which the full moment would be made.
pub(super) fn turning<'a>(blade: &'a Blade, settings: &Settings) -> Result<Cow<'a, Blade>, Faults> {
    if settings.propeller_moment != Some(PropellerMoment::Full) {
        return Ok(Cow::Borrowed(blade));
    }
    let fault = |r: f64| {
        let rule = "must be at least flap_inertia less lag_inertia with the full propeller moment";
        let message = format!("polar inertia {rule} (at r = {} m it is not)", short(r, 4));
        Fault::new(FaultCode::OutOfRange, "distribution.polar_inertia", None, rule, message).into()
    };
    blade.with_full_propeller_moment().map(Cow::Owned).map_err(fault)
}

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
            crate::modes(&check(&given).unwrap(), &Settings::default()).unwrap().modes,
            crate::modes(&check(&blade()).unwrap(), &Settings::default()).unwrap().modes,
        );
    }

    #[test]
    fn the_full_propeller_moment_uses_inertias_that_a_section_can_have() {
        let full = Settings { propeller_moment: Some(PropellerMoment::Full), ..Settings::default() };
        let turned = |given: &BladeDefinition| turning(&check(given).unwrap(), &full).map(Cow::into_owned);
        let told = |given: &BladeDefinition| -> Vec<String> {
            warnings(&turned(given).unwrap()).iter().map(ToString::to_string).collect()
        };
        let thin = "distribution.polar_inertia: taken for a thin section: all of it in the chord plane";
        assert_eq!(told(&blade()), [thin]);
        let both = |flap: f64, lag: f64| blade().with(Property::FlapInertia, flap).with(Property::LagInertia, lag);
        let expected =
            ["distribution.flap_inertia: acts in torsion only", "distribution.lag_inertia: acts in torsion only"];
        assert_eq!(told(&both(0.75, 0.25)), expected);
        for (flap, lag, racket) in [(0.25, 0.75, Racket::Flat), (0.75, 0.25, Racket::Steep), (1.0, 0.0, Racket::Steep)]
        {
            assert_eq!(turned(&both(flap, lag)).unwrap().racket(), racket);
        }
        let message = "distribution.polar_inertia: polar inertia must be at least flap_inertia less lag_inertia with \
                       the full propeller moment (at r = 0 m it is not)";
        assert_eq!(turned(&both(1.5, 0.25)).unwrap_err().to_string(), message);
        assert!(
            crate::modes(&check(&both(1.5, 0.25)).unwrap(), &Settings::default()).is_ok(),
            "the paper's needs none"
        );
        assert!(Model::of(&full).words().ends_with("no trapeze, full propeller moment"));
        assert_eq!(Model::of(&Settings::default()), Model::UNCOUPLED);
    }

    #[test]
    fn what_the_model_uses_is_told_apart_from_what_it_does_not() {
        assert!(Model::UNCOUPLED.uses(Property::MassOffset) && Model::UNCOUPLED.uses(Property::Mass));
        assert!(!Model::UNCOUPLED.uses(Property::Twist));
        assert_eq!(MODEL, "uncoupled, in vacuum, zero pitch, no rotary inertia, no trapeze, the paper's torsion term");
    }
}
