//! The parts of a hand-in, and the file that they make. A class server stores the parts one by one.

use crate::fact::Fact;
use crate::json::{self, Object};
use serde::Deserialize;
use std::borrow::Cow;

/// Version of the format of hand-ins.
pub const HAND_IN_VERSION: u32 = 2;

/// Version of the format of projects.
pub const PROJECT_VERSION: u32 = 1;

/// Beginning of the name of a part with an item.
pub const ITEM: &str = "item:";

/// Names of the other parts.
pub const NAMES: [&str; 5] = ["documents", "state", "order", "facts", "head"];

/// The student or the group that hands in.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(default)]
pub struct Sender {
    /// Pseudonym or name of the group.
    pub name: String,
    /// Seat, from 1; `None` if no values were assigned.
    pub seat: Option<u32>,
    /// Identifier of the assignment; empty if there is none.
    pub assignment: String,
}

/// Head of a hand-in: its version, program, time and sender.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Head {
    /// Version of its format.
    pub version: u32,
    /// Version of the program that made it.
    pub program: String,
    /// Number of the bits of that program's results; `None` if it stated none.
    pub bits: Option<u32>,
    /// Time at which it was made, in milliseconds since 1970.
    pub made: u64,
    /// The student or the group.
    pub sender: Sender,
}

/// A hand-in, cut into texts in JSON.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Parts<'a> {
    /// Its head.
    pub head: Head,
    /// Document and translations.
    pub documents: Cow<'a, str>,
    /// State of the run, in the form of a link.
    pub state: Cow<'a, str>,
    /// Names of items, and the items with their names.
    pub items: Vec<(String, Cow<'a, str>)>,
    /// Values that follow from the work.
    pub facts: Cow<'a, str>,
}

/// Files of a document in JSON: names and texts.
pub fn documents<'a>(files: impl IntoIterator<Item = (&'a str, &'a str)>) -> String {
    let file = |(name, text)| Object::default().with("name", json::text(name)).with("text", json::text(text)).end();
    json::list(files.into_iter().map(file))
}

/// An item of a project with its name. `item`: text of the item.
pub fn named_item(name: &str, item: &str) -> String {
    Object::default().with("name", json::text(name)).with("item", item).end()
}

/// Facts in JSON.
pub fn facts(facts: &[Fact]) -> String {
    json::list(facts.iter().map(Fact::json))
}

/// A project in JSON, of texts in JSON.
pub fn project<T: AsRef<str>>(documents: &str, state: &str, items: impl IntoIterator<Item = T>) -> String {
    Object::default()
        .with("meniscus project", PROJECT_VERSION.to_string())
        .with("documents", documents)
        .with("state", state)
        .with("items", json::list(items))
        .end()
}

impl Sender {
    fn json(&self) -> String {
        Object::default()
            .with("name", json::text(&self.name))
            .with_some("seat", self.seat.map(|seat| seat.to_string()))
            .with_some("assignment", (!self.assignment.is_empty()).then(|| json::text(&self.assignment)))
            .end()
    }
}

impl Head {
    /// Its members behind the version, of which the name is `version`.
    fn object(&self, version: &str) -> Object {
        Object::default()
            .with(version, self.version.to_string())
            .with("program", json::text(&self.program))
            .with_some("bits", self.bits.map(|bits| bits.to_string()))
            .with("made", self.made.to_string())
            .with("sender", self.sender.json())
    }
}

impl Parts<'_> {
    /// Content of the file.
    pub fn text(&self) -> String {
        let work = project(&self.documents, &self.state, self.items.iter().map(|(_, item)| item));
        self.head.object("meniscus hand-in").with("work", work).with("facts", &self.facts).end()
    }

    /// The parts with their names, as a class server takes them.
    pub fn named(&self) -> Vec<(String, String)> {
        let items = self.items.iter().map(|(name, item)| (format!("{ITEM}{name}"), item.to_string()));
        let order = json::list(self.items.iter().map(|(name, _)| json::text(name)));
        let own = [("order", order), ("facts", self.facts.to_string()), ("head", self.head.object("format").end())];
        let documents = [("documents", self.documents.to_string()), ("state", self.state.to_string())];
        let owned = |(name, value): (&str, String)| (name.to_owned(), value);
        documents.into_iter().map(owned).chain(items).chain(own.into_iter().map(owned)).collect()
    }
}
