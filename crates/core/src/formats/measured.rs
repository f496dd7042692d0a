//! Measured points: frequencies from a test or another program, as CSV.

use super::BYTE_ORDER_MARK;
use super::place::{Placed, in_order};
use crate::fault::{Fault, FaultCode, Faults};
use crate::figures::shortest;
use crate::label::{Label, NotALabel};
use crate::report::MeasuredPoint;
use crate::units::SpeedUnit;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use csv::{ReaderBuilder, StringRecord, Trim};

/// The columns, in the order of [`Columns`].
const COLUMNS: [&str; 4] = ["label", "speed", "frequency", "source"];

/// The mark at the beginning of a line that is a comment.
const COMMENT: u8 = b'#';

/// Most points: as many as a fan chart may have rotor speeds.
const MOST: usize = 100_000;

/// Where each column of [`COLUMNS`] stands, and the factors of speed and frequency to rad/s.
struct Columns {
    place: [usize; 4],
    speed: f64,
    frequency: f64,
    count: usize,
}

/// Reads measured points: a header row with label, speed, frequency and source in any order, units
/// as in `speed [rpm]` (rad/s where there are none), then one point per row, at most 100 000. Lines
/// that begin with `#` are comments.
///
/// # Errors
/// Every fault, with line and column; paths are `header.speed`, `points[0].label` and the like.
pub fn read(text: &str) -> Result<Vec<MeasuredPoint>, Faults> {
    let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
    let mut points = Vec::new();
    let mut faults = Vec::new();
    let mut columns = None;
    let mut row = 0;
    let mut beyond = None;
    let mut reader = ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(COMMENT))
        .trim(Trim::All)
        .from_reader(text.as_bytes());
    for record in reader.records() {
        // The text is UTF-8 and rows may have any length: nothing else can go wrong.
        let Ok(record) = record else { continue };
        let at = start(text, &record);
        if at == text.len() {
            // A comment at the end, without a line end: the library makes an empty row of it.
            continue;
        }
        let mut row_faults = Row { text, at, faults: &mut faults };
        if let Some(columns) = &columns {
            if row < MOST {
                points.extend(row_faults.point(row, &record, columns));
            } else {
                beyond.get_or_insert(at);
            }
            row += 1;
        } else {
            match row_faults.header(&record) {
                Some(found) => columns = Some(found),
                // Without columns no row can be read.
                None => break,
            }
        }
    }
    if columns.is_none() && faults.is_empty() {
        let message = "must have a header row: label, speed, frequency, source";
        let fault = Fault::new(FaultCode::Missing, "header", None, message, message);
        faults.push(Placed { at: Some(0), fault });
    }
    if beyond.is_some() {
        let rule = format!("must be at most {MOST}");
        let fault =
            Fault::new(FaultCode::Length, "points", Some(row.to_string()), &rule, format!("{rule} (are {row})"));
        faults.push(Placed { at: beyond, fault });
    }
    if faults.is_empty() { Ok(points) } else { Err(in_order(text, &faults).into()) }
}

/// The byte at which a row begins. What the library says is where the row before ended: empty lines
/// and comments may still stand between the two.
fn start(text: &str, record: &StringRecord) -> usize {
    let mut at = record.position().and_then(|position| position.byte().try_into().ok()).unwrap_or(0);
    loop {
        match text.as_bytes().get(at..) {
            Some([b'\n' | b'\r', ..]) => at += 1,
            Some(rest @ [COMMENT, ..]) => at += rest.split(|byte| *byte == b'\n').next().map_or(0, <[u8]>::len),
            _ => return at,
        }
    }
}

/// One row of the text.
struct Row<'t, 'f> {
    text: &'t str,
    at: usize,
    faults: &'f mut Vec<Placed>,
}

impl Row<'_, '_> {
    fn refuse(&mut self, field: usize, code: FaultCode, path: String, value: Option<&str>, message: &str) {
        let value = value.map(ToString::to_string);
        let is = value.as_ref().map(|value| format!(" (is \"{}\")", value.escape_debug())).unwrap_or_default();
        let fault = Fault::new(code, path, value, message, format!("{message}{is}"));
        self.faults.push(Placed { at: Some(field_start(self.text, self.at, field)), fault });
    }

    fn header(&mut self, record: &StringRecord) -> Option<Columns> {
        let before = self.faults.len();
        let mut place = [None; 4];
        let mut factors = [1.0; 4];
        for (field, title) in record.iter().enumerate() {
            let (name, unit) = match title.split_once('[') {
                Some((name, rest)) => (name.trim(), Some(rest.strip_suffix(']').unwrap_or(rest).trim())),
                None => (title, None),
            };
            let Some(column) = COLUMNS.iter().position(|known| known.eq_ignore_ascii_case(name)) else {
                let path = format!("header[{field}]");
                let rule = "column must be label, speed, frequency or source";
                self.refuse(field, FaultCode::UnknownKey, path, Some(title), rule);
                continue;
            };
            let path = format!("header.{}", COLUMNS[column]);
            if place[column].is_some() {
                self.refuse(field, FaultCode::Conflict, path, Some(title), "column must stand only once");
                continue;
            }
            place[column] = Some(field);
            match (column, unit) {
                (_, None) => {}
                (1 | 2, Some(unit)) => match SpeedUnit::from_name(unit) {
                    Some(unit) => factors[column] = unit.si(),
                    None => {
                        self.refuse(field, FaultCode::UnknownUnit, path, Some(unit), "unit must be rad/s, rpm or Hz");
                    }
                },
                (_, Some(unit)) => {
                    self.refuse(field, FaultCode::Conflict, path, Some(unit), "this column has no unit");
                }
            }
        }
        for (column, name) in place.iter().zip(COLUMNS) {
            if column.is_none() {
                let message = format!("column {name} must be given");
                self.refuse(0, FaultCode::Missing, format!("header.{name}"), None, &message);
            }
        }
        let [label, speed, frequency, source] = place;
        let place = [label?, speed?, frequency?, source?];
        (self.faults.len() == before).then_some(Columns {
            place,
            speed: factors[1],
            frequency: factors[2],
            count: record.len(),
        })
    }

    fn point(&mut self, row: usize, record: &StringRecord, columns: &Columns) -> Option<MeasuredPoint> {
        let path = |name: &str| format!("points[{row}].{name}");
        if record.len() != columns.count {
            let message = format!("must have {} fields like the header (has {})", columns.count, record.len());
            self.refuse(0, FaultCode::Length, format!("points[{row}]"), None, &message);
            return None;
        }
        let [label, speed, frequency, source] = columns.place;
        let text = |field: usize| record.get(field).unwrap_or_default();
        let found = text(label).parse::<Label>();
        if found.is_err() {
            let rule = format!("label {}", NotALabel::RULE);
            self.refuse(label, FaultCode::UnknownChoice, path("label"), Some(text(label)), &rule);
        }
        let speed_rad_s = self.number(speed, path("speed"), text(speed), columns.speed);
        let frequency_rad_s = self.number(frequency, path("frequency"), text(frequency), columns.frequency);
        Some(MeasuredPoint {
            label: found.ok()?,
            speed_rad_s: speed_rad_s?,
            frequency_rad_s: frequency_rad_s?,
            source: text(source).to_string(),
        })
    }

    fn number(&mut self, field: usize, path: String, text: &str, factor: f64) -> Option<f64> {
        let Ok(value) = text.parse::<f64>() else {
            self.refuse(field, FaultCode::WrongType, path, Some(text), "must be a number");
            return None;
        };
        let si = value * factor;
        if !si.is_finite() {
            self.refuse(field, FaultCode::NotFinite, path, Some(text), "must be finite");
        } else if si < 0.0 {
            self.refuse(field, FaultCode::OutOfRange, path, Some(&shortest(value)), "must be at least 0");
        } else {
            return Some(si);
        }
        None
    }
}

/// The byte at which a field of the row at `at` begins, blanks skipped; the row's beginning for a
/// field that it does not have. A field that begins with a quote ends with one, and a quote inside is
/// doubled; elsewhere a quote is a letter like any other.
fn field_start(text: &str, at: usize, field: usize) -> usize {
    let row = text.get(at..).unwrap_or_default();
    let (mut commas, mut quoted, mut may_open) = (0, false, true);
    for (i, c) in row.char_indices() {
        let ends = matches!(c, '\n' | '\r') && !quoted;
        if commas == field && (ends || !c.is_whitespace()) {
            return at + i;
        }
        match c {
            _ if ends => return at,
            '"' if quoted => (quoted, may_open) = (false, true),
            '"' if may_open => quoted = true,
            ',' if !quoted => (commas, may_open) = (commas + 1, true),
            _ => may_open = false,
        }
    }
    if commas == field { text.len() } else { at }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "label,speed,frequency,source\n";

    /// Places and paths of the faults.
    fn faults(text: &str) -> Vec<String> {
        let faults = read(text).unwrap_err();
        let place = |fault: &Fault| format!("{}:{} {}", fault.line.unwrap(), fault.column.unwrap(), fault.path);
        faults.iter().map(place).collect()
    }

    #[test]
    fn comments_and_empty_lines_do_not_move_faults() {
        let text = format!("# a\n#b, \"c\n{HEADER}\n# d\n\r\n# e\n1F,x,2,me\n# f\n1F,1,y,me\n");
        assert_eq!(faults(&text), ["8:4 points[0].speed", "10:6 points[1].frequency"]);
        assert_eq!(faults("# a\n\n  label, pace,frequency,source\n"), ["3:3 header.speed", "3:10 header[1]"]);
        let text = format!("# a\r\n{HEADER}# b\r\n1F,1,2\r\n# c");
        assert_eq!(faults(&text), ["4:1 points[0]"]);
    }

    #[test]
    fn quotes_part_fields_only_where_they_begin_one() {
        let header = "source,label,speed,frequency\n";
        for source in ["5\" pipe", "\"a, \"\"b\"\"\"", "\"a\"b\"", " \"a\""] {
            let row = format!("{source},1F,1,x\n");
            let column = row.find('x').unwrap() + 1;
            assert_eq!(faults(&format!("{header}{row}")), [format!("2:{column} points[0].frequency")], "{source}");
        }
        let text = format!("{header}\"two\nlines\",1F,1,x\n");
        assert_eq!(faults(&text), ["3:13 points[0].frequency"], "a line end inside quotes");
    }

    #[test]
    fn a_field_without_a_letter_has_a_place() {
        assert_eq!(faults("label,speed,frequency,source,\n"), ["1:30 header[4]"]);
        assert_eq!(faults("label,speed,frequency,source, "), ["1:31 header[4]"]);
    }

    #[test]
    fn points_are_limited_in_number() {
        let rows = |count: usize| format!("{HEADER}# the points\n{}", "1F,1,2,me\n".repeat(count));
        assert_eq!(read(&rows(MOST)).unwrap().len(), MOST);
        let refused = read(&rows(MOST + 2)).unwrap_err();
        let texts: Vec<String> = refused.iter().map(ToString::to_string).collect();
        assert_eq!(texts, ["100003:1: points: must be at most 100000 (are 100002)"]);
        assert_eq!(refused[0].value.as_deref(), Some("100002"), "the value");
    }
}
