//! The facade: what the command line and the page call. It composes the other rooms and adds no
//! formula of its own.

mod report;
mod settings;

pub use report::{
    BasisReport, BladeSummary, Branch, Coincidence, ConvergeReport, ConvergeSeries, Crossing, DofSummary, FanChart,
    FunctionCounts, Margin, MeasuredPoint, ModeReport, ModesReport, Nominal, ShapeReport, ShapesReport, Southwell,
};
pub use settings::{BasisFamily, Settings, ShapeScale, SpeedRange};

use crate::blade::{Blade, RootCondition, moments};
use crate::dof::Dof;
use crate::fan::{Curves, meet_rays};
use crate::fault::{Fault, FaultCode};
use crate::lagrange::{SystemMatrices, assemble, classical_functions, tabulate, torsion_norm};
use crate::modes::{self, Mode, SolveError};
use crate::numerics::eigen::EigenError;
use crate::numerics::scalar::{round, sqrt};
use crate::units;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;

/// One plain line that says what the model is; it stands with every table and chart.
pub const MODEL: &str = "uncoupled, in vacuum, zero pitch, the paper's torsion term";

/// Frequencies of every degree of freedom asked for at one speed.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn modes(blade: &Blade, settings: &Settings) -> Result<ModesReport, Vec<Fault>> {
    none(settings.check())?;
    let speed = settings.speed_or(blade.nominal_speed());
    let mut report = ModesReport {
        schema: "bladefan-modes/1",
        blade: blade.name().to_string(),
        speed_rad_s: speed,
        basis: basis(settings),
        modes: Vec::new(),
        warnings: blade.warnings().to_vec(),
    };
    for dof in settings.ordered_dofs() {
        let solved = solve(&matrices(blade, dof, settings.functions), speed, settings.modes)?;
        report.modes.extend(solved.iter().enumerate().map(|(index, mode)| ModeReport {
            label: label(dof, index + 1),
            dof,
            number: index + 1,
            frequency_rad_s: mode.frequency,
            frequency_hz: units::hz(mode.frequency),
            per_rev: units::per_rev(mode.frequency, speed),
            lower_rad_s: None,
            upper_rad_s: None,
            classical_rad_s: Some(mode.frequency),
            residual: mode.residual,
        }));
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
    let nominal = blade.nominal_speed();
    let range = settings.speeds_or(nominal);
    let mut chart = FanChart {
        schema: "bladefan-fan/1",
        blade: blade.name().to_string(),
        blades: blade.blades(),
        harmonics: settings.harmonics,
        basis: basis(settings),
        speeds_rad_s: range.speeds(),
        branches: Vec::new(),
        crossings: Vec::new(),
        coincident: Vec::new(),
        nominal: Nominal { speed_rad_s: nominal, margins: Vec::new() },
        warnings: blade.warnings().to_vec(),
    };
    for dof in settings.ordered_dofs() {
        let matrices = matrices(blade, dof, settings.functions);
        let at_rest = solve(&matrices, 0.0, settings.modes)?;
        let curves =
            Curves::fit(&matrices, range.from * range.from, range.to * range.to, settings.modes).map_err(unsolvable)?;
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
        let at_nominal = solve(&matrices, nominal, settings.modes)?;
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
    let speed = settings.speed_or(blade.nominal_speed());
    let (inner, radius) = (blade.least_offset(), blade.radius());
    let last = settings.points - 1;
    let at = |i: usize| if i == last { radius } else { inner + (radius - inner) * (i as f64 / last as f64) };
    let radii: Vec<f64> = (0..settings.points).map(at).collect();
    let mut report = ShapesReport {
        schema: "bladefan-shapes/1",
        blade: blade.name().to_string(),
        speed_rad_s: speed,
        basis: basis(settings),
        r_m: Vec::new(),
        radius_m: radius,
        shapes: Vec::new(),
        warnings: blade.warnings().to_vec(),
    };
    for dof in settings.ordered_dofs() {
        let functions = classical_functions(blade, dof, settings.functions);
        let matrices = assemble(blade, dof, functions.as_ref());
        let solved = solve(&matrices, speed, settings.modes)?;
        let tables = tabulate(blade, dof, functions.as_ref(), &radii);
        let norm = match (settings.normalise, dof) {
            (ShapeScale::Max, _) => None,
            (ShapeScale::Mass, Dof::Flap | Dof::Lag) => Some(matrices.mass().clone()),
            (ShapeScale::Mass, Dof::Torsion) => Some(torsion_norm(blade, functions.as_ref())),
        };
        let sampled = modes::shapes(&tables, &solved, speed * speed, norm.as_ref());
        report.shapes.extend(solved.iter().zip(sampled).enumerate().map(|(index, (mode, shape))| ShapeReport {
            label: label(dof, index + 1),
            dof,
            number: index + 1,
            frequency_rad_s: mode.frequency,
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
    let speed = settings.speed_or(blade.nominal_speed());
    let mut report = ConvergeReport {
        schema: "bladefan-converge/1",
        blade: blade.name().to_string(),
        speed_rad_s: speed,
        functions: (1..=settings.up_to).collect(),
        series: Vec::new(),
        warnings: blade.warnings().to_vec(),
    };
    for dof in settings.ordered_dofs() {
        let matrices = matrices(blade, dof, settings.up_to);
        let mut values = vec![Vec::with_capacity(settings.up_to); settings.modes];
        for &count in &report.functions {
            let solved = available(&matrices.leading(count), speed * speed, settings.modes).map_err(unsolvable)?;
            for (index, series) in values.iter_mut().enumerate() {
                series.push(solved.get(index).map(|mode| mode.frequency));
            }
        }
        report.series.extend(values.into_iter().enumerate().map(|(index, classical_rad_s)| ConvergeSeries {
            label: label(dof, index + 1),
            dof,
            number: index + 1,
            classical_rad_s,
            converged_rad_s: None,
        }));
    }
    Ok(report)
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
    let mut stations: Vec<f64> = Dof::ALL
        .into_iter()
        .map(|dof| blade.stiffness(dof))
        .chain([blade.mass(), blade.polar_inertia(), blade.mass_offset()])
        .flat_map(|property| property.stations().iter().copied())
        .collect();
    stations.sort_by(f64::total_cmp);
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

fn matrices(blade: &Blade, dof: Dof, count: usize) -> SystemMatrices {
    assemble(blade, dof, classical_functions(blade, dof, count).as_ref())
}

fn solve(matrices: &SystemMatrices, speed: f64, count: usize) -> Result<Vec<Mode>, Vec<Fault>> {
    modes::solve(matrices, speed * speed, count).map_err(unsolvable)
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

fn basis(settings: &Settings) -> BasisReport {
    let asked = |dof: Dof| settings.dofs.contains(&dof).then_some(settings.functions);
    BasisReport {
        family: settings.basis,
        functions: FunctionCounts { flap: asked(Dof::Flap), lag: asked(Dof::Lag), torsion: asked(Dof::Torsion) },
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
