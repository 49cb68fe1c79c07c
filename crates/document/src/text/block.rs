//! Blocks of a document.

use model::{Sentence, Span, Statement};
use std::ops::Range;

/// Kind of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockKind {
    /// Markdown between the fenced blocks. Fenced code of other kinds belongs to it.
    Prose,
    /// Statements of the equation language.
    Model,
    /// One table of the equation language, whose first line is the opening line: ```` ```table a(t) in [m/s^2] ````.
    Table,
    /// An SVG drawing.
    Scene,
    /// Descriptions of figures.
    Plots,
    /// Named sets of parameter values.
    Presets,
    /// A question.
    Question,
    /// Items of the survey.
    Survey,
    /// Claims about runs.
    Check,
    /// Texts and their translations.
    Translations,
}

impl BlockKind {
    /// Kinds of fenced blocks: all except prose.
    pub const FENCED: [Self; 9] = [
        Self::Model,
        Self::Table,
        Self::Scene,
        Self::Plots,
        Self::Presets,
        Self::Question,
        Self::Survey,
        Self::Check,
        Self::Translations,
    ];

    /// Name of the kind; for a fenced block, the word after the backquotes.
    pub fn word(self) -> &'static str {
        match self {
            Self::Prose => "prose",
            Self::Model => "model",
            Self::Table => "table",
            Self::Scene => "scene",
            Self::Plots => "plots",
            Self::Presets => "presets",
            Self::Question => "question",
            Self::Survey => "survey",
            Self::Check => "check",
            Self::Translations => "translations",
        }
    }
}

/// A block of a document.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Kind of the block.
    pub kind: BlockKind,
    /// Whole block, including fence lines and line ends.
    pub span: Span,
    /// Text between the fence lines, including the last line end; for prose, the whole block.
    pub content: Span,
    /// Fence lines; `None` for prose.
    pub fence: Option<Fence>,
    /// Statements of a model or a table, in text order; see [`model::parse`] for statements with errors. Empty for other
    /// kinds, and if the models of the document are too long to be parsed.
    pub statements: Vec<Statement>,
    /// Sentences of a block of plots, presets, claims, translations or a survey, in text order. Empty for other kinds.
    pub sentences: Vec<Sentence>,
}

/// Fence lines of a block, without their line ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fence {
    /// The opening line.
    pub opening: Span,
    /// Closing line. `None` if it is missing; the block then ends with the text or at the next block.
    pub closing: Option<Span>,
}

impl Block {
    pub(crate) fn prose(span: Span) -> Self {
        Self { kind: BlockKind::Prose, span, content: span, fence: None, statements: Vec::new(), sentences: Vec::new() }
    }

    /// Byte range of the statements of the equation language, for a model or a table.
    pub(crate) fn model_part(&self, source: &str) -> Option<Range<usize>> {
        match self.kind {
            BlockKind::Model => Some(self.content.range()),
            BlockKind::Table => {
                let opening = self.head();
                let marks = source[opening.range()].trim_start_matches([' ', '`', '~']);
                Some(opening.end - marks.len()..self.content.end)
            }
            _ => None,
        }
    }

    /// Place of errors about the whole block: its opening line.
    pub(crate) fn head(&self) -> Span {
        self.fence.map_or(self.span, |fence| fence.opening)
    }
}
