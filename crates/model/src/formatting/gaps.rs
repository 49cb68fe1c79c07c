//! Blanks between two tokens.

use super::roles::Role;
use program::functions::Function;

/// Rule for the number of blanks between two tokens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Gap {
    None,
    One,
    /// One blank if the text has any.
    OneIfAny,
    /// As many blanks as the text has.
    Exact,
}

/// Gap between two tokens with these roles and texts. `apart`: true if there are blanks between them now.
pub(super) fn gap(roles: [Role; 2], texts: [&str; 2], apart: bool) -> Gap {
    use Role::{
        Attached, Brace, Brackets, Closing, Colon, Comment, Dots, Keyword, Name, Number, Opening, Operator, Point,
        Separator, Sign, Text, Tight, Unknown,
    };
    match roles {
        [_, Comment] => Gap::One,
        [Point, _] | [_, Point] => Gap::Exact,
        [_, Separator | Closing | Dots | Colon] | [Opening | Dots | Sign, _] => Gap::None,
        [_, Attached] => Gap::OneIfAny,
        [Tight, _] | [_, Tight] => Gap::None,
        [Separator | Colon | Brace | Operator | Keyword, _] | [_, Brace | Operator | Keyword] => Gap::One,
        [Number, Brackets] => Gap::One,
        [Name, Opening] if apart && Function::named(texts[0]).is_none() => Gap::One,
        [Name, Opening] => Gap::None,
        [Number, Unknown] if texts[1] == "%" => Gap::One,
        [Text, _] | [_, Text] => Gap::One,
        _ => Gap::OneIfAny,
    }
}
