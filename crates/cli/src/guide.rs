//! `meniscus guide`: the language of documents in short, for people and programs that write them.
//!
//! The text is made from `docs/language.md` by the build script (`guide.rs` beside it), so there is no second text.

use crate::failure::Failure;
use crate::terminal::output;

/// The guide, in Markdown.
pub const GUIDE: &str = include_str!(concat!(env!("OUT_DIR"), "/guide.md"));

/// Prints the guide.
///
/// # Errors
/// The standard output cannot be written.
pub fn guide() -> Result<(), Failure> {
    output::print(GUIDE)
}
