//! Edits of single plots.

use super::blocks::{insert_block, remove_block};
use super::columns::keeping_columns;
use super::layout::{self, begin_line, line_end, with_line_ends_of};
use super::lines::{exchanged, lines_around};
use super::obstacle::Obstacle;
use super::{Edit, EditError};
use crate::form::{PlotCell, PlotPart, plot_sentences, plots};
use crate::text::grammar::{HISTOGRAM, POINTS};
use crate::text::outline::{Outline, read};
use crate::{BlockKind, assist};
use model::{Phrase, Span};

/// A new plot of quantities against another one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct NewPlot {
    /// Title.
    pub title: String,
    /// Curves, separated by commas.
    pub curves: String,
    /// Expression on the abscissa.
    pub across: String,
}

/// Replaces the text of a cell of the plot with this index in [`plots`]. An empty text removes `against`, the keyword of a
/// kind, or `equal axes`. A change of kind adds the parts that the new kind needs and removes those that it cannot have:
/// `every` of points, the abscissa of a histogram. The text may contain errors, which [`crate::open()`] then reports in the
/// plot; it is refused only if it would not be parsed as this one cell.
///
/// # Errors
///
/// [`EditError::UnknownCell`], [`EditError::NotOneCell`], [`EditError::ChangesOthers`] and [`EditError::TooLong`].
pub fn set_plot(outline: &Outline, number: usize, kind: PlotCell, text: &str) -> Result<Vec<Edit>, EditError> {
    let source = outline.source();
    let parts = plots(outline);
    let part = parts.get(number).ok_or(EditError::UnknownCell)?;
    let (old, span) = part.cell(kind).ok_or(EditError::UnknownCell)?;
    let text = with_line_ends_of(source, text.trim());
    if text == old {
        return Ok(Vec::new());
    }
    let edit = match kind {
        PlotCell::Title => titled(source, &parts, part, &text),
        PlotCell::Kind => of_kind(outline, (number, part), &text)?,
        // An empty cell stands between words and needs a blank.
        PlotCell::Curves if old.is_empty() => Edit { span, text: format!("{text} ") },
        PlotCell::Curves if text.is_empty() => {
            let rest = &source[span.end..];
            let blanks = rest.len() - rest.trim_start_matches(' ').len();
            Edit { span: Span::new(span.start, span.end + blanks), text: String::new() }
        }
        PlotCell::Across if old.is_empty() || text.is_empty() => {
            let before = part.cell(PlotCell::Curves).map_or(span.start, |(_, curves)| curves.end);
            let text = if text.is_empty() { text.clone() } else { format!(" against {text}") };
            Edit { span: Span::new(before, span.end), text }
        }
        PlotCell::Equal => {
            let before =
                part.cell(PlotCell::Across).or(part.cell(PlotCell::Curves)).map_or(span.start, |(_, it)| it.end);
            let text = if text.is_empty() { String::new() } else { format!(", {text}") };
            Edit { span: Span::new(before, span.end), text }
        }
        PlotCell::Curves | PlotCell::Across | PlotCell::Text => Edit { span, text: text.clone() },
    };
    let mut expected: Vec<Vec<(PlotCell, String)>> = parts.iter().map(texts).collect();
    if let Some(cells) = expected.get_mut(number) {
        match kind {
            PlotCell::Text => cells.clear(),
            // The other cells depend on the kind.
            PlotCell::Kind => cells.retain(|(one, _)| *one == PlotCell::Title),
            _ => cells.retain(|(one, _)| *one != kind && *one != PlotCell::Text),
        }
        cells.push((kind, text.clone()));
    }
    let edits = vec![edit];
    let refusal = EditError::NotOneCell(Obstacle::of(&text, obstacles(kind)));
    expect(outline, &edits, &expected, refusal)?;
    Ok(edits)
}

/// Adds a plot after the last one. A document without plots gets a block of plots after model and drawing.
///
/// # Errors
///
/// [`EditError::NotOneCell`] if a text would not be parsed as its part of the plot, and the errors of [`insert_block`].
pub fn add_plot(outline: &Outline, plot: &NewPlot) -> Result<Edit, EditError> {
    let source = outline.source();
    let [title, curves, across] = [&plot.title, &plot.curves, &plot.across].map(|text| text.trim());
    if [title, curves, across].contains(&"") {
        return Err(EditError::NotOneCell(Obstacle::Empty));
    }
    let refusal = || {
        let cells = [(PlotCell::Title, title), (PlotCell::Curves, curves), (PlotCell::Across, across)];
        let obstacle = |(kind, text)| Some(Obstacle::of(text, obstacles(kind))).filter(|one| *one != Obstacle::Other);
        EditError::NotOneCell(cells.into_iter().find_map(obstacle).unwrap_or(Obstacle::Other))
    };
    let line = format!("\"{title}\": {curves} against {across}");
    let blocks = outline.blocks();
    let edit = match blocks.iter().rfind(|block| block.kind == BlockKind::Plots) {
        Some(last) => {
            let at = last.content.end;
            let text = format!("{}{line}{}", begin_line(source, at), line_end(source));
            Edit { span: Span::new(at, at), text }
        }
        None => {
            let is_before = |kind| matches!(kind, BlockKind::Model | BlockKind::Scene | BlockKind::Table);
            let last = blocks.iter().rposition(|block| is_before(block.kind)).or(blocks.len().checked_sub(1));
            let mut edit = insert_block(outline, last, BlockKind::Plots, &line)?;
            edit.text.insert_str(0, line_end(source));
            edit
        }
    };
    let mut expected: Vec<Vec<(PlotCell, String)>> = plots(outline).iter().map(texts).collect();
    let cells = [(PlotCell::Title, title), (PlotCell::Curves, curves), (PlotCell::Across, across)];
    expected.push(cells.map(|(kind, text)| (kind, text.to_owned())).to_vec());
    if outline.blocks_of(BlockKind::Plots).next().is_some() {
        expect(outline, std::slice::from_ref(&edit), &expected, refusal())?;
    } else if !are(&plots(&read(&layout::result(outline, std::slice::from_ref(&edit))?)), &expected) {
        return Err(refusal());
    }
    Ok(edit)
}

/// Removes the plot with this index, including the comment on its lines. The fence is removed with the last plot of a
/// block.
///
/// # Errors
///
/// [`EditError::UnknownCell`] if there is no such plot, [`EditError::ChangesOthers`].
pub fn remove_plot(outline: &Outline, number: usize) -> Result<Edit, EditError> {
    let source = outline.source();
    let parts = plots(outline);
    let part = parts.get(number).ok_or(EditError::UnknownCell)?;
    let content = outline.blocks().get(part.block).ok_or(EditError::UnknownCell)?.content;
    let lines = lines_around(source, part.span);
    let end = source[lines.end..].find('\n').map_or(source.len(), |length| lines.end + length + 1).min(content.end);
    let (before, after) = (&source[content.start..lines.start], &source[end.max(lines.end)..content.end]);
    if before.trim().is_empty() && after.trim().is_empty() {
        return remove_block(outline, part.block);
    }
    let edit = Edit { span: Span::new(lines.start, end.max(lines.end)), text: String::new() };
    let mut expected: Vec<Vec<(PlotCell, String)>> = parts.iter().map(texts).collect();
    expected.remove(number);
    expect(outline, std::slice::from_ref(&edit), &expected, EditError::ChangesOthers)?;
    Ok(edit)
}

/// Exchanges two plots, including the comments on their lines.
///
/// # Errors
///
/// [`EditError::UnknownCell`] if there is no such plot, [`EditError::ChangesOthers`].
pub fn exchange_plots(outline: &Outline, one: usize, other: usize) -> Result<Vec<Edit>, EditError> {
    let parts = plots(outline);
    let (Some(first), Some(second)) = (parts.get(one), parts.get(other)) else { return Err(EditError::UnknownCell) };
    let edits = exchanged(outline.source(), first.span, second.span);
    let mut expected: Vec<Vec<(PlotCell, String)>> = parts.iter().map(texts).collect();
    expected.swap(one, other);
    expect(outline, &edits, &expected, EditError::ChangesOthers)?;
    Ok(edits)
}

/// Characters and words that a cell of this kind must not contain.
fn obstacles(kind: PlotCell) -> &'static [&'static str] {
    match kind {
        PlotCell::Title => &["\n", "\""],
        PlotCell::Curves => &["\n", "#", "\"", "against"],
        PlotCell::Across => &["\n", "#", "\"", "equal axes"],
        PlotCell::Kind | PlotCell::Equal | PlotCell::Text => &[],
    }
}

/// Edit of the title and its colon; the rest of the line stays in its column.
fn titled(source: &str, parts: &[PlotPart], part: &PlotPart, text: &str) -> Edit {
    let head = |part: &PlotPart| {
        let (_, title) = part.cell(PlotCell::Title)?;
        let colon = source[title.end..].find(':')?;
        Some(Span::new(title.start, title.end + colon + 1))
    };
    let Some(span) = head(part) else { return Edit { span: part.span, text: text.to_owned() } };
    let title_end = part.cell(PlotCell::Title).map_or(span.end, |(_, title)| title.end);
    let edit = Edit { span, text: format!("{text}{}", &source[title_end..span.end]) };
    keeping_columns(source, edit, parts.iter().filter(|other| other.block == part.block).filter_map(head))
}

/// Edit that changes the kind of the plot with this index, from the keyword of the kind to the end.
fn of_kind(outline: &Outline, (number, part): (usize, &PlotPart), kind: &str) -> Result<Edit, EditError> {
    let source = outline.source();
    let (_, sentence) = plot_sentences(outline).nth(number).ok_or(EditError::UnknownCell)?;
    let (curves, _) = part.cell(PlotCell::Curves).ok_or(EditError::UnknownCell)?;
    let (_, old) = part.cell(PlotCell::Kind).ok_or(EditError::UnknownCell)?;
    let span = Span::new(old.start, sentence.span.end);
    let written = |phrase: Phrase| &source[phrase.span().range()];
    if kind == HISTOGRAM {
        let first =
            sentence.phrases().next().map(|first| first.split_last(&["against"]).map_or(first, |one| one.before));
        return Ok(Edit { span, text: format!("{HISTOGRAM} {}", first.map_or("", written)) });
    }
    let drawn = sentence.phrases().filter_map(|phrase| phrase.split_last(&["against"])).next_back();
    let own = part.cell(PlotCell::Across).map(|(across, _)| across);
    let (name, unit) = assist::independent(outline);
    let across = own.filter(|across| !across.is_empty()).unwrap_or(&name);
    let phrase = drawn.filter(|_| own.is_some()).map(|against| against.after);
    let moments = phrase.and_then(|phrase| phrase.split_last(&["every"]).or_else(|| phrase.split_last(&["at"])));
    let over_values = phrase.is_some_and(|phrase| phrase.split_last(&["in", "for"]).is_some());
    let across = match moments {
        None if kind == POINTS && !over_values => {
            let unit = if unit.is_empty() { unit } else { format!(" [{unit}]") };
            format!("{across} every 1{unit}")
        }
        Some(moments) if kind != POINTS => written(moments.before).to_owned(),
        _ => across.to_owned(),
    };
    let across = if own.is_none() && drawn.is_some() { String::new() } else { format!(" against {across}") };
    let word = if kind.is_empty() { String::new() } else { format!("{kind} ") };
    let equal = part.cell(PlotCell::Equal).map_or("", |(equal, _)| equal);
    let equal = if equal.is_empty() { String::new() } else { format!(", {equal}") };
    Ok(Edit { span, text: format!("{word}{curves}{across}{equal}") })
}

/// Cells of a plot without their places, or the whole text if it has no cells.
fn texts(part: &PlotPart) -> Vec<(PlotCell, String)> {
    let whole = (PlotCell::Text, part.whole.clone());
    part.cells
        .iter()
        .map(|(kind, text, _)| (*kind, text.clone()))
        .chain(part.cells.is_empty().then_some(whole))
        .collect()
}

fn are(parts: &[PlotPart], expected: &[Vec<(PlotCell, String)>]) -> bool {
    let has = |part: &PlotPart, kind, text: &String| part.cell(kind).is_some_and(|(own, _)| own == text);
    let is =
        |(part, cells): (&PlotPart, &Vec<(PlotCell, String)>)| cells.iter().all(|(kind, text)| has(part, *kind, text));
    parts.len() == expected.len() && parts.iter().zip(expected).all(is)
}

/// Requires that edits change only plots and turn them into `expected`.
fn expect(
    outline: &Outline,
    edits: &[Edit],
    expected: &[Vec<(PlotCell, String)>],
    refusal: EditError,
) -> Result<(), EditError> {
    let is_plots = |_, kind| kind == BlockKind::Plots;
    layout::expect(outline, edits, is_plots, |after| are(&plots(after), expected), refusal)
}
