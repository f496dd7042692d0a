//! Options of every command, one plain struct: defaults, reading from text, checks.

use super::model::couples;
use crate::blade::{Blade, PropellerMoment};
use crate::dof::Dof;
use crate::fault::{Fault, FaultCode, Faults};
use crate::figures::Shortest;
use crate::functions::BasisFamily;
use crate::units::{parse_angle, parse_speed};
use alloc::format;
use alloc::string::ToString;
use alloc::vec::Vec;

/// What mode shapes are scaled to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShapeScale {
    /// Largest absolute displacement of the sampled radii 1.
    Max,
    /// ∫ m X² dr = 1 in bending (Eq. 86), ∫ X² dr = l/2 in torsion (Eq. 87).
    Mass,
}

/// Rotor speeds FROM:TO:COUNT, evenly spaced, both ends included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedRange {
    /// First speed [rad/s], at least 0.
    pub from: f64,
    /// Last speed [rad/s], greater than the first.
    pub to: f64,
    /// How many, 2 … 100000.
    pub count: usize,
}

impl SpeedRange {
    /// The speeds, ascending; the last is exactly `to`.
    pub fn speeds(&self) -> Vec<f64> {
        let last = self.count.saturating_sub(1).max(1);
        (0..self.count)
            .map(|i| if i == last { self.to } else { self.from + (self.to - self.from) * (i as f64 / last as f64) })
            .collect()
    }
}

/// Functions per degree of freedom that the paper calls converged.
pub const PAPER_FUNCTIONS: usize = 15;
/// Most speeds a chart may have.
const MOST_SPEEDS: usize = 100_000;
/// Most frequencies of one degree of freedom in a chart: speeds times modes.
const MOST_VALUES: usize = 1_000_000;
/// Slowest and fastest speeds that are not rest [rad/s]; beyond, squares would not stay numbers.
const LEAST_SPEED: f64 = 1e-9;
const MOST_SPEED: f64 = 1e9;
/// Most modes per degree of freedom.
const MOST_MODES: usize = 50;
/// Largest pitch and precone [rad]; those of a blade file.
const MOST_PITCH: f64 = 1e6;
const MOST_CONE: f64 = 1.5;
/// Most assumed functions of the classical family.
const MOST_FUNCTIONS: usize = 200;
/// Most radii a shape may be sampled at.
const MOST_POINTS: usize = 10_001;
/// Most harmonics.
const MOST_HARMONICS: u32 = 100;

/// Options of every command. Any value is legal here; the analysis checks what it uses.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Rotor speed [rad/s]; `None`: nominal.
    pub speed: Option<f64>,
    /// Speeds of the fan chart; `None`: 0 to 1.2 × nominal, 101 speeds.
    pub speeds: Option<SpeedRange>,
    /// Modes per degree of freedom. 5: what the paper's charts show.
    pub modes: usize,
    /// Degrees of freedom, each at most once; results keep the order flap, lag, torsion. All three are those that the
    /// blade has; one of fewer that it does not have is a fault.
    pub dofs: Vec<Dof>,
    /// Family of assumed functions.
    pub basis: BasisFamily,
    /// Number of assumed functions of the classical family; [`PAPER_FUNCTIONS`].
    pub functions: usize,
    /// Rays 1P … nP.
    pub harmonics: u32,
    /// Radii per mode shape.
    pub points: usize,
    /// Scale of mode shapes.
    pub normalise: ShapeScale,
    /// Largest number of functions of a convergence study. 16: as in the paper's Fig. 6–7.
    pub up_to: usize,
    /// Operating band as ratios of nominal speed; crossings inside are marked.
    pub band: (f64, f64),
    /// What is solved; `None`: the coupled model where the blade is coupled at all, see
    /// [`model_for`](Self::model_for).
    pub model: Option<ModelKind>,
    /// Modes of a coupled blade, all motions together.
    pub coupled_modes: usize,
    /// Collective pitch [rad] in place of the blade's own; coupled.
    pub pitch: Option<f64>,
    /// Precone [rad] in place of the blade's own; coupled.
    pub precone: Option<f64>,
    /// Whether the tension of the fibres stiffens torsion; `None`: where the blade has data for it. Coupled.
    pub trapeze: Option<bool>,
    /// Whether sections have rotary inertia in bending; coupled.
    pub rotary: bool,
    /// Whether Coriolis terms act; coupled modes at one speed.
    pub gyroscopic: bool,
    /// Which propeller moment acts; `None`: the full one in the coupled model, the paper's in the uncoupled one.
    pub propeller_moment: Option<PropellerMoment>,
}

/// Whether flap, lag and torsion feel one another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModelKind {
    /// Each on its own, as in the paper.
    Uncoupled,
    /// With twist, pitch, precone and offsets.
    Coupled,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            speed: None,
            speeds: None,
            modes: 5,
            dofs: Dof::ALL.to_vec(),
            basis: BasisFamily::Piecewise,
            functions: PAPER_FUNCTIONS,
            harmonics: 10,
            points: 101,
            normalise: ShapeScale::Max,
            up_to: 16,
            band: (0.9, 1.1),
            model: None,
            coupled_modes: 12,
            pitch: None,
            precone: None,
            trapeze: None,
            rotary: true,
            gyroscopic: false,
            propeller_moment: None,
        }
    }
}

impl Settings {
    /// The defaults, of one model.
    pub fn of(model: ModelKind) -> Self {
        Self { model: Some(model), ..Self::default() }
    }

    /// Sets one option by its command-line name from its command-line text.
    ///
    /// # Errors
    /// A name that is not an option, or a text that the option cannot be read from. Ranges are
    /// checked by [`check`](Self::check).
    pub fn set(&mut self, name: &str, text: &str) -> Result<(), Fault> {
        let refuse = |rule: &str| Err(option_fault(name, text, rule));
        match name {
            // The range is looked at here too: only here is the value in the user's unit.
            "speed" => match parse_speed(text) {
                Some(speed) => match speed_rule(speed) {
                    None => self.speed = Some(speed),
                    Some(rule) => return refuse(rule),
                },
                None => return refuse("must be a speed like 69.1, 660rpm, 11Hz or 69.1rad/s"),
            },
            "speeds" => match parse_range(text) {
                Some(range) => self.speeds = Some(range),
                None => return refuse("must be FROM:TO:COUNT like 0:792rpm:101"),
            },
            "dof" => match parse_dofs(text) {
                Some(dofs) => self.dofs = dofs,
                None => return refuse("must be one or more of flap, lag, torsion, each once, with commas"),
            },
            "basis" => match text {
                "classical" => self.basis = BasisFamily::Classical,
                "piecewise" => self.basis = BasisFamily::Piecewise,
                _ => return refuse("must be piecewise or classical"),
            },
            "normalise" => match text {
                "max" => self.normalise = ShapeScale::Max,
                "mass" => self.normalise = ShapeScale::Mass,
                _ => return refuse("must be max or mass"),
            },
            "model" => match text {
                "auto" => self.model = None,
                "uncoupled" => self.model = Some(ModelKind::Uncoupled),
                "coupled" => self.model = Some(ModelKind::Coupled),
                _ => return refuse("must be auto, uncoupled or coupled"),
            },
            "pitch" | "precone" => {
                let Some(angle) = parse_angle(text) else { return refuse("must be an angle like 8deg or 0.14rad") };
                match name {
                    "pitch" => self.pitch = Some(angle),
                    _ => self.precone = Some(angle),
                }
            }
            "trapeze" | "rotary" | "gyroscopic" => {
                let on = match text {
                    "on" => true,
                    "off" => false,
                    _ => return refuse("must be on or off"),
                };
                match name {
                    "trapeze" => self.trapeze = Some(on),
                    "gyroscopic" => self.gyroscopic = on,
                    _ => self.rotary = on,
                }
            }
            "propeller_moment" => match text {
                "full" => self.propeller_moment = Some(PropellerMoment::Full),
                "paper" => self.propeller_moment = Some(PropellerMoment::Paper),
                _ => return refuse("must be full or paper"),
            },
            "band" => match parse_band(text) {
                Some(band) => self.band = band,
                None => return refuse("must be FROM:TO as ratios of nominal speed like 0.9:1.1"),
            },
            "harmonics" => match text.parse() {
                Ok(count) => self.harmonics = count,
                Err(_) => return refuse("must be a whole number"),
            },
            "modes" | "functions" | "points" | "up_to" => {
                let Ok(count) = text.parse() else { return refuse("must be a whole number") };
                match name {
                    "modes" => (self.modes, self.coupled_modes) = (count, count),
                    "functions" => self.functions = count,
                    "points" => self.points = count,
                    _ => self.up_to = count,
                }
            }
            _ => return Err(option_fault(name, text, "is not an option")),
        }
        Ok(())
    }

    /// Looks at every option.
    ///
    /// # Errors
    /// Every option that is outside its range.
    pub fn check(&self) -> Result<(), Faults> {
        self.faults(self.basis == BasisFamily::Classical).none()
    }

    /// The same for a convergence study: the number of functions varies there, so
    /// [`functions`](Self::functions) does not limit the number of modes.
    ///
    /// # Errors
    /// Every option that is outside its range.
    pub fn check_converge(&self) -> Result<(), Faults> {
        self.faults(false).none()
    }

    /// The model to solve: the one chosen, or else the coupled one where twist, pitch, precone, an offset or an
    /// angle of the springs couples the motions of the blade.
    pub fn model_for(&self, blade: &Blade) -> ModelKind {
        let coupled = |blade| couples(blade, self.pitch, self.precone);
        let by_blade = || if coupled(blade) { ModelKind::Coupled } else { ModelKind::Uncoupled };
        self.model.unwrap_or_else(by_blade)
    }

    /// Refuses Coriolis terms where a question is without them.
    pub(super) fn still(&self) -> Result<(), Faults> {
        let rule = "acts in modes at one speed, with piecewise functions";
        if self.gyroscopic { Err(option_fault("gyroscopic", "on", rule).into()) } else { Ok(()) }
    }

    /// Refuses the coupled model where a question is of the uncoupled one.
    pub(super) fn uncoupled(&self) -> Result<(), Faults> {
        match self.model {
            None | Some(ModelKind::Uncoupled) => Ok(()),
            Some(ModelKind::Coupled) => Err(option_fault("model", "coupled", "has a question of its own").into()),
        }
    }

    fn faults(&self, functions_act: bool) -> Faults {
        let mut faults = Vec::new();
        let mut require = |holds: bool, name: &str, value: &dyn core::fmt::Display, rule: &str| {
            if !holds {
                faults.push(option_fault(name, &value.to_string(), rule));
            }
        };
        if let Some(speed) = self.speed {
            let broken = speed_rule(speed);
            require(broken.is_none(), "speed", &Shortest(speed), broken.unwrap_or_default());
        }
        if let Some(pitch) = self.pitch {
            require(pitch.abs() <= MOST_PITCH, "pitch", &Shortest(pitch), "must be between -1e6 and 1e6 rad");
        }
        if let Some(precone) = self.precone {
            require(precone.abs() <= MOST_CONE, "precone", &Shortest(precone), "must be between -1.5 and 1.5 rad");
        }
        // One option sets both; its rule stands below.
        if self.coupled_modes != self.modes {
            let held = (1..=MOST_MODES).contains(&self.coupled_modes);
            require(held, "modes", &self.coupled_modes, "must be from 1 to 50");
        }
        if let Some(range) = self.speeds {
            let text = format!("{}:{}:{}", Shortest(range.from), Shortest(range.to), range.count);
            let ends = range.from >= 0.0 && range.from < range.to && range.to.is_finite();
            require(ends, "speeds", &text, "must have 0 <= FROM < TO, both finite");
            let fast = !ends || (LEAST_SPEED..=MOST_SPEED).contains(&range.to);
            require(fast, "speeds", &text, "must have a TO from 1e-9 to 1e9 rad/s");
            let count = (2..=MOST_SPEEDS).contains(&range.count);
            require(count, "speeds", &text, "must have a COUNT from 2 to 100000");
            let modes = self.modes.clamp(1, MOST_MODES);
            let most = format!("must have a COUNT of at most {} for {modes} modes", MOST_VALUES / modes);
            require(!count || range.count <= MOST_VALUES / modes, "speeds", &text, &most);
        }
        require((1..=MOST_MODES).contains(&self.modes), "modes", &self.modes, "must be from 1 to 50");
        require((1..=MOST_FUNCTIONS).contains(&self.functions), "functions", &self.functions, "must be from 1 to 200");
        let few = format!("must not be above functions ({})", self.functions);
        let enough = !functions_act || self.modes <= self.functions || self.modes > MOST_MODES;
        require(enough, "modes", &self.modes, &few);
        require((1..=MOST_FUNCTIONS).contains(&self.up_to), "up_to", &self.up_to, "must be from 1 to 200");
        require((1..=MOST_HARMONICS).contains(&self.harmonics), "harmonics", &self.harmonics, "must be from 1 to 100");
        require((2..=MOST_POINTS).contains(&self.points), "points", &self.points, "must be from 2 to 10001");
        let text = format!("{}:{}", Shortest(self.band.0), Shortest(self.band.1));
        let band = self.band.0 >= 0.0 && self.band.0 < self.band.1 && self.band.1.is_finite();
        require(band, "band", &text, "must have 0 <= FROM < TO, both finite");
        let distinct = Dof::ALL.iter().all(|dof| self.dofs.iter().filter(|other| *other == dof).count() <= 1);
        require(!self.dofs.is_empty() && distinct, "dof", &self.dofs.len(), "must be one or more, each once");
        faults.into()
    }

    /// The speed to solve at for a blade of this nominal speed.
    pub fn speed_or(&self, nominal: f64) -> f64 {
        self.speed.unwrap_or(nominal)
    }

    /// The speeds of the fan chart for a blade of this nominal speed.
    pub fn speeds_or(&self, nominal: f64) -> SpeedRange {
        self.speeds.unwrap_or(SpeedRange { from: 0.0, to: 1.2 * nominal, count: 101 })
    }

    /// The degrees of freedom asked for that a blade has, in the order of results.
    ///
    /// # Errors
    /// Torsion, asked for by itself, of a blade without torsion data.
    pub(super) fn dofs_of(&self, blade: &Blade) -> Result<Vec<Dof>, Faults> {
        let asked = |dof: &&Dof| self.dofs.contains(dof);
        if self.dofs.contains(&Dof::Torsion) && self.dofs.len() < Dof::ALL.len() && !blade.has_torsion() {
            let rule = "needs torsion data of the blade: [torsion], torsion_stiffness and polar_inertia";
            let message = format!("torsion {rule}");
            return Err(Fault::new(FaultCode::Missing, "dof", Some("torsion".into()), rule, message).into());
        }
        Ok(blade.dofs().iter().filter(asked).copied().collect())
    }
}

/// What a rotor speed must be.
const SPEED_RULE: &str = "must be finite and at least 0";
const SIZE_RULE: &str = "must be 0 or from 1e-9 to 1e9 rad/s";

/// The rule that a speed breaks.
fn speed_rule(speed: f64) -> Option<&'static str> {
    if !speed.is_finite() || speed < 0.0 {
        return Some(SPEED_RULE);
    }
    (speed > 0.0 && !(LEAST_SPEED..=MOST_SPEED).contains(&speed)).then_some(SIZE_RULE)
}

fn option_fault(name: &str, value: &str, rule: &str) -> Fault {
    Fault::new(FaultCode::Option, name, Some(value.to_string()), rule, format!("{rule} (is {value})"))
}

fn parse_range(text: &str) -> Option<SpeedRange> {
    let mut parts = text.split(':');
    let range = SpeedRange {
        from: parse_speed(parts.next()?)?,
        to: parse_speed(parts.next()?)?,
        count: parts.next()?.parse().ok()?,
    };
    parts.next().is_none().then_some(range)
}

fn parse_band(text: &str) -> Option<(f64, f64)> {
    let (from, to) = text.split_once(':')?;
    Some((from.parse().ok()?, to.parse().ok()?))
}

fn parse_dofs(text: &str) -> Option<Vec<Dof>> {
    text.split(',').map(|name| Dof::from_name(name.trim())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::String;
    use alloc::vec;

    fn told(settings: &Settings) -> String {
        settings.check().map_or_else(|faults| faults.to_string(), |()| String::new())
    }

    fn chart(from: f64, to: f64, count: usize, modes: usize) -> Settings {
        Settings { speeds: Some(SpeedRange { from, to, count }), modes, ..Settings::default() }
    }

    #[test]
    fn a_chart_has_a_limit_of_speeds_times_modes() {
        assert_eq!(told(&chart(0.0, 1.0, 100_000, 10)), "");
        assert_eq!(told(&chart(0.0, 1.0, 20_000, 50)), "");
        let rule = "speeds: must have a COUNT of at most 20000 for 50 modes (is 0:1:20001)";
        assert_eq!(told(&chart(0.0, 1.0, 20_001, 50)), rule);
        assert_eq!(told(&chart(0.0, 1.0, 100_001, 5)), "speeds: must have a COUNT from 2 to 100000 (is 0:1:100001)");
    }

    #[test]
    fn speeds_whose_squares_would_not_be_numbers_are_refused() {
        let at = |speed: f64| told(&Settings { speed: Some(speed), ..Settings::default() });
        assert_eq!((at(0.0), at(1e-9), at(1e9)), (String::new(), String::new(), String::new()));
        for (speed, rule) in [(1e80, "1e9"), (1e-200, "1e-9")] {
            assert!(
                at(speed).starts_with("speed: must be 0 or from 1e-9 to 1e9 rad/s"),
                "{speed} {rule}: {}",
                at(speed)
            );
        }
        assert_eq!(at(-1.0), "speed: must be finite and at least 0 (is -1)");
        assert_eq!(told(&chart(0.0, 1e10, 3, 5)), "speeds: must have a TO from 1e-9 to 1e9 rad/s (is 0:10000000000:3)");
        assert_eq!(told(&chart(2.0, 1.0, 3, 5)), "speeds: must have 0 <= FROM < TO, both finite (is 2:1:3)");
        let fault = Settings::default().set("speed", "1e80").unwrap_err();
        assert_eq!(fault.message, "must be 0 or from 1e-9 to 1e9 rad/s (is 1e80)");
    }

    #[test]
    fn every_option_outside_its_range_is_told_at_once() {
        let settings = Settings { modes: 0, points: 1, up_to: 201, dofs: vec![Dof::Flap; 2], ..Settings::default() };
        let faults = settings.check().unwrap_err();
        let names: Vec<&str> = faults.iter().map(|fault| fault.path.as_str()).collect();
        assert_eq!(names, ["modes", "up_to", "points", "dof"]);
    }
}
