//! Names, texts in quotation marks, and units in brackets.

use crate::Span;
use units::Unit;

/// A name as written, and its place. Greek characters are transcribed to ASCII (γ is `gamma`).
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// The ASCII name.
    pub text: String,
    /// Place in the source.
    pub span: Span,
}

/// A text in quotation marks, and its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Quoted {
    /// The text, without quotation marks.
    pub text: String,
    /// Place in the source, including the quotation marks.
    pub span: Span,
}

/// A unit in brackets, and its place.
#[derive(Clone, Debug, PartialEq)]
pub struct StatedUnit {
    /// The unit. A unit that cannot be parsed is reported, and the statement has none.
    pub unit: Unit,
    /// Place in the source, including the brackets.
    pub span: Span,
}
