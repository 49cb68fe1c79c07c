//! The simulation document: one Markdown file with prose, equations, scene, plots, presets and questions, and further
//! files that translate it. Opening one never fails: what cannot be read is a [`model::Diagnostic`] with its place.

mod document;
mod expressions;
mod fences;
mod front_matter;
mod open;
pub mod page;
mod plots;
mod presets;
mod prose;
mod questions;
mod scan;
mod scene;
mod settings;
mod source;
mod translation;
mod vary;

pub use document::{Document, Opened};
pub use front_matter::translates;
pub use open::open;
