//! An options object as settings. Names and rules are core's: every value is turned into the text
//! that the command line would be given, and core reads that.

use crate::tree::{elements, entries};
use bladefan_core::Settings;
use bladefan_core::chart::{ChartOptions, FrequencyUnit, Theme, parse_frequencies};
use bladefan_core::figures::shortest;
use bladefan_core::formats::measured;
use bladefan_core::report::MeasuredPoint;
use bladefan_core::units::SpeedUnit;
use bladefan_core::{Fault, FaultCode, Faults};
use wasm_bindgen::JsValue;

/// What a call computes; each takes the options of the command of the same name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Analysis {
    Modes,
    Fan,
    Shapes,
    Converge,
    Compare,
}

/// Options of the model, of every analysis.
const MODEL: &[&str] = &["model", "pitch", "precone", "trapeze", "rotary", "gyroscopic", "propeller_moment"];

impl Analysis {
    /// What has a chart; modes are a table.
    const CHARTS: &[Self] = &[Self::Fan, Self::Shapes, Self::Converge];

    /// The kind of a chart, by name.
    pub(crate) fn of_chart(name: &str) -> Option<Self> {
        Self::CHARTS.iter().copied().find(|analysis| analysis.name() == name)
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Modes => "modes",
            Self::Fan => "fan",
            Self::Shapes => "shapes",
            Self::Converge => "converge",
            Self::Compare => "compare",
        }
    }

    const fn options(self) -> &'static [&'static str] {
        match self {
            Self::Modes => &["speed", "modes", "dof", "basis", "functions"],
            Self::Fan => &["speeds", "modes", "dof", "basis", "functions", "harmonics", "band"],
            Self::Shapes => &["speed", "modes", "dof", "basis", "functions", "points", "normalise"],
            Self::Converge => &["speed", "modes", "dof", "basis", "up_to"],
            Self::Compare => &["modes", "dof", "basis", "functions"],
        }
    }

    /// Whether the analysis has this option.
    fn has(self, name: &str) -> bool {
        self.options().contains(&name) || MODEL.contains(&name)
    }
}

/// Options of a drawing, beside those of its analysis.
#[derive(Clone, Debug, Default)]
pub(crate) struct Looks {
    theme: Theme,
    width: Option<u32>,
    height: Option<u32>,
    frequencies: Option<(f64, f64)>,
    speed_unit: Option<SpeedUnit>,
    frequency_unit: FrequencyUnit,
    measured: Vec<MeasuredPoint>,
}

impl Looks {
    /// As core takes them.
    pub(crate) fn chart_options(&self, settings: &Settings) -> ChartOptions<'_> {
        let default = ChartOptions::default();
        ChartOptions {
            theme: self.theme,
            width: self.width.unwrap_or(default.width),
            height: self.height,
            frequencies: self.frequencies,
            speed_unit: self.speed_unit.unwrap_or(default.speed_unit),
            frequency_unit: self.frequency_unit,
            band: settings.band,
            measured: &self.measured,
        }
    }

    /// Sets one option of a drawing; tells whether there is one of this name.
    fn set(&mut self, name: &str, text: &str, analysis: Analysis) -> Result<bool, Faults> {
        let refuse = |rule: &str| Err(option_fault(name, text, rule).into());
        match name {
            "theme" => match Theme::from_name(text) {
                Some(theme) => self.theme = theme,
                None => return refuse("must be light or dark"),
            },
            "width" => match text.parse() {
                Ok(width) => self.width = Some(width),
                Err(_) => return refuse("must be a whole number of pixels"),
            },
            "height" => match text.parse() {
                Ok(height) => self.height = Some(height),
                Err(_) => return refuse("must be a whole number of pixels"),
            },
            "speed_unit" => match SpeedUnit::from_name(text) {
                Some(unit) => self.speed_unit = Some(unit),
                None => return refuse("must be rad/s, rpm or Hz"),
            },
            "frequency_unit" => match FrequencyUnit::from_name(text) {
                Some(unit) => self.frequency_unit = unit,
                None => return refuse("must be rad/s, Hz, rpm or per-rev"),
            },
            "measured" if analysis == Analysis::Fan => self.measured = measured::read(text)?,
            "frequencies" if analysis == Analysis::Fan => {
                self.frequencies = Some(parse_frequencies(text)?);
            }
            _ => return Ok(false),
        }
        Ok(true)
    }
}

/// Reads the options of an analysis.
pub(crate) fn settings(options: &JsValue, analysis: Analysis) -> Result<Settings, Faults> {
    read(options, analysis, None)
}

/// Reads the options of an analysis and of its drawing.
pub(crate) fn settings_and_looks(options: &JsValue, analysis: Analysis) -> Result<(Settings, Looks), Faults> {
    let mut looks = Looks::default();
    let settings = read(options, analysis, Some(&mut looks))?;
    Ok((settings, looks))
}

/// All faults of the options at once, as the command line gives them.
fn read(options: &JsValue, analysis: Analysis, mut looks: Option<&mut Looks>) -> Result<Settings, Faults> {
    let mut settings = Settings::default();
    if options.is_undefined() || options.is_null() {
        return Ok(settings);
    }
    let mut faults = Vec::new();
    for (name, value) in entries(options, "options")? {
        if value.is_undefined() || value.is_null() {
            continue; // not given
        }
        let text = match text(&name, &value) {
            Ok(text) => text,
            Err(fault) => {
                faults.push(fault);
                continue;
            }
        };
        let drawn = match looks.as_deref_mut().map(|looks| looks.set(&name, &text, analysis)) {
            Some(Ok(known)) => known,
            Some(Err(found)) => {
                faults.extend(found);
                true
            }
            None => false,
        };
        if drawn {
            continue;
        }
        if !analysis.has(&name) {
            let rule = format!("is not an option of {}", analysis.name());
            faults.push(Fault::new(FaultCode::Option, name.as_str(), None, rule.as_str(), rule.as_str()));
        } else if let Err(fault) = settings.set(&name, &text) {
            faults.push(fault);
        }
    }
    Faults::from(faults).none()?;
    if analysis == Analysis::Converge { settings.check_converge() } else { settings.check() }?;
    Ok(settings)
}

/// An option's value as on the command line: numbers in decimals that read back to the same f64,
/// lists with the separator of the option.
fn text(name: &str, value: &JsValue) -> Result<String, Fault> {
    if let Some(text) = scalar(value) {
        return Ok(text);
    }
    let wrong = || {
        let rule = "must be text, a number or a list of these";
        Fault::new(FaultCode::Option, name, None, rule, rule)
    };
    let separator = if matches!(name, "speeds" | "band" | "frequencies") { ":" } else { "," };
    let list = elements(value, name)?.ok_or_else(wrong)?;
    let parts: Option<Vec<String>> = list.iter().map(scalar).collect();
    parts.map(|parts| parts.join(separator)).ok_or_else(wrong)
}

fn scalar(value: &JsValue) -> Option<String> {
    value.as_string().or_else(|| value.as_f64().map(shortest))
}

fn option_fault(name: &str, value: &str, rule: &str) -> Fault {
    Fault::new(FaultCode::Option, name, Some(value.into()), rule, format!("{rule} (is {value})"))
}
