//! Blades whose frequencies are known without any approximation.
//!
//! Constants: roots of the characteristic equations named beside them and power-series solutions
//! of the rotating beam, both in 40- to 50-digit arithmetic with mpmath and printed to 16 digits.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use bladefan_core::Dof;
use bladefan_core::report::ShapesReport;
use bladefan_core::{PropellerMoment, Settings, ShapeScale, shapes};
use bladefan_tests::blades::{End, Table, TestBlade};
use bladefan_tests::closed_forms::{CLAMPED, CONTROL_SPRING, HINGED, SPRING_HINGED};
use bladefan_tests::coupled::PointMass;
use bladefan_tests::solve::{converged, converged_settings, frequencies, settings, solve_with};

/// Error allowed where the assumed functions hold the answer and only quadrature and rounding act:
/// measured 1e-15, the goal is 1e-10. The paper reports up to 7.6e-5 (its Fig. 4).
const UNIFORM: f64 = 1e-12;
/// Error allowed where an identity holds function by function: a few roundings of ω².
const IDENTITY: f64 = 1e-12;

fn assert_close(found: &[f64], expected: &[f64], tolerance: f64, what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (i, (&f, &e)) in found.iter().zip(expected).enumerate() {
        let error = (f / e - 1.0).abs();
        assert!(error <= tolerance, "{what}: mode {} is {f}, expected {e}: relative error {error:.1e}", i + 1);
    }
}

/// Asserts that Ritz values are not below the exact ones and above by no more than `tolerance`.
fn assert_above(found: &[f64], exact: &[f64], tolerance: f64, what: &str) {
    assert_close(found, exact, tolerance, what);
    for (&f, &e) in found.iter().zip(exact) {
        assert!(f >= e * (1.0 - 1e-11), "{what}: {f} is below the exact {e}");
    }
}

/// Ten modes with N = 10 … 60 functions.
fn check_uniform(blade: &TestBlade, dof: Dof, expected: &[f64], what: &str) {
    for functions in [10, 20, 30, 40, 50, 60] {
        let found = frequencies(blade, dof, 0.0, functions, 10);
        let (rigid, elastic) = found.split_at(10 - expected.len());
        assert!(rigid.iter().all(|&f| f == 0.0), "{what}: {rigid:?}");
        assert_close(elastic, expected, UNIFORM, &format!("{what}, {dof}, {functions} functions"));
    }
}

#[test]
fn uniform_hingeless_blade_at_rest() {
    for dof in [Dof::Flap, Dof::Lag] {
        check_uniform(&TestBlade::uniform(1.0), dof, &CLAMPED, "hingeless");
        // The same length outboard of a root offset.
        let offset = TestBlade::uniform(1.25).with_root(dof, End::clamped(0.25));
        check_uniform(&offset, dof, &CLAMPED, "hingeless with offset");
    }
}

#[test]
fn uniform_hinged_blade_at_rest() {
    for dof in [Dof::Flap, Dof::Lag] {
        check_uniform(&TestBlade::uniform(1.0).with_root(dof, End::free(0.0)), dof, &HINGED[..9], "hinged");
        let offset = TestBlade::uniform(1.25).with_root(dof, End::free(0.25));
        check_uniform(&offset, dof, &HINGED[..9], "hinged with offset");
    }
}

#[test]
fn uniform_spring_hinged_blade_at_rest() {
    for dof in [Dof::Flap, Dof::Lag] {
        let blade =
            TestBlade::uniform(2.0).with_root(dof, End::spring(0.0, 30.0)).with_stiffness(dof, Table::uniform(50.0));
        check_uniform(&blade, dof, &SPRING_HINGED, "spring-hinged");
    }
}

#[test]
fn uniform_blade_in_torsion_at_rest() {
    let rigid: Vec<f64> =
        (0..10).map(|i| (f64::from(i) + 0.5) * core::f64::consts::PI / 2.0 * 7.0_f64.sqrt()).collect();
    let blade = TestBlade::uniform(2.0).with_stiffness(Dof::Torsion, Table::uniform(7.0));
    check_uniform(&blade, Dof::Torsion, &rigid, "rigid control");
    let sprung = blade.with_root(Dof::Torsion, End::spring(0.0, 3.0));
    check_uniform(&sprung, Dof::Torsion, &CONTROL_SPRING, "control spring");
    // A spring of 0 is a free blade: sin γl = 0.
    let loose: Vec<f64> = (1..10).map(|i| f64::from(i) * core::f64::consts::PI / 2.0 * 7.0_f64.sqrt()).collect();
    check_uniform(&sprung.with_root(Dof::Torsion, End::free(0.0)), Dof::Torsion, &loose, "free in pitch");
}

/// Uniform cantilever EI = m = R = 1: five modes at Ω = 2, 6, 12 (power series, 40 digits; the
/// values of Wright et al., J. Appl. Mech. 49, 1982, agree to their 4–5 digits).
const ROTATING: [(f64, [f64; 5]); 3] = [
    (
        2.0,
        [
            4.137_319_573_025_358,
            22.614_921_956_504_05,
            62.273_184_105_671_66,
            121.496_694_714_221_5,
            200.466_923_205_638_2,
        ],
    ),
    (
        6.0,
        [
            7.360_373_019_310_02,
            26.809_081_678_497_93,
            66.683_914_381_504_89,
            126.140_452_588_969_6,
            205.252_813_586_183,
        ],
    ),
    (
        12.0,
        [
            13.170_150_487_506_18,
            37.603_112_331_191_87,
            79.614_478_489_457_21,
            140.534_354_474_681_3,
            220.536_322_001_501,
        ],
    ),
];

/// The modes of the blade at rest reach those of the turning blade only algebraically, because the
/// tension changes the shapes' higher derivatives at root and tip: the error falls as N⁻⁵. Measured
/// at Ω = 12, first to fifth mode: 3e-6 to 6e-6 with 15 functions, 4e-9 to 9e-9 with 60 (hinged:
/// below 1e-14).
const TURNING: f64 = 1e-8;

#[test]
fn uniform_cantilever_turning() {
    for (speed, exact) in ROTATING {
        let found = frequencies(&TestBlade::uniform(1.0), Dof::Flap, speed, 60, 5);
        assert_above(&found, &exact, TURNING, &format!("cantilever at {speed} rad/s"));
    }
}

#[test]
fn more_functions_close_on_the_turning_cantilever() {
    let exact = ROTATING[2].1[2];
    let error = |functions| frequencies(&TestBlade::uniform(1.0), Dof::Flap, 12.0, functions, 5)[2] / exact - 1.0;
    let (few, many) = (error(15), error(60));
    assert!((4e-6..7e-6).contains(&few), "15 functions: {few:e}");
    assert!((4e-9..2e-8).contains(&many), "60 functions: {many:e}");
}

/// Uniform blade hinged at the centre, EI = m = R = 1, Ω = 12 (power series, 40 digits).
const HINGED_TURNING: [f64; 5] =
    [12.0, 33.760_301_346_797_75, 70.837_323_551_269_83, 126.431_362_318_376_3, 201.122_422_161_873_3];

#[test]
fn hinged_blade_turning() {
    let blade = TestBlade::uniform(1.0).with_root(Dof::Flap, End::free(0.0));
    assert_above(&frequencies(&blade, Dof::Flap, 12.0, 60, 5), &HINGED_TURNING, TURNING, "hinged");
    // A rigid blade on a central hinge keeps the plane of rotation: ω = Ω at every speed.
    for speed in [1e-3, 0.1, 1.0, 30.0, 1e3] {
        for functions in [1, 5, 15, 60] {
            let first = frequencies(&blade, Dof::Flap, speed, functions, 1)[0];
            assert_close(&[first], &[speed], IDENTITY, &format!("1F at {speed} rad/s, {functions} functions"));
        }
    }
}

/// Uniform cantilever EI = m = R = 1 with a mass of 1 at the tip: power series, 40 digits; at rest z² with
/// 1 + cos z cosh z + z (cos z sinh z − sin z cosh z) = 0.
#[test]
fn cantilever_with_a_tip_mass() {
    let tip = PointMass { r: 1.0, mass: 1.0, offset: 0.0, inertia: [0.0; 2] };
    let blade = TestBlade { point_masses: vec![tip], ..TestBlade::uniform(1.0) };
    for (speed, exact) in [
        (0.0, [1.557_297_861_198_921, 16.250_085_158_238_6]),
        (6.0, [6.509_055_923_327_381, 29.291_671_109_351_26]),
        (12.0, [12.481_372_669_375_99, 50.859_386_054_839_54]),
    ] {
        let turning = exact.map(|f: f64| (f * f - speed * speed).sqrt());
        for (dof, exact) in [(Dof::Flap, exact), (Dof::Lag, turning)] {
            let what = format!("tip mass in {dof} at {speed} rad/s");
            assert_close(&converged(&blade, dof, speed, 2), &exact, 1e-10, &what);
            assert_above(&frequencies(&blade, dof, speed, 60, 2), &exact, 1e-4, &what);
        }
    }
}

/// Uniform, clamped, GJ = ρI_p = R = 1 with an inertia of 1 at the tip: γ tan γ = 1. The rotor's turning adds
/// Ω² m Y² to both the tip's and the blade's stiffness where m Y² is as large a part of the inertia of either.
#[test]
fn torsion_with_an_inertia_at_the_tip() {
    let exact = [0.860_333_589_019_379_8, 3.425_618_459_481_728, 6.437_298_179_171_947];
    let tip = PointMass { r: 1.0, mass: 1.0, offset: 0.5, inertia: [0.25, 0.75] };
    let blade = TestBlade { point_masses: vec![tip], mass_offset: Table::uniform(0.5), ..TestBlade::uniform(1.0) };
    for speed in [0.0, 3.0] {
        let turning = exact.map(|f: f64| (f * f + 0.25 * speed * speed).sqrt());
        assert_close(&converged(&blade, Dof::Torsion, speed, 3), &turning, 1e-10, "tip inertia");
    }
}

/// The full propeller moment of a thin section is all of its inertia: ω² = ω₀² + Ω², whatever the blade. Of one
/// that is as thick as it is wide there is none, and one that stands upright has it the other way round.
#[test]
fn the_full_propeller_moment_turns_sections_flat() {
    let tip = PointMass { r: 0.962, mass: 0.1, offset: 0.03, inertia: [0.0, 2e-4] };
    let thin = TestBlade { point_masses: vec![tip], ..TestBlade::stepped() };
    let share = |part: f64| {
        let [flap, lag] = [part, 1.0 - part].map(|part| thin.polar_inertia.times(part));
        let masses = vec![PointMass { inertia: [2e-4 * part, 2e-4 * (1.0 - part)], ..tip }];
        TestBlade { inertias: Some([flap, lag]), point_masses: masses, ..thin.clone() }
    };
    let full = |blade: &TestBlade, speed: f64| -> Vec<f64> {
        let settings = converged_settings(Dof::Torsion, speed, 5);
        let settings = Settings { propeller_moment: Some(PropellerMoment::Full), ..settings };
        solve_with(&blade.blade(), &settings).iter().map(|mode| mode.frequency_rad_s).collect()
    };
    let speed = 105.0;
    for end in [End::clamped(0.09), End::spring(0.09, 40.0)] {
        for (blade, moment) in [(thin.clone(), 1.0), (share(0.0), 1.0), (share(0.5), 0.0), (share(0.75), -0.5)] {
            let blade = blade.with_root(Dof::Torsion, end);
            let still = converged(&blade, Dof::Torsion, 0.0, 5);
            let turning: Vec<f64> = still.iter().map(|f| (f * f + moment * speed * speed).sqrt()).collect();
            assert_close(&full(&blade, speed), &turning, 1e-10, &format!("{end:?}, {moment}"));
        }
    }
    let loose = thin.with_root(Dof::Torsion, End::free(0.09));
    assert_close(&full(&loose, speed)[..1], &[speed], 1e-12, "free in pitch");
}

#[test]
fn lag_lies_below_flap_by_the_square_of_the_speed() {
    for end in [End::clamped(0.0), End::clamped(0.1), End::free(0.07), End::spring(0.05, 2.0)] {
        let blade = TestBlade::uniform(1.0).with_root(Dof::Flap, end).with_root(Dof::Lag, end);
        for speed in [0.5, 6.0, 40.0] {
            let flap = frequencies(&blade, Dof::Flap, speed, 20, 5);
            let lag = frequencies(&blade, Dof::Lag, speed, 20, 5);
            for (f, l) in flap.iter().zip(lag) {
                let error = (l * l - (f * f - speed * speed)).abs() / (f * f);
                assert!(error < IDENTITY, "{end:?} at {speed}: flap {f}, lag {l}: {error:e}");
            }
        }
    }
}

#[test]
fn free_hinge_at_rest_has_frequency_zero_exactly() {
    let blade = TestBlade::stepped()
        .with_root(Dof::Flap, End::free(0.09))
        .with_root(Dof::Lag, End::spring(0.09, 0.0))
        .with_root(Dof::Torsion, End::free(0.09));
    for dof in Dof::ALL {
        for functions in [1, 2, 15, 60] {
            let first = frequencies(&blade, dof, 0.0, functions, 1)[0];
            assert!(first == 0.0, "{dof} with {functions} functions: {first:e}");
        }
    }
    // A lag hinge on the rotor axis has no centrifugal spring at any speed.
    let central = TestBlade::uniform(1.0).with_root(Dof::Lag, End::free(0.0));
    for speed in [0.0, 1.0, 100.0] {
        let first = frequencies(&central, Dof::Lag, speed, 15, 1)[0];
        assert!(first == 0.0, "1L at {speed} rad/s: {first:e}");
    }
}

/// EI → 0, pinned at the centre: ω = Ω √(k (2k − 1)), the Legendre polynomials of odd order. The
/// stiffness adds to ω² in proportion at first, so two small ones extrapolate to none. What is
/// left is the boundary layer at the tip, of a higher order in EI: measured 9e-8, 3e-6 and 2e-5 for
/// the second to fourth mode at EI = 1e-7, where 200 functions hold the layer to 1e-9. The first
/// mode is straight, so exact at any stiffness.
#[test]
fn spinning_string() {
    let stiff = |stiffness: f64| {
        let blade = TestBlade::uniform(1.0)
            .with_root(Dof::Flap, End::free(0.0))
            .with_stiffness(Dof::Flap, Table::uniform(stiffness));
        frequencies(&blade, Dof::Flap, 1.0, 200, 4)
    };
    let (once, twice) = (stiff(1e-7), stiff(2e-7));
    for (i, (one, two)) in once.iter().zip(twice).enumerate() {
        let k = (i + 1) as f64;
        let (expected, found) = (k * (2.0 * k - 1.0), 2.0 * one * one - two * two);
        let error = (found / expected - 1.0).abs();
        assert!(error < [1e-13, 2e-7, 5e-6, 4e-5][i], "mode {}: ω² {found} against {expected}", i + 1);
    }
}

/// EI → ∞ on a hinge at e: flap Ω √(1 + 1.5 e/(1 − e)), lag Ω √(1.5 e/(1 − e)). The flexibility
/// lowers ω² in proportion at first, so two large stiffnesses extrapolate to a rigid blade. The
/// rest, of the order (Ω² m l⁴/EI)², is lost in rounding.
#[test]
fn rigid_blade_on_an_offset_hinge() {
    for e in [0.02, 0.05, 0.1] {
        let squares = |stiffness: f64, dof: Dof| {
            let blade =
                TestBlade::uniform(1.0).with_root(dof, End::free(e)).with_stiffness(dof, Table::uniform(stiffness));
            frequencies(&blade, dof, 1.0, 20, 1)[0].powi(2)
        };
        let restoring = 1.5 * e / (1.0 - e);
        for (dof, expected) in [(Dof::Flap, 1.0 + restoring), (Dof::Lag, restoring)] {
            let found = 2.0 * squares(2e4, dof) - squares(1e4, dof);
            assert!((found / expected - 1.0).abs() < 1e-13, "{dof}, e = {e}: ω² {found} against {expected}");
        }
    }
}

/// m = 1 − x/2, EI = (1 − x/2)³, clamped (Hodges & Rutkowski, AIAA J. 19, 1981, to 4–5 digits;
/// here by power series in 40 digits).
const TAPERED: [(f64, [f64; 3]); 3] = [
    (0.0, [3.823_784_847_290_28, 18.317_260_904_174_72, 47.264_827_010_480_63]),
    (5.0, [6.743_398_555_674_412, 21.905_325_192_205_6, 50.933_807_299_684_22]),
    (12.0, [13.471_129_933_316_34, 34.087_674_923_672_47, 65.523_654_261_292_31]),
];

/// Between stations EI is linear, above the convex cubic by h² EI″/12 on average (h = 1/300):
/// measured 1e-7 to 1.4e-6 of ω, the same for 40 and 80 functions.
#[test]
fn tapered_blade() {
    let mut blade = TestBlade::uniform(1.0)
        .with_stiffness(Dof::Flap, Table::sampled(1.0, 300, |x| (1.0 - 0.5 * x) * (1.0 - 0.5 * x) * (1.0 - 0.5 * x)));
    blade.mass = Table { r: vec![0.0, 1.0], y: vec![1.0, 0.5] };
    for (speed, exact) in TAPERED {
        let found = frequencies(&blade, Dof::Flap, speed, 40, 3);
        assert_above(&found, &exact, 2e-6, &format!("tapered at {speed} rad/s"));
    }
}

/// Error allowed to the piecewise functions: they are refined until an eigenvalue is good to 1e-10,
/// and the reference values have more digits.
const CONVERGED: f64 = 1e-9;

#[test]
fn piecewise_uniform_cantilever() {
    let blade = TestBlade::uniform(1.0);
    assert_above(&converged(&blade, Dof::Flap, 0.0, 10), &CLAMPED, CONVERGED, "cantilever at rest");
    for (speed, exact) in ROTATING {
        let what = format!("cantilever at {speed} rad/s");
        assert_above(&converged(&blade, Dof::Flap, speed, 5), &exact, CONVERGED, &what);
        let lag = exact.map(|f| (f * f - speed * speed).sqrt());
        assert_above(&converged(&blade, Dof::Lag, speed, 5), &lag, CONVERGED, &format!("{what}, lag"));
    }
}

#[test]
fn piecewise_hinged_blade() {
    let blade = TestBlade::uniform(1.0).with_root(Dof::Flap, End::free(0.0)).with_root(Dof::Lag, End::free(0.0));
    assert_above(&converged(&blade, Dof::Flap, 0.0, 10)[1..], &HINGED[..9], CONVERGED, "hinged at rest");
    assert_above(&converged(&blade, Dof::Flap, 12.0, 5), &HINGED_TURNING, CONVERGED, "hinged at 12 rad/s");
    let lag = [1, 2, 3, 4].map(|i: usize| (HINGED_TURNING[i] * HINGED_TURNING[i] - 144.0).sqrt());
    assert_above(&converged(&blade, Dof::Lag, 12.0, 5)[1..], &lag, CONVERGED, "lag at 12 rad/s");
}

#[test]
fn piecewise_springs() {
    let mut blade = TestBlade::uniform(2.0).with_root(Dof::Torsion, End::spring(0.0, 3.0));
    blade.stiffness = [Table::uniform(50.0), Table::uniform(50.0), Table::uniform(7.0)];
    for dof in [Dof::Flap, Dof::Lag] {
        let blade = blade.clone().with_root(dof, End::spring(0.0, 30.0));
        assert_above(&converged(&blade, dof, 0.0, 10), &SPRING_HINGED, CONVERGED, "spring-hinged");
    }
    assert_above(&converged(&blade, Dof::Torsion, 0.0, 10), &CONTROL_SPRING, CONVERGED, "control spring");
}

/// The string again. Three stiffnesses extrapolate over the terms in EI and EI^(3/2); what is left
/// falls faster than EI: measured 1.4e-9 to 2.6e-6 at EI = 1e-8, 7e-11 to 1.1e-7 at 1e-9.
#[test]
fn piecewise_spinning_string() {
    let squares = |stiffness: f64| {
        let blade = TestBlade::uniform(1.0)
            .with_root(Dof::Flap, End::free(0.0))
            .with_stiffness(Dof::Flap, Table::uniform(stiffness));
        converged(&blade, Dof::Flap, 1.0, 5).into_iter().map(|f| f * f).collect::<Vec<f64>>()
    };
    let values = [1e-8, 4e-8, 16e-8].map(squares);
    for (i, tolerance) in [1e-13, 2e-9, 6e-8, 6e-7, 4e-6].into_iter().enumerate() {
        // First the term in EI, by steps of 4, then that in EI^(3/2), by steps of 8.
        let linear = |k: usize| (4.0 * values[k][i] - values[k + 1][i]) / 3.0;
        let found = (8.0 * linear(0) - linear(1)) / 7.0;
        let k = (i + 1) as f64;
        let expected = k * (2.0 * k - 1.0);
        assert!((found / expected - 1.0).abs() < tolerance, "mode {}: ω² {found} against {expected}", i + 1);
    }
}

/// The rigid blade again.
#[test]
fn piecewise_rigid_blade_on_an_offset_hinge() {
    for e in [0.02, 0.05, 0.1] {
        let squares = |stiffness: f64, dof: Dof| {
            let blade =
                TestBlade::uniform(1.0).with_root(dof, End::free(e)).with_stiffness(dof, Table::uniform(stiffness));
            converged(&blade, dof, 1.0, 3)[0].powi(2)
        };
        let restoring = 1.5 * e / (1.0 - e);
        for (dof, expected) in [(Dof::Flap, 1.0 + restoring), (Dof::Lag, restoring)] {
            let found = 2.0 * squares(2e4, dof) - squares(1e4, dof);
            assert!((found / expected - 1.0).abs() < CONVERGED, "{dof}, e = {e}: ω² {found} against {expected}");
        }
    }
}

/// The taper again, with fewer stations: measured below 5e-6, of which the interpolation is all.
#[test]
fn piecewise_tapered_blade() {
    let mut blade = TestBlade::uniform(1.0)
        .with_stiffness(Dof::Flap, Table::sampled(1.0, 160, |x| (1.0 - 0.5 * x) * (1.0 - 0.5 * x) * (1.0 - 0.5 * x)));
    blade.mass = Table { r: vec![0.0, 1.0], y: vec![1.0, 0.5] };
    for (speed, exact) in TAPERED {
        let found = converged(&blade, Dof::Flap, speed, 3);
        assert_above(&found, &exact, 1e-5, &format!("tapered at {speed} rad/s"));
    }
}

/// Composite Simpson sum of `f` over evenly spaced samples; their number must be odd.
fn simpson(f: &[f64], step: f64) -> f64 {
    let last = f.len() - 1;
    let weight = |i: usize| {
        if i == 0 || i == last {
            1.0
        } else if i % 2 == 1 {
            4.0
        } else {
            2.0
        }
    };
    f.iter().enumerate().map(|(i, v)| weight(i) * v).sum::<f64>() * step / 3.0
}

/// ∫ c X_i X_j dr of all pairs of shapes, where c is constant on [r_k, r_k+1] given as indices.
fn gram(report: &ShapesReport, pieces: &[(usize, usize, f64)]) -> Vec<Vec<f64>> {
    let step = (report.r_m[report.r_m.len() - 1] - report.r_m[0]) / (report.r_m.len() - 1) as f64;
    let shapes = &report.shapes;
    let pair = |i: usize, j: usize| {
        let integral = |&(from, to, c): &(usize, usize, f64)| {
            let samples = from..=to;
            let values: Vec<f64> = samples.map(|k| shapes[i].displacement[k] * shapes[j].displacement[k]).collect();
            c * simpson(&values, step)
        };
        pieces.iter().map(integral).sum::<f64>()
    };
    (0..shapes.len()).map(|i| (0..shapes.len()).map(|j| pair(i, j)).collect()).collect()
}

/// A blade with steps at a fifth and three tenths of the span, on the grid of the samples.
fn stepped_on_grid() -> TestBlade {
    let radii = [0.0, 0.2, 0.3, 1.0];
    let stiffness = Table::steps(&radii, &[90.0, 4.0, 1.0]);
    TestBlade {
        mass: Table::steps(&radii, &[4.0, 2.0, 1.0]),
        stiffness: [stiffness.clone(), stiffness.clone(), stiffness],
        polar_inertia: Table::steps(&radii, &[0.5, 0.0, 0.1]),
        ..TestBlade::uniform(1.0)
    }
}

/// Functions, speed, samples of a shape, and how good Simpson's sum over them is for the product of
/// two tenth modes: (10π h)⁴/180 with a step h of twice the sampling. Samples less one are a
/// multiple of 20, so that the steps of the blade fall on every other of them.
const SHAPES: [(usize, f64, usize, f64); 4] =
    [(15, 0.0, 2001, 1e-8), (15, 9.0, 2001, 1e-8), (60, 9.0, 2001, 1e-8), (200, 9.0, 401, 5e-6)];

#[test]
fn mode_shapes_are_orthogonal_and_normalised() {
    let blade = stepped_on_grid();
    for (functions, speed, samples, tolerance) in SHAPES {
        for dof in Dof::ALL {
            let settings =
                Settings { points: samples, normalise: ShapeScale::Mass, ..settings(dof, speed, functions, 10) };
            let report = shapes(&blade.blade(), &settings).unwrap();
            let last = samples - 1;
            let inertia = if dof == Dof::Torsion { [0.5, 0.0, 0.1] } else { [4.0, 2.0, 1.0] };
            let pieces =
                [(0, last / 5, inertia[0]), (last / 5, last * 3 / 10, inertia[1]), (last * 3 / 10, last, inertia[2])];
            let weighted = gram(&report, &pieces);
            for (i, row) in weighted.iter().enumerate() {
                for (j, entry) in row.iter().enumerate().filter(|(j, _)| *j != i) {
                    let cosine = entry / (row[i] * weighted[j][j]).sqrt();
                    assert!(cosine.abs() < tolerance, "{dof} {i} {j}, {functions} functions: {cosine:e}");
                }
                // Eq. 86 and 87.
                let (found, expected) =
                    if dof == Dof::Torsion { (gram(&report, &[(0, last, 1.0)])[i][i], 0.5) } else { (row[i], 1.0) };
                assert!((found / expected - 1.0).abs() < tolerance, "{dof} {i}: {found} against {expected}");
                assert!(*report.shapes[i].displacement.last().unwrap() > 0.0, "tip positive");
            }
        }
    }
}

#[test]
fn two_hundred_functions() {
    let roots = [
        [End::clamped(0.0), End::clamped(0.0), End::clamped(0.0)],
        [End::free(0.05), End::free(0.05), End::free(0.05)],
        [End::spring(0.05, 3.0), End::spring(0.05, 3.0), End::spring(0.05, 3.0)],
    ];
    for roots in roots {
        let blade = TestBlade { roots, ..stepped_on_grid() };
        for dof in Dof::ALL {
            for speed in [0.0, 9.0, 200.0] {
                let found = frequencies(&blade, dof, speed, 200, 50);
                assert!(found.iter().all(|f| f.is_finite() && *f >= 0.0), "{dof}: {found:?}");
                assert!(found.windows(2).all(|pair| pair[0] < pair[1]), "{dof}: {found:?}");
            }
        }
    }
}

#[test]
fn fifty_modes_of_two_hundred_functions() {
    // cos z cosh z + 1 = 0: z_i = (i − ½) π to the last digit from i = 13 on (1/cosh z < 1e-17).
    let found = frequencies(&TestBlade::uniform(1.0), Dof::Flap, 0.0, 200, 50);
    let expected: Vec<f64> = (13..=50).map(|i| ((f64::from(i) - 0.5) * core::f64::consts::PI).powi(2)).collect();
    assert_close(&found[..10], &CLAMPED, UNIFORM, "first ten");
    assert_close(&found[12..], &expected, UNIFORM, "13 to 50");
}
