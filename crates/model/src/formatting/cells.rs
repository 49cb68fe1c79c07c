//! Tokens and the comment of a line, with the blanks before each.

use super::gaps::{Gap, gap};
use super::roles::Role;
use crate::Span;
use crate::lexer::{Token, TokenKind, tokens};
use std::borrow::Cow;
use std::ops::Range;

/// Blanks per level of indentation: of braces, and of the continuation lines of a statement.
pub(super) const LEVEL: usize = 4;

/// A token or a comment.
pub(super) struct Cell<'a> {
    /// Place in the text.
    pub(super) span: Span,
    /// Formatted text.
    pub(super) text: Cow<'a, str>,
    pub(super) role: Role,
    /// Blanks between it and the preceding cell.
    pub(super) before: Span,
    /// Number of blanks in the original text.
    pub(super) found: usize,
    /// Kind of gap that belongs before it.
    pub(super) gap: Gap,
    /// Number of blanks before it after formatting.
    pub(super) blanks: usize,
}

impl Cell<'_> {
    /// Number of blanks before the cell if it is not aligned to a column.
    pub(super) fn natural(&self) -> usize {
        match self.gap {
            Gap::None => 0,
            Gap::One => 1,
            Gap::OneIfAny => self.found.min(1),
            Gap::Exact => self.found,
        }
    }
}

/// Tokens of the line in the byte range `range`, and the comment at its end.
pub(super) fn line_cells<'a>(source: &'a str, line: &[Token], roles: &[Role], range: Range<usize>) -> Vec<Cell<'a>> {
    let tokens = line.iter().zip(roles).filter(|(token, _)| token.kind != TokenKind::End);
    let mut parts: Vec<(Span, Cow<str>, Role)> =
        tokens.map(|(token, role)| (token.span, tidied(source, token), *role)).collect();
    let end = parts.last().map_or(range.start, |(span, ..)| span.end);
    let rest = source[end..range.end].trim();
    if rest.starts_with('#') {
        let start = end + source[end..range.end].find('#').unwrap_or_default();
        parts.push((Span::new(start, start + rest.len()), Cow::Borrowed(rest), Role::Comment));
    }
    let mut cells: Vec<Cell> = Vec::with_capacity(parts.len());
    for (span, text, role) in parts {
        let (before, gap) = match cells.last() {
            Some(last) => {
                let before = Span::new(last.span.end, span.start);
                (before, gap([last.role, role], [&last.text, &text], before.start < before.end))
            }
            None => (Span::new(range.start, span.start), if role == Role::Point { Gap::Exact } else { Gap::None }),
        };
        let found = width(&source[before.range()]);
        let mut cell = Cell { span, text, role, before, found, gap, blanks: 0 };
        cell.blanks = cell.natural();
        cells.push(cell);
    }
    cells
}

/// Width of a text in columns; a tab counts as one level of indentation.
pub(super) fn width(text: &str) -> usize {
    text.chars().map(|c| if c == '\t' { LEVEL } else { 1 }).sum()
}

/// Formatted text of a token: units without outer blanks, indices without any blanks.
fn tidied<'a>(source: &'a str, token: &Token) -> Cow<'a, str> {
    let text = &source[token.span.range()];
    let TokenKind::Brackets(inside) = &token.kind else {
        return Cow::Borrowed(text);
    };
    let content = &source[inside.clone()];
    let is_index = source[..token.span.start].ends_with(|c: char| c == '_' || c.is_alphanumeric());
    let tight = if is_index { without_blanks(source, inside.clone()) } else { content.trim().to_owned() };
    if tight == content { Cow::Borrowed(text) } else { Cow::Owned(format!("[{tight}]")) }
}

/// An index such as `i - 1` without blanks; one that contains keywords only loses its outer blanks.
fn without_blanks(source: &str, range: Range<usize>) -> String {
    let content = source[range.clone()].trim();
    let (inside, found) = tokens(source, range);
    let is_simple = |token: &Token| {
        matches!(token.kind, TokenKind::Name { .. } | TokenKind::Number(_) | TokenKind::Symbol(_) | TokenKind::End)
    };
    let has_pair = inside.windows(2).any(|pair| {
        let is_operand = |token: &Token| !matches!(token.kind, TokenKind::Symbol(_) | TokenKind::End);
        is_operand(&pair[0]) && is_operand(&pair[1])
    });
    if found.is_empty() && !has_pair && inside.iter().all(is_simple) {
        inside.iter().map(|token| &source[token.span.range()]).collect::<String>().replace(',', ", ")
    } else {
        content.to_owned()
    }
}
