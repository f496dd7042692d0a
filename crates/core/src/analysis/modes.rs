//! Frequencies at one speed.

use super::basis::{Basis, Classical, converged, separated, solve};
use super::model::{turning, uncoupled};
use super::{Settings, available, margin, note, note_bounds, note_fewer, unsolvable, warnings};
use crate::blade::Blade;
use crate::converged::{Wanted, Work};
use crate::fault::Faults;
use crate::functions::BasisFamily;
use crate::label::Label;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::{maximum, sqrt};
use crate::report::{BasisReport, FunctionCounts, Margin, ModeReport, ModesReport};
use crate::units;
use alloc::boxed::Box;
use alloc::string::ToString;
use alloc::vec::Vec;

/// Frequencies of every degree of freedom asked for at one speed, with two-sided bounds and the
/// paper's values beside them.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn modes(blade: &Blade, settings: &Settings) -> Result<ModesReport, Faults> {
    settings.check()?;
    settings.uncoupled()?;
    let blade = &*turning(blade, settings)?;
    let rules = GaussRules::new();
    let speed = settings.speed_or(blade.nominal_speed());
    let square = speed * speed;
    let mut report = ModesReport {
        schema: "bladefan-modes/1",
        blade: blade.name().to_string(),
        speed_rad_s: speed,
        model: uncoupled(blade, settings),
        basis: BasisReport { family: settings.basis, functions: FunctionCounts::default() },
        classical_functions: settings.functions,
        modes: Vec::new(),
        warnings: warnings(blade),
    };
    for dof in settings.dofs_of(blade)? {
        let for_bounds = settings.basis == BasisFamily::Classical;
        let paper = Classical::new(blade, dof, settings.functions, &rules, for_bounds);
        // One mode more than asked for separates the last one from the rest.
        let found = converged(blade, dof, &Wanted::at(square, settings.modes + 1), &rules, &Work::default())?;
        let reference = solve(found.matrices(), speed, settings.modes + 1)?;
        let by_paper = available(&paper.matrices, square, settings.modes).map_err(unsolvable)?;
        let error = found.error();
        let separation = separated(&found, &reference);
        let basis = match settings.basis {
            BasisFamily::Classical => Basis::Classical(Box::new(paper)),
            BasisFamily::Piecewise => Basis::Piecewise(Box::new(found)),
        };
        let solved = match settings.basis {
            BasisFamily::Classical => solve(basis.matrices(), speed, settings.modes)?,
            BasisFamily::Piecewise => reference.get(..settings.modes).unwrap_or(&reference).to_vec(),
        };
        let bounds = basis.bounds(&solved, &separation, square, &rules);
        note_bounds(&mut report.warnings, dof, bounds.is_some());
        note_fewer(&mut report.warnings, dof, solved.len(), settings.modes);
        report.basis.functions.set(dof, basis.count());
        note(&mut report.warnings, dof, error);
        for (index, mode) in solved.iter().enumerate() {
            let interval = bounds.as_ref().and_then(|bounds| bounds.intervals.get(index));
            let better = bounds.as_ref().and_then(|bounds| bounds.eigenvalues.get(index));
            // The same bits where the value is the same.
            let frequency = better.map_or(mode.frequency, |value| sqrt(*value));
            let converged = match settings.basis {
                BasisFamily::Classical => reference.get(index).map(|mode| mode.frequency),
                BasisFamily::Piecewise => Some(frequency),
            };
            let per_rev = units::per_rev(frequency, speed);
            let margin = per_rev.map(|per_rev| margin(Label::new(dof, index + 1), per_rev));
            report.modes.push(ModeReport {
                label: Label::new(dof, index + 1),
                dof,
                number: index + 1,
                frequency_rad_s: frequency,
                frequency_hz: units::hz(frequency),
                per_rev,
                nearest_harmonic: margin.as_ref().map(|margin| margin.nearest_harmonic),
                margin_per_rev: margin.as_ref().map(|margin| margin.margin_per_rev),
                lower_rad_s: interval.map(|interval| sqrt(interval.lower)),
                upper_rad_s: interval.map(|interval| sqrt(interval.upper)),
                separation_rad_s: bounds
                    .as_ref()
                    .and_then(|bounds| bounds.separation)
                    .map(|square| sqrt(maximum(square, 0.0))),
                classical_rad_s: by_paper.get(index).map(|mode| mode.frequency),
                converged_rad_s: converged,
                residual: mode.residual,
            });
        }
    }
    Ok(report)
}

/// How far each mode is from the nearest harmonic, as at nominal speed in a fan chart; nothing at rest.
pub fn margins(report: &ModesReport) -> Vec<Margin> {
    report.modes.iter().filter_map(|mode| Some(margin(mode.label, mode.per_rev?))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blade::{BladeDefinition, Property, RootDefinition, check};
    use crate::dof::Dof;

    /// Free in lag about the axis: exactly 0 at every speed, also where heavy blocks on soft stretches make
    /// the other eigenvalues come from their own fields.
    #[test]
    fn what_is_free_stays_at_zero_between_heavy_blocks() {
        let r = [0.0, 0.3323, 0.3323, 0.3333, 0.3333, 0.6658, 0.6658, 0.6668, 0.6668, 0.9995, 0.9995, 1.0005];
        let blocks = |soft: f64, heavy: f64| -> [(f64, f64); 12] {
            core::array::from_fn(|i| (r[i], if i % 4 < 2 { soft } else { heavy }))
        };
        let blade = BladeDefinition::new("wells", 1.0005, 1.0)
            .with_flap(RootDefinition::hinged(0.0))
            .with_lag(RootDefinition::hinged(0.0))
            .with_torsion(RootDefinition::rigid(0.0))
            .with(Property::Mass, blocks(1.0, 5.097e8))
            .with(Property::FlapStiffness, blocks(1.0, 10650.0))
            .with(Property::LagStiffness, blocks(3.0, 31950.0))
            .with(Property::TorsionStiffness, blocks(1.0, 10650.0))
            .with(Property::PolarInertia, blocks(1.0, 1.0));
        let blade = check(&blade).unwrap();
        for speed in [0.012, 0.1, 0.7, 1.2] {
            let settings = Settings { speed: Some(speed), dofs: alloc::vec![Dof::Lag], ..Settings::default() };
            let report = modes(&blade, &settings).unwrap();
            let first = &report.modes[0];
            assert_eq!((first.frequency_rad_s, first.lower_rad_s, first.upper_rad_s), (0.0, Some(0.0), Some(0.0)));
            assert!(report.modes.iter().all(|mode| mode.frequency_rad_s >= 0.0), "{speed}: {:?}", report.modes);
        }
    }
}
