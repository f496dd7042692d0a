//! The oracle against reference values, closed forms and itself.
#![allow(clippy::unreadable_literal, reason = "reference values stand as they were given")]

use super::*;
use crate::blades::{End, Hold, Table, TestBlade};
use crate::exact::Exact as Uncoupled;
use bladefan_core::Dof;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, FRAC_PI_6, PI};

/// Reference values of the tapered blade are given to ten decimals.
const DECIMALS: f64 = 0.6e-10;
/// Agreement asked of closed forms, relative, in ω: a few hundred roundings.
const CLOSE: f64 = 2e-12;

fn frequencies(blade: &CoupledBlade, speed: f64, count: usize) -> Vec<f64> {
    Exact::new(blade, speed).eigenvalues(count).into_iter().map(f64::sqrt).collect()
}

/// Frequencies within half a unit of the last digit given, or `relative` where none are cut off.
fn assert_near(name: &str, found: &[f64], expected: &[f64], absolute: f64, relative: f64) {
    for (f, e) in found.iter().zip(expected) {
        let ratio = (f - e).abs() / (absolute + relative * e.abs());
        assert!(ratio < 1.0, "{name}: {f} against {e}");
    }
}

fn bent(bending: [f64; 2], pitch: f64) -> CoupledBlade {
    CoupledBlade { pitch, ..CoupledBlade::uniform(1.0, bending) }
}

fn hinged(mut blade: CoupledBlade, holds: [Hold; 3]) -> CoupledBlade {
    for (root, hold) in blade.roots.iter_mut().zip(holds) {
        root.hold = hold;
    }
    blade
}

fn with_tip(mut blade: CoupledBlade) -> CoupledBlade {
    blade.point_masses.push(PointMass { r: 2.0, mass: 0.5, offset: 0.03, inertia: [1e-3, 5e-3] });
    blade
}

// Two meshes of a Ritz program with piecewise polynomials agree on these to 1e-13, and shooting to 1e-7.
#[test]
#[rustfmt::skip]
fn tapered_blade_with_every_option() {
    let tapered = CoupledBlade::tapered;
    let plain = CoupledBlade { trapeze: Trapeze::Off, tension_offset: Table::uniform(0.0), ..tapered() };
    let sprung = hinged(tapered(), [Hold::Free, Hold::Spring(30.0), Hold::Spring(40.0)]);
    let cases = [
        ("at rest", tapered(), 0.0, [3.2381034548, 9.9338261741, 18.0547383839, 23.4698057116, 43.5855198374, 57.1225657559]),
        ("slow", tapered(), 5.0, [6.1885108104, 10.989808775, 21.0729893989, 25.6431943687, 47.3596859955, 58.6984608648]),
        ("clamped", tapered(), 12.0, [10.8557528665, 15.9043031526, 25.9673493366, 38.2857025683, 60.0176798196, 65.5298161356]),
        ("no tension axis", plain, 12.0, [10.8406549455, 15.9029307608, 17.5333995002, 38.8569097869, 53.2557868495, 62.9456396879]),
        ("collective", CoupledBlade { pitch: 0.2, ..tapered() }, 12.0, [9.9381960842, 16.4919659105, 25.2789803346, 37.9439802852, 59.9736953047, 65.4306143687]),
        ("precone", CoupledBlade { precone: 0.05, ..tapered() }, 12.0, [10.8450307471, 15.8596762541, 25.6987071952, 38.2072134273, 59.9800471041, 65.4507852224]),
        ("rotary", CoupledBlade { rotary: true, ..tapered() }, 12.0, [10.7986604005, 15.8290917602, 25.9057713952, 38.0688678965, 58.3875337982, 63.8328263733]),
        ("torque offset", CoupledBlade { torque_offset: 0.1, ..tapered() }, 12.0, [10.8560238759, 15.9053912604, 27.4753689563, 38.5960673643, 60.0876748685, 65.8344293366]),
        ("hinges", sprung, 12.0, [6.1900902719, 13.2576945373, 20.7545982079, 34.6494678069, 49.6111804825, 52.4893058919]),
        ("tip mass", with_tip(tapered()), 12.0, [9.7718684037, 14.9996178903, 23.7306415518, 37.8121340374, 56.1207613238, 58.7226630639]),
    ];
    for (name, blade, speed, expected) in cases {
        assert_near(name, &frequencies(&blade, speed, 6), &expected, DECIMALS, 0.0);
    }
}

#[test]
fn everything_at_once_with_roots_apart() {
    let mut blade = with_tip(hinged(CoupledBlade::tapered(), [Hold::Free, Hold::Spring(30.0), Hold::Spring(40.0)]));
    blade = CoupledBlade { precone: 0.05, rotary: true, torque_offset: 0.1, ..blade };
    blade.roots[1].offset = 0.35;
    blade.roots[2].offset = 0.5;
    let expected = [
        6.848_343_012_4,
        13.079_217_319_9,
        22.760_869_355_4,
        35.098_917_018_9,
        46.969_781_639_7,
        53.565_028_970_0,
        64.877_428_329_8,
    ];
    assert_near("everything", &frequencies(&blade, 12.0, 7), &expected, DECIMALS, 0.0);
}

#[test]
fn pitch_shares_the_softening_of_lag() {
    let at = |degrees: f64| frequencies(&bent([1.0, 4.0], degrees.to_radians()), 6.0, 4);
    assert_near("flat", &at(0.0), &[7.36037, 7.48702], 0.6e-5, 0.0);
    assert_near("at 30", &at(30.0), &[6.0524, 8.57897, 26.63754, 46.352], 0.6e-3, 0.0);
    assert_near("at 30", &at(30.0)[1..3], &[8.57897, 26.63754], 0.6e-5, 0.0);
    assert_near("on edge", &at(90.0), &[4.26323, 9.59456], 0.6e-5, 0.0);
}

/// The uniform part of the HART II blade, with trapeze term and rotary inertia: Ritz values to 1e-5.
#[test]
fn model_rotor_blade() {
    let line = |r: f64| (1.5 - r) * 0.0698131701;
    let blade = CoupledBlade {
        mass: Table::uniform(0.95),
        torsion: Table::uniform(160.0),
        inertia: [1.7e-5, 7.0128e-4].map(Table::uniform),
        trapeze: Trapeze::AxialStiffness(Table::uniform(1.17e7)),
        twist: Table { r: vec![0.12, 2.0], y: vec![line(0.12), line(2.0)] },
        rotary: true,
        roots: [End::clamped(0.12); 3],
        ..CoupledBlade::uniform(2.0, [250.0, 5200.0])
    };
    let expected = [92.02367, 119.49883, 303.45086, 418.92078, 523.85351, 556.16166, 868.70032, 1213.30096];
    assert_near("HART II", &frequencies(&blade, 109.12, 8), &expected, 0.6e-5, 0.0);
}

/// Carnegie's twisted strip of steel, as an Euler beam and with rotary inertia [Hz]: Ritz values.
#[test]
fn twisted_strip_at_rest() {
    let (length, width, thick, density) = (0.1524, 0.0254, 0.0017272, 7857.6);
    let [first, second] = [width * thick * thick * thick / 12.0, thick * width * width * width / 12.0];
    let mut blade = CoupledBlade {
        mass: Table::uniform(density * width * thick),
        // Stiff in torsion, which without offsets takes no part.
        torsion: Table::uniform(1e6),
        inertia: [density * first, density * second].map(Table::uniform),
        twist: Table { r: vec![0.0, length], y: vec![0.0, FRAC_PI_4] },
        ..CoupledBlade::uniform(length, [206.85e9 * first, 206.85e9 * second])
    };
    let hertz =
        |blade: &CoupledBlade| frequencies(blade, 0.0, 4).into_iter().map(|f| f / (2.0 * PI)).collect::<Vec<_>>();
    let euler = hertz(&blade);
    assert_near("strip", &euler, &[62.08, 305.48, 949.94], 0.6e-2, 0.0);
    assert_near("strip", &euler[3..], &[1221.9], 0.06, 0.0);
    blade.rotary = true;
    let turning = hertz(&blade);
    assert_near("strip, rotary", &turning, &[62.03, 305.29], 0.6e-2, 0.0);
    assert_near("strip, rotary", &turning[2..], &[948.2, 1214.7], 0.06, 0.0);
}

/// At rest the closed form, 1 + cos b cosh b + b (cos b sinh b − sin b cosh b) = 0 with ω = b²; at speed
/// reference values, to five digits, of a mass with some length.
#[test]
fn tip_mass_as_heavy_as_the_blade() {
    let mut blade = bent([1.0, 1e4], 0.0);
    blade.point_masses.push(PointMass { r: 1.0, mass: 1.0, offset: 0.0, inertia: [0.0; 2] });
    let exact = [1.557_297_861_198_919_6, 16.250_085_158_238_6];
    assert_near("at rest", &frequencies(&blade, 0.0, 2), &exact, 0.0, CLOSE);
    for (speed, expected) in [(6.0, [6.50905, 29.2915]), (12.0, [12.4814, 50.859])] {
        assert_near("at speed", &frequencies(&blade, speed, 2), &expected, 0.0, 1e-5);
    }
}

/// At rest, without offsets: the closed forms of a uniform beam and a uniform shaft.
#[test]
fn uniform_blade_at_rest() {
    let mut blade = bent([1.0, 9.0], 0.0);
    blade.torsion = Table::uniform(2.0);
    blade.inertia = [1e-3, 4e-3].map(Table::uniform);
    let beam = [1.875_104_068_711_961_2_f64, 4.694_091_132_974_175, 7.854_757_438_237_613].map(|x| x * x);
    let shaft = [0.5, 1.5].map(|x| x * PI * 20.0);
    let mut expected: Vec<f64> = beam.iter().flat_map(|x| [*x, 3.0 * x]).chain(shaft).collect();
    expected.sort_by(f64::total_cmp);
    for angle in [0.0, 0.4, FRAC_PI_2] {
        blade.pitch = angle;
        assert_near("uniform", &frequencies(&blade, 0.0, 6), &expected, 0.0, CLOSE);
    }
    // The spring-held root: k = −θ cot θ with θ = 1.
    let sprung = hinged(blade, [Hold::Clamped, Hold::Clamped, Hold::Spring(2.0 * 1.0_f64.tan())]);
    let near = frequencies(&sprung, 0.0, 6).iter().any(|f| (f / 20.0 - 1.0).abs() < CLOSE);
    assert!(near, "a shaft on a spring");
}

/// Power series in 40 digits, as for the uncoupled solution.
#[test]
fn uniform_blade_at_speed() {
    let expected = [13.170_150_487_506_18, 37.603_112_331_191_87, 79.614_478_489_457_21];
    assert_near("flap", &frequencies(&bent([1.0, 1e5], 0.0), 12.0, 3), &expected, 0.0, CLOSE);
    let expected = [12.0, 33.760_301_346_797_75];
    let free = hinged(bent([1.0, 1e5], 0.0), [Hold::Free, Hold::Clamped, Hold::Clamped]);
    assert_near("hinged", &frequencies(&free, 12.0, 2), &expected, 0.0, CLOSE);
}

#[test]
fn free_roots_at_rest_and_a_central_lag_hinge() {
    let mut blade = CoupledBlade { pitch: FRAC_PI_6, ..CoupledBlade::tapered() };
    blade = hinged(blade, [Hold::Free; 3]);
    let mut exact = Exact::new(&blade, 0.0);
    let near = exact.rounding(0.0);
    assert_eq!([-near, near].map(|square| exact.count_below(square)), [0, 3]);
    for root in &mut blade.roots[..2] {
        root.offset = 0.0;
    }
    let mut exact = Exact::new(&blade, 6.0);
    // Rigid flap turns with the rotor, rigid lag does not move, whatever the offsets.
    for square in [0.0, 36.0] {
        let near = exact.rounding(square);
        let counts = [square - near, square + near].map(|square| exact.count_below(square));
        assert_eq!(counts[1], counts[0] + 1, "around {square}");
    }
}

#[test]
fn a_flat_section_on_edge_turns_over() {
    let mut blade = hinged(bent([1.0, 4.0], FRAC_PI_2), [Hold::Clamped, Hold::Clamped, Hold::Free]);
    blade.torsion = Table::uniform(2.0);
    blade.inertia = [1e-3, 1e-2].map(Table::uniform);
    let first = Exact::new(&blade, 6.0).eigenvalue(1);
    assert!((first / (-36.0 * 9.0 / 11.0) - 1.0).abs() < CLOSE, "{first}");
}

/// Double and triple eigenvalues: each is counted as often as it is one.
#[test]
fn coincident_eigenvalues() {
    let mut blade = bent([1.0, 1.0], 0.3);
    blade.torsion = Table::uniform(2.0);
    blade.inertia = [1e-3; 2].map(Table::uniform);
    let squares = Exact::new(&blade, 0.0).eigenvalues(4);
    assert_near("round rod", &[squares[0], squares[2]], &[squares[1], squares[3]], 0.0, 2.0 * CLOSE);
    blade = hinged(blade, [Hold::Free; 3]);
    let mut exact = Exact::new(&blade, 0.0);
    let near = exact.rounding(0.0);
    assert_eq!([-near, near].map(|square| exact.count_below(square)), [0, 3]);
}

/// Springs that are turned with the section are springs of the section.
#[test]
fn turned_springs() {
    let mut blade = hinged(bent([1.0, 4.0], 0.5), [Hold::Spring(3.0), Hold::Spring(7.0), Hold::Clamped]);
    blade.spring_angle = 0.5;
    let turned = frequencies(&blade, 0.0, 4);
    blade = CoupledBlade { pitch: 0.0, spring_angle: 0.0, ..blade };
    assert_near("turned", &turned, &frequencies(&blade, 0.0, 4), 0.0, CLOSE);
}

#[test]
fn axial_stiffness_gives_the_radius_of_gyration() {
    let mut blade = CoupledBlade::tapered();
    blade.bending = [Table::uniform(20.0), Table::uniform(100.0)];
    blade.tension_offset = Table::uniform(0.02);
    blade.trapeze = Trapeze::AxialStiffness(Table::uniform(1e4));
    let found = frequencies(&blade, 12.0, 5);
    blade.trapeze = Trapeze::Square(Table::uniform(120.0 / 1e4 + 4e-4));
    assert_near("gyration", &found, &frequencies(&blade, 12.0, 5), 0.0, CLOSE);
}

#[test]
fn intervals_are_judged() {
    let mut exact = Exact::new(&CoupledBlade::tapered(), 12.0);
    let second = exact.eigenvalue(2);
    let wide = 1e-6 * second;
    assert_eq!(exact.contradiction(2, second - wide, second + wide), None);
    assert_eq!(exact.contradiction(2, second, second), None);
    for (number, low, up) in [
        (1, second - wide, second + wide),
        (3, second - wide, second + wide),
        (2, second + wide, second + 2.0 * wide),
        (2, second - 2.0 * wide, second - wide),
        (2, second + wide, second - wide),
        (2, f64::NAN, second),
    ] {
        assert!(exact.contradiction(number, low, up).is_some(), "{number} in [{low}, {up}]");
    }
}

/// Other panels are another computation of the same numbers.
#[test]
fn shorter_panels_change_nothing() {
    let mut blade = with_tip(CoupledBlade { precone: 0.05, rotary: true, pitch: 0.7, ..CoupledBlade::tapered() });
    blade.roots = [End::free(0.3), End::spring(0.25, 12.0), End::spring(0.4, 20.0)];
    let all = |share: f64| Exact::with_shorter_panels(&blade, 12.0, share).eigenvalues(8);
    let usual = all(1.0);
    for share in [0.7, 0.3, 0.1] {
        assert_near("panels", &all(share), &usual, 0.0, 2.0 * CLOSE);
    }
}

/// Where nothing couples, as many eigenvalues lie below any number as the uncoupled solutions count.
#[test]
fn uncoupled_motions_are_counted_together() {
    let parts = TestBlade::stepped();
    let blade = CoupledBlade {
        radius: parts.radius,
        mass: parts.mass.clone(),
        bending: [parts.stiffness[0].clone(), parts.stiffness[1].clone()],
        torsion: parts.stiffness[2].clone(),
        inertia: [parts.polar_inertia.times(0.5), parts.polar_inertia.times(0.5)],
        roots: parts.roots,
        ..CoupledBlade::uniform(1.0, [1.0; 2])
    };
    assert!(parts.mass_offset.y.iter().all(|y| *y == 0.0), "no racket moment");
    let (speed, highest) = (parts.nominal_speed, 2000.0);
    let alone = [Dof::Flap, Dof::Lag, Dof::Torsion].map(|dof| Uncoupled::<f64>::new(&parts, dof, speed, highest));
    let mut exact = Exact::new(&blade, speed);
    for i in 1..=40 {
        let square = (highest * f64::from(i) / 40.0).powi(2);
        let sum: usize = alone.iter().map(|one| one.count_below(speed, square)).sum();
        assert_eq!(exact.count_below(square), sum, "below {square}");
    }
}
