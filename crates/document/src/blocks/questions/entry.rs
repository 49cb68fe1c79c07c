//! Entries with texts in quotation marks: `"The density" "It cancels."` and `2.2 [s] "You used the diameter"`.

use model::{Lexeme, LexemeKind, Span, lexemes};
use std::ops::Range;

/// An entry as written.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Place without outer blanks.
    pub span: Span,
    /// Texts with their quotation marks.
    texts: Vec<Span>,
    /// Everything else, without blanks and comments.
    pub others: Vec<Lexeme>,
}

impl Entry {
    /// Reads the entry in `range`, which has no outer blanks.
    pub fn read(source: &str, range: Range<usize>) -> Self {
        let span = Span::new(range.start, range.end);
        let is_text = |lexeme: &Lexeme| lexeme.kind == LexemeKind::Text && lexeme.text(source).starts_with('"');
        let is_trivia =
            |one: &Lexeme| matches!(one.kind, LexemeKind::Blank | LexemeKind::Comment | LexemeKind::LineEnd);
        let (texts, others): (Vec<Lexeme>, Vec<Lexeme>) =
            lexemes(source, range).into_iter().filter(|one| !is_trivia(one)).partition(is_text);
        Self { span, texts: texts.into_iter().map(|text| text.span).collect(), others }
    }

    /// Number of texts.
    pub fn count(&self) -> usize {
        self.texts.len()
    }

    /// Place of the text with this index, with its quotation marks.
    pub fn text(&self, index: usize) -> Option<Span> {
        self.texts.get(index).copied()
    }

    /// Byte range between the quotation marks of the text with this index; `None` if the text is empty.
    pub fn inside(&self, source: &str, index: usize) -> Option<Range<usize>> {
        let text = self.text(index)?;
        let range = text.start + 1..text.end - 1;
        (!source[range.clone()].trim().is_empty()).then_some(range)
    }
}
