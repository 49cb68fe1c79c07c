//! The blocks of a document.

use model::{Span, Statement};

/// What a block of a document holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockKind {
    /// Markdown between the fenced blocks. Fenced code of other kinds belongs to it.
    Prose,
    /// Statements of the equation language.
    Model,
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
    pub const FENCED: [Self; 7] =
        [Self::Model, Self::Scene, Self::Plots, Self::Presets, Self::Question, Self::Check, Self::Translations];

    /// The name; of a fenced block, the word after the backquotes.
    pub fn word(self) -> &'static str {
        match self {
            Self::Prose => "prose",
            Self::Model => "model",
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
    /// The statements of a model, in the order of the text; see [`model::parse`] for those that have errors. None of
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

    /// Where to report a finding about the whole block: its opening line.
    pub(crate) fn head(&self) -> Span {
        self.fence.map_or(self.span, |fence| fence.opening)
    }
}
