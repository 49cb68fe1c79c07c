//! Links: which document, and which state of it; and pages inside other pages.

mod embedding;
mod link;
pub(crate) mod restore;
mod state;

pub use embedding::{Embedding, PagePart};
pub use link::{LONGEST_PACKED, LONGEST_UNPACKED, Link, Subject, packed_length};
