//! A blade made of bytes: check, modes and a chart. It is refused or answered, and what is answered makes
//! sense.
#![no_main]

use bladefan_core::{Settings, SpeedRange, fan, modes};
use bladefan_core::formats::{Format, read};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Ok(question) = bladefan_fuzz::question(bytes) else { return };
    if std::env::var_os("BLADEFAN_SHOW").is_some() {
        eprintln!("{}\n{:?}, chart to {} rad/s", question.text, question.options, question.fastest);
    }
    let Ok(file) = read(&question.text, Format::Json) else { return };
    let mut settings = Settings::default();
    for (name, value) in &question.options {
        if settings.set(name, value).is_err() {
            return;
        }
    }
    let seen = &question.text;
    if let Ok(report) = modes(&file.blade, &settings) {
        for mode in &report.modes {
            let f = mode.frequency_rad_s;
            assert!(f.is_finite() && f >= 0.0, "{mode:?} of {seen}");
            if let (Some(lower), Some(upper)) = (mode.lower_rad_s, mode.upper_rad_s) {
                assert!((lower..=upper).contains(&f), "{mode:?} of {seen}");
            }
        }
        for pair in report.modes.windows(2).filter(|pair| pair[0].dof == pair[1].dof) {
            assert!(pair[0].frequency_rad_s <= pair[1].frequency_rad_s, "{pair:?} of {seen}");
        }
    }
    settings.speeds = Some(SpeedRange { from: 0.0, to: question.fastest, count: 21 });
    if let Ok(chart) = fan(&file.blade, &settings) {
        for branch in &chart.branches {
            let sound = branch.frequency_rad_s.iter().all(|f| f.is_finite() && *f >= 0.0);
            assert!(sound, "{branch:?} of {seen}");
        }
        for crossing in &chart.crossings {
            assert!(crossing.speed_rad_s > 0.0 && crossing.frequency_rad_s.is_finite(), "{crossing:?} of {seen}");
        }
    }
});
