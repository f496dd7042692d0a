//! Frequencies of a coupled blade against the number of assumed functions.

use super::Settings;
use super::coupled::{frequency_of, label, model, note, paper_functions, rigid, unsolvable};
use crate::blade::Blade;
use crate::coupled::{self, Classical, CoupledMode};
use crate::fault::Faults;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::sqrt;
use crate::report::{ConvergeReport, ConvergeSeries};
use alloc::string::ToString;
use alloc::vec::Vec;

/// Frequencies of the lowest modes of the whole blade, with 1, 2, … of the paper's functions of each motion and with
/// more and more piecewise polynomials.
///
/// # Errors
/// Faults in the settings, inertias that are impossible, or equations without an answer.
pub(super) fn coupled_converge(blade: &Blade, settings: &Settings) -> Result<ConvergeReport, Faults> {
    settings.still()?;
    let (coupled, model, mut warnings) = model(blade, settings)?;
    let speed = settings.speed_or(blade.nominal_speed());
    let (square, count, rules) = (speed * speed, settings.coupled_modes, GaussRules::new());
    let found = coupled::modes(&coupled, square, count, &rules).map_err(unsolvable)?;
    note(&mut warnings, &found.modes, count);
    let rigid = rigid(&found);
    let frequency = |value: f64| frequency_of(value, rigid);
    let steps = coupled::steps(&coupled, square, count, &rules).map_err(unsolvable)?;
    let functions: Vec<usize> = (1..=settings.up_to).collect();
    let paper = paper_functions(blade, settings.up_to);
    let paper = Classical::new(&coupled, &paper, &rules);
    let by_paper: Vec<Vec<f64>> = functions
        .iter()
        .map(|each| paper.values_of(*each, square, count))
        .collect::<Result<_, _>>()
        .map_err(unsolvable)?;
    let mut numbers = [0; 3];
    let series = |(index, mode): (usize, &CoupledMode)| {
        let label = label(&mode.shares, &mut numbers);
        let of = |values: &Vec<f64>| values.get(index).copied().and_then(frequency);
        let bound = |value: f64| (mode.eigenvalue >= 0.0).then(|| sqrt(value.max(0.0)));
        ConvergeSeries {
            label,
            dof: label.dof,
            number: label.number,
            classical_rad_s: by_paper.iter().map(of).collect(),
            converged_rad_s: frequency(mode.eigenvalue),
            lower_rad_s: mode.bounds.and_then(|(lower, _)| bound(lower)),
            upper_rad_s: mode.bounds.and_then(|(_, upper)| bound(upper)),
            piecewise_functions: steps.iter().map(|(count, _)| *count).collect(),
            piecewise_rad_s: steps.iter().map(|(_, values)| of(values)).collect(),
        }
    };
    let all: Vec<ConvergeSeries> = found.modes.iter().enumerate().map(series).collect();
    Ok(ConvergeReport {
        schema: "bladefan-converge/1",
        blade: blade.name().to_string(),
        speed_rad_s: speed,
        model,
        functions,
        series: all.into_iter().filter(|series| settings.dofs.contains(&series.dof)).collect(),
        warnings,
    })
}
