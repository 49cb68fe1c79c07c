//! Links: which document, and which state of it.

mod link;
pub(crate) mod restore;
mod state;

pub use link::{LONGEST_PACKED, LONGEST_UNPACKED, Link, Subject, packed_length};
