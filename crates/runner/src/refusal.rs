//! Reasons why a request cannot be carried out.

use model::Diagnostic;
use std::fmt::Display;
use std::io;
use std::path::Path;
use units::{Words, nearest, words};

/// Reason why a request cannot be carried out. Settings are named in it as options of the command line, such as `--until`.
#[derive(Clone, Debug)]
pub enum Refusal {
    /// A wrong setting, or a file that cannot be read.
    Request {
        /// Description of the fault.
        message: Words,
        /// Remedy.
        hint: Option<Words>,
    },
    /// A text in a setting has errors.
    Expression {
        /// Name of the setting, for messages.
        setting: String,
        /// The text.
        text: String,
        /// Errors, with their places in the text.
        found: Vec<Diagnostic>,
    },
}

impl Refusal {
    /// A refusal without a remedy.
    pub fn request(message: impl Into<String>) -> Self {
        Self::Request { message: Words::same(message.into()), hint: None }
    }

    /// A refusal with a remedy.
    pub fn with_hint(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::in_words(Words::same(message.into()), Words::same(hint.into()))
    }

    /// A refusal with a remedy, in every language.
    pub fn in_words(message: Words, hint: Words) -> Self {
        Self::Request { message, hint: Some(hint) }
    }

    /// A refused file; the reason follows the name.
    pub fn about(path: &Path, why: &Words) -> Self {
        let name = path.display();
        Self::Request { message: words!("{name} {why}"), hint: None }
    }

    /// A file that cannot be read or written. `doing`: the verb of the message.
    pub fn file(doing: &str, path: &Path, error: &io::Error) -> Self {
        Self::request(format!("cannot {doing} {}: {}", path.display(), plain(error)))
    }

    /// A name that the document does not have. The hint is the nearest name, or all names.
    pub fn unknown<'a>(noun: &str, name: &str, known: impl Iterator<Item = &'a str> + Clone) -> Self {
        let hint = match nearest(name, known.clone()) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("there are {}", listed(known)),
        };
        Self::with_hint(format!("there is no {noun} `{name}`"), hint)
    }
}

/// Message of the operating system without `(os error 2)`.
pub fn plain(error: &io::Error) -> String {
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
