//! The structure of a document's text: its front matter and its blocks, with their places. The text need not make sense:
//! names, units and values are not checked, so that an author sees the structure while there are errors in it.

use super::block::{Block, BlockKind};
use super::fences;
use super::findings::limited;
use crate::FrontMatter;
use crate::blocks::front_matter;
use model::{Diagnostic, Span, Statement};
use std::ops::Range;
use units::words;

/// How long a document may be, in bytes.
pub(crate) const LENGTH: usize = 1 << 20;

/// The structure of a document's text. Front matter and blocks together cover the text without gaps, but for a byte
/// order mark before them.
#[derive(Clone, Debug)]
pub struct Outline<'a> {
    /// The text; empty if it was too long to be read.
    source: &'a str,
    front_matter: FrontMatter,
    blocks: Vec<Block>,
    /// Findings about front matter and fences.
    pub(crate) layout: Vec<Diagnostic>,
    /// Findings about the syntax of the model.
    syntax: Vec<Diagnostic>,
    is_too_long: bool,
}

/// Reads the structure of a document or of a translation. Always succeeds; what is wrong is in
/// [`Outline::diagnostics`]. A text of more than 1 MB has no front matter and no blocks. Models of more than 200 kB together
/// are not parsed.
pub fn read(source: &str) -> Outline<'_> {
    let mut layout = Vec::new();
    let is_too_long = source.len() > LENGTH;
    if is_too_long {
        let end = source.chars().next().map_or(0, char::len_utf8);
        let message = words!(
            "a document cannot be longer than {LENGTH} bytes; this one has {}",
            "un documento no puede tener más de {LENGTH} bytes; este tiene {}",
            source.len()
        );
        layout.push(Diagnostic::error("too-large", message, Span::new(0, end)));
    }
    let source = if is_too_long { "" } else { source };
    let front_matter = front_matter::read(source, &mut layout);
    let mut blocks = fences::split(source, front_matter.span.end..source.len(), &mut layout);
    let syntax = parse_models(source, &mut blocks);
    Outline { source, front_matter, blocks, layout, syntax, is_too_long }
}

/// Parses the statements of all models, and returns what was found.
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
    /// The text that was read; empty if it was too long.
    pub fn source(&self) -> &'a str {
        self.source
    }

    /// Whether the text was too long to be read.
    pub fn is_too_long(&self) -> bool {
        self.is_too_long
    }

    /// The front matter.
    pub fn front_matter(&self) -> &FrontMatter {
        &self.front_matter
    }

    /// The blocks in the order of the text.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// The blocks of one kind.
    pub fn blocks_of(&self, kind: BlockKind) -> impl Iterator<Item = &Block> {
        self.blocks.iter().filter(move |block| block.kind == kind)
    }

    /// What is wrong with the structure and with the syntax of the model, in the order of the text. Errors in names, units
    /// and everything else are found by [`crate::open`].
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        limited(self.layout.iter().chain(&self.syntax).cloned().collect())
    }

    /// Moves the statements of all models out of their blocks, with what was found in their syntax.
    pub(crate) fn take_model(&mut self) -> (Vec<Statement>, Vec<Diagnostic>) {
        let statements = self.blocks.iter_mut().flat_map(|block| std::mem::take(&mut block.statements)).collect();
        (statements, std::mem::take(&mut self.syntax))
    }
}
