//! What the lines before the first row say: names, units, bodies.

use super::cells::{Cells, Delimiter};
use crate::finding::Finding;
use units::Unit;

/// What is known of a column before its numbers.
#[derive(Clone, Debug, Default)]
pub(super) struct Head {
    pub name: String,
    pub unit: Option<Unit>,
    pub body: Option<String>,
}

/// Names, units and bodies of so many columns, or of more if the header has more.
pub(super) fn read(lines: &[&str], delimiter: Delimiter, columns: usize, findings: &mut Vec<Finding>) -> Vec<Head> {
    let mut filled: Vec<&str> = Vec::new();
    // A title has a blank line under it, the name of a body has not.
    let mut titles = 0;
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
    let lines = &filled[..];
    let (names, above) = match lines {
        [] => return vec![Head::default(); columns],
        [above @ .., names, units] if are_units(names, units, delimiter, columns) => {
            let units: Vec<&str> = split(units, delimiter, columns);
            let mut heads = named(names, delimiter, columns, findings);
            for (head, text) in heads.iter_mut().zip(units) {
                head.unit = head.unit.take().or_else(|| unit(text.trim_matches(['[', ']', '(', ')'])));
            }
            (heads, above)
        }
        [above @ .., names] => (named(names, delimiter, columns, findings), above),
    };
    let mut heads = names;
    if let Some(bodies) = above.get(titles.min(above.len())..).and_then(<[&str]>::last) {
        name_bodies(&mut heads, bodies, delimiter);
    }
    heads
}

/// The line without the sign that makes it a comment.
fn uncommented(line: &str) -> &str {
    let start = line.trim_start();
    let bare = start.strip_prefix('#').or_else(|| start.strip_prefix('%')).or_else(|| start.strip_prefix("//"));
    match bare {
        // A first column that is called `#` is no comment.
        Some(rest) if !rest.starts_with(['\t', ';', ',']) => rest.trim_start_matches(['#', ' ']),
        _ => line,
    }
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
    [Delimiter::Tab, Delimiter::Semicolon, Delimiter::Comma, Delimiter::Blanks]
        .into_iter()
        .map(cells)
        .find(|other| other.len() == columns)
        .unwrap_or(own)
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
                if !next.starts_with(['[', '(', '/']) && !line[..index].ends_with('/') {
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

/// Whether the second line holds the units of the names in the first.
fn are_units(names: &str, units: &str, delimiter: Delimiter, columns: usize) -> bool {
    let names = split(names, delimiter, columns);
    let units = split(units, delimiter, columns);
    let bracketed =
        |cell: &str| (cell.starts_with('[') && cell.ends_with(']')) || (cell.starts_with('(') && cell.ends_with(')'));
    let filled = |cells: &[&str]| cells.iter().filter(|cell| !cell.is_empty()).count();
    filled(&names) >= 2.max(filled(&units))
        && filled(&units) > 0
        && names.len() <= columns
        && (units.iter().all(|cell| cell.is_empty() || bracketed(cell))
            || units.iter().all(|cell| cell.is_empty() || unit(cell).is_some()))
}

fn named(line: &str, delimiter: Delimiter, columns: usize, findings: &mut Vec<Finding>) -> Vec<Head> {
    let mut heads: Vec<Head> = split(line, delimiter, columns).into_iter().map(|cell| head(cell, findings)).collect();
    heads.resize(columns.max(heads.len()), Head::default());
    heads
}

/// `y [cm]`, `y (cm)`, `y / cm`, `v_{y}`: a name, perhaps with a unit.
fn head(cell: &str, findings: &mut Vec<Finding>) -> Head {
    let cell = cell.trim();
    let split = |open: char, close: char| {
        let (name, rest) = cell.split_once(open)?;
        Some((name.trim(), rest.trim_end().strip_suffix(close)?.trim()))
    };
    let mut name = cell;
    let mut found = None;
    if let Some((before, text)) = split('[', ']') {
        found = unit(text);
        name = before;
        if found.is_none() && !text.is_empty() {
            findings.push(Finding::UnknownUnit { column: plain(before), unit: text.to_owned() });
        }
    } else if let Some((before, text)) = split('(', ')')
        // y(t) is no y in tonnes.
        && (text != "t" || cell.contains(" ("))
        && !before.is_empty()
    {
        found = unit(text).filter(|_| !text.is_empty());
        if found.is_some() {
            name = before.trim_end_matches('/');
        }
    } else if let Some((before, text)) = cell.split_once('/')
        && !before.trim().is_empty()
    {
        found = unit(text.trim()).filter(|_| !text.trim().is_empty());
        if found.is_some() {
            name = before.trim();
        }
    }
    Head { name: plain(name), unit: found, body: None }
}

/// `v_{y}` is `v_y`.
fn plain(name: &str) -> String {
    name.trim().replace("_{", "_").replace('}', "")
}

/// The unit of this name, also as people write it: `m/s2`, `sec`.
fn unit(text: &str) -> Option<Unit> {
    let text = text.trim();
    let known = Unit::parse(text).ok();
    known.or_else(|| {
        let base = match text.to_lowercase().trim_end_matches('.') {
            "sec" | "secs" | "second" | "seconds" | "seg" | "segundo" | "segundos" => "s",
            "meter" | "meters" | "metre" | "metres" | "metro" | "metros" => "m",
            _ => "",
        };
        if !base.is_empty() {
            return Unit::parse(base).ok();
        }
        // A digit or a minus sign after a letter begins an exponent.
        let mut raised = String::new();
        let mut before = ' ';
        for character in text.chars() {
            if before.is_alphabetic() && (character.is_ascii_digit() || character == '-') {
                raised.push('^');
            }
            raised.push(character);
            before = character;
        }
        Unit::parse(&raised).ok()
    })
}

/// A line of bodies over the names: each body from its own column to the next, or one for each time column.
fn name_bodies(heads: &mut [Head], line: &str, delimiter: Delimiter) {
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
        head.body = name_at(index).map(str::to_owned);
    }
}
