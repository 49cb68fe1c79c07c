//! The list of facts of a hand-in.

use saved::Number;
use saved::hand_in::{Fact, FactValue, Part};
use std::collections::BTreeMap;

/// Facts in the order in which they are made.
#[derive(Default)]
pub(super) struct Facts {
    facts: Vec<Fact>,
    /// Number of items of a part with this name.
    named: BTreeMap<(Part, String), usize>,
}

impl Facts {
    /// Name of an item in the facts: items of the same name are numbered from the second one on.
    pub fn item(&mut self, part: Part, name: String) -> String {
        let count = self.named.entry((part, name.clone())).or_default();
        *count += 1;
        if *count == 1 { name } else { format!("{name} ({count})") }
    }

    /// The facts.
    pub fn into_list(self) -> Vec<Fact> {
        self.facts
    }

    /// Adds the facts that the simulation states about itself.
    pub fn take(&mut self, stated: Vec<Fact>) {
        self.facts.extend(stated);
    }

    pub fn number(&mut self, part: Part, item: &str, quantity: impl Into<String>, value: f64) {
        self.add(part, item, quantity.into(), FactValue::Number(Number(value)));
    }

    pub fn text(&mut self, part: Part, item: &str, quantity: &str, value: impl Into<String>) {
        self.add(part, item, quantity.to_owned(), FactValue::Text(value.into()));
    }

    pub fn add(&mut self, part: Part, item: &str, quantity: String, value: FactValue) {
        self.facts.push(Fact { part, item: item.to_owned(), quantity, value });
    }
}
