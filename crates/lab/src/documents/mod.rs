//! Documents of the laboratory: opened, linked, and kept for the next visit.
//!
//! `links.rs` opens what the address asks for. `visited.rs` keeps the open document in each step of the browser's history,
//! and `navigation.rs` follows it. `saved.rs` is the storage, `diagnostics.rs` lists errors, `project.rs` opens projects.
//! `served.rs` asks `meniscus serve` for the files of the document, and the run goes on with them when they have changed.
//! `carried.rs` has the parts of the page that few visits need.

pub mod carried;
pub mod diagnostics;
pub mod import_report;
pub mod imported;
pub mod links;
pub mod navigation;
pub mod opening;
pub mod packing;
pub mod project;
pub mod saved;
pub mod served;
pub mod stored;
mod titles;
pub mod visited;
