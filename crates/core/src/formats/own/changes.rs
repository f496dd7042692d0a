//! A list of changes of a blade, as JSON and JavaScript have it: `{what: "distribution.mass",
//! scale: 1.1, from: 2, to: 4}`.

use super::reader::{Reader, Table};
use super::tree::{Node, Tree};
use crate::blade::{Amount, Change, Stretch, What, choice_fault};
use crate::fault::{Fault, FaultCode};
use crate::units::Units;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

/// Keys of a change.
const KEYS: [&str; 8] = ["what", "scale", "set", "add", "from", "to", "units", "mass_alone"];

impl Reader {
    /// Reads a list of changes; `units` are the blade's, which stand in for absent ones.
    pub(super) fn changes(&mut self, tree: &Tree, units: Units) -> Vec<Change> {
        let Node::List(list) = &tree.node else {
            self.wrong_type("changes", tree, "must be a list of changes");
            return Vec::new();
        };
        list.iter().enumerate().filter_map(|(i, tree)| self.change(&format!("changes[{i}]"), tree, units)).collect()
    }

    fn change(&mut self, path: &str, tree: &Tree, units: Units) -> Option<Change> {
        let table = self.table(path, tree, &KEYS)?;
        let what = self.what(&table);
        let amount = self.amount(&table, path);
        let stretch = Stretch { from: self.number(&table, "from"), to: self.number(&table, "to") };
        let units = table.get("units").map(|tree| self.units_at(&table.path("units"), tree, units));
        let mass_alone = self.truth(&table, "mass_alone").unwrap_or(false);
        Some(Change { what: what?, amount: amount?, stretch, units, mass_alone })
    }

    fn what(&mut self, table: &Table) -> Option<What> {
        let path = table.path("what");
        if table.get("what").is_none() {
            let message = "what is changed must be given, like distribution.mass";
            self.push(table.at, Fault::new(FaultCode::Missing, path, None, "must be given", message));
            return None;
        }
        let given = self.text(table, "what")?;
        let found = What::from_path(&given);
        if found.is_none() {
            let known: Vec<String> = What::all().map(What::path).collect();
            let known: Vec<&str> = known.iter().map(String::as_str).collect();
            let given = super::reader::clipped(&given);
            self.push(table.at, choice_fault(FaultCode::UnknownChoice, &path, "what is changed", &given, &known));
        }
        found
    }

    fn amount(&mut self, table: &Table, path: &str) -> Option<Amount> {
        let given = ["scale", "set", "add"].map(|key| self.number(table, key));
        match given {
            [Some(factor), None, None] => Some(Amount::Scale(factor)),
            [None, Some(number), None] => Some(Amount::Set(number)),
            [None, None, Some(number)] => Some(Amount::Add(number)),
            _ => {
                let code = if given == [None; 3] { FaultCode::Missing } else { FaultCode::Conflict };
                let rule = "must have one of scale, set and add";
                self.push(table.at, Fault::new(code, path, None, rule, format!("a change {rule}")));
                None
            }
        }
    }
}
