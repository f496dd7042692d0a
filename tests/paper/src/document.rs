//! Generated parts of a Markdown document, between `<!-- generated: NAME -->` and `<!-- end -->`.

use alloc::collections::BTreeMap;

const BEGIN: &str = "<!-- generated: ";
const END: &str = "<!-- end -->";

/// The document with every generated part as `parts` says.
///
/// # Errors
/// A part without an end, one that is not among `parts`, or one of `parts` that the document does not show.
pub(super) fn replace(document: &str, parts: &BTreeMap<String, String>) -> Result<String, String> {
    let mut shown = Vec::new();
    let mut pieces = document.split(BEGIN);
    let mut text = pieces.next().unwrap_or_default().to_string();
    for piece in pieces {
        let (name, rest) = piece.split_once(" -->").ok_or("a generated part without a name")?;
        let (_, after) = rest.split_once(END).ok_or_else(|| format!("part {name} has no end"))?;
        let part = parts.get(name).ok_or_else(|| format!("no part is called {name}"))?;
        text += &format!("{BEGIN}{name} -->\n{}\n{END}{after}", part.trim_end());
        shown.push(name);
    }
    match parts.keys().find(|name| !shown.contains(&name.as_str())) {
        Some(name) => Err(format!("part {name} is not shown")),
        None => Ok(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_replaced_and_missing_ones_are_named() {
        let parts = |names: &[&str]| names.iter().map(|&name| (name.into(), format!("new {name}\n"))).collect();
        let text = "a\n<!-- generated: x -->\nold\n<!-- end -->\nb\n";
        let replaced = replace(text, &parts(&["x"])).unwrap();
        assert_eq!(replaced, "a\n<!-- generated: x -->\nnew x\n<!-- end -->\nb\n");
        assert_eq!(replace(&replaced, &parts(&["x"])).unwrap(), replaced);
        assert_eq!(replace(text, &parts(&[])).unwrap_err(), "no part is called x");
        assert_eq!(replace(text, &parts(&["x", "y"])).unwrap_err(), "part y is not shown");
        assert_eq!(replace("<!-- generated: x -->", &parts(&["x"])).unwrap_err(), "part x has no end");
    }
}
