//! The paper's functions in the coupled equations.

use super::*;
use crate::functions::{BendingRoot, ClassicalBending, ClassicalTorsion, TorsionRoot};
use alloc::boxed::Box;

fn clamped_functions(count: usize) -> Functions {
    let bending = || Box::new(ClassicalBending::new(BendingRoot::Clamped, count, 1.75, 2.5));
    [bending(), bending(), Box::new(ClassicalTorsion::new(TorsionRoot::Clamped, count, 1.75))]
}

fn assert_classical(blade: &CoupledBlade, functions: &Functions, proof: Proof, upper: &[f64], lower: &[f64]) {
    // Nothing known below ρ: bounded together or not at all.
    let proven = Proven { proof, lower: vec![0.0; proof.below] };
    let classical = Classical::new(blade, functions, &GaussRules::new());
    let found = classical.modes(144.0, proof.below, Some(&proven)).unwrap().modes;
    for ((mode, upper), lower) in found.iter().zip(upper).zip(lower) {
        let frequency = mode.eigenvalue.sqrt();
        // The digits given.
        assert!((frequency / upper - 1.0).abs() < 1e-9, "{frequency} {upper}");
        let bound = mode.bounds.unwrap().0.sqrt();
        // Energies of residual moments are taken 0.1 % larger than they are summed up to, which widens an
        // interval by 0.1 %, and a little more where it is wide: the bound is 1/ν.
        assert!((bound - lower).abs() < 1.5e-3 * (upper - lower), "{bound} {lower} {upper}");
        assert!(bound < *lower, "allowances widen");
    }
}

/// V5: the paper's functions, 8 and 15 of each motion, and 15 with a free flap hinge and a pitch spring.
#[test]
fn the_papers_functions_in_the_coupled_equations() {
    let proof = |rho| Proof { below: 6, rho, theta: 0.1, sigma: 50.0 };
    assert_classical(
        &golden(),
        &clamped_functions(8),
        proof(5000.0),
        &[10.85767512, 15.90443232, 25.98049117, 38.29334962, 60.02743063, 65.5340364],
        &[10.85523347, 15.90425625, 25.96292107, 38.28027099, 59.98402159, 65.49908173],
    );
    assert_classical(
        &golden(),
        &clamped_functions(15),
        proof(5000.0),
        &[10.85588488, 15.90431479, 25.96912779, 38.28645927, 60.01818517, 65.53031639],
        &[10.85571572, 15.90429886, 25.966803, 38.28517676, 60.01602955, 65.52617644],
    );
    let mut hinged = golden();
    root(0, 0.25, RootCondition::Free, &mut hinged);
    root(2, 0.25, RootCondition::Spring(40.0), &mut hinged);
    let spring = TorsionRoot::Spring(40.0 * 1.75 / 11.0);
    let functions: Functions = [
        Box::new(ClassicalBending::new(BendingRoot::Free, 15, 1.75, 2.5)),
        Box::new(ClassicalBending::new(BendingRoot::Clamped, 15, 1.75, 2.5)),
        Box::new(ClassicalTorsion::new(spring, 15, 1.75)),
    ];
    assert_classical(
        &hinged,
        &functions,
        proof(4000.0),
        &[10.22556267, 13.25832606, 20.94225164, 35.58809318, 52.39152501, 57.52898805],
        &[9.831895725, 13.2580314, 20.66768738, 35.46052129, 50.74318055, 53.56531648],
    );
    let converged = frequencies(&hinged, 12.0, 6);
    let known = [9.905236939, 13.25810688, 20.78124158, 35.52270858, 52.08279001, 56.81544103];
    assert!(converged.iter().zip(known).all(|(found, known)| (found / known - 1.0).abs() < 1e-9), "{converged:?}");
}

/// What the piecewise functions prove of the blade makes the paper's intervals narrower, and they hold the truth.
#[test]
fn the_papers_functions_are_bounded_by_what_is_proven() {
    for blade in [golden(), hinged(), everything()] {
        let found = modes(&blade, 144.0, 6, &GaussRules::new()).unwrap();
        let functions: Functions = [
            Box::new(ClassicalBending::new(BendingRoot::Free, 15, 1.75, 2.5)),
            Box::new(ClassicalBending::new(BendingRoot::Free, 15, 1.65, 2.5)),
            Box::new(ClassicalTorsion::new(TorsionRoot::Free, 15, 1.5)),
        ];
        let functions =
            if blade.roots[0].condition == RootCondition::Clamped { clamped_functions(15) } else { functions };
        let classical = Classical::new(&blade, &functions, &GaussRules::new());
        let by_paper = classical.modes(144.0, 6, found.proven.as_ref()).unwrap().modes;
        for (mode, truth) in by_paper.iter().zip(&found.modes) {
            let (lower, upper) = mode.bounds.unwrap();
            assert!(lower <= truth.eigenvalue && truth.eigenvalue <= upper, "{lower} {} {upper}", truth.eigenvalue);
            assert!(mode.eigenvalue >= truth.eigenvalue * (1.0 - 1e-12), "functions of a smaller space lie above");
        }
    }
}
