//! `meniscus verify`: computes hand-ins again.

use super::arguments::{Format, Verify};
use super::read::computed;
use super::report::{holds, json, text};
use crate::failure::Failure;
use crate::terminal::Terminal;
use crate::terminal::output::print;

/// Verifies hand-ins and writes the result.
///
/// # Errors
/// A file cannot be read. [`Failure::Document`] if a hand-in does not hold.
pub fn verify(arguments: &Verify, terminal: Terminal) -> Result<(), Failure> {
    let (class, _) = computed(&arguments.paths, &arguments.document, terminal.language)?;
    let result = match arguments.format {
        Format::Text => text(&class, terminal.language),
        Format::Json => json(&class, terminal.language),
    };
    print(&result)?;
    if holds(&class) { Ok(()) } else { Err(Failure::Document) }
}
