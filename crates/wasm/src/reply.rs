//! Results as JavaScript objects.

use bladefan_core::fault::{Faults, Warning};
use serde::Serialize;
use serde_wasm_bindgen::Serializer;
use wasm_bindgen::{JsError, JsValue};

/// A result or all faults, told apart by `status`.
#[derive(Debug, Serialize)]
#[serde(tag = "status", rename_all = "lowercase")]
enum Reply {
    Ok {
        #[serde(with = "serde_wasm_bindgen::preserve")]
        value: JsValue,
        warnings: Vec<Warning>,
    },
    Error {
        faults: Faults,
    },
}

/// The tagged object of a result.
///
/// # Errors
/// Only by a mistake of ours: a result that cannot be written as an object.
pub(crate) fn reply<T: Serialize>(result: Result<(T, Vec<Warning>), Faults>) -> Result<JsValue, JsError> {
    object(&match result {
        Ok((value, warnings)) => Reply::Ok { value: object(&value)?, warnings },
        Err(faults) => Reply::Error { faults },
    })
}

/// As JSON would have it: objects, not maps; null, not undefined.
fn object(value: &impl Serialize) -> Result<JsValue, JsError> {
    value.serialize(&Serializer::json_compatible()).map_err(JsError::from)
}
