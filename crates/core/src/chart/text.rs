//! Text without a font: widths from a table, shortening, wrapping, numbers, escaping.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// Fonts of one set of widths (Helvetica's) wherever there is one, so that the table below holds.
pub(super) const FAMILY: &str = "Helvetica Neue, Helvetica, Arial, Liberation Sans, Arimo, sans-serif";

/// Widths of U+0020 … U+007E in 1/1000 of the text size (Adobe's font metrics of Helvetica).
#[rustfmt::skip]
const WIDTHS: [u16; 95] = [
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,
    556, 556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,
    1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,
    667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,
    333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,
    556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584,
];

/// Room for fonts wider than the table's, and for bold.
const REGULAR: f64 = 1.06;
const BOLD: f64 = 1.14;

/// Width [px] that is enough for `text` at `size`.
pub(super) fn width(text: &str, size: f64, bold: bool) -> f64 {
    let units: u32 = text.chars().map(|c| u32::from(char_width(c))).sum();
    f64::from(units) / 1000.0 * size * if bold { BOLD } else { REGULAR }
}

fn char_width(c: char) -> u16 {
    let code = c as usize;
    match WIDTHS.get(code.wrapping_sub(0x20)) {
        Some(&width) => width,
        None if c == '·' => 333,
        // Scripts and pictures of full width start at Hangul.
        None if code >= 0x1100 => 1000,
        None => 660,
    }
}

/// `text` as it may stand in a drawing: no characters that XML forbids, none that control or
/// reorder text, one space for any run of white space.
pub(super) fn clean(text: &str) -> String {
    let shown = |c: &char| {
        !(c.is_control()
            || matches!(*c, '\u{200B}'..='\u{200F}' | '\u{2028}'..='\u{202E}' | '\u{2060}'..='\u{206F}')
            || matches!(*c, '\u{FEFF}' | '\u{FFF9}'..='\u{FFFF}' | '\u{E0000}'..='\u{E0FFF}')
            || (*c as u32) & 0xFFFE == 0xFFFE)
    };
    let spaced: String = text.chars().map(|c| if c.is_whitespace() { ' ' } else { c }).filter(shown).collect();
    spaced.split(' ').filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
}

/// `text`, or as much of it as fits in `room` with an ellipsis.
pub(super) fn shorten(text: &str, room: f64, size: f64, bold: bool) -> String {
    if width(text, size, bold) <= room {
        return text.to_string();
    }
    let room = room - width("…", size, bold);
    let mut kept = String::new();
    for c in text.chars() {
        kept.push(c);
        if width(&kept, size, bold) > room {
            kept.pop();
            break;
        }
    }
    format!("{}…", kept.trim_end())
}

/// Room from which on lines are broken [px].
const BROKEN: f64 = 340.0;

/// `parts` joined by middle dots into as few lines as `room` allows; a part too long for one is broken after commas,
/// but in drawings so narrow that the chart itself needs the height.
pub(super) fn flow(parts: &[String], room: f64, size: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for part in parts {
        if let Some(line) = lines.last_mut() {
            let joined = format!("{line} · {part}");
            if width(&joined, size, false) <= room {
                *line = joined;
                continue;
            }
        }
        let mut rest = String::new();
        for phrase in part.split_inclusive(", ") {
            if room > BROKEN && !rest.is_empty() && width(&format!("{rest}{}", phrase.trim_end()), size, false) > room {
                lines.push(shorten(rest.trim_end(), room, size, false));
                rest.clear();
            }
            rest.push_str(phrase);
        }
        lines.push(shorten(&rest, room, size, false));
    }
    lines
}

/// `text` for an XML attribute or element.
pub(super) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '&' => escaped.push_str("&amp;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&apos;"),
            other => escaped.push(other),
        }
    }
    escaped
}

/// Mantissa (1 ≤ |m| < 10) and decimal exponent; none for 0 and what is not finite.
pub(super) fn scientific(value: f64) -> Option<(f64, i32)> {
    if value == 0.0 || !value.is_finite() {
        return None;
    }
    let text = format!("{value:e}");
    let (mantissa, exponent) = text.split_once('e')?;
    Some((mantissa.parse().ok()?, exponent.parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hostile_names_lose_control_characters_and_markup() {
        assert_eq!(clean("a\u{0}b\u{202E}c\n\td\u{FFFF}"), "abc d");
        assert_eq!(escape("<b a='x'>&\""), "&lt;b a=&apos;x&apos;&gt;&amp;&quot;");
    }

    #[test]
    fn long_names_end_in_an_ellipsis_and_fit() {
        let name = "blade ".repeat(60);
        let short = shorten(&name, 200.0, 17.0, true);
        assert!(short.ends_with('…'), "{short}");
        assert!(width(&short, 17.0, true) <= 200.0, "{short}");
        assert_eq!(shorten("TM 4760", 200.0, 17.0, true), "TM 4760");
    }
}
