//! Data stored for the next visit: conversion between a desk and items ([`saved::Item`]), and a visit of a page with its
//! storage.
//!
//! `records/stored.rs`, `fits/stored.rs`, and here `films.rs`, `tracks.rs` and `answers.rs` convert. A fit is saved as what
//! was asked for and the numbers it found; the next visit repeats it from those numbers in a few trials. `project.rs` gives
//! all items for a project file and takes them. `visit.rs` brings a desk and a storage to each other; the page passes its
//! storage in, tests a map. `facts.rs` has the values that follow from a work.

mod answers;
mod fact_list;
mod facts;
mod films;
mod fit_facts;
mod link;
mod place;
mod project;
mod tracks;
mod visit;

pub use answers::{answer_of_item, restore_answer, saved_answers};
pub use facts::facts;
pub use link::restore;
pub use project::{items_of_fit, merge_project_items, project_items, take_project_items};
pub use visit::{Visit, document_data};

pub(crate) use films::read as film;
