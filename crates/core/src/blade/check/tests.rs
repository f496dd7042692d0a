#![allow(clippy::unwrap_used, clippy::float_cmp, reason = "a test may stop; conversions here are exact")]

use super::*;
use crate::blade::{DistributionDefinition, PropertyDefinition};
use crate::units::{ForceUnit, LengthUnit, MassUnit, SpeedUnit};
use alloc::vec;

/// A uniform blade with roots at the centre of rotation.
pub(super) fn definition() -> BladeDefinition {
    BladeDefinition::new("test", 2.0, 60.0)
        .with_flap(RootDefinition::hingeless(0.0))
        .with_lag(RootDefinition::hinged(0.0))
        .with_torsion(RootDefinition::rigid(0.0))
        .with(Property::Mass, 1.0)
        .with(Property::FlapStiffness, 1.0)
        .with(Property::LagStiffness, 1.0)
        .with(Property::TorsionStiffness, 1.0)
        .with(Property::PolarInertia, 1.0)
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
    given.flap = Some(RootDefinition { offset: None, offset_ratio: Some(0.25), ..RootDefinition::hingeless(0.0) });
    given.lag = Some(RootDefinition::spring_hinged(0.5, 3.0));
    let distribution = given.distribution.as_mut().unwrap();
    distribution.r = Some(vec![0.0, 1.0, 1.0, 2.0]);
    distribution[Property::Mass] = Some(PropertyDefinition::OnStations(vec![4.0, 3.0, 2.0, 1.0]));
    distribution[Property::MassOffset] = Some(PropertyDefinition::Uniform(-0.5));
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
    assert!(blade.warnings().is_empty());
}

#[test]
fn a_spring_of_zero_is_a_free_root() {
    let mut given = definition();
    given.torsion = Some(RootDefinition::spring(0.0, -0.0));
    let blade = check(&given).unwrap();
    assert_eq!(blade.root(Dof::Torsion).condition, RootCondition::Free);
    assert_eq!(blade.root(Dof::Lag).condition, RootCondition::Free);
}

#[test]
fn an_empty_definition_misses_everything_that_must_be_there() {
    assert_eq!(paths(&BladeDefinition::default()), ["name", "rotor", "flap", "lag", "distribution"]);
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

/// Without anything of torsion there are flap and lag alone; a part of it is none.
#[test]
fn torsion_may_be_left_out_as_a_whole() {
    let all = [Property::TorsionStiffness, Property::PolarInertia];
    let bare = all.into_iter().fold(BladeDefinition { torsion: None, ..definition() }, without);
    let offset = bare.clone().with(Property::MassOffset, [(0.0, 0.1), (1.0, 0.2)]);
    for given in [&bare, &offset] {
        let blade = check(given).unwrap();
        assert_eq!((blade.dofs(), blade.has_torsion()), (&[Dof::Flap, Dof::Lag][..], false));
        assert_eq!(blade.warnings()[0].to_string(), "torsion: no torsion data: flap and lag alone");
        assert_eq!(blade.root(Dof::Torsion).offset, blade.radius(), "nothing twists");
        assert_eq!(blade.inertias().map(|inertia| inertia.at(1.0)), [0.0; 2]);
    }
    assert_eq!(check(&definition()).unwrap().dofs(), Dof::ALL);
    let [root, stiffness, inertia] = ["torsion", "distribution.torsion_stiffness", "distribution.polar_inertia"];
    let parts = [
        (bare.clone().with_torsion(RootDefinition::rigid(0.0)), [stiffness, inertia]),
        (bare.clone().with(Property::TorsionStiffness, 1.0), [root, inertia]),
        (bare.clone().with(Property::PolarInertia, 1.0), [root, stiffness]),
        (bare.with(Property::FlapInertia, 1.0).with(Property::LagInertia, 1.0), [root, stiffness]),
    ];
    for (given, missing) in parts {
        assert_eq!(paths(&given), missing);
        let faults = check(&given).unwrap_err().to_string();
        assert_eq!(faults.matches("be left out together").count(), 2, "{faults}");
    }
}

#[test]
fn mass_must_act_outboard_of_each_bending_root_and_inertia_outboard_of_torsion() {
    let mut given = definition();
    given.lag.as_mut().unwrap().offset = Some(1.5);
    let distribution = given.distribution.as_mut().unwrap();
    let inner = PropertyDefinition::OwnRadii { r: vec![0.0, 1.0, 2.0], values: vec![1.0, 0.0, 0.0] };
    distribution[Property::Mass] = Some(inner.clone());
    distribution[Property::PolarInertia] = Some(inner);
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
    distribution[Property::FlapStiffness] = Some(PropertyDefinition::OwnRadii { r, values: vec![9.0, 1.0, 1.0, 9.0] });
    assert_eq!(check(&given).unwrap().stiffness(Dof::Flap).at(1.5), 1.0);
}

#[test]
fn radii_one_above_the_other_are_told_apart_from_steps() {
    let mut given = definition();
    let r = vec![0.0, 1.0, 1.0, 1.0 + 1e-12, f64::NAN, 1.5, 1.2, 2.0, 2.0, 2.0];
    given.distribution.as_mut().unwrap()[Property::Mass] =
        Some(PropertyDefinition::OwnRadii { values: vec![1.0; r.len()], r });
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
    given.distribution.as_mut().unwrap()[Property::Mass] =
        Some(PropertyDefinition::OwnRadii { values: vec![1.0; r.len()], r });
    let faults = check(&given).unwrap_err();
    assert_eq!(faults.len(), 1, "{faults:?}");
    assert_eq!((faults[0].code, faults[0].path.as_str()), (FaultCode::Radii, "distribution.mass.r"));
}

#[test]
fn numbers_whose_squares_would_not_be_numbers_are_refused() {
    let refused = |given: BladeDefinition| check(&given).unwrap_err().to_string();
    let cases = [
        (
            definition().with(Property::Mass, 1e-110),
            "distribution.mass: mass per length must be 0 or from 1e-30 to 1e30 kg/m (is 1e-110)",
        ),
        (
            definition().with(Property::FlapStiffness, [(0.0, 1e200), (2.0, 1.0)]),
            "distribution.flap_stiffness.values[0]: flap stiffness at r = 0 m must be from 1e-30 to 1e30 N·m² (is 1e200)",
        ),
        (
            definition().with(Property::TorsionStiffness, 1e-31),
            "distribution.torsion_stiffness: torsion stiffness must be from 1e-30 to 1e30 N·m² (is 1e-31)",
        ),
        (
            definition().with(Property::PolarInertia, 1e31),
            "distribution.polar_inertia: polar inertia must be 0 or from 1e-30 to 1e30 kg·m (is 1e31)",
        ),
        (
            definition().with(Property::MassOffset, -1e7),
            "distribution.mass_offset: mass offset must be from -1e6 to 1e6 m (is -10000000)",
        ),
        (
            definition().with(Property::Twist, 1e7),
            "distribution.twist: twist must be from -1e6 to 1e6 rad (is 10000000)",
        ),
        (
            definition().with_lag(RootDefinition::spring_hinged(0.0, 1e200)),
            "lag.spring: lag spring must be 0 or from 1e-30 to 1e30 N·m/rad (is 1e200)",
        ),
    ];
    for (given, message) in cases {
        assert_eq!(refused(given), message);
    }
    let rotor =
        |radius, speed| BladeDefinition { rotor: BladeDefinition::new("", radius, speed).rotor, ..definition() };
    assert_eq!(refused(rotor(1e-200, 60.0)), "rotor.radius: tip radius must be from 1e-6 to 1e6 m (is 1e-200)");
    assert_eq!(
        refused(rotor(2.0, 1e80)),
        "rotor.nominal_speed: nominal speed must be from 1e-9 to 1e9 rad/s (is 1e80)"
    );
}

/// The units of the file do not matter: 1e4 km would be legal in millimetres.
#[test]
fn sizes_are_looked_at_in_si_units() {
    let mut given = definition().with(Property::FlapStiffness, 1e31);
    given.units.length = LengthUnit::Millimetre;
    let rotor = RotorDefinition { radius: Some(2e7), ..given.rotor.unwrap() };
    assert_eq!(check(&BladeDefinition { rotor: Some(rotor), ..given }).unwrap().radius(), 2e4);
}

#[test]
fn too_many_stations_are_one_fault_of_each_list() {
    let list = |count: usize| -> Vec<f64> { (0..count).map(|i| 2.0 * i as f64 / (count - 1) as f64).collect() };
    let with = |count| definition().with_stations(list(count)).with(Property::Mass, vec![1.0; count]);
    assert_eq!(check(&with(10_000)).unwrap().mass().stations().len(), 10_000);
    let expected = "distribution.r: list of radii must have at most 10000 values (has 10001)\n\
                    distribution.mass: mass per length must have at most 10000 values (has 10001)";
    assert_eq!(check(&with(10_001)).unwrap_err().to_string(), expected);
}

fn without(mut given: BladeDefinition, property: Property) -> BladeDefinition {
    given.distribution.as_mut().unwrap()[property] = None;
    given
}

#[test]
fn polar_inertia_is_the_sum_of_flap_and_lag_inertia_where_it_is_not_given() {
    let both = definition()
        .with(Property::FlapInertia, [(0.0, 1.0), (1.0, 1.0), (1.0, 3.0), (2.0, 3.0)])
        .with(Property::LagInertia, [(0.0, 2.0), (1.5, 5.0), (2.0, 0.0)]);
    let sum = check(&without(both.clone(), Property::PolarInertia)).unwrap();
    assert_eq!(sum.polar_inertia().stations(), [0.0, 1.0, 1.0, 1.5, 2.0]);
    assert_eq!(sum.polar_inertia().values(), [3.0, 5.0, 7.0, 8.0, 3.0]);
    assert!(sum.inertias_given() && !sum.gives(Property::PolarInertia));
    let given = check(&both).unwrap();
    assert_eq!(given.polar_inertia(), &PiecewiseLinear::uniform(1.0), "what is given stays");
    assert_eq!((given.flap_inertia(), given.lag_inertia()), (sum.flap_inertia(), sum.lag_inertia()));
    let neither = check(&definition()).unwrap();
    assert!(!neither.inertias_given() && neither.gives(Property::PolarInertia));
    assert_eq!(neither.flap_inertia(), &PiecewiseLinear::uniform(0.0));
}

#[test]
fn flap_and_lag_inertia_stand_together() {
    let alone = definition().with(Property::FlapInertia, 1.0);
    let message = "distribution.lag_inertia: lag inertia must be given where flap_inertia is";
    for given in [alone.clone(), without(alone, Property::PolarInertia)] {
        assert_eq!(check(&given).unwrap_err().to_string(), message);
    }
    let alone = definition().with(Property::LagInertia, 0.0);
    let message = "distribution.flap_inertia: flap inertia must be given where lag_inertia is";
    assert_eq!(check(&alone).unwrap_err().to_string(), message);
    // A faulty part makes no second fault of the sum.
    let faulty = definition().with(Property::FlapInertia, -1.0).with(Property::LagInertia, 1.0);
    let message = "distribution.flap_inertia: flap inertia must be at least 0 (is -1)";
    assert_eq!(check(&without(faulty, Property::PolarInertia)).unwrap_err().to_string(), message);
}

#[test]
fn a_sum_of_inertias_must_act_in_torsion_and_its_parts_be_known_outboard_of_every_root() {
    let with = |flap: &[(f64, f64)], lag: f64| {
        let given = definition().with_torsion(RootDefinition::rigid(1.0)).with(Property::FlapInertia, flap);
        check(&without(given.with(Property::LagInertia, lag), Property::PolarInertia))
    };
    let inner = [(0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (2.0, 0.0)];
    assert!(with(&inner, 1.0).is_ok());
    let message = "distribution.lag_inertia: flap inertia or lag inertia must be greater than 0 somewhere outboard of \
                   the torsion root at r = 1 m";
    assert_eq!(with(&inner, 0.0).unwrap_err().to_string(), message);
    let message = "distribution.flap_inertia: flap inertia must be given from r = 0 to 2 m (is given from 1 to 2 m)";
    assert_eq!(with(&[(1.0, 1.0), (2.0, 1.0)], 1.0).unwrap_err().to_string(), message);
    assert!(with(&[(1.0, 0.0), (1.5, 0.0)], 1.0).is_ok(), "0 everywhere need be known nowhere");
}

#[test]
fn what_gives_the_trapeze_radius_stands_alone() {
    let given = definition().with(Property::AxialStiffness, 5e8).with(Property::TensionOffset, -0.1);
    let blade = check(&given).unwrap();
    assert_eq!((blade.axial_stiffness().at(1.0), blade.tension_offset().at(1.0)), (5e8, -0.1));
    assert_eq!(check(&definition().with(Property::TrapezeRadius, 0.1)).unwrap().trapeze_radius().at(1.0), 0.1);
    let message = "distribution.trapeze_radius: trapeze radius must not be given beside axial_stiffness";
    assert_eq!(check(&given.with(Property::TrapezeRadius, 0.1)).unwrap_err().to_string(), message);
    let cases = [
        (Property::AxialStiffness, 0.0, "axial_stiffness: axial stiffness must be greater than 0 (is 0)"),
        (Property::TrapezeRadius, -0.1, "trapeze_radius: trapeze radius must be at least 0 (is -0.1)"),
        (Property::TensionOffset, 1e7, "tension_offset: tension offset must be from -1e6 to 1e6 m (is 10000000)"),
    ];
    for (property, value, message) in cases {
        let found = check(&definition().with(property, value)).unwrap_err().to_string();
        assert_eq!(found, format!("distribution.{message}"));
    }
}
