//! What stands above a table: which blade at what speed, what the functions and the model are.

use super::text::wrap;
use bladefan_core::BasisFamily;
use bladefan_core::figures::short;
use bladefan_core::report::BasisReport;
use bladefan_core::units;
use unicode_width::UnicodeWidthStr;

/// The lines above every table, an empty one last.
pub(crate) fn heading(blade: &str, what: &str, basis: &str, model: &str, width: usize) -> String {
    let together = format!("{basis}; {model}");
    let model = if together.width() <= width { vec![together] } else { vec![String::from(basis), String::from(model)] };
    let lines = core::iter::once(format!("{blade}, {what}")).chain(model);
    let lines: String = lines.map(|line| wrap(&line, 0, width) + "\n").collect();
    lines + "\n"
}

/// A rotor speed.
pub(crate) fn speed(speed: f64) -> String {
    format!("{} rad/s ({} rpm)", short(speed, 4), short(units::rpm(speed), 4))
}

/// The assumed functions.
pub(crate) fn basis(report: &BasisReport) -> String {
    let known = report.functions.known();
    // The user chose one number of classical functions for all.
    if let (BasisFamily::Classical, Some((_, count))) = (report.family, known.clone().next()) {
        return format!("classical, {count} functions");
    }
    let each = known.map(|(dof, count)| format!("{dof} {count}"));
    let words: Vec<String> = core::iter::once(format!("{} functions", report.family.name())).chain(each).collect();
    words.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use bladefan_core::Dof;
    use bladefan_core::report::FunctionCounts;

    #[test]
    fn functions_and_model_share_a_line_where_there_is_room() {
        let model = "uncoupled, in vacuum, zero pitch, with words";
        assert_eq!(heading("a", "b", "c", model, 100), format!("a, b\nc; {model}\n\n"));
        assert_eq!(heading("a", "b", "c", model, model.width() + 2), format!("a, b\nc\n{model}\n\n"));
        let narrow = heading("a", "b", "c", model, 30);
        assert!(narrow.lines().all(|line| line.width() <= 30), "{narrow}");
    }

    #[test]
    fn names_cannot_forge_lines() {
        assert!(heading("a\u{1b}[1A\nb", "c", "d", "e", 100).starts_with("a\\u{1b}[1A b, c\n"), "one line");
    }

    #[test]
    fn speeds_are_in_two_units() {
        assert_eq!(speed(69.115_038), "69.12 rad/s (660 rpm)");
        assert_eq!(speed(0.0), "0 rad/s (0 rpm)");
    }

    #[test]
    fn only_functions_asked_for_are_counted() {
        let mut report = BasisReport { family: BasisFamily::Piecewise, functions: FunctionCounts::default() };
        report.functions.set(Dof::Lag, 7);
        report.functions.set(Dof::Torsion, 8);
        assert_eq!(basis(&report), "piecewise functions, lag 7, torsion 8");
        report.family = BasisFamily::Classical;
        assert_eq!(basis(&report), "classical, 7 functions");
    }
}
