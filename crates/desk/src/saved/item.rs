//! An item in the storage: one JSON object with the version of the format and the time when it was first stored.
//!
//! ```json
//! {"meniscus":3,"since":1763812800000,"item":{"record":{"name":"film.txt","text":"…"}}}
//! ```
//!
//! The whole item is one text, so that the storage never holds half of it.

use super::earlier;
use super::format::Content;
use serde::{Deserialize, Serialize};

/// The version of the format. Records had a version 1 of their own, fits 1 and 2, answers none: see [`earlier`].
const VERSION: u32 = 3;

/// The longest text of an item that is read, in bytes. What is written is shorter: a record of 1 MiB, six bytes for each
/// character where all of them are escaped.
pub(crate) const LONGEST_ITEM: usize = 8 << 20;

/// Something that is kept for the next visit: a record, a fit or an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Item(pub(super) Content);

#[derive(Serialize, Deserialize)]
struct Stored<C> {
    #[serde(rename = "meniscus")]
    version: u32,
    since: u64,
    item: C,
}

impl Item {
    /// The text that is stored; `since` is when the item was first stored, in milliseconds.
    pub fn write(&self, since: u64) -> String {
        // Texts and numbers only: there is nothing in it that could not be written.
        serde_json::to_string(&Stored { version: VERSION, since, item: &self.0 }).unwrap_or_default()
    }

    /// When the items of a stored text were first stored, and the items: one, or all that an earlier version has kept in one
    /// text. None where this version cannot read them.
    pub fn read(text: &str) -> Option<(u64, Vec<Self>)> {
        if text.len() > LONGEST_ITEM {
            return None;
        }
        if !text.starts_with('{') {
            let (since, items) = earlier::read(text)?;
            return Some((since, items.into_iter().map(Self).collect()));
        }
        let stored: Stored<Content> = serde_json::from_str(text).ok()?;
        (stored.version <= VERSION).then(|| (stored.since, vec![Self(stored.item)]))
    }
}
