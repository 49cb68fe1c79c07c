//! A line of a text that gets its layout.

use super::cells::{Cell, line_cells, width};
use super::roles::roles;
use crate::lexer::{Token, TokenKind};
use crate::{Edit, Span};
use std::ops::Range;

/// A line of the text.
pub(super) struct Line<'a> {
    /// The blanks with which it begins.
    pub(super) indentation: Span,
    /// How many there are after this.
    pub(super) indented: usize,
    pub(super) cells: Vec<Cell<'a>>,
    /// The blanks with which it ends, its line end left out.
    pub(super) trailing: Span,
    /// Where the next line begins.
    pub(super) next: usize,
    /// How many paragraphs come before it.
    pub(super) paragraph: usize,
    /// The token with which it begins, in the order of the text.
    pub(super) first: usize,
}

impl Line<'_> {
    /// What changes in the text.
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

/// The lines of a text, as they stand there.
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
            // What stands before the first one is the indentation.
            cell.before = Span::new(from, from);
            cell.blanks = 0;
        }
        lines.push(line);
        start = token.span.end;
        first = index + 1;
    }
    lines
}
