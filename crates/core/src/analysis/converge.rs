//! Frequency against the number of assumed functions.

use super::basis::{Basis, Classical, converged, separated, solve};
use super::coupled_converge::coupled_converge;
use super::model::{turning, uncoupled};
use super::{ModelKind, Settings, available, note, note_bounds, note_fewer, unsolvable, warnings};
use crate::blade::Blade;
use crate::converged::{Converged, TOLERANCE, Wanted, Work};
use crate::dof::Dof;
use crate::fault::Faults;
use crate::functions::MOST_ORDER;
use crate::label::Label;
use crate::lagrange::system;
use crate::modes::{Mode, SolveError};
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::sqrt;
use crate::report::{ConvergeReport, ConvergeSeries};
use alloc::boxed::Box;
use alloc::string::ToString;
use alloc::vec;
use alloc::vec::Vec;

/// One polynomial more per element costs about so many times the last one.
const ONE_MORE: f64 = 1.5;

/// Frequency against the number of assumed functions at one speed. The functions are nested, so
/// the matrices of fewer functions are leading parts of those of the most.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn converge(blade: &Blade, settings: &Settings) -> Result<ConvergeReport, Faults> {
    settings.check_converge()?;
    if settings.model_for(blade) == ModelKind::Coupled {
        return coupled_converge(blade, settings);
    }
    let blade = &*turning(blade, settings)?;
    let rules = GaussRules::new();
    let speed = settings.speed_or(blade.nominal_speed());
    let mut report = ConvergeReport {
        schema: "bladefan-converge/1",
        blade: blade.name().to_string(),
        speed_rad_s: speed,
        model: uncoupled(blade, settings),
        functions: (1..=settings.up_to).collect(),
        series: Vec::new(),
        warnings: warnings(blade),
    };
    let square = speed * speed;
    for dof in settings.dofs_of(blade)? {
        let matrices = Classical::new(blade, dof, settings.up_to, &rules, false).matrices;
        let mut values = vec![Vec::with_capacity(settings.up_to); settings.modes];
        for &count in &report.functions {
            let solved = available(&matrices.leading(count), square, settings.modes).map_err(unsolvable)?;
            for (index, series) in values.iter_mut().enumerate() {
                series.push(solved.get(index).map(|mode| mode.frequency));
            }
        }
        let steps = piecewise_steps(blade, dof, speed, settings.modes, &rules)?;
        let found = converged(blade, dof, &Wanted::at(square, settings.modes + 1), &rules, &Work::default())?;
        let reference = solve(found.matrices(), speed, settings.modes + 1)?;
        let error = found.error();
        let separation = separated(&found, &reference);
        let solved = reference.get(..settings.modes).unwrap_or(&reference);
        let bounds = Basis::Piecewise(Box::new(found)).bounds(solved, &separation, square, &rules);
        let interval = |index: usize| bounds.as_ref().and_then(|bounds| bounds.intervals.get(index));
        let better = |index: usize| bounds.as_ref().and_then(|bounds| bounds.eigenvalues.get(index));
        note_bounds(&mut report.warnings, dof, bounds.is_some());
        note_fewer(&mut report.warnings, dof, solved.len(), settings.modes);
        note(&mut report.warnings, dof, error);
        report.series.extend(values.into_iter().enumerate().map(|(index, classical_rad_s)| ConvergeSeries {
            label: Label::new(dof, index + 1),
            dof,
            number: index + 1,
            classical_rad_s,
            converged_rad_s: solved.get(index).map(|mode| better(index).map_or(mode.frequency, |value| sqrt(*value))),
            lower_rad_s: interval(index).map(|interval| sqrt(interval.lower)),
            upper_rad_s: interval(index).map(|interval| sqrt(interval.upper)),
            piecewise_functions: steps.iter().map(|(count, _)| *count).collect(),
            piecewise_rad_s: steps.iter().map(|(_, modes)| modes.get(index).map(|mode| mode.frequency)).collect(),
        }));
    }
    Ok(report)
}

/// Modes with more and more piecewise functions: one polynomial per element, two, three, … until
/// they are converged, or too much work.
fn piecewise_steps(
    blade: &Blade,
    dof: Dof,
    speed: f64,
    count: usize,
    rules: &GaussRules,
) -> Result<Vec<(usize, Vec<Mode>)>, Faults> {
    let mut steps = Vec::new();
    let work = Work::default();
    for order in 1..=MOST_ORDER {
        let before = work.left();
        let cause = |cause| unsolvable(SolveError { dofs: system(blade, dof).dofs, cause });
        let found = Converged::with_order(blade, dof, speed * speed, count, order, rules, &work).map_err(cause)?;
        let modes = available(found.matrices(), speed * speed, count).map_err(unsolvable)?;
        let done = found.error() <= TOLERANCE && modes.len() == count;
        steps.push((found.count(), modes));
        if done || work.left() < ONE_MORE * (before - work.left()) {
            break;
        }
    }
    Ok(steps)
}
