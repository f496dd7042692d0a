//! Coriolis terms.

use super::*;
use crate::coupled::certificate::{Form, index};
use crate::coupled::gyroscopic as turning;

fn assert_turning(found: &CoupledModes, known: &[f64], digits: f64) {
    for (mode, known) in found.modes.iter().zip(known) {
        let frequency = mode.eigenvalue.sqrt();
        assert!((frequency / known - 1.0).abs() < digits, "{frequency} {known}");
        let (lower, upper) = mode.bounds.unwrap();
        assert!(lower <= mode.eigenvalue && mode.eigenvalue <= upper);
        assert!((upper - lower) < 1e-8 * mode.eigenvalue, "{frequency}: {}", upper - lower);
    }
}

/// G-K: precone 0.05 with Coriolis terms, to the ten digits given, and bounded.
#[test]
fn coriolis_terms() {
    let coned = CoupledBlade { precone: 0.05, ..golden() };
    let found = turning::modes(&coned, 12.0, 6, &GaussRules::new()).unwrap();
    assert_turning(&found, &[10.70689507, 16.00341613, 25.71959268, 38.17581680, 59.91735429, 65.64886705], 1e-9);
}

/// V4: on two elements, of another program of the same method, to its digits.
#[test]
fn bounds_with_coriolis_terms_from_few_functions() {
    let (coned, rules) = (CoupledBlade { precone: 0.05, ..golden() }, GaussRules::new());
    let layout = Layout { radii: vec![0.25, 1.125, 2.0], orders: vec![[4; 3]; 2], highest: 5e3 };
    let assembly = Assembly::new(&coned, &layout, &rules, None);
    let functions = iterate(&assembly, 144.0, (24, 0), 1.0).unwrap().0;
    assert_eq!(functions.len(), 24, "all there are");
    let g = turning::Gyroscopic::new(&assembly);
    let solved = turning::solve(&coned, &assembly, &g, &functions, 12.0, 6).unwrap();
    let upper = [10.70844374, 16.00354177, 25.72090754, 38.18302626, 59.94771746, 65.65637537];
    for (found, known) in solved.values.iter().zip(upper) {
        assert!((found / known - 1.0).abs() < 1e-9, "{found} {known}");
    }
    let gaps = solved.gaps.map(|part| part / bounds::SLACK);
    let proof = turning::Proof { below: 6, rho: 72.0, theta: 0.5 };
    let found = turning::lower_bounds(&solved.values, &gaps, &proof).unwrap();
    let lower = [10.70439004, 16.0031817, 25.71657423, 38.14930128, 59.55490642, 65.47878074];
    for (found, known) in found.iter().zip(lower) {
        assert!((found / known - 1.0).abs() < 1e-9, "{found} {known}");
    }
}

/// Between the frequencies of G-K, on four elements.
#[test]
fn the_number_of_frequencies_below_is_proven_with_coriolis_terms() {
    let coned = CoupledBlade { precone: 0.05, ..golden() };
    let radii = (0..=4).map(|i| 0.25 + 1.75 * f64::from(i) / 4.0).collect();
    let layout = Layout { radii, orders: vec![[5; 3]; 4], highest: 5e3 };
    let assembly = Assembly::new(&coned, &layout, &GaussRules::new(), None);
    for (below, omega) in [5.0, 12.0, 20.0, 30.0, 50.0, 62.0, 70.0].into_iter().enumerate() {
        let form = Form { alpha: 1.0, s: 144.0, kappa: -omega * omega, turning: 12.0 * omega };
        assert_eq!(index(&assembly, form), Some(below), "{omega}");
    }
    // Between 16.0034 with these terms and 15.8597 without.
    let form = |turning| Form { alpha: 1.0, s: 144.0, kappa: -15.95 * 15.95, turning };
    assert_eq!(index(&assembly, form(12.0 * 15.95)), Some(1));
    assert_eq!(index(&assembly, form(0.0)), Some(2));
}
