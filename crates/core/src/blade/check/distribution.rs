//! Properties along the span: stations, values, and the span that each must cover.

use super::{CheckedRoot, Checker, Length, NEAR, Range};
use crate::blade::definition::{DistributionDefinition, PropertyDefinition};
use crate::blade::property::Property;
use crate::dof::Dof;
use crate::fault::FaultCode;
use crate::figures::{Shortest, shortest};
use crate::numerics::PiecewiseLinear;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

/// Most values of one list. Work grows with them, a file with more is most likely no blade, and one
/// fault says so where as many as there are values would not.
const MOST_STATIONS: usize = 10_000;

/// Radii as given, and in metres where nothing is wrong with them.
struct Stations<'a> {
    path: String,
    given: &'a [f64],
    si: Option<Vec<f64>>,
}

/// A sound property: the function, and the radii it reaches (none: everywhere).
struct Known {
    function: PiecewiseLinear,
    reach: Option<(Length, Length)>,
}

impl Known {
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
    /// Checks `[distribution]` against the rotor and the roots: the properties in SI units, none
    /// where one is faulty.
    pub(super) fn distribution(
        &mut self,
        given: Option<&DistributionDefinition>,
        radius: Option<Length>,
        roots: &[CheckedRoot; 3],
    ) -> [Option<PiecewiseLinear>; Property::COUNT] {
        let Some(given) = given else {
            self.missing("distribution", "distribution of properties");
            return Default::default();
        };
        let stations = given.r.as_ref().map(|r| self.stations("distribution.r".into(), r, radius));
        let mut known = Property::ALL.map(|property| self.property(property, given, stations.as_ref(), radius));
        for property in Property::ALL {
            if is_sum(property, given) {
                known[property.index()] = sum(property, &known);
            }
        }
        if let Some(radius) = radius {
            for property in Property::ALL {
                if let (Some(found), Some(from)) = (&known[property.index()], inmost(property, &known, roots)) {
                    self.cover(property, found, from, radius);
                }
            }
            for property in Property::ALL {
                self.acts_outboard(property, given, &known, roots, radius);
            }
        }
        self.distribution_warnings(given, radius);
        known.map(|found| found.map(|found| found.function))
    }

    /// Checks radii: at least 0, never falling, a radius at most twice, none too near another.
    #[allow(clippy::float_cmp, reason = "a step is the same radius written twice")]
    fn stations<'a>(&mut self, path: String, given: &'a [f64], radius: Option<Length>) -> Stations<'a> {
        let known = self.faults.len();
        let unit = self.units.length;
        if given.is_empty() {
            self.refuse(FaultCode::Length, &path, None, "list of radii", "must have at least one radius");
        }
        if self.too_long(&path, given.len(), "list of radii") {
            return Stations { path, given, si: None };
        }
        for (i, &r) in given.iter().enumerate() {
            if self.number(&format_args!("{path}[{i}]"), &"radius", r, unit.si(), Range::NOT_NEGATIVE).is_none() {
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

    /// Whether a list has more values than are taken, with the fault.
    pub(super) fn too_long(&mut self, path: &str, count: usize, subject: &str) -> bool {
        if count > MOST_STATIONS {
            let rule = format!("must have at most {MOST_STATIONS} values");
            self.refuse_as("has", FaultCode::Length, path, Some(format!("{count}")), subject, &rule);
        }
        count > MOST_STATIONS
    }

    /// A property as the solver takes it; 0 where it may be left out and is, none where it is
    /// faulty or the sum of others.
    fn property(
        &mut self,
        property: Property,
        given: &DistributionDefinition,
        stations: Option<&Stations>,
        radius: Option<Length>,
    ) -> Option<Known> {
        let row = property.row();
        let path = format!("distribution.{}", row.key);
        let Some(value) = &given[property] else { return self.absent(property, &path, given) };
        if let Some(other) = row.not_beside.filter(|other| given[*other].is_some()) {
            let rule = format!("must not be given beside {}", other.key());
            self.refuse(FaultCode::Conflict, &path, None, row.words, &rule);
        }
        match value {
            PropertyDefinition::Uniform(value) => {
                let value = self.number(&path, &row.words, *value, property.unit(&self.units), row.range)?;
                Some(Known { function: PiecewiseLinear::uniform(value), reach: None })
            }
            PropertyDefinition::OnStations(values) => {
                if stations.is_none() && !self.faults.iter().any(|fault| fault.path == "distribution.r") {
                    let rule = "must be given where a property is a list without radii of its own";
                    self.refuse(FaultCode::Missing, "distribution.r", None, "list of radii", rule);
                }
                self.values(property, &path, values, stations)
            }
            PropertyDefinition::OwnRadii { r, values } => {
                let stations = self.stations(format!("{path}.r"), r, radius);
                self.values(property, &format!("{path}.values"), values, Some(&stations))
            }
        }
    }

    /// What a property is that is not given.
    fn absent(&mut self, property: Property, path: &str, given: &DistributionDefinition) -> Option<Known> {
        let row = property.row();
        if let Some(other) = row.together_with.filter(|other| given[*other].is_some()) {
            let rule = format!("must be given where {} is", other.key());
            self.refuse(FaultCode::Missing, path, None, row.words, &rule);
            return None;
        }
        let of_torsion = Property::OF_TORSION.contains(&property);
        if !row.required || (of_torsion && !self.torsion) {
            return Some(Known { function: PiecewiseLinear::uniform(0.0), reach: None });
        }
        // A sum that lacks a part is told of there.
        if row.sum_of.iter().all(|part| given[*part].is_none()) {
            if of_torsion { self.missing_torsion(path, row.words) } else { self.missing(path, row.words) }
        }
        None
    }

    fn values(&mut self, property: Property, path: &str, values: &[f64], stations: Option<&Stations>) -> Option<Known> {
        let (row, unit, factor) = (property.row(), self.units.length, property.unit(&self.units));
        if self.too_long(path, values.len(), row.words) {
            return None;
        }
        let mut si = Vec::with_capacity(values.len());
        for (i, &value) in values.iter().enumerate() {
            let r = stations.and_then(|stations| stations.given.get(i));
            let place = format_args!("{path}[{i}]");
            si.extend(match r {
                Some(&r) => {
                    let at = format_args!("{} at r = {} {unit}", row.words, Shortest(r));
                    self.number(&place, &at, value, factor, row.range)
                }
                None => self.number(&place, &row.words, value, factor, row.range),
            });
        }
        let stations = stations?;
        if values.len() != stations.given.len() {
            let rule = format!("must have {} values, as many as {}", stations.given.len(), stations.path);
            let count = format!("{}", values.len());
            self.refuse_as("has", FaultCode::Length, path, Some(count), row.words, &rule);
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
        Some(Known { function: function?, reach: Some(reach) })
    }

    /// A property must reach from a root to the tip.
    fn cover(&mut self, property: Property, known: &Known, from: Length, radius: Length) {
        let Some((first, last)) = known.reach else { return };
        let near = NEAR * radius.si;
        if from.si >= radius.si {
            // No root of it is on the blade.
            return;
        }
        if first.si <= from.si + near && last.si >= radius.si - near {
            return;
        }
        let unit = self.units.length;
        let rule = format!("must be given from r = {} to {} {unit}", shortest(from.given), shortest(radius.given));
        let reach = format!("{} to {} {unit}", shortest(first.given), shortest(last.given));
        let path = format!("distribution.{}", property.key());
        self.refuse_as("is given from", FaultCode::Uncovered, &path, Some(reach), property.words(), &rule);
    }

    /// Mass or inertia must be greater than 0 somewhere outboard of each root that moves it; of a sum,
    /// any part of it.
    fn acts_outboard(
        &mut self,
        property: Property,
        given: &DistributionDefinition,
        known: &[Option<Known>; Property::COUNT],
        roots: &[CheckedRoot; 3],
        radius: Length,
    ) {
        let row = property.row();
        let alone = [property];
        let parts = if is_sum(property, given) { row.sum_of } else { &alone };
        let Some(found) = parts.iter().map(|part| known[part.index()].as_ref()).collect::<Option<Vec<_>>>() else {
            return;
        };
        let (Some(last), words) = (parts.last(), parts.iter().map(|part| part.words()).collect::<Vec<_>>()) else {
            return;
        };
        for &dof in row.acts_outboard_of {
            let Some(offset) = roots[dof.index()].offset.filter(|offset| offset.si < radius.si) else { continue };
            if !found.iter().any(|part| part.positive_between(offset.si, radius.si)) {
                let unit = self.units.length;
                let rule = format!(
                    "must be greater than 0 somewhere outboard of the {dof} root at r = {} {unit}",
                    shortest(offset.given)
                );
                let path = format!("distribution.{}", last.key());
                self.refuse(FaultCode::OutOfRange, &path, None, &words.join(" or "), &rule);
                return;
            }
        }
    }

    fn distribution_warnings(&mut self, given: &DistributionDefinition, radius: Option<Length>) {
        let beyond =
            |r: &[f64]| radius.is_some_and(|radius| r.last().is_some_and(|&r| r > radius.given * (1.0 + NEAR)));
        if let Some(r) = &given.r {
            if !given.properties.iter().any(|p| matches!(p, Some(PropertyDefinition::OnStations(_)))) {
                self.warn("distribution.r", "not used: no property is a list on these radii");
            } else if beyond(r) {
                self.warn("distribution.r", "radii beyond the tip radius do not act");
            }
        }
        for property in Property::ALL {
            if let Some(PropertyDefinition::OwnRadii { r, .. }) = &given[property]
                && beyond(r)
            {
                let path = format!("distribution.{}.r", property.key());
                self.warn(&path, "radii beyond the tip radius do not act");
            }
        }
    }
}

/// Whether a property is the sum of others.
fn is_sum(property: Property, given: &DistributionDefinition) -> bool {
    let parts = property.row().sum_of;
    given[property].is_none() && !parts.is_empty() && parts.iter().all(|part| given[*part].is_some())
}

/// A property that is the sum of others; none where one of them is faulty.
fn sum(property: Property, known: &[Option<Known>; Property::COUNT]) -> Option<Known> {
    let parts = property.row().sum_of.iter().map(|part| known[part.index()].as_ref().map(|part| &part.function));
    let parts = parts.collect::<Option<Vec<_>>>()?;
    let (first, others) = parts.split_first()?;
    // Its parts reach as far as they must.
    let function = others.iter().fold((*first).clone(), |sum, part| sum.plus(part));
    Some(Known { function, reach: None })
}

/// The innermost root from which a property must be known; none where it need not be, or where a
/// root is not known.
fn inmost(property: Property, known: &[Option<Known>; Property::COUNT], roots: &[CheckedRoot; 3]) -> Option<Length> {
    let row = property.row();
    let acts = |property: Property| known[property.index()].as_ref().is_some_and(Known::acts);
    if !row.required && !acts(property) {
        return None;
    }
    let also = row.also_from.iter().filter(|(other, _)| acts(*other)).map(|(_, dof)| dof);
    let offsets = row.known_from.iter().chain(also).map(|dof: &Dof| roots[dof.index()].offset);
    // A root that is not known makes the innermost one unknown.
    let offsets = offsets.collect::<Option<Vec<Length>>>()?;
    offsets.into_iter().reduce(|least, other| if least.si < other.si { least } else { other })
}
