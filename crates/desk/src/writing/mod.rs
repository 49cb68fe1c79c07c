//! Editing of a document: the texts in the editor, their findings, and whether they are the running ones.
//!
//! `Desk::write` checks a change; texts with no more errors than those that run take their place (`Play::replace_program`),
//! and what is measured follows. Otherwise the last good version runs on. `versions.rs` says which earlier versions stay,
//! thinned with age, and counts changed lines.

mod completion;
mod mark;
mod sketching;
mod state;
mod versions;

pub use completion::{Insight, Proposals, insight, propose};
pub use mark::{Mark, TextChange, text_changes};
pub use sketching::DrawingPlaces;
pub(crate) use sketching::Sketching;
pub use state::Writing;
pub use versions::{LineChanges, line_changes, superfluous_versions};
