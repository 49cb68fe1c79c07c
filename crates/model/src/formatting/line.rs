//! A line of a text to be formatted.

use super::cells::{Cell, line_cells, width};
use super::roles::roles;
use crate::lexer::{Token, TokenKind};
use crate::{Edit, Span};
use std::ops::Range;

/// A line of the text.
pub(super) struct Line<'a> {
    /// Leading blanks.
    pub(super) indentation: Span,
    /// Number of leading blanks after formatting.
    pub(super) indented: usize,
    pub(super) cells: Vec<Cell<'a>>,
    /// Trailing blanks, without the line end.
    pub(super) trailing: Span,
    /// Byte at which the next line begins.
    pub(super) next: usize,
    /// Number of paragraphs before it.
    pub(super) paragraph: usize,
    /// Index of its first token.
    pub(super) first: usize,
}

impl Line<'_> {
    /// Appends the edits that format the line.
    pub(super) fn edit(&self, source: &str, edits: &mut Vec<Edit>) {
        let mut replace = |span: Span, text: &str| {
            if &source[span.range()] != text {
                edits.push(Edit { span, text: text.to_owned() });
            }
        };
        replace(self.indentation, &" ".repeat(self.indented));
        for cell in &self.cells {
            replace(cell.before, &" ".repeat(cell.blanks));
            replace(cell.span, &cell.text);
        }
        replace(self.trailing, "");
    }
}

/// Splits a text into lines, with their layout unchanged.
pub(super) fn lines<'a>(source: &'a str, range: Range<usize>, tokens: &[Token]) -> Vec<Line<'a>> {
    let roles = roles(source, tokens);
    let mut lines = Vec::new();
    let mut start = range.start;
    let mut first = 0;
    let mut paragraph = 0;
    for (index, token) in tokens.iter().enumerate() {
        let is_end = token.kind == TokenKind::End;
        if !is_end && token.kind != TokenKind::Newline {
            continue;
        }
        let end = if is_end { range.end } else { token.span.start };
        if is_end && start == end {
            break;
        }
        let end = end - usize::from(source[start..end].ends_with('\r'));
        let cells = line_cells(source, &tokens[first..index], &roles[first..index], start..end);
        let (from, to) = match (cells.first(), cells.last()) {
            (Some(first), Some(last)) => (first.before.end, last.span.end),
            _ => (start, start),
        };
        paragraph += usize::from(cells.is_empty());
        let indentation = Span::new(start, from);
        let mut line = Line {
            indentation,
            indented: width(&source[indentation.range()]),
            cells,
            trailing: Span::new(to, end),
            next: token.span.end,
            paragraph,
            first,
        };
        if let Some(cell) = line.cells.first_mut() {
            // Blanks before the first cell are the indentation.
            cell.before = Span::new(from, from);
            cell.blanks = 0;
        }
        lines.push(line);
        start = token.span.end;
        first = index + 1;
    }
    lines
}
