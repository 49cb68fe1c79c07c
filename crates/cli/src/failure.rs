//! Failures of a command and their exit codes.

use model::Diagnostic;
use runner::{Refusal, Sources, plain};
use std::io;
use std::path::Path;
use units::Words;

/// Reason why a command stopped.
#[derive(Debug)]
pub enum Failure {
    /// The document has errors, or its run failed. Diagnostics were already written. Exit code 1.
    Document,
    /// An argument has errors. They were already written. Exit code 2.
    Argument,
    /// An expression in an argument has errors. Exit code 2.
    Expression {
        /// The expression under the name of its argument.
        source: Sources,
        /// Its errors.
        found: Vec<Diagnostic>,
    },
    /// The request cannot be carried out: a wrong argument, or a file that cannot be read or written. Exit code 2.
    Request {
        /// Description of the fault.
        message: Words,
        /// Remedy.
        hint: Option<Words>,
    },
    /// The reader of the standard output closed it, as `head` does. Not a failure: exit code 0.
    OutputClosed,
}

impl Failure {
    /// A wrong request without a remedy.
    pub fn request(message: impl Into<String>) -> Self {
        Refusal::request(message).into()
    }

    /// A wrong request with a remedy.
    pub fn with_hint(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Refusal::with_hint(message, hint).into()
    }

    /// A wrong request with a remedy, in every language.
    pub fn in_words(message: Words, hint: Words) -> Self {
        Refusal::in_words(message, hint).into()
    }

    /// A file of which a reason is said; the reason follows the name.
    pub fn about(path: &Path, why: &Words) -> Self {
        Refusal::about(path, why).into()
    }

    /// A file that cannot be read or written. `doing`: the verb of the message.
    pub fn file(doing: &str, path: &Path, error: &io::Error) -> Self {
        Refusal::file(doing, path, error).into()
    }

    /// Failure of writing to the standard output.
    pub fn standard_output(error: &io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::OutputClosed,
            _ => Self::request(format!("cannot write to the standard output: {}", plain(error))),
        }
    }

    /// Exit code: 0, 1 or 2.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::OutputClosed => 0,
            Self::Document => 1,
            Self::Argument | Self::Expression { .. } | Self::Request { .. } => 2,
        }
    }
}

impl From<Refusal> for Failure {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Request { message, hint } => Self::Request { message, hint },
            Refusal::Expression { setting, text, found } => {
                Self::Expression { source: Sources::of_text(&setting, &text), found }
            }
        }
    }
}
