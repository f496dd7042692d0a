//! Blades without torsion data: flap and lag as with it, each on its own; coupled, one system of the two, which is the
//! limit of a blade that hardly twists.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use bladefan_core::report::CoupledModesReport;
use bladefan_core::{
    Amount, Blade, BladeDefinition, Change, Dof, FaultCode, ModelKind, PointMassDefinition, Property, RootDefinition,
    Settings, What, change, check, converge, coupled_modes, coupled_shapes, fan, modes, shapes, summary,
};
use bladefan_tests::blades::without_torsion;

/// A tapered, twisted blade on hinges of its own, with a weight on it and one at the tip.
fn whole() -> BladeDefinition {
    BladeDefinition::new("test", 2.0, 30.0)
        .with_pitch(0.15)
        .with_flap(RootDefinition::hinged(0.1))
        .with_lag(RootDefinition::spring_hinged(0.2, 30.0))
        .with_torsion(RootDefinition::rigid(0.1))
        .with(Property::Mass, [(0.1, 3.0), (2.0, 2.0)])
        .with(Property::FlapStiffness, [(0.1, 20.0), (2.0, 8.0)])
        .with(Property::LagStiffness, [(0.2, 200.0), (2.0, 100.0)])
        .with(Property::TorsionStiffness, 15.0)
        .with(Property::PolarInertia, 0.03)
        .with(Property::Twist, [(0.1, 0.5), (2.0, 0.0)])
        .with_point_mass(PointMassDefinition::new(1.2, 0.5))
        .with_point_mass(PointMassDefinition::new(2.0, 0.2))
}

fn bare() -> Blade {
    check(&without_torsion(whole())).unwrap()
}

fn coupled() -> Settings {
    Settings { model: Some(ModelKind::Coupled), coupled_modes: 8, ..Settings::default() }
}

const TOLD: &str = "torsion: no torsion data: flap and lag alone";

#[test]
fn flap_and_lag_are_as_with_torsion() {
    let bending = Settings { dofs: vec![Dof::Flap, Dof::Lag], ..Settings::of(ModelKind::Uncoupled) };
    let (blade, other) = (bare(), check(&whole()).unwrap());
    let all = Settings::of(ModelKind::Uncoupled);
    let report = modes(&blade, &all).unwrap();
    assert_eq!(report.modes, modes(&other, &bending).unwrap().modes);
    assert_eq!(report.basis.functions.torsion, None);
    assert_eq!(report.warnings[0].to_string(), TOLD);
    assert_eq!(shapes(&blade, &all).unwrap().shapes, shapes(&other, &bending).unwrap().shapes);
    assert_eq!(converge(&blade, &all).unwrap().series, converge(&other, &bending).unwrap().series);
    let (chart, known) = (fan(&blade, &all).unwrap(), fan(&other, &bending).unwrap());
    assert_eq!((chart.branches, chart.crossings), (known.branches, known.crossings));
    let told = summary(&blade);
    assert_eq!(told.dofs.iter().map(|dof| dof.dof).collect::<Vec<_>>(), [Dof::Flap, Dof::Lag]);
    assert_eq!(told.dofs, summary(&other).dofs[..2]);
    assert_eq!(told.warnings[0].to_string(), TOLD);
}

#[test]
fn torsion_asked_for_by_itself_is_refused() {
    for (model, dofs) in [
        (ModelKind::Uncoupled, vec![Dof::Torsion]),
        (ModelKind::Uncoupled, vec![Dof::Flap, Dof::Torsion]),
        (ModelKind::Coupled, vec![Dof::Torsion]),
    ] {
        let settings = Settings { model: Some(model), dofs, ..coupled() };
        let faults = match model {
            ModelKind::Uncoupled => modes(&bare(), &settings).unwrap_err(),
            ModelKind::Coupled => coupled_modes(&bare(), &settings).unwrap_err(),
        };
        assert_eq!((faults[0].code, faults[0].path.as_str()), (FaultCode::Missing, "dof"));
        let missing = "[torsion], torsion_stiffness and polar_inertia";
        assert!(faults[0].message.ends_with(missing), "{faults}");
    }
}

#[test]
fn nothing_of_torsion_can_be_changed() {
    let stiffer = Change::new(What::Property(Property::TorsionStiffness), Amount::Scale(2.0));
    let faults = change(&without_torsion(whole()), &[stiffer]).unwrap_err();
    assert_eq!(faults[0].path, "changes[0].what");
    let heavier = Change::new(What::Property(Property::Mass), Amount::Scale(2.0));
    let changed = change(&without_torsion(whole()), &[heavier]).unwrap().blade;
    assert!(!check(&changed).unwrap().has_torsion(), "a scaled mass makes no inertia");
}

/// Every mode bounded and without torsion.
fn solved(blade: &Blade, settings: &Settings) -> CoupledModesReport {
    let report = coupled_modes(blade, settings).unwrap();
    assert_eq!(report.modes.len(), settings.coupled_modes);
    for mode in &report.modes {
        let (Some(lower), Some(upper)) = (mode.lower_rad_s, mode.upper_rad_s) else {
            panic!("{} has no bounds: {:?}", mode.label, mode.bounds_missing);
        };
        assert!(lower <= upper && upper - lower < 1e-8 * upper, "{}: {lower} {upper}", mode.label);
    }
    report
}

fn assert_limit(bare: &CoupledModesReport, limit: &CoupledModesReport) {
    for (mode, known) in bare.modes.iter().zip(&limit.modes) {
        let (found, known) = (mode.frequency_rad_s.unwrap(), known.frequency_rad_s.unwrap());
        assert!((found / known - 1.0).abs() < 1e-6, "{}: {found}, limit {known}", mode.label);
        assert!(mode.shares.torsion == 0.0 && !mode.label.to_string().contains('T'), "{}", mode.label);
    }
}

/// Without offsets the limit is any blade that is stiff and light in torsion.
#[test]
fn coupled_bending_is_the_limit_of_a_blade_that_hardly_twists() {
    let stiff = whole().with(Property::TorsionStiffness, 1e9).with(Property::PolarInertia, 1e-9);
    for speed in [3.0, 30.0] {
        let settings = Settings { speed: Some(speed), ..coupled() };
        let report = solved(&bare(), &settings);
        assert_eq!(report.warnings.iter().map(ToString::to_string).collect::<Vec<_>>(), [TOLD]);
        assert_limit(&report, &solved(&check(&stiff).unwrap(), &settings));
    }
}

/// An offset of the mass centre acts where the rotor is coned, in terms without twist.
#[test]
fn an_offset_acts_with_precone() {
    let ahead = whole().with_precone(0.1).with(Property::MassOffset, 0.05);
    let stiff = ahead.clone().with(Property::TorsionStiffness, 1e9);
    let settings = Settings { rotary: false, ..coupled() };
    let found = solved(&check(&without_torsion(ahead)).unwrap(), &settings);
    assert_limit(&found, &solved(&check(&stiff).unwrap(), &settings));
    let centred = solved(&check(&without_torsion(whole().with_precone(0.1))).unwrap(), &settings);
    let moved = |i: usize| found.modes[i].eigenvalue_s2 / centred.modes[i].eigenvalue_s2 - 1.0;
    assert!((0..4).any(|i| moved(i).abs() > 1e-5), "the offset is not felt");
}

#[test]
fn charts_and_shapes_of_coupled_bending_have_no_torsion() {
    let chart = fan(&bare(), &Settings { modes: 4, coupled_modes: 4, ..coupled() }).unwrap();
    assert_eq!((chart.branches.len(), chart.basis.functions.torsion), (4, None));
    assert!(chart.branches.iter().all(|branch| branch.dof != Dof::Torsion));
    let report = coupled_shapes(&bare(), &coupled()).unwrap();
    for shape in &report.shapes {
        let torsion = &shape.components.torsion;
        assert!(torsion.twist.iter().chain(&torsion.moment).all(|value| *value == 0.0), "{}", shape.label);
    }
}
