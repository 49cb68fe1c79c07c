//! Trailing blanks in Markdown.

use super::html::options;
use crate::text::source::lines;
use model::{Edit, Span};
use pulldown_cmark::{Event, Parser, Tag};
use std::ops::Range;

/// Edits that remove trailing blanks outside code, except the two blanks of a line break. No edits if the meaning of the
/// Markdown would change.
pub fn without_trailing_blanks(source: &str, range: Range<usize>) -> Vec<Edit> {
    let text = &source[range.clone()];
    let events = Parser::new_ext(text, options()).into_offset_iter();
    let code: Vec<Range<usize>> = events
        .filter(|(event, _)| matches!(event, Event::Start(Tag::CodeBlock(_) | Tag::HtmlBlock)))
        .map(|(_, place)| place)
        .collect();
    let mut edits = Vec::new();
    let mut code = code.iter().peekable();
    let mut rest = lines(text, 0..text.len()).peekable();
    while let Some(line) = rest.next() {
        while code.next_if(|place| place.end <= line.start).is_some() {}
        if code.peek().is_some_and(|place| place.start < line.next) {
            continue;
        }
        let content = line.text(text).trim_end_matches([' ', '\t']);
        let blanks = &line.text(text)[content.len()..];
        let goes_on = rest.peek().is_some_and(|next| !next.text(text).trim().is_empty());
        let breaks = blanks.starts_with("  ") && !content.is_empty() && goes_on;
        let kept = if breaks { "  " } else { "" };
        if blanks != kept {
            edits.push(Edit { span: Span::new(line.start + content.len(), line.end), text: kept.to_owned() });
        }
    }
    let means_the_same = crate::edit::apply(text, &edits)
        .is_ok_and(|after| Parser::new_ext(text, options()).eq(Parser::new_ext(&after, options())));
    if !means_the_same {
        return Vec::new();
    }
    let moved = |span: Span| Span::new(span.start + range.start, span.end + range.start);
    edits.into_iter().map(|edit| Edit { span: moved(edit.span), ..edit }).collect()
}
