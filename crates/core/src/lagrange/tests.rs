//! Blades that tests share, of which much is known in closed form.

use crate::blade::Blade;
use alloc::format;

/// Tip radius [m].
pub(crate) const RADIUS: f64 = 2.0;
/// Mass per length [kg/m].
pub(crate) const MASS: f64 = 2.0;
/// Flapwise and chordwise stiffness, and the torsional one [N·m²].
pub(crate) const STIFFNESS: [f64; 3] = [50.0, 80.0, 30.0];
/// Polar inertia per length [kg·m].
pub(crate) const INERTIA: f64 = 0.01;
/// Mass centre ahead of the elastic axis [m].
pub(crate) const MASS_OFFSET: f64 = 0.1;
/// Roots of cos z cosh z + 1 = 0 (W. C. Young & R. G. Budynas, Roark's Formulas for Stress and Strain).
pub(crate) const CANTILEVER: [f64; 4] =
    [1.875_104_068_711_961, 4.694_091_132_974_174, 7.854_757_438_237_613, 10.995_540_734_875_466];

fn read(text: &str) -> Blade {
    crate::formats::read(text, crate::formats::Format::Toml).unwrap().blade
}

/// A uniform blade whose roots stand at `offset`; `bending` and `torsion` are those of flap and lag
/// and of torsion, as in a blade file.
pub(crate) fn uniform(offset: f64, bending: &str, torsion: &str) -> Blade {
    let [flap, lag, twist] = STIFFNESS;
    read(&format!(
        r#"
        schema = "bladefan-blade/1"
        name = "uniform"
        rotor = {{ radius = {RADIUS}, nominal_speed = 15 }}
        flap = {{ {bending}, offset = {offset} }}
        lag = {{ {bending}, offset = {offset} }}
        torsion = {{ {torsion}, offset = {offset} }}
        [distribution]
        mass = {MASS}
        flap_stiffness = {flap}
        lag_stiffness = {lag}
        torsion_stiffness = {twist}
        polar_inertia = {INERTIA}
        mass_offset = {MASS_OFFSET}
    "#
    ))
}

/// A uniform blade that is clamped at `offset`.
pub(crate) fn clamped(offset: f64) -> Blade {
    uniform(offset, r#"root = "hingeless""#, r#"root = "rigid""#)
}

/// A uniform blade that turns freely about `offset`.
pub(crate) fn free(offset: f64) -> Blade {
    uniform(offset, r#"root = "hinged""#, r#"root = "spring", spring = 0"#)
}

/// A uniform blade on springs of 40 N·m/rad at `offset`.
pub(crate) fn sprung(offset: f64) -> Blade {
    uniform(offset, r#"root = "spring-hinged", spring = 40"#, r#"root = "spring", spring = 40"#)
}

/// A blade of two linear parts with a step between them at 1 m, of 2 kg and 2 kg·m about the hub.
pub(crate) fn tapered() -> Blade {
    read(
        r#"
        schema = "bladefan-blade/1"
        name = "tapered"
        rotor = { radius = 2, nominal_speed = 15 }
        flap = { root = "hingeless", offset = 0.5 }
        lag = { root = "spring-hinged", offset = 0.5, spring = 40 }
        torsion = { root = "rigid", offset = 0.5 }
        [distribution]
        r = [0.5, 1, 1, 2]
        mass = [3, 2, 1, 0.5]
        flap_stiffness = [100, 50, 40, 10]
        lag_stiffness = [200, 100, 80, 20]
        torsion_stiffness = [60, 30, 20, 5]
        polar_inertia = [0.02, 0.01, 0.01, 0.005]
        mass_offset = [0.1, 0.1, 0.05, 0.05]
    "#,
    )
}

/// ω² of mode `index` of the uniform clamped blade in flap at rest.
pub(crate) fn cantilever(index: usize, length: f64) -> f64 {
    STIFFNESS[0] / MASS * (CANTILEVER[index] / length).powi(4)
}
