//! Documents of the laboratory: opened, linked, and kept for the next visit.

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
