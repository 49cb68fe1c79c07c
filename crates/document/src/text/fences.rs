//! Boundaries of the blocks of a document.

use super::block::{Block, BlockKind, Fence};
use super::source::{Line, lines};
use model::{Diagnostic, Span};
use std::ops::Range;
use units::alphabet::plain;
use units::{nearest, words};

/// Other names of kinds of blocks, in Spanish and English, without accents.
const OTHER_WORDS: [(&str, BlockKind); 36] = [
    ("models", BlockKind::Model),
    ("modelo", BlockKind::Model),
    ("modelos", BlockKind::Model),
    ("ecuaciones", BlockKind::Model),
    ("equations", BlockKind::Model),
    ("tables", BlockKind::Table),
    ("tabla", BlockKind::Table),
    ("tablas", BlockKind::Table),
    ("scenes", BlockKind::Scene),
    ("escena", BlockKind::Scene),
    ("dibujo", BlockKind::Scene),
    ("drawing", BlockKind::Scene),
    ("plot", BlockKind::Plots),
    ("figure", BlockKind::Plots),
    ("figures", BlockKind::Plots),
    ("graph", BlockKind::Plots),
    ("graphs", BlockKind::Plots),
    ("charts", BlockKind::Plots),
    ("grafica", BlockKind::Plots),
    ("graficas", BlockKind::Plots),
    ("grafico", BlockKind::Plots),
    ("graficos", BlockKind::Plots),
    ("preset", BlockKind::Presets),
    ("ajustes", BlockKind::Presets),
    ("questions", BlockKind::Question),
    ("pregunta", BlockKind::Question),
    ("preguntas", BlockKind::Question),
    ("surveys", BlockKind::Survey),
    ("encuesta", BlockKind::Survey),
    ("encuestas", BlockKind::Survey),
    ("checks", BlockKind::Check),
    ("comprobacion", BlockKind::Check),
    ("comprobaciones", BlockKind::Check),
    ("translation", BlockKind::Translations),
    ("traduccion", BlockKind::Translations),
    ("traducciones", BlockKind::Translations),
];

/// The opening line of any fence.
struct Opening<'a> {
    mark: char,
    length: usize,
    word: &'a str,
    /// The word after it.
    second: &'a str,
}

impl<'a> Opening<'a> {
    /// Opening line by the rule of CommonMark: at most three blanks, at least three marks, and no backquote after
    /// backquotes.
    fn read(line: &'a str) -> Option<Self> {
        // Fast rejection, because most lines are not fences and each is checked several times.
        if !matches!(line.as_bytes().first(), Some(b' ' | b'`' | b'~')) {
            return None;
        }
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
        let mut words = info.split_whitespace();
        let [word, second] = [words.next(), words.next()].map(Option::unwrap_or_default);
        Some(Self { mark, length, word, second })
    }

    fn kind(&self) -> Option<BlockKind> {
        if matches!(self.word, "smooth" | "steps") && self.second == "table" {
            return Some(BlockKind::Table);
        }
        BlockKind::FENCED.into_iter().find(|kind| kind.word() == self.word).or_else(|| self.meant())
    }

    /// Kind that another word means.
    fn meant(&self) -> Option<BlockKind> {
        let word = plain(self.word);
        OTHER_WORDS.iter().find(|(other, _)| *other == word).map(|(_, kind)| *kind)
    }

    fn is_closed_by(&self, line: &str) -> bool {
        Opening::read(line)
            .is_some_and(|other| other.mark == self.mark && other.length >= self.length && other.word.is_empty())
    }
}

/// Splits `range` of `source` into blocks. The statements of models are not parsed.
pub fn split(source: &str, range: Range<usize>, diagnostics: &mut Vec<Diagnostic>) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut prose = range.start;
    let mut rest = lines(source, range.clone()).peekable();
    while let Some(line) = rest.next() {
        let Some(opening) = Opening::read(line.text(source)) else {
            continue;
        };
        let span = Span::new(line.start, line.end);
        let Some(kind) = opening.kind() else {
            warn_of_near_kind(source, &opening, span, diagnostics);
            // A block of code belongs to the prose, and its content is skipped.
            while rest.next_if(|line| !opening.is_closed_by(line.text(source))).is_some() {}
            rest.next();
            continue;
        };
        if opening.meant().is_some_and(|kind| kind.word() != opening.word) {
            diagnostics.push(other_word(source, &opening, span, kind));
        }
        if prose < line.start {
            blocks.push(Block::prose(Span::new(prose, line.start)));
        }
        let mut content = Span::new(line.next, line.next);
        while let Some(inner) = rest.next_if(|inner| !ends_inside(source, &opening, inner)) {
            content.end = inner.next;
        }
        let closing = rest.next_if(|closing| opening.is_closed_by(closing.text(source)));
        if closing.is_none() {
            diagnostics.push(unclosed(&opening, span, rest.peek()));
        }
        prose = closing.map_or(content.end, |closing| closing.next);
        blocks.push(Block {
            kind,
            span: Span::new(line.start, prose),
            content,
            fence: Some(Fence { opening: span, closing: closing.map(|line| Span::new(line.start, line.end)) }),
            statements: Vec::new(),
            sentences: Vec::new(),
        });
    }
    if prose < range.end {
        blocks.push(Block::prose(Span::new(prose, range.end)));
    }
    blocks
}

/// Number of backquotes for a fence that no line of `content` can close; at least 3.
pub fn safe_length(content: &str) -> usize {
    let lines = lines(content, 0..content.len()).filter_map(|line| Opening::read(line.text(content)));
    lines.filter(|fence| fence.mark == '`').map(|fence| fence.length + 1).max().unwrap_or(3)
}

/// True if the block ends before this line: the line closes the fence, or opens another block because the closing line is
/// missing.
fn ends_inside(source: &str, opening: &Opening, line: &Line) -> bool {
    let text = line.text(source);
    opening.is_closed_by(text)
        || Opening::read(text)
            .is_some_and(|next| next.kind().is_some() && next.mark == opening.mark && next.length >= opening.length)
}

fn unclosed(opening: &Opening, span: Span, next: Option<&Line>) -> Diagnostic {
    let marks: String = std::iter::repeat_n(opening.mark, opening.length).collect();
    let message = words!("the `{}` block is not closed", opening.word);
    let diagnostic = Diagnostic::error("fence", message, span).saying(words("begins here"));
    match next {
        Some(next) => {
            diagnostic.with_label(Span::new(next.start, next.end), words("and the next one begins inside it"))
        }
        None => diagnostic,
    }
    .with_hint(words!("end it with a line `{marks}`"))
}

/// Reports a block with another name of a kind. It is read as that kind, to avoid errors that follow from the first.
fn other_word(source: &str, opening: &Opening, span: Span, kind: BlockKind) -> Diagnostic {
    let (written, ours) = (opening.word, kind.word());
    let message = words!("there is no block `{written}`: this one is called `{ours}`");
    let at = span.start + source[span.range()].find(written).unwrap_or_default();
    let place = Span::new(at, at + written.len());
    Diagnostic::error("unknown-fence", message, place).with_hint(words!("write `{ours}`")).with_fix(place, ours)
}

fn warn_of_near_kind(source: &str, opening: &Opening, span: Span, diagnostics: &mut Vec<Diagnostic>) {
    let known = BlockKind::FENCED.map(BlockKind::word);
    if let Some(near) = nearest(opening.word, known) {
        let message = words!("a `{}` block is shown as code and means nothing else", opening.word);
        let hint = words!("did you mean `{near}`?");
        let mut diagnostic = Diagnostic::warning("unknown-fence", message, span).with_hint(hint);
        if let Some(at) = source[span.range()].find(opening.word).map(|at| span.start + at) {
            diagnostic = diagnostic.with_fix(Span::new(at, at + opening.word.len()), near);
        }
        diagnostics.push(diagnostic);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn summary(source: &str) -> (Vec<String>, Vec<String>) {
        let mut diagnostics = Vec::new();
        let blocks = split(source, 0..source.len(), &mut diagnostics)
            .into_iter()
            .map(|block| format!("{} {:?}", block.kind.word(), &source[block.content.range()]))
            .collect();
        (blocks, diagnostics.into_iter().map(|d| d.message.english()).collect())
    }

    #[test]
    fn prose_and_fences_alternate() {
        let (blocks, messages) = summary("A\n```model\nx = 1\n```\nB\n~~~plots\n~~~\n```model\n```");
        assert_eq!(blocks, ["prose \"A\\n\"", "model \"x = 1\\n\"", "prose \"B\\n\"", "plots \"\"", "model \"\""]);
        assert_eq!(messages, [""; 0]);
    }

    #[test]
    fn code_is_prose_even_with_fences_inside() {
        let source = "````markdown\n```model\nx = 1\n```\n````\nB";
        assert_eq!(summary(source).0, [format!("prose {source:?}")]);
    }

    #[test]
    fn an_open_fence_ends_where_the_next_begins() {
        let (blocks, messages) = summary("```model\nx = 1\n```plots\ny\n```\nB");
        assert_eq!(blocks, ["model \"x = 1\\n\"", "plots \"y\\n\"", "prose \"B\""]);
        assert_eq!(messages, ["the `model` block is not closed"]);
        let (blocks, messages) = summary("```model\nx = 1");
        assert_eq!(blocks, ["model \"x = 1\""]);
        assert_eq!(messages, ["the `model` block is not closed"]);
    }

    #[test]
    fn a_block_with_another_word_is_read_as_it_is_meant() {
        for word in ["gráficas", "Gráficas", "graficas", "figures", "plot"] {
            let (blocks, messages) = summary(&format!("```{word}\ny\n```"));
            assert_eq!(blocks, ["plots \"y\\n\""], "{word}");
            assert_eq!(messages, [format!("there is no block `{word}`: this one is called `plots`")]);
        }
    }

    #[test]
    fn a_misspelt_kind_is_noticed() {
        assert_eq!(summary("```presest\n```").1, ["a `presest` block is shown as code and means nothing else"]);
        assert_eq!(summary("```python\n```").1, [""; 0]);
    }
}
