//! The simulation document: one Markdown file with prose, equations, scene, plots, presets, questions and checks, and further
//! files that translate it.
//!
//! [`read`] gives the structure of a text (front matter, blocks, syntax trees, all with places) and always succeeds.
//! [`open()`] also checks it: the model first, then every other part against it. A faulty part is left out and reported; only
//! an error in the model leaves no [`Document`]. Errors are [`model::Diagnostic`]s with their places.
//!
//! | module | content |
//! |---|---|
//! | `text` | lines, blocks and fences of a text; words of each kind of sentence (`grammar.rs`) |
//! | `blocks`, `checks`, `prose`, `scene` | parts of a document: their syntax, and the parts of the program made from them |
//! | [`edit`], [`format()`] | changes of a text by its structure; the one layout |
//! | [`assist`] | what can stand at a place, and what a word means, for editors |
//! | [`form`], [`drawing`], [`translating`], [`asked`] | a text as cells, as a drawing, with its translation, as questions |
//! | [`card()`], [`Searchable`] | entry of a list of documents; search by words in all languages |
//! | [`page`] | documents embedded in a page; `page::played` fills the player, for program and laboratory alike |
//! | [`proposals`] | claims that follow from the text of a document alone |
//! | [`outcomes()`], [`resized()`] | what is kept of many runs; other sizes of families |
//! | [`TEMPLATES`] | short documents to begin with, in each language (`templates/`) |
//!
//! - **Invariant:** the result is safe to show. Sanitising happens here, by lists of what is allowed, and nowhere else: see
//!   `scene` for drawings and `prose` for text.
//! - **Invariant:** one model. A translation supplies words; numbers, equations and answers come from the base document.
//! - **Invariant:** an edit leaves every other byte as it is, or is refused. The test of [`format()`] compiles all documents
//!   before and after.

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
pub mod proposals;
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
