//! Columns: in neighbouring lines of one kind, what they have in common stands below one another - equals signs, units, ranges,
//! labels.
//!
//! Where a column stands follows from the tokens alone and not from the blanks that are found, so a layout is reached in one step
//! whoever wrote the text.

use super::cells::{Cell, width};
use super::gaps::Gap;
use super::line::Line;
use super::roles::Role;
use std::ops::RangeInclusive;

/// What lines are in the same columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// `parameter k = 4 [N/m] in 1..9 step 1 "Stiffness"`
    Parameter,
    /// `T = 2*pi*sqrt(m/k) in [s] "Period"`, `y(0) = 1 [m]`
    Definition,
    /// `x' = -k*x`
    Rate,
    /// `"Mercury": rho = 13534 [kg/m^3]`
    Titled,
    /// `"Mercury" = "Mercurio"`
    Translated,
    /// A comment alone, which ends no group.
    Comment,
    /// Anything else.
    Other,
}

/// A column of a kind of line, in their order from left to right.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Column {
    Titled,
    Equals,
    Unit,
    In,
    Step,
    For,
    Label,
    Comment,
}

const COLUMNS: [Column; 8] = [
    Column::Titled,
    Column::Equals,
    Column::Unit,
    Column::In,
    Column::Step,
    Column::For,
    Column::Label,
    Column::Comment,
];

/// Sets the blanks before all cells but the first ones of their lines.
pub(super) fn align(lines: &mut [Line]) {
    let kinds: Vec<Kind> = lines.iter().map(kind).collect();
    let mut start = 0;
    while start < lines.len() {
        if matches!(kinds[start], Kind::Comment | Kind::Other) {
            start += 1;
        } else {
            let end = end_of_group(lines, &kinds, start);
            align_group(&mut lines[start..end], &kinds[start..end]);
            start = end;
        }
    }
}

/// Where the lines end that are in the columns of the first one: at a blank line or at another kind. Comments and the further
/// lines of a statement, which are indented, stand between them.
fn end_of_group(lines: &[Line], kinds: &[Kind], start: usize) -> usize {
    let goes_on = |index: usize| {
        let (line, first) = (&lines[index], &lines[start]);
        line.paragraph == first.paragraph
            && (kinds[index] == Kind::Comment
                || line.indented > first.indented
                || kinds[index] == kinds[start] && line.indented == first.indented)
    };
    (start + 1..lines.len()).find(|&index| !goes_on(index)).unwrap_or(lines.len())
}

fn kind(line: &Line) -> Kind {
    let cells = line.cells.as_slice();
    match cells {
        [comment] if comment.role == Role::Comment => Kind::Comment,
        [title, colon, ..] if title.role == Role::Text && colon.role == Role::Colon => Kind::Titled,
        [text, equals, ..] if text.role == Role::Text && is_equals(equals) => Kind::Translated,
        [word, ..] if word.role != Role::Text && !is_function(cells) => match cells.iter().position(is_equals) {
            Some(at) if is_defined(&cells[..at]) && word.text == "parameter" => Kind::Parameter,
            Some(at) if is_defined(&cells[..at]) && is_rate(&cells[..at]) => Kind::Rate,
            Some(at) if is_defined(&cells[..at]) => Kind::Definition,
            _ => Kind::Other,
        },
        _ => Kind::Other,
    }
}

/// Whether a derivative stands before the equals sign, and no value at the start.
fn is_rate(cells: &[Cell]) -> bool {
    cells.last().is_some_and(|cell| cell.text.ends_with('\''))
}

/// `function f(x) = ...`, possibly after another word.
fn is_function(cells: &[Cell]) -> bool {
    cells.iter().take(2).any(|cell| cell.text == "function")
}

fn is_equals(cell: &Cell) -> bool {
    cell.role == Role::Operator && cell.text == "="
}

/// Whether a name alone stands before the equals sign, possibly with primes, an index or the place of a value at the start.
fn is_defined(cells: &[Cell]) -> bool {
    !cells.iter().any(|cell| matches!(cell.role, Role::Operator | Role::Tight | Role::Sign | Role::Brace))
}

/// The cell of a line that begins each of its columns.
fn columns(line: &Line, kind: Kind) -> Vec<(Column, usize)> {
    let mut found: Vec<(Column, usize)> = Vec::new();
    let mut depth = 0_usize;
    for (index, cell) in line.cells.iter().enumerate() {
        match cell.role {
            Role::Opening => depth += 1,
            Role::Closing => depth = depth.saturating_sub(1),
            _ => {}
        }
        let before = index.checked_sub(1).map(|before| &line.cells[before]);
        let Some(column) = before.filter(|_| depth == 0).and_then(|before| column(before, cell, kind)) else {
            continue;
        };
        // What stands on the right of a column in another order, as the `in` of `for k in 1..9`, is in none.
        if found.last().is_none_or(|(last, _)| *last < column) {
            found.push((column, index));
        }
    }
    found
}

fn column(before: &Cell, cell: &Cell, kind: Kind) -> Option<Column> {
    if matches!(cell.gap, Gap::None | Gap::Exact) {
        return None;
    }
    match (kind, cell.role) {
        (_, Role::Comment) => Some(Column::Comment),
        (Kind::Titled, _) => (before.role == Role::Colon).then_some(Column::Titled),
        (Kind::Translated, _) => is_equals(cell).then_some(Column::Equals),
        (_, Role::Text) if before.role != Role::Operator => Some(Column::Label),
        (Kind::Parameter, Role::Brackets) if before.role == Role::Number => Some(Column::Unit),
        _ if is_equals(cell) => Some(Column::Equals),
        (_, Role::Keyword | Role::Name) => match &*cell.text {
            "in" => Some(Column::In),
            "step" => Some(Column::Step),
            "for" => Some(Column::For),
            _ => None,
        },
        _ => None,
    }
}

/// Sets the columns of lines one after the other, from left to right, so that all before one of them is where it will be.
fn align_group(lines: &mut [Line], kinds: &[Kind]) {
    let first = lines.first().map(|line| (kinds[0], line.indented));
    let is_member = |line: &Line, kind: Kind| first == Some((kind, line.indented));
    let found = lines
        .iter()
        .zip(kinds)
        .map(|(line, kind)| if is_member(line, *kind) { columns(line, *kind) } else { Vec::new() });
    let found: Vec<Vec<(Column, usize)>> = found.collect();
    for column in COLUMNS {
        let cell = |number: usize| found[number].iter().find(|(found, _)| *found == column).map(|(_, cell)| *cell);
        let members: Vec<(usize, usize, usize)> = (0..lines.len())
            .filter_map(|number| cell(number).map(|cell| (number, cell, end_before(&lines[number], cell))))
            .collect();
        let ends = reach(members.iter().map(|(.., end)| *end).collect(), widest(column));
        for (number, cell, end) in members {
            lines[number].cells[cell].blanks = blanks(column) + if ends.contains(&end) { ends.end() - end } else { 0 };
        }
    }
}

/// How many blanks stand before a column at least.
fn blanks(column: Column) -> usize {
    if column == Column::Label { 2 } else { 1 }
}

/// How many blanks a column may put into a line. Where lines differ by more, the column is that of most of them, and the others
/// are not in it.
fn widest(column: Column) -> usize {
    if column == Column::Equals { 16 } else { 48 }
}

/// From the shortest to the longest of as many lines as are in one column, by the places where they end.
fn reach(mut ends: Vec<usize>, widest: usize) -> RangeInclusive<usize> {
    ends.sort_unstable();
    let mut most = (0, 0..=0);
    for (first, &start) in ends.iter().enumerate() {
        let count = ends[first..].iter().take_while(|end| **end <= start + widest).count();
        if count > most.0 {
            most = (count, start..=ends[first + count - 1]);
        }
    }
    most.1
}

/// The column of text in which the cell before this one ends.
fn end_before(line: &Line, cell: usize) -> usize {
    line.indented + line.cells[..cell].iter().map(|cell| cell.blanks + width(&cell.text)).sum::<usize>()
}
