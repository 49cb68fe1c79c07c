//! Formats of saved work.
//!
//! | module | content |
//! |---|---|
//! | [`mod@format`] | content of an item: a record, a fit, an answer or the work on a film |
//! | [`item`] | an item as one JSON object |
//! | [`project`] | a document with its items as one file |
//! | [`hand_in`] | a project with its sender and the numbers that follow from it |
//! | [`carried`] | a report that carries a hand-in |
//! | [`survey`] | one person's answers to a survey, apart from all other work |
//! | [`storage`] | the storage of a page, as a trait |
//! | [`shelf`] | synchronisation of the items of a page with its storage |
//!
//! The types of [`mod@format`] are not those of the laboratory, so that a change there does not change what is stored.
//!
//! An [`Item`] is a record, the work on a film, a fit or an answer as one JSON object with the version of the format and the
//! time when it was first stored. Items are stored one by one, so that two open pages do not overwrite each other's. A
//! project is a file of documents, a state, and items, into which it does not look.
//!
//! - **Invariant:** no DOM, no clock; a storage comes in as a trait ([`Storage`]).
//! - **Invariant:** stored text is not trusted. Size and nesting are bounded. Readers ignore fields that they do not know,
//!   and leave items of a later version where they are. A new field needs a default; only one that changes the meaning of
//!   others needs another version.
//!
//! ```
//! use saved::project::{Project, ProjectError};
//!
//! assert_eq!(Project::read("no project"), Err(ProjectError::Unreadable));
//! ```

pub mod carried;
pub mod format;
pub mod hand_in;
pub mod item;
pub mod project;
mod quantity;
pub mod shelf;
pub mod storage;
pub mod survey;

pub use handed::Number;
pub use item::Item;
pub use shelf::{Left, Shelf};
pub use storage::{Storage, own_document_key};
