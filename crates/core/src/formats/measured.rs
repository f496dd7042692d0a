//! Measured points: frequencies from a test or another program, as CSV.

use super::BYTE_ORDER_MARK;
use super::place::{Placed, in_order};
use crate::blade::shortest;
use crate::fault::{Fault, FaultCode, Faults};
use crate::label::{Label, NotALabel};
use crate::report::MeasuredPoint;
use crate::units::SpeedUnit;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use csv::{ReaderBuilder, StringRecord, Trim};

/// The columns, in the order of [`Columns`].
const COLUMNS: [&str; 4] = ["label", "speed", "frequency", "source"];

/// Where each column of [`COLUMNS`] stands, and the factors of speed and frequency to rad/s.
struct Columns {
    place: [usize; 4],
    speed: f64,
    frequency: f64,
    count: usize,
}

/// Reads measured points: a header row with label, speed, frequency and source in any order, units
/// as in `speed [rpm]` (rad/s where there are none), then one point per row. Lines that begin with
/// `#` are comments.
///
/// # Errors
/// Every fault, with line and column; paths are `header.speed`, `points[0].label` and the like.
pub fn read(text: &str) -> Result<Vec<MeasuredPoint>, Faults> {
    let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
    let mut points = Vec::new();
    let mut faults = Vec::new();
    let mut columns = None;
    let mut row = 0;
    let mut reader = ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(Trim::All)
        .from_reader(text.as_bytes());
    for record in reader.records() {
        // The text is UTF-8 and rows may have any length: nothing else can go wrong.
        let Ok(record) = record else { continue };
        let mut row_faults = Row { text, at: start(&record), faults: &mut faults };
        if let Some(columns) = &columns {
            points.extend(row_faults.point(row, &record, columns));
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
    if faults.is_empty() { Ok(points) } else { Err(in_order(text, &faults).into()) }
}

fn start(record: &StringRecord) -> usize {
    record.position().and_then(|position| position.byte().try_into().ok()).unwrap_or(0)
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

/// The byte at which a field of the row at `at` begins, blanks skipped. A field may be quoted; a
/// quote inside quotes is doubled.
fn field_start(text: &str, at: usize, field: usize) -> usize {
    let Some(row) = text.get(at..) else { return text.len() };
    let (mut commas, mut quoted) = (0, false);
    for (i, c) in row.char_indices() {
        if commas == field && (c == '"' || !c.is_whitespace()) {
            return at + i;
        }
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => commas += 1,
            // A field that the row does not have.
            '\n' if !quoted && i > 0 => return at,
            _ => {}
        }
    }
    at
}
