//! Lossless syntax tree of the parts of a document that are no statements of the equation language: plots, presets, items of a
//! survey, claims, translations, answers.
//!
//! ```text
//! sentence = [ HEAD ] [ TEXT ] [ ":" ] [ KIND ] phrase { "," phrase } [ "," ENDING ]
//! phrase   = operand { KEYWORD operand }
//! operand  = { lexeme } [ TEXT ]
//! ```
//!
//! A [`Grammar`] lists the words of a kind of sentence. They are not reserved: a word is a keyword only after a value or
//! before one, outside parentheses, brackets and texts; elsewhere it is the name of a quantity. Only `in` cannot be a name. The operands are read by
//! [`crate::parse_expression`].
//!
//! Lexemes cover a text without gaps. A [`Sentence`] has title, colon and phrases, a phrase an operand and clauses
//! (`against t`), all with places. The words of each kind of sentence stand in `document/src/text/grammar.rs`. `at at end`,
//! for example, is the quantity `at` at the end of a run.

mod lexeme;
mod phrase;

pub use lexeme::{Lexeme, LexemeKind, lexemes};
pub use phrase::{Clause, Keyword, Operand, Phrase, Split};

use crate::Span;
use std::ops::Range;

/// Words that have a meaning in a kind of sentence.
#[derive(Clone, Copy, Debug)]
pub struct Grammar {
    /// Words at the beginning, before a text or a colon.
    pub heads: &'static [&'static str],
    /// Words before the first phrase, which another word must follow.
    pub kinds: &'static [&'static str],
    /// Words between operands.
    pub clauses: &'static [&'static str],
    /// Words that stand together after the last comma.
    pub ending: &'static [&'static str],
    /// True if a text at the beginning is a title.
    pub is_titled: bool,
    /// True if commas separate phrases.
    pub is_list: bool,
    /// True if an indented line belongs to the sentence before, unless it begins with a text or a head.
    pub joins_indented: bool,
}

impl Grammar {
    /// A list of phrases without words of its own.
    pub const LIST: Self = Self {
        heads: &[],
        kinds: &[],
        clauses: &[],
        ending: &[],
        is_titled: false,
        is_list: true,
        joins_indented: false,
    };

    /// A list of phrases after a title.
    pub const TITLED: Self = Self { is_titled: true, ..Self::LIST };
}

/// A sentence: a line, with the lines that continue it.
#[derive(Clone, Debug, PartialEq)]
pub struct Sentence {
    /// Place without outer blanks and comments.
    pub span: Span,
    /// The word at the beginning.
    pub head: Option<Keyword>,
    /// The text at the beginning or after the head, with its quotation marks.
    pub title: Option<Span>,
    /// The colon after title or head.
    pub colon: Option<Span>,
    /// The word before the first phrase.
    pub kind: Option<Keyword>,
    /// Place of phrases and ending. Empty, at the end of the sentence, if there are none.
    pub body: Span,
    /// The phrases; one empty phrase if the body is empty.
    parts: Vec<(Operand, Vec<Clause>)>,
    /// The option after the last comma.
    pub ending: Option<Span>,
}

impl Sentence {
    /// The phrases between the commas.
    pub fn phrases(&self) -> impl DoubleEndedIterator<Item = Phrase<'_>> + ExactSizeIterator {
        self.parts.iter().map(|(operand, clauses)| Phrase { operand: *operand, clauses })
    }

    /// Place after title or head: the colon with the body.
    pub fn rest(&self) -> Span {
        Span::new(self.colon.map_or(self.body.start, |colon| colon.start), self.span.end)
    }

    /// Place of the phrases. Empty, at the beginning of the body, if there are none.
    pub fn listed(&self) -> Span {
        let end = self.phrases().last().map_or(self.body.start, |last| last.span().end);
        if self.ending.is_none() { self.body } else { Span::new(self.body.start, end.max(self.body.start)) }
    }

    /// The title without its quotation marks; `None` if it is missing or blank.
    pub fn title_text<'a>(&self, source: &'a str) -> Option<&'a str> {
        self.title.map(|title| inside(source, title)).filter(|title| !title.trim().is_empty())
    }
}

/// The text between the quotation marks at `text`.
pub fn inside(source: &str, text: Span) -> &str {
    &source[text.start + 1..text.end - 1]
}

/// Operators of expressions, which are written like words.
const OPERATORS: [&str; 4] = ["and", "or", "then", "else"];

/// Operators before a value.
const PREFIXES: [&str; 2] = ["if", "not"];

/// Reads the sentences in `range`. A sentence is a line; after a comma or a colon it continues on the next line.
pub fn sentences(source: &str, range: Range<usize>, grammar: &Grammar) -> Vec<Sentence> {
    let lexemes = lexemes(source, range);
    let mut groups: Vec<Vec<Lexeme>> = Vec::new();
    for line in lexemes.split(|lexeme| lexeme.kind == LexemeKind::LineEnd) {
        let written = line.iter().copied().filter(|lexeme| !lexeme.is_trivia());
        let Some(first) = written.clone().next() else { continue };
        let is_indented = grammar.joins_indented && line.first() != Some(&first);
        let is_head = || keyword(source, &[first], grammar.heads).is_some();
        let begins = is_quoted(source, first)
            || is_head() && written.clone().nth(1).is_some_and(|next| next.text(source) == ":");
        let goes_on = |last: &Lexeme| matches!(last.text(source), "," | ":") || is_indented && !begins;
        match groups.last_mut() {
            Some(before) if before.last().is_some_and(goes_on) => before.extend(written),
            _ => groups.push(written.collect()),
        }
    }
    groups
        .iter()
        .map(|group| sentence_of(source, group, group.last().map_or(0, |last| last.span.end), grammar))
        .collect()
}

/// Reads `range` as one sentence, also over several lines.
pub fn sentence(source: &str, range: Range<usize>, grammar: &Grammar) -> Sentence {
    let end = range.start + source[range.clone()].trim_end().len();
    let written = lexemes(source, range).into_iter();
    let written: Vec<Lexeme> =
        written.filter(|lexeme| !lexeme.is_trivia() && lexeme.kind != LexemeKind::LineEnd).collect();
    sentence_of(source, &written, written.last().map_or(end, |last| last.span.end), grammar)
}

fn sentence_of(source: &str, lexemes: &[Lexeme], end: usize, grammar: &Grammar) -> Sentence {
    let mut rest = lexemes;
    let start = rest.first().map_or(end, |first| first.span.start);
    let head = keyword(source, rest, grammar.heads);
    rest = &rest[usize::from(head.is_some())..];
    let title = rest.first().filter(|first| grammar.is_titled && is_quoted(source, **first)).map(|first| first.span);
    rest = &rest[usize::from(title.is_some())..];
    let is_headed = head.is_some() || title.is_some();
    let colon = rest.first().filter(|first| is_headed && first.text(source) == ":").map(|first| first.span);
    rest = &rest[usize::from(colon.is_some())..];
    let kind = keyword(source, rest, grammar.kinds).filter(|_| opening(source, rest, grammar)[0]);
    rest = &rest[usize::from(kind.is_some())..];
    let body = Span::new(rest.first().map_or(end, |first| first.span.start), end);
    let mut parts = Vec::new();
    let mut ending = None;
    let commas = separators(source, rest, grammar);
    let ends = commas.iter().copied().chain([rest.len()]);
    let mut from = 0;
    for to in ends {
        let part = &rest[from..to];
        let after = rest.get(to).map_or(end, |comma| comma.span.start);
        let is_last = to == rest.len() && !part.is_empty();
        if is_last && part.iter().map(|lexeme| lexeme.text(source)).eq(grammar.ending.iter().copied()) {
            ending = Some(Span::new(part[0].span.start, after));
        } else {
            parts.push(phrase(source, part, after, grammar));
        }
        from = to + 1;
    }
    Sentence { span: Span::new(start, end), head, title, colon, kind, body, parts, ending }
}

/// The word at the beginning, if it is one of `words`.
fn keyword(source: &str, lexemes: &[Lexeme], words: &[&'static str]) -> Option<Keyword> {
    let first = lexemes.first()?;
    let word = words.iter().find(|word| **word == first.text(source))?;
    Some(Keyword { word, span: first.span })
}

/// For each lexeme, true if an operand follows it after a blank: a word, a number or a parenthesis. A word of the grammar
/// before an operand is no name, because no value follows a value.
fn opening(source: &str, lexemes: &[Lexeme], grammar: &Grammar) -> Vec<bool> {
    let mut opens = vec![false; lexemes.len()];
    for (index, pair) in lexemes.windows(2).enumerate().rev() {
        let (text, next) = (pair[1].text(source), pair[1]);
        opens[index] = next.span.start > pair[0].span.end
            && (text == "(" || matches!(next.kind, LexemeKind::Word | LexemeKind::Number))
            && !OPERATORS.contains(&text)
            && !(opens[index + 1] && grammar.clauses.contains(&text));
    }
    opens
}

/// Text in plain quotation marks.
fn is_quoted(source: &str, lexeme: Lexeme) -> bool {
    let text = lexeme.text(source);
    lexeme.kind == LexemeKind::Text && text.starts_with('"') && text.ends_with('"')
}

/// Indices of the commas outside parentheses; none if they do not separate phrases.
fn separators(source: &str, lexemes: &[Lexeme], grammar: &Grammar) -> Vec<usize> {
    let is_comma = |(_, lexeme): &(usize, &Lexeme)| lexeme.text(source) == ",";
    outside(source, lexemes).filter(|one| grammar.is_list && is_comma(one)).map(|(index, _)| index).collect()
}

/// Lexemes outside parentheses and braces with their indices; of these marks, only the opening ones.
pub fn outside<'a>(source: &'a str, lexemes: &'a [Lexeme]) -> impl Iterator<Item = (usize, &'a Lexeme)> {
    let mut depth = 0_usize;
    lexemes.iter().enumerate().filter(move |(_, lexeme)| {
        let is_outside = depth == 0;
        match lexeme.text(source) {
            "(" | "{" => depth += 1,
            ")" | "}" => depth = depth.saturating_sub(1),
            _ => {}
        }
        is_outside
    })
}

/// Splits a phrase that ends before byte `end` at its keywords.
fn phrase(source: &str, lexemes: &[Lexeme], end: usize, grammar: &Grammar) -> (Operand, Vec<Clause>) {
    let opens = opening(source, lexemes, grammar);
    let mut words: Vec<(usize, Keyword)> = Vec::new();
    let mut follows_value = false;
    for (index, lexeme) in outside(source, lexemes) {
        let text = lexeme.text(source);
        let found = keyword(source, &lexemes[index..], grammar.clauses);
        let found = found.filter(|_| follows_value || text == "in" || opens[index]);
        follows_value = match found {
            Some(_) => false,
            None if PREFIXES.contains(&text) || follows_value && OPERATORS.contains(&text) => false,
            None => matches!(text, "(" | "{") || lexeme.ends_value(source),
        };
        words.extend(found.map(|keyword| (index, keyword)));
    }
    let limit = |number: usize| words.get(number).map_or(lexemes.len(), |(index, _)| *index);
    let place = |index: usize| lexemes.get(index).map_or(end, |lexeme| lexeme.span.start);
    let operand = |from: usize, to: usize| operand(source, &lexemes[from..to], place(to));
    let mut first = operand(0, limit(0));
    if first.span.start == first.span.end && first.label.is_some() {
        // A text alone is a value.
        first = Operand { span: first.label.unwrap_or(first.span), label: None, ..first };
    }
    let clause = |(number, (index, keyword)): (usize, &(usize, Keyword))| Clause {
        keyword: *keyword,
        operand: operand(index + 1, limit(number + 1)),
    };
    (first, words.iter().enumerate().map(clause).collect())
}

fn operand(source: &str, lexemes: &[Lexeme], end: usize) -> Operand {
    let label = lexemes.last().filter(|last| is_quoted(source, **last)).map(|last| last.span);
    let value = &lexemes[..lexemes.len() - usize::from(label.is_some())];
    let dots = outside(source, value).find(|(_, lexeme)| matches!(lexeme.text(source), ".." | "…"));
    let blank = label.map_or(end, |label| label.start);
    let span = match (value.first(), value.last()) {
        (Some(first), Some(last)) => first.span.to(last.span),
        _ => Span::new(blank, blank),
    };
    let is_word = matches!(value, [one] if one.kind == LexemeKind::Word && !one.text(source).ends_with(['\'', '′']));
    Operand { span, label, dots: dots.map(|(_, lexeme)| lexeme.span), is_word }
}
