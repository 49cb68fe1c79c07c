//! A document while it is written: its texts as they stand in the editor, what is wrong with them, and whether they are what runs.

mod completion;
mod mark;
mod rewriting;
mod state;
mod versions;

pub use completion::Proposals;
pub use mark::{Mark, TextChange};
pub use state::Writing;
pub use versions::{LineChanges, line_changes, superfluous_versions};
