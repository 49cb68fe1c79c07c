//! The text of a document: its lines, its blocks, and their places.

pub(crate) mod block;
pub(crate) mod fences;
pub(crate) mod findings;
pub(crate) mod grammar;
pub(crate) mod outline;
pub(crate) mod source;
