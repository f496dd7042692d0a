//! Results as JSON: one line, numbers in the shortest form that reads back to the same f64.

use crate::failure::Failure;
use core::fmt::Write as _;
use serde::Serialize;

/// The result as one line.
pub(crate) fn line(result: &impl Serialize) -> Result<String, Failure> {
    match serde_json::to_string(result) {
        Ok(mut text) => {
            text.push('\n');
            Ok(escaped(text))
        }
        Err(error) => Err(Failure::Output(format!("JSON: cannot be written: {error}"))),
    }
}

/// The same JSON with every control character as `\u009b`: the library leaves U+007F to U+009F as
/// they are, and terminals obey them. Outside strings JSON has none.
fn escaped(json: String) -> String {
    let left = |letter: char| ('\u{7f}'..='\u{9f}').contains(&letter);
    if !json.contains(left) {
        return json;
    }
    let mut out = String::with_capacity(json.len());
    for letter in json.chars() {
        if left(letter) {
            // Writing to a string does not fail.
            let _ = write!(out, "\\u{:04x}", u32::from(letter));
        } else {
            out.push(letter);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_character_of_a_name_is_there() {
        let name = "a\u{1b}Pb\u{7f}c\u{9b}d\n\"é旋\\";
        let json = line(&[name]).unwrap();
        assert_eq!(json, "[\"a\\u001bPb\\u007fc\\u009bd\\n\\\"é旋\\\\\"]\n");
        assert_eq!(serde_json::from_str::<[String; 1]>(&json).unwrap(), [name]);
    }

    #[test]
    fn numbers_are_the_shortest_that_read_back() {
        assert_eq!(line(&[0.1, 1e20, 1.0 / 3.0, -0.0]).unwrap(), "[0.1,1e+20,0.3333333333333333,-0.0]\n");
    }
}
