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
pub use originals::Original;
pub use place::Section;
pub use refusal::Refusal;
pub use report::{Entry, EntryKind, Report};

use translation::{Blocker, Solved};

/// True if a file of this name is a simulation: `.ejss`, `_source.json`.
pub fn is_simulation(name: &str) -> bool {
    reading::Format::of(name).is_some()
}

/// True if a file is an archive with a simulation in it.
pub fn holds_simulation(bytes: &[u8]) -> bool {
    reading::Files::open(bytes).is_ok_and(|files| files.has_source())
}

/// Document of a simulation. `accepts`: checks a document; `Err` is the first error of it. A translation that is not accepted
/// is replaced by one without units, then by one without its drawing, then by a listing.
///
/// # Errors
/// The reason why the file gives no document.
pub fn import(bytes: &[u8], accepts: &mut dyn FnMut(&str) -> Result<(), String>) -> Result<Imported, Refusal> {
    let (simulation, files) = reading::read(bytes)?;
    let page = page::Page::new(&simulation, &files);
    let mut report = page.report.clone();
    let blocker = match Solved::new(&simulation, &files, &mut report) {
        Ok(solved) => {
            let mut message = String::new();
            for (has_units, has_scene) in [(true, true), (false, true), (true, false), (false, false)] {
                if has_units && !solved.has_units() || !has_scene && !solved.has_picture() {
                    continue;
                }
                let mut report = report.clone();
                let blocks = solved.document(&page.title, [has_units, has_scene], &mut report);
                let imported = page.translated(&simulation, &solved, &blocks, has_units, report);
                match accepts(&imported.document) {
                    Ok(()) => return Ok(imported),
                    Err(error) => message = error,
                }
            }
            Blocker::Checker(message)
        }
        Err(blocker) => blocker,
    };
    Ok(page.listed(&simulation, &blocker))
}
