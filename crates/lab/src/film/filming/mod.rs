//! Virtual camera: films the simulation of the open document. The film is tracked like any other and does not leave the
//! page.
//!
//! A second `Play` of the same program runs from frame to frame, and its scene is drawn as SVG (`drawing.rs`) for instants
//! within each exposure (`shooting.rs`).

mod drawing;
mod form;
mod ruler;
mod shooting;

pub use form::{button, view};
