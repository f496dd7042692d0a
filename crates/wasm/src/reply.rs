//! Results as JavaScript objects.

use bladefan_core::{Faults, Warning};
use serde::Serialize;
use serde_wasm_bindgen::Serializer;
use wasm_bindgen::{JsError, JsValue};

/// A result or all faults, told apart by `status`.
#[derive(Debug, Serialize)]
#[serde(tag = "status", rename_all = "lowercase")]
enum Reply<T> {
    Ok { value: T, warnings: Vec<Warning> },
    Error { faults: Faults },
}

/// The tagged object of a result, as JSON would have it: objects, not maps; null, not undefined.
///
/// # Errors
/// Only by a mistake of ours: a result that cannot be written as an object.
pub(crate) fn reply<T: Serialize>(result: Result<(T, Vec<Warning>), Faults>) -> Result<JsValue, JsError> {
    let reply = match result {
        Ok((value, warnings)) => Reply::Ok { value, warnings },
        Err(faults) => Reply::Error { faults },
    };
    reply.serialize(&Serializer::json_compatible()).map_err(JsError::from)
}
