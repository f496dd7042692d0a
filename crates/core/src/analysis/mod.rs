//! The facade: what the command line and the page call. It composes the other rooms and adds no
//! formula of its own.

mod basis;
mod compare;
mod report;
mod settings;

pub use compare::compare;
pub use report::{
    BasisReport, BladeSummary, Branch, Coincidence, ComparedPoint, ConvergeReport, ConvergeSeries, Crossing,
    DofSummary, FanChart, FunctionCounts, Margin, MeasuredPoint, ModeReport, ModesReport, Nominal, ShapeReport,
    ShapesReport, Southwell,
};
pub use settings::{BasisFamily, Settings, ShapeScale, SpeedRange};

use crate::blade::{Blade, RootCondition, moments};
use crate::converged::{Converged, TOLERANCE};
use crate::dof::Dof;
use crate::fan::{Curves, meet_rays};
use crate::fault::{Fault, FaultCode, Warning};
use crate::functions::MOST_ORDER;
use crate::lagrange::{SystemMatrices, tabulate, torsion_norm};
use crate::modes::{self, Mode, SolveError};
use crate::numerics::eigen::EigenError;
use crate::numerics::quadrature::GaussRules;
use crate::numerics::scalar::{round, sqrt};
use crate::order::ascending;
use crate::units;
use alloc::boxed::Box;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;
use basis::{Basis, Classical, converged, solve};

/// One plain line that says what the model is; it stands with every table and chart.
pub const MODEL: &str = "uncoupled, in vacuum, zero pitch, the paper's torsion term";

/// Frequencies of every degree of freedom asked for at one speed, with two-sided bounds and the
/// paper's values beside them.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn modes(blade: &Blade, settings: &Settings) -> Result<ModesReport, Vec<Fault>> {
    none(settings.check())?;
    let rules = GaussRules::new();
    let speed = settings.speed_or(blade.nominal_speed());
    let square = speed * speed;
    let mut report = ModesReport {
        schema: "bladefan-modes/1",
        blade: blade.name().to_string(),
        speed_rad_s: speed,
        basis: BasisReport { family: settings.basis, functions: FunctionCounts::default() },
        classical_functions: settings.functions,
        modes: Vec::new(),
        warnings: blade.warnings().to_vec(),
    };
    for dof in settings.ordered_dofs() {
        let for_bounds = settings.basis == BasisFamily::Classical;
        let paper = Classical::new(blade, dof, settings.functions, &rules, for_bounds);
        // One mode more than asked for separates the last one from the rest.
        let found = converged(blade, dof, (square, square), settings.modes + 1, &rules)?;
        let reference = solve(found.matrices(), speed, settings.modes + 1)?;
        let by_paper = available(&paper.matrices, square, settings.modes).map_err(unsolvable)?;
        let error = found.error();
        let basis = match settings.basis {
            BasisFamily::Classical => Basis::Classical(Box::new(paper)),
            BasisFamily::Piecewise => Basis::Piecewise(Box::new(found)),
        };
        let solved = match settings.basis {
            BasisFamily::Classical => solve(basis.matrices(), speed, settings.modes)?,
            BasisFamily::Piecewise => reference.get(..settings.modes).unwrap_or(&reference).to_vec(),
        };
        let bounds = basis.bounds(&solved, &reference, square, &rules);
        report.basis.functions.set(dof, basis.count());
        note(&mut report.warnings, dof, error);
        for (index, (mode, interval)) in solved.iter().zip(&bounds.intervals).enumerate() {
            let per_rev = units::per_rev(mode.frequency, speed);
            let margin = per_rev.map(|per_rev| margin(label(dof, index + 1), per_rev));
            report.modes.push(ModeReport {
                label: label(dof, index + 1),
                dof,
                number: index + 1,
                frequency_rad_s: mode.frequency,
                frequency_hz: units::hz(mode.frequency),
                per_rev,
                nearest_harmonic: margin.as_ref().map(|margin| margin.nearest_harmonic),
                margin_per_rev: margin.as_ref().map(|margin| margin.margin_per_rev),
                lower_rad_s: Some(sqrt(interval.lower)),
                upper_rad_s: Some(sqrt(interval.upper)),
                separation_rad_s: bounds.separation.map(|square| sqrt(square.max(0.0))),
                classical_rad_s: by_paper.get(index).map(|mode| mode.frequency),
                converged_rad_s: reference.get(index).map(|mode| mode.frequency),
                residual: mode.residual,
            });
        }
    }
    Ok(report)
}

/// How far each mode is from the nearest harmonic, as at nominal speed in a fan chart; nothing at rest.
pub fn margins(report: &ModesReport) -> Vec<Margin> {
    report.modes.iter().filter_map(|mode| Some(margin(mode.label.clone(), mode.per_rev?))).collect()
}

/// Fan chart: branches over a range of speeds, crossings with the nP rays, margins at nominal
/// speed, Southwell coefficients.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn fan(blade: &Blade, settings: &Settings) -> Result<FanChart, Vec<Fault>> {
    none(settings.check())?;
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
        warnings: blade.warnings().to_vec(),
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
            label: label(dof, index + 1),
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
            label: label(dof, crossing.branch + 1),
            harmonic: crossing.harmonic,
            speed_rad_s: crossing.speed,
            frequency_rad_s: crossing.frequency,
        }));
        chart.coincident.extend(
            rays.coincident.iter().map(|&(branch, harmonic)| Coincidence { label: label(dof, branch + 1), harmonic }),
        );
        let at_nominal = solve(matrices, nominal, settings.modes)?;
        chart.nominal.margins.extend(
            at_nominal.iter().enumerate().map(|(index, mode)| margin(label(dof, index + 1), mode.frequency / nominal)),
        );
    }
    Ok(chart)
}

/// Mode shapes along the span at one speed.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn shapes(blade: &Blade, settings: &Settings) -> Result<ShapesReport, Vec<Fault>> {
    none(settings.check())?;
    let rules = GaussRules::new();
    let speed = settings.speed_or(blade.nominal_speed());
    let (inner, radius) = (blade.least_offset(), blade.radius());
    let last = settings.points - 1;
    let at = |i: usize| if i == last { radius } else { inner + (radius - inner) * (i as f64 / last as f64) };
    let radii: Vec<f64> = (0..settings.points).map(at).collect();
    let mut report = ShapesReport {
        schema: "bladefan-shapes/1",
        blade: blade.name().to_string(),
        speed_rad_s: speed,
        basis: BasisReport { family: settings.basis, functions: FunctionCounts::default() },
        r_m: Vec::new(),
        radius_m: radius,
        shapes: Vec::new(),
        warnings: blade.warnings().to_vec(),
    };
    for dof in settings.ordered_dofs() {
        let basis = Basis::new(blade, dof, settings, (speed * speed, speed * speed), settings.modes, &rules)?;
        report.basis.functions.set(dof, basis.count());
        note(&mut report.warnings, dof, basis.error());
        let solved = solve(basis.matrices(), speed, settings.modes)?;
        let mass = basis.matrices().mass().clone();
        let orthogonality = modes::orthogonality(&mass, &solved);
        let functions = basis.into_functions();
        let tables = tabulate(blade, dof, functions.as_ref(), &radii, &rules);
        let norm = match (settings.normalise, dof) {
            (ShapeScale::Max, _) => None,
            (ShapeScale::Mass, Dof::Flap | Dof::Lag) => Some(mass),
            (ShapeScale::Mass, Dof::Torsion) => Some(torsion_norm(blade, functions.as_ref(), &rules)),
        };
        let sampled = modes::shapes(&tables, &solved, speed * speed, norm.as_ref());
        report.shapes.extend(solved.iter().zip(sampled).enumerate().map(|(index, (mode, shape))| ShapeReport {
            label: label(dof, index + 1),
            dof,
            number: index + 1,
            frequency_rad_s: mode.frequency,
            orthogonality: orthogonality[index],
            displacement: shape.displacement,
            slope: shape.slope,
            moment: shape.moment,
        }));
    }
    report.r_m = radii;
    Ok(report)
}

/// Frequency against the number of assumed functions at one speed. The functions are nested, so
/// the matrices of fewer functions are leading parts of those of the most.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn converge(blade: &Blade, settings: &Settings) -> Result<ConvergeReport, Vec<Fault>> {
    none(settings.check_converge())?;
    let rules = GaussRules::new();
    let speed = settings.speed_or(blade.nominal_speed());
    let mut report = ConvergeReport {
        schema: "bladefan-converge/1",
        blade: blade.name().to_string(),
        speed_rad_s: speed,
        functions: (1..=settings.up_to).collect(),
        series: Vec::new(),
        warnings: blade.warnings().to_vec(),
    };
    let square = speed * speed;
    for dof in settings.ordered_dofs() {
        let matrices = Classical::new(blade, dof, settings.up_to, &rules, false).matrices;
        let mut values = vec![Vec::with_capacity(settings.up_to); settings.modes];
        for &count in &report.functions {
            let solved = available(&matrices.leading(count), square, settings.modes).map_err(unsolvable)?;
            for (index, series) in values.iter_mut().enumerate() {
                series.push(solved.get(index).map(|mode| mode.frequency));
            }
        }
        let steps = piecewise_steps(blade, dof, speed, settings.modes, &rules)?;
        let found = converged(blade, dof, (square, square), settings.modes + 1, &rules)?;
        let reference = solve(found.matrices(), speed, settings.modes + 1)?;
        let error = found.error();
        let solved = reference.get(..settings.modes).unwrap_or(&reference);
        let bounds = Basis::Piecewise(Box::new(found)).bounds(solved, &reference, square, &rules);
        note(&mut report.warnings, dof, error);
        report.series.extend(values.into_iter().enumerate().map(|(index, classical_rad_s)| ConvergeSeries {
            label: label(dof, index + 1),
            dof,
            number: index + 1,
            classical_rad_s,
            converged_rad_s: solved.get(index).map(|mode| mode.frequency),
            lower_rad_s: bounds.intervals.get(index).map(|interval| sqrt(interval.lower)),
            upper_rad_s: bounds.intervals.get(index).map(|interval| sqrt(interval.upper)),
            piecewise_functions: steps.iter().map(|(count, _)| *count).collect(),
            piecewise_rad_s: steps.iter().map(|(_, modes)| modes.get(index).map(|mode| mode.frequency)).collect(),
        }));
    }
    Ok(report)
}

/// Modes with more and more piecewise functions: one polynomial per element, two, three, … until
/// they are converged.
fn piecewise_steps(
    blade: &Blade,
    dof: Dof,
    speed: f64,
    count: usize,
    rules: &GaussRules,
) -> Result<Vec<(usize, Vec<Mode>)>, Vec<Fault>> {
    let mut steps = Vec::new();
    for order in 1..=MOST_ORDER {
        let cause = |cause| unsolvable(SolveError { dof, cause });
        let found = Converged::with_order(blade, dof, speed * speed, count, order, rules).map_err(cause)?;
        let modes = available(found.matrices(), speed * speed, count).map_err(unsolvable)?;
        let done = found.error() <= TOLERANCE && modes.len() == count;
        steps.push((found.count(), modes));
        if done {
            break;
        }
    }
    Ok(steps)
}

/// Mass, inertia and static moments of a blade.
pub fn summary(blade: &Blade) -> BladeSummary {
    let dofs = Dof::ALL.into_iter().map(|dof| {
        let root = blade.root(dof);
        let [mass, first, second] = moments(blade.mass(), root.offset, blade.radius());
        let torsion = dof == Dof::Torsion;
        let [polar, _, _] = moments(blade.polar_inertia(), root.offset, blade.radius());
        DofSummary {
            dof,
            root: match (root.condition, torsion) {
                (RootCondition::Clamped, false) => "hingeless",
                (RootCondition::Free, false) => "hinged",
                (RootCondition::Spring(_), false) => "spring-hinged",
                (RootCondition::Clamped, true) => "rigid",
                (RootCondition::Free, true) => "free",
                (RootCondition::Spring(_), true) => "spring",
            },
            offset_m: root.offset,
            spring_n_m: match root.condition {
                RootCondition::Spring(spring) => Some(spring),
                RootCondition::Clamped | RootCondition::Free => None,
            },
            mass_kg: mass,
            static_moment_kg_m: (!torsion).then_some(first),
            inertia_kg_m2: if torsion { polar } else { second },
        }
    });
    let stations: Vec<f64> = Dof::ALL
        .into_iter()
        .map(|dof| blade.stiffness(dof))
        .chain([blade.mass(), blade.polar_inertia(), blade.mass_offset()])
        .flat_map(|property| property.stations().iter().copied())
        .collect();
    let mut stations = ascending(&stations);
    stations.dedup();
    BladeSummary {
        schema: "bladefan-check/1",
        blade: blade.name().to_string(),
        radius_m: blade.radius(),
        nominal_speed_rad_s: blade.nominal_speed(),
        blades: blade.blades(),
        stations: stations.len(),
        dofs: dofs.collect(),
        warnings: blade.warnings().to_vec(),
    }
}

fn none(faults: Vec<Fault>) -> Result<(), Vec<Fault>> {
    if faults.is_empty() { Ok(()) } else { Err(faults) }
}

/// As many modes as so few functions determine.
fn available(matrices: &SystemMatrices, speed_squared: f64, count: usize) -> Result<Vec<Mode>, SolveError> {
    match modes::solve(matrices, speed_squared, count) {
        Err(SolveError { cause: EigenError::TooFewModes(0), .. }) => Ok(Vec::new()),
        Err(SolveError { cause: EigenError::TooFewModes(left), .. }) => modes::solve(matrices, speed_squared, left),
        other => other,
    }
}

fn unsolvable(error: SolveError) -> Vec<Fault> {
    let rule = "the equations of the degree of freedom must have an answer";
    vec![Fault::new(FaultCode::Unsolvable, error.dof.name(), None, rule, error.to_string())]
}

/// Says so where the piecewise functions did not reach their tolerance.
fn note(warnings: &mut Vec<Warning>, dof: Dof, error: f64) {
    if error > TOLERANCE {
        warnings.push(Warning {
            path: dof.name().to_string(),
            message: format!("{dof} frequencies are converged to {:.0e} only, not to {TOLERANCE:.0e}", 0.5 * error),
        });
    }
}

/// `1F`, `2L`, …
fn label(dof: Dof, number: usize) -> String {
    format!("{number}{}", dof.letter())
}

fn margin(label: String, per_rev: f64) -> Margin {
    let nearest = round(per_rev).max(1.0);
    // A frequency of more than 4 billion per revolution keeps the largest harmonic there is.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at least 1; the cast saturates")]
    let nearest_harmonic = nearest as u32;
    Margin { label, per_rev, nearest_harmonic, margin_per_rev: per_rev - nearest }
}
