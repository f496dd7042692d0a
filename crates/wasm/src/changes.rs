//! Changed blades, and charts read off between their speeds: what a page asks again and again.

use crate::curves;
use crate::reply::reply;
use crate::{Answer, read_tree, tree};
use bladefan_core::Faults;
use bladefan_core::formats;
use wasm_bindgen::prelude::*;

/// A blade with changes, one after the other: what-if, sweeps and sensitivities are made of these.
/// The changed blade is not checked; a blade that cannot be read gives the faults of its reading and
/// its check.
#[wasm_bindgen(unchecked_return_type = "Reply<ChangedBlade>")]
pub fn change_blade(
    #[wasm_bindgen(unchecked_param_type = "Blade")] blade: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Change[]")] changes: &JsValue,
) -> Answer {
    let given = read_tree(blade, "blade").and_then(|tree| {
        formats::read_definition(&tree).map_err(|faults| formats::read_tree(&tree).err().unwrap_or(faults))
    });
    // Without a blade the faults of the changes are the same.
    let units = given.as_ref().map(|definition| definition.units).unwrap_or_default();
    let changes = tree::any(changes, "changes").map_err(Faults::from);
    let changes = changes.and_then(|tree| formats::read_changes(&tree, units));
    let changed = Faults::both(given, changes).and_then(|(given, changes)| bladefan_core::change(&given, &changes));
    reply(changed.map(|changed| (changed, Vec::new())))
}

/// The branches of a fan chart, as `fan` gave it, at one rotor speed [rad/s] within it: read off between
/// its speeds, nothing is solved. Empty for a chart of fewer than three speeds; a branch that is unstable
/// there is left out.
#[wasm_bindgen(unchecked_return_type = "Reply<ModeAtSpeed[]>")]
pub fn at_speed(
    #[wasm_bindgen(unchecked_param_type = "FanChart")] chart: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "number")] speed: &JsValue,
) -> Answer {
    let speed = speed.as_f64().filter(|speed| speed.is_finite() && *speed >= 0.0);
    let speed = speed.ok_or_else(|| tree::fault("speed", "must be a number of at least 0").into());
    reply(
        Faults::both(curves::curves(chart), speed)
            .map(|(chart, speed)| (bladefan_core::at_speed(&chart.speeds, chart.branches(), speed), Vec::new())),
    )
}
