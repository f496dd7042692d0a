//! Blades of other people's reports and programs. Values, tolerances and their reasons stand in
//! `tests/cases`; `cargo test -p bladefan-tests --test literature -- --nocapture` prints them
//! beside ours.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]
#![allow(clippy::print_stdout, reason = "the comparison is worth reading when it holds, too")]

use bladefan_core::Dof;
use bladefan_tests::blades::TestBlade;
use bladefan_tests::cases::Case;
use bladefan_tests::solve::frequencies;

#[test]
fn every_case_holds() {
    let cases = Case::all();
    assert!(cases.len() >= 9, "cases are missing");
    let mut broken = Vec::new();
    for (name, case) in cases {
        let compared = case.compare();
        println!("{name}: {}\n", case.table(&compared));
        if !compared.iter().all(|value| value.holds) {
            broken.push(format!("{name}: {}", case.table(&compared)));
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n\n"));
}

/// The driver notices a value that is off by more than its tolerance, and no smaller one.
#[test]
fn a_wrong_value_is_found() {
    let mut case = Case::all().into_iter().find(|(name, _)| name == "wright-1982").unwrap().1;
    let broken = |case: &Case| case.compare().iter().filter(|value| !value.holds).count();
    case.rows[12][2] += 0.5 * case.digits;
    assert_eq!(broken(&case), 0);
    case.rows[12][2] += 2.0 * case.digits;
    assert_eq!(broken(&case), 1);
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
