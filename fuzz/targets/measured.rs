//! Any text as a file of measured points.
#![no_main]

use bladefan_core::formats::measured;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| match measured::read(text) {
    Ok(points) => {
        for point in points {
            assert!(point.speed_rad_s.is_finite() && point.frequency_rad_s.is_finite(), "{point:?}");
        }
    }
    Err(faults) => assert!(!faults.is_empty(), "refused without a reason"),
});
