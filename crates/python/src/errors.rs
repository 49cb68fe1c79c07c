//! Refusals and failed runs as Python exceptions.

use crate::diagnostic::Diagnostic;
use crate::keywords::in_keywords;
use document::Document;
use model::Severity;
use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyValueError};
use pyo3::prelude::*;
use runner::{Loaded, Refusal, Sources, place};

create_exception!(
    meniscus,
    MeniscusError,
    PyException,
    "Base of the errors of this package. `diagnostics` has their places and remedies."
);
create_exception!(meniscus, DocumentError, MeniscusError, "A document has errors.");
create_exception!(meniscus, SettingError, MeniscusError, "An argument is wrong, or a file cannot be read.");
create_exception!(meniscus, RunError, MeniscusError, "A run cannot start or continue.");

/// A wrong Python argument.
pub fn value_error(message: impl Into<String>) -> PyErr {
    PyValueError::new_err(message.into())
}

/// The error for a refused request.
pub fn refused(py: Python<'_>, refusal: &Refusal) -> PyErr {
    let found = match refusal {
        Refusal::Request { message, hint } => {
            vec![Diagnostic::without_place(Severity::Error, "", message, hint.as_ref())]
        }
        Refusal::Expression { setting, text, found } => {
            let sources = Sources::of_text(&in_keywords(setting), text);
            found.iter().map(|diagnostic| Diagnostic::new(&sources, 0, diagnostic)).collect()
        }
    };
    raised::<SettingError>(py, found)
}

/// The error for a document with errors. Its warnings are among the diagnostics, not in the message.
pub fn unsound(py: Python<'_>, loaded: &Loaded) -> PyErr {
    raised::<DocumentError>(py, diagnostics(loaded))
}

/// All findings about a document.
pub fn diagnostics(loaded: &Loaded) -> Vec<Diagnostic> {
    let found = loaded.opened.diagnostics.iter();
    found.map(|(file, diagnostic)| Diagnostic::new(&loaded.sources, *file, diagnostic)).collect()
}

/// The error for a run that cannot start or continue.
pub fn failed(py: Python<'_>, (sources, document): (&Sources, &Document), error: &engine::RunError) -> PyErr {
    raised::<RunError>(py, vec![run_diagnostic((sources, document), error)])
}

/// A failed run as a diagnostic, with its place in the document if that is known.
pub fn run_diagnostic((sources, document): (&Sources, &Document), error: &engine::RunError) -> Diagnostic {
    let (message, hint) = (error.message(&document.program.model), error.hint());
    match error.subject().and_then(|subject| place(document, subject)) {
        Some(span) => {
            let found = model::Diagnostic::error(error.code(), message, span).with_hint(hint);
            Diagnostic::new(sources, 0, &found)
        }
        None => Diagnostic::without_place(Severity::Error, error.code(), &message, Some(&hint)),
    }
}

/// An exception of this type with the errors as message and all diagnostics as attribute.
fn raised<T: pyo3::PyTypeInfo>(py: Python<'_>, found: Vec<Diagnostic>) -> PyErr {
    let errors = found.iter().filter(|one| one.is_error()).map(Diagnostic::described);
    let message = errors.collect::<Vec<_>>().join("\n");
    let error = PyErr::from_type(T::type_object(py), message);
    // An exception without the attribute is still an exception with its message.
    let _ = error.value(py).setattr("diagnostics", found);
    error
}
