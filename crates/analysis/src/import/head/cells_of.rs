//! Cells of a header line, which may have another delimiter than the rows.

use super::unit_words;
use crate::import::cells::{Cells, Delimiter};

/// Cells of a header line: by the delimiter of the rows or, if that does not give the right number, by another.
pub(super) fn split(line: &str, delimiter: Delimiter, columns: usize) -> Vec<&str> {
    let cells = |delimiter| {
        let mut cells: Vec<&str> =
            if delimiter == Delimiter::Blanks { split_at_blanks(line) } else { Cells::of(line, delimiter).collect() };
        while cells.last().is_some_and(|cell| cell.is_empty()) {
            cells.pop();
        }
        cells
    };
    let own = cells(delimiter);
    if own.len() == columns {
        return own;
    }
    // For `t ms y cm` over two columns.
    if own.len() == 2 * columns && own.iter().skip(1).step_by(2).all(|cell| unit_words::read(cell).is_some()) {
        let joined = own.chunks(2).filter_map(|pair| within(line, pair.first()?, pair.last()?));
        return joined.collect();
    }
    if delimiter == Delimiter::Blanks
        && let Some(units) = units_at_blanks(line).filter(|units| units.len() > own.len() && units.len() <= columns)
    {
        return units;
    }
    // A line with the delimiter of the rows has no other one.
    if own.len() > 1 && !matches!(delimiter, Delimiter::Blanks | Delimiter::Blank) {
        return own;
    }
    [Delimiter::Tab, Delimiter::Semicolon, Delimiter::Comma, Delimiter::Blanks]
        .into_iter()
        .map(cells)
        .find(|other| other.len() == columns)
        .unwrap_or(own)
}

/// Part of a line from the beginning of `first` to the end of `last`.
fn within<'a>(line: &'a str, first: &str, last: &str) -> Option<&'a str> {
    let start = (first.as_ptr() as usize).checked_sub(line.as_ptr() as usize)?;
    let end = (last.as_ptr() as usize).checked_sub(line.as_ptr() as usize)? + last.len();
    line.get(start..end)
}

/// Cells of a line of units between blanks, `[s] [mm]`, `in s in mm`, `/ s / mm`; `None` for any other line.
fn units_at_blanks(line: &str) -> Option<Vec<&str>> {
    let mut cells: Vec<&str> = Vec::new();
    let mut start = None;
    for word in line.split_whitespace() {
        let word_start = word.as_ptr() as usize - line.as_ptr() as usize;
        let from = start.unwrap_or(word_start);
        let cell = line.get(from..word_start + word.len())?;
        let open = cell.matches(['[', '(']).count() > cell.matches([']', ')']).count();
        if open || matches!(cell, "in" | "en" | "/") {
            start = Some(from);
            continue;
        }
        start = None;
        if bare_unit(cell).len() == cell.len() {
            return None;
        }
        cells.push(cell);
    }
    start.is_none().then_some(cells)
}

/// Words between blanks; a unit in brackets stays with its name: `t (s) y [m]`. If there are tabs or wide blanks, only
/// these are delimiters: `elapsed time   height`. Quotation marks keep a name together.
fn split_at_blanks(line: &str) -> Vec<&str> {
    let mut cells: Vec<&str> = Vec::new();
    let mut start = None;
    let mut depth = 0_usize;
    let mut at = 0;
    let mut quoted = false;
    let line = line.trim();
    for (index, character) in line.char_indices() {
        match character {
            '"' => quoted = !quoted && line[index + 1..].contains('"'),
            '[' | '(' if !quoted => depth += 1,
            ']' | ')' => depth = depth.saturating_sub(1),
            ' ' | '\t' if depth == 0 && !quoted => {
                let next = line[index..].trim_start();
                let joined = next.starts_with(['[', '(', '/', '<', '{']) || next.starts_with("in ");
                if !joined && !line[..index].ends_with('/') && !line[..index].ends_with(" in") {
                    cells.extend(start.take().map(|start| &line[start..index]));
                }
                continue;
            }
            _ => {}
        }
        start.get_or_insert(index);
        at = index + character.len_utf8();
    }
    cells.extend(start.map(|start| line[start..at].trim()));
    cells.into_iter().map(|cell| cell.trim().trim_matches('"')).collect()
}

/// Returns `cm` for `[cm]`, `(cm)`, `in cm` or `/ cm`.
pub(super) fn bare_unit(cell: &str) -> &str {
    let cell = cell.trim();
    let word = ["in ", "en "].iter().find_map(|word| cell.strip_prefix(word)).or_else(|| cell.strip_prefix('/'));
    let bare = word.unwrap_or(cell).trim();
    let inside = |open, close| bare.strip_prefix(open).and_then(|rest| rest.strip_suffix(close));
    let inside =
        inside('[', ']').or_else(|| inside('(', ')')).or_else(|| inside('<', '>')).or_else(|| inside('{', '}'));
    let bare = inside.unwrap_or(bare).trim();
    ["in ", "en "].iter().find_map(|word| bare.strip_prefix(word)).unwrap_or(bare).trim()
}
