//! A document while it is written: its texts as they stand in the editor, what is wrong with them, and whether they are what runs.

mod mark;
mod rewriting;
mod state;
mod template;
mod vocabulary;

pub use mark::Mark;
pub use state::Writing;
pub use template::{TEMPLATES, Template};
pub use vocabulary::{Word, WordKind};
