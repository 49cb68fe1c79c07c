//! The virtual camera: it films the simulation of the open document, and the film is tracked as any other. Nothing leaves the page.

mod drawing;
mod form;
mod ruler;
mod shooting;

pub use form::{button, view};
