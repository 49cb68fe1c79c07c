//! `meniscus new` and `meniscus format`: documents as their authors begin and keep them.

pub mod arguments;
mod format;
mod new;

pub use format::format;
pub use new::new;
