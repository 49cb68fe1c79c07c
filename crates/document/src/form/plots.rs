//! Form view of the plots of a document. Cells are found in the text, so that a cell can have errors while it is edited.

use crate::BlockKind;
use crate::blocks::plots::{POINTS, begins_with, is_equal_axes};
use crate::blocks::profiles::HISTOGRAM;
use crate::text::outline::Outline;
use crate::text::scan::{find_any_word, leading_text, split, statements};
use crate::text::source::{trim, trimmed};
use model::Span;
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
    let blocks = outline.blocks().iter().enumerate().filter(|(_, block)| block.kind == BlockKind::Plots);
    let written = blocks.flat_map(|(number, block)| {
        statements(source, block.content.range()).into_iter().map(move |statement| (number, statement))
    });
    let part = |(block, statement): (usize, Range<usize>)| PlotPart {
        block,
        span: Span::new(statement.start, statement.end),
        whole: source[statement.clone()].to_owned(),
        cells: cells(source, statement).unwrap_or_default(),
    };
    written.map(part).collect()
}

fn cells(source: &str, statement: Range<usize>) -> Option<Vec<(PlotCell, String, Span)>> {
    let (title, end) = leading_text(source, statement.clone())?;
    let title_at = statement.start + 1;
    let after = trim(source, end..statement.end);
    source[after.clone()].starts_with(':').then_some(())?;
    let body = trim(source, after.start + 1..after.end);
    // The range of a blank text is its end.
    let body = if body.is_empty() { after.end..after.end } else { body };
    let word = [HISTOGRAM, POINTS].into_iter().find(|word| begins_with(word, &source[body.clone()]));
    let drawn = trim(source, body.start + word.map_or(0, str::len)..body.end);
    let mut parts = split(source, drawn.clone(), ',');
    let equal = parts.pop_if(|part| is_equal_axes(&source[part.clone()])).filter(|_| word != Some(HISTOGRAM));
    let end = match &equal {
        Some(equal) => drawn.start + source[drawn.start..equal.start].trim_end().trim_end_matches(',').trim_end().len(),
        None => drawn.end,
    };
    let drawn = drawn.start..end.max(drawn.start);
    let against = find_any_word(source, drawn.clone(), "against").filter(|_| word != Some(HISTOGRAM));
    let earlier = against.as_ref().and_then(|against| find_any_word(source, drawn.start..against.start, "against"));
    let mut cells = Vec::new();
    let mut add = |kind, range: Range<usize>| {
        cells.push((kind, source[range.clone()].to_owned(), Span::new(range.start, range.end)));
    };
    add(PlotCell::Title, title_at..title_at + title.len());
    add(PlotCell::Kind, body.start..body.start + word.map_or(0, str::len));
    match against.filter(|_| earlier.is_none()) {
        Some(against) => {
            add(PlotCell::Curves, trimmed(source, drawn.start..against.start));
            let across = trim(source, against.end..drawn.end);
            add(PlotCell::Across, if across.is_empty() { drawn.end..drawn.end } else { across });
        }
        None => {
            add(PlotCell::Curves, drawn.clone());
            if earlier.is_none() && word != Some(HISTOGRAM) {
                add(PlotCell::Across, drawn.end..drawn.end);
            }
        }
    }
    if word != Some(HISTOGRAM) {
        add(PlotCell::Equal, equal.map_or(drawn.end..drawn.end, |equal| trim(source, equal)));
    }
    Some(cells)
}
