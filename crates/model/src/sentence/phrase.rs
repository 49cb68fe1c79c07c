//! Phrases: an operand, and clauses that begin with a word.

use crate::Span;

/// A word that has a meaning where it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Keyword {
    /// The word.
    pub word: &'static str,
    /// Its place.
    pub span: Span,
}

/// Text between keywords.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Operand {
    /// Place without label; empty, at the end of the blanks, if nothing stands there.
    pub span: Span,
    /// A text at its end, with its quotation marks.
    pub label: Option<Span>,
    /// The first `..` outside parentheses.
    pub dots: Option<Span>,
    /// True if a single word without primes stands there.
    pub is_word: bool,
}

/// A keyword and its operand: `against t`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Clause {
    /// The word with which it begins.
    pub keyword: Keyword,
    /// The text up to the next keyword.
    pub operand: Operand,
}

/// A node of the tree: an operand with the clauses after it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Phrase<'t> {
    /// The text before the first clause.
    pub operand: Operand,
    /// The clauses, in text order.
    pub clauses: &'t [Clause],
}

/// A phrase split at one of its keywords.
#[derive(Clone, Copy, Debug)]
pub struct Split<'t> {
    /// The phrase before the keyword.
    pub before: Phrase<'t>,
    /// The keyword.
    pub keyword: Keyword,
    /// The operand of the keyword, with the clauses after it.
    pub after: Phrase<'t>,
}

impl Operand {
    fn whole(self) -> Span {
        self.label.map_or(self.span, |label| if self.is_blank() { label } else { self.span.to(label) })
    }

    fn is_blank(self) -> bool {
        self.span.start == self.span.end
    }
}

impl<'t> Phrase<'t> {
    /// Place from the first operand to the last one, with labels.
    pub fn span(self) -> Span {
        let start = self.operand.whole();
        match self.clauses.last() {
            None => start,
            Some(last) if last.operand.is_blank() && last.operand.label.is_none() => start.to(last.keyword.span),
            Some(last) => start.to(last.operand.whole()),
        }
    }

    /// [`Self::span`] without the label at the end. A text alone is no label.
    pub fn unlabelled(self) -> Span {
        let start = self.operand.whole();
        match self.clauses.last() {
            None if self.operand.is_blank() => start,
            None => self.operand.span,
            Some(last) if last.operand.is_blank() => start.to(last.keyword.span),
            Some(last) => start.to(last.operand.span),
        }
    }

    /// The label at the end, with its quotation marks.
    pub fn label(self) -> Option<Span> {
        match self.clauses.last() {
            Some(last) => last.operand.label,
            None => self.operand.label.filter(|_| !self.operand.is_blank()),
        }
    }

    /// The text between plain quotation marks, if nothing else stands there.
    pub fn text(self, source: &str) -> Option<&str> {
        let text = source[self.span().range()].strip_prefix('"')?.strip_suffix('"')?;
        (!text.contains('"')).then_some(text)
    }

    /// True if nothing stands there.
    pub fn is_empty(self) -> bool {
        self.clauses.is_empty() && self.operand.is_blank() && self.operand.label.is_none()
    }

    /// Splits at the last of these keywords.
    pub fn split_last(self, words: &[&str]) -> Option<Split<'t>> {
        self.split(self.clauses.iter().rposition(|clause| words.contains(&clause.keyword.word))?)
    }

    /// Splits at the first keyword `word`.
    pub fn split_first(self, word: &str) -> Option<Split<'t>> {
        self.split(self.clauses.iter().position(|clause| clause.keyword.word == word)?)
    }

    fn split(self, index: usize) -> Option<Split<'t>> {
        let (before, rest) = self.clauses.split_at(index);
        let (clause, after) = rest.split_first()?;
        let (before, after) = (Phrase { clauses: before, ..self }, Phrase { operand: clause.operand, clauses: after });
        Some(Split { before, keyword: clause.keyword, after })
    }
}
