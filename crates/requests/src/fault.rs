//! Errors of requests, named by the Python exceptions that they become.

use crate::diagnostic::Diagnostic;
use crate::reply::Reply;
use document::Document;
use model::Severity;
use runner::{Loaded, Refusal, Sources, in_keywords, place};
use serde::{Deserialize, Serialize};

/// Reason why a request is not fulfilled.
#[derive(Clone, Debug)]
pub enum Fault {
    /// A document has errors: all findings about it.
    Document(Vec<Diagnostic>),
    /// A setting is wrong, or a file cannot be read.
    Refused(Refusal),
    /// A run cannot start or continue.
    Run(Box<Diagnostic>),
    /// An argument has a wrong value.
    Value(String),
    /// An argument has a wrong type.
    Type(String),
    /// The caller has ended the work.
    Interrupted,
}

impl From<Refusal> for Fault {
    fn from(refusal: Refusal) -> Self {
        Self::Refused(refusal)
    }
}

/// An answer that cannot be written.
impl From<serde_json::Error> for Fault {
    fn from(error: serde_json::Error) -> Self {
        Self::Value(error.to_string())
    }
}

/// Reads a request.
pub fn read<'a, T: Deserialize<'a>>(request: &'a str) -> Result<T, Fault> {
    serde_json::from_str(request).map_err(|error| Fault::Type(error.to_string()))
}

/// The form of an error in JSON.
#[derive(Serialize)]
struct Raised<'a> {
    error: &'a str,
    message: &'a str,
    diagnostics: Vec<Diagnostic>,
}

impl Fault {
    /// The error as a reply.
    pub fn reply(self) -> Reply {
        let (error, message, diagnostics) = match self {
            Self::Document(diagnostics) => ("DocumentError", String::new(), diagnostics),
            Self::Refused(refusal) => ("SettingError", String::new(), refused(&refusal)),
            Self::Run(diagnostic) => ("RunError", String::new(), vec![*diagnostic]),
            Self::Value(message) => ("ValueError", message, Vec::new()),
            Self::Type(message) => ("TypeError", message, Vec::new()),
            Self::Interrupted => ("KeyboardInterrupt", String::new(), Vec::new()),
        };
        let json = serde_json::to_string(&Raised { error, message: &message, diagnostics });
        Reply { json: json.unwrap_or_default(), buffers: Vec::new() }
    }
}

/// Diagnostics of a refused request.
fn refused(refusal: &Refusal) -> Vec<Diagnostic> {
    match refusal {
        Refusal::Request { message, hint } => {
            vec![Diagnostic::without_place(Severity::Error, "", message, hint.as_ref())]
        }
        Refusal::Expression { setting, text, found } => {
            let sources = Sources::of_text(&in_keywords(setting), text);
            found.iter().map(|diagnostic| Diagnostic::new(&sources, 0, diagnostic)).collect()
        }
    }
}

/// All findings about a document.
pub fn diagnostics(loaded: &Loaded) -> Vec<Diagnostic> {
    let found = loaded.opened.diagnostics.iter();
    found.map(|(file, diagnostic)| Diagnostic::new(&loaded.sources, *file, diagnostic)).collect()
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
