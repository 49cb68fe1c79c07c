//! Cells of a statement that is a row of a form. They are nodes of the syntax tree, which exist while a cell has errors.

use crate::text::source::{trim, trimmed};
use model::{ExpressionKind, Grammar, Phrase, Span, Statement, StatementKind, lexemes, sentence};
use std::ops::Range;

/// Kind of cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CellKind {
    /// The name of a parameter, or the left side of an initial value.
    Name,
    /// Default value of a parameter, or initial value.
    Value,
    /// The unit, without its brackets.
    Unit,
    /// `LOW..HIGH`
    Range,
    /// The step of the slider.
    Step,
    /// The label, without its quotation marks.
    Label,
    /// Text of a statement that is not a row.
    Text,
}

/// An editable part of a statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Kind of cell.
    pub kind: CellKind,
    /// Text; empty if the statement has no such part.
    pub text: String,
    /// Place of the text, or of its insertion if it is empty.
    pub span: Span,
    /// The span including keyword, brackets or quotation marks and the blanks before them.
    pub outer: Span,
}

impl Cell {
    /// The whole text of a statement.
    pub(super) fn whole(source: &str, span: Span) -> Self {
        Self { kind: CellKind::Text, text: source[span.range()].to_owned(), span, outer: span }
    }

    fn of(source: &str, kind: CellKind, text: Range<usize>, outer: Range<usize>) -> Self {
        let span = Span::new(text.start, text.end);
        Self { kind, text: source[text].to_owned(), span, outer: Span::new(outer.start, outer.end) }
    }
}

/// Keyword and cells of a statement that is a row of a form; `None` for other statements. A row is a single line with plain
/// quotation marks.
pub(super) fn row(source: &str, statement: &Statement) -> Option<(String, Vec<Cell>)> {
    let all = statement.span.range();
    let text = &source[all.clone()];
    if text.contains(['\n', '“', '”', '«', '»', '#']) || !statement.over.is_empty() {
        return None;
    }
    if let Some(name) = group_name(source, statement) {
        return Some((GROUP.to_owned(), vec![name]));
    }
    let all = all.start + hidden_length(text)..all.end;
    let text = &source[all.clone()];
    let word = ["parameter", "switch", "random", "size", "discrete"].into_iter().find(|word| begins_with(text, word));
    let is_start = match &statement.kind {
        StatementKind::InitialValue { .. } | StatementKind::Discrete { .. } => true,
        StatementKind::Equation { left, .. } => {
            left.kind == ExpressionKind::Error && (word == Some("discrete") || begins_as_initial_value(text))
        }
        StatementKind::Parameter(_) | StatementKind::Size(_) => word.is_none(),
        _ => return None,
    };
    let word = word.unwrap_or_default();
    if !is_start && word.is_empty() {
        return None;
    }
    let equals = begins_lexeme(source, &all, "=")?;
    let name = trim(source, all.start + word.len()..equals);
    let after = equals + 1 + usize::from(source[equals + 1..all.end].starts_with(' '));
    let quote = begins_lexeme(source, &(after..all.end), "\"");
    let body = after..quote.unwrap_or(all.end);
    let clauses: &'static [&'static str] = match word {
        _ if is_start => &["in"],
        "parameter" => &["in", "step", "assigned"],
        "switch" => &[],
        _ => &["in"],
    };
    let written = sentence(source, body.clone(), &Grammar { clauses, is_list: false, ..Grammar::LIST });
    let phrase = written.phrases().next()?;
    let mut cells = vec![Cell::of(source, CellKind::Name, name.clone(), name)];
    if is_start {
        cells.extend(of_start(source, &body, phrase));
    } else {
        // The assigned values are edited in the text.
        let assigned = phrase.split_last(&["assigned"]);
        let own = body.start..assigned.map_or(body.end, |assigned| assigned.keyword.span.start);
        let phrase = assigned.map_or(phrase, |assigned| assigned.before);
        cells.extend(of_parameter(source, &own, phrase, clauses));
    }
    let end = trimmed_end(source, &body);
    cells.push(match quote {
        Some(quote) => {
            let inside = quote + 1..source[quote + 1..all.end].find('"').map_or(all.end, |at| quote + 1 + at);
            Cell::of(source, CellKind::Label, inside, end..all.end)
        }
        None => Cell::of(source, CellKind::Label, end..end, end..end),
    });
    Some((word.to_owned(), cells))
}

const GROUP: &str = "group";

/// The name in `group "Circuit"`, or the place of its insertion.
fn group_name(source: &str, statement: &Statement) -> Option<Cell> {
    let all = trim(source, statement.span.range());
    let rest = source[all.clone()].strip_prefix(GROUP)?;
    let inside = rest.trim_start().strip_prefix('"');
    match inside {
        Some(inside) => {
            let start = all.end - inside.len();
            let end = inside.find('"').map_or(all.end, |at| start + at);
            Some(Cell::of(source, CellKind::Label, start..end, all.start + GROUP.len()..all.end))
        }
        None => rest.is_empty().then(|| Cell::of(source, CellKind::Label, all.end..all.end, all.end..all.end)),
    }
}

/// Byte at which the first lexeme of `range` begins that begins with `mark`.
fn begins_lexeme(source: &str, range: &Range<usize>, mark: &str) -> Option<usize> {
    let lexemes = lexemes(source, range.clone());
    lexemes.iter().find(|lexeme| lexeme.text(source).starts_with(mark)).map(|lexeme| lexeme.span.start)
}

/// Place of the last keyword `word`.
fn keyword(phrase: Phrase, word: &str) -> Option<Range<usize>> {
    phrase.split_last(&[word]).map(|split| split.keyword.span.range())
}

/// Cells of a parameter: value, and as far as it can have them unit, range and step. `clauses`: the keywords of its parts.
fn of_parameter(source: &str, body: &Range<usize>, phrase: Phrase, clauses: &[&str]) -> Vec<Cell> {
    let [has_range, has_step] = ["in", "step"].map(|word| clauses.contains(&word));
    let (range, step) = (keyword(phrase, "in"), keyword(phrase, "step"));
    let first = |after: usize| {
        let starts = [&range, &step].into_iter().flatten().map(|word| word.start).filter(|start| *start >= after);
        starts.min().unwrap_or(body.end)
    };
    let head = body.start..first(body.start);
    // Only a number with a slider has a unit.
    let bracket = begins_lexeme(source, &head, "[").filter(|_| has_step);
    let value = trimmed(source, head.start..bracket.unwrap_or(head.end));
    let mut end = value.end;
    let mut cells = vec![Cell::of(source, CellKind::Value, value.clone(), value)];
    if has_step {
        cells.push(unit(source, bracket, end, head.end));
        end = bracket.map_or(end, |_| trimmed_end(source, &head));
    }
    let mut part = |kind, word: Option<Range<usize>>, wanted: bool| {
        if !wanted {
            return;
        }
        cells.push(match word {
            Some(word) => {
                let whole = word.start..first(word.end);
                let inside = trim(source, word.end..whole.end);
                let before = trimmed_end(source, &(body.start..word.start));
                end = end.max(trimmed_end(source, &whole));
                Cell::of(source, kind, inside, before..trimmed_end(source, &whole))
            }
            None => Cell::of(source, kind, end..end, end..end),
        });
    };
    part(CellKind::Range, range.clone(), has_range);
    part(CellKind::Step, step.clone(), has_step);
    cells
}

/// Cells of a quantity with an initial value: value and unit.
fn of_start(source: &str, body: &Range<usize>, phrase: Phrase) -> Vec<Cell> {
    let stated = keyword(phrase, "in");
    let value = trimmed(source, body.start..stated.as_ref().map_or(body.end, |word| word.start));
    let bracket = stated.as_ref().and_then(|word| source[word.end..body.end].find('[').map(|at| word.end + at));
    let end = value.end;
    vec![Cell::of(source, CellKind::Value, value.clone(), value), unit(source, bracket, end, body.end)]
}

/// Cell of the unit whose bracket opens at byte `bracket`. `before`: end of the preceding text.
fn unit(source: &str, bracket: Option<usize>, before: usize, until: usize) -> Cell {
    let Some(open) = bracket else {
        return Cell::of(source, CellKind::Unit, before..before, before..before);
    };
    let inside = open + 1..source[open..until].find(']').map_or(until, |at| open + at);
    Cell::of(source, CellKind::Unit, inside, before..trimmed_end(source, &(before..until)))
}

/// Length in bytes of `hidden` and the blanks after it, at the beginning of a statement; 0 if it has none.
fn hidden_length(text: &str) -> usize {
    let rest = text.strip_prefix("hidden").unwrap_or(text);
    if rest.starts_with([' ', '\t']) { text.len() - rest.trim_start().len() } else { 0 }
}

fn begins_with(text: &str, word: &str) -> bool {
    let rest = text.strip_prefix(word).unwrap_or_default();
    let blank = rest.len() - rest.trim_start_matches([' ', '\t']).len();
    blank > 0
        && (word == "parameter"
            || rest.trim_start().starts_with(|letter: char| letter.is_alphabetic() || letter == '_'))
}

/// True for `y'(0) =`.
fn begins_as_initial_value(text: &str) -> bool {
    let left = text.split('=').next().unwrap_or_default().trim_end();
    left.strip_suffix("(0)").is_some_and(|name| !name.is_empty() && !name.contains([' ', '(', '[']))
}

/// End of a range without trailing blanks.
fn trimmed_end(source: &str, range: &Range<usize>) -> usize {
    range.start + source[range.clone()].trim_end().len()
}
