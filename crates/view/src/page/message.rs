//! A message, with an optional action to undo the event or to go to its place.

use play::Prominence;

/// Action offered by a message.
#[derive(Clone, PartialEq)]
pub enum Action {
    /// Undoes the removal with this number.
    Undo(u32),
    /// Goes to the element with this id.
    Show(String),
    /// Restores the document texts stored under this name.
    Restore(String),
}

/// A message, one line.
#[derive(Clone, PartialEq)]
pub struct Message {
    pub(crate) text: String,
    /// An error stays until it is dismissed; any other message fades or is replaced by the next one.
    pub(crate) is_error: bool,
    pub(crate) action: Option<Action>,
}

impl Message {
    /// Message of a success.
    pub fn notice(text: String) -> Self {
        Self { text, is_error: false, action: None }
    }

    /// Message of an error.
    pub fn error(text: String) -> Self {
        Self { text, is_error: true, action: None }
    }

    /// Message for a prominence; `None` if it is only spoken.
    pub fn new(prominence: Prominence, words: &str) -> Option<Self> {
        match prominence {
            Prominence::Spoken => None,
            Prominence::Shown => Some(Self::notice(words.to_owned())),
            Prominence::Error => Some(Self::error(words.to_owned())),
        }
    }

    /// Adds a button that undoes the removal with this number, if any.
    pub fn undone_by(self, number: Option<u32>) -> Self {
        Self { action: number.map(Action::Undo).or(self.action), ..self }
    }

    /// Adds a button that restores the texts stored under this name.
    pub fn restoring(self, version: String) -> Self {
        Self { action: Some(Action::Restore(version)), ..self }
    }

    /// Adds a button that goes to the element with this id.
    pub fn leading_to(self, place: String) -> Self {
        Self { action: Some(Action::Show(place)), ..self }
    }
}
