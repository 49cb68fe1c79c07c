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
use saved::hand_in::Sender;
use serde::{Deserialize, Serialize};
use serde_json::value::{RawValue, to_raw_value};
use std::collections::BTreeMap;

/// Kind of events with a part of a hand-in.
pub const PART: &str = "part";

/// Beginning of the name of a part with an item.
const ITEM: &str = "item:";
/// Names of the other parts.
const PARTS: [&str; 5] = ["head", "documents", "state", "order", "facts"];
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
        PARTS.contains(&name.as_str()) || (name.starts_with(ITEM) && name.len() <= LONGEST_NAME)
    }
}

/// Parts of one hand-in, each with the number of its event and the time of its arrival.
#[derive(Clone, Debug, Default)]
struct Parts(BTreeMap<String, (u64, u64, Box<RawValue>)>);

/// Latest parts of the hand-ins of a seat, by document.
#[derive(Clone, Debug, Default)]
pub struct Folded(BTreeMap<String, Parts>);

#[derive(Deserialize, Default)]
#[serde(default)]
struct Head {
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

#[derive(Serialize)]
struct Work<'a> {
    #[serde(rename = "meniscus project")]
    version: u32,
    documents: &'a RawValue,
    state: &'a RawValue,
    items: Vec<&'a RawValue>,
}

#[derive(Serialize)]
struct HandIn<'a> {
    #[serde(rename = "meniscus hand-in")]
    version: u32,
    program: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    bits: Option<u32>,
    made: u64,
    sender: Sender,
    work: Work<'a>,
    facts: &'a RawValue,
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
        let head: Head = serde_json::from_str(parts.value("head")?.get()).ok()?;
        let order: Vec<String> = serde_json::from_str(parts.value("order")?.get()).ok()?;
        let made = parts.0.values().map(|(_, at, _)| *at).max().unwrap_or(0);
        let items: Option<Vec<&RawValue>> = order.iter().map(|name| parts.value(&format!("{ITEM}{name}"))).collect();
        let none = to_raw_value(&[(); 0]).ok()?;
        let hand_in = HandIn {
            version: head.format.unwrap_or(1),
            program: head.program,
            bits: head.bits,
            made,
            sender: Sender { name: pseudonym.to_owned(), ..head.sender },
            work: Work {
                version: 1,
                documents: parts.value("documents")?,
                state: parts.value("state")?,
                items: items?,
            },
            facts: parts.value("facts").unwrap_or(&none),
        };
        serde_json::to_string(&hand_in).ok()
    }

    /// The items of a document: their names, and texts as `saved::Item` reads them.
    pub fn items<'a>(&'a self, document: &str) -> impl Iterator<Item = (&'a str, String)> {
        let item = |value: &RawValue| Some(serde_json::from_str::<Named>(value.get()).ok()?.item.get().to_owned());
        let parts = self.0.get(document).into_iter().flat_map(|parts| &parts.0);
        parts.filter_map(move |(name, (.., value))| Some((name.strip_prefix(ITEM)?, item(value)?)))
    }
}

impl Parts {
    fn value(&self, name: &str) -> Option<&RawValue> {
        self.0.get(name).map(|(.., value)| &**value)
    }
}

/// Sender of a hand-in: the pseudonym, and of several documents also its document, since of each sender one hand-in counts.
pub fn sender(pseudonym: &str, document: &str, documents: usize) -> String {
    if documents > 1 { format!("{pseudonym} ({document})") } else { pseudonym.to_owned() }
}
