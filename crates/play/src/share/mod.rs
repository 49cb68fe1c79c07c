//! Links to a document in a given state, and pages embedded in other pages.
//!
//! `state.rs` writes the state as a link, `restoring.rs` reads it, `passing.rs` has what one module of the page leaves to
//! another. `link.rs` names the document of a link. `embedding.rs` has what the address of a page inside another page asks
//! for, and the code of the frame.

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
