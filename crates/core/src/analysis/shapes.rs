//! Mode shapes along the span.

use super::basis::{Basis, solve};
use super::model::{turning, uncoupled};
use super::{Settings, ShapeScale, note, note_fewer, warnings};
use crate::blade::Blade;
use crate::converged::{Wanted, Work};
use crate::dof::Dof;
use crate::fault::Faults;
use crate::label::Label;
use crate::lagrange::{tabulate, torsion_norm};
use crate::modes;
use crate::numerics::quadrature::GaussRules;
use crate::report::{BasisReport, FunctionCounts, ShapeReport, ShapesReport};
use alloc::string::ToString;
use alloc::vec::Vec;

/// Where shapes are sampled [m]: evenly from the innermost root to the tip.
pub(super) fn radii(blade: &Blade, settings: &Settings) -> Vec<f64> {
    let (inner, radius) = (blade.least_offset(), blade.radius());
    let last = settings.points - 1;
    let at = |i: usize| if i == last { radius } else { inner + (radius - inner) * (i as f64 / last as f64) };
    (0..settings.points).map(at).collect()
}

/// Mode shapes along the span at one speed.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn shapes(blade: &Blade, settings: &Settings) -> Result<ShapesReport, Faults> {
    settings.check()?;
    settings.uncoupled()?;
    let blade = &*turning(blade, settings)?;
    let rules = GaussRules::new();
    let speed = settings.speed_or(blade.nominal_speed());
    let (radius, radii) = (blade.radius(), radii(blade, settings));
    let mut report = ShapesReport {
        schema: "bladefan-shapes/1",
        blade: blade.name().to_string(),
        speed_rad_s: speed,
        model: uncoupled(blade, settings),
        basis: BasisReport { family: settings.basis, functions: FunctionCounts::default() },
        r_m: Vec::new(),
        radius_m: radius,
        shapes: Vec::new(),
        warnings: warnings(blade),
    };
    for dof in settings.dofs_of(blade)? {
        let basis =
            Basis::new(blade, dof, settings, &Wanted::at(speed * speed, settings.modes), &rules, &Work::default())?;
        report.basis.functions.set(dof, basis.count());
        note(&mut report.warnings, dof, basis.error());
        let solved = solve(basis.matrices(), speed, settings.modes)?;
        note_fewer(&mut report.warnings, dof, solved.len(), settings.modes);
        let mass = basis.matrices().mass().clone();
        let orthogonality = modes::orthogonality(&mass, &solved);
        let functions = basis.into_functions();
        let tables = tabulate(blade, dof, functions.as_ref(), &radii, &rules);
        let norm = match (settings.normalise, dof) {
            (ShapeScale::Max, _) => None,
            (ShapeScale::Mass, Dof::Flap | Dof::Lag) => Some(mass),
            (ShapeScale::Mass, Dof::Torsion) => Some(torsion_norm(blade, functions.as_ref(), &rules)),
        };
        let sampled = modes::shapes(&[tables], &solved, speed * speed, norm.as_ref());
        let components = sampled.into_iter().flat_map(|shape| shape.components);
        report.shapes.extend(solved.iter().zip(components).enumerate().map(|(index, (mode, component))| ShapeReport {
            label: Label::new(component.dof, index + 1),
            dof: component.dof,
            number: index + 1,
            frequency_rad_s: mode.frequency,
            orthogonality: orthogonality[index],
            nodes_m: modes::nodes(&radii, &component.displacement),
            displacement: component.displacement,
            slope: component.slope,
            moment: component.moment,
        }));
    }
    report.r_m = radii;
    Ok(report)
}
