//! Hand-ins as a fold over the events of a seat.
//!
//! A part of a hand-in is an event of kind [`PART`] with the body
//!
//! ```json
//! {"document":"tube.md","part":"item:fit 1","value":{"name":"fit 1","item":{}}}
//! ```
//!
//! | part | value |
//! |---|---|
//! | `head` | version of the format and of the program, number of its bits, time, seat and assignment |
//! | `documents` | the files of the document |
//! | `state` | the state of the run, as in a link |
//! | `order` | names of the items in their order; other items were removed |
//! | `item:NAME` | an item |
//! | `facts` | the values that follow from the work |
//!
//! Of each part the event with the highest number counts, so that events may arrive in any order and several times. Values are
//! copied byte for byte: their numbers keep their bits.

use crate::store::EventRow;
use handed::parts::{self, Head, ITEM, NAMES, Sender};
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use std::collections::BTreeMap;

/// Kind of events with a part of a hand-in.
pub const PART: &str = "part";

/// Maximum length of the name of a part, in bytes.
const LONGEST_NAME: usize = 1000;

/// Body of an event with a part.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Part {
    /// File name of the document.
    pub document: String,
    /// Name of the part.
    pub part: String,
    /// Its value.
    pub value: Box<RawValue>,
}

impl Part {
    /// True if there is a part of this name.
    pub fn is_known(&self) -> bool {
        let name = &self.part;
        NAMES.contains(&name.as_str()) || (name.starts_with(ITEM) && name.len() <= LONGEST_NAME)
    }
}

/// Parts of one hand-in, each with the number of its event and the time of its arrival.
#[derive(Clone, Debug, Default)]
struct Parts(BTreeMap<String, (u64, u64, Box<RawValue>)>);

/// Latest parts of the hand-ins of a seat, by document.
#[derive(Clone, Debug, Default)]
pub struct Folded(BTreeMap<String, Parts>);

/// Value of the part `head`.
#[derive(Deserialize, Default)]
#[serde(default)]
struct Stated {
    /// Version of the format of hand-ins; without it the first.
    format: Option<u32>,
    program: String,
    bits: Option<u32>,
    sender: Sender,
}

/// Value of a part with an item.
#[derive(Deserialize)]
struct Named {
    item: Box<RawValue>,
}

impl Folded {
    /// Adds an event; one of another kind adds nothing.
    pub fn add(&mut self, event: &EventRow) {
        if event.kind != PART {
            return;
        }
        let Ok(part) = serde_json::from_str::<Part>(&event.body) else { return };
        let parts = &mut self.0.entry(part.document).or_default().0;
        if parts.get(&part.part).is_none_or(|(seq, ..)| *seq < event.seq) {
            parts.insert(part.part, (event.seq, event.at, part.value));
        }
    }

    /// The fold over these events.
    pub fn of<'a>(events: impl IntoIterator<Item = &'a EventRow>) -> Self {
        let mut folded = Self::default();
        events.into_iter().for_each(|event| folded.add(event));
        folded
    }

    /// Names of the documents with work.
    pub fn documents(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }

    /// The hand-in of a document, as a text in the format of `saved::hand_in`; its sender has this pseudonym, and the
    /// time at which it was made is that of the latest arrival by the server's clock. `None` while its
    /// documents, its state or its items are missing.
    pub fn hand_in(&self, document: &str, pseudonym: &str) -> Option<String> {
        let parts = self.0.get(document)?;
        let stated: Stated = serde_json::from_str(parts.value("head")?).ok()?;
        let order: Vec<String> = serde_json::from_str(parts.value("order")?).ok()?;
        let made = parts.0.values().map(|(_, at, _)| *at).max().unwrap_or(0);
        let item = |name: String| {
            let item = parts.value(&format!("{ITEM}{name}"))?;
            Some((name, item.into()))
        };
        let head = Head {
            version: stated.format.unwrap_or(1),
            program: stated.program,
            bits: stated.bits,
            made,
            sender: Sender { name: pseudonym.to_owned(), ..stated.sender },
        };
        let hand_in = parts::Parts {
            head,
            documents: parts.value("documents")?.into(),
            state: parts.value("state")?.into(),
            items: order.into_iter().map(item).collect::<Option<_>>()?,
            facts: parts.value("facts").unwrap_or("[]").into(),
        };
        Some(hand_in.text())
    }

    /// The items of a document: their names, and texts as `saved::Item` reads them.
    pub fn items<'a>(&'a self, document: &str) -> impl Iterator<Item = (&'a str, String)> {
        let item = |value: &RawValue| Some(serde_json::from_str::<Named>(value.get()).ok()?.item.get().to_owned());
        let parts = self.0.get(document).into_iter().flat_map(|parts| &parts.0);
        parts.filter_map(move |(name, (.., value))| Some((name.strip_prefix(ITEM)?, item(value)?)))
    }
}

impl Parts {
    fn value(&self, name: &str) -> Option<&str> {
        self.0.get(name).map(|(.., value)| value.get())
    }
}

/// Sender of a hand-in: the pseudonym, and of several documents also its document, since of each sender one hand-in counts.
pub fn sender(pseudonym: &str, document: &str, documents: usize) -> String {
    if documents > 1 { format!("{pseudonym} ({document})") } else { pseudonym.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use saved::hand_in::{Fact, FactValue, HandIn, Part as Of};
    use saved::project::Project;

    /// A hand-in that is sent in parts, in any order and with parts that are replaced later, comes out as its own writer would write it.
    #[test]
    fn the_parts_of_a_hand_in_make_the_same_file() {
        let value = FactValue::Number(saved::Number(0.1 + 0.2));
        let fact = Fact { part: Of::Run, item: "a".to_owned(), quantity: "value:x".to_owned(), value };
        let item = |name: &str| (name.to_owned(), "{\"meniscus\":3,\"x\":[1.10,-0.0]}".to_owned());
        let work =
            Project { state: "1&p=b:2".to_owned(), items: vec![item("q \"1\""), item("r")], ..Project::default() };
        let sender = Sender { name: "blue heron".to_owned(), seat: Some(7), assignment: "tube".to_owned() };
        let made = HandIn::new(5, sender, work, vec![fact]);
        let event = |seq: u64, (part, value): (String, String)| EventRow {
            number: seq,
            seat: 7,
            seq,
            at: 5,
            kind: PART.to_owned(),
            body: format!("{{\"document\":\"a.md\",\"part\":{},\"value\":{value}}}", serde_json::json!(part)),
        };
        let mut events: Vec<EventRow> = (2..).zip(made.parts().named()).map(|(seq, part)| event(seq, part)).collect();
        assert!(events.iter().all(|one| serde_json::from_str::<Part>(&one.body).is_ok_and(|part| part.is_known())));
        events.push(event(1, ("state".to_owned(), "\"outdated\"".to_owned())));
        events.reverse();
        assert_eq!(Folded::of(&events).hand_in("a.md", "blue heron"), Some(made.write()));
    }
}
