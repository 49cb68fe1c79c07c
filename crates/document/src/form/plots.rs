//! Form view of the plots of a document. Cells are nodes of the syntax tree, which exist while a cell has errors.

use crate::BlockKind;
use crate::text::grammar::HISTOGRAM;
use crate::text::outline::Outline;
use crate::text::source::{trim, trimmed};
use model::{Sentence, Span};
use std::ops::Range;

/// Kind of cell of a plot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum PlotCell {
    /// Title, without quotation marks.
    Title,
    /// Keyword before the curves: `points`, `histogram`, or empty.
    Kind,
    /// Curves; in a plot with several abscissas, including these.
    Curves,
    /// Abscissa with its options: `t`, `x every 2 [s]`, `omega in 1..12`.
    Across,
    /// `equal axes`, or empty.
    Equal,
    /// The whole plot.
    Text,
}

/// A plot in a form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlotPart {
    /// Index of its block in [`Outline::blocks`].
    pub block: usize,
    /// Place without the comment.
    pub span: Span,
    /// The whole text.
    pub whole: String,
    /// Cells with their texts and places, in the order of [`PlotCell`]; none if the plot has no title and colon. A
    /// histogram and a plot with several abscissas have no [`PlotCell::Across`].
    pub cells: Vec<(PlotCell, String, Span)>,
}

impl PlotPart {
    /// Text and place of a cell.
    pub fn cell(&self, kind: PlotCell) -> Option<(&str, Span)> {
        if kind == PlotCell::Text {
            return Some((&self.whole, self.span));
        }
        self.cells.iter().find(|(own, ..)| *own == kind).map(|(_, text, span)| (text.as_str(), *span))
    }
}

/// Plots of a document, in text order.
pub fn plots(outline: &Outline) -> Vec<PlotPart> {
    let source = outline.source();
    let part = |(block, sentence): (usize, &Sentence)| PlotPart {
        block,
        span: sentence.span,
        whole: source[sentence.span.range()].to_owned(),
        cells: cells(source, sentence).unwrap_or_default(),
    };
    sentences(outline).map(part).collect()
}

/// Plots of a document in the syntax tree, each with the index of its block.
pub(crate) fn sentences<'a>(outline: &'a Outline) -> impl Iterator<Item = (usize, &'a Sentence)> {
    let blocks = outline.blocks().iter().enumerate().filter(|(_, block)| block.kind == BlockKind::Plots);
    blocks.flat_map(|(number, block)| block.sentences.iter().map(move |sentence| (number, sentence)))
}

fn cells(source: &str, sentence: &Sentence) -> Option<Vec<(PlotCell, String, Span)>> {
    let title = sentence.title.filter(|_| sentence.colon.is_some())?;
    let body = sentence.body;
    let kind = sentence.kind.map_or(Span::new(body.start, body.start), |kind| kind.span);
    let mut cells = Vec::new();
    let mut add = |kind, span: Span| cells.push((kind, source[span.range()].to_owned(), span));
    add(PlotCell::Title, Span::new(title.start + 1, title.end - 1));
    add(PlotCell::Kind, kind);
    if sentence.kind.is_some_and(|kind| kind.word == HISTOGRAM) {
        add(PlotCell::Curves, body);
        return Some(cells);
    }
    let drawn = sentence.listed();
    let spanned = |range: Range<usize>| Span::new(range.start, range.end);
    let mut abscissas = sentence.phrases().filter_map(|phrase| phrase.split_last(&["against"]));
    match (abscissas.next_back(), abscissas.next_back()) {
        (Some(against), None) => {
            let [before, after] = [drawn.start..against.keyword.span.start, against.keyword.span.end..drawn.end];
            add(PlotCell::Curves, spanned(trimmed(source, before)));
            add(PlotCell::Across, spanned(trim(source, after)));
        }
        (None, _) => {
            add(PlotCell::Curves, drawn);
            add(PlotCell::Across, drawn.after());
        }
        _ => add(PlotCell::Curves, drawn),
    }
    add(PlotCell::Equal, sentence.ending.unwrap_or(drawn.after()));
    Some(cells)
}
