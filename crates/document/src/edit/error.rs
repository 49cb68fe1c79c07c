//! Reasons for refusing an edit.

use super::obstacle::Obstacle;
use model::Span;
use std::fmt;
use units::{Words, words};

/// Reason for refusing an edit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EditError {
    /// The span is outside the text, or cuts a character.
    Place(Span),
    /// The span overlaps another edit.
    Overlap(Span),
    /// The document is or would become too long.
    TooLong,
    /// The model declares no parameter of this name.
    UnknownParameter(String),
    /// The default value of this parameter has an error and cannot be replaced alone.
    UnreadableParameter(String),
    /// The default value of a parameter must be a number without a unit.
    NotANumber(String),
    /// Not a valid key of the front matter.
    Key(String),
    /// Not a valid value in the front matter: empty, or several lines.
    Value(String),
    /// The document has no block with this index.
    UnknownBlock(usize),
    /// This text would change the meaning of other parts of the document.
    ChangesOthers,
    /// The form has no such statement or cell.
    UnknownCell,
    /// The text would not be parsed as one cell.
    NotOneCell(Obstacle),
    /// The text is not one whole statement.
    NotOneStatement,
    /// The document has no drawing.
    NoDrawing,
    /// The drawing has no such element.
    UnknownElement(usize),
    /// The text would not stay inside its element.
    NotOneElement(Obstacle),
    /// The expression of this place cannot be changed graphically.
    NotAPoint,
    /// Questions of a translation must be in the order of the document; this many come before this one.
    EarlierQuestion(usize),
    /// There is no name of the model at the place.
    NoName,
    /// Not a valid name, or already in use.
    NewName(String),
    /// Not all places of this name could be found.
    Incomplete(String),
    /// At a place of `old`, `new` is an argument, an index or another local name.
    Captured {
        /// Name to be changed.
        old: String,
        /// New name.
        new: String,
    },
    /// With this name the document would compute other results.
    ComputesOthers(String),
}

impl EditError {
    /// Message in one sentence without a full stop.
    pub fn words(&self) -> Words {
        match self {
            Self::Place(Span { start, end }) => words!("the bytes from {start} to {end} are not a part of the text"),
            Self::Overlap(Span { start, end }) => words!("another edit also changes bytes from {start} to {end}"),
            Self::TooLong => words!("a document cannot be longer than {} bytes", crate::text::outline::LENGTH),
            Self::UnknownParameter(name) => {
                words!("the model has no parameter `{name}`")
            }
            Self::UnreadableParameter(name) => {
                words!("the default of the parameter `{name}` has an error; correct it in the text")
            }
            Self::NotANumber(text) => words!("`{text}` is not a number"),
            Self::Key(key) => {
                words!("`{key}` cannot be a key of the front matter")
            }
            Self::Value(_) => words("a value in the front matter is one line of text"),
            Self::UnknownBlock(index) => words!("the document has no block with the index {index}"),
            Self::ChangesOthers => words("this text would change how the blocks around it are read"),
            Self::UnknownCell => words("the form has no such cell"),
            Self::NotOneCell(obstacle) | Self::NotOneElement(obstacle) => obstacle.words(),
            Self::NotOneStatement => {
                words("this is not one whole statement: it is empty, has several, or a brace or parenthesis is open")
            }
            Self::NoDrawing => words("the document has no drawing"),
            Self::UnknownElement(_) => words("the drawing has no such element"),
            Self::NotAPoint => {
                words("this place is computed in a way that the hand cannot change; write it in the text")
            }
            Self::EarlierQuestion(number) => words!(
                "translate the first {number} questions before this one: a translation has them in the same order"
            ),
            Self::NoName => words("no name of the model stands here"),
            Self::NewName(name) => {
                words!("`{name}` cannot be a name here: it has a meaning already, or characters that names do not have")
            }
            Self::Incomplete(name) => words!("`{name}` could not be renamed everywhere; rename it in the text"),
            Self::Captured { old, new } => words!(
                "`{old}` cannot become `{new}`: an argument, an index or a `let` is called `{new}` already; rename that first"
            ),
            Self::ComputesOthers(name) => words!(
                "with the name `{name}` the document would compute something else: `{name}` has a meaning of its own in it, or the name decides what is drawn at random; rename in the text"
            ),
        }
    }
}

impl fmt::Display for EditError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.words().english())
    }
}

impl std::error::Error for EditError {}
