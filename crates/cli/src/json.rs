//! Results as JSON: one line, numbers in the shortest form that reads back to the same f64.

use crate::failure::Failure;
use serde::Serialize;

/// The result as one line.
pub(crate) fn line(result: &impl Serialize) -> Result<String, Failure> {
    match serde_json::to_string(result) {
        Ok(mut text) => {
            text.push('\n');
            Ok(text)
        }
        Err(error) => Err(Failure::Output(format!("JSON: cannot be written: {error}"))),
    }
}
