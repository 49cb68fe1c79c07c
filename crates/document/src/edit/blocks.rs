//! Edits of whole blocks.

use super::layout::{Layout, begin_line, line_end, with_line_ends_of};
use super::{Edit, EditError};
use crate::text::block::{Block, BlockKind};
use crate::text::fences::safe_length;
use crate::text::outline::Outline;
use model::Span;

/// Replaces the content of the block with this index in [`Outline::blocks`]; its fence lines are kept. Line ends are
/// converted to those of the document, and a missing final one is added. Prose without text is removed.
///
/// # Errors
///
/// [`EditError::UnknownBlock`], [`EditError::TooLong`], and [`EditError::ChangesOthers`] if a line of the content would
/// close the block or begin another.
pub fn replace_block(outline: &Outline, index: usize, content: &str) -> Result<Edit, EditError> {
    let block = block(outline, index)?;
    let is_last = block.content.end == outline.source().len();
    let text = lines_of(outline, content, is_last);
    let mut expected = Layout::of(outline);
    expected.blocks[index].1.clone_from(&text);
    let edit = Edit { span: block.content, text };
    expected.expect_of(outline, std::slice::from_ref(&edit))?;
    Ok(edit)
}

/// Inserts a block after the block with the index `after` in [`Outline::blocks`], or before the first one for `None`. The
/// fence is long enough that no line of the content closes the block. Adjacent prose is joined to one block.
///
/// # Errors
///
/// [`EditError::UnknownBlock`], [`EditError::TooLong`], and [`EditError::ChangesOthers`] if prose contains a line that begins
/// a block, or if code in the prose before is not closed.
pub fn insert_block(
    outline: &Outline,
    after: Option<usize>,
    kind: BlockKind,
    content: &str,
) -> Result<Edit, EditError> {
    let source = outline.source();
    let at = match after {
        Some(index) => block(outline, index)?.span.end,
        None => outline.front_matter().span.end,
    };
    let (begin, end) = (begin_line(source, at), line_end(source));
    let text = lines_of(outline, content, kind == BlockKind::Prose && at == source.len());
    let mut expected = Layout::of(outline);
    if let Some((_, last)) = after.and_then(|index| expected.blocks.get_mut(index)) {
        last.push_str(begin);
    }
    expected.blocks.insert(after.map_or(0, |index| index + 1), (kind, text.clone()));
    let text = if kind == BlockKind::Prose {
        format!("{begin}{text}")
    } else {
        let marks = "`".repeat(safe_length(content));
        format!("{begin}{marks}{}{end}{text}{marks}{end}", kind.word())
    };
    let edit = Edit { span: Span::new(at, at), text };
    expected.expect_of(outline, std::slice::from_ref(&edit))?;
    Ok(edit)
}

/// Removes the block with this index in [`Outline::blocks`], including its fence lines. Prose before and after it is
/// joined.
///
/// # Errors
///
/// [`EditError::UnknownBlock`], and [`EditError::ChangesOthers`] if the block before is not closed and would extend
/// further.
pub fn remove_block(outline: &Outline, index: usize) -> Result<Edit, EditError> {
    let edit = Edit { span: block(outline, index)?.span, text: String::new() };
    let mut expected = Layout::of(outline);
    expected.blocks.remove(index);
    expected.expect_of(outline, std::slice::from_ref(&edit))?;
    Ok(edit)
}

fn block<'a>(outline: &'a Outline, index: usize) -> Result<&'a Block, EditError> {
    outline.blocks().get(index).ok_or(EditError::UnknownBlock(index))
}

/// `content` with the line ends of the document. The last line of the document needs none.
fn lines_of(outline: &Outline, content: &str, is_last: bool) -> String {
    let mut text = with_line_ends_of(outline.source(), content);
    if !is_last && !text.is_empty() && !text.ends_with('\n') {
        text.push_str(line_end(outline.source()));
    }
    text
}
