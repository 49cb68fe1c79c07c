//! Simulations of Easy JavaScript Simulations (`.ejss`) and WebEJS (`_source.json`) as documents.
//!
//! [`import`] reads every simulation: one with plain differential equations is translated, any other is listed, with its
//! variables, equations and code. A [`Report`] says what was not carried over. Nothing of a file is executed.

mod imported;
mod importing;
mod listing;
mod originals;
mod page;
mod place;
mod prose;
mod reading;
mod refusal;
mod report;
mod script;
mod simulation;
mod translation;

pub use imported::Imported;
pub use importing::Importing;
pub use originals::Original;
pub use place::Section;
pub use refusal::Refusal;
pub use report::{Entry, EntryKind, Report};

/// True if a file of this name is a simulation: `.ejss`, `_source.json`.
pub fn is_simulation(name: &str) -> bool {
    reading::Format::of(name).is_some()
}

/// True if a file is an archive with a simulation in it.
pub fn holds_simulation(bytes: &[u8]) -> bool {
    reading::Files::open(bytes).is_ok_and(|files| files.has_source())
}

/// Document of a simulation. `accepts`: checks a document; `Err` is the first error of it.
///
/// # Errors
/// The reason why the file gives no document.
pub fn import(bytes: &[u8], accepts: &mut dyn FnMut(&str) -> Result<(), String>) -> Result<Imported, Refusal> {
    let mut importing = Importing::begin(bytes)?;
    loop {
        let imported = importing.candidate();
        match accepts(&imported.document) {
            Err(error) if imported.listed_because.is_none() => importing.refuse(error),
            _ => return Ok(imported),
        }
    }
}
