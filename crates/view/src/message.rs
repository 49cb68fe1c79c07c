//! A message: something that has happened, with a way to undo it or to go there.

use play::Prominence;

/// What can be done about a message.
#[derive(Clone, PartialEq)]
pub enum Action {
    /// Puts back what the removal of this number took away.
    Undo(u32),
    /// Goes to the element of this id.
    Show(String),
    /// Goes back to the texts of the document that the page keeps under this name.
    Restore(String),
}

/// A line.
#[derive(Clone, PartialEq)]
pub struct Message {
    pub(crate) text: String,
    /// An error stays until it is dismissed; anything else fades, and the next one takes its place.
    pub(crate) is_error: bool,
    pub(crate) action: Option<Action>,
}

impl Message {
    /// Something that went well.
    pub fn notice(text: String) -> Self {
        Self { text, is_error: false, action: None }
    }

    /// Something that did not.
    pub fn error(text: String) -> Self {
        Self { text, is_error: true, action: None }
    }

    /// Words as they are shown; nothing of what is only spoken.
    pub fn new(prominence: Prominence, words: &str) -> Option<Self> {
        match prominence {
            Prominence::Spoken => None,
            Prominence::Shown => Some(Self::notice(words.to_owned())),
            Prominence::Error => Some(Self::error(words.to_owned())),
        }
    }

    /// The message with a button that puts back what was removed, where there is a number of that removal.
    pub fn undone_by(self, number: Option<u32>) -> Self {
        Self { action: number.map(Action::Undo).or(self.action), ..self }
    }

    /// The message with a button that goes back to the texts that are kept under this name.
    pub fn restoring(self, version: String) -> Self {
        Self { action: Some(Action::Restore(version)), ..self }
    }

    /// The message with a button that goes to the element of this id.
    pub fn leading_to(self, place: String) -> Self {
        Self { action: Some(Action::Show(place)), ..self }
    }
}
