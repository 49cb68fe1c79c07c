//! What the lines before the first row say: names, units, bodies.

use super::cells::{Cells, Delimiter};
use super::label::{self, Label};
use super::roles::is_time;
use super::{clock, unit_words};
use super::{format, number};
use crate::finding::Finding;
use crate::origin::UnitOrigin;
use crate::run_name;
use units::Unit;

/// What is known of a column before its numbers.
#[derive(Clone, Debug, Default)]
pub(super) struct Head {
    pub name: String,
    /// The cell as it is written.
    pub heading: String,
    pub unit: Option<Unit>,
    pub origin: UnitOrigin,
    pub body: Option<String>,
    /// What the name says of its clock times.
    pub clock: Option<clock::Form>,
}

/// Names, units and bodies of so many columns, or of more if the header has more.
pub(super) fn read(lines: &[&str], delimiter: Delimiter, columns: usize, findings: &mut Vec<Finding>) -> Vec<Head> {
    let mut filled: Vec<&str> = Vec::new();
    // A title has a blank line under it, the name of a body has not.
    let mut titles = 0;
    let lines = match lines {
        [first, rest @ ..] if format::declared(first).is_some() => rest,
        all => all,
    };
    for line in lines {
        let bare = uncommented(line);
        if bare.trim().is_empty() {
            titles = filled.len();
        } else if !bare.trim_start().to_ascii_lowercase().starts_with("multi:") {
            filled.push(bare);
            // Neither does a comment name one.
            titles = if bare.len() < line.len() { filled.len() } else { titles };
        }
    }
    // Units may stand below a blank line, names may not.
    let (names, units) = match &filled[..] {
        [] => return vec![Head::default(); columns],
        [.., names, units] if are_units(names, units, delimiter, columns) => (filled.len() - 2, Some(*units)),
        _ => (filled.len() - 1, None),
    };
    let mut heads = named(filled[names], delimiter, columns);
    if let Some(units) = units {
        take_units(&mut heads, &split(units, delimiter, columns));
    }
    name_bodies(&mut heads, &filled[titles.min(names)..names], delimiter);
    let unknown = heads.iter().filter_map(|head| Some((head, head.origin.unknown()?)));
    findings
        .extend(unknown.map(|(head, unit)| Finding::UnknownUnit { column: head.name.clone(), unit: unit.to_owned() }));
    heads
}

/// The line without the sign that makes it a comment.
fn uncommented(line: &str) -> &str {
    let start = line.trim_start();
    let bare = start.strip_prefix('#').or_else(|| start.strip_prefix('%')).or_else(|| start.strip_prefix("//"));
    match bare {
        // Neither a first column that is called `#` nor a failed formula is a comment.
        Some(_) if number::is_spreadsheet_error(first_word(start)) => line,
        Some(rest) if !rest.starts_with(['\t', ';', ',']) => rest.trim_start_matches(['#', ' ']),
        _ => line,
    }
}

/// Up to the first delimiter of any kind.
pub(super) fn first_word(text: &str) -> &str {
    text.split(['\t', ';', ',', ' ', '|']).next().unwrap_or(text)
}

/// The header's cells: by the delimiter of the rows or, where that does not give the right number, by another.
fn split(line: &str, delimiter: Delimiter, columns: usize) -> Vec<&str> {
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
    // `t ms y cm` over two columns.
    if own.len() == 2 * columns && own.iter().skip(1).step_by(2).all(|cell| unit_words::read(cell).is_some()) {
        let joined = own.chunks(2).filter_map(|pair| within(line, pair.first()?, pair.last()?));
        return joined.collect();
    }
    [Delimiter::Tab, Delimiter::Semicolon, Delimiter::Comma, Delimiter::Blanks]
        .into_iter()
        .map(cells)
        .find(|other| other.len() == columns)
        .unwrap_or(own)
}

/// The part of a line from one of its cells to the end of another.
fn within<'a>(line: &'a str, first: &str, last: &str) -> Option<&'a str> {
    let start = (first.as_ptr() as usize).checked_sub(line.as_ptr() as usize)?;
    let end = (last.as_ptr() as usize).checked_sub(line.as_ptr() as usize)? + last.len();
    line.get(start..end)
}

/// Words between blanks; a unit in brackets stays with its name: `t (s) y [m]`. If there are tabs or wide blanks, only
/// those divide: `elapsed time   height`.
fn split_at_blanks(line: &str) -> Vec<&str> {
    let mut cells: Vec<&str> = Vec::new();
    let mut start = None;
    let mut depth = 0_usize;
    let mut at = 0;
    let line = line.trim();
    for (index, character) in line.char_indices() {
        match character {
            '[' | '(' => depth += 1,
            ']' | ')' => depth = depth.saturating_sub(1),
            ' ' | '\t' if depth == 0 => {
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

/// Whether the second line holds the units of the names in the first: all in brackets, or that of the time is one, or most are
/// known; and none of a time is something else.
fn are_units(names: &str, units: &str, delimiter: Delimiter, columns: usize) -> bool {
    let names = split(names, delimiter, columns);
    let units = split(units, delimiter, columns);
    let filled = |cells: &[&str]| cells.iter().filter(|cell| !cell.is_empty()).count();
    let known = |(place, cell): (usize, &&str)| {
        let name = names.get(place).copied().unwrap_or_default();
        !cell.is_empty() && label::unit(bare_unit(cell), name).is_some()
    };
    let known = units.iter().enumerate().filter(|(place, cell)| known((*place, cell))).count();
    let all_in_brackets = units.iter().all(|cell| cell.is_empty() || bare_unit(cell).len() < cell.len());
    let over_times = |known: bool| {
        units.iter().enumerate().any(|(place, cell)| {
            let name = names.get(place).copied().unwrap_or_default();
            is_time(name) && label::unit(bare_unit(cell), name).is_some() == known
        })
    };
    filled(&names) >= 2.max(filled(&units))
        && known > 0
        && names.len() <= columns
        && (all_in_brackets || (!over_times(false) && (over_times(true) || 2 * known > filled(&units))))
}

/// `cm` of `[cm]` or `(cm)`.
fn bare_unit(cell: &str) -> &str {
    let inside = |open, close| cell.strip_prefix(open).and_then(|rest| rest.strip_suffix(close));
    inside('[', ']').or_else(|| inside('(', ')')).unwrap_or(cell).trim()
}

fn take_units(heads: &mut [Head], units: &[&str]) {
    for (head, cell) in heads.iter_mut().zip(units) {
        let text = bare_unit(cell);
        if head.unit.is_some() || text.is_empty() {
            continue;
        }
        head.unit = label::unit(text, &head.name);
        head.origin = match head.unit {
            Some(_) => UnitOrigin::UnitLine,
            None => UnitOrigin::Unknown(text.chars().take(40).collect()),
        };
    }
}

fn named(line: &str, delimiter: Delimiter, columns: usize) -> Vec<Head> {
    let cells = split(line, delimiter, columns);
    let prefix = |cell: &str| cell.split_once(':').map(|(prefix, _)| prefix.trim().to_owned());
    let prefixes: Vec<Option<String>> = cells.iter().map(|cell| prefix(cell)).collect();
    let mut labels: Vec<Label> = Vec::with_capacity(cells.len());
    for (cell, prefix) in cells.iter().zip(&prefixes) {
        // `ball: t`, `ball: y`: what several names have in common is a body.
        let shared = prefix.is_some() && prefixes.iter().filter(|other| *other == prefix).count() > 1;
        labels.push(match cell.split_once(':').filter(|_| shared && clock::read(cell).is_none()) {
            Some((body, rest)) => {
                let body = run_name::name(body).unwrap_or_else(|| body.trim().to_owned());
                Label { run: Some(body), ..label::read(rest) }
            }
            None => label::read(cell),
        });
    }
    // `y [cm] (left)` and `y [cm] (right)` are distinguished by what stands behind.
    let full: Vec<(String, Option<String>)> =
        labels.iter().map(|label| (label.name.clone(), label.run.clone())).collect();
    let mut heads: Vec<Head> = Vec::with_capacity(columns.max(labels.len()));
    for (label, cell) in labels.into_iter().zip(&cells) {
        let same = |other: &&(String, Option<String>)| other.0 == label.name && other.1 == label.run;
        let twice = !label.behind.is_empty() && full.iter().filter(same).count() > 1;
        heads.push(Head {
            name: if twice { format!("{} {}", label.name, label.behind) } else { label.name },
            heading: (*cell).to_owned(),
            unit: label.unit,
            origin: label.origin,
            body: label.run,
            clock: label.clock,
        });
    }
    heads.resize(columns.max(heads.len()), Head::default());
    heads
}

/// A line of bodies over the names: each body from its own column to the next, or one for each time column.
fn name_bodies(heads: &mut [Head], above: &[&str], delimiter: Delimiter) {
    let Some(line) = above.last() else { return };
    if heads.iter().any(|head| head.body.is_some()) {
        return;
    }
    // Blanks at the beginning stand for empty cells.
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
    // One name over all is that of the body, unless there are more lines of words over it: those are of a logger.
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
    for (index, head) in heads.iter_mut().enumerate() {
        head.body = name_at(index).map(|name| run_name::name(name).unwrap_or_else(|| name.to_owned()));
    }
}
