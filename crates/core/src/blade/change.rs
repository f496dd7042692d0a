//! A blade with something changed: what-if, sweeps and sensitivities speak of changes.

use super::convert::{Factors, LENGTH, SPEED};
use super::definition::{BladeDefinition, DistributionDefinition, PointMassDefinition, PropertyDefinition};
use super::property::Property;
use super::restation::{Piece, restationed};
use crate::dof::Dof;
use crate::fault::{Fault, FaultCode, Faults, Warning};
use crate::units::Units;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// What of a blade is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum What {
    /// A property along the span.
    Property(Property),
    /// The radius of the hinge or root of a degree of freedom.
    Offset(Dof),
    /// The spring at the root of a degree of freedom.
    Spring(Dof),
    /// The nominal rotor speed.
    NominalSpeed,
}

impl What {
    /// Everything that can be changed.
    pub fn all() -> impl Iterator<Item = Self> {
        let properties = Property::ALL.into_iter().map(Self::Property);
        let roots = Dof::ALL.into_iter().flat_map(|dof| [Self::Offset(dof), Self::Spring(dof)]);
        core::iter::once(Self::NominalSpeed).chain(roots).chain(properties)
    }

    /// Its path in the blade file: `distribution.mass`, `flap.offset`, `lag.spring`,
    /// `rotor.nominal_speed`.
    pub fn path(self) -> String {
        match self {
            Self::Property(property) => format!("distribution.{}", property.key()),
            Self::Offset(dof) => format!("{dof}.offset"),
            Self::Spring(dof) => format!("{dof}.spring"),
            Self::NominalSpeed => "rotor.nominal_speed".into(),
        }
    }

    /// What stands at this path.
    pub fn from_path(path: &str) -> Option<Self> {
        Self::all().find(|what| what.path() == path)
    }

    /// Whether it exists with torsion alone.
    fn is_of_torsion(self) -> bool {
        match self {
            Self::Property(property) => Property::OF_TORSION.contains(&property),
            Self::Offset(dof) | Self::Spring(dof) => dof == Dof::Torsion,
            Self::NominalSpeed => false,
        }
    }

    /// How many SI units one unit of it is.
    fn unit(self, units: Units) -> f64 {
        match self {
            Self::Property(property) => property.unit(&units),
            Self::Offset(_) => LENGTH(&units),
            Self::Spring(_) => units.spring(),
            Self::NominalSpeed => SPEED(&units),
        }
    }
}

/// How a number is changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount {
    /// Times this.
    Scale(f64),
    /// To this, whatever it was.
    Set(f64),
    /// By this.
    Add(f64),
}

impl Amount {
    pub(super) fn of(self, value: f64) -> f64 {
        match self {
            Self::Scale(factor) => value * factor,
            Self::Set(number) => number,
            Self::Add(number) => value + number,
        }
    }

    const fn number(self) -> f64 {
        let (Self::Scale(number) | Self::Set(number) | Self::Add(number)) = self;
        number
    }

    /// The same with its number in other units; a factor has none.
    fn converted(self, convert: impl Fn(f64) -> f64) -> Self {
        match self {
            Self::Scale(factor) => Self::Scale(factor),
            Self::Set(number) => Self::Set(convert(number)),
            Self::Add(number) => Self::Add(convert(number)),
        }
    }
}

/// The part of the span between two radii [length]; without one of them, to the end on that side.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Part {
    /// Inner end.
    pub from: Option<f64>,
    /// Outer end.
    pub to: Option<f64>,
}

impl Part {
    /// The whole span.
    pub const WHOLE: Self = Self { from: None, to: None };

    const fn is_whole(self) -> bool {
        self.from.is_none() && self.to.is_none()
    }

    pub(super) fn ends(self) -> (f64, f64) {
        (self.from.unwrap_or(f64::NEG_INFINITY), self.to.unwrap_or(f64::INFINITY))
    }
}

/// One change of a blade.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// What is changed.
    pub what: What,
    /// How.
    pub amount: Amount,
    /// Where along the span; only a property has more places than one.
    pub part: Part,
    /// Units of the numbers here; `None`: those of the blade.
    pub units: Option<Units>,
    /// A mass per length that is scaled takes its inertias and the point masses there along, as more
    /// of the same material would; this leaves them as they are.
    pub mass_alone: bool,
}

impl Change {
    /// A change over the whole span, in the blade's units.
    pub const fn new(what: What, amount: Amount) -> Self {
        Self { what, amount, part: Part::WHOLE, units: None, mass_alone: false }
    }

    /// The same on a part of the span only.
    #[must_use]
    pub const fn on(self, from: f64, to: f64) -> Self {
        Self { part: Part { from: Some(from), to: Some(to) }, ..self }
    }

    /// The same with its numbers in these units.
    #[must_use]
    pub const fn in_units(self, units: Units) -> Self {
        Self { units: Some(units), ..self }
    }

    /// What is wrong with it; `path` is where it stands.
    fn faults(&self, path: &str, blade: &BladeDefinition) -> Vec<Fault> {
        let mut faults = Vec::new();
        if self.what.is_of_torsion() && !blade.has_torsion() {
            let (what, rule) = (self.what.path(), "needs a blade with torsion data");
            let message = format!("{what} {rule}: this one has flap and lag alone");
            faults.push(Fault::new(FaultCode::Missing, format!("{path}.what"), Some(what), rule, message));
        }
        let mut refuse = |code, key: &str, value: Option<f64>, rule: &str| {
            let value = value.map(|value| value.to_string());
            let is = value.as_ref().map(|value| format!(" (is {value})")).unwrap_or_default();
            faults.push(Fault::new(code, format!("{path}.{key}"), value, rule, format!("{rule}{is}")));
        };
        let key = match self.amount {
            Amount::Scale(_) => "scale",
            Amount::Set(_) => "set",
            Amount::Add(_) => "add",
        };
        let Part { from, to } = self.part;
        for (key, number) in [(key, Some(self.amount.number())), ("from", from), ("to", to)] {
            if let Some(number) = number.filter(|number| !number.is_finite()) {
                refuse(FaultCode::NotFinite, key, Some(number), "must be finite");
            }
        }
        if let (Some(from), Some(to)) = (from, to)
            && from >= to
        {
            refuse(FaultCode::OutOfRange, "to", Some(to), "must be greater than from");
        }
        if !self.part.is_whole() && !matches!(self.what, What::Property(_)) {
            let key = if from.is_some() { "from" } else { "to" };
            refuse(FaultCode::Conflict, key, from.or(to), "belongs to a property along the span only");
        }
        faults
    }

    /// The same with its numbers in the units of a blade.
    fn in_units_of(self, blade: Units) -> Self {
        let Some(own) = self.units else { return self };
        let factors = Factors { from: own, to: blade };
        let length = |end: Option<f64>| end.map(|end| factors.number(end, LENGTH));
        Self {
            amount: self.amount.converted(|number| factors.number(number, |units| self.what.unit(*units))),
            part: Part { from: length(self.part.from), to: length(self.part.to) },
            units: None,
            ..self
        }
    }
}

/// A blade after changes.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "formats", derive(serde::Serialize))]
pub struct Changed {
    /// The changed blade, in the units of the one given.
    pub blade: BladeDefinition,
    /// What was changed along with what was asked for.
    pub notes: Vec<Warning>,
}

/// A blade with changes, one after the other. A property that is changed on a part of the span gets
/// a step at either end of that part; numbers outside keep their bits, and a change that changes
/// nothing leaves the definition as it is. What the blade lacks stays missing, except that an
/// optional property may be set; what is faulty stays as it is. The blade is not checked.
///
/// # Errors
/// Changes that are none, and those of torsion where the blade has no torsion data: paths are `changes[0].from` and
/// the like.
pub fn change(definition: &BladeDefinition, changes: &[Change]) -> Result<Changed, Faults> {
    let faults = changes.iter().enumerate().flat_map(|(i, change)| change.faults(&format!("changes[{i}]"), definition));
    faults.collect::<Faults>().none()?;
    let mut changed = Changed { blade: definition.clone(), notes: Vec::new() };
    for change in changes {
        changed.apply(change.in_units_of(definition.units));
    }
    Ok(changed)
}

impl Changed {
    fn apply(&mut self, change: Change) {
        let Change { what, amount, part, .. } = change;
        match what {
            What::Property(property) => {
                let done = self.property(property, amount, part);
                if let (Property::Mass, Amount::Scale(factor), false) = (property, amount, change.mass_alone) {
                    self.along_with_mass(factor, part, done);
                }
            }
            What::Offset(dof) => self.offset(dof, amount),
            What::Spring(dof) => {
                if let Some(root) = self.blade.root_mut(dof) {
                    set(&mut root.spring, amount);
                }
            }
            What::NominalSpeed => {
                if let Some(rotor) = &mut self.blade.rotor {
                    set(&mut rotor.nominal_speed, amount);
                }
            }
        }
    }

    /// Scales the inertias of a mass that was scaled, and the point masses on the same part.
    fn along_with_mass(&mut self, factor: f64, part: Part, done: bool) {
        let message = format!("scaled by {factor} along with the mass");
        for property in [Property::PolarInertia, Property::FlapInertia, Property::LagInertia] {
            if done && self.property(property, Amount::Scale(factor), part) {
                self.notes.push(Warning { path: What::Property(property).path(), message: message.clone() });
            }
        }
        let radius = self.blade.rotor.and_then(|rotor| rotor.radius).unwrap_or(f64::INFINITY);
        let (from, to) = part.ends();
        for (i, mass) in self.blade.point_masses.iter_mut().enumerate() {
            // Where two parts meet, a mass belongs to the outer one.
            let inside = mass.r.is_some_and(|r| r >= from && (r < to || to >= radius));
            if inside && mass.scale(factor) {
                self.notes.push(Warning { path: format!("point_mass[{i}]"), message: message.clone() });
            }
        }
    }

    /// Changes a property; tells whether anything is changed.
    fn property(&mut self, property: Property, amount: Amount, part: Part) -> bool {
        let radius = self.blade.rotor.and_then(|rotor| rotor.radius);
        let Some(distribution) = &mut self.blade.distribution else { return false };
        let changed = match &distribution[property] {
            Some(given) => changed_property(given, distribution, amount, part, radius),
            // What may be left out is 0 where it is.
            None if property.is_required() => None,
            None => changed_property(&PropertyDefinition::Uniform(0.0), distribution, amount, part, radius),
        };
        let done = changed.is_some();
        if done {
            distribution[property] = changed;
        }
        done
    }

    /// A factor keeps an offset the ratio that it is; a number makes it a radius.
    fn offset(&mut self, dof: Dof, amount: Amount) {
        let radius = self.blade.rotor.and_then(|rotor| rotor.radius);
        let Some(root) = self.blade.root_mut(dof) else { return };
        let place = match (root.offset, root.offset_ratio, amount) {
            (None, Some(ratio), Amount::Scale(factor)) => {
                root.offset_ratio = Some(ratio * factor);
                return;
            }
            (None, Some(ratio), _) => radius.map(|radius| ratio * radius),
            (offset, ..) => Some(offset.unwrap_or(0.0)),
        };
        let to = match (amount, place) {
            (Amount::Set(to), _) => to,
            (_, Some(place)) => amount.of(place),
            (_, None) => return,
        };
        if place.is_none_or(|place| differ(place, to)) {
            root.offset = Some(to);
            root.offset_ratio = None;
        }
    }
}

impl PointMassDefinition {
    /// Scales the mass and the inertias that go with it; tells whether anything is changed.
    fn scale(&mut self, factor: f64) -> bool {
        let before = *self;
        for number in [&mut self.mass, &mut self.flap_inertia, &mut self.lag_inertia] {
            set(number, Amount::Scale(factor));
        }
        let differs = |a: Option<f64>, b: Option<f64>| a.zip(b).is_some_and(|(a, b)| differ(a, b));
        differs(before.mass, self.mass)
            || differs(before.flap_inertia, self.flap_inertia)
            || differs(before.lag_inertia, self.lag_inertia)
    }
}

/// Changes a number that is there; one that is not can only be set.
fn set(number: &mut Option<f64>, amount: Amount) {
    *number = match (*number, amount) {
        (None, Amount::Set(to)) => Some(to),
        (given, _) => given.map(|given| if differ(given, amount.of(given)) { amount.of(given) } else { given }),
    };
}

/// Whether two numbers are not the same; what is no number stays none.
#[allow(clippy::float_cmp, reason = "what is not changed is the same number")]
pub(super) fn differ(a: f64, b: f64) -> bool {
    a != b && !(a.is_nan() && b.is_nan())
}

/// A property after a change; none where that is what it was, or where it is faulty.
fn changed_property(
    given: &PropertyDefinition,
    distribution: &DistributionDefinition,
    amount: Amount,
    part: Part,
    radius: Option<f64>,
) -> Option<PropertyDefinition> {
    let (from, to) = part.ends();
    let all = |r: &[f64]| part.is_whole() || matches!(r, [first, .., last] if from <= *first && to >= *last);
    let ends = radius.map(|radius| [0.0, radius]);
    let (r, values): (&[f64], &[f64]) = match given {
        PropertyDefinition::Uniform(value) => {
            if part.is_whole() || ends.is_some_and(|ends| all(&ends)) {
                return differ(*value, amount.of(*value)).then(|| PropertyDefinition::Uniform(amount.of(*value)));
            }
            (&ends?, &[*value, *value])
        }
        PropertyDefinition::OnStations(values) => (distribution.r.as_deref().unwrap_or_default(), values),
        PropertyDefinition::OwnRadii { r, values } => (r, values),
    };
    if all(r) {
        // The whole property: it keeps its form.
        if !values.iter().any(|&value| differ(value, amount.of(value))) {
            return None;
        }
        let values = values.iter().map(|&value| amount.of(value)).collect();
        return Some(match given {
            PropertyDefinition::OwnRadii { r, .. } => PropertyDefinition::OwnRadii { r: r.clone(), values },
            _ => PropertyDefinition::OnStations(values),
        });
    }
    let Piece { r, values } = restationed(r, values, (from, to), |value| amount.of(value))?;
    Some(PropertyDefinition::OwnRadii { r, values })
}

#[cfg(test)]
mod tests;
