//! Diagnostics: what is wrong in a text, where, why, and what to do. A diagnostic is a value; the command line and the page
//! render it in the language of the reader.
//!
//! A diagnostic has a code, a message, places, reasons and remedies. Terminal, JSON and page render the same value.

use std::ops::Range;
use units::{Dimension, UnitError, Words, words};

/// A range of bytes in the document's source.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Span {
    /// The first byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

impl Span {
    /// True if `other` lies inside.
    pub(crate) fn contains(self, other: Self) -> bool {
        self.start <= other.start && other.end <= self.end
    }

    /// The bytes from `start` to `end`, exclusive.
    pub fn new(start: usize, end: usize) -> Self {
        Self { start, end }
    }

    /// The smallest span that covers both.
    pub fn to(self, other: Self) -> Self {
        Self::new(self.start.min(other.start), self.end.max(other.end))
    }

    /// The empty span just after it.
    pub fn after(self) -> Self {
        Self::new(self.end, self.end)
    }

    /// The bytes as a range, for slicing the source.
    pub fn range(self) -> Range<usize> {
        self.start..self.end
    }
}

/// Severity of a diagnostic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The document runs, but the author should know.
    Warning,
    /// The document does not run.
    Error,
}

/// A place in the source with a text about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// Text beside the place; empty where underlining suffices.
    pub text: Words,
}

/// A replacement of part of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The bytes to be replaced; empty for an insertion.
    pub span: Span,
    /// The new text; empty for a removal.
    pub text: String,
}

/// A change of the text that removes the cause of a diagnostic.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// Replacements; their spans do not overlap.
    pub edits: Vec<Edit>,
}

impl Fix {
    /// Title of the button that makes the change in `source`: "replace `gmma` by `gamma`".
    pub fn title(&self, source: &str) -> Words {
        let Some(Edit { span, text }) = self.edits.first() else { return Words::default() };
        let old = source.get(span.range()).unwrap_or_default().trim();
        let new = text.trim();
        match (old.is_empty(), new.is_empty()) {
            (true, _) => words!("insert `{new}`"),
            (false, true) => words!("remove `{old}`"),
            (false, false) => words!("replace `{old}` by `{new}`"),
        }
    }
}

/// One finding about a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Severity.
    pub severity: Severity,
    /// Stable identifier such as `dimension-mismatch`, never translated.
    pub code: &'static str,
    /// The fault, in one sentence without a full stop.
    pub message: Words,
    /// Places; the first label is the primary place.
    pub labels: Vec<Label>,
    /// Reasons: lines that may be aligned in columns, for a fixed-width font.
    pub notes: Vec<Words>,
    /// Remedies.
    pub hints: Vec<Words>,
    /// Remedies that an editor can apply.
    pub fixes: Vec<Fix>,
    /// The dimension found at the primary place, and the one needed there; of a mismatch between known dimensions only.
    pub dimensions: Option<[Dimension; 2]>,
}

impl Diagnostic {
    /// An error at `span`.
    pub fn error(code: &'static str, message: Words, span: Span) -> Self {
        Self::new(Severity::Error, code, message, span)
    }

    /// A warning at `span`.
    pub fn warning(code: &'static str, message: Words, span: Span) -> Self {
        Self::new(Severity::Warning, code, message, span)
    }

    fn new(severity: Severity, code: &'static str, message: Words, span: Span) -> Self {
        let labels = vec![Label { span, text: Words::default() }];
        let (notes, hints, fixes) = (Vec::new(), Vec::new(), Vec::new());
        Self { severity, code, message, labels, notes, hints, fixes, dimensions: None }
    }

    /// Diagnostic for a unit whose text begins at byte `start`, inside the brackets at `brackets`.
    pub fn of_unit(error: UnitError, start: usize, brackets: Span) -> Self {
        let inside = Span::new(start + error.range.start, start + error.range.end);
        let span = if error.range.is_empty() { brackets } else { inside };
        let mut diagnostic = Self::error(error.code, error.message, span);
        diagnostic.hints.extend(error.hint.map(|hint| *hint));
        match error.meant {
            Some(meant) => diagnostic.with_fix(span, meant),
            None => diagnostic,
        }
    }

    /// Sets the text beside the primary place.
    pub fn saying(mut self, text: Words) -> Self {
        if let Some(label) = self.labels.first_mut() {
            label.text = text;
        }
        self
    }

    /// States the dimension that was found and the one that is needed.
    pub fn of_dimensions(mut self, found: Dimension, needed: Dimension) -> Self {
        self.dimensions = Some([found, needed]);
        self
    }

    /// Adds a place.
    pub fn with_label(mut self, span: Span, text: Words) -> Self {
        self.labels.push(Label { span, text });
        self
    }

    /// Adds a reason.
    pub fn with_note(mut self, note: Words) -> Self {
        self.notes.push(note);
        self
    }

    /// Adds a remedy.
    pub fn with_hint(mut self, hint: Words) -> Self {
        self.hints.push(hint);
        self
    }

    /// Adds a fix that replaces the text at `span` by `text`.
    pub fn with_fix(self, span: Span, text: impl Into<String>) -> Self {
        self.with_fixes(vec![Edit { span, text: text.into() }])
    }

    /// Adds a fix with replacements at several places.
    pub fn with_fixes(mut self, edits: Vec<Edit>) -> Self {
        self.fixes.push(Fix { edits });
        self
    }

    /// Suggests `word` in place of the text at the primary place.
    pub fn meaning(self, word: &str) -> Self {
        let span = self.span();
        self.with_hint(words!("did you mean `{word}`?")).with_fix(span, word)
    }

    /// The primary place.
    pub fn span(&self) -> Span {
        self.labels.first().map(|label| label.span).unwrap_or_default()
    }
}

/// True if any diagnostic is an error.
pub fn has_errors(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
}
