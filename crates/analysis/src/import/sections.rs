//! Headers and titles between the rows. Each begins a section, which has its own names and units.

use super::cells::{COLUMNS, Delimiter};
use super::doubts::called;
use super::head::{self, Below, Head};
use super::notes::FINDINGS;
use super::rows::Rows;
use crate::finding::Finding;
use crate::origin::{Origin, UnitOrigin};
use crate::table::Column;
use crate::{roles, run_name};
use units::{Dimension, Unit};

/// Rows below one header or title.
#[derive(Debug)]
pub(super) struct Section {
    /// First row.
    pub start: usize,
    /// Heads of all columns.
    heads: Vec<Head>,
    /// Name of the run, `Run 2`.
    title: Option<String>,
    /// True if the times start again.
    restarts: bool,
    /// Line of its own header; `None` if that of the file holds.
    line: Option<usize>,
}

/// Sections of the rows; the first has the heads of the file. Lines that begin a section are no longer lines of words.
pub(super) fn read(rows: &mut Rows, heads: &[Head], delimiter: Delimiter) -> Vec<Section> {
    let lines = std::mem::take(&mut rows.between);
    let title = heads.first().and_then(|head| head.body.clone());
    let mut sections = vec![Section { start: 0, heads: heads.to_vec(), title, restarts: false, line: None }];
    let clock = heads.iter().position(is_clock).unwrap_or(0);
    for block in lines.chunk_by(|one, other| one.row == other.row) {
        let Some(first) = block.first().filter(|first| first.row < rows.length) else { continue };
        let end = lines.iter().map(|line| line.row).find(|row| *row > first.row).unwrap_or(rows.length);
        let before = sections.last().map_or(0, |section| section.start);
        let restarts = restarts(rows, clock, (before, first.row, end));
        let texts: Vec<&str> = block.iter().map(|line| line.text.as_str()).collect();
        let own = own_heads(rows, heads, &texts, delimiter, (first.row, end));
        let title = texts.iter().find_map(|text| title_of(text));
        if own.is_none() && !restarts {
            continue;
        }
        let repeated = own.as_ref().is_some_and(|own| own.iter().zip(heads).all(is_same)) && title.is_none();
        if !repeated {
            rows.forget_lines(block.iter().map(|line| line.line));
        }
        let line = block.last().filter(|_| own.is_some()).map(|last| last.line);
        let inherited = || sections.last().map(|section| section.heads.clone()).unwrap_or_default();
        let heads = own.unwrap_or_else(inherited);
        sections.push(Section { start: first.row, heads, title, restarts, line });
    }
    sections
}

/// Name of the run in a line: `Run #2`, `# run 2: t y`.
fn title_of(text: &str) -> Option<String> {
    let text = head::uncommented(text).trim().trim_matches([',', ';', '"', '\t']);
    run_name::name(text).or_else(|| run_name::name(text.split_once(':')?.0))
}

fn is_clock(head: &Head) -> bool {
    roles::is_time(&head.name) || head.unit.as_ref().is_some_and(|unit| unit.dimension == Dimension::TIME)
}

/// True if a clock that increases in the rows `from..at` and `at..end` goes back at `at`.
fn restarts(rows: &Rows, clock: usize, (from, at, end): (usize, usize, usize)) -> bool {
    let Some(values) = rows.columns.get(clock) else { return false };
    let part = |from: usize, to: usize| values[from..to].iter().copied().filter(|value| value.is_finite());
    let increases = |from: usize, to: usize| part(from, to).zip(part(from, to).skip(1)).all(|(one, next)| next >= one);
    let last = part(from, at).next_back();
    let first = part(at, end).next();
    last.zip(first).is_some_and(|(last, first)| first < last) && increases(from, at) && increases(at, end)
}

/// Heads of the rows `start..end` from the lines above them; `None` if these are not a header.
///
/// A header names most of the columns, and one of its cells shows it: a name of the file's header, a time, or a unit.
fn own_heads(
    rows: &Rows,
    heads: &[Head],
    lines: &[&str],
    delimiter: Delimiter,
    (start, end): (usize, usize),
) -> Option<Vec<Head>> {
    let filled = |values: &Vec<f64>| values[start..end].iter().any(|value| value.is_finite());
    let mut numeric: Vec<bool> = rows.columns.iter().map(filled).collect();
    numeric.truncate(numeric.iter().rposition(|numeric| *numeric)? + 1);
    let wide = numeric.len();
    let numbers = |column: usize| rows.columns.get(column).map_or(&[][..], |values| &values[start..end]);
    let below = Below { numeric, first: numbers(0), second: numbers(1) };
    let mut own = head::read(lines, delimiter, &below, &mut Vec::new());
    let named = own.iter().filter(|head| !head.name.is_empty()).count();
    let known = |name: &str| heads.iter().any(|head| !name.is_empty() && head.name.eq_ignore_ascii_case(name));
    let shown = own.iter().any(|head| {
        known(&head.name) || roles::is_time(&head.name) || (head.unit.is_some() && head.origin != UnitOrigin::Name)
    });
    if own.len() > rows.columns.len().max(wide) || 2 * named <= below.numeric() || !shown {
        return None;
    }
    own.resize(rows.columns.len(), Head::default());
    for (head, of_file) in own.iter_mut().zip(heads) {
        if matches!(of_file.origin, UnitOrigin::Clock | UnitOrigin::Cells) {
            (head.unit, head.origin, head.reading) = (of_file.unit.clone(), of_file.origin.clone(), None);
        }
    }
    Some(own)
}

/// Converts the numbers of each section to values in the units of its own heads, and begins each clock of times of day again
/// where it goes back.
pub(super) fn convert(sections: &[Section], rows: &mut Rows) {
    for (index, section) in sections.iter().enumerate() {
        let end = sections.get(index + 1).map_or(rows.length, |next| next.start);
        for (head, values) in section.heads.iter().zip(&mut rows.columns) {
            let values = &mut values[section.start..end];
            if let Some(conversion) = head.conversion() {
                values.iter_mut().for_each(|number| *number = conversion.value(*number));
            }
            let first = values.iter().copied().find(|value| value.is_finite());
            if let Some(first) = first.filter(|_| section.restarts && head.origin == UnitOrigin::Clock) {
                values.iter_mut().for_each(|number| *number = ((*number - first) * 1e9).round() / 1e9);
            }
        }
    }
}

/// Joins sections with the names of the first one: their numbers are converted to its units, their columns put in its
/// order. Returns the sections that remain: one, unless names or dimensions differ.
pub(super) fn join(sections: Vec<Section>, rows: &mut Rows, heads: &mut [Head]) -> Vec<Section> {
    let orders: Option<Vec<Vec<usize>>> =
        sections.iter().map(|section| order(heads, &section.heads, |column| is_filled(rows, column))).collect();
    let Some(orders) = orders.filter(|_| sections.len() > 1) else { return sections };
    for (index, (section, order)) in sections.iter().zip(&orders).enumerate() {
        let end = sections.get(index + 1).map_or(rows.length, |next| next.start);
        let part: Vec<Vec<f64>> = rows.columns.iter().map(|values| values[section.start..end].to_vec()).collect();
        for (column, from) in order.iter().enumerate() {
            let (Some(values), Some(source)) = (rows.columns.get_mut(column), part.get(*from)) else { continue };
            let unit = |heads: &[Head], column: usize| heads.get(column).and_then(|head| head.unit.clone());
            let ratio = match (unit(&section.heads, *from), unit(heads, column)) {
                (Some(own), Some(wanted)) if own.factor != wanted.factor => Some((own, wanted)),
                _ => None,
            };
            for (value, number) in values[section.start..end].iter_mut().zip(source) {
                *value = ratio.as_ref().map_or(*number, |(own, wanted)| scaled(*number, own, wanted));
            }
        }
    }
    let titled = sections.iter().all(|section| section.title.is_some());
    let distinct = sections
        .iter()
        .enumerate()
        .all(|(index, section)| sections[..index].iter().all(|other| other.title != section.title));
    if titled && distinct {
        rows.titles = sections.iter().filter_map(|section| section.title.clone()).collect();
    }
    // One title above all columns is that of the first section.
    if heads.iter().all(|head| head.body == heads[0].body) {
        heads.iter_mut().for_each(|head| head.body = None);
    }
    rows.repeats = sections.iter().skip(1).map(|section| section.start).collect();
    sections.into_iter().take(1).collect()
}

/// Number in another unit; decimal powers without a rounding error.
fn scaled(number: f64, own: &Unit, wanted: &Unit) -> f64 {
    let ratio = own.factor / wanted.factor;
    let inverse = (wanted.factor / own.factor).round();
    if ratio < 1.0 && (inverse * ratio - 1.0).abs() < 1e-12 {
        number / inverse
    } else if (ratio - ratio.round()).abs() < 1e-9 * ratio {
        number * ratio.round()
    } else {
        number * ratio
    }
}

fn is_filled(rows: &Rows, column: usize) -> bool {
    rows.columns.get(column).is_some_and(|values| values.iter().any(|value| value.is_finite()))
}

/// For each column of `heads`, the column of `own` with its name and dimension; `None` if there is not one for each.
fn order(heads: &[Head], own: &[Head], filled: impl Fn(usize) -> bool) -> Option<Vec<usize>> {
    let mut order: Vec<usize> = Vec::new();
    for (column, head) in heads.iter().enumerate() {
        let same = |other: &Head| other.name == head.name && dimension(other) == dimension(head);
        let here = own.get(column).filter(|other| same(other)).map(|_| column);
        let free = |place: &usize| !order.contains(place) && same(&own[*place]);
        let found = here.or_else(|| (0..own.len()).find(free));
        match found {
            Some(place) => order.push(place),
            None if !filled(column) => order.push(column),
            None => return None,
        }
    }
    Some(order)
}

fn dimension(head: &Head) -> Option<Dimension> {
    head.unit.as_ref().map(|unit| unit.dimension)
}

/// True if two heads have the same name and unit.
fn is_same((own, head): (&Head, &Head)) -> bool {
    own.name == head.name && own.unit == head.unit
}

/// Note on the sections that have a header of their own.
pub(super) fn finding(sections: &[Section], file: &[Head]) -> Option<Finding> {
    let differs = |section: &&Section| section.line.is_some() && !section.heads.iter().zip(file).all(is_same);
    let count = sections.iter().filter(differs).count();
    let line = sections.iter().find(differs)?.line?;
    Some(Finding::OtherHeader { line, count })
}

/// Columns of sections with different names, each as a run, and the indices of the columns in the file. Empty if the runs
/// would need too many columns or gaps.
pub(super) fn apart(sections: &[Section], rows: &mut Rows) -> (Vec<Column>, Vec<usize>) {
    let count = rows.columns.len();
    let ends: Vec<usize> = sections.iter().skip(1).map(|section| section.start).chain([rows.length]).collect();
    let longest = sections.iter().zip(&ends).map(|(section, end)| end - section.start).max().unwrap_or(0);
    if sections.len() * count > COLUMNS || sections.len() * longest > 20 * rows.length {
        return (Vec::new(), Vec::new());
    }
    let (mut columns, mut kept) = (Vec::new(), Vec::new());
    for (run, (section, end)) in sections.iter().zip(&ends).enumerate() {
        let body = section.title.clone().filter(|_| sections.iter().all(|section| section.title.is_some()));
        for (index, (head, values)) in section.heads.iter().zip(&rows.columns).enumerate() {
            let mut values = values[section.start..*end].to_vec();
            if values.iter().all(|value| !value.is_finite()) {
                continue;
            }
            values.resize(longest, f64::NAN);
            let (words, first_word) = if run == 0 { (rows.words_in(index), rows.first_word(index)) } else { (0, None) };
            let origin = Origin {
                heading: head.heading.clone(),
                unit: head.origin.clone(),
                words,
                first_word,
                conversion: head.conversion(),
                number: index + 1,
                ..Origin::default()
            };
            let body = Some(body.clone().unwrap_or_else(|| format!("Run {}", run + 1)));
            // Rows without a header are of the same logger: their clock has the name that a later header gives it.
            let later = || {
                sections.iter().filter_map(|section| section.heads.get(index)).find(|head| roles::is_time(&head.name))
            };
            let named = if head.name.is_empty() && is_clock(head) { later() } else { None };
            let (name, unit) = (named.unwrap_or(head).name.clone(), head.unit.clone());
            columns.push(Column { name, unit, body, independent: 0, values, origin });
            kept.push(index);
        }
    }
    (columns, kept)
}

/// Columns that hold numbers or have a name, and their indices in the file.
pub(super) fn whole(heads: Vec<Head>, rows: &mut Rows, findings: &mut Vec<Finding>) -> (Vec<Column>, Vec<usize>) {
    let mut columns = Vec::with_capacity(heads.len());
    let mut kept = Vec::new();
    for (index, (head, values)) in heads.into_iter().zip(std::mem::take(&mut rows.columns)).enumerate() {
        let words = rows.words_in(index);
        let filled = values.iter().any(|value| value.is_finite());
        if !filled && (words > 0 || head.name.is_empty()) {
            // Empty columns without a name come from a delimiter at the end of each line; columns of words are not
            // measurements.
            if words > 0 && findings.len() < FINDINGS {
                findings.push(Finding::WordColumn(called(&head.name, index)));
            }
            continue;
        }
        if !filled && findings.len() < FINDINGS {
            findings.push(Finding::EmptyColumn(called(&head.name, index)));
        }
        kept.push(index);
        let (conversion, first_word) = (head.conversion(), rows.first_word(index));
        let origin = Origin {
            heading: head.heading,
            unit: head.origin,
            words,
            first_word,
            conversion,
            number: index + 1,
            ..Origin::default()
        };
        columns.push(Column { name: head.name, unit: head.unit, body: head.body, independent: 0, values, origin });
    }
    (columns, kept)
}
