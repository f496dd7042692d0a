//! Tables for reading: columns aligned on the decimal point, units in the headers.
//!
//! No table crate we know aligns on the decimal point, and that is most of what there is to do.

use super::text::{spaces, visible};
use anstyle::{Ansi256Color, Style};
use bladefan_core::Dof;
use bladefan_core::figures::significant;
use unicode_width::UnicodeWidthStr;

/// Between two columns.
pub(crate) const GAP: &str = "   ";

/// One cell: text and how it is coloured.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cell {
    text: String,
    style: Style,
}

impl Cell {
    /// A word. What would move a terminal's cursor is written out.
    pub(crate) fn text(text: impl AsRef<str>) -> Self {
        Self { text: visible(text.as_ref()), style: Style::new() }
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
        Self { text: visible(&label.to_string()), style: dof.map(colour).unwrap_or_default() }
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

    /// The lines of the table, each with its line end. What is wider than `width` goes on below with
    /// the first column once more.
    pub(crate) fn render(&self, width: usize) -> String {
        let head = self.headers.iter().map(|(header, _)| header.lines().count()).max().unwrap_or(0);
        let column = |index: usize, header: &str, align: Align| {
            Column::new(header, head, align, self.rows.iter().filter_map(|row| row.get(index)))
        };
        let mut headers = self.headers.iter().enumerate();
        let Some((_, (name, align))) = headers.next() else { return String::new() };
        let first = column(0, name, *align);
        let mut parts: Vec<(usize, Vec<Column>)> = Vec::new();
        for (index, (header, align)) in headers {
            let next = column(index, header, *align);
            let wider = GAP.len() + next.width;
            match parts.last_mut() {
                Some((taken, part)) if *taken + wider <= width => {
                    *taken += wider;
                    part.push(next);
                }
                _ => {
                    let next = column(index, &self.whole_header(index), *align);
                    parts.push((first.width + GAP.len() + next.width, vec![first.clone(), next]));
                }
            }
        }
        let lines = head + self.rows.len();
        let parts: Vec<String> = parts.iter().map(|(_, part)| part_text(part, head, lines)).collect();
        parts.join("\n")
    }

    /// The header of a column that stands first in its part: one that shares the first line of the
    /// column before has it to itself.
    fn whole_header(&self, index: usize) -> String {
        let header = |index: usize| self.headers.get(index).map_or("", |(header, _)| header.as_str());
        let shared = (0..=index).rev().map(header).find(|header| !header.starts_with('\n'));
        match shared.and_then(|shared| shared.lines().next()) {
            Some(line) if header(index).starts_with('\n') => format!("{line}{}", header(index)),
            _ => header(index).into(),
        }
    }
}

/// Columns side by side, without lines above the headers that are in none of them.
fn part_text(part: &[Column], head: usize, lines: usize) -> String {
    let line = |at: usize| {
        let cells: Vec<&str> = part.iter().map(|column| column.lines.get(at).map_or("", String::as_str)).collect();
        format!("{}\n", cells.join(GAP).trim_end())
    };
    (0..lines).map(line).enumerate().skip_while(|(at, line)| *at < head && line == "\n").map(|(_, line)| line).collect()
}

/// A column's lines, padded to one width: `head` of them are the header, the rest the cells.
#[derive(Clone)]
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_on_their_decimal_points() {
        let mut table = Table::new([("mode", Align::Left), ("rad/s", Align::Point)]);
        for (label, value) in [("1F", 72.3), ("2F", 1185.9), ("3F", 0.0)] {
            table.row([Cell::text(label), Cell::number(value, 4)]);
        }
        assert_eq!(table.render(100), "mode     rad/s\n1F       72.30\n2F     1186\n3F        0\n");
    }

    #[test]
    fn a_wide_header_pushes_numbers_to_the_right() {
        let mut table = Table::new([("rotor speed [rad/s]", Align::Point), ("x", Align::Left)]);
        table.row([Cell::number(1.5, 2), Cell::text("a\u{1b}[2J")]);
        assert_eq!(table.render(100), "rotor speed [rad/s]   x\n                1.5   a\\u{1b}[2J\n");
    }

    #[test]
    fn headers_of_several_lines_stand_at_the_bottom() {
        let mut table = Table::new([("mode", Align::Left), ("mass\n[kg]", Align::Point)]);
        table.row([Cell::text("1F"), Cell::fixed(-0.004, 2)]);
        assert_eq!(table.render(100), "       mass\nmode   [kg]\n1F     0.00\n");
    }

    #[test]
    fn wide_tables_go_on_below() {
        let mut table = Table::new((0..40).map(|index| (format!("head{index:02}"), Align::Left)));
        table.row((0..40).map(|index| Cell::text(index.to_string())));
        let text = table.render(100);
        assert!(text.lines().all(|line| line.width() <= 100), "{text}");
        assert_eq!(text.matches("head00").count(), 4, "the first column stands with every part: {text}");
        assert!((0..40).all(|index| text.contains(&format!("head{index:02}"))), "{text}");
    }

    #[test]
    fn what_goes_on_below_has_its_whole_header() {
        let headers =
            [("mode", Align::Left), ("speed\n[rpm]", Align::Point), ("\n[rad/s]", Align::Point), ("of", Align::Left)];
        let mut table = Table::new(headers);
        table.row(["1F", "660", "69", "all"].map(Cell::text));
        assert_eq!(table.render(30), "       speed\nmode   [rpm]   [rad/s]   of\n1F       660        69   all\n");
        let parts = [
            "       speed\nmode   [rpm]\n1F       660\n",
            "         speed\nmode   [rad/s]\n1F          69\n",
            "mode   of\n1F     all\n",
        ];
        assert_eq!(table.render(14), parts.join("\n"));
    }

    #[test]
    fn colour_takes_no_width() {
        let mut table = Table::new([("mode", Align::Left), ("x", Align::Left)]);
        table.row([Cell::label(&"1F", Some(Dof::Flap)), Cell::text("y")]);
        let text = anstream::adapter::strip_str(&table.render(100)).to_string();
        assert_eq!(text, "mode   x\n1F     y\n");
    }
}
