//! Failures of a command and their exit codes.

use std::fmt::Display;
use std::io;
use std::path::Path;
use units::{Words, words};

/// Reason why a command stopped.
#[derive(Debug)]
pub enum Failure {
    /// The document has errors, or its run failed. Diagnostics were already written. Exit code 1.
    Document,
    /// An expression in an argument has errors. Diagnostics were already written. Exit code 2.
    Argument,
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
        Self::Request { message: Words::same(message.into()), hint: None }
    }

    /// A wrong request with a remedy.
    pub fn with_hint(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::Request { message: Words::same(message.into()), hint: Some(Words::same(hint.into())) }
    }

    /// A wrong request with a remedy, in every language.
    pub fn in_words(message: Words, hint: Words) -> Self {
        Self::Request { message, hint: Some(hint) }
    }

    /// A file of which a reason is said; the reason follows the name.
    pub fn about(path: &Path, why: &Words) -> Self {
        let name = path.display();
        Self::Request { message: words!("{name} {why}"), hint: None }
    }

    /// A file that cannot be read or written. `doing`: the verb of the message.
    pub fn file(doing: &str, path: &Path, error: &io::Error) -> Self {
        Self::request(format!("cannot {doing} {}: {}", path.display(), plain(error)))
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
            Self::Argument | Self::Request { .. } => 2,
        }
    }
}

/// Message of the operating system without `(os error 2)`.
fn plain(error: &io::Error) -> String {
    let text = error.to_string();
    match text.split_once(" (os error") {
        Some((words, _)) => words.to_owned(),
        None => text,
    }
}

/// Joins items to a list: `a, b and c`.
pub fn listed<T: Display>(items: impl IntoIterator<Item = T>) -> String {
    let items: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    match items.as_slice() {
        [] => "none".to_owned(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_read_as_a_sentence() {
        assert_eq!(listed(["b"]), "b");
        assert_eq!(listed(["b", "h_l", "rho"]), "b, h_l and rho");
    }
}
