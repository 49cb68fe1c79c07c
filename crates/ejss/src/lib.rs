//! Simulations of Easy JavaScript Simulations (`.ejss`) and WebEJS (`_source.json`) as documents.
//!
//! [`import`] reads every simulation: one with plain differential equations is translated, any other is listed, with its
//! variables, equations and code. A [`Report`] says what was not carried over.
//!
//! | module | content |
//! |---|---|
//! | `reading` | one structure from both formats; `.ejss` is found by names of elements: many files are no well-formed XML |
//! | `script` | the subset of JavaScript of the models |
//! | `translation` | symbolic execution of the code, and the model, scene and plots made from it |
//! | `listing`, `prose`, `page` | the simulation as text; descriptions as Markdown; the document around a model |
//!
//! [`import`] is given a function that checks a document, and takes the first of its candidates that has no error: with
//! units, without, without the drawing, the listing. The tests make both formats from short texts
//! (`tests/simulations/*.txt`), compare documents byte for byte, and run them beside values of an independent evaluator.
//!
//! - **Invariant:** nothing of a file is executed. Everything is bounded: bytes, elements, nesting, tokens, statements, the
//!   size of a value.
//! - **Invariant:** a difference to the original that the translation can see stands in the report.

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
        if imported.listed_because.is_some() {
            return Ok(imported);
        }
        match accepts(&imported.document) {
            Err(error) => importing.refuse(error),
            Ok(()) => return Ok(imported),
        }
    }
}
