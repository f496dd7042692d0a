//! Options as settings. Values stay text up to here: the core reads and checks them
//! (`Settings::set`), so that the page and the command line have the same rules and messages.

use super::{ConvergeArgs, FamilyArgs, FanArgs, Format, ModelArgs, ModesArgs, ShapesArgs, SolverArgs};
use crate::failure::Failure;
use bladefan_core::BasisFamily;
use bladefan_core::chart::parse_frequencies;
use bladefan_core::{Faults, Warning};
use bladefan_core::{ModelKind, Settings};

/// Options by the names that the core knows them by.
type Given<'a> = Vec<(&'static str, &'a Option<String>)>;

/// Reads options into settings and checks them; every fault at once.
fn read(given: Given<'_>) -> Result<Settings, Failure> {
    let settings = set(given)?;
    checked(settings.check()).map(|()| settings)
}

fn set(given: Given<'_>) -> Result<Settings, Failure> {
    let mut settings = Settings::default();
    let mut faults = Vec::new();
    for (name, text) in given {
        if let Some(text) = text
            && let Err(fault) = settings.set(name, text)
        {
            faults.push(fault);
        }
    }
    checked(Faults::from(faults).none()).map(|()| settings)
}

fn checked(checked: Result<(), Faults>) -> Result<(), Failure> {
    checked.map_err(|faults| Failure::options(&faults))
}

/// A warning about an option that has no effect.
fn does_nothing(option: &str, why: &str) -> Warning {
    Warning { path: format!("--{option}"), message: why.into() }
}

impl SolverArgs {
    fn given(&self) -> Given<'_> {
        vec![("modes", &self.modes), ("dof", &self.dof)]
    }
}

impl FamilyArgs {
    fn given(&self) -> Given<'_> {
        vec![("basis", &self.basis), ("functions", &self.functions)]
    }

    /// Where results hold nothing of the family that is not asked for.
    fn idle(&self, settings: &Settings) -> Option<Warning> {
        let idle = self.functions.is_some() && settings.basis != BasisFamily::Classical;
        idle.then(|| does_nothing("functions", "acts with --basis classical only"))
    }
}

impl ModelArgs {
    fn given(&self) -> Given<'_> {
        let mut given = self.coupled_only().to_vec();
        given.extend([("model", &self.model), ("propeller_moment", &self.propeller_moment)]);
        given
    }

    fn coupled_only(&self) -> [(&'static str, &Option<String>); 5] {
        [
            ("pitch", &self.pitch),
            ("precone", &self.precone),
            ("trapeze", &self.trapeze),
            ("rotary", &self.rotary),
            ("gyroscopic", &self.gyroscopic),
        ]
    }

    /// The options given that the model has no use for.
    fn idle(&self, model: ModelKind) -> Vec<Warning> {
        let given = self.coupled_only().into_iter().filter(|(_, text)| text.is_some());
        let idle = given.filter(|_| model != ModelKind::Coupled);
        idle.map(|(name, _)| does_nothing(&name.replace('_', "-"), "acts in the coupled model only")).collect()
    }
}

impl ModesArgs {
    pub(crate) fn settings(&self) -> Result<Settings, Failure> {
        let mut given = vec![("speed", &self.speed.speed)];
        given.extend(self.solver.given());
        given.extend(self.family.given());
        given.extend(self.model.given());
        read(given)
    }

    /// The options given that nothing of the result shows.
    pub(crate) fn idle(&self, model: ModelKind) -> Vec<Warning> {
        self.model.idle(model)
    }
}

impl FanArgs {
    /// The settings, and the range of the frequency axis.
    pub(crate) fn settings(&self) -> Result<(Settings, Option<(f64, f64)>), Failure> {
        let mut given = vec![("speeds", &self.speeds), ("harmonics", &self.harmonics), ("band", &self.band)];
        given.extend(self.solver.given());
        given.extend(self.family.given());
        given.extend(self.model.given());
        let window = self.frequencies.as_deref().map(parse_frequencies).transpose();
        match (read(given), window) {
            (Ok(settings), Ok(window)) => Ok((settings, window)),
            (settings, window) => Err(Failure::both(settings.err(), window.err().as_ref())),
        }
    }

    /// The options given that nothing of the result shows.
    pub(crate) fn idle(&self, settings: &Settings, model: ModelKind) -> Vec<Warning> {
        let branches_only = self.result.format == Format::Csv && !self.drawing.any();
        let no_band = self.result.format != Format::Table && !self.drawing.any();
        let cases = [
            (branches_only && self.measured.is_some(), "measured", "is in the table, JSON and drawings, not in CSV"),
            (branches_only && self.harmonics.is_some(), "harmonics", "is in the table, JSON and drawings, not in CSV"),
            (no_band && self.band.is_some(), "band", "is in the table and drawings only"),
        ];
        let shown = cases.into_iter().filter(|(idle, ..)| *idle).map(|(_, option, why)| does_nothing(option, why));
        self.family.idle(settings).into_iter().chain(self.model.idle(model)).chain(shown).collect()
    }
}

impl ShapesArgs {
    pub(crate) fn settings(&self) -> Result<Settings, Failure> {
        let mut given = vec![("speed", &self.speed.speed), ("points", &self.points), ("normalise", &self.normalise)];
        given.extend(self.solver.given());
        given.extend(self.family.given());
        given.extend(self.model.given());
        read(given)
    }

    /// The options given that nothing of the result shows.
    pub(crate) fn idle(&self, settings: &Settings, model: ModelKind) -> Vec<Warning> {
        self.family.idle(settings).into_iter().chain(self.model.idle(model)).collect()
    }
}

impl ConvergeArgs {
    pub(crate) fn settings(&self) -> Result<Settings, Failure> {
        let mut given = vec![("speed", &self.speed.speed), ("up_to", &self.up_to), ("basis", &self.basis)];
        given.extend(self.solver.given());
        given.extend(self.model.given());
        let settings = set(given)?;
        checked(settings.check_converge()).map(|()| settings)
    }

    /// The options given that nothing of the result shows.
    pub(crate) fn idle(&self, model: ModelKind) -> Vec<Warning> {
        let both = self.basis.iter().map(|_| does_nothing("basis", "a convergence study has both families"));
        both.chain(self.model.idle(model)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Cli, Command};
    use bladefan_core::ModelKind;
    use clap::Parser;

    /// What is said of options that do nothing in `bladefan fan uniform …`.
    fn idle(options: &str) -> Vec<String> {
        let line = format!("bladefan fan uniform {options}");
        match Cli::try_parse_from(line.split_whitespace()).unwrap().command {
            Command::Fan(args) => args
                .idle(&args.settings().unwrap().0, ModelKind::Uncoupled)
                .into_iter()
                .map(|warning| warning.path)
                .collect(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn options_that_nothing_shows_are_told() {
        assert_eq!(idle("--functions 20"), ["--functions"]);
        assert_eq!(idle("--functions 20 --basis classical"), [""; 0]);
        let all = "--measured a.csv --harmonics 3 --band 0.8:1.2";
        assert_eq!(idle(all), [""; 0]);
        assert_eq!(idle(&format!("{all} --format json")), ["--band"]);
        assert_eq!(idle(&format!("{all} --format csv")), ["--measured", "--harmonics", "--band"]);
        assert_eq!(idle(&format!("{all} --format csv --svg a.svg")), [""; 0]);
    }
}
