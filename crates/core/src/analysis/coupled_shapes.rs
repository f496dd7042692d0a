//! Mode shapes of a coupled blade.

use super::coupled::{label, model, paper_functions, unsolvable};
use super::shapes::radii;
use super::{Settings, ShapeScale};
use crate::blade::Blade;
use crate::coupled::{self, Classical, Sample};
use crate::dof::Dof;
use crate::fault::Faults;
use crate::functions::BasisFamily;
use crate::modes::nodes;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::sqrt;
use crate::report::{
    BasisReport, BendingComponent, Components, CoupledShapeReport, CoupledShapesReport, FunctionCounts, Shares,
    TorsionComponent,
};
use alloc::string::ToString;
use alloc::vec::Vec;

/// Mode shapes of the whole blade along the span at one speed, with forces and moments from equilibrium. Flap is
/// out of the disc plane and lag in it, whatever the local angle.
///
/// # Errors
/// Faults in the settings, inertias that are impossible, or equations without an answer.
pub fn coupled_shapes(blade: &Blade, settings: &Settings) -> Result<CoupledShapesReport, Faults> {
    settings.check()?;
    settings.still()?;
    let (coupled, model, warnings) = model(blade, settings)?;
    let speed = settings.speed_or(blade.nominal_speed());
    let r_m = radii(blade, settings);
    let (square, count, rules) = (speed * speed, settings.coupled_modes, GaussRules::new());
    let (modes, functions, samples) = match settings.basis {
        BasisFamily::Piecewise => {
            let (found, samples) = coupled::shapes(&coupled, square, count, &r_m, &rules).map_err(unsolvable)?;
            (found.modes, found.functions, samples)
        }
        BasisFamily::Classical => {
            let functions = paper_functions(blade, settings.functions);
            let paper = Classical::new(&coupled, &functions, &rules);
            let found = paper.modes(square, count, None).map_err(unsolvable)?;
            let samples = paper.samples(&found, square, &r_m);
            (found.modes, paper.counts(), samples)
        }
    };
    let mut numbers = [0; 3];
    let mut shapes = Vec::new();
    for (mode, samples) in modes.iter().zip(&samples) {
        let label = label(&mode.shares, &mut numbers);
        if !settings.dofs.contains(&label.dof) {
            continue;
        }
        let leading = displacement(samples, label.dof);
        let largest = leading.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        let size = match settings.normalise {
            ShapeScale::Max if largest > 0.0 => 1.0 / largest,
            ShapeScale::Max | ShapeScale::Mass => 1.0,
        };
        let factor = if leading.last().is_some_and(|tip| *tip < 0.0) { -size } else { size };
        let components = components(samples, factor);
        let [flap, lag, torsion] = mode.shares;
        shapes.push(CoupledShapeReport {
            label,
            dof: label.dof,
            number: label.number,
            shares: Shares { flap, lag, torsion },
            frequency_rad_s: (mode.eigenvalue >= 0.0).then(|| sqrt(mode.eigenvalue)),
            nodes_m: nodes(&r_m, components.leading(label.dof)),
            components,
        });
    }
    Ok(CoupledShapesReport {
        schema: "bladefan-shapes/1",
        blade: blade.name().to_string(),
        speed_rad_s: speed,
        model,
        basis: BasisReport { family: settings.basis, functions: FunctionCounts::of(blade.dofs(), functions) },
        r_m,
        radius_m: blade.radius(),
        shapes,
        warnings,
    })
}

fn displacement(samples: &[Sample], dof: Dof) -> Vec<f64> {
    samples.iter().map(|sample| sample.fields[3 * dof.index()]).collect()
}

fn components(samples: &[Sample], factor: f64) -> Components {
    let of = |at: fn(&Sample) -> f64| -> Vec<f64> { samples.iter().map(|sample| factor * at(sample)).collect() };
    Components {
        flap: BendingComponent {
            displacement: of(|at| at.fields[0]),
            slope: of(|at| at.fields[1]),
            moment: of(|at| at.forces[1]),
            force: of(|at| at.forces[0]),
        },
        lag: BendingComponent {
            displacement: of(|at| at.fields[3]),
            slope: of(|at| at.fields[4]),
            moment: of(|at| at.forces[3]),
            force: of(|at| at.forces[2]),
        },
        torsion: TorsionComponent { twist: of(|at| at.fields[6]), moment: of(|at| at.forces[4]) },
    }
}
