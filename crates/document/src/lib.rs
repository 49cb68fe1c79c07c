//! The simulation document: one Markdown file with prose, equations, scene, plots, presets, questions and checks, and further
//! files that translate it.
//!
//! [`read`] gives the structure of a text, whatever is wrong in it. [`open`] also checks it and gives a program if the
//! model has no errors. Neither fails: what cannot be read is a [`model::Diagnostic`] with its
//! place. [`edit`] changes a text by its structure, [`format()`] its layout.

mod asked;
pub mod assist;
mod block;
mod card;
mod checks;
mod curves;
mod document;
pub mod drawing;
pub mod edit;
mod edition;
mod expressions;
mod extent;
mod fences;
mod findings;
pub mod form;
mod format;
mod front_matter;
mod members;
mod open;
mod outline;
pub mod page;
mod plots;
mod presets;
mod profiles;
pub mod project;
mod prose;
mod questions;
mod resized;
mod scan;
mod scene;
mod settings;
mod source;
mod sweeps;
mod template;
mod tolerances;
pub mod translating;
mod translation;
mod vary;

pub use asked::{Asked, QuestionPart, asked, possible_answers};
pub use block::{Block, BlockKind, Fence};
pub use card::{Card, card};
pub use document::{Document, Opened};
pub use format::{Formatted, format};
pub use front_matter::{Entry, FrontMatter, Value, translates};
pub use open::open;
pub use outline::{Outline, read};
pub use resized::resized;
pub use template::{TEMPLATES, Template, file_name};
