//! The same blade with its numbers in other units.

use super::{
    BladeDefinition, DistributionDefinition, PointMassDefinition, Property, PropertyDefinition, RootDefinition,
    RotorDefinition, SpringAngle,
};
use crate::units::Units;
use alloc::format;
use alloc::vec::Vec;

/// The same blade in other units. A number whose unit stays keeps all its bits; every other one is
/// rounded to 15 significant digits, so that 55 in are 1.397 m and not 1.3970000000000002 m. Equal
/// numbers of one quantity stay equal and ordered ones ordered, so stations and steps stay what
/// they are. What is missing stays missing; nothing is checked.
pub fn convert(definition: &BladeDefinition, units: Units) -> BladeDefinition {
    let factors = Factors { from: definition.units, to: units };
    BladeDefinition {
        name: definition.name.clone(),
        notes: definition.notes.clone(),
        source: definition.source.clone(),
        units,
        rotor: definition.rotor.map(|rotor| factors.rotor(rotor)),
        flap: definition.flap.map(|root| factors.root(root)),
        lag: definition.lag.map(|root| factors.root(root)),
        torsion: definition.torsion.map(|root| factors.root(root)),
        distribution: definition.distribution.as_ref().map(|given| factors.distribution(given)),
        point_masses: definition.point_masses.iter().map(|mass| factors.point_mass(*mass)).collect(),
    }
}

/// How many SI units one unit of a quantity is.
pub(super) type Quantity = fn(&Units) -> f64;

pub(super) const LENGTH: Quantity = |units| units.length.si();
const ANGLE: Quantity = |units| units.angle.si();
pub(super) const SPEED: Quantity = |units| units.speed.si();

/// From one set of units to another.
#[derive(Clone, Copy)]
pub(super) struct Factors {
    pub(super) from: Units,
    pub(super) to: Units,
}

impl Factors {
    pub(super) fn number(self, value: f64, quantity: impl Fn(&Units) -> f64) -> f64 {
        let (from, to) = (quantity(&self.from), quantity(&self.to));
        if from.to_bits() == to.to_bits() { value } else { rounded(value * from / to) }
    }

    fn list(self, values: &[f64], quantity: impl Fn(&Units) -> f64 + Copy) -> Vec<f64> {
        values.iter().map(|&value| self.number(value, quantity)).collect()
    }

    fn rotor(self, rotor: RotorDefinition) -> RotorDefinition {
        RotorDefinition {
            radius: rotor.radius.map(|value| self.number(value, LENGTH)),
            nominal_speed: rotor.nominal_speed.map(|value| self.number(value, SPEED)),
            blades: rotor.blades,
            pitch: rotor.pitch.map(|value| self.number(value, ANGLE)),
            precone: rotor.precone.map(|value| self.number(value, ANGLE)),
            torque_offset: rotor.torque_offset.map(|value| self.number(value, LENGTH)),
            spring_angle: rotor.spring_angle.map(|angle| match angle {
                SpringAngle::Angle(value) => SpringAngle::Angle(self.number(value, ANGLE)),
                SpringAngle::Pitch => SpringAngle::Pitch,
            }),
        }
    }

    fn root(self, root: RootDefinition) -> RootDefinition {
        RootDefinition {
            root: root.root,
            offset: root.offset.map(|value| self.number(value, LENGTH)),
            offset_ratio: root.offset_ratio,
            spring: root.spring.map(|value| self.number(value, Units::spring)),
        }
    }

    fn point_mass(self, given: PointMassDefinition) -> PointMassDefinition {
        PointMassDefinition {
            r: given.r.map(|value| self.number(value, LENGTH)),
            mass: given.mass.map(|value| self.number(value, |units| units.mass.si())),
            offset: given.offset.map(|value| self.number(value, LENGTH)),
            flap_inertia: given.flap_inertia.map(|value| self.number(value, Units::inertia)),
            lag_inertia: given.lag_inertia.map(|value| self.number(value, Units::inertia)),
        }
    }

    fn property(self, property: &PropertyDefinition, quantity: impl Fn(&Units) -> f64 + Copy) -> PropertyDefinition {
        match property {
            PropertyDefinition::Uniform(value) => PropertyDefinition::Uniform(self.number(*value, quantity)),
            PropertyDefinition::OnStations(values) => PropertyDefinition::OnStations(self.list(values, quantity)),
            PropertyDefinition::OwnRadii { r, values } => {
                PropertyDefinition::OwnRadii { r: self.list(r, LENGTH), values: self.list(values, quantity) }
            }
        }
    }

    fn distribution(self, given: &DistributionDefinition) -> DistributionDefinition {
        DistributionDefinition {
            r: given.r.as_ref().map(|radii| self.list(radii, LENGTH)),
            properties: Property::ALL.map(|property| {
                let given = given[property].as_ref()?;
                Some(self.property(given, |units| property.unit(units)))
            }),
        }
    }
}

/// `value` to 15 significant digits, which every f64 holds; what is not finite stays as it is.
fn rounded(value: f64) -> f64 {
    if value.is_finite() { format!("{value:.14e}").parse().unwrap_or(value) } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{AngleUnit, ForceUnit, LengthUnit, MassUnit, SpeedUnit};
    use alloc::vec;

    #[test]
    fn inches_become_the_metres_that_a_person_would_write_and_come_back() {
        let inches = Units {
            length: LengthUnit::Inch,
            mass: MassUnit::Pound,
            force: ForceUnit::PoundForce,
            speed: SpeedUnit::Rpm,
            ..Units::default()
        };
        let rotor = RotorDefinition {
            radius: Some(55.0),
            nominal_speed: Some(660.0),
            blades: Some(4.0),
            ..RotorDefinition::default()
        };
        let mut distribution =
            DistributionDefinition { r: Some(vec![0.0, 3.0, 3.0, 55.0, f64::NAN]), ..Default::default() };
        distribution[Property::Mass] = Some(PropertyDefinition::Uniform(1.0));
        let given = BladeDefinition {
            units: inches,
            rotor: Some(rotor),
            distribution: Some(distribution),
            ..BladeDefinition::default()
        };
        let metres = convert(&given, Units::default());
        let rotor = metres.rotor.unwrap();
        assert_eq!((rotor.radius, rotor.blades), (Some(1.397), Some(4.0)));
        assert_eq!(rotor.nominal_speed, Some(69.115_038_378_975_4));
        let distribution = metres.distribution.as_ref().unwrap();
        let radii = distribution.r.as_ref().unwrap();
        assert_eq!(radii[..4], [0.0, 0.0762, 0.0762, 1.397]);
        assert!(radii[4].is_nan(), "what is no number stays none");
        assert_eq!(distribution[Property::Mass], Some(PropertyDefinition::Uniform(17.857_967_322_834_6)));
        assert_eq!(
            (metres.flap, distribution[Property::Twist].as_ref()),
            (None, None),
            "what is missing stays missing"
        );

        let back = convert(&metres, inches);
        assert_eq!(back.rotor, given.rotor);
        let Some(PropertyDefinition::Uniform(mass)) = back.distribution.unwrap()[Property::Mass] else {
            panic!("one number")
        };
        assert!((mass - 1.0).abs() < 1e-14, "17.8579673228346 kg/m is 1 lb/in to 15 digits: {mass}");
    }

    #[test]
    fn what_stands_on_the_rotor_and_point_masses_are_converted() {
        let units = Units {
            length: LengthUnit::Millimetre,
            mass: MassUnit::Gram,
            angle: AngleUnit::Degree,
            ..Units::default()
        };
        let given = BladeDefinition::new("", 1.0, 1.0)
            .with_pitch(core::f64::consts::PI)
            .with_precone(-0.5)
            .with_torque_offset(0.25)
            .with_spring_angle(SpringAngle::Angle(core::f64::consts::FRAC_PI_2))
            .with_point_mass(PointMassDefinition::new(0.5, 2.0).with_offset(-0.125).with_inertias(3.0, 4.0));
        let converted = convert(&given, units);
        let rotor = converted.rotor.unwrap();
        assert_eq!((rotor.pitch, rotor.precone), (Some(180.0), Some(-28.647_889_756_541_2)));
        assert_eq!((rotor.torque_offset, rotor.spring_angle), (Some(250.0), Some(SpringAngle::Angle(90.0))));
        let mass = PointMassDefinition::new(500.0, 2000.0).with_offset(-125.0).with_inertias(3e9, 4e9);
        assert_eq!(converted.point_masses, [mass]);
        let turning = convert(&given.clone().with_spring_angle(SpringAngle::Pitch), units);
        assert_eq!(turning.rotor.unwrap().spring_angle, Some(SpringAngle::Pitch));
        assert_eq!(convert(&given, Units::default()), given, "numbers whose unit stays keep their bits");
    }

    #[test]
    fn numbers_whose_unit_stays_keep_their_bits() {
        let rotor =
            RotorDefinition { radius: Some(0.1 + 0.2), nominal_speed: Some(1.0 / 3.0), ..RotorDefinition::default() };
        let given = BladeDefinition { rotor: Some(rotor), ..BladeDefinition::default() };
        assert_eq!(convert(&given, Units::default()), given);
        let rpm = convert(&given, Units { speed: SpeedUnit::Rpm, ..Units::default() });
        assert_eq!(rpm.rotor.unwrap().radius, Some(0.1 + 0.2));
    }
}
