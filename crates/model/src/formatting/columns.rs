//! Alignment in columns: equals signs, units, ranges and labels of neighbouring lines of one kind stand below one another.
//!
//! Columns depend on the tokens alone, not on the existing blanks. So formatting is idempotent and independent of the
//! original layout.

use super::cells::{Cell, width};
use super::gaps::Gap;
use super::line::Line;
use super::roles::Role;
use std::ops::RangeInclusive;
use units::order::sort;

/// Kind of a line; lines of one kind share columns.
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
    /// A comment alone on its line; it does not end a group.
    Comment,
    /// Anything else.
    Other,
}

/// Columns of a line, from left to right.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Column {
    Titled,
    Equals,
    Unit,
    In,
    Step,
    Assigned,
    For,
    Label,
    Comment,
}

const COLUMNS: [Column; 9] = [
    Column::Titled,
    Column::Equals,
    Column::Unit,
    Column::In,
    Column::Step,
    Column::Assigned,
    Column::For,
    Column::Label,
    Column::Comment,
];

/// Sets the blanks before all cells except the first one of each line.
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

/// End of the group of lines that share columns with the line `start`: at a blank line or at another kind of line. Comments
/// and indented continuation lines do not end a group.
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
            Some(at) if is_defined(&cells[..at]) && cells[..at].iter().any(|cell| cell.text == "parameter") => {
                Kind::Parameter
            }
            Some(at) if is_defined(&cells[..at]) && is_rate(&cells[..at]) => Kind::Rate,
            Some(at) if is_defined(&cells[..at]) => Kind::Definition,
            _ => Kind::Other,
        },
        _ => Kind::Other,
    }
}

/// True if a derivative, not an initial value, stands before the equals sign.
fn is_rate(cells: &[Cell]) -> bool {
    cells.last().is_some_and(|cell| cell.text.ends_with('\''))
}

/// True for `function f(x) = ...`, possibly after another word.
fn is_function(cells: &[Cell]) -> bool {
    cells.iter().take(2).any(|cell| cell.text == "function")
}

fn is_equals(cell: &Cell) -> bool {
    cell.role == Role::Operator && cell.text == "="
}

/// True if a single name stands before the equals sign, possibly with primes, an index or `(0)`.
fn is_defined(cells: &[Cell]) -> bool {
    !cells.iter().any(|cell| matches!(cell.role, Role::Operator | Role::Tight | Role::Sign | Role::Brace))
}

/// Columns of a line, each with the index of its first cell.
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
        // A token out of column order, such as the `in` of `for k in 1..9`, is not aligned.
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
            "assigned" => Some(Column::Assigned),
            "for" => Some(Column::For),
            _ => None,
        },
        _ => None,
    }
}

/// Sets the columns from left to right, so that everything before a column is final when it is set.
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

/// Minimum number of blanks before a column.
fn blanks(column: Column) -> usize {
    if column == Column::Label { 2 } else { 1 }
}

/// Maximum number of blanks for alignment in one line. If line lengths differ by more, the column follows the majority, and
/// the other lines are not aligned.
fn widest(column: Column) -> usize {
    if column == Column::Equals { 16 } else { 48 }
}

/// Range of line ends, in columns, that contains the most lines and is no wider than `widest`.
fn reach(mut ends: Vec<usize>, widest: usize) -> RangeInclusive<usize> {
    sort(&mut ends);
    let mut most = (0, 0..=0);
    for (first, &start) in ends.iter().enumerate() {
        let count = ends[first..].iter().take_while(|end| **end <= start + widest).count();
        if count > most.0 {
            most = (count, start..=ends[first + count - 1]);
        }
    }
    most.1
}

/// Text column at which the preceding cell ends.
fn end_before(line: &Line, cell: usize) -> usize {
    line.indented + line.cells[..cell].iter().map(|cell| cell.blanks + width(&cell.text)).sum::<usize>()
}
