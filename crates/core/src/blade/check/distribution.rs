//! Properties along the span: stations, values, and the span that each must cover.

use super::{CheckedRoot, Checker, Length, NEAR, Range, Shortest, shortest};
use crate::blade::definition::{DistributionDefinition, PropertyDefinition};
use crate::dof::Dof;
use crate::fault::FaultCode;
use crate::numerics::PiecewiseLinear;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

/// Properties in SI units; none where one is faulty.
#[derive(Default)]
pub(super) struct Distribution {
    pub(super) mass: Option<PiecewiseLinear>,
    pub(super) stiffness: [Option<PiecewiseLinear>; 3],
    pub(super) polar_inertia: Option<PiecewiseLinear>,
    pub(super) mass_offset: Option<PiecewiseLinear>,
}

/// One property of the file: its key, its name in messages, its legal values, its unit in SI.
#[derive(Clone, Copy)]
struct Quantity {
    key: &'static str,
    subject: &'static str,
    range: Range,
    factor: f64,
}

/// Radii as given, and in metres where nothing is wrong with them.
struct Stations<'a> {
    path: String,
    given: &'a [f64],
    si: Option<Vec<f64>>,
}

/// A sound property: the function, and the radii it reaches (none: everywhere).
struct Property {
    function: PiecewiseLinear,
    reach: Option<(Length, Length)>,
}

impl Property {
    fn acts(&self) -> bool {
        self.function.values().iter().any(|&value| value != 0.0)
    }

    /// Whether the function is greater than 0 on some stretch between the radii.
    fn positive_between(&self, from: f64, to: f64) -> bool {
        let (x, y) = (self.function.stations(), self.function.values());
        let stretch = |(x, y): (&[f64], &[f64])| x[1].min(to) > x[0].max(from) && (y[0] > 0.0 || y[1] > 0.0);
        match self.reach {
            None => y.iter().any(|&value| value > 0.0),
            Some(_) => x.windows(2).zip(y.windows(2)).any(stretch),
        }
    }
}

impl Checker {
    /// Checks `[distribution]` against the rotor and the roots.
    pub(super) fn distribution(
        &mut self,
        given: Option<&DistributionDefinition>,
        radius: Option<Length>,
        roots: &[CheckedRoot; 3],
    ) -> Distribution {
        let Some(given) = given else {
            self.missing("distribution", "distribution of properties");
            return Distribution::default();
        };
        let stations = given.r.as_ref().map(|r| self.stations("distribution.r".into(), r, radius));
        let stations = stations.as_ref();
        let units = self.units;
        let stiffness = |key, subject| Quantity { key, subject, range: Range::Positive, factor: units.stiffness() };
        let flap = stiffness("flap_stiffness", "flap stiffness");
        let lag = stiffness("lag_stiffness", "lag stiffness");
        let torsion = stiffness("torsion_stiffness", "torsion stiffness");
        let quantity = |key, subject, range, factor| Quantity { key, subject, range, factor };
        let mass = quantity("mass", "mass per length", Range::NotNegative, units.mass_per_length());
        let inertia = quantity("polar_inertia", "polar inertia", Range::NotNegative, units.polar_inertia());
        let offset = quantity("mass_offset", "mass offset", Range::Finite, units.length.si());
        let twist = quantity("twist", "twist", Range::Finite, units.angle.si());

        let properties = [
            (mass, self.required(mass, given.mass.as_ref(), stations, radius)),
            (flap, self.required(flap, given.flap_stiffness.as_ref(), stations, radius)),
            (lag, self.required(lag, given.lag_stiffness.as_ref(), stations, radius)),
            (torsion, self.required(torsion, given.torsion_stiffness.as_ref(), stations, radius)),
            (inertia, self.required(inertia, given.polar_inertia.as_ref(), stations, radius)),
            (offset, self.optional(offset, given.mass_offset.as_ref(), stations, radius)),
        ];
        let twisted = self.optional(twist, given.twist.as_ref(), stations, radius);

        let moved = properties[5].1.as_ref().is_some_and(Property::acts);
        let root = |dof: Dof| roots[dof.index()].offset;
        let least = |a: Option<Length>, b: Option<Length>| Some(if a?.si < b?.si { a? } else { b? });
        let bending = least(root(Dof::Flap), root(Dof::Lag));
        let inmost = [
            if moved { least(bending, root(Dof::Torsion)) } else { bending },
            root(Dof::Flap),
            root(Dof::Lag),
            root(Dof::Torsion),
            root(Dof::Torsion),
            // An offset of 0 everywhere needs to be known nowhere.
            if moved { root(Dof::Torsion) } else { None },
        ];
        if let Some(radius) = radius {
            for ((quantity, property), from) in properties.iter().zip(inmost) {
                if let (Some(property), Some(from)) = (property, from) {
                    self.cover(*quantity, property, from, radius);
                }
            }
            let [(_, mass), _, _, _, (_, inertia), _] = &properties;
            self.positive("mass", "mass per length", mass.as_ref(), roots, &[Dof::Flap, Dof::Lag], radius);
            self.positive("polar_inertia", "polar inertia", inertia.as_ref(), roots, &[Dof::Torsion], radius);
        }
        self.distribution_warnings(given, moved, twisted.as_ref().is_some_and(Property::acts), radius);

        let [mass, flap, lag, torsion, inertia, offset] = properties.map(|(_, p)| p.map(|p| p.function));
        Distribution { mass, stiffness: [flap, lag, torsion], polar_inertia: inertia, mass_offset: offset }
    }

    /// Checks radii: at least 0, never falling, a radius at most twice, none too near another.
    #[allow(clippy::float_cmp, reason = "a step is the same radius written twice")]
    fn stations<'a>(&mut self, path: String, given: &'a [f64], radius: Option<Length>) -> Stations<'a> {
        let known = self.faults.len();
        let unit = self.units.length;
        if given.is_empty() {
            self.refuse(FaultCode::Length, &path, None, "list of radii", "must have at least one radius");
        }
        for (i, &r) in given.iter().enumerate() {
            if self.number(&format_args!("{path}[{i}]"), &"radius", r, unit.si(), Range::NotNegative).is_none() {
                continue;
            }
            let before = i.checked_sub(1).and_then(|i| given.get(i));
            let Some(&last) = before.filter(|r| r.is_finite()) else { continue };
            let twice_before = i >= 2 && given[i - 2] == last;
            let near = radius.is_some_and(|radius| r - last < NEAR * radius.given);
            let rule = if r < last {
                format!("must not be less than the radius before it, {} {unit}", shortest(last))
            } else if r == last && twice_before {
                "must not stand more than twice".into()
            } else if r > last && near {
                format!("must equal the radius before it, {} {unit}, or be farther from it", shortest(last))
            } else {
                continue;
            };
            self.refuse(FaultCode::Radii, &format!("{path}[{i}]"), Some(shortest(r)), "radius", &rule);
        }
        let sound = self.faults.len() == known;
        Stations { path, given, si: sound.then(|| given.iter().map(|r| r * unit.si()).collect()) }
    }

    fn required(
        &mut self,
        quantity: Quantity,
        given: Option<&PropertyDefinition>,
        stations: Option<&Stations>,
        radius: Option<Length>,
    ) -> Option<Property> {
        if given.is_none() {
            self.missing(&format!("distribution.{}", quantity.key), quantity.subject);
        }
        self.property(quantity, given?, stations, radius)
    }

    /// A property that is 0 where it is not given.
    fn optional(
        &mut self,
        quantity: Quantity,
        given: Option<&PropertyDefinition>,
        stations: Option<&Stations>,
        radius: Option<Length>,
    ) -> Option<Property> {
        match given {
            Some(given) => self.property(quantity, given, stations, radius),
            None => Some(Property { function: PiecewiseLinear::uniform(0.0), reach: None }),
        }
    }

    fn property(
        &mut self,
        quantity: Quantity,
        given: &PropertyDefinition,
        stations: Option<&Stations>,
        radius: Option<Length>,
    ) -> Option<Property> {
        let path = format!("distribution.{}", quantity.key);
        match given {
            PropertyDefinition::Uniform(value) => {
                let value = self.number(&path, &quantity.subject, *value, quantity.factor, quantity.range)?;
                Some(Property { function: PiecewiseLinear::uniform(value), reach: None })
            }
            PropertyDefinition::OnStations(values) => {
                if stations.is_none() && !self.faults.iter().any(|fault| fault.path == "distribution.r") {
                    let rule = "must be given where a property is a list without radii of its own";
                    self.refuse(FaultCode::Missing, "distribution.r", None, "list of radii", rule);
                }
                self.values(quantity, &path, values, stations)
            }
            PropertyDefinition::OwnRadii { r, values } => {
                let stations = self.stations(format!("{path}.r"), r, radius);
                self.values(quantity, &format!("{path}.values"), values, Some(&stations))
            }
        }
    }

    fn values(
        &mut self,
        quantity: Quantity,
        path: &str,
        values: &[f64],
        stations: Option<&Stations>,
    ) -> Option<Property> {
        let unit = self.units.length;
        let mut si = Vec::with_capacity(values.len());
        for (i, &value) in values.iter().enumerate() {
            let r = stations.and_then(|stations| stations.given.get(i));
            let place = format_args!("{path}[{i}]");
            let Quantity { subject, range, factor, .. } = quantity;
            si.extend(match r {
                Some(&r) => {
                    let at = format_args!("{subject} at r = {} {unit}", Shortest(r));
                    self.number(&place, &at, value, factor, range)
                }
                None => self.number(&place, &subject, value, factor, range),
            });
        }
        let stations = stations?;
        if values.len() != stations.given.len() {
            let rule = format!("must have {} values, as many as {}", stations.given.len(), stations.path);
            let count = format!("{}", values.len());
            self.refuse_as("has", FaultCode::Length, path, Some(count), quantity.subject, &rule);
            return None;
        }
        if si.len() != values.len() {
            return None;
        }
        let radii = stations.si.as_ref()?;
        let end = |i: usize| Some(Length { given: *stations.given.get(i)?, si: *radii.get(i)? });
        let reach = (end(0)?, end(radii.len().checked_sub(1)?)?);
        let function = PiecewiseLinear::new(radii.clone(), si);
        if function.is_none() {
            // Radii far beyond the tip, or of no size at all, may fall together in SI units.
            let rule = "must stay apart in SI units";
            self.refuse(FaultCode::Radii, &stations.path, None, "list of radii", rule);
        }
        Some(Property { function: function?, reach: Some(reach) })
    }

    /// A property must reach from a root to the tip.
    fn cover(&mut self, quantity: Quantity, property: &Property, from: Length, radius: Length) {
        let Some((first, last)) = property.reach else { return };
        let near = NEAR * radius.si;
        if first.si <= from.si + near && last.si >= radius.si - near {
            return;
        }
        let unit = self.units.length;
        let rule = format!("must be given from r = {} to {} {unit}", shortest(from.given), shortest(radius.given));
        let reach = format!("{} to {} {unit}", shortest(first.given), shortest(last.given));
        let path = format!("distribution.{}", quantity.key);
        self.refuse_as("is given from", FaultCode::Uncovered, &path, Some(reach), quantity.subject, &rule);
    }

    /// Mass or inertia must be greater than 0 somewhere outboard of each root that moves it.
    fn positive(
        &mut self,
        key: &str,
        subject: &str,
        property: Option<&Property>,
        roots: &[CheckedRoot; 3],
        dofs: &[Dof],
        radius: Length,
    ) {
        let Some(property) = property else { return };
        for &dof in dofs {
            let Some(offset) = roots[dof.index()].offset else { continue };
            if !property.positive_between(offset.si, radius.si) {
                let unit = self.units.length;
                let rule = format!(
                    "must be greater than 0 somewhere outboard of the {dof} root at r = {} {unit}",
                    shortest(offset.given)
                );
                self.refuse(FaultCode::OutOfRange, &format!("distribution.{key}"), None, subject, &rule);
                return;
            }
        }
    }

    fn distribution_warnings(
        &mut self,
        given: &DistributionDefinition,
        moved: bool,
        twisted: bool,
        radius: Option<Length>,
    ) {
        let properties = [
            ("mass", &given.mass),
            ("flap_stiffness", &given.flap_stiffness),
            ("lag_stiffness", &given.lag_stiffness),
            ("torsion_stiffness", &given.torsion_stiffness),
            ("polar_inertia", &given.polar_inertia),
            ("mass_offset", &given.mass_offset),
            ("twist", &given.twist),
        ];
        let beyond =
            |r: &[f64]| radius.is_some_and(|radius| r.last().is_some_and(|&r| r > radius.given * (1.0 + NEAR)));
        if let Some(r) = &given.r {
            if !properties.iter().any(|(_, p)| matches!(p, Some(PropertyDefinition::OnStations(_)))) {
                self.warn("distribution.r", "not used: no property is a list on these radii");
            } else if beyond(r) {
                self.warn("distribution.r", "radii beyond the tip radius do not act");
            }
        }
        for (key, property) in properties {
            if let Some(PropertyDefinition::OwnRadii { r, .. }) = property
                && beyond(r)
            {
                self.warn(&format!("distribution.{key}.r"), "radii beyond the tip radius do not act");
            }
        }
        if moved {
            self.warn("distribution.mass_offset", "acts in torsion only");
        }
        if twisted {
            self.warn("distribution.twist", "not used by the uncoupled solver");
        }
    }
}
