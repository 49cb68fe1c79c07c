//! Whole lines around a span.

use super::Edit;
use model::Span;

/// Span from the beginning of the first line of `span` to the end of its last line, without the line end.
pub(super) fn lines_around(source: &str, span: Span) -> Span {
    let start = source[..span.start].rfind('\n').map_or(0, |at| at + 1);
    let end = source[span.end..].find('\n').map_or(source.len(), |length| span.end + length);
    let end = if source[..end].ends_with('\r') && end > span.end { end - 1 } else { end };
    Span::new(start, end)
}

/// Edits that exchange the lines of two spans.
pub(super) fn exchanged(source: &str, one: Span, other: Span) -> Vec<Edit> {
    let (one, other) = (lines_around(source, one), lines_around(source, other));
    let edit = |span: Span, with: Span| Edit { span, text: source[with.range()].to_owned() };
    if one == other { Vec::new() } else { vec![edit(one, other), edit(other, one)] }
}
