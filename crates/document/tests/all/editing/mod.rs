//! Forms, edits, names and layout of a document.

pub mod asked;
pub mod assist;
pub mod edit;
pub mod form;
pub mod format;
pub mod outline;
pub mod rename;
pub mod templates;
pub mod translating;
pub mod uses;
