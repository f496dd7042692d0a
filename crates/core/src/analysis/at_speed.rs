//! What a fan chart says at one of its speeds.

use super::margin;
use crate::fan::between;
use crate::label::Label;
use crate::report::ModeAtSpeed;
use crate::units::per_rev;
use alloc::vec::Vec;

/// The branches of a fan chart at one speed within it, read off between the speeds it has: nothing is
/// solved. `branches` are labels with frequencies at the `speeds`; fewer than three tell nothing.
pub fn at_speed<'a>(
    speeds: &[f64],
    branches: impl IntoIterator<Item = (Label, &'a [f64])>,
    speed: f64,
) -> Vec<ModeAtSpeed> {
    let at = |(label, frequencies): (Label, &[f64])| {
        let frequency_rad_s = between(speeds, frequencies, speed)?;
        let margin = per_rev(frequency_rad_s, speed).map(|per_rev| margin(label, per_rev));
        Some(ModeAtSpeed {
            label,
            frequency_rad_s,
            per_rev: margin.as_ref().map(|margin| margin.per_rev),
            nearest_harmonic: margin.as_ref().map(|margin| margin.nearest_harmonic),
            margin_per_rev: margin.as_ref().map(|margin| margin.margin_per_rev),
        })
    };
    branches.into_iter().filter_map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dof::Dof;

    #[test]
    fn a_branch_at_a_speed_is_its_frequency_and_its_margin() {
        let speeds = [0.0, 1.0, 2.0, 3.0];
        let label = Label::new(Dof::Flap, 2);
        let found = at_speed(&speeds, [(label, &[2.6; 4][..])], 2.0);
        let ModeAtSpeed { frequency_rad_s, per_rev, nearest_harmonic, margin_per_rev, .. } = found[0];
        assert_eq!((found.len(), found[0].label, frequency_rad_s), (1, label, 2.6));
        assert_eq!((per_rev, nearest_harmonic, margin_per_rev), (Some(1.3), Some(1), Some(1.3 - 1.0)));
        assert_eq!(at_speed(&speeds, [(label, &[2.6; 4][..])], 0.0)[0].nearest_harmonic, None, "at rest");
        assert!(at_speed(&speeds[..2], [(label, &[2.6; 2][..])], 1.0).is_empty(), "too few speeds");
    }
}
