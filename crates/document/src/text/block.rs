//! The blocks of a document.

use model::{Span, Statement};
use std::ops::Range;

/// What a block of a document holds.
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
    /// Claims about runs.
    Check,
    /// Texts and their translations.
    Translations,
}

impl BlockKind {
    /// The kinds that stand between fence lines: all but prose.
    pub const FENCED: [Self; 8] = [
        Self::Model,
        Self::Table,
        Self::Scene,
        Self::Plots,
        Self::Presets,
        Self::Question,
        Self::Check,
        Self::Translations,
    ];

    /// The name; of a fenced block, the word after the backquotes.
    pub fn word(self) -> &'static str {
        match self {
            Self::Prose => "prose",
            Self::Model => "model",
            Self::Table => "table",
            Self::Scene => "scene",
            Self::Plots => "plots",
            Self::Presets => "presets",
            Self::Question => "question",
            Self::Check => "check",
            Self::Translations => "translations",
        }
    }
}

/// A block of a document.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// What it holds.
    pub kind: BlockKind,
    /// All of it: fence lines and line ends included.
    pub span: Span,
    /// What stands between the fence lines, with its last line end. Of prose, all of it.
    pub content: Span,
    /// The lines around the content; none around prose.
    pub fence: Option<Fence>,
    /// The statements of a model or a table, in the order of the text; see [`model::parse`] for those that have errors. None of
    /// other kinds, and none if the models of the document are too long to be parsed.
    pub statements: Vec<Statement>,
}

/// The lines that begin and end a block, without their line ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fence {
    /// The opening line.
    pub opening: Span,
    /// The closing line. None if it is missing; the block ends with the text or where the next block begins.
    pub closing: Option<Span>,
}

impl Block {
    pub(crate) fn prose(span: Span) -> Self {
        Self { kind: BlockKind::Prose, span, content: span, fence: None, statements: Vec::new() }
    }

    /// Where statements of the equation language stand, if there are any.
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

    /// Where to report a finding about the whole block: its opening line.
    pub(crate) fn head(&self) -> Span {
        self.fence.map_or(self.span, |fence| fence.opening)
    }
}
