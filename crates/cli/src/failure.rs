//! Why a command did not do what it was asked, and the exit code that says so.

use std::fmt::Display;
use std::io;
use std::path::Path;
use units::Words;

/// Why a command stopped.
#[derive(Debug)]
pub enum Failure {
    /// The document has errors, or its run failed; the diagnostics are on the screen already. Exit code 1.
    Document,
    /// An expression in an argument has errors; the diagnostics are on the screen already. Exit code 2.
    Argument,
    /// What was asked for cannot be done: a wrong argument, a file that cannot be read or written. Exit code 2.
    Request {
        /// What is wrong.
        message: Words,
        /// What to do.
        hint: Option<Words>,
    },
    /// Whoever read our output has seen enough, as `head` does. No failure: exit code 0.
    OutputClosed,
}

impl Failure {
    /// Something in the request is wrong.
    pub fn request(message: impl Into<String>) -> Self {
        Self::Request { message: Words::same(message.into()), hint: None }
    }

    /// Something in the request is wrong, and there is a remedy.
    pub fn with_hint(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::Request { message: Words::same(message.into()), hint: Some(Words::same(hint.into())) }
    }

    /// As [`Self::with_hint`], in every language.
    pub fn in_words(message: Words, hint: Words) -> Self {
        Self::Request { message, hint: Some(hint) }
    }

    /// A file that cannot be read or written.
    pub fn file(doing: &str, path: &Path, error: &io::Error) -> Self {
        Self::request(format!("cannot {doing} {}: {}", path.display(), plain(error)))
    }

    /// What writing to standard output ran into.
    pub fn standard_output(error: &io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::OutputClosed,
            _ => Self::request(format!("cannot write to the standard output: {}", plain(error))),
        }
    }

    /// The exit code: 0, 1 or 2.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::OutputClosed => 0,
            Self::Document => 1,
            Self::Argument | Self::Request { .. } => 2,
        }
    }
}

/// The system's own words, without `(os error 2)`.
fn plain(error: &io::Error) -> String {
    let text = error.to_string();
    match text.split_once(" (os error") {
        Some((words, _)) => words.to_owned(),
        None => text,
    }
}

/// `a, b and c`
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
