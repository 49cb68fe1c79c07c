//! What stands for itself: names, texts in quotation marks, units in brackets.

use crate::Span;
use units::Unit;

/// A name as written and where. Greek characters are already ASCII names (γ is `gamma`).
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// The ASCII name.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// A text in quotation marks and where.
#[derive(Clone, Debug, PartialEq)]
pub struct Quoted {
    /// The text, without its marks.
    pub text: String,
    /// Where it stands, with its marks.
    pub span: Span,
}

/// A unit in brackets and where.
#[derive(Clone, Debug, PartialEq)]
pub struct StatedUnit {
    /// The unit; where it could not be read, a diagnostic says so and the statement has none.
    pub unit: Unit,
    /// Where it stands, with its brackets.
    pub span: Span,
}
