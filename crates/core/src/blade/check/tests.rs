#![allow(clippy::unwrap_used, clippy::float_cmp, reason = "a test may stop; conversions here are exact")]

use super::*;
use crate::blade::{DistributionDefinition, PropertyDefinition};
use crate::units::{ForceUnit, LengthUnit, MassUnit, SpeedUnit};
use alloc::vec;

fn root(root: RootKind) -> RootDefinition {
    RootDefinition { root: Some(root), ..RootDefinition::default() }
}

/// A uniform blade with roots at the centre of rotation.
fn definition() -> BladeDefinition {
    let one = Some(PropertyDefinition::Uniform(1.0));
    BladeDefinition {
        name: Some("test".into()),
        rotor: Some(RotorDefinition { radius: Some(2.0), nominal_speed: Some(60.0), blades: None }),
        flap: Some(root(RootKind::Hingeless)),
        lag: Some(root(RootKind::Hinged)),
        torsion: Some(root(RootKind::Rigid)),
        distribution: Some(DistributionDefinition {
            mass: one.clone(),
            flap_stiffness: one.clone(),
            lag_stiffness: one.clone(),
            torsion_stiffness: one.clone(),
            polar_inertia: one,
            ..DistributionDefinition::default()
        }),
        ..BladeDefinition::default()
    }
}

fn paths(definition: &BladeDefinition) -> Vec<String> {
    check(definition).unwrap_err().into_iter().map(|fault| fault.path).collect()
}

#[test]
fn everything_is_converted_once() {
    let mut given = definition();
    given.units = Units {
        length: LengthUnit::Foot,
        mass: MassUnit::Pound,
        force: ForceUnit::PoundForce,
        speed: SpeedUnit::Rpm,
        ..Units::default()
    };
    given.flap.as_mut().unwrap().offset_ratio = Some(0.25);
    given.lag = Some(RootDefinition {
        root: Some(RootKind::SpringHinged),
        offset: Some(0.5),
        offset_ratio: None,
        spring: Some(3.0),
    });
    let distribution = given.distribution.as_mut().unwrap();
    distribution.r = Some(vec![0.0, 1.0, 1.0, 2.0]);
    distribution.mass = Some(PropertyDefinition::OnStations(vec![4.0, 3.0, 2.0, 1.0]));
    distribution.mass_offset = Some(PropertyDefinition::Uniform(-0.5));
    let blade = check(&given).unwrap();
    let (foot, pound, lbf) = (0.3048, 0.453_592_37, 0.453_592_37 * 9.806_65);
    assert_eq!(blade.radius(), 2.0 * foot);
    assert_eq!(blade.nominal_speed(), 60.0 * crate::units::RAD_S_PER_RPM);
    assert_eq!(blade.root(Dof::Flap), Root { offset: 0.25 * (2.0 * foot), condition: RootCondition::Clamped });
    assert_eq!(blade.root(Dof::Lag), Root { offset: 0.5 * foot, condition: RootCondition::Spring(3.0 * (lbf * foot)) });
    assert_eq!(blade.mass().stations(), [0.0, foot, foot, 2.0 * foot]);
    assert_eq!(blade.mass().values()[1], 3.0 * (pound / foot));
    assert_eq!(blade.stiffness(Dof::Torsion).at(0.1), lbf * foot * foot);
    assert_eq!(blade.polar_inertia().at(0.1), pound * foot);
    assert_eq!(blade.mass_offset().at(0.1), -0.5 * foot);
    assert_eq!(blade.warnings().len(), 1);
}

#[test]
fn a_spring_of_zero_is_a_free_root() {
    let mut given = definition();
    given.torsion =
        Some(RootDefinition { root: Some(RootKind::Spring), spring: Some(-0.0), ..RootDefinition::default() });
    let blade = check(&given).unwrap();
    assert_eq!(blade.root(Dof::Torsion).condition, RootCondition::Free);
    assert_eq!(blade.root(Dof::Lag).condition, RootCondition::Free);
}

#[test]
fn an_empty_definition_misses_everything_that_must_be_there() {
    assert_eq!(paths(&BladeDefinition::default()), ["name", "rotor", "flap", "lag", "torsion", "distribution"]);
    let mut given = definition();
    given.rotor = Some(RotorDefinition::default());
    given.flap = Some(RootDefinition::default());
    given.distribution = Some(DistributionDefinition::default());
    let expected = [
        "rotor.radius",
        "rotor.nominal_speed",
        "flap.root",
        "distribution.mass",
        "distribution.flap_stiffness",
        "distribution.lag_stiffness",
        "distribution.torsion_stiffness",
        "distribution.polar_inertia",
    ];
    assert_eq!(paths(&given), expected);
}

#[test]
fn mass_must_act_outboard_of_each_bending_root_and_inertia_outboard_of_torsion() {
    let mut given = definition();
    given.lag.as_mut().unwrap().offset = Some(1.5);
    let distribution = given.distribution.as_mut().unwrap();
    let inner = PropertyDefinition::OwnRadii { r: vec![0.0, 1.0, 2.0], values: vec![1.0, 0.0, 0.0] };
    distribution.mass = Some(inner.clone());
    distribution.polar_inertia = Some(inner);
    let faults = check(&given).unwrap_err();
    assert_eq!(faults.len(), 1);
    assert_eq!(
        faults[0].message,
        "mass per length must be greater than 0 somewhere outboard of the lag root at r = 1.5 m"
    );
}

#[test]
fn a_step_may_lie_at_the_root_and_at_the_tip() {
    let mut given = definition();
    given.flap.as_mut().unwrap().offset = Some(1.0);
    let distribution = given.distribution.as_mut().unwrap();
    let r = vec![1.0, 1.0, 2.0, 2.0];
    distribution.flap_stiffness = Some(PropertyDefinition::OwnRadii { r, values: vec![9.0, 1.0, 1.0, 9.0] });
    assert_eq!(check(&given).unwrap().stiffness(Dof::Flap).at(1.5), 1.0);
}

#[test]
fn radii_one_above_the_other_are_told_apart_from_steps() {
    let mut given = definition();
    let r = vec![0.0, 1.0, 1.0, 1.0 + 1e-12, f64::NAN, 1.5, 1.2, 2.0, 2.0, 2.0];
    given.distribution.as_mut().unwrap().mass = Some(PropertyDefinition::OwnRadii { values: vec![1.0; r.len()], r });
    let found: Vec<_> = check(&given).unwrap_err().into_iter().map(|fault| (fault.path, fault.code)).collect();
    let place = |i: usize| format!("distribution.mass.r[{i}]");
    let expected = [
        (place(3), FaultCode::Radii),
        (place(4), FaultCode::NotFinite),
        (place(6), FaultCode::Radii),
        (place(9), FaultCode::Radii),
    ];
    assert_eq!(found, expected);
}

#[test]
fn radii_that_fall_together_in_si_units_are_refused() {
    let mut given = definition();
    given.units.length = LengthUnit::Millimetre;
    // Neighbouring numbers, all beyond the tip: fewer of them in metres.
    let next = |steps: u64| f64::from_bits(2.1e9_f64.to_bits() + steps);
    let r = vec![0.0, 2.0, next(1), next(1), next(2), next(3), next(4), next(5), next(6), next(7), next(8)];
    given.distribution.as_mut().unwrap().mass = Some(PropertyDefinition::OwnRadii { values: vec![1.0; r.len()], r });
    let faults = check(&given).unwrap_err();
    assert_eq!(faults.len(), 1, "{faults:?}");
    assert_eq!((faults[0].code, faults[0].path.as_str()), (FaultCode::Radii, "distribution.mass.r"));
}

#[test]
fn numbers_are_shown_shortest() {
    for (value, text) in [
        (-17.0, "-17"),
        (0.3, "0.3"),
        (5e6, "5000000"),
        (1e300, "1e300"),
        (-0.0, "-0"),
        (1.5e-7, "1.5e-7"),
        (f64::INFINITY, "inf"),
        (f64::NAN, "NaN"),
    ] {
        assert_eq!(shortest(value), text);
    }
}
