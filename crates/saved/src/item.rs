//! A stored item: one JSON object with the version of the format and the time when it was first stored.
//!
//! ```json
//! {"meniscus":3,"since":1763812800000,"item":{"record":{"name":"film.txt","text":"…"}}}
//! ```
//!
//! An item is stored as a single text, so that the storage never holds an incomplete one.

use crate::format::Content;
use handed::answer::{ITEM_VERSION, item};
use serde::Deserialize;

/// Maximum length of the text of an item that is read, in bytes. Written items are shorter: a record of 1 MiB with six
/// bytes per character if all are escaped.
const LONGEST_ITEM: usize = 8 << 20;

/// An item stored for the next visit: a record, a fit, an answer or the work on a film.
#[derive(Clone, Debug, PartialEq)]
pub struct Item(pub Content);

#[derive(Deserialize)]
struct Stored {
    #[serde(rename = "meniscus")]
    version: u32,
    since: u64,
    item: Content,
}

impl Item {
    /// The text to store. `since`: time when the item was first stored, in milliseconds.
    pub fn write(&self, since: u64) -> String {
        let (kind, content) = match &self.0 {
            Content::Record(record) => ("record", serde_json::to_string(record)),
            Content::Fit(fit) => ("fit", serde_json::to_string(fit)),
            Content::Answer(answer) => ("answer", Ok(answer.json())),
            Content::Film(film) => ("film", serde_json::to_string(film)),
        };
        // Texts and numbers can always be serialised.
        item(kind, &content.unwrap_or_default(), since)
    }

    /// Reads a stored text: the time when it was first stored, in milliseconds, and its item. `None` if this version
    /// cannot read the text.
    pub fn read(text: &str) -> Option<(u64, Self)> {
        if text.len() > LONGEST_ITEM {
            return None;
        }
        let stored: Stored = serde_json::from_str(text).ok()?;
        (stored.version == ITEM_VERSION).then_some((stored.since, Self(stored.item)))
    }
}
