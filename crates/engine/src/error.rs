//! Why a run cannot start or go on.

use model::{Diagnostic, Span};
use std::fmt;
use units::Words;

/// Why a run cannot start or go on: a value with place and time, which becomes a [`Diagnostic`].
#[derive(Clone, Debug, PartialEq)]
pub struct RunError {
    /// A stable name, such as `not-finite`; never translated.
    pub code: &'static str,
    /// What is wrong, in one sentence without a full stop.
    pub message: Words,
    /// The value of the independent variable, in SI.
    pub time: f64,
    /// Where the state or the event concerned stands in the document.
    pub span: Option<Span>,
    /// What to do. Boxed, as a result that carries this error is returned for every row.
    pub hint: Option<Box<Words>>,
}

impl RunError {
    /// An error before the first row, without a place.
    pub fn at_start(code: &'static str, message: Words) -> Self {
        Self { code, message, time: 0.0, span: None, hint: None }
    }

    /// The same with what to do.
    pub fn with_hint(self, hint: Words) -> Self {
        Self { hint: Some(Box::new(hint)), ..self }
    }

    /// The same at a place in the document.
    pub fn with_span(self, span: Option<Span>) -> Self {
        Self { span, ..self }
    }
}

/// In English.
impl fmt::Display for RunError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message.english)
    }
}

impl std::error::Error for RunError {}

impl From<RunError> for Diagnostic {
    fn from(error: RunError) -> Self {
        let diagnostic = Self::error(error.code, error.message, error.span.unwrap_or_default());
        match error.hint {
            Some(hint) => diagnostic.with_hint(*hint),
            None => diagnostic,
        }
    }
}
