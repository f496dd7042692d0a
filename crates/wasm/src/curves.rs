//! A fan chart that comes back from JavaScript, to be read at one speed.

use crate::tree;
use bladefan_core::Label;
use bladefan_core::formats::{Node, Tree};
use bladefan_core::{Fault, FaultCode, Faults};
use wasm_bindgen::JsValue;

/// What of a fan chart is needed to read it off.
#[derive(Debug)]
pub(crate) struct Curves {
    pub(crate) speeds: Vec<f64>,
    pub(crate) branches: Vec<(Label, Vec<f64>)>,
}

/// Reads the speeds and the branches of a fan chart, as `fan` gave it.
pub(crate) fn curves(chart: &JsValue) -> Result<Curves, Faults> {
    let chart = tree::tree(chart, "chart")?;
    let speeds = numbers(chart.get("speeds_rad_s"), "chart.speeds_rad_s")?;
    let Some(Node::List(branches)) = chart.get("branches").map(|tree| &tree.node) else {
        return Err(tree::fault("chart.branches", "must be a list of branches").into());
    };
    let branch = |(i, branch): (usize, &Tree)| {
        let path = format!("chart.branches[{i}]");
        let label = match branch.get("label").map(|tree| &tree.node) {
            Some(Node::Text(text)) => text.parse::<Label>().map_err(|error| {
                let message = error.to_string();
                Fault::new(
                    FaultCode::UnknownChoice,
                    format!("{path}.label"),
                    Some(text.clone()),
                    message.as_str(),
                    message.as_str(),
                )
            })?,
            _ => return Err(tree::fault(&format!("{path}.label"), "must be text")),
        };
        Ok((label, numbers(branch.get("frequency_rad_s"), &format!("{path}.frequency_rad_s"))?))
    };
    let branches = branches.iter().enumerate().map(branch).collect::<Result<_, Fault>>()?;
    Ok(Curves { speeds, branches })
}

fn numbers(tree: Option<&Tree>, path: &str) -> Result<Vec<f64>, Fault> {
    let wrong = || tree::fault(path, "must be a list of numbers");
    let Some(Node::List(values)) = tree.map(|tree| &tree.node) else { return Err(wrong()) };
    let number = |tree: &Tree| if let Node::Number(value) = tree.node { Some(value) } else { None };
    values.iter().map(number).collect::<Option<_>>().ok_or_else(wrong)
}
