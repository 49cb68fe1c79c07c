//! The simulation document: one Markdown file with prose, equations, scene, plots, presets, questions and checks, and further
//! files that translate it.
//!
//! [`read`] gives the structure of a text, even with errors. [`open()`] also checks it and gives a program if the model has
//! no errors. Neither fails: errors are [`model::Diagnostic`]s with their places. [`edit`] changes a text by its structure,
//! [`format()`] its layout.

pub mod assist;
mod blocks;
mod card;
mod checks;
mod document;
pub mod drawing;
pub mod edit;
mod expressions;
mod extent;
pub mod form;
mod format;
mod hidden;
mod open;
mod outcomes;
pub mod page;
mod prose;
mod resized;
mod scene;
mod search;
mod settable;
mod template;
mod text;
pub mod translating;

pub use blocks::asked::{Asked, QuestionPart, asked, possible_answers};
pub use blocks::front_matter::{Entry, FrontMatter, Value, translates};
pub use blocks::sweeps::Limits;
pub use card::{Card, card};
pub use document::{Document, Opened};
pub use format::{Formatted, format};
pub use open::{Opening, open};
pub use outcomes::{outcomes, parameter_range};
pub use resized::resized;
pub use search::Searchable;
pub use template::{TEMPLATES, Template, file_name};
pub use text::block::{Block, BlockKind, Fence};
pub use text::outline::{Outline, read};
