//! Checks of the structure of a text after an edit.

use super::{Edit, EditError, apply};
use crate::FrontMatter;
use crate::blocks::front_matter;
use crate::text::block::{Block, BlockKind};
use crate::text::fences;
use crate::text::outline::{LENGTH, Outline, read};

/// Entries of the front matter and contents of the blocks, without places.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Layout {
    /// Keys and values of the front matter.
    entries: Vec<(String, String)>,
    pub(super) blocks: Vec<(BlockKind, String)>,
}

impl Layout {
    pub(super) fn of(outline: &Outline) -> Self {
        Self::new(outline.source(), outline.front_matter(), outline.blocks())
    }

    /// Structure of a text. Statements of models are not parsed, because edits of other parts cannot change them.
    fn read(source: &str) -> Self {
        let mut ignored = Vec::new();
        let matter = front_matter::read(source, &mut ignored);
        let blocks = fences::split(source, matter.span.end..source.len(), &mut ignored);
        Self::new(source, &matter, &blocks)
    }

    fn new(source: &str, matter: &FrontMatter, blocks: &[Block]) -> Self {
        let entries = matter.entries.iter().map(|entry| (entry.key.clone(), entry.value.text.clone())).collect();
        let blocks = blocks.iter().map(|block| (block.kind, source[block.content.range()].to_owned())).collect();
        Self { entries, blocks }
    }

    /// Joins adjacent prose and removes empty prose, which the text cannot distinguish. Line ends at the end of a block are
    /// ignored, because an edit may complete the last line of a text.
    fn normalised(self) -> Self {
        let mut blocks: Vec<(BlockKind, String)> = Vec::new();
        for (kind, content) in self.blocks {
            match blocks.last_mut() {
                _ if kind == BlockKind::Prose && content.is_empty() => {}
                Some((BlockKind::Prose, last)) if kind == BlockKind::Prose => last.push_str(&content),
                _ => blocks.push((kind, content)),
            }
        }
        for (_, content) in &mut blocks {
            content.truncate(content.trim_end_matches(['\r', '\n']).len());
        }
        Self { entries: self.entries, blocks }
    }

    /// True if the layout of a text is the same, apart from the contents of the blocks that `may_differ` by index and kind.
    fn differs_only_in(mut self, may_differ: impl Fn(usize, BlockKind) -> bool, mut other: Self) -> bool {
        for layout in [&mut self, &mut other] {
            let changed = layout.blocks.iter_mut().enumerate().filter(|(block, (kind, _))| may_differ(*block, *kind));
            changed.for_each(|(_, (_, content))| content.clear());
        }
        self == other
    }

    /// Requires that `edits` turn the text of `outline` into one with this structure.
    pub(super) fn expect_of(self, outline: &Outline, edits: &[Edit]) -> Result<(), EditError> {
        let text = result(outline, edits)?;
        if Self::read(&text).normalised() == self.normalised() { Ok(()) } else { Err(EditError::ChangesOthers) }
    }
}

/// Requires that `edits` change only the contents of blocks that `may_differ` by index and kind, and that the text after them
/// `is_expected`; otherwise [`EditError::ChangesOthers`] or `refusal`.
pub(super) fn expect(
    outline: &Outline,
    edits: &[Edit],
    may_differ: impl Fn(usize, BlockKind) -> bool,
    is_expected: impl FnOnce(&Outline) -> bool,
    refusal: EditError,
) -> Result<(), EditError> {
    let text = result(outline, edits)?;
    match Layout::of(outline).differs_only_in(may_differ, Layout::read(&text)) {
        false => Err(EditError::ChangesOthers),
        true if is_expected(&read(&text)) => Ok(()),
        true => Err(refusal),
    }
}

/// The text after the edits. [`EditError::TooLong`] if it is too long to be read.
pub(super) fn result(outline: &Outline, edits: &[Edit]) -> Result<String, EditError> {
    let text = apply(outline.source(), edits)?;
    if outline.is_too_long() || text.len() > LENGTH { Err(EditError::TooLong) } else { Ok(text) }
}

/// Line end of a text: that of its first line.
pub(crate) fn line_end(source: &str) -> &'static str {
    match source.split_once('\n') {
        Some((first, _)) if first.ends_with('\r') => "\r\n",
        _ => "\n",
    }
}

/// `content` with the line ends of `source`.
pub(super) fn with_line_ends_of(source: &str, content: &str) -> String {
    let content = content.replace("\r\n", "\n");
    match line_end(source) {
        "\n" => content,
        line_end => content.replace('\n', line_end),
    }
}

/// Line end to insert at byte `at` so that an insertion begins a line; empty if it already does.
pub(super) fn begin_line(source: &str, at: usize) -> &'static str {
    let before = source[..at].trim_start_matches('\u{feff}');
    if before.is_empty() || before.ends_with('\n') { "" } else { line_end(source) }
}
