//! Fan charts: frequencies over a range of rotor speeds.

use super::basis::{Basis, solve};
use super::{Settings, margin, note, unsolvable, warnings};
use crate::blade::Blade;
use crate::fan::{Curves, meet_rays};
use crate::fault::Faults;
use crate::label::Label;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::sqrt;
use crate::report::{BasisReport, Branch, Coincidence, Crossing, FanChart, FunctionCounts, Nominal, Southwell};
use alloc::string::ToString;
use alloc::vec::Vec;

/// Fan chart: branches over a range of speeds, crossings with the nP rays, margins at nominal
/// speed, Southwell coefficients.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn fan(blade: &Blade, settings: &Settings) -> Result<FanChart, Faults> {
    settings.check()?;
    let rules = GaussRules::new();
    let nominal = blade.nominal_speed();
    let range = settings.speeds_or(nominal);
    let highest = range.to.max(nominal);
    let mut chart = FanChart {
        schema: "bladefan-fan/1",
        blade: blade.name().to_string(),
        blades: blade.blades(),
        harmonics: settings.harmonics,
        basis: BasisReport { family: settings.basis, functions: FunctionCounts::default() },
        speeds_rad_s: range.speeds(),
        branches: Vec::new(),
        crossings: Vec::new(),
        coincident: Vec::new(),
        nominal: Nominal { speed_rad_s: nominal, margins: Vec::new() },
        warnings: warnings(blade),
    };
    for dof in settings.ordered_dofs() {
        // From rest, where the Southwell coefficients are taken, past nominal speed.
        let basis = Basis::new(blade, dof, settings, (0.0, highest * highest), settings.modes, &rules)?;
        chart.basis.functions.set(dof, basis.count());
        note(&mut chart.warnings, dof, basis.error());
        let matrices = basis.matrices();
        let at_rest = solve(matrices, 0.0, settings.modes)?;
        let curves =
            Curves::fit(matrices, &at_rest, range.from * range.from, range.to * range.to).map_err(unsolvable)?;
        chart.branches.extend(at_rest.iter().enumerate().map(|(index, mode)| Branch {
            label: Label::new(dof, index + 1),
            dof,
            number: index + 1,
            frequency_rad_s: Vec::with_capacity(range.count),
            southwell: Southwell { k0: mode.eigenvalue, k1: mode.southwell },
        }));
        let first = chart.branches.len() - at_rest.len();
        for speed in &chart.speeds_rad_s {
            let values = curves.eigenvalues(speed * speed);
            for (branch, value) in chart.branches[first..].iter_mut().zip(values) {
                branch.frequency_rad_s.push(sqrt(value));
            }
        }
        let rays = meet_rays(&curves, settings.harmonics);
        chart.crossings.extend(rays.crossings.iter().map(|crossing| Crossing {
            label: Label::new(dof, crossing.branch + 1),
            harmonic: crossing.harmonic,
            speed_rad_s: crossing.speed,
            frequency_rad_s: crossing.frequency,
        }));
        chart.coincident.extend(
            rays.coincident
                .iter()
                .map(|&(branch, harmonic)| Coincidence { label: Label::new(dof, branch + 1), harmonic }),
        );
        let at_nominal = solve(matrices, nominal, settings.modes)?;
        chart.nominal.margins.extend(
            at_nominal
                .iter()
                .enumerate()
                .map(|(index, mode)| margin(Label::new(dof, index + 1), mode.frequency / nominal)),
        );
    }
    Ok(chart)
}
