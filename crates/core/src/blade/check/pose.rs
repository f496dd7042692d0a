//! How the blade stands on its rotor: pitch, precone, torque offset and the angle of its springs.

use super::{CheckedRoot, Checker, Length, NEAR, Range};
use crate::blade::definition::{RotorDefinition, SpringAngle};
use crate::blade::model::Pose;
use crate::fault::FaultCode;
use crate::figures::{Shortest, shortest};
use alloc::format;

/// As twist, which pitch is added to.
const ANGLE: Range = Range::up_to(1e6, "rad");
/// At a right angle the blade would lie on the rotor's axis.
const PRECONE: Range = Range::up_to(1.5, "rad");
const OFFSET: Range = Range::up_to(1e6, "m");

const SPRING_ANGLE: (&str, &str) = ("rotor.spring_angle", "spring angle");

impl Checker {
    /// What is absent is 0; none where a number is faulty.
    pub(super) fn pose(&mut self, rotor: Option<&RotorDefinition>) -> Option<Pose> {
        let rotor = rotor?;
        let (angle, length) = (self.units.angle.si(), self.units.length.si());
        let mut number = |(path, subject): (&str, &str), given: Option<f64>, factor: f64, range: Range| match given {
            Some(given) => self.number(&path, &subject, given, factor, range),
            None => Some(0.0),
        };
        let pitch = number(("rotor.pitch", "pitch"), rotor.pitch, angle, ANGLE);
        let precone = number(("rotor.precone", "precone"), rotor.precone, angle, PRECONE);
        let offset = number(("rotor.torque_offset", "torque offset"), rotor.torque_offset, length, OFFSET);
        let spring_angle = match rotor.spring_angle.unwrap_or_default() {
            SpringAngle::Pitch => Some(SpringAngle::Pitch),
            SpringAngle::Angle(given) => number(SPRING_ANGLE, Some(given), angle, ANGLE).map(SpringAngle::Angle),
        };
        Some(Pose { pitch: pitch?, precone: precone?, torque_offset: offset?, spring_angle: spring_angle? })
    }

    /// Springs that are turned couple flap and lag, so they must lie at one radius.
    pub(super) fn turned_springs(
        &mut self,
        rotor: Option<&RotorDefinition>,
        radius: Option<Length>,
        [flap, lag, _]: &[CheckedRoot; 3],
    ) {
        let value = match rotor.and_then(|rotor| rotor.spring_angle) {
            None => return,
            Some(SpringAngle::Angle(angle)) if angle == 0.0 || !angle.is_finite() => return,
            Some(SpringAngle::Angle(angle)) => shortest(angle),
            Some(SpringAngle::Pitch) => SpringAngle::PITCH.into(),
        };
        let (Some(radius), Some(flap), Some(lag)) = (radius, flap.offset, lag.offset) else { return };
        if (flap.si - lag.si).abs() > NEAR * radius.si {
            let rule = format!(
                "must be 0 where the roots of flap and lag are at different radii, {} and {} {}",
                Shortest(flap.given),
                Shortest(lag.given),
                self.units.length
            );
            let (path, subject) = SPRING_ANGLE;
            self.refuse(FaultCode::Conflict, path, Some(value), subject, &rule);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::blade::check::tests::definition;
    use crate::blade::{BladeDefinition, RootDefinition, SpringAngle, check};
    use crate::units::{AngleUnit, LengthUnit, Units};
    use alloc::format;
    use alloc::string::{String, ToString};

    fn refused(given: &BladeDefinition) -> String {
        check(given).unwrap_err().to_string()
    }

    #[test]
    fn what_is_not_given_is_zero() {
        let blade = check(&definition()).unwrap();
        assert_eq!((blade.pitch(), blade.precone(), blade.torque_offset()), (0.0, 0.0, 0.0));
        assert_eq!(blade.spring_angle(), SpringAngle::Angle(0.0));
    }

    #[test]
    fn angles_and_offsets_are_converted() {
        let units = Units { length: LengthUnit::Millimetre, angle: AngleUnit::Degree, ..Units::default() };
        let given = definition()
            .in_units(units)
            .with_pitch(8.0)
            .with_precone(-2.5)
            .with_torque_offset(-0.25)
            .with_spring_angle(SpringAngle::Angle(90.0));
        let degree = AngleUnit::Degree.si();
        let blade = check(&given).unwrap();
        assert_eq!((blade.pitch(), blade.precone()), (8.0 * degree, -2.5 * degree));
        assert_eq!(blade.torque_offset(), -0.25 * 1e-3);
        assert_eq!(blade.spring_angle(), SpringAngle::Angle(90.0 * degree));
        let turning = check(&given.with_spring_angle(SpringAngle::Pitch)).unwrap();
        assert_eq!(turning.spring_angle(), SpringAngle::Pitch);
    }

    #[test]
    fn numbers_out_of_range_are_refused() {
        let cases = [
            (definition().with_pitch(f64::NAN), "rotor.pitch: pitch must be finite (is NaN)"),
            (definition().with_pitch(2e6), "rotor.pitch: pitch must be from -1e6 to 1e6 rad (is 2000000)"),
            (definition().with_precone(-1.6), "rotor.precone: precone must be from -1.5 to 1.5 rad (is -1.6)"),
            (
                definition().with_torque_offset(1e7),
                "rotor.torque_offset: torque offset must be from -1e6 to 1e6 m (is 10000000)",
            ),
            (
                definition().with_spring_angle(SpringAngle::Angle(f64::INFINITY)),
                "rotor.spring_angle: spring angle must be finite (is inf)",
            ),
        ];
        for (given, message) in cases {
            assert_eq!(refused(&given), message);
        }
        let degrees = Units { angle: AngleUnit::Degree, ..Units::default() };
        assert!(check(&definition().in_units(degrees).with_precone(85.0)).is_ok(), "degrees are no radians");
    }

    #[test]
    fn turned_springs_lie_at_one_radius() {
        let apart = definition().with_lag(RootDefinition::hinged(0.25));
        for (angle, value) in [(SpringAngle::Pitch, "pitch"), (SpringAngle::Angle(0.1), "0.1")] {
            assert!(check(&definition().with_spring_angle(angle)).is_ok());
            let message = format!(
                "rotor.spring_angle: spring angle must be 0 where the roots of flap and lag are at different radii, \
                 0 and 0.25 m (is {value})"
            );
            assert_eq!(refused(&apart.clone().with_spring_angle(angle)), message);
        }
        assert!(check(&apart.with_spring_angle(SpringAngle::Angle(0.0))).is_ok(), "0 is what absent means");
        // The same radius, once as a ratio: apart by rounding at most.
        let ratio = RootDefinition { offset: None, offset_ratio: Some(0.15), ..RootDefinition::hinged(0.0) };
        let same = definition().with_flap(ratio).with_lag(RootDefinition::hinged(0.3));
        assert!(check(&same.with_spring_angle(SpringAngle::Pitch)).is_ok());
    }
}
