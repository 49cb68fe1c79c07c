//! Formatter for documents.

use crate::blocks::questions;
use crate::prose;
use crate::text::block::{Block, BlockKind};
use crate::text::fences::safe_length;
use crate::text::outline::Outline;
use crate::text::source::{Line, lines, trim};
use model::{Edit, Form, Span};
use std::ops::Range;
use units::order::sort_by_key;

/// Result of [`format()`].
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Formatted {
    /// Changes for [`crate::edit::apply`], in text order.
    pub edits: Vec<Edit>,
    /// First lines of the parts that stay unchanged because they have errors.
    pub left: Vec<Span>,
}

/// Edits that format a document: blanks around operators and between words, indentation, blank lines, fences. Columns stay
/// aligned. Line breaks, comments, spelling and order are kept; in prose only trailing blanks are removed. A block with
/// syntax errors stays unchanged.
///
/// The meaning of the document is unchanged, and formatting is idempotent.
pub fn format(outline: &Outline) -> Formatted {
    let source = outline.source();
    let mut formatted = Formatted::default();
    front_matter(outline, &mut formatted);
    let diagnostics = outline.diagnostics();
    for block in outline.blocks() {
        let faulty = diagnostics.iter().any(|found| {
            found.severity == model::Severity::Error
                && block.span.start <= found.span().start
                && found.span().end <= block.span.end
        });
        match (!faulty).then(|| edits(source, block)).flatten() {
            Some(edits) => formatted.edits.extend(edits),
            None => formatted.left.push(block.head()),
        }
    }
    end_of_text(outline, &mut formatted);
    formatted.edits.retain(|edit| source[edit.span.range()] != edit.text);
    sort_by_key(&mut formatted.edits, |edit| (edit.span.start, edit.span.end));
    formatted
}

/// Edits of a block. `None` if it cannot be parsed.
fn edits(source: &str, block: &Block) -> Option<Vec<Edit>> {
    let content = block.content.range();
    let mut edits = match block.kind {
        BlockKind::Prose => prose::without_trailing_blanks(source, content),
        BlockKind::Model | BlockKind::Table => model::format(source, content, Form::Model)?,
        BlockKind::Plots | BlockKind::Presets | BlockKind::Survey | BlockKind::Check | BlockKind::Translations => {
            model::format(source, content, Form::Lines)?
        }
        BlockKind::Question => question(source, content)?,
        BlockKind::Scene => scene(source, content),
    };
    fences(source, block, &mut edits)?;
    Some(edits)
}

/// `key: value` with one blank, and no blank lines. An unclosed front matter stays unchanged.
fn front_matter(outline: &Outline, formatted: &mut Formatted) {
    let (source, matter) = (outline.source(), outline.front_matter());
    let Some(closing) = matter.closing else {
        if matter.span.start < matter.span.end {
            formatted.left.push(Span::new(matter.span.start, matter.span.start + "---".len()));
        }
        return;
    };
    for line in lines(source, matter.span.start..closing.end) {
        if line.text(source).trim().is_empty() {
            formatted.edits.push(Edit { span: Span::new(line.start, line.next), text: String::new() });
        } else if !matter
            .entries
            .iter()
            .any(|entry| line.start <= entry.key_span.start && entry.key_span.end <= line.end)
        {
            trim_end(source, &line, &mut formatted.edits);
        }
    }
    for entry in &matter.entries {
        let start = source[..entry.key_span.start].rfind('\n').map_or(0, |at| at + 1);
        let line = lines(source, start..closing.end).next().map_or(start..start, |line| line.range());
        let written = &source[entry.value.span.range()];
        let text = format!("{}: {written}", entry.key);
        let span = Span::new(line.start, line.end);
        formatted.edits.push(Edit { span, text: text.trim_end().to_owned() });
    }
}

/// Formats a fence: three backquotes, or more if the content needs them, and the words after them.
fn fences(source: &str, block: &Block, edits: &mut Vec<Edit>) -> Option<()> {
    let Some(fence) = block.fence else { return Some(()) };
    let closing = fence.closing?;
    let marks = "`".repeat(safe_length(&source[block.content.range()]));
    let opening = &source[fence.opening.range()];
    let head = fence.opening.end - opening.trim_start_matches([' ', '`', '~']).len();
    let words = match block.kind {
        BlockKind::Table => model::spaced(source, head..fence.opening.end),
        _ => source[head..fence.opening.end].split_whitespace().collect::<Vec<_>>().join(" "),
    };
    edits.push(Edit { span: fence.opening, text: format!("{marks}{words}") });
    edits.push(Edit { span: closing, text: marks });
    Some(())
}

/// Formats a question: its texts as prose, its computed parts as expressions.
fn question(source: &str, content: Range<usize>) -> Option<Vec<Edit>> {
    let parts = questions::split(source, content.clone(), &mut Vec::new());
    let mut edits = prose::without_trailing_blanks(source, parts.prompt());
    for (key, range) in parts.fields() {
        if key.holds == questions::Holds::Expressions {
            let line = range.start - key.word.len() - 1..range.end;
            let end = trim(source, line.clone()).end;
            edits.extend(model::format(source, line.start..end, Form::Lines)?);
            edits.extend(lines(source, end..range.end).flat_map(|line| without_blanks(source, &line)));
        } else {
            edits.extend(prose::without_trailing_blanks(source, range.clone()));
        }
    }
    let text = trim(source, content.clone());
    let is_blank = |line: &Line| line.text(source).trim().is_empty();
    let outer =
        lines(source, content).filter(|line| is_blank(line) && (line.next <= text.start || line.start >= text.end));
    let outer: Vec<Edit> =
        outer.map(|line| Edit { span: Span::new(line.start, line.next), text: String::new() }).collect();
    edits.retain(|edit| !outer.iter().any(|line| line.span.start <= edit.span.start && edit.span.end <= line.span.end));
    edits.extend(outer);
    Some(edits)
}

/// Removes blanks after tags. Text between tags is kept.
fn scene(source: &str, content: Range<usize>) -> Vec<Edit> {
    let mut edits = Vec::new();
    for line in lines(source, content).filter(|line| line.text(source).trim_end().ends_with('>')) {
        trim_end(source, &line, &mut edits);
    }
    edits
}

fn trim_end(source: &str, line: &Line, edits: &mut Vec<Edit>) {
    let end = line.start + line.text(source).trim_end().len();
    edits.push(Edit { span: Span::new(end, line.end), text: String::new() });
}

fn without_blanks(source: &str, line: &Line) -> Vec<Edit> {
    let mut edits = Vec::new();
    trim_end(source, line, &mut edits);
    edits
}

/// One line end at the end of the text, without blank lines before it.
fn end_of_text(outline: &Outline, formatted: &mut Formatted) {
    let source = outline.source();
    let Some(last) = outline.blocks().last() else { return };
    let is_left = formatted.left.iter().any(|head| last.span.start <= head.start && head.end <= last.span.end);
    if is_left || last.fence.is_some_and(|fence| fence.closing.is_none()) {
        return;
    }
    let end = source.trim_end().len();
    let end = if last.kind == BlockKind::Prose { end.max(last.span.start) } else { source.len() };
    let span = Span::new(end, source.len());
    formatted.edits.retain(|edit| edit.span.start < span.start || edit.span.end > span.end || span.start == span.end);
    let text = if source[..end].ends_with('\n') || end == 0 { "" } else { crate::edit::line_end(source) };
    formatted.edits.push(Edit { span, text: text.to_owned() });
}
