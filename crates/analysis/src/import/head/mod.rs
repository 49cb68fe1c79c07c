//! Reading of the header: names, units and bodies from the lines before the first row.

mod below;
mod block;
mod bodies;
mod cells_of;
mod column;
mod label;
mod meant;
mod power;
mod prose;
mod unit_words;

pub(super) use below::Below;
pub(super) use column::Head;
pub(super) use meant::{Meant, unit as meant_unit};
pub(super) use unit_words::{level, read as unit_of};

use super::cells::{Delimiter, declared};
use super::{clock, number};
use crate::finding::{Certainty, Finding, Heading};
use crate::origin::UnitOrigin;
use crate::run_name;
use bodies::{are_runs, is_body_line, name_bodies};
use cells_of::{bare_unit, split};
use column::head;
use label::Label;
use power::Sense;
pub(super) use power::superscript;
use units::Dimension;

/// True if a text after a number is a unit.
pub(super) fn is_unit(text: &str) -> bool {
    unit_of(text).is_some() || level(text).is_some()
}

/// Head from one cell with a name and perhaps a unit, `y [cm]`.
pub(super) fn of_cell(cell: &str) -> Head {
    head(label::read(cell), cell)
}

/// Head of a column whose name and unit are stated apart.
pub(super) fn with_unit(name: &str, unit: &str) -> Head {
    let (mut head, unit) = (Head::named(name), bare_unit(unit));
    match meant_unit(unit, &head.name) {
        Some(meant) => head.take(meant, unit.to_owned(), UnitOrigin::UnitLine),
        None => head.origin = UnitOrigin::Unknown(unit.chars().take(40).collect()),
    }
    head
}

/// Ratio of two units of one dimension by which a number in the first is multiplied; `None` if one is a temperature scale.
pub(super) fn ratio(from: &str, to: &str) -> Option<f64> {
    let (from, to) = (unit_of(from)?, unit_of(to)?);
    (from.dimension == to.dimension).then_some(from.factor / to.factor)
}

/// Heads of all columns; there are more if the header has more.
pub(super) fn read(lines: &[&str], delimiter: Delimiter, below: &Below, findings: &mut Vec<Finding>) -> Vec<Head> {
    let columns = below.wide();
    let mut filled: Vec<&str> = Vec::new();
    let mut numbers: Vec<usize> = Vec::new();
    // A title is followed by a blank line, the name of a body is not.
    let mut titles = 0;
    let settings = prose::settings(lines, delimiter);
    let comments: Vec<&str> = lines.iter().map(|line| uncommented(line)).collect();
    let all = lines.iter().zip(&comments).all(|(line, bare)| bare.len() < line.len() || line.trim().is_empty());
    if let Some(names) = prose::numbered(&comments, columns).filter(|_| all) {
        let heads: Vec<Head> = names.into_iter().map(of_list).collect();
        say(&heads, findings);
        return heads;
    }
    for (number, line) in lines.iter().enumerate() {
        let bare = uncommented(line);
        let is_comment = bare.len() < line.len();
        // `# run 2: t y` names the run and the columns.
        let bare = prose::without_run(bare, is_comment);
        let is_prose = is_comment && prose::is_prose(bare, delimiter, columns);
        if settings.contains(&number) || is_prose || prose::is_title(line, delimiter) {
            titles = filled.len();
            continue;
        }
        let of_tracker = bare.trim_start().to_ascii_lowercase().starts_with("multi:");
        let of_excel = number == 0 && declared(line).is_some();
        if bare.trim().is_empty() {
            titles = filled.len();
        } else if !of_tracker && !of_excel {
            filled.push(bare);
            numbers.push(number + 1);
            // A comment line does not name a body either.
            titles = if bare.len() < line.len() { filled.len() } else { titles };
        }
    }
    // The name of a run stands above rows without names.
    while filled.last().is_some_and(|line| prose::is_run(line, delimiter)) {
        filled.pop();
        numbers.pop();
        titles = titles.min(filled.len());
    }
    let Some(block) = block::tell(&filled, delimiter, below) else { return vec![Head::default(); columns] };
    let mut heads = named(filled[block.names], delimiter, columns);
    let shifted = settle_count(&mut heads, &filled, block.names, below, findings);
    complete(&mut heads, &filled, &block, delimiter, columns);
    if let Some(units) = block.units {
        let mut units = split(filled[units], delimiter, columns);
        if shifted && units.len() < columns {
            units.insert(0, "");
        }
        take_units(&mut heads, &units, below, findings);
    }
    let above: Vec<&str> = (titles.min(block.names)..block.names)
        .filter(|line| Some(*line) != block.units)
        .map(|line| filled[line])
        .collect();
    name_bodies(&mut heads, &above, delimiter);
    // Runs may be named below the names.
    let runs = |line: &&usize| **line > block.names && are_runs(filled[**line], delimiter);
    let below_names = block.comments.iter().find(runs).copied();
    if let Some(line) = below_names.filter(|_| heads.iter().all(|head| head.body.is_none())) {
        name_bodies(&mut heads, &[filled[line]], delimiter);
    }
    let comments: Vec<usize> = block
        .comments
        .iter()
        .filter(|line| Some(**line) != below_names && !is_body_line(filled[**line], &heads, delimiter))
        .filter_map(|line| numbers.get(*line).copied())
        .collect();
    if !comments.is_empty() {
        let number = |line: usize| numbers.get(line).copied().unwrap_or_default();
        let units = block.units.map(number);
        findings.push(Finding::Heading(Heading::Lines { names: number(block.names), units, comments }));
    }
    doubt_astronomy(&mut heads);
    say(&heads, findings);
    heads
}

/// Head from an entry of a list of columns, in which the unit may follow a comma: `Height, km`.
fn of_list(entry: &str) -> Head {
    match entry.rsplit_once(',') {
        Some((name, unit)) if is_unit(unit.trim()) => with_unit(name.trim(), unit.trim()),
        _ => of_cell(entry),
    }
}

/// Leaves the unit `au` open where no other column is a length: loggers write it for arbitrary units.
fn doubt_astronomy(heads: &mut [Head]) {
    let is_au = |head: &Head| head.unit.as_ref().is_some_and(|unit| unit.text == "au");
    let is_length =
        |head: &Head| head.unit.as_ref().is_some_and(|unit| unit.dimension == Dimension::LENGTH && unit.text != "au");
    if heads.iter().any(is_length) {
        return;
    }
    for head in heads.iter_mut().filter(|head| is_au(head)) {
        (head.unit, head.origin) = (None, UnitOrigin::Unknown("au".to_owned()));
    }
}

/// Reports powers of ten, conversions and unknown units.
fn say(heads: &[Head], findings: &mut Vec<Finding>) {
    for (index, head) in heads.iter().enumerate() {
        let column = if head.name.is_empty() { (index + 1).to_string() } else { head.name.clone() };
        if let Some((tens, sense)) = head.tens {
            let certainty = match sense {
                Sense::Clear => Certainty::Clear,
                Sense::Usual => Certainty::Usual,
                Sense::Open => Certainty::Open,
            };
            let heading = head.heading.clone();
            findings.push(Finding::Heading(Heading::Power { column, heading, tens, certainty }));
            continue;
        }
        if let Some((reading, written)) = &head.reading {
            let (reading, written) = (*reading, written.clone());
            findings.push(Finding::Heading(Heading::Unit { column, written, reading }));
        } else if let Some(unit) = head.origin.unknown() {
            findings.push(Finding::UnknownUnit { column, unit: unit.to_owned() });
        }
    }
}

/// Moves names to the right if the first column has none, as in tables written by R and pandas. Returns true if it did.
fn settle_count(
    heads: &mut Vec<Head>,
    filled: &[&str],
    names: usize,
    below: &Below,
    findings: &mut Vec<Finding>,
) -> bool {
    let count = heads.iter().rposition(|head| !head.heading.is_empty()).map_or(0, |last| last + 1);
    if count + 1 != below.wide() || count < 2 || heads.iter().take(count).any(|head| head.heading.is_empty()) {
        return false;
    }
    // A single word such as `t` below the names is the name of the first column.
    let alone = filled.get(names + 1).map(|line| line.trim()).filter(|line| !line.contains([' ', '\t', ',', ';']));
    let first = alone.is_some() || below.names_rows();
    if first {
        heads.truncate(count);
        heads.insert(0, alone.map(|line| head(label::read(line), line)).unwrap_or_default());
    }
    if alone.is_none() {
        findings.push(Finding::Heading(Heading::FewNames { names: count, first }));
    }
    first
}

/// Gives a column without a name that of the line above, for cells merged downwards.
fn complete(heads: &mut [Head], filled: &[&str], block: &block::Block, delimiter: Delimiter, columns: usize) {
    let Some(above) = block.names.checked_sub(1).filter(|above| Some(*above) != block.units) else { return };
    let cells = split(filled[above], delimiter, columns);
    let any_named = heads.iter().any(|head| !head.heading.is_empty());
    for (own, cell) in heads.iter_mut().zip(cells).filter(|(own, _)| own.heading.is_empty() && any_named) {
        *own = head(label::read(cell), cell);
    }
}

/// Line without its comment sign.
pub(super) fn uncommented(line: &str) -> &str {
    let start = line.trim_start();
    let bare = start.strip_prefix('#').or_else(|| start.strip_prefix('%')).or_else(|| start.strip_prefix("//"));
    match bare {
        // Neither a first column named `#` nor a failed formula is a comment.
        Some(_) if number::is_spreadsheet_error(first_word(start)) => line,
        Some(rest) if !rest.starts_with(['\t', ';', ',']) => rest.trim_start_matches(['#', ' ']),
        _ => line,
    }
}

/// Text up to the first delimiter of any kind.
pub(super) fn first_word(text: &str) -> &str {
    text.split(['\t', ';', ',', ' ', '|']).next().unwrap_or(text)
}

fn take_units(heads: &mut [Head], units: &[&str], below: &Below, findings: &mut Vec<Finding>) {
    let mut without = Vec::new();
    for (index, head) in heads.iter_mut().enumerate() {
        let cell = units.get(index).copied().unwrap_or_default();
        let text = bare_unit(cell);
        // A unit that is only guessed from the name gives way to the stated one.
        if head.unit.is_some() && head.is_guessed() && !text.is_empty() && meant_unit(text, &head.heading).is_some() {
            (head.name, head.unit, head.reading) = (head.heading.clone(), None, None);
            head.origin = UnitOrigin::default();
        }
        if head.unit.is_some() || head.origin.unknown().is_some() {
            continue;
        }
        if text.is_empty() {
            if below.is_numeric(index) && !head.name.is_empty() {
                without.push(head.name.clone());
            }
            continue;
        }
        // A power of ten may precede the unit.
        let label = label::read(&format!("{} [{text}]", if head.name.is_empty() { "x" } else { &head.name }));
        head.reading = label.reading.map(|reading| (reading, text.to_owned()));
        (head.unit, head.tens) = (label.unit, label.tens.or(head.tens));
        head.origin = match head.unit {
            Some(_) => UnitOrigin::UnitLine,
            None => UnitOrigin::Unknown(text.chars().take(40).collect()),
        };
    }
    if !without.is_empty() {
        findings.push(Finding::Heading(Heading::NoUnit(without)));
    }
}

fn named(line: &str, delimiter: Delimiter, columns: usize) -> Vec<Head> {
    let cells = split(line, delimiter, columns);
    let prefix = |cell: &str| cell.split_once(':').map(|(prefix, _)| prefix.trim().to_owned());
    let prefixes: Vec<Option<String>> = cells.iter().map(|cell| prefix(cell)).collect();
    let mut labels: Vec<Label> = Vec::with_capacity(cells.len());
    for (cell, prefix) in cells.iter().zip(&prefixes) {
        // In `ball: t`, `ball: y` the common prefix is a body.
        let shared = prefix.is_some() && prefixes.iter().filter(|other| *other == prefix).count() > 1;
        labels.push(match cell.split_once(':').filter(|_| shared && clock::read(cell).is_none()) {
            Some((body, rest)) => {
                let body = run_name::name(body).unwrap_or_else(|| body.trim().to_owned());
                Label { run: Some(body), ..label::read(rest) }
            }
            None => label::read(cell),
        });
    }
    // `y [cm] (left)` and `y [cm] (right)` are distinguished by the text after the unit.
    let full: Vec<(String, Option<String>)> =
        labels.iter().map(|label| (label.name.clone(), label.run.clone())).collect();
    let mut heads: Vec<Head> = Vec::with_capacity(columns.max(labels.len()));
    for (label, cell) in labels.into_iter().zip(&cells) {
        let same = |other: &&(String, Option<String>)| other.0 == label.name && other.1 == label.run;
        let twice = !label.behind.is_empty() && full.iter().filter(same).count() > 1;
        let name = if twice { format!("{} {}", label.name, label.behind) } else { label.name.clone() };
        heads.push(Head { name, ..head(label, cell) });
    }
    heads.resize(columns.max(heads.len()), Head::default());
    heads
}
