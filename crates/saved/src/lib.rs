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
