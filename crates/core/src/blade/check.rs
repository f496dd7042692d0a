//! From a definition to a blade: every fault at once, and the one conversion to SI units.

mod distribution;
mod point_mass;
mod pose;

use super::definition::{BladeDefinition, RootDefinition, RootKind, RotorDefinition, Source};
use super::model::{Blade, PointMass, Pose, Racket, Root, RootCondition};
use super::property::Property;
use super::range::Range;
use crate::dof::Dof;
use crate::fault::{Fault, FaultCode, Faults, Warning};
use crate::figures::{Shortest, shortest};
use crate::numerics::PiecewiseLinear;
use crate::units::Units;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

/// Two radii nearer than this times R are one place, so far as ends and gaps go.
const NEAR: f64 = 1e-9;

/// Beyond these, squares and products of a blade's numbers would not stay numbers.
const RADIUS: Range = Range::positive(1e-6, 1e6, "m");
const NOMINAL_SPEED: Range = Range::positive(1e-9, 1e9, "rad/s");
/// What is missing of torsion where not all of it is.
const TOGETHER: &str = "must be given, or [torsion], torsion_stiffness and the inertias be left out together";

const SPRING: Range = Range::zero_or(1e-30, 1e30, "N·m/rad");

/// Checks a definition and converts it to SI units.
///
/// # Errors
/// Every rule of the blade file that the definition breaks, in the order of the file's keys, each
/// with its path and the value in the definition's own units.
pub fn check(definition: &BladeDefinition) -> Result<Blade, Faults> {
    let torsion = definition.has_torsion();
    let mut checker = Checker { units: definition.units, torsion, faults: Vec::new(), warnings: Vec::new() };
    let name = definition.name.clone();
    if name.is_none() {
        checker.missing("name", "name of the blade");
    }
    checker.source(definition.source.as_ref());
    let rotor = checker.rotor(definition.rotor.as_ref());
    let radius = rotor.radius;
    let pose = checker.pose(definition.rotor.as_ref());
    let mut root = |dof: Dof, given: Option<&RootDefinition>| checker.root(dof, given, radius);
    let roots = [
        root(Dof::Flap, definition.flap.as_ref()),
        root(Dof::Lag, definition.lag.as_ref()),
        if torsion { root(Dof::Torsion, definition.torsion.as_ref()) } else { CheckedRoot::none(radius) },
    ];
    checker.turned_springs(definition.rotor.as_ref(), radius, &roots);
    if !torsion {
        checker.warn("torsion", "no torsion data: flap and lag alone");
    }
    let properties = checker.distribution(definition.distribution.as_ref(), radius, &roots);
    let given = |property| definition.distribution.as_ref().is_some_and(|given| given[property].is_some());
    let span = Span {
        properties,
        given: Property::ALL.map(given),
        point_masses: checker.point_masses(&definition.point_masses, radius, &roots),
    };
    let Checker { faults, warnings, .. } = checker;
    let faults = Faults::from(faults);
    let blade = assemble(name, &rotor, pose, roots, span, warnings);
    // Without a fault nothing is missing, so the blade is there.
    if faults.is_empty() { blade.ok_or(faults) } else { Err(faults) }
}

fn assemble(
    name: Option<String>,
    rotor: &Rotor,
    pose: Option<Pose>,
    [flap, lag, torsion]: [CheckedRoot; 3],
    span: Span,
    warnings: Vec<Warning>,
) -> Option<Blade> {
    let properties: Vec<PiecewiseLinear> = span.properties.into_iter().collect::<Option<_>>()?;
    Some(Blade {
        name: name?,
        radius: rotor.radius?.si,
        nominal_speed: rotor.nominal_speed?,
        blades: rotor.blades,
        roots: [flap.root()?, lag.root()?, torsion.root()?],
        pose: pose?,
        properties: properties.try_into().ok()?,
        given: span.given,
        point_masses: span.point_masses,
        racket: Racket::default(),
        warnings,
    })
}

/// A word that is not one of the choices.
pub(crate) fn choice_fault(code: FaultCode, path: &str, subject: &str, given: &str, choices: &[&str]) -> Fault {
    let rule = match choices {
        [head @ .., before, last] if !head.is_empty() => format!("must be {}, {before} or {last}", head.join(", ")),
        _ => format!("must be {}", choices.join(" or ")),
    };
    let message = format!("{subject} {rule} (is {given})");
    Fault::new(code, path, Some(given.into()), rule, message)
}

/// A length in the file's unit, for messages, and in metres.
#[derive(Clone, Copy)]
struct Length {
    given: f64,
    si: f64,
}

struct Rotor {
    radius: Option<Length>,
    nominal_speed: Option<f64>,
    blades: Option<u32>,
}

/// What lies along the span.
struct Span {
    properties: [Option<PiecewiseLinear>; Property::COUNT],
    given: [bool; Property::COUNT],
    point_masses: Vec<PointMass>,
}

/// What is known of a root, be it sound or not.
#[derive(Clone, Copy)]
struct CheckedRoot {
    offset: Option<Length>,
    condition: Option<RootCondition>,
}

impl CheckedRoot {
    /// Of a degree of freedom that does not exist: clamped at the tip, it moves nothing.
    const fn none(tip: Option<Length>) -> Self {
        Self { offset: tip, condition: Some(RootCondition::Clamped) }
    }

    fn root(&self) -> Option<Root> {
        Some(Root { offset: self.offset?.si, condition: self.condition? })
    }
}

struct Checker {
    units: Units,
    /// Whether anything of torsion is given.
    torsion: bool,
    faults: Vec<Fault>,
    warnings: Vec<Warning>,
}

impl Checker {
    fn refuse(&mut self, code: FaultCode, path: &str, value: Option<String>, subject: &str, rule: &str) {
        self.refuse_as("is", code, path, value, subject, rule);
    }

    /// As [`refuse`](Self::refuse), with the word that joins the value to the message.
    fn refuse_as(&mut self, word: &str, code: FaultCode, path: &str, value: Option<String>, subject: &str, rule: &str) {
        let is = value.as_ref().map(|value| format!(" ({word} {value})")).unwrap_or_default();
        self.faults.push(Fault::new(code, path, value, rule, format!("{subject} {rule}{is}")));
    }

    fn missing(&mut self, path: &str, subject: &str) {
        self.refuse(FaultCode::Missing, path, None, subject, "must be given");
    }

    /// What belongs to torsion is missing where something else of it is given.
    fn missing_torsion(&mut self, path: &str, subject: &str) {
        self.refuse(FaultCode::Missing, path, None, subject, TOGETHER);
    }

    fn warn(&mut self, path: &str, message: &str) {
        self.warnings.push(Warning { path: path.into(), message: message.into() });
    }

    /// One number, converted with `factor` to SI units; none where it is faulty.
    fn number(
        &mut self,
        path: &dyn fmt::Display,
        subject: &dyn fmt::Display,
        value: f64,
        factor: f64,
        range: Range,
    ) -> Option<f64> {
        let si = value * factor;
        let (code, rule) = if !value.is_finite() {
            (FaultCode::NotFinite, "must be finite".into())
        } else if !si.is_finite() {
            (FaultCode::NotFinite, "must be finite in SI units".into())
        } else if let Some(rule) = range.broken_by(si) {
            (FaultCode::OutOfRange, rule)
        } else {
            return Some(si);
        };
        self.refuse(code, &path.to_string(), Some(shortest(value)), &subject.to_string(), &rule);
        None
    }

    fn source(&mut self, source: Option<&Source>) {
        if let Some(quality) = source.and_then(|source| source.quality.as_deref())
            && !Source::QUALITIES.contains(&quality)
        {
            let code = FaultCode::UnknownChoice;
            self.faults.push(choice_fault(code, "source.quality", "quality", quality, Source::QUALITIES));
        }
    }

    fn rotor(&mut self, rotor: Option<&RotorDefinition>) -> Rotor {
        let Some(rotor) = rotor else {
            self.missing("rotor", "rotor");
            return Rotor { radius: None, nominal_speed: None, blades: None };
        };
        let (length, speed) = (self.units.length.si(), self.units.speed.si());
        let mut required = |path: &str, subject: &str, given: Option<f64>, factor: f64, range: Range| {
            if given.is_none() {
                self.missing(path, subject);
            }
            self.number(&path, &subject, given?, factor, range)
        };
        let radius = required("rotor.radius", "tip radius", rotor.radius, length, RADIUS);
        let radius = rotor.radius.zip(radius).map(|(given, si)| Length { given, si });
        let (path, subject) = ("rotor.nominal_speed", "nominal speed");
        let nominal_speed = required(path, subject, rotor.nominal_speed, speed, NOMINAL_SPEED);
        let blades = rotor.blades.and_then(|blades| self.blades(blades));
        Rotor { radius, nominal_speed, blades }
    }

    fn blades(&mut self, blades: f64) -> Option<u32> {
        let (path, subject) = ("rotor.blades", "number of blades");
        let blades = self.number(&path, &subject, blades, 1.0, Range::FINITE)?;
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "compared with the number it came from"
        )]
        let whole = blades as u32;
        #[allow(clippy::float_cmp, reason = "a whole number is exact")]
        if whole >= 1 && f64::from(whole) == blades {
            return Some(whole);
        }
        let rule = "must be a whole number of at least 1";
        self.refuse(FaultCode::OutOfRange, path, Some(shortest(blades)), subject, rule);
        None
    }

    fn root(&mut self, dof: Dof, given: Option<&RootDefinition>, radius: Option<Length>) -> CheckedRoot {
        let Some(given) = given else {
            let subject = format!("{dof} root");
            match dof {
                Dof::Torsion => self.missing_torsion(dof.name(), &subject),
                Dof::Flap | Dof::Lag => self.missing(dof.name(), &subject),
            }
            return CheckedRoot { offset: None, condition: None };
        };
        CheckedRoot { offset: self.offset(dof, given, radius), condition: self.condition(dof, given) }
    }

    /// Radius of hinge or root; 0 where none is given.
    fn offset(&mut self, dof: Dof, given: &RootDefinition, radius: Option<Length>) -> Option<Length> {
        let subject = format!("{dof} offset");
        let (ratio_path, offset_path) = (format!("{dof}.offset_ratio"), format!("{dof}.offset"));
        match (given.offset, given.offset_ratio) {
            (None, None) => Some(Length { given: 0.0, si: 0.0 }),
            (Some(_), Some(ratio)) => {
                let rule = "must be given as offset or as offset_ratio, not both";
                self.refuse(FaultCode::Conflict, &ratio_path, Some(shortest(ratio)), &subject, rule);
                None
            }
            (None, Some(ratio)) => {
                let ratio = self.number(&ratio_path, &format!("{subject} ratio"), ratio, 1.0, Range::NOT_NEGATIVE)?;
                if ratio >= 1.0 {
                    let subject = format!("{subject} ratio");
                    self.refuse(
                        FaultCode::OutOfRange,
                        &ratio_path,
                        Some(shortest(ratio)),
                        &subject,
                        "must be less than 1",
                    );
                    return None;
                }
                let radius = radius?;
                Some(Length { given: ratio * radius.given, si: ratio * radius.si })
            }
            (Some(offset), None) => {
                let si = self.number(&offset_path, &subject, offset, self.units.length.si(), Range::NOT_NEGATIVE)?;
                if let Some(radius) = radius
                    && si >= radius.si
                {
                    let rule =
                        format!("must be less than the tip radius {} {}", Shortest(radius.given), self.units.length);
                    self.refuse(FaultCode::OutOfRange, &offset_path, Some(shortest(offset)), &subject, &rule);
                    return None;
                }
                Some(Length { given: offset, si })
            }
        }
    }

    fn condition(&mut self, dof: Dof, given: &RootDefinition) -> Option<RootCondition> {
        let path = format!("{dof}.spring");
        let subject = format!("{dof} spring");
        let spring = given.spring.map(|spring| {
            let factor = self.units.spring();
            self.number(&path, &subject, spring, factor, SPRING)
        });
        let Some(kind) = given.root else {
            self.missing(&format!("{dof}.root"), &format!("{dof} root"));
            return None;
        };
        let choices = RootKind::choices(dof);
        if !choices.contains(&kind) {
            let names: Vec<&str> = choices.iter().map(|kind| kind.name()).collect();
            let (path, subject) = (format!("{dof}.root"), format!("{dof} root"));
            self.faults.push(choice_fault(FaultCode::UnknownChoice, &path, &subject, kind.name(), &names));
            return None;
        }
        if !kind.takes_spring() {
            if let Some(spring) = given.spring {
                let rule = format!("does not belong to a {} root", kind.name());
                self.refuse(FaultCode::Conflict, &path, Some(shortest(spring)), &subject, &rule);
            }
            return Some(if kind == RootKind::Hinged { RootCondition::Free } else { RootCondition::Clamped });
        }
        if spring.is_none() {
            let rule = format!("must be given for a {} root", kind.name());
            self.refuse(FaultCode::Missing, &path, None, &subject, &rule);
        }
        // A spring of 0 holds nothing.
        spring?.map(|k| if k > 0.0 { RootCondition::Spring(k) } else { RootCondition::Free })
    }
}

#[cfg(test)]
mod tests;
