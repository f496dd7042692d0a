//! Blades of other people's reports and programs. Values, tolerances and their reasons stand in
//! `tests/cases`; `cargo test -p bladefan-tests --test literature -- --nocapture` prints them
//! beside ours.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]
#![allow(clippy::print_stdout, reason = "the comparison is worth reading when it holds, too")]

use bladefan_core::dof::Dof;
use bladefan_tests::blades::{Hold, TestBlade};
use bladefan_tests::cases::{Case, Compared};
use bladefan_tests::solve::frequencies;

fn assert_holds(case: &Case, compared: &[Compared]) {
    let table = case.table(compared);
    println!("{table}\n");
    assert!(compared.iter().all(|value| value.holds), "{table}");
}

#[test]
fn tm_4760_against_finite_elements() {
    let case = Case::read(include_str!("../cases/tm4760-finite-elements.toml"));
    assert_eq!(case.rows.len(), 7);
    assert_holds(&case, &case.compare());
}

/// Young's modulus of the MBDyn example is multiplied by this, its lag spring is not.
const GRAVITY_IN_S2: f64 = 386.09;

#[test]
fn tm_4760_against_mbdyn() {
    let case = Case::read(include_str!("../cases/tm4760-mbdyn.toml"));
    let mut blade = TestBlade::built_in(&case.blade);
    let Hold::Spring(spring) = &mut blade.roots[Dof::Lag.index()].hold else { panic!("no lag spring") };
    // 464 in-lbf/rad.
    assert!((*spring / 52.425 - 1.0).abs() < 1e-4, "{spring}");
    *spring /= GRAVITY_IN_S2;
    assert_holds(&case, &case.compare_with(&blade.blade()));
}

#[test]
fn sa_330_against_finite_elements() {
    let case = Case::read(include_str!("../cases/sa330-finite-elements.toml"));
    assert_holds(&case, &case.compare());
}

/// Uniform cantilever, EI = m = R = 1, as widely quoted from Wright, Smith, Thresher & Wang,
/// J. Appl. Mech. 49, 1982: four decimals.
#[test]
fn uniform_cantilever_of_wright_and_others() {
    let quoted = [
        (0.0, [3.5160, 22.0345, 61.6972]),
        (2.0, [4.1373, 22.6149, 62.2732]),
        (6.0, [7.3604, 26.8091, 66.6839]),
        (12.0, [13.1702, 37.6031, 79.6145]),
    ];
    for (speed, expected) in quoted {
        let found = frequencies(&TestBlade::uniform(1.0), Dof::Flap, speed, 60, 3);
        for (f, e) in found.iter().zip(expected) {
            // Half of the last decimal, and the last bits.
            assert!((f - e).abs() < 0.5001e-4, "{f} against {e} at {speed}");
        }
    }
}

/// The paper's Fig. 6–7 call 15 functions converged. On the stepped hingeless blade they are not.
/// N = 15 by an independent evaluation of the same functions in 80-digit arithmetic (mpmath); the
/// exact values by Taylor series in 40 digits.
#[test]
fn fifteen_functions_on_a_stepped_blade() {
    let exact = [51.261_342_728_55, 309.123_053_635_7, 828.445_457_357_6, 1_535.911_869_818, 2_412.891_901_824];
    let fifteen = [53.140_047_49, 321.401_860_13, 863.465_10, 1_601.331_19, 2_497.282_22];
    let digits = [2e-10, 5e-11, 1e-8, 5e-9, 5e-9];
    let blade = TestBlade::stepped();
    let high = |functions: usize| -> Vec<f64> {
        let found = frequencies(&blade, Dof::Flap, 0.0, functions, 5);
        found.iter().zip(exact).map(|(f, e)| f / e - 1.0).collect()
    };
    let found = frequencies(&blade, Dof::Flap, 0.0, 15, 5);
    for ((f, e), d) in found.iter().zip(fifteen).zip(digits) {
        assert!((f / e - 1.0).abs() < d, "{f} against {e}");
    }
    for (functions, range) in [(15, 0.034..0.044), (40, 0.0119..0.0186), (160, 0.003..0.005)] {
        let high = high(functions);
        println!("stepped blade, {functions} functions: {high:.4?} above the exact values");
        assert!(high.iter().all(|h| range.contains(h)), "{functions} functions: {high:?}");
    }
}
