//! Links to a document in a given state, and pages embedded in other pages.

mod embedding;
pub(crate) mod link;

pub use embedding::{Embedding, PagePart};
pub use link::{LONGEST_PACKED, LONGEST_UNPACKED, Link, Subject, packed_length};
