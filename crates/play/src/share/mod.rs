//! Links to a document in a given state, and pages embedded in other pages.

mod embedding;
pub(crate) mod link;
mod missing;
mod passing;
pub(crate) mod restoring;
pub(crate) mod state;

pub use embedding::{Embedding, PagePart};
pub use link::{LONGEST_PACKED, LONGEST_UNPACKED, Link, Subject, packed_length};
pub use missing::missing_in_link;
pub use passing::Passed;
pub use state::Extent;
