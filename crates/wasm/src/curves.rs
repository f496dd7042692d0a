//! A fan chart that comes back from JavaScript, to be read at one speed.

use crate::tree;
use bladefan_core::formats::{Node, Tree};
use bladefan_core::report::BranchLabel;
use bladefan_core::{Curve, Label};
use bladefan_core::{Fault, FaultCode, Faults};
use wasm_bindgen::JsValue;

/// What of a fan chart is needed to read it off.
#[derive(Debug)]
pub(crate) struct Curves {
    pub(crate) speeds: Vec<f64>,
    branches: Vec<Branch>,
}

#[derive(Debug)]
struct Branch {
    label: Label,
    labels: Vec<BranchLabel>,
    frequencies: Vec<f64>,
}

impl Curves {
    pub(crate) fn branches(&self) -> impl Iterator<Item = Curve<'_>> {
        self.branches.iter().map(|Branch { label, labels, frequencies }| Curve { label: *label, labels, frequencies })
    }
}

/// Reads the speeds and the branches of a fan chart, as `fan` gave it.
pub(crate) fn curves(chart: &JsValue) -> Result<Curves, Faults> {
    let chart = tree::tree(chart, "chart")?;
    let speeds = numbers(chart.get("speeds_rad_s"), "chart.speeds_rad_s")?;
    let branches = list(chart.get("branches"), "chart.branches", "branches")?;
    let branches = branches.iter().enumerate().map(|(i, tree)| branch(tree, &format!("chart.branches[{i}]")));
    let branches = branches.collect::<Result<_, Fault>>()?;
    Ok(Curves { speeds, branches })
}

fn branch(tree: &Tree, path: &str) -> Result<Branch, Fault> {
    let label = label(tree, path)?;
    let labels = match tree.get("labels") {
        None => Vec::new(),
        given => {
            let path = format!("{path}.labels");
            let each = |(i, tree)| named(tree, &format!("{path}[{i}]"));
            list(given, &path, "labels")?.iter().enumerate().map(each).collect::<Result<_, Fault>>()?
        }
    };
    let frequencies = numbers(tree.get("frequency_rad_s"), &format!("{path}.frequency_rad_s"))?;
    Ok(Branch { label, labels, frequencies })
}

/// What a branch is called from a rotor speed on.
fn named(tree: &Tree, path: &str) -> Result<BranchLabel, Fault> {
    let Some(&Node::Number(from_rad_s)) = tree.get("from_rad_s").map(|tree| &tree.node) else {
        return Err(tree::fault(&format!("{path}.from_rad_s"), "must be a number"));
    };
    Ok(BranchLabel { from_rad_s, label: label(tree, path)? })
}

fn label(tree: &Tree, path: &str) -> Result<Label, Fault> {
    let path = format!("{path}.label");
    let Some(Node::Text(text)) = tree.get("label").map(|tree| &tree.node) else {
        return Err(tree::fault(&path, "must be text"));
    };
    text.parse::<Label>().map_err(|error| {
        let message = error.to_string();
        Fault::new(FaultCode::UnknownChoice, path, Some(text.clone()), message.as_str(), message.as_str())
    })
}

fn list<'a>(tree: Option<&'a Tree>, path: &str, of: &str) -> Result<&'a [Tree], Fault> {
    match tree.map(|tree| &tree.node) {
        Some(Node::List(items)) => Ok(items),
        _ => Err(tree::fault(path, &format!("must be a list of {of}"))),
    }
}

fn numbers(tree: Option<&Tree>, path: &str) -> Result<Vec<f64>, Fault> {
    let number = |tree: &Tree| if let Node::Number(value) = tree.node { Some(value) } else { None };
    let values: Option<Vec<f64>> = list(tree, path, "numbers")?.iter().map(number).collect();
    values.ok_or_else(|| tree::fault(path, "must be a list of numbers"))
}
