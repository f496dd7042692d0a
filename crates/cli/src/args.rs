//! The commands and their options.

mod settings;

use crate::help;
use bladefan_core::chart::{ChartOptions, FrequencyUnit, Theme};
use bladefan_core::units::SpeedUnit;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{ArgGroup, Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

/// Natural frequencies, mode shapes and fan charts of rotating blades: flap, lag and torsion, each on
/// its own (uncoupled), in vacuum, at zero pitch.
#[derive(Debug, Parser)]
#[command(name = "bladefan", version, after_help = help::NOTES, max_term_width = 100)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Frequencies of every degree of freedom at one rotor speed.
    #[command(after_help = help::MODES)]
    Modes(ModesArgs),
    /// Fan chart: frequencies over rotor speed, crossings with the nP rays, margins at nominal speed.
    #[command(after_help = help::FAN)]
    Fan(FanArgs),
    /// Mode shapes along the span at one rotor speed.
    #[command(after_help = help::SHAPES)]
    Shapes(ShapesArgs),
    /// Frequency against the number of assumed functions.
    #[command(after_help = help::CONVERGE)]
    Converge(ConvergeArgs),
    /// Look a blade over: every fault with its place, or mass, inertia and static moments.
    #[command(after_help = help::CHECK)]
    Check(CheckArgs),
    /// List the built-in blades, or print the file of one.
    #[command(after_help = help::BLADES)]
    Blades(BladesArgs),
}

/// How a result is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    // No doc comments: clap would print them as a list under the option.
    Table,
    Json,
    Csv,
}

/// The group of options that make a drawing.
const PICTURE: &str = "picture";

/// A word that the core knows, out of the words it lists.
fn word<T: Copy + Send + Sync + 'static>(
    all: &[T],
    name: fn(T) -> &'static str,
    from_name: fn(&str) -> Option<T>,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(all.iter().map(|choice| name(*choice)))
        .try_map(move |text| from_name(&text).ok_or("must be one of the words above"))
}

#[derive(Debug, Args)]
pub(crate) struct BladeArg {
    /// Built-in name, .toml or .json file, or - for standard input
    #[arg(value_name = "BLADE")]
    pub(crate) blade: String,
}

#[derive(Debug, Args)]
pub(crate) struct ResultArgs {
    /// table for reading; json (one line) and csv with all digits
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub(crate) format: Format,
    /// Write the result to FILE, not to standard output
    #[arg(long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}

/// Options that make drawings, and options of drawings, which need one.
#[derive(Debug, Args)]
#[command(group = ArgGroup::new(PICTURE).multiple(true))]
pub(crate) struct DrawingArgs {
    /// Also draw to FILE as SVG
    #[arg(long, value_name = "FILE", group = PICTURE)]
    pub(crate) svg: Option<PathBuf>,
    /// Also draw to FILE as PNG, at twice the width (Latin, Greek and Cyrillic letters)
    #[arg(long, value_name = "FILE", group = PICTURE)]
    pub(crate) png: Option<PathBuf>,
    /// Colours of the drawing
    #[arg(
        long,
        requires = PICTURE,
        value_parser = word(&Theme::ALL, Theme::name, Theme::from_name),
        default_value = Theme::default().name()
    )]
    pub(crate) theme: Theme,
    /// Width of the drawing in pixels [default: 960]
    #[arg(long, value_name = "PIXELS", requires = PICTURE, value_parser = clap::value_parser!(u32).range(320..=8000))]
    pub(crate) width: Option<u32>,
    /// Height of the drawing in pixels, held to 0.4 to 1.6 of the width [default: as suits the width]
    #[arg(long, value_name = "PIXELS", requires = PICTURE)]
    pub(crate) height: Option<u32>,
    /// Unit of rotor speeds in the drawing
    #[arg(
        long,
        requires = PICTURE,
        value_name = "UNIT",
        value_parser = word(SpeedUnit::ALL, SpeedUnit::name, SpeedUnit::from_name),
        default_value = ChartOptions::default().speed_unit.name()
    )]
    pub(crate) speed_unit: SpeedUnit,
}

impl DrawingArgs {
    /// Whether anything is drawn.
    pub(crate) fn any(&self) -> bool {
        self.svg.is_some() || self.png.is_some()
    }
}

#[derive(Debug, Args)]
pub(crate) struct FrequencyUnitArg {
    /// Unit of frequencies in the drawing
    #[arg(
        long,
        requires = PICTURE,
        value_name = "UNIT",
        value_parser = word(&FrequencyUnit::ALL, FrequencyUnit::name, FrequencyUnit::from_name),
        default_value = FrequencyUnit::default().name()
    )]
    pub(crate) frequency_unit: FrequencyUnit,
}

#[derive(Debug, Args)]
pub(crate) struct SolverArgs {
    /// Modes per degree of freedom [default: 5]
    #[arg(long, value_name = "K", allow_hyphen_values = true)]
    modes: Option<String>,
    /// Degrees of freedom [default: flap,lag,torsion]
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    dof: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct FamilyArgs {
    /// Assumed functions: piecewise (converged, with bounds) or classical (the paper's) [default: piecewise]
    #[arg(long, value_name = "FAMILY", allow_hyphen_values = true)]
    basis: Option<String>,
    /// Number of classical functions per degree of freedom [default: 15]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    functions: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct SpeedArg {
    /// Rotor speed, like 69.1 (rad/s), 660rpm or 11Hz [default: the blade's nominal speed]
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    speed: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct ModesArgs {
    #[command(flatten)]
    pub(crate) blade: BladeArg,
    #[command(flatten)]
    speed: SpeedArg,
    #[command(flatten)]
    solver: SolverArgs,
    #[command(flatten)]
    family: FamilyArgs,
    #[command(flatten)]
    model: ModelArgs,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
}

/// What is solved.
#[derive(Debug, Args)]
struct ModelArgs {
    /// uncoupled: flap, lag and torsion each on its own; coupled: with twist, pitch, precone and offsets, 12 modes
    /// of the whole blade; auto: coupled where the blade has any of these [default: auto]
    #[arg(long, value_name = "MODEL")]
    model: Option<String>,
    /// Collective pitch of the coupled model, like 8deg, nose up [default: the blade's]
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pitch: Option<String>,
    /// Precone of the coupled model, tip up [default: the blade's]
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    precone: Option<String>,
    /// Stiffening of torsion by tension in the coupled model, on or off [default: where the blade has data for it]
    #[arg(long, value_name = "ON|OFF")]
    trapeze: Option<String>,
    /// Rotary inertia in bending in the coupled model, on or off [default: on]
    #[arg(long, value_name = "ON|OFF")]
    rotary: Option<String>,
    /// Coriolis terms in coupled modes at one speed, on or off [default: off]
    #[arg(long, value_name = "ON|OFF")]
    gyroscopic: Option<String>,
    /// Propeller moment that torsion feels, full or paper [default: full in the coupled model, else paper]
    #[arg(long, value_name = "FULL|PAPER")]
    propeller_moment: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct FanArgs {
    #[command(flatten)]
    pub(crate) blade: BladeArg,
    /// Rotor speeds, both ends included, like 0:800rpm:101 [default: 0 to 1.2 × nominal, 101 speeds]
    #[arg(long, value_name = "FROM:TO:COUNT", allow_hyphen_values = true)]
    speeds: Option<String>,
    /// Rays 1P … NP [default: 10]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    harmonics: Option<String>,
    /// Operating band as ratios of nominal speed [default: 0.9:1.1]
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true)]
    band: Option<String>,
    /// Measured points to set beside the branches (CSV)
    #[arg(long, value_name = "FILE")]
    pub(crate) measured: Option<PathBuf>,
    /// What the frequency axis of the drawing shows, in its unit, like 0:500 [default: what suits]
    #[arg(long, value_name = "FROM:TO", requires = PICTURE, allow_hyphen_values = true)]
    frequencies: Option<String>,
    #[command(flatten)]
    solver: SolverArgs,
    #[command(flatten)]
    family: FamilyArgs,
    #[command(flatten)]
    model: ModelArgs,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) drawing: DrawingArgs,
    #[command(flatten)]
    pub(crate) frequency: FrequencyUnitArg,
}

#[derive(Debug, Args)]
pub(crate) struct ShapesArgs {
    #[command(flatten)]
    pub(crate) blade: BladeArg,
    #[command(flatten)]
    speed: SpeedArg,
    /// Radii per mode shape, both ends included [default: 101]
    #[arg(long, value_name = "COUNT", allow_hyphen_values = true)]
    points: Option<String>,
    /// Scale of the shapes: max (largest displacement 1) or mass (the paper's Eq. 86-87) [default: max]
    #[arg(long, value_name = "HOW", allow_hyphen_values = true)]
    normalise: Option<String>,
    #[command(flatten)]
    solver: SolverArgs,
    #[command(flatten)]
    family: FamilyArgs,
    #[command(flatten)]
    model: ModelArgs,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) drawing: DrawingArgs,
}

#[derive(Debug, Args)]
pub(crate) struct ConvergeArgs {
    #[command(flatten)]
    pub(crate) blade: BladeArg,
    #[command(flatten)]
    speed: SpeedArg,
    /// Largest number of assumed functions [default: 16]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    up_to: Option<String>,
    #[command(flatten)]
    solver: SolverArgs,
    // Taken, as by every command; but a convergence study has both families anyway.
    #[arg(long, value_name = "FAMILY", allow_hyphen_values = true, hide = true)]
    basis: Option<String>,
    #[command(flatten)]
    model: ModelArgs,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) drawing: DrawingArgs,
    #[command(flatten)]
    pub(crate) frequency: FrequencyUnitArg,
}

#[derive(Debug, Args)]
pub(crate) struct CheckArgs {
    #[command(flatten)]
    pub(crate) blade: BladeArg,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
}

#[derive(Debug, Args)]
pub(crate) struct BladesArgs {
    /// Print the file of this blade
    pub(crate) name: Option<String>,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
}
