//! Header lines with the bodies or runs of columns.

use super::column::{Head, head};
use super::label;
use crate::import::cells::{Cells, Delimiter};
use crate::run_name;

/// True if a line names several runs, and nothing else.
pub(super) fn are_runs(line: &str, delimiter: Delimiter) -> bool {
    let cells: Vec<String> =
        Cells::of(line, delimiter).filter(|cell| !cell.is_empty()).map_while(run_name::name).collect();
    cells.len() == Cells::of(line, delimiter).filter(|cell| !cell.is_empty()).count()
        && cells.iter().any(|cell| Some(cell) != cells.first())
}

/// True if a line names the bodies of the columns.
pub(super) fn is_body_line(line: &str, heads: &[Head], delimiter: Delimiter) -> bool {
    let mut cells = Cells::of(line, delimiter).filter(|cell| !cell.is_empty()).peekable();
    if heads.iter().any(|head| head.body.as_deref() == Some(line.trim())) {
        return true;
    }
    let is_body = |cell: &str| {
        let name = run_name::name(cell).unwrap_or_else(|| label::read(cell).name);
        heads.iter().any(|head| head.body.as_deref() == Some(name.as_str()) || head.body.as_deref() == Some(cell))
    };
    cells.peek().is_some() && cells.all(|cell| is_body(cell) || heads.iter().any(|head| head.heading == cell))
}

/// Assigns bodies from a line above the names: each body from its own column to the next, or one for each time column.
pub(super) fn name_bodies(heads: &mut [Head], above: &[&str], delimiter: Delimiter) {
    let Some(line) = above.last() else { return };
    if heads.iter().any(|head| head.body.is_some()) {
        return;
    }
    // Leading blanks stand for empty cells.
    let exact = delimiter == Delimiter::Blanks && (line.starts_with(' ') || line.contains("  "));
    let cells: Vec<&str> = if exact {
        Cells::of(line, Delimiter::Blank).collect()
    } else if delimiter == Delimiter::Blanks && !line.contains('\t') {
        vec![line.trim()]
    } else if delimiter == Delimiter::Blanks {
        Cells::of(line, Delimiter::Tab).collect()
    } else {
        Cells::of(line, delimiter).collect()
    };
    let filled: Vec<(usize, &str)> = cells.into_iter().enumerate().filter(|(_, cell)| !cell.is_empty()).collect();
    let Some((first, _)) = filled.first() else { return };
    // A single name over all columns is that of the body, unless there are further lines of words above it: those come from
    // a logger.
    if filled.len() == 1 && *first == 0 && above.len() > 1 && run_name::name(line).is_none() {
        return;
    }
    // As many different names as columns are longer names of the columns.
    let different =
        |(place, (_, name)): (usize, &(usize, &str))| filled[..place].iter().all(|(_, other)| other != name);
    if filled.len() == heads.len() && filled.iter().enumerate().all(different) {
        return;
    }
    if filled.len() > heads.len() || filled.iter().any(|(_, name)| name.chars().count() > 60) {
        return;
    }
    let starts: Vec<usize> = (0..heads.len()).filter(|index| heads[*index].name == heads[0].name).collect();
    let name_at = |index: usize| -> Option<&str> {
        if filled.len() == 1 && *first == 0 {
            return Some(filled[0].1);
        }
        if filled.len() == starts.len() && starts.len() > 1 {
            let group = starts.iter().filter(|start| **start <= index).count().checked_sub(1)?;
            return Some(filled[group].1);
        }
        filled.iter().rev().find(|(start, _)| *start <= index).map(|(_, name)| *name)
    };
    for (index, own) in heads.iter_mut().enumerate() {
        let Some(name) = name_at(index).filter(|name| *name != own.heading) else { continue };
        // `Position (cm)` over x and y is the unit of both.
        let over = head(label::read(name), name);
        if over.unit.is_some() && over.body.is_none() && filled.len() > 1 && name.contains(['[', '(']) {
            if own.unit.is_none() && own.origin.unknown().is_none() {
                (own.unit, own.origin, own.reading, own.tens) = (over.unit, over.origin, over.reading, over.tens);
            }
            own.body = Some(over.name);
        } else {
            own.body = Some(run_name::name(name).unwrap_or_else(|| name.to_owned()));
        }
    }
}
