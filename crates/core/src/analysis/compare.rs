//! Measured points beside the solver's answer at the same rotor speed.

use super::coupled_fan::coupled_at;
use super::fitted::fitted;
use super::model::turning;
use super::{ModelKind, Settings, frequency};
use crate::blade::Blade;
use crate::fault::Faults;
use crate::label::Label;
use crate::numerics::quadrature::GaussRules;
use crate::report::{ComparedPoint, MeasuredPoint};
use crate::units::percent;
use alloc::vec;
use alloc::vec::Vec;

/// Every point with the frequency of its branch at its own rotor speed. Solves each degree of freedom
/// that has points once, over the range of their speeds; [`Settings::speed`] is not looked at.
///
/// # Errors
/// Faults in the settings or in a rotor speed, or equations without an answer.
pub fn compare(blade: &Blade, points: &[MeasuredPoint], settings: &Settings) -> Result<Vec<ComparedPoint>, Faults> {
    settings.check()?;
    for point in points {
        Settings { speed: Some(point.speed_rad_s), ..settings.clone() }.check()?;
    }
    let rules = GaussRules::new();
    let mut computed = vec![None; points.len()];
    let model = settings.model_for(blade);
    if model == ModelKind::Coupled {
        let asked: Vec<(Label, f64)> = points.iter().map(|point| (point.label, point.speed_rad_s)).collect();
        computed = coupled_at(blade, &asked, settings)?;
    }
    let blade = &*turning(blade, settings)?;
    for dof in settings.dofs_of(blade)?.into_iter().filter(|_| model == ModelKind::Uncoupled) {
        let branch = |point: &MeasuredPoint| {
            let Label { dof: own, number, .. } = point.label;
            (own == dof && number <= settings.modes).then(|| number.checked_sub(1))?
        };
        let own: Vec<(usize, usize)> =
            points.iter().enumerate().filter_map(|(index, point)| Some((index, branch(point)?))).collect();
        let squares = own.iter().map(|&(index, _)| points[index].speed_rad_s * points[index].speed_rad_s);
        let (Some(from), Some(to)) = (squares.clone().reduce(f64::min), squares.reduce(f64::max)) else { continue };
        let found = fitted(blade, dof, settings, (from, to), to, &rules)?;
        for (index, branch) in own {
            let speed = points[index].speed_rad_s;
            computed[index] = found.eigenvalues(speed * speed).get(branch).map(|&value| frequency(value));
        }
    }
    let compared = points.iter().zip(computed).map(|(point, computed_rad_s)| {
        let MeasuredPoint { label, speed_rad_s, frequency_rad_s, source } = point.clone();
        // Nothing is so many percent of 0.
        let error = computed_rad_s.filter(|_| frequency_rad_s != 0.0);
        let error_percent = error.and_then(|computed| percent(computed, frequency_rad_s));
        ComparedPoint { label, speed_rad_s, frequency_rad_s, source, computed_rad_s, error_percent }
    });
    Ok(compared.collect())
}

#[cfg(all(test, feature = "library"))]
mod tests {
    use super::*;
    use crate::analysis::modes;
    use crate::dof::Dof;
    use crate::functions::BasisFamily;
    use crate::{formats, library};
    use alloc::string::String;

    fn built_in(name: &str) -> Blade {
        formats::read(library::find(name).unwrap().toml, formats::Format::Toml).unwrap().blade
    }

    fn point(label: &str, speed_rad_s: f64, frequency_rad_s: f64) -> MeasuredPoint {
        MeasuredPoint { label: label.parse().unwrap(), speed_rad_s, frequency_rad_s, source: String::new() }
    }

    fn assert_as_by_modes(blade: &Blade, points: &[MeasuredPoint], settings: &Settings) {
        for compared in compare(blade, points, settings).unwrap() {
            let at = Settings { speed: Some(compared.speed_rad_s), ..settings.clone() };
            let report = modes(blade, &at).unwrap();
            let exact = report.modes.iter().find(|mode| mode.label == compared.label).unwrap().frequency_rad_s;
            let found = compared.computed_rad_s.unwrap();
            assert!(
                (found - exact).abs() <= 1e-9 * exact,
                "{} of {} at {}: {found} {exact}",
                compared.label,
                blade.name(),
                compared.speed_rad_s
            );
            let percent = 100.0 * (found / compared.frequency_rad_s - 1.0);
            assert_eq!(compared.error_percent, Some(percent));
        }
    }

    #[test]
    fn the_frequencies_are_those_of_each_speed_alone() {
        for blade in library::ENTRIES.iter().map(|entry| built_in(entry.name)) {
            let nominal = blade.nominal_speed();
            for basis in [BasisFamily::Piecewise, BasisFamily::Classical] {
                let settings = Settings { basis, ..Settings::of(ModelKind::Uncoupled) };
                let points: Vec<MeasuredPoint> = [0.0, 0.31, 0.77, 1.0, 1.29]
                    .into_iter()
                    .flat_map(|ratio| ["1F", "2L", "3T", "5F"].map(|label| point(label, ratio * nominal, nominal)))
                    .collect();
                assert_as_by_modes(&blade, &points, &settings);
                // A range that leaves out rest, and one speed alone.
                assert_as_by_modes(&blade, &points[4..16], &settings);
                assert_as_by_modes(&blade, &points[9..10], &settings);
            }
        }
    }

    #[test]
    fn what_was_not_asked_for_has_no_answer() {
        let blade = built_in("uniform");
        let settings = Settings { dofs: alloc::vec![Dof::Flap], modes: 2, ..Settings::of(ModelKind::Uncoupled) };
        let points = [point("2F", 3.0, 0.0), point("3F", 3.0, 1.0), point("1T", 3.0, 1.0)];
        let compared = compare(&blade, &points, &settings).unwrap();
        assert!(compared[0].computed_rad_s.is_some() && compared[0].error_percent.is_none());
        assert!(compared[1..].iter().all(|point| point.computed_rad_s.is_none() && point.error_percent.is_none()));
        assert!(compare(&blade, &[], &settings).unwrap().is_empty());
    }

    #[test]
    fn a_speed_that_is_none_is_a_fault() {
        let blade = built_in("uniform");
        for speed in [-1.0, f64::NAN, f64::INFINITY] {
            let faults =
                compare(&blade, &[point("1F", 3.0, 1.0), point("9T", speed, 1.0)], &Settings::of(ModelKind::Uncoupled));
            assert_eq!(faults.unwrap_err()[0].path, "speed");
        }
    }
}
