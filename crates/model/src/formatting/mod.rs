//! Formatter for the text of a model: blanks between tokens, at the beginning and at the end of lines, and blank lines
//! between statements. Line ends, comments and the spelling of tokens are kept.
//!
//! Neighbouring lines of one kind are aligned in columns.

mod cells;
mod columns;
mod gaps;
mod line;
mod roles;

use crate::lexer::{Token, TokenKind, tokens};
use crate::parser::goes_on;
use crate::{Diagnostic, Edit, Span};
use cells::{LEVEL, line_cells};
use gaps::Gap;
use line::{Line, lines};
use std::ops::Range;

/// Kind of text to be formatted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Statements of the equation language; they determine the indentation of each line.
    Model,
    /// Lines of texts and expressions, such as plots and presets. A line that begins with a text is not indented; other
    /// lines keep their indentation.
    Lines,
}

/// Edits that format the text in the byte range `range`. `None` if the lexer reports an error there.
pub fn format(source: &str, range: Range<usize>, form: Form) -> Option<Vec<Edit>> {
    let (tokens, found) = tokens(source, range.clone());
    if !is_readable(source, &found) {
        return None;
    }
    let mut lines = lines(source, range, &tokens);
    match form {
        Form::Model => indent_statements(&tokens, &mut lines),
        Form::Lines => indent_texts(&mut lines),
    }
    let mut edits = remove_blank_lines(&mut lines);
    columns::align(&mut lines);
    for line in &lines {
        line.edit(source, &mut edits);
    }
    Some(edits)
}

/// An expression, or a line of texts and expressions, in one line with normalized blanks.
pub fn spaced(source: &str, range: Range<usize>) -> String {
    let (mut tokens, found) = tokens(source, range.clone());
    if !is_readable(source, &found) {
        return source[range].split_whitespace().collect::<Vec<_>>().join(" ");
    }
    tokens.retain(|token| !matches!(token.kind, TokenKind::Newline | TokenKind::End));
    let cells = line_cells(source, &tokens, &roles::roles(source, &tokens), range);
    let mut text = String::new();
    for cell in cells {
        text.push_str(if cell.natural() > 0 { " " } else { "" });
        text.push_str(&cell.text);
    }
    text
}

/// True if the lexer reports nothing, apart from percent signs.
fn is_readable(source: &str, found: &[Diagnostic]) -> bool {
    found.iter().all(|diagnostic| source.get(diagnostic.span().range()) == Some("%"))
}

fn indent_statements(tokens: &[Token], lines: &mut [Line]) {
    let goes_on = goes_on(tokens);
    let mut depth = 0_usize;
    for line in lines {
        let continues = line.first.checked_sub(1).is_some_and(|end| goes_on[end]);
        let closes = line.cells.first().is_some_and(|cell| cell.text == "}");
        let level = LEVEL * depth.saturating_sub(usize::from(closes));
        let is_point = line.cells.first().is_some_and(|cell| cell.gap == Gap::Exact);
        line.indented = match (continues, line.indented) {
            (true, 0) => level + LEVEL,
            (true, found) => found,
            (false, found) if is_point && found > 0 => found,
            (false, _) => level,
        };
        for cell in &line.cells {
            match &*cell.text {
                "{" => depth += 1,
                "}" => depth = depth.saturating_sub(1),
                _ => {}
            }
        }
    }
}

fn indent_texts(lines: &mut [Line]) {
    for line in lines {
        let begins = line.cells.first().is_some_and(|cell| {
            cell.text.starts_with('"') || ["set", "hide", "answer", "group"].contains(&&*cell.text)
        });
        if begins {
            line.indented = 0;
        }
    }
}

/// Keeps at most one blank line in a row, and none at the beginning and at the end.
fn remove_blank_lines(lines: &mut Vec<Line>) -> Vec<Edit> {
    let mut edits = Vec::new();
    let last = lines.iter().rposition(|line| !line.cells.is_empty());
    let mut follows_text = false;
    let mut index = 0;
    lines.retain(|line| {
        let is_blank = line.cells.is_empty();
        let keep = !is_blank || follows_text && last.is_some_and(|last| index < last);
        if !keep {
            edits.push(Edit { span: Span::new(line.indentation.start, line.next), text: String::new() });
        }
        follows_text = !is_blank;
        index += 1;
        keep
    });
    edits
}
