//! Structure of a document's text: front matter and blocks with their places. Names, units and values are not checked, so
//! the structure is available even while the text has errors.

use super::block::{Block, BlockKind};
use super::fences;
use super::findings::limited;
use super::grammar;
use crate::FrontMatter;
use crate::blocks::front_matter;
use model::{Diagnostic, Span, Statement, sentences};
use std::ops::Range;
use units::words;

/// Maximum length of a document, in bytes.
pub(crate) const LENGTH: usize = 1 << 20;

/// Structure of a document's text. Front matter and blocks cover the text without gaps, except for a byte order mark before
/// them.
#[derive(Clone, Debug)]
pub struct Outline<'a> {
    /// The text; empty if it is too long to be read.
    source: &'a str,
    front_matter: FrontMatter,
    blocks: Vec<Block>,
    /// Diagnostics about front matter and fences.
    pub(crate) layout: Vec<Diagnostic>,
    /// Diagnostics about the syntax of the model.
    syntax: Vec<Diagnostic>,
    is_too_long: bool,
}

/// Reads the structure of a document or of a translation. Always succeeds; errors are in [`Outline::diagnostics`]. A text
/// of more than 1 MB has no front matter and no blocks. Models with more than 200 kB in total are not parsed.
pub fn read(source: &str) -> Outline<'_> {
    let mut layout = Vec::new();
    let is_too_long = source.len() > LENGTH;
    if is_too_long {
        let end = source.chars().next().map_or(0, char::len_utf8);
        let message = words!("a document cannot be longer than {LENGTH} bytes; this one has {}", source.len());
        layout.push(Diagnostic::error("too-large", message, Span::new(0, end)));
    }
    let source = if is_too_long { "" } else { source };
    let front_matter = front_matter::read(source, &mut layout);
    let mut blocks = fences::split(source, front_matter.span.end..source.len(), &mut layout);
    let syntax = parse_models(source, &mut blocks);
    for block in &mut blocks {
        let grammar = grammar::of_block(block.kind);
        block.sentences = grammar.map_or_else(Vec::new, |grammar| sentences(source, block.content.range(), grammar));
    }
    Outline { source, front_matter, blocks, layout, syntax, is_too_long }
}

/// Parses the statements of all models and returns the diagnostics.
fn parse_models(source: &str, blocks: &mut [Block]) -> Vec<Diagnostic> {
    let parts: Vec<Range<usize>> = blocks.iter().filter_map(|block| block.model_part(source)).collect();
    if let Some(refusal) = model::refuse_length(&parts) {
        return vec![refusal];
    }
    let mut diagnostics = Vec::new();
    for block in blocks {
        let Some(part) = block.model_part(source) else { continue };
        let (statements, found) = model::parse(source, &[part]);
        block.statements = statements;
        diagnostics.extend(found);
    }
    diagnostics
}

impl<'a> Outline<'a> {
    /// The text; empty if it is too long to be read.
    pub fn source(&self) -> &'a str {
        self.source
    }

    /// True if the text is too long to be read.
    pub fn is_too_long(&self) -> bool {
        self.is_too_long
    }

    /// The front matter.
    pub fn front_matter(&self) -> &FrontMatter {
        &self.front_matter
    }

    /// The blocks, in text order.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// The blocks of one kind.
    pub fn blocks_of(&self, kind: BlockKind) -> impl Iterator<Item = &Block> {
        self.blocks.iter().filter(move |block| block.kind == kind)
    }

    /// Errors in the structure and in the syntax of the model, in text order. Errors in names, units and everything else
    /// are found by [`crate::open()`].
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        limited(self.layout.iter().chain(&self.syntax).cloned().collect())
    }

    /// Moves the statements of all models and the diagnostics about their syntax out of the outline.
    pub(crate) fn take_model(&mut self) -> (Vec<Statement>, Vec<Diagnostic>) {
        let statements = self.blocks.iter_mut().flat_map(|block| std::mem::take(&mut block.statements)).collect();
        (statements, std::mem::take(&mut self.syntax))
    }
}
