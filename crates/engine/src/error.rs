//! Why a run cannot start or go on.

use model::{Diagnostic, Span};
use std::fmt;

/// Why a run cannot start or go on: a value with place and time, which becomes a [`Diagnostic`].
#[derive(Clone, Debug, PartialEq)]
pub struct RunError {
    /// A stable name, such as `not-finite`; never translated.
    pub code: &'static str,
    /// What is wrong, in one sentence without a full stop.
    pub message: String,
    /// The value of the independent variable, in SI.
    pub time: f64,
    /// Where the state or the event concerned stands in the document.
    pub span: Option<Span>,
    /// What to do.
    pub hint: Option<String>,
}

impl fmt::Display for RunError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message)
    }
}

impl std::error::Error for RunError {}

impl From<RunError> for Diagnostic {
    fn from(error: RunError) -> Self {
        let diagnostic = Self::error(error.code, error.message, error.span.unwrap_or_default());
        match error.hint {
            Some(hint) => diagnostic.with_hint(hint),
            None => diagnostic,
        }
    }
}
