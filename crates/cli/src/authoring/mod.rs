//! `meniscus new` and `meniscus format`: creation and layout of documents.

pub mod arguments;
mod format;
mod new;

pub use format::format;
pub use new::new;
