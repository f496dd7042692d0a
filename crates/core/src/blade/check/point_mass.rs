//! Masses at one radius.

use super::{CheckedRoot, Checker, Length, NEAR, Range};
use crate::blade::definition::PointMassDefinition;
use crate::blade::model::PointMass;
use crate::fault::FaultCode;
use crate::figures::{Shortest, shortest};
use crate::units::Units;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

const MASS: Range = Range::zero_or(1e-30, 1e30, "kg");
const INERTIA: Range = Range::zero_or(1e-30, 1e30, "kg·m²");
const OFFSET: Range = Range::up_to(1e6, "m");

impl Checker {
    /// Checks the point masses: those that are sound, by ascending radius.
    pub(super) fn point_masses(
        &mut self,
        given: &[PointMassDefinition],
        radius: Option<Length>,
        roots: &[CheckedRoot; 3],
    ) -> Vec<PointMass> {
        if self.too_long("point_mass", given.len(), "list of point masses") {
            return Vec::new();
        }
        let offsets = roots.iter().map(|root| root.offset).collect::<Option<Vec<Length>>>();
        let least = offsets.and_then(|offsets| offsets.into_iter().reduce(|a, b| if b.si < a.si { b } else { a }));
        let ends = least.zip(radius);
        let masses = given.iter().enumerate();
        let mut sound: Vec<PointMass> =
            masses.filter_map(|(i, given)| self.point_mass(&format!("point_mass[{i}]"), given, ends)).collect();
        sound.sort_by(|a, b| a.r.total_cmp(&b.r));
        sound
    }

    fn point_mass(
        &mut self,
        path: &str,
        given: &PointMassDefinition,
        ends: Option<(Length, Length)>,
    ) -> Option<PointMass> {
        let (length, mass, inertia) = (self.units.length.si(), self.units.mass.si(), self.units.inertia());
        let r = self.radius_of_point_mass(path, given.r, ends);
        let mut number = |key: &str, subject: &str, given: f64, factor: f64, range: Range| {
            self.number(&format_args!("{path}.{key}"), &subject, given, factor, range)
        };
        let kg = given.mass.map(|given| number("mass", "point mass", given, mass, MASS));
        let offset = number("offset", "point mass offset", given.offset.unwrap_or(0.0), length, OFFSET);
        let flap = given.flap_inertia.unwrap_or(0.0);
        let flap = number("flap_inertia", "point mass flap inertia", flap, inertia, INERTIA);
        let lag = given.lag_inertia.map(|lag| number("lag_inertia", "point mass lag inertia", lag, inertia, INERTIA));
        if kg.is_none() {
            self.missing(&format!("{path}.mass"), "point mass");
        }
        let (mass, offset, flap_inertia) = (kg??, offset?, flap?);
        let of_offset = mass * offset * offset;
        let lag_inertia = match lag {
            None => of_offset,
            Some(lag) => {
                let lag = lag?;
                // Numbers that were rounded to be written are as good.
                if flap_inertia + lag < of_offset * (1.0 - NEAR) {
                    self.light(path, given);
                    return None;
                }
                lag
            }
        };
        Some(PointMass { r: r?, mass, offset, flap_inertia, lag_inertia })
    }

    /// A radius on the blade; one that rounding has moved off it lies on its end.
    fn radius_of_point_mass(&mut self, path: &str, given: Option<f64>, ends: Option<(Length, Length)>) -> Option<f64> {
        let (path, subject) = (format!("{path}.r"), "point mass radius");
        let Some(given) = given else {
            self.missing(&path, subject);
            return None;
        };
        let r = self.number(&path, &subject, given, self.units.length.si(), Range::NOT_NEGATIVE)?;
        let (least, radius) = ends?;
        let near = NEAR * radius.si;
        if r < least.si - near || r > radius.si + near {
            let (from, to, unit) = (Shortest(least.given), Shortest(radius.given), self.units.length);
            let rule = format!("must be on the blade, from {from} to {to} {unit}");
            self.refuse(FaultCode::OutOfRange, &path, Some(shortest(given)), subject, &rule);
            return None;
        }
        Some(r.clamp(least.si, radius.si))
    }

    /// No body has less inertia about an axis than its mass at its centre.
    fn light(&mut self, path: &str, given: &PointMassDefinition) {
        let value = |number: Option<f64>| number.unwrap_or(0.0);
        let Units { length, mass, .. } = self.units;
        let least = value(given.mass) * value(given.offset) * value(given.offset);
        let flap = given.flap_inertia.map(|_| ", with flap_inertia,").unwrap_or_default();
        let rule = format!("must be{flap} at least mass·offset², {} {mass}·{length}²", shortest(least));
        let value: Option<String> = given.lag_inertia.map(shortest);
        let path = format!("{path}.lag_inertia");
        self.refuse(FaultCode::OutOfRange, &path, value, "point mass lag inertia", &rule);
    }
}

#[cfg(test)]
mod tests {
    use crate::blade::check::tests::definition;
    use crate::blade::{BladeDefinition, PointMass, PointMassDefinition, RootDefinition, check};
    use crate::units::{LengthUnit, MassUnit, Units};
    use alloc::format;
    use alloc::string::ToString;
    use alloc::vec;
    use alloc::vec::Vec;

    const TIP: PointMassDefinition = PointMassDefinition::new(2.0, 0.5);

    fn masses(given: &BladeDefinition) -> Vec<PointMass> {
        check(given).unwrap().point_masses().to_vec()
    }

    #[test]
    fn masses_are_converted_completed_and_sorted() {
        let units = Units { length: LengthUnit::Millimetre, mass: MassUnit::Gram, ..Units::default() };
        let given = definition()
            .in_units(units)
            .with_point_mass(TIP.with_offset(-0.5))
            .with_point_mass(PointMassDefinition::new(1.0, 3.0).with_offset(2.0).with_inertias(4.0, 8.0));
        let inertia = 1e-3 * 1e-3 * 1e-3;
        let expected = [
            PointMass { r: 1e-3, mass: 3e-3, offset: 2e-3, flap_inertia: 4.0 * inertia, lag_inertia: 8.0 * inertia },
            PointMass {
                r: 2e-3,
                mass: 0.5e-3,
                offset: -0.5e-3,
                flap_inertia: 0.0,
                lag_inertia: 0.5e-3 * (-0.5e-3) * (-0.5e-3),
            },
        ];
        assert_eq!(masses(&given), expected);
        assert!(masses(&definition()).is_empty());
        let nothing = PointMassDefinition::new(1.0, 0.0);
        assert_eq!(masses(&definition().with_point_mass(nothing))[0].mass, 0.0, "a mass may be 0");
    }

    #[test]
    fn a_mass_lies_on_the_blade() {
        let rooted = || {
            definition()
                .with_flap(RootDefinition::hinged(0.5))
                .with_lag(RootDefinition::hinged(0.25))
                .with_torsion(RootDefinition::rigid(0.5))
        };
        let at = |r: f64| check(&rooted().with_point_mass(PointMassDefinition::new(r, 1.0)));
        assert_eq!(at(0.25).unwrap().point_masses()[0].r, 0.25);
        assert_eq!(at(2.0 + 1e-10).unwrap().point_masses()[0].r, 2.0, "moved there by rounding");
        for (r, value) in [(0.2, "0.2"), (2.1, "2.1")] {
            let message =
                format!("point_mass[0].r: point mass radius must be on the blade, from 0.25 to 2 m (is {value})");
            assert_eq!(at(r).unwrap_err().to_string(), message);
        }
        let negative = "point_mass[0].r: point mass radius must be at least 0 (is -1)";
        assert_eq!(at(-1.0).unwrap_err().to_string(), negative);
    }

    #[test]
    fn every_number_of_a_mass_has_its_fault() {
        let bad = PointMassDefinition {
            r: None,
            mass: Some(-1.0),
            offset: Some(f64::NAN),
            flap_inertia: Some(1e31),
            lag_inertia: Some(-2.0),
        };
        let given =
            definition().with_point_mass(TIP).with_point_mass(bad).with_point_mass(PointMassDefinition::default());
        let expected = "point_mass[1].r: point mass radius must be given\n\
                        point_mass[1].mass: point mass must be at least 0 (is -1)\n\
                        point_mass[1].offset: point mass offset must be finite (is NaN)\n\
                        point_mass[1].flap_inertia: point mass flap inertia must be 0 or from 1e-30 to 1e30 kg·m² (is 1e31)\n\
                        point_mass[1].lag_inertia: point mass lag inertia must be at least 0 (is -2)\n\
                        point_mass[2].r: point mass radius must be given\n\
                        point_mass[2].mass: point mass must be given";
        assert_eq!(check(&given).unwrap_err().to_string(), expected);
    }

    #[test]
    fn inertias_contain_the_offset() {
        let with = |flap, lag| check(&definition().with_point_mass(TIP.with_offset(0.2).with_inertias(flap, lag)));
        // 0.5 kg at 0.2 m has 0.02 kg·m², but for rounding.
        for (flap, lag) in [(0.0, 0.02), (0.015, 0.005), (0.0, 0.02 * (1.0 - 1e-10))] {
            assert_eq!(with(flap, lag).unwrap().point_masses()[0].lag_inertia, lag);
        }
        let message = "point_mass[0].lag_inertia: point mass lag inertia must be, with flap_inertia, at least \
                       mass·offset², 0.020000000000000004 kg·m² (is 0.009)";
        assert_eq!(with(0.01, 0.009).unwrap_err().to_string(), message);
        let alone = PointMassDefinition { lag_inertia: Some(0.0), ..TIP.with_offset(0.5) };
        let message = "point_mass[0].lag_inertia: point mass lag inertia must be at least mass·offset², \
                       0.125 kg·m² (is 0)";
        assert_eq!(check(&definition().with_point_mass(alone)).unwrap_err().to_string(), message);
    }

    #[test]
    fn too_many_masses_are_one_fault() {
        let given = BladeDefinition { point_masses: vec![PointMassDefinition::default(); 10_001], ..definition() };
        let message = "point_mass: list of point masses must have at most 10000 values (has 10001)";
        assert_eq!(check(&given).unwrap_err().to_string(), message);
    }
}
