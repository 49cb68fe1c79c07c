//! Lexemes: pieces of a text that cover it without gaps.

use crate::Span;
use crate::lexer::{TokenKind, is_blank, tokens};
use std::ops::Range;

/// Kind of a [`Lexeme`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LexemeKind {
    /// A name with its primes, or a keyword.
    Word,
    /// A number without its unit.
    Number,
    /// A text with its quotation marks.
    Text,
    /// A unit or an index with its brackets.
    Brackets,
    /// An operator, a separator, a parenthesis or a brace.
    Symbol,
    /// Primes, an exponent or a component after a value.
    Suffix,
    /// Text that the language does not have.
    Unknown,
    /// Blanks in a line.
    Blank,
    /// `#` and the rest of its line.
    Comment,
    /// A line feed.
    LineEnd,
}

/// Smallest piece of a text, with its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lexeme {
    /// Its kind.
    pub kind: LexemeKind,
    /// Byte range in the document.
    pub span: Span,
}

impl Lexeme {
    /// The text as written.
    pub fn text(self, source: &str) -> &str {
        &source[self.span.range()]
    }

    /// True for blanks and comments.
    pub(super) fn is_trivia(self) -> bool {
        matches!(self.kind, LexemeKind::Blank | LexemeKind::Comment)
    }

    /// True if a value can end with it.
    pub(super) fn ends_value(self, source: &str) -> bool {
        let ends = |letter: char| letter.is_alphanumeric() || "_)]}\"'′%°º".contains(letter);
        match self.kind {
            LexemeKind::Symbol => matches!(self.text(source), ")" | "}"),
            LexemeKind::Unknown => self.text(source).ends_with(ends),
            _ => true,
        }
    }
}

/// Splits `source[range]` into lexemes, which cover it without gaps. `range` must lie on character boundaries.
pub fn lexemes(source: &str, range: Range<usize>) -> Vec<Lexeme> {
    let mut found = Vec::new();
    append(source, range, &mut found);
    found
}

fn append(source: &str, range: Range<usize>, found: &mut Vec<Lexeme>) {
    let mut at = range.start;
    for token in tokens(source, range).0 {
        append_trivia(source, at..token.span.start, found);
        at = token.span.end;
        let kind = match token.kind {
            TokenKind::Number(_) => LexemeKind::Number,
            TokenKind::Name { .. } | TokenKind::Keyword(_) => LexemeKind::Word,
            TokenKind::Symbol(_) => LexemeKind::Symbol,
            TokenKind::Component { .. } | TokenKind::Raised(_) | TokenKind::Primes => LexemeKind::Suffix,
            TokenKind::Text(_) => LexemeKind::Text,
            TokenKind::Brackets(_) => LexemeKind::Brackets,
            TokenKind::Newline => LexemeKind::LineEnd,
            TokenKind::Unknown => LexemeKind::Unknown,
            TokenKind::End => continue,
        };
        // The lexer skips the rest of a line after `?`, which means nothing in an expression.
        let is_choice = kind == LexemeKind::Unknown && source[token.span.range()].starts_with('?');
        let end = if is_choice { token.span.start + 1 } else { token.span.end };
        found.push(Lexeme { kind, span: Span::new(token.span.start, end) });
        if end < token.span.end {
            append(source, end..token.span.end, found);
        }
    }
}

/// Appends the text between two tokens: blanks, comments, and characters for which the lexer has no token.
fn append_trivia(source: &str, range: Range<usize>, found: &mut Vec<Lexeme>) {
    let mut at = range.start;
    while at < range.end {
        let text = &source[at..range.end];
        let (kind, length) = match text.chars().next() {
            Some('#') => (LexemeKind::Comment, text.find('\n')),
            Some(first) if is_blank(first) => (LexemeKind::Blank, text.find(|letter| !is_blank(letter))),
            _ => (LexemeKind::Unknown, text.find(|letter| letter == '#' || is_blank(letter))),
        };
        let end = at + length.unwrap_or(text.len());
        found.push(Lexeme { kind, span: Span::new(at, end) });
        at = end;
    }
}
