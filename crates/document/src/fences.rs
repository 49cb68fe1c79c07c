//! The fenced blocks of a document that are more than prose, and the prose between them.

use crate::source::{Line, lines};
use model::{Diagnostic, Span};
use std::ops::Range;
use units::{nearest, words};

/// What a fenced block holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FenceKind {
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
    /// Texts and their translations.
    Translations,
}

const KINDS: [(&str, FenceKind); 6] = [
    ("model", FenceKind::Model),
    ("scene", FenceKind::Scene),
    ("plots", FenceKind::Plots),
    ("presets", FenceKind::Presets),
    ("question", FenceKind::Question),
    ("translations", FenceKind::Translations),
];

impl FenceKind {
    /// The word after the backquotes.
    pub fn word(self) -> &'static str {
        KINDS.iter().find(|(_, kind)| *kind == self).map_or("", |(word, _)| word)
    }
}

/// A part of a document's body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Part {
    /// Markdown.
    Prose(Range<usize>),
    /// A fenced block of a kind that means something here.
    Fence(Fence),
}

/// A fenced block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fence {
    /// What it holds.
    pub kind: FenceKind,
    /// The opening line.
    pub opening: Span,
    /// What stands inside.
    pub content: Range<usize>,
}

/// The opening line of any fence.
struct Opening<'a> {
    mark: char,
    length: usize,
    word: &'a str,
}

impl<'a> Opening<'a> {
    /// CommonMark's rule: at most three blanks, at least three marks, and no backquote after backquotes.
    fn read(line: &'a str) -> Option<Self> {
        let text = line.trim_start_matches(' ');
        if line.len() - text.len() > 3 {
            return None;
        }
        let mark = text.chars().next().filter(|mark| matches!(mark, '`' | '~'))?;
        let info = text.trim_start_matches(mark);
        let length = text.len() - info.len();
        if length < 3 || (mark == '`' && info.contains('`')) {
            return None;
        }
        Some(Self { mark, length, word: info.split_whitespace().next().unwrap_or("") })
    }

    fn kind(&self) -> Option<FenceKind> {
        KINDS.iter().find(|(word, _)| *word == self.word).map(|(_, kind)| *kind)
    }

    fn is_closed_by(&self, line: &str) -> bool {
        Opening::read(line)
            .is_some_and(|other| other.mark == self.mark && other.length >= self.length && other.word.is_empty())
    }
}

/// Splits `range` of `source` into prose and fences.
pub fn split(source: &str, range: Range<usize>, diagnostics: &mut Vec<Diagnostic>) -> Vec<Part> {
    let mut parts = Vec::new();
    let mut prose = range.start;
    let mut rest = lines(source, range.clone()).peekable();
    while let Some(line) = rest.next() {
        let Some(opening) = Opening::read(line.text(source)) else {
            continue;
        };
        let span = Span::new(line.start, line.end);
        let Some(kind) = opening.kind() else {
            warn_of_near_kind(&opening, span, diagnostics);
            // A block of code: it belongs to the prose, and what stands inside means nothing.
            while rest.next_if(|line| !opening.is_closed_by(line.text(source))).is_some() {}
            rest.next();
            continue;
        };
        if prose < line.start {
            parts.push(Part::Prose(prose..line.start));
        }
        let content_start = line.next;
        let mut content_end = line.next;
        while let Some(inner) = rest.next_if(|inner| !ends_inside(source, &opening, inner)) {
            content_end = inner.next;
        }
        parts.push(Part::Fence(Fence { kind, opening: span, content: content_start..content_end }));
        prose = content_end;
        match rest.next_if(|closing| opening.is_closed_by(closing.text(source))) {
            Some(closing) => prose = closing.next,
            None => diagnostics.push(unclosed(&opening, span, rest.peek())),
        }
    }
    if prose < range.end {
        parts.push(Part::Prose(prose..range.end));
    }
    parts
}

/// Whether a fence cannot go on with this line: it closes, or the next one begins because it was forgotten to close.
fn ends_inside(source: &str, opening: &Opening, line: &Line) -> bool {
    let text = line.text(source);
    opening.is_closed_by(text)
        || Opening::read(text)
            .is_some_and(|next| next.kind().is_some() && next.mark == opening.mark && next.length >= opening.length)
}

fn unclosed(opening: &Opening, span: Span, next: Option<&Line>) -> Diagnostic {
    let marks: String = std::iter::repeat_n(opening.mark, opening.length).collect();
    let message = words!("the `{}` block is not closed", "el bloque `{}` no se cierra", opening.word);
    let diagnostic = Diagnostic::error("fence", message, span).saying(words("begins here", "empieza aquí"));
    match next {
        Some(next) => diagnostic.with_label(
            Span::new(next.start, next.end),
            words("and the next one begins inside it", "y el siguiente empieza dentro de él"),
        ),
        None => diagnostic,
    }
    .with_hint(words!("end it with a line `{marks}`", "termínalo con una línea `{marks}`"))
}

fn warn_of_near_kind(opening: &Opening, span: Span, diagnostics: &mut Vec<Diagnostic>) {
    let known = KINDS.iter().map(|(word, _)| *word);
    if let Some(near) = nearest(opening.word, known) {
        diagnostics.push(
            Diagnostic::warning(
                "unknown-fence",
                words!(
                    "a `{}` block is shown as code and means nothing else",
                    "un bloque `{}` se muestra como código y no significa nada más",
                    opening.word
                ),
                span,
            )
            .with_hint(words!("did you mean `{near}`?", "¿querías decir `{near}`?")),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn summary(source: &str) -> (Vec<String>, Vec<String>) {
        let mut diagnostics = Vec::new();
        let parts = split(source, 0..source.len(), &mut diagnostics)
            .into_iter()
            .map(|part| match part {
                Part::Prose(range) => format!("prose {:?}", &source[range]),
                Part::Fence(fence) => format!("{} {:?}", fence.kind.word(), &source[fence.content]),
            })
            .collect();
        (parts, diagnostics.into_iter().map(|d| d.message.english.into_owned()).collect())
    }

    #[test]
    fn prose_and_fences_alternate() {
        let (parts, messages) = summary("A\n```model\nx = 1\n```\nB\n~~~plots\n~~~\n```model\n```");
        assert_eq!(parts, ["prose \"A\\n\"", "model \"x = 1\\n\"", "prose \"B\\n\"", "plots \"\"", "model \"\""]);
        assert_eq!(messages, [""; 0]);
    }

    #[test]
    fn code_is_prose_even_with_fences_inside() {
        let source = "````markdown\n```model\nx = 1\n```\n````\nB";
        assert_eq!(summary(source).0, [format!("prose {source:?}")]);
    }

    #[test]
    fn an_open_fence_ends_where_the_next_begins() {
        let (parts, messages) = summary("```model\nx = 1\n```plots\ny\n```\nB");
        assert_eq!(parts, ["model \"x = 1\\n\"", "plots \"y\\n\"", "prose \"B\""]);
        assert_eq!(messages, ["the `model` block is not closed"]);
        let (parts, messages) = summary("```model\nx = 1");
        assert_eq!(parts, ["model \"x = 1\""]);
        assert_eq!(messages, ["the `model` block is not closed"]);
    }

    #[test]
    fn a_misspelt_kind_is_noticed() {
        assert_eq!(summary("```preset\n```").1, ["a `preset` block is shown as code and means nothing else"]);
        assert_eq!(summary("```python\n```").1, [""; 0]);
    }
}
