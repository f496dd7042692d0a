//! Memory of a fan chart: what it is made of stays within a bound, however many speeds are asked for.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests fail by panicking and print what they measured")]

use allocation_counter::measure;
use bladefan_core::Blade;
use bladefan_core::formats::{Format, read};
use bladefan_core::library;
use bladefan_core::{ModelKind, Settings, SpeedRange, fan};
use core::hint::black_box;

fn built_in(name: &str) -> Blade {
    read(library::find(name).unwrap().toml, Format::Toml).unwrap().blade
}

/// Most memory in use at one time [bytes].
fn memory(blade: &Blade, count: usize) -> u64 {
    let settings = Settings {
        speeds: Some(SpeedRange { from: 0.0, to: 1.2 * blade.nominal_speed(), count }),
        ..Settings::of(ModelKind::Uncoupled)
    };
    measure(|| drop(black_box(fan(blade, &settings).unwrap()))).bytes_max
}

#[test]
fn more_speeds_take_no_more_than_their_results() {
    for name in ["tm4760", "hingeless-1000"] {
        let blade = built_in(name);
        let (few, many) = (memory(&blade, 101), memory(&blade, 10_001));
        println!("{name}: {} kB at most for 101 speeds, {} kB for 10001", few / 1000, many / 1000);
        // Half of a small core's second-level cache.
        assert!(few <= 1 << 19, "{name}: {few:?}");
        // A speed and fifteen frequencies, eight bytes each.
        let results = 9900 * 16 * 8;
        assert!(many <= few + results, "{name}: {many} against {few}");
    }
}
