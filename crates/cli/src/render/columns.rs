//! Columns and rows that several tables share.

use super::table::{Align, Cell};
use bladefan_core::report::Margin;

/// Headers of a mode at one rotor speed.
pub(crate) const MODE_COLUMNS: [(&str, Align); 4] =
    [("mode", Align::Left), ("rad/s", Align::Point), ("Hz", Align::Point), ("/rev", Align::Point)];

/// Headers of what [`margin_cells`] fills.
pub(crate) const MARGIN_COLUMNS: [(&str, Align); 2] = [("nearest", Align::Left), ("margin\n[/rev]", Align::Point)];

/// A header beside ones that are made up.
pub(crate) fn own((name, align): (&str, Align)) -> (String, Align) {
    (name.into(), align)
}

/// The nearest harmonic and the margin to it; there is none at rest.
pub(crate) fn margin_cells(margin: Option<&Margin>) -> [Cell; 2] {
    match margin {
        Some(margin) => [Cell::text(format!("{}P", margin.nearest_harmonic)), Cell::signed(margin.margin_per_rev, 3)],
        None => [Cell::text("-"), Cell::text("-")],
    }
}

/// Indices of at most `most` of `len` rows: first and last, evenly spaced where that is possible.
pub(crate) fn pick(len: usize, most: usize) -> Vec<usize> {
    let last = len.saturating_sub(1);
    let steps = last.min(most.saturating_sub(1)).max(1);
    let even = (steps / 2 + 1..=steps).rev().find(|steps| last.is_multiple_of(*steps));
    let steps = even.unwrap_or(steps);
    let mut picked: Vec<usize> = (0..=steps).map(|step| (step * last + steps / 2) / steps).collect();
    picked.dedup();
    picked
}

#[cfg(test)]
mod tests {
    use super::super::table::Table;
    use super::*;
    use bladefan_core::{Dof, Label};

    #[test]
    fn picked_rows_are_evenly_spaced_where_possible() {
        assert_eq!(pick(101, 7), [0, 20, 40, 60, 80, 100]);
        assert_eq!(pick(101, 11), [0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100]);
        assert_eq!(pick(2, 7), [0, 1]);
        assert_eq!(pick(1, 7), [0]);
        assert_eq!(pick(12, 7), [0, 2, 4, 6, 7, 9, 11], "eleven steps have no even split into four to six");
    }

    #[test]
    fn margins_have_signs_and_there_is_none_at_rest() {
        let margin = Margin {
            label: Label::new(Dof::Flap, 2),
            branch: None,
            per_rev: 2.689,
            nearest_harmonic: 3,
            margin_per_rev: -0.311,
        };
        let mut table = Table::new(MARGIN_COLUMNS);
        table.row(margin_cells(Some(&margin)));
        table.row(margin_cells(None));
        assert_eq!(table.render(100), "          margin\nnearest   [/rev]\n3P        -0.311\n-          -\n");
    }
}
