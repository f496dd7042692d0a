//! Fan charts: frequencies over a range of rotor speeds.

use super::basis::solve;
use super::coupled_fan::coupled_fan;
use super::fitted::{Fitted, fitted};
use super::model::{turning, uncoupled};
use super::{ModelKind, Settings, frequency, margin, note, note_crossings, note_fewer, warnings};
use crate::blade::Blade;
use crate::fan::meet_rays;
use crate::fault::Faults;
use crate::label::Label;
use crate::numerics::quadrature::GaussRules;
use crate::report::{BasisReport, Branch, Coincidence, Crossing, FanChart, FunctionCounts, Margin, Nominal, Southwell};
use alloc::string::ToString;
use alloc::vec::Vec;

/// Fan chart: branches over a range of speeds, crossings with the nP rays, margins at nominal
/// speed, Southwell coefficients.
///
/// # Errors
/// Faults in the settings, or equations without an answer.
pub fn fan(blade: &Blade, settings: &Settings) -> Result<FanChart, Faults> {
    settings.check()?;
    if settings.model_for(blade) == ModelKind::Coupled {
        return coupled_fan(blade, settings);
    }
    let blade = &*turning(blade, settings)?;
    let rules = GaussRules::new();
    let nominal = blade.nominal_speed();
    let range = settings.speeds_or(nominal);
    let highest = range.to.max(nominal);
    let mut chart = FanChart {
        schema: "bladefan-fan/1",
        blade: blade.name().to_string(),
        blades: blade.blades(),
        harmonics: settings.harmonics,
        basis: BasisReport { family: settings.basis, functions: FunctionCounts::default() },
        speeds_rad_s: range.speeds(),
        branches: Vec::new(),
        crossings: Vec::new(),
        coincident: Vec::new(),
        nominal: Nominal { speed_rad_s: nominal, margins: Vec::new() },
        warnings: warnings(blade),
        model: uncoupled(blade, settings),
        veerings: Vec::new(),
    };
    for dof in settings.dofs_of(blade)? {
        // From rest, where the Southwell coefficients are taken, past nominal speed.
        let squares = (range.from * range.from, range.to * range.to);
        let found = fitted(blade, dof, settings, squares, highest * highest, &rules)?;
        let Fitted { basis, at_rest, curves, .. } = &found;
        let matrices = basis.matrices();
        chart.basis.functions.set(dof, basis.count());
        note_fewer(&mut chart.warnings, dof, at_rest.len(), settings.modes);
        chart.branches.extend(at_rest.iter().enumerate().map(|(index, mode)| Branch {
            label: Label::new(dof, index + 1),
            dof,
            number: index + 1,
            frequency_rad_s: Vec::with_capacity(range.count),
            southwell: Southwell { k0: mode.eigenvalue, k1: mode.southwell },
            labels: Vec::new(),
            lower_rad_s: Vec::new(),
            upper_rad_s: Vec::new(),
        }));
        let first = chart.branches.len() - at_rest.len();
        for speed in &chart.speeds_rad_s {
            let values = found.eigenvalues(speed * speed);
            for (branch, value) in chart.branches[first..].iter_mut().zip(values) {
                branch.frequency_rad_s.push(frequency(value));
            }
        }
        note(&mut chart.warnings, dof, found.error());
        note_crossings(&mut chart.warnings, dof, curves.error());
        let rays = meet_rays(curves, settings.harmonics);
        chart.crossings.extend(rays.crossings.iter().map(|crossing| Crossing {
            label: Label::new(dof, crossing.branch + 1),
            branch: first + crossing.branch,
            harmonic: crossing.harmonic,
            speed_rad_s: crossing.speed,
            frequency_rad_s: crossing.frequency,
        }));
        chart.coincident.extend(rays.coincident.iter().map(|&(branch, harmonic)| Coincidence {
            label: Label::new(dof, branch + 1),
            branch: first + branch,
            harmonic,
        }));
        let at_nominal = solve(matrices, nominal, settings.modes)?;
        chart.nominal.margins.extend(
            at_nominal
                .iter()
                .enumerate()
                .map(|(index, mode)| margin(Label::new(dof, index + 1), mode.frequency / nominal))
                .enumerate()
                .map(|(index, margin)| Margin { branch: Some(first + index), ..margin }),
        );
    }
    Ok(chart)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dof::Dof;
    use crate::lagrange::tests::{cantilever, clamped, free};
    use alloc::string::String;

    /// About the hub a hinged blade flaps once per revolution at every speed and is free in lag.
    #[test]
    fn a_central_hinge_flaps_once_per_revolution() {
        let settings =
            Settings { modes: 2, dofs: alloc::vec![Dof::Lag, Dof::Flap], ..Settings::of(ModelKind::Uncoupled) };
        let chart = fan(&free(0.0), &settings).unwrap();
        let labels: Vec<String> = chart.branches.iter().map(|branch| branch.label.to_string()).collect();
        assert_eq!(labels, ["1F", "2F", "1L", "2L"], "flap before lag, whatever was asked for first");
        let [flap, _, lag, _] = &chart.branches[..] else { panic!("four branches") };
        for ((speed, in_flap), in_lag) in chart.speeds_rad_s.iter().zip(&flap.frequency_rad_s).zip(&lag.frequency_rad_s)
        {
            // ω = √Ω² of a curve that is a straight line.
            assert!((in_flap - speed).abs() < 1e-12 * speed.max(1.0), "{in_flap} at {speed}");
            assert_eq!(*in_lag, 0.0);
        }
        assert_eq!((flap.southwell.k0, lag.southwell.k0, lag.southwell.k1), (0.0, 0.0, 0.0));
        assert!((flap.southwell.k1 - 1.0).abs() < 1e-12, "{}", flap.southwell.k1);
        let lies_on: Vec<_> = chart.coincident.iter().map(|on| (on.label.to_string(), on.harmonic)).collect();
        assert_eq!(lies_on, [("1F".to_string(), 1)]);
        let margin = &chart.nominal.margins[0];
        assert_eq!((margin.label.to_string().as_str(), margin.nearest_harmonic), ("1F", 1));
        assert!(margin.margin_per_rev.abs() < 1e-12, "{}", margin.margin_per_rev);
    }

    /// At rest ω² = EI/m (z/l)⁴; on a crossing ω = nΩ, and the crossing lies on its branch.
    #[test]
    fn a_chart_starts_at_the_cantilever_and_crosses_its_rays() {
        let chart = fan(
            &clamped(0.5),
            &Settings { modes: 3, dofs: alloc::vec![Dof::Flap], ..Settings::of(ModelKind::Uncoupled) },
        )
        .unwrap();
        assert_eq!((chart.speeds_rad_s.len(), chart.speeds_rad_s[0], chart.speeds_rad_s[100]), (101, 0.0, 18.0));
        for (index, branch) in chart.branches.iter().enumerate() {
            let known = cantilever(index, 1.5).sqrt();
            assert!((branch.frequency_rad_s[0] / known - 1.0).abs() < 1e-10, "{}", branch.label);
            assert!(branch.frequency_rad_s.is_sorted(), "{}: pull stiffens", branch.label);
        }
        assert!(!chart.crossings.is_empty());
        for crossing in &chart.crossings {
            let (speed, frequency) = (crossing.speed_rad_s, crossing.frequency_rad_s);
            assert!((frequency / (f64::from(crossing.harmonic) * speed) - 1.0).abs() < 1e-9, "on its ray");
            let branch = chart.branches.iter().find(|branch| branch.label == crossing.label).unwrap();
            let after = chart.speeds_rad_s.partition_point(|s| *s < speed);
            let (below, above) = (branch.frequency_rad_s[after - 1], branch.frequency_rad_s[after]);
            assert!(below <= frequency && frequency <= above, "{} at {speed}", crossing.label);
        }
    }

    #[test]
    fn unsound_settings_are_refused() {
        let faults = fan(&clamped(0.5), &Settings { modes: 0, ..Settings::of(ModelKind::Uncoupled) }).unwrap_err();
        assert_eq!(faults[0].path, "modes");
    }
}
