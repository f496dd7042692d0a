#![allow(clippy::unwrap_used, clippy::float_cmp, reason = "a test may stop; what is not changed keeps its bits")]

use super::*;
use crate::blade::{PointMassDefinition, RootDefinition, check};
use crate::units::LengthUnit;
use alloc::vec;
use proptest::prelude::*;

const MASS: What = What::Property(Property::Mass);

fn blade() -> BladeDefinition {
    BladeDefinition::new("test", 4.0, 60.0)
        .with_flap(RootDefinition::hinged(0.5))
        .with_lag(RootDefinition::spring_hinged(0.5, 3.0))
        .with_torsion(RootDefinition::rigid(0.0))
        .with_stations([0.0, 1.0, 1.0, 4.0])
        .with(Property::Mass, [5.0, 5.0, 2.0, 1.0])
        .with(Property::FlapStiffness, 7.0)
        .with(Property::LagStiffness, [(0.0, 8.0), (4.0, 6.0)])
        .with(Property::TorsionStiffness, 3.0)
        .with(Property::PolarInertia, 0.1)
}

fn after(changes: &[Change]) -> BladeDefinition {
    change(&blade(), changes).unwrap().blade
}

fn property(blade: &BladeDefinition, property: Property) -> &PropertyDefinition {
    blade.distribution.as_ref().unwrap()[property].as_ref().unwrap()
}

fn own(points: &[(f64, f64)]) -> PropertyDefinition {
    points.into()
}

#[test]
fn the_whole_of_a_property_keeps_its_form() {
    let scaled = after(&[Change::new(MASS, Amount::Scale(3.0))]);
    assert_eq!(*property(&scaled, Property::Mass), PropertyDefinition::OnStations(vec![15.0, 15.0, 6.0, 3.0]));
    let all = Change::new(What::Property(Property::FlapStiffness), Amount::Add(1.0)).on(0.0, 4.0);
    assert_eq!(*property(&after(&[all]), Property::FlapStiffness), PropertyDefinition::Uniform(8.0));
}

#[test]
fn a_part_of_a_property_gets_steps_at_its_ends() {
    let lag = |amount, from, to| {
        let changed = after(&[Change::new(What::Property(Property::LagStiffness), amount).on(from, to)]);
        property(&changed, Property::LagStiffness).clone()
    };
    let expected = [(0.0, 8.0), (1.0, 7.5), (1.0, 15.0), (2.0, 14.0), (2.0, 7.0), (4.0, 6.0)];
    assert_eq!(lag(Amount::Scale(2.0), 1.0, 2.0), own(&expected));
    assert_eq!(lag(Amount::Set(9.0), 2.0, 5.0), own(&[(0.0, 8.0), (2.0, 7.0), (2.0, 9.0), (4.0, 9.0)]));
    let flap = Change::new(What::Property(Property::FlapStiffness), Amount::Scale(2.0)).on(-1.0, 1.0);
    let expected = [(0.0, 14.0), (1.0, 14.0), (1.0, 7.0), (4.0, 7.0)];
    assert_eq!(*property(&after(&[flap]), Property::FlapStiffness), own(&expected));
}

#[test]
fn a_step_that_is_there_takes_the_change_on_its_own_side() {
    let mass = Change { mass_alone: true, ..Change::new(MASS, Amount::Scale(2.0)).on(1.0, 4.0) };
    let expected = own(&[(0.0, 5.0), (1.0, 5.0), (1.0, 4.0), (4.0, 2.0)]);
    assert_eq!(*property(&after(&[mass]), Property::Mass), expected);
}

#[test]
fn steps_at_the_ends_of_a_table_stay() {
    let points = [(0.0, 9.0), (0.0, 1.0), (4.0, 1.0), (4.0, 9.0)];
    let given = blade().with(Property::LagStiffness, points);
    let scaled = Change::new(What::Property(Property::LagStiffness), Amount::Scale(2.0));
    let changed = change(&given, &[scaled.on(0.0, 2.0)]).unwrap().blade;
    let expected = [(0.0, 9.0), (0.0, 2.0), (2.0, 2.0), (2.0, 1.0), (4.0, 1.0), (4.0, 9.0)];
    assert_eq!(*property(&changed, Property::LagStiffness), own(&expected));
}

/// A tip three times as heavy is heavier to twist, too.
#[test]
fn scaled_mass_takes_its_inertia_along_and_says_so() {
    let heavy = Change::new(MASS, Amount::Scale(3.0)).on(2.0, 4.0);
    let Changed { blade: changed, notes } = change(&blade(), &[heavy]).unwrap();
    let inertia = own(&[(0.0, 0.1), (2.0, 0.1), (2.0, 0.1 * 3.0), (4.0, 0.1 * 3.0)]);
    assert_eq!(*property(&changed, Property::PolarInertia), inertia);
    assert_eq!(notes.len(), 1);
    assert_eq!(notes[0].to_string(), "distribution.polar_inertia: scaled by 3 along with the mass");
    for alone in [Change { mass_alone: true, ..heavy }, Change { amount: Amount::Add(3.0), ..heavy }] {
        let Changed { blade: changed, notes } = change(&blade(), &[alone]).unwrap();
        assert_eq!(property(&changed, Property::PolarInertia), property(&blade(), Property::PolarInertia));
        assert!(notes.is_empty());
    }
}

/// What is given instead of the polar inertia goes along as that would, and so do masses on the part.
#[test]
fn scaled_mass_takes_both_inertias_and_its_point_masses_along() {
    let mut given = blade()
        .with(Property::FlapInertia, 0.25)
        .with(Property::LagInertia, 0.5)
        .with_point_mass(PointMassDefinition::new(1.0, 1.0))
        .with_point_mass(PointMassDefinition::new(2.0, 1.0).with_offset(0.5).with_inertias(0.125, 0.375))
        .with_point_mass(PointMassDefinition::new(4.0, 1.0).with_offset(0.5));
    given.distribution.as_mut().unwrap()[Property::PolarInertia] = None;
    let heavy = Change::new(MASS, Amount::Scale(2.0)).on(2.0, 4.0);
    let Changed { blade: changed, notes } = change(&given, &[heavy]).unwrap();
    let twice = |value: f64| own(&[(0.0, value), (2.0, value), (2.0, 2.0 * value), (4.0, 2.0 * value)]);
    assert_eq!(*property(&changed, Property::FlapInertia), twice(0.25));
    assert_eq!(*property(&changed, Property::LagInertia), twice(0.5));
    let masses = [
        given.point_masses[0],
        PointMassDefinition::new(2.0, 2.0).with_offset(0.5).with_inertias(0.25, 0.75),
        PointMassDefinition::new(4.0, 2.0).with_offset(0.5),
    ];
    assert_eq!(changed.point_masses, masses);
    let paths: Vec<&str> = notes.iter().map(|note| note.path.as_str()).collect();
    assert_eq!(paths, ["distribution.flap_inertia", "distribution.lag_inertia", "point_mass[1]", "point_mass[2]"]);
    check(&changed).unwrap();
    // Where two parts meet, a mass is scaled once; beyond the tip and by nothing, never.
    let parts = [heavy, Change::new(MASS, Amount::Scale(2.0)).on(0.5, 2.0)];
    assert_eq!(change(&given, &parts).unwrap().blade.point_masses[1], masses[1]);
    for none in [
        Change { mass_alone: true, ..heavy },
        Change { amount: Amount::Add(3.0), ..heavy },
        Change { amount: Amount::Scale(1.0), ..heavy },
        heavy.on(5.0, 6.0),
    ] {
        let changed = change(&given, &[none]).unwrap();
        assert_eq!(changed.blade.point_masses, given.point_masses, "{none:?}");
        assert!(changed.notes.is_empty(), "{none:?}");
    }
}

#[test]
fn offsets_springs_and_the_nominal_speed_are_numbers_of_their_own() {
    let changed = after(&[
        Change::new(What::Offset(Dof::Flap), Amount::Set(0.75)),
        Change::new(What::Spring(Dof::Lag), Amount::Scale(2.0)),
        Change::new(What::Spring(Dof::Flap), Amount::Scale(2.0)),
        Change::new(What::NominalSpeed, Amount::Add(-10.0)),
    ]);
    assert_eq!(changed.flap, Some(RootDefinition::hinged(0.75)), "and no spring where there is none");
    assert_eq!(changed.lag, Some(RootDefinition::spring_hinged(0.5, 6.0)));
    assert_eq!(changed.rotor.unwrap().nominal_speed, Some(50.0));
    let mut ratio = blade();
    ratio.flap = Some(RootDefinition { offset: None, offset_ratio: Some(0.125), ..RootDefinition::hinged(0.0) });
    let flap = |amount| change(&ratio, &[Change::new(What::Offset(Dof::Flap), amount)]).unwrap().blade.flap.unwrap();
    assert_eq!((flap(Amount::Scale(2.0)).offset, flap(Amount::Scale(2.0)).offset_ratio), (None, Some(0.25)));
    assert_eq!((flap(Amount::Add(0.5)).offset, flap(Amount::Add(0.5)).offset_ratio), (Some(1.0), None));
    assert_eq!(Some(flap(Amount::Set(0.5))), ratio.flap, "as it was");
}

#[test]
fn what_may_be_left_out_can_be_set_and_what_must_be_given_stays_missing() {
    let twist = Change::new(What::Property(Property::Twist), Amount::Set(0.1)).on(2.0, 4.0);
    assert_eq!(*property(&after(&[twist]), Property::Twist), own(&[(0.0, 0.0), (2.0, 0.0), (2.0, 0.1), (4.0, 0.1)]));
    let bare = BladeDefinition::new("bare", 1.0, 1.0);
    let (torsion, others): (Vec<What>, Vec<What>) = What::all().partition(|what| what.is_of_torsion());
    let changes: Vec<Change> = others.into_iter().map(|what| Change::new(what, Amount::Scale(2.0))).collect();
    let changed = change(&bare, &changes).unwrap().blade;
    assert_eq!((changed.distribution, changed.flap), (None, None));
    let given = BladeDefinition { distribution: Some(DistributionDefinition::default()), ..bare };
    let set = [Change::new(MASS, Amount::Set(2.0)).on(0.0, 0.5)];
    assert_eq!(change(&given, &set).unwrap().blade, given);
    // A blade of flap and lag alone has nothing of torsion to be changed.
    for what in torsion {
        let faults = change(&given, &[Change::new(what, Amount::Set(2.0))]).unwrap_err();
        let path = what.path();
        let message =
            format!("changes[0].what: {path} needs a blade with torsion data: this one has flap and lag alone");
        assert_eq!(faults.to_string(), message);
    }
}

#[test]
fn a_change_that_changes_nothing_leaves_every_bit() {
    for what in What::all() {
        for amount in [Amount::Scale(1.0), Amount::Add(0.0)] {
            for part in [Part::WHOLE, Part { from: Some(1.5), to: None }] {
                if part != Part::WHOLE && !matches!(what, What::Property(_)) {
                    continue;
                }
                assert_eq!(after(&[Change { part, ..Change::new(what, amount) }]), blade(), "{what:?} {amount:?}");
            }
        }
    }
    assert_eq!(after(&[Change::new(MASS, Amount::Scale(4.0)).on(5.0, 6.0)]), blade(), "beyond the tip");
    assert_eq!(after(&[]), blade());
}

#[test]
fn numbers_of_a_change_have_units_of_their_own() {
    let inches = Units { length: LengthUnit::Inch, ..Units::default() };
    let metres = Units::default();
    let given = crate::blade::convert(&blade(), inches);
    let offset = Change::new(What::Offset(Dof::Flap), Amount::Set(0.254)).in_units(metres);
    assert_eq!(change(&given, &[offset]).unwrap().blade.flap.unwrap().offset, Some(10.0));
    let half = Change::new(What::Property(Property::FlapStiffness), Amount::Scale(0.5)).on(0.254, 0.508);
    let changed = change(&given, &[half.in_units(metres)]).unwrap().blade;
    let PropertyDefinition::OwnRadii { r, .. } = property(&changed, Property::FlapStiffness) else { unreachable!() };
    assert_eq!(r[1..5], [10.0, 10.0, 20.0, 20.0]);
}

#[test]
fn changes_that_are_none_are_refused_at_once() {
    let bad = [
        Change::new(MASS, Amount::Scale(f64::NAN)).on(2.0, 1.0),
        Change::new(What::Offset(Dof::Lag), Amount::Set(1.0)).on(0.0, 1.0),
        Change { part: Part { from: None, to: Some(f64::INFINITY) }, ..Change::new(MASS, Amount::Add(1.0)) },
    ];
    let faults: Vec<String> = change(&blade(), &bad).unwrap_err().iter().map(ToString::to_string).collect();
    let expected = [
        "changes[0].scale: must be finite (is NaN)",
        "changes[0].to: must be greater than from (is 1)",
        "changes[1].from: belongs to a property along the span only (is 0)",
        "changes[2].to: must be finite (is inf)",
    ];
    assert_eq!(faults, expected);
}

#[test]
fn paths_name_everything_that_can_be_changed() {
    for what in What::all() {
        assert_eq!(What::from_path(&what.path()), Some(what));
    }
    assert_eq!(What::Offset(Dof::Torsion).path(), "torsion.offset");
    assert_eq!(What::from_path("rotor.radius"), None);
}

/// As the page once computed it: scaled pieces, a step at either end, no point twice.
fn as_on_the_page(r: &[f64], values: &[f64], from: f64, to: f64, factor: f64) -> Vec<(f64, f64)> {
    let mut out: Vec<(f64, f64)> = Vec::new();
    for i in 0..r.len() - 1 {
        let (a, b) = (r[i], r[i + 1]);
        if a >= b {
            continue;
        }
        let at = |x: f64| {
            if x == a {
                values[i]
            } else if x == b {
                values[i + 1]
            } else {
                values[i] + ((values[i + 1] - values[i]) * (x - a)) / (b - a)
            }
        };
        let mut cuts = vec![a];
        cuts.extend([from, to].into_iter().filter(|&x| x > a && x < b));
        cuts.push(b);
        for pair in cuts.windows(2) {
            let own = if pair[0] >= from && pair[1] <= to { factor } else { 1.0 };
            out.push((pair[0], at(pair[0]) * own));
            out.push((pair[1], at(pair[1]) * own));
        }
    }
    out.dedup();
    out
}

proptest! {
    #[test]
    fn parts_are_scaled_as_the_page_scaled_them(
        stations in prop::collection::vec((1..4_u32, 0.0..9.0_f64, any::<bool>()), 1..9),
        ends in (0.0..12.0_f64, 0.1..12.0_f64),
        factor in 0.25..4.0_f64,
    ) {
        let (mut r, mut values) = (vec![0.0], vec![1.5]);
        for (step, value, twice) in stations {
            let last = r[r.len() - 1] + f64::from(step);
            r.push(last);
            values.push(value);
            if twice {
                r.push(last);
                values.push(value + 1.0);
            }
        }
        // The page lost a step at the very end.
        r.push(r[r.len() - 1] + 1.0);
        values.push(2.0);
        let (from, to) = (ends.0, ends.0 + ends.1);
        let page = as_on_the_page(&r, &values, from, to, factor);
        let given = blade().with(Property::LagStiffness, PropertyDefinition::OwnRadii { r, values });
        let scaled = Change::new(What::Property(Property::LagStiffness), Amount::Scale(factor)).on(from, to);
        let changed = change(&given, &[scaled]).unwrap().blade;
        let PropertyDefinition::OwnRadii { r, values } = property(&changed, Property::LagStiffness) else { unreachable!() };
        let found: Vec<(f64, f64)> = r.iter().copied().zip(values.iter().copied()).collect();
        prop_assert_eq!(found, page);
    }
}

#[test]
fn a_changed_blade_is_a_legal_blade() {
    let heavy_tip = Change::new(MASS, Amount::Scale(3.0)).on(2.5, 4.0);
    assert_eq!(check(&after(&[heavy_tip])).unwrap().mass().limits(2.5), (1.5, 4.5));
}
