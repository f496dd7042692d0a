//! Tables for reading: columns aligned on the decimal point, units in the headers.
//!
//! No table crate we know aligns on the decimal point, and that is most of what there is to do.

use anstyle::{Ansi256Color, Style};
use bladefan_core::dof::Dof;
use core::fmt::Write as _;
use unicode_width::UnicodeWidthStr;

/// Most columns of a terminal that a table takes.
pub(crate) const WIDTH: usize = 100;
/// Between two columns.
const GAP: &str = "   ";

/// One cell: text and how it is coloured.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cell {
    text: String,
    style: Style,
}

impl Cell {
    /// A word. What would move a terminal's cursor is shown as `?`.
    pub(crate) fn text(text: impl AsRef<str>) -> Self {
        Self { text: plain(text.as_ref()), style: Style::new() }
    }

    /// A number of so many significant figures.
    pub(crate) fn number(value: f64, figures: usize) -> Self {
        Self { text: significant(value, figures), style: Style::new() }
    }

    /// A number, or `-` where there is none.
    pub(crate) fn maybe(value: Option<f64>, figures: usize) -> Self {
        value.map_or_else(|| Self::text("-"), |value| Self::number(value, figures))
    }

    /// A number with a fixed number of decimals.
    pub(crate) fn fixed(value: f64, decimals: usize) -> Self {
        let text = format!("{value:.decimals$}");
        // What rounds to zero has no sign.
        let zero = text.chars().all(|letter| matches!(letter, '-' | '.' | '0'));
        Self { text: if zero { text.replace('-', "") } else { text }, style: Style::new() }
    }

    /// The same with its sign.
    pub(crate) fn signed(value: f64, decimals: usize) -> Self {
        Self { text: format!("{value:+.decimals$}"), style: Style::new() }
    }

    /// A mode's label in the colour of its degree of freedom, as in the charts.
    pub(crate) fn label(label: &impl ToString, dof: Option<Dof>) -> Self {
        Self { text: plain(&label.to_string()), style: dof.map(colour).unwrap_or_default() }
    }
}

/// Nearly the colours of the charts: blue flap, vermilion lag, green torsion.
fn colour(dof: Dof) -> Style {
    let colour = match dof {
        Dof::Flap => Ansi256Color(32),
        Dof::Lag => Ansi256Color(166),
        Dof::Torsion => Ansi256Color(36),
    };
    Style::new().fg_color(Some(colour.into()))
}

/// How a column stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Align {
    /// Words.
    Left,
    /// Numbers, by their decimal point.
    Point,
}

/// A table: headers, which may have several lines, then rows.
#[derive(Clone, Debug)]
pub(crate) struct Table {
    headers: Vec<(String, Align)>,
    rows: Vec<Vec<Cell>>,
}

impl Table {
    pub(crate) fn new(headers: impl IntoIterator<Item = (impl Into<String>, Align)>) -> Self {
        Self { headers: headers.into_iter().map(|(text, align)| (text.into(), align)).collect(), rows: Vec::new() }
    }

    pub(crate) fn row(&mut self, cells: impl IntoIterator<Item = Cell>) {
        self.rows.push(cells.into_iter().collect());
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The lines of the table, each with its line end. What is wider than a terminal goes on below
    /// under the first column once more.
    pub(crate) fn render(&self) -> String {
        let head = self.headers.iter().map(|(header, _)| header.lines().count()).max().unwrap_or(0);
        let column = |(index, (header, align)): (usize, &(String, Align))| {
            Column::new(header, head, *align, self.rows.iter().filter_map(move |row| row.get(index)))
        };
        let columns: Vec<Column> = self.headers.iter().enumerate().map(column).collect();
        let Some((first, rest)) = columns.split_first() else { return String::new() };
        let mut parts: Vec<(usize, Vec<&Column>)> = Vec::new();
        for column in rest {
            let wider = GAP.len() + column.width;
            match parts.last_mut() {
                Some((width, part)) if *width + wider <= WIDTH => {
                    *width += wider;
                    part.push(column);
                }
                _ => parts.push((first.width + wider, vec![first, column])),
            }
        }
        let line = |part: &[&Column], line: usize| {
            let cells: Vec<&str> =
                part.iter().map(|column| column.lines.get(line).map_or("", String::as_str)).collect();
            format!("{}\n", cells.join(GAP).trim_end())
        };
        let lines = head + self.rows.len();
        let parts: Vec<String> =
            parts.iter().map(|(_, part)| (0..lines).map(|at| line(part, at)).collect::<String>()).collect();
        parts.join("\n")
    }
}

/// A column's lines, padded to one width: `head` of them are the header, the rest the cells.
struct Column {
    width: usize,
    lines: Vec<String>,
}

impl Column {
    fn new<'a>(header: &str, head: usize, align: Align, cells: impl Iterator<Item = &'a Cell> + Clone) -> Self {
        let before = |text: &str| if align == Align::Point { point(text).0 } else { 0 };
        let after = |text: &str| if align == Align::Point { point(text).1 } else { text.width() };
        let most_before = cells.clone().map(|cell| before(&cell.text)).max().unwrap_or(0);
        let most_after = cells.clone().map(|cell| after(&cell.text)).max().unwrap_or(0);
        let width = header.lines().map(str::width).max().unwrap_or(0).max(most_before + most_after);
        // Numbers stand at the right end under a wide header, words at the left.
        let lead = if align == Align::Point { width - most_before - most_after } else { 0 };
        let above = core::iter::repeat_n("", head - header.lines().count().min(head));
        let headers = above.chain(header.lines()).map(|line| match align {
            Align::Left => format!("{line}{}", spaces(width - line.width())),
            Align::Point => format!("{}{line}", spaces(width - line.width())),
        });
        let lines = cells.map(|cell| {
            let left = lead + most_before - before(&cell.text);
            let right = width - left - cell.text.width();
            format!("{}{}{}{:#}{}", spaces(left), cell.style, cell.text, cell.style, spaces(right))
        });
        Self { width, lines: headers.chain(lines).collect() }
    }
}

/// Widths before and from the decimal point of a number; a unit stands after it.
fn point(text: &str) -> (usize, usize) {
    let at = text.find(['.', 'e', ' ', '%']).unwrap_or(text.len());
    (text[..at].width(), text[at..].width())
}

fn spaces(count: usize) -> String {
    " ".repeat(count)
}

/// Text without control characters, which could change what a terminal shows.
pub(crate) fn plain(text: &str) -> String {
    text.chars().map(|letter| if letter.is_control() { '?' } else { letter }).collect()
}

/// Decimals that show so many significant figures of `largest`.
pub(crate) fn decimals(largest: f64, figures: usize) -> usize {
    let exponent = exponent(largest, figures).unwrap_or(0);
    let decimals = i32::try_from(figures).unwrap_or(0).saturating_sub(1).saturating_sub(exponent);
    usize::try_from(decimals.max(0)).unwrap_or(0)
}

/// Decimal exponent after rounding: 9.9999 to four figures is 10.00.
fn exponent(value: f64, figures: usize) -> Option<i32> {
    let decimals = figures.saturating_sub(1);
    format!("{value:.decimals$e}").split_once('e')?.1.parse().ok()
}

/// `value` to so many significant figures; without exponent where that stays readable.
pub(crate) fn significant(value: f64, figures: usize) -> String {
    match exponent(value, figures) {
        _ if value == 0.0 => "0".into(),
        Some(-4..=6) => format!("{value:.*}", decimals(value, figures)),
        _ => format!("{value:.*e}", figures.saturating_sub(1)),
    }
}

/// `value` to at most so many significant figures, without zeros at the end: for running text.
pub(crate) fn short(value: f64, figures: usize) -> String {
    let text = significant(value, figures);
    let number = text.contains('.') && !text.contains('e');
    if number { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

/// `text` in lines of at most `width` columns, broken between words, each but the first indented.
pub(crate) fn wrap(text: &str, indent: usize, width: usize) -> String {
    let mut out = String::new();
    let mut column = indent;
    for word in text.split_whitespace() {
        let word = plain(word);
        if column > indent && column + 1 + word.width() > width {
            let _ = write!(out, "\n{}", spaces(indent));
            column = indent;
        } else if column > indent {
            out.push(' ');
            column += 1;
        }
        column += word.width();
        out.push_str(&word);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn significant_figures_are_counted_after_rounding() {
        let cases = [
            (0.0, "0"),
            (9.99999, "10.000"),
            (72.3, "72.300"),
            (-0.312_345_67, "-0.31235"),
            (0.000_123_456, "0.00012346"),
            (1_234_567.0, "1234567"),
            (12_345_678.0, "1.2346e7"),
            (1.0e-13, "1.0000e-13"),
        ];
        for (value, text) in cases {
            assert_eq!(significant(value, 5), text, "{value}");
        }
        assert_eq!(significant(f64::NAN, 5), "NaN", "a number that is none must stay visible");
    }

    #[test]
    fn numbers_stand_on_their_decimal_points() {
        let mut table = Table::new([("mode", Align::Left), ("rad/s", Align::Point)]);
        for (label, value) in [("1F", 72.3), ("2F", 1185.9), ("3F", 0.0)] {
            table.row([Cell::text(label), Cell::number(value, 4)]);
        }
        assert_eq!(table.render(), "mode     rad/s\n1F       72.30\n2F     1186\n3F        0\n");
    }

    #[test]
    fn a_wide_header_pushes_numbers_to_the_right() {
        let mut table = Table::new([("rotor speed [rad/s]", Align::Point), ("x", Align::Left)]);
        table.row([Cell::number(1.5, 2), Cell::text("a\u{1b}[2J")]);
        assert_eq!(table.render(), "rotor speed [rad/s]   x\n                1.5   a?[2J\n");
    }

    #[test]
    fn headers_of_several_lines_stand_at_the_bottom() {
        let mut table = Table::new([("mode", Align::Left), ("mass\n[kg]", Align::Point)]);
        table.row([Cell::text("1F"), Cell::fixed(-0.004, 2)]);
        assert_eq!(table.render(), "       mass\nmode   [kg]\n1F     0.00\n");
    }

    #[test]
    fn wide_tables_go_on_below() {
        let mut table = Table::new((0..40).map(|index| (format!("head{index:02}"), Align::Left)));
        table.row((0..40).map(|index| Cell::text(index.to_string())));
        let text = table.render();
        assert!(text.lines().all(|line| line.width() <= WIDTH), "{text}");
        assert_eq!(text.matches("head00").count(), 4, "the first column stands with every part: {text}");
        assert!((0..40).all(|index| text.contains(&format!("head{index:02}"))), "{text}");
    }

    #[test]
    fn running_text_has_no_idle_zeros() {
        for (value, text) in [(660.0, "660"), (0.25, "0.25"), (69.115_038, "69.12"), (1.0e9, "1.000e9"), (0.0, "0")] {
            assert_eq!(short(value, 4), text);
        }
    }

    #[test]
    fn colour_takes_no_width() {
        let mut table = Table::new([("mode", Align::Left), ("x", Align::Left)]);
        table.row([Cell::label(&"1F", Some(Dof::Flap)), Cell::text("y")]);
        let text = anstream::adapter::strip_str(&table.render()).to_string();
        assert_eq!(text, "mode   x\n1F     y\n");
    }

    #[test]
    fn text_wraps_between_words() {
        assert_eq!(wrap("one two three", 2, 9), "one two\n  three");
    }
}
