//! `meniscus new`, `meniscus import` and `meniscus format`: creation and layout of documents.

pub mod arguments;
mod format;
mod import;
mod new;

pub use format::format;
pub use import::import;
pub use new::new;
