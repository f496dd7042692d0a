//! Fan charts of coupled blades.

use super::coupled::{label, model, paper_functions, unsolvable};
use super::{Settings, frequency, margin};
use crate::blade::Blade;
use crate::coupled::{Bounded, Classical, CoupledBlade, Range, RangeMode};
use crate::fan::{Branches, Meets, OnBranch, meet};
use crate::fault::{Fault, FaultCode, Faults, Warning};
use crate::functions::BasisFamily;
use crate::label::Label;
use crate::numerics::eigen::EigenError;
use crate::numerics::quadrature::GaussRules;
use crate::report::{
    BasisReport, Branch, BranchLabel, Coincidence, Crossing, FanChart, FunctionCounts, Margin, Nominal, Southwell,
    VeeringReport,
};
use alloc::format;
use alloc::string::ToString;
use alloc::vec::Vec;

/// Branches beyond those shown that are followed, which may cross them.
const BEYOND: usize = 2;
/// Beside rest, as a share of nominal speed.
const BESIDE_REST: f64 = 1e-3;
/// λ within this of 0, as a share of the highest, is the rounding of a rigid motion.
const NOTHING: f64 = 1e-12;

/// The fan chart of a coupled blade: branches over a range of speeds, labelled by their leading motion at nominal
/// speed, with proven bounds at every speed; veerings, crossings with the nP rays, margins at nominal speed.
///
/// # Errors
/// Faults in the settings, inertias that are impossible, or equations without an answer.
pub(super) fn coupled_fan(blade: &Blade, settings: &Settings) -> Result<FanChart, Faults> {
    settings.still()?;
    let (coupled, model, mut warnings) = model(blade, settings)?;
    let nominal = blade.nominal_speed();
    let drawn = settings.speeds_or(nominal);
    let highest = drawn.to.max(nominal);
    let reach = Branches::reach(nominal, highest);
    let range = range(blade, &coupled, reach * reach, settings)?;
    if !range.is_converged() {
        let message = format!("frequencies are converged to {:.0e} only", 0.5 * range.error());
        warnings.push(Warning { path: "coupled".into(), message });
    }
    let followed = Followed::new(&range, nominal, highest, settings).map_err(unsolvable)?;
    let speeds = drawn.speeds();
    let branches = followed.branches(&speeds).map_err(unsolvable)?;
    let mut chart = FanChart {
        schema: "bladefan-fan/1",
        blade: blade.name().to_string(),
        blades: blade.blades(),
        harmonics: settings.harmonics,
        basis: BasisReport { family: settings.basis, functions: FunctionCounts::of(blade.dofs(), range.functions()) },
        speeds_rad_s: speeds,
        crossings: Vec::new(),
        coincident: Vec::new(),
        nominal: Nominal { speed_rad_s: nominal, margins: followed.margins() },
        veerings: followed.veerings((drawn.from, drawn.to)),
        branches,
        warnings,
        model,
    };
    followed.meet_rays((drawn.from, drawn.to), &mut chart).map_err(unsolvable)?;
    Ok(chart)
}

/// The functions that the settings ask for, up to a speed.
fn range(blade: &Blade, coupled: &CoupledBlade, highest: f64, settings: &Settings) -> Result<Range, Faults> {
    let (count, rules) = (settings.coupled_modes, GaussRules::new());
    let range = match settings.basis {
        BasisFamily::Piecewise => Range::new(coupled, highest, count, &rules),
        BasisFamily::Classical => {
            let functions = paper_functions(blade, settings.functions);
            let most = (blade.dofs().len() * settings.functions).saturating_sub(BEYOND + 1);
            if count > most {
                let rule = format!("must be at most {most} with so few functions");
                let message = format!("{rule} (is {count})");
                return Err(Fault::new(FaultCode::Option, "modes", Some(count.to_string()), rule, message).into());
            }
            Range::classical(&Classical::new(coupled, &functions, &rules), highest, count)
        }
    };
    range.map_err(unsolvable)
}

/// The frequencies of modes at their own rotor speeds, each found by its label there; `None` where there is no such
/// mode among those asked for.
///
/// # Errors
/// As of the chart.
pub(super) fn coupled_at(
    blade: &Blade,
    points: &[(Label, f64)],
    settings: &Settings,
) -> Result<Vec<Option<f64>>, Faults> {
    settings.still()?;
    let (coupled, ..) = model(blade, settings)?;
    let highest = points.iter().map(|point| point.1).fold(blade.nominal_speed(), f64::max);
    let range = range(blade, &coupled, highest * highest, settings)?;
    let at = |&(named, speed): &(Label, f64)| {
        let modes = called(&range, speed, settings.coupled_modes)?;
        let found = modes.iter().find(|(_, label)| label.dof == named.dof && label.number == named.number);
        let nothing = NOTHING * modes.last().map_or(0.0, |(mode, _)| mode.eigenvalue.abs());
        Ok(found.and_then(|(mode, _)| shown(mode.eigenvalue, nothing)))
    };
    points.iter().map(at).collect::<Result<_, EigenError>>().map_err(unsolvable)
}

/// The lowest modes at a rotor speed and what they are called there.
fn called(range: &Range, speed: f64, count: usize) -> Result<Vec<(RangeMode, Label)>, EigenError> {
    let mut numbers = [0; 3];
    let name = |mode: RangeMode| {
        let label = label(&mode.shares, &mut numbers);
        (mode, label)
    };
    Ok(range.modes(speed * speed, count)?.into_iter().map(name).collect())
}

/// ω of an eigenvalue that is 0 within `nothing`; `None` where unstable.
fn shown(eigenvalue: f64, nothing: f64) -> Option<f64> {
    match eigenvalue {
        value if value < -nothing => None,
        value if value <= nothing => Some(0.0),
        value => Some(frequency(value)),
    }
}

/// The branches of a coupled blade.
struct Followed<'a> {
    range: &'a Range,
    branches: Branches,
    /// At the nodes, by sorted position: what each mode is, and what it is called.
    at_nodes: Vec<Vec<(RangeMode, Label)>>,
    /// At nominal speed: of the branches shown, which one, its label and its frequency; none where it is unstable.
    shown: Vec<(usize, Label, Option<f64>)>,
    nominal: f64,
    modes: usize,
}

impl<'a> Followed<'a> {
    fn new(range: &'a Range, nominal: f64, highest: f64, settings: &Settings) -> Result<Self, EigenError> {
        let modes = settings.coupled_modes;
        let called = |speed: f64| called(range, speed, modes + BEYOND);
        let nodes = Branches::nodes(nominal, highest);
        let mut at_nodes: Vec<_> = nodes.iter().map(|speed| called(*speed)).collect::<Result<_, EigenError>>()?;
        // Motions that are rigid at rest have one eigenvalue there, 0, and are told apart as soon as it turns.
        let nothing = NOTHING * at_nodes[0].last().map_or(0.0, |(mode, _)| mode.eigenvalue.abs());
        for (at_rest, turning) in at_nodes[0].iter_mut().zip(called(BESIDE_REST * nominal)?) {
            if at_rest.0.eigenvalue.abs() <= nothing {
                *at_rest = (RangeMode { eigenvalue: 0.0, ..turning.0 }, turning.1);
            }
        }
        let values = at_nodes.iter().map(|modes| modes.iter().map(|(mode, _)| mode.eigenvalue).collect()).collect();
        let branches = Branches::new(&|speed| range.eigenvalues(speed * speed), nodes, values, modes + BEYOND)?;
        let at_nominal = called(nominal)?;
        let nothing = NOTHING * at_nominal.last().map_or(0.0, |(mode, _)| mode.eigenvalue.abs());
        let shown = branches
            .order(nominal)
            .into_iter()
            .zip(at_nominal)
            .take(modes)
            .filter(|(_, (_, label))| settings.dofs.contains(&label.dof))
            .map(|(branch, (mode, label))| (branch, label, shown(mode.eigenvalue, nothing)))
            .collect();
        Ok(Self { range, branches, at_nodes, shown, nominal, modes })
    }

    fn margins(&self) -> Vec<Margin> {
        let of = |(index, &(_, label, frequency)): (usize, &(usize, Label, Option<f64>))| {
            Some(Margin { branch: Some(index), ..margin(label, frequency? / self.nominal) })
        };
        self.shown.iter().enumerate().filter_map(of).collect()
    }

    /// The branches at these rotor speeds, ascending, with their bounds.
    fn branches(&self, speeds: &[f64]) -> Result<Vec<Branch>, EigenError> {
        let squares: Vec<f64> = speeds.iter().map(|speed| speed * speed).collect();
        let found = self.range.bounded(&squares)?;
        let mut all: Vec<Branch> = self.shown.iter().map(|&(branch, label, _)| self.empty(branch, label)).collect();
        for (speed, Bounded { eigenvalues: values, bounds }) in speeds.iter().zip(&found) {
            let nothing = NOTHING * values.last().map_or(0.0, |v| v.abs());
            let positions = self.branches.positions(*speed);
            for (out, &(branch, ..)) in all.iter_mut().zip(&self.shown) {
                let position = positions[branch];
                let value = values[position];
                let interval = bounds.as_ref().ok().filter(|_| position < self.modes).and_then(|all| all.get(position));
                let proven = interval.is_some_and(|(lower, _)| *lower > 0.0);
                // Without a number where the blade is unstable: a gap in the chart.
                let zero = if proven { 0.0 } else { nothing };
                out.frequency_rad_s.push(shown(value, zero).unwrap_or(f64::NAN));
                if !self.range.is_bounded() {
                    continue;
                }
                out.lower_rad_s.push(interval.filter(|_| value >= -nothing).map(|(lower, _)| frequency(*lower)));
                out.upper_rad_s.push(interval.filter(|_| value >= -nothing).map(|(_, upper)| frequency(*upper)));
            }
        }
        Ok(all)
    }

    /// What a branch is called at a rotor speed: as at the nodes on either side, or by a solve where they differ.
    fn label(&self, branch: usize, speed: f64) -> Result<Label, EigenError> {
        let above = self.branches.nodes.partition_point(|node| *node < speed);
        let near = above.saturating_sub(1)..(above + 1).min(self.branches.nodes.len());
        let mut labels =
            near.map(|node| self.at_nodes[node][self.branches.positions(self.branches.nodes[node])[branch]].1);
        let first = labels.next().filter(|first| labels.all(|label| label == *first));
        let solved = || Ok(called(self.range, speed, self.branches.count())?[self.branches.positions(speed)[branch]].1);
        first.map_or_else(solved, Ok)
    }

    /// A branch without speeds: its labels along the range, at the nodes where they change, and how it starts.
    fn empty(&self, branch: usize, label: Label) -> Branch {
        let mut labels: Vec<BranchLabel> = Vec::new();
        for (speed, modes) in self.branches.nodes.iter().zip(&self.at_nodes) {
            let here = modes[self.branches.positions(*speed)[branch]].1;
            if labels.last().is_none_or(|last| last.label != here) {
                labels.push(BranchLabel { from_rad_s: *speed, label: here });
            }
        }
        let start = &self.at_nodes[0][branch].0;
        Branch {
            label,
            dof: label.dof,
            number: label.number,
            frequency_rad_s: Vec::new(),
            southwell: Southwell { k0: start.eigenvalue, k1: start.slope },
            labels,
            lower_rad_s: Vec::new(),
            upper_rad_s: Vec::new(),
        }
    }

    /// The veerings and crossings of branches that are shown.
    fn veerings(&self, (from, to): (f64, f64)) -> Vec<VeeringReport> {
        let index = |branch: usize| self.shown.iter().position(|shown| shown.0 == branch);
        let mut order: Vec<usize> = (0..self.branches.count()).collect();
        let mut all = Vec::new();
        for veering in &self.branches.veerings {
            let (lower, upper) = (order[veering.position], order[veering.position + 1]);
            if veering.crosses {
                order.swap(veering.position, veering.position + 1);
            }
            if let (Some(first), Some(second), true) =
                (index(lower), index(upper), (from..=to).contains(&veering.speed))
            {
                all.push(VeeringReport {
                    branches: [first, second],
                    kind: if veering.crosses { "crossing" } else { "veering" },
                    speed_rad_s: veering.speed,
                    gap_rad_s: veering.gap,
                    frequency_rad_s: veering.frequency,
                });
            }
        }
        all
    }

    /// Adds where the branches meet the rays ω = nΩ, by root solving on them.
    fn meet_rays(&self, (from, to): (f64, f64), chart: &mut FanChart) -> Result<(), EigenError> {
        // λ and dλ/dΩ² of every branch at the ends of the range and the nodes between.
        let mut stations: Vec<(f64, Vec<(f64, f64)>)> = Vec::new();
        let mut add = |speed: f64, modes: &[RangeMode]| {
            let at = |position: usize| (modes[position].eigenvalue, modes[position].slope);
            stations.push((speed, self.branches.positions(speed).into_iter().map(at).collect()));
        };
        if from > 0.0 {
            add(from, &self.range.modes(from * from, self.branches.count())?);
        } else {
            // What is rigid at rest starts on every ray and crosses none there.
            let at_rest: Vec<RangeMode> = self.at_nodes[0].iter().map(|(mode, _)| mode.clone()).collect();
            add(0.0, &at_rest);
        }
        for (speed, modes) in self.branches.nodes.iter().zip(&self.at_nodes) {
            if *speed > from && *speed < to {
                let modes: Vec<RangeMode> = modes.iter().map(|(mode, _)| mode.clone()).collect();
                add(*speed, &modes);
            }
        }
        add(to, &self.range.modes(to * to, self.branches.count())?);
        for (index, &(branch, label, _)) in self.shown.iter().enumerate() {
            let known: Vec<OnBranch> = stations
                .iter()
                .map(|(speed, values)| OnBranch { speed: *speed, value: values[branch].0, slope: values[branch].1 })
                .collect();
            let at = |speed: f64| Ok(self.range.eigenvalues(speed * speed)?[self.branches.positions(speed)[branch]]);
            let Meets { crossings, coincident } = meet(&known, chart.harmonics, at)?;
            for (harmonic, speed_rad_s) in crossings {
                chart.crossings.push(Crossing {
                    label: self.label(branch, speed_rad_s)?,
                    branch: index,
                    harmonic,
                    speed_rad_s,
                    frequency_rad_s: f64::from(harmonic) * speed_rad_s,
                });
            }
            chart.coincident.extend(coincident.into_iter().map(|harmonic| Coincidence {
                label,
                branch: index,
                harmonic,
            }));
        }
        Ok(())
    }
}
