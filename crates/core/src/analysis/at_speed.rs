//! What a fan chart says at one of its speeds.

use super::margin;
use crate::fan::between;
use crate::label::Label;
use crate::report::{BranchLabel, ModeAtSpeed};
use crate::units::per_rev;
use alloc::vec::Vec;

/// One branch as a chart has it.
#[derive(Clone, Copy, Debug)]
pub struct Curve<'a> {
    /// What it is called.
    pub label: Label,
    /// What it is called from a rotor speed on, ascending; empty where that is the same everywhere.
    pub labels: &'a [BranchLabel],
    /// At the speeds of the chart; not a number where the blade is unstable.
    pub frequencies: &'a [f64],
}

impl Curve<'_> {
    fn label_at(&self, speed: f64) -> Label {
        let named = self.labels.iter().rev().find(|named| named.from_rad_s <= speed).or(self.labels.first());
        named.map_or(self.label, |named| named.label)
    }

    /// Read off between the speeds around it that have a frequency; none where the nearest two have not.
    fn at(&self, speeds: &[f64], speed: f64) -> Option<f64> {
        let count = speeds.len().min(self.frequencies.len());
        let above = speeds[..count.checked_sub(1)?].partition_point(|&each| each <= speed).max(1);
        let is_none = |frequency: &f64| frequency.is_nan();
        let first = self.frequencies[..above].iter().rposition(is_none).map_or(0, |gap| gap + 1);
        let last = self.frequencies[above..count].iter().position(is_none).map_or(count, |gap| above + gap);
        let is_between = first < above && above < last;
        if is_between { between(&speeds[first..last], &self.frequencies[first..last], speed) } else { None }
    }
}

/// The branches of a fan chart at one speed within it, read off between the speeds it has: nothing is
/// solved. Fewer than three speeds tell nothing, and where a branch has no frequency it is left out.
pub fn at_speed<'a>(speeds: &[f64], branches: impl IntoIterator<Item = Curve<'a>>, speed: f64) -> Vec<ModeAtSpeed> {
    let at = |(branch, curve): (usize, Curve)| {
        let (label, frequency_rad_s) = (curve.label_at(speed), curve.at(speeds, speed)?);
        let margin = per_rev(frequency_rad_s, speed).map(|per_rev| margin(label, per_rev));
        Some(ModeAtSpeed {
            label,
            branch,
            frequency_rad_s,
            per_rev: margin.as_ref().map(|margin| margin.per_rev),
            nearest_harmonic: margin.as_ref().map(|margin| margin.nearest_harmonic),
            margin_per_rev: margin.as_ref().map(|margin| margin.margin_per_rev),
        })
    };
    branches.into_iter().enumerate().filter_map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dof::Dof;

    const SPEEDS: [f64; 6] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0];

    #[test]
    fn a_branch_at_a_speed_is_its_frequency_and_its_margin() {
        let label = Label::new(Dof::Flap, 2);
        let curve = Curve { label, labels: &[], frequencies: &[2.6; 6] };
        let found = at_speed(&SPEEDS, [curve], 2.0);
        let ModeAtSpeed { frequency_rad_s, per_rev, nearest_harmonic, margin_per_rev, .. } = found[0];
        assert_eq!((found.len(), found[0].label, frequency_rad_s), (1, label, 2.6));
        assert_eq!((per_rev, nearest_harmonic, margin_per_rev), (Some(1.3), Some(1), Some(1.3 - 1.0)));
        assert_eq!(at_speed(&SPEEDS, [curve], 0.0)[0].nearest_harmonic, None, "at rest");
        assert!(at_speed(&SPEEDS[..2], [curve], 1.0).is_empty(), "too few speeds");
        assert!(at_speed(&[], [curve], 1.0).is_empty());
    }

    #[test]
    fn a_coupled_branch_is_called_by_what_leads_at_the_speed() {
        let [flap, torsion] = [Label::new(Dof::Flap, 3), Label::mixed(Dof::Torsion, 1, Dof::Flap)];
        let labels = [(0.0, flap), (2.5, torsion)].map(|(from_rad_s, label)| BranchLabel { from_rad_s, label });
        let curve = Curve { label: torsion, labels: &labels, frequencies: &[9.0; 6] };
        let called = |speed| at_speed(&SPEEDS, [curve], speed)[0].label;
        assert_eq!([0.0, 2.4, 2.5, 5.0].map(called), [flap, flap, torsion, torsion]);
    }

    #[test]
    fn where_a_branch_is_unstable_it_is_left_out() {
        let gap = f64::NAN;
        let label = Label::new(Dof::Torsion, 1);
        let stable = Curve { label: Label::new(Dof::Flap, 1), labels: &[], frequencies: &[1.0; 6] };
        let places = |frequencies: &[f64], speed| -> Vec<usize> {
            let unstable = Curve { label, labels: &[], frequencies };
            at_speed(&SPEEDS, [unstable, stable], speed).iter().map(|found| found.branch).collect()
        };
        let late = [3.0, 3.0, 3.0, gap, gap, gap];
        assert_eq!(places(&late, 1.5), [0, 1]);
        assert_eq!(places(&late, 2.5), [1], "between a frequency and none");
        assert_eq!(places(&late, 5.0), [1]);
        assert_eq!(places(&[gap, gap, gap, 3.0, 3.0, 3.0], 5.0), [0, 1]);
        assert_eq!(places(&[gap, 3.0, 3.0, gap, 3.0, 3.0], 1.5), [1], "too few");
    }
}
