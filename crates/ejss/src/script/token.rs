//! Tokens of JavaScript.

/// Token with the line where it begins.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Token {
    pub kind: TokenKind,
    /// Line, from 1.
    pub line: usize,
    /// True if a line end precedes it: it can then end the statement before it.
    pub after_line_end: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum TokenKind {
    /// Number as it is written, and its value.
    Number(String, f64),
    Text(String),
    /// Name or word of the language.
    Name(String),
    /// Operator or bracket.
    Sign(&'static str),
    /// Regular expression; its pattern is not needed.
    Pattern,
    End,
}

impl TokenKind {
    pub fn is_sign(&self, sign: &str) -> bool {
        matches!(self, Self::Sign(own) if *own == sign)
    }

    pub fn is_name(&self, name: &str) -> bool {
        matches!(self, Self::Name(own) if own == name)
    }

    /// True for a token after which `/` divides and does not begin a regular expression.
    pub fn ends_operand(&self) -> bool {
        match self {
            Self::Number(..) | Self::Text(_) | Self::Pattern => true,
            Self::Name(name) => !matches!(name.as_str(), "return" | "typeof" | "case"),
            Self::Sign(sign) => matches!(*sign, ")" | "]" | "}"),
            Self::End => false,
        }
    }
}
