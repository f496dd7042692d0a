//! The product against the independent solution of [`bladefan_tests::exact`], which integrates the
//! differential equations and knows no assumed functions: Ritz values lie above and close in.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]
#![allow(clippy::print_stdout, reason = "the comparison is worth reading when it holds, too")]

use bladefan_core::Dof;
use bladefan_core::library;
use bladefan_tests::blades::{End, TestBlade};
use bladefan_tests::exact;
use bladefan_tests::random::{blade, cases, dof};
use bladefan_tests::solve::frequencies;
use proptest::prelude::*;

/// Rounding of both sides together, in relative terms.
const ROUNDING: f64 = 1e-9;

/// Relative errors of the lowest five frequencies for each number of functions.
fn errors(blade: &TestBlade, dof: Dof, speed: f64, functions: &[usize]) -> Vec<Vec<f64>> {
    let ritz: Vec<Vec<f64>> = functions.iter().map(|&n| frequencies(blade, dof, speed, n, 5)).collect();
    // Every exact value lies below the first, coarsest, Ritz value of its number.
    let exact = exact::frequencies(blade, dof, speed, ritz[0][4] * (1.0 + ROUNDING));
    // A rigid motion without a centrifugal spring has the frequency 0, which shooting does not list.
    let zeros = ritz[0].iter().filter(|&&f| f == 0.0).count();
    assert!(exact.len() >= 5 - zeros, "{dof} at {speed}: exact {exact:?}, Ritz {ritz:?}");
    ritz.iter().map(|found| found[zeros..].iter().zip(&exact).map(|(f, e)| f / e - 1.0).collect()).collect()
}

#[test]
fn built_in_blades() {
    for entry in library::ENTRIES {
        let blade = TestBlade::built_in(entry.name);
        for dof in Dof::ALL {
            for speed in [0.0, blade.nominal_speed] {
                let counts = [15, 60, 120];
                let errors = errors(&blade, dof, speed, &counts);
                for (functions, errors) in counts.iter().zip(&errors) {
                    let per_cent: Vec<String> = errors.iter().map(|e| format!("{:9.5}", 100.0 * e)).collect();
                    println!(
                        "{:14} {dof:7} {speed:8.3} rad/s, {functions:3} functions: {} % above exact",
                        entry.name,
                        per_cent.join(" ")
                    );
                    assert!(errors.iter().all(|e| *e >= -ROUNDING), "{} {dof} at {speed}: {errors:?}", entry.name);
                }
                for (few, many) in errors[0].iter().zip(&errors[2]) {
                    assert!(*many <= 0.3 * few + ROUNDING, "{} {dof} at {speed}: {few:e}, then {many:e}", entry.name);
                }
            }
        }
    }
}

/// On a stepped blade the error falls as 1/N: N times the error is nearly the same for N = 40 and 160.
#[test]
fn error_on_a_stepped_blade_falls_as_one_over_the_number_of_functions() {
    for end in [End::clamped(0.09), End::free(0.09), End::spring(0.09, 40.0)] {
        let blade = TestBlade::stepped().with_root(Dof::Flap, end);
        for speed in [0.0, 105.0] {
            let errors = errors(&blade, Dof::Flap, speed, &[15, 40, 160]);
            println!("{end:?} at {speed}: {errors:?}");
            for (few, many) in errors[1].iter().zip(&errors[2]) {
                assert!(*few >= -ROUNDING && *many >= -ROUNDING, "{end:?} at {speed}: {errors:?}");
                let ratio = few / many;
                assert!((2.5..6.0).contains(&ratio) || *few < 1e-7, "{end:?} at {speed}: {few:e}, then {many:e}");
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn ritz_values_lie_above_the_exact_ones(blade in blade(), dof in dof(), part in 0.0..1.5_f64) {
        let errors = errors(&blade, dof, part * blade.nominal_speed, &[12, 60]);
        for errors in &errors {
            prop_assert!(errors.iter().all(|e| *e >= -ROUNDING), "{:?}", errors);
        }
        // How much nearer depends on the blade: a piece shorter than a wave of the functions is not
        // felt yet by more of them. The rate is tested on the blades above.
        for (few, many) in errors[0].iter().zip(&errors[1]) {
            prop_assert!(*many <= few + ROUNDING, "{:?}", errors);
        }
    }
}
