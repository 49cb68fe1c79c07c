//! Columns: what stands below one another in the lines of a paragraph stays so.
//!
//! A column is made of cells of one kind that begin in the same column of the text, if one of them has more than one blank before it.
//! Where the cells before them change their widths, the column moves as far as the widest of them asks.

use super::Line;
use super::cells::{Cell, width};
use super::gaps::Gap;
use super::roles::Role;
use std::collections::BTreeMap;

/// What cells of one column have in common.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Text,
    Brackets,
    Comment,
    Brace,
    Operator,
    Keyword(String),
    /// A word after an operand, such as `step`.
    Word(String),
    AfterOperator,
    AfterMark,
    Other,
}

/// Sets the blanks before all cells but the first ones of their lines.
pub(super) fn align(lines: &mut [Line]) {
    let mut columns: BTreeMap<(usize, usize, Kind), Vec<(usize, usize)>> = BTreeMap::new();
    for (number, line) in lines.iter().enumerate() {
        let mut at = line.found;
        for (index, cell) in line.cells.iter().enumerate() {
            at += if index == 0 { 0 } else { cell.found };
            if index > 0 && cell.found > 0 && !matches!(cell.gap, Gap::None | Gap::Exact) {
                let key = (at, line.paragraph, kind(&line.cells[index - 1], cell));
                columns.entry(key).or_default().push((number, index));
            }
            at += cell.length;
        }
    }
    let mut placed: Vec<Placed> = lines.iter().map(Placed::new).collect();
    // Columns from left to right, so that all before one of their cells are where they will be.
    for ((_, _, kind), members) in columns {
        let is_column = members.len() > 1 && members.iter().any(|(line, cell)| lines[*line].cells[*cell].found > 1);
        if !is_column {
            for (line, cell) in members {
                let cell = &mut lines[line].cells[cell];
                cell.blanks = cell.found.min(widest(&kind));
            }
            continue;
        }
        let before =
            |(line, cell): &(usize, usize), placed: &mut [Placed]| placed[*line].end_before(&lines[*line], *cell);
        let ends: Vec<usize> = members.iter().map(|member| before(member, &mut placed)).collect();
        let least = members.iter().map(|(line, cell)| lines[*line].cells[*cell].found).min().unwrap_or(1);
        let column = ends.iter().max().copied().unwrap_or_default() + least;
        for ((line, cell), end) in members.iter().zip(ends) {
            lines[*line].cells[*cell].blanks = column - end;
        }
    }
}

/// How many blanks may stand before a cell that no other one pushes to the right.
fn widest(kind: &Kind) -> usize {
    match kind {
        Kind::Text | Kind::Comment | Kind::Brackets => 2,
        Kind::Keyword(word) if word == "in" => 2,
        _ => 1,
    }
}

fn kind(before: &Cell, cell: &Cell) -> Kind {
    match (before.role, cell.role) {
        (_, Role::Text) => Kind::Text,
        (_, Role::Brackets) => Kind::Brackets,
        (_, Role::Comment) => Kind::Comment,
        (_, Role::Brace) => Kind::Brace,
        (_, Role::Operator) => Kind::Operator,
        (_, Role::Keyword) => Kind::Keyword(cell.text.to_string()),
        (Role::Operator, _) => Kind::AfterOperator,
        (Role::Separator | Role::Colon, _) => Kind::AfterMark,
        (Role::Number | Role::Name | Role::Brackets | Role::Closing | Role::Attached, Role::Name) => {
            Kind::Word(cell.text.to_string())
        }
        _ => Kind::Other,
    }
}

/// How far the cells of a line have been placed.
struct Placed {
    cells: usize,
    end: usize,
}

impl Placed {
    fn new(line: &Line) -> Self {
        Self { cells: 0, end: line.indented }
    }

    /// Where the cell before this one ends.
    fn end_before(&mut self, line: &Line, cell: usize) -> usize {
        for cell in &line.cells[self.cells..cell] {
            self.end += cell.blanks + width(&cell.text);
        }
        self.cells = cell;
        self.end
    }
}
