//! Virtual camera: films the simulation of the open document. The film is tracked like any other and does not leave the
//! page.

mod drawing;
mod form;
mod ruler;
mod shooting;

pub use form::{button, view};
