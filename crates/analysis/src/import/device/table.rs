//! Table of the sections of a file.

use super::description::{Description, Sections, Settings};
use super::remark::Remark;
use super::section::{MadeColumn, Notes, Section};
use crate::conversion::Conversion;
use crate::finding::Finding;
use crate::import::cells::COLUMNS;
use crate::import::notes::{FINDINGS, runs_finding};
use crate::origin::Origin;
use crate::roles;
use crate::table::{Column, Table};

/// Greatest ratio of the cells of runs beside each other to the filled ones.
const MOST_EXPANSION: usize = 20;

/// Columns of a run, with its name.
struct Run {
    name: Option<String>,
    columns: Vec<MadeColumn>,
    rows: usize,
}

/// Table of the sections, with findings.
pub(super) fn of(description: &'static Description, sections: Vec<Section>) -> (Table, Vec<Finding>) {
    let mut notes = Notes::default();
    notes.say(Remark::Recognised { name: description.name });
    if description.settings == Settings::Beside {
        notes.say(Remark::Beside);
    }
    let mut runs: Vec<Run> = Vec::new();
    for section in sections.into_iter().filter(|section| section.rows > 0) {
        let (name, rows) = (section.header.run(), section.rows);
        let mut columns = section.make(description, &mut notes);
        merge_clocks(&mut columns, 0);
        let run = Run { name, columns, rows };
        match runs.last_mut() {
            Some(last) if description.sections == Sections::Channels => last.widen(run),
            Some(last) if last.continues(&run) => last.append(run),
            _ => runs.push(run),
        }
    }
    if let [first, rest @ ..] = &mut runs[..]
        && !fit_side_by_side(first, rest)
    {
        let rest = runs.split_off(1);
        rest.into_iter().for_each(|run| runs[0].append(run));
    }
    let mut findings: Vec<Finding> = notes.remarks.into_iter().map(Finding::Device).collect();
    notes.word_columns.dedup();
    findings.extend(notes.word_columns.into_iter().take(FINDINGS).map(Finding::WordColumn));
    let mut table = table(runs, &mut findings);
    let roles = roles::assign(&mut table);
    findings.extend(runs_finding(&table));
    findings.extend(roles.into_iter().map(Finding::Role));
    (table, findings)
}

impl Run {
    /// True if another run has the same columns and its times go on after the last of this one.
    fn continues(&self, next: &Self) -> bool {
        let names = |run: &Self| {
            run.columns.iter().map(|column| (column.head.name.clone(), column.head.unit.clone())).collect::<Vec<_>>()
        };
        let clock = |run: &Self| run.columns.iter().find(|column| column.clock).map(|column| column.values.clone());
        let (Some(own), Some(times)) = (clock(self), clock(next)) else { return false };
        let last = own.iter().rev().find(|time| time.is_finite());
        let first = times.iter().find(|time| time.is_finite());
        next.name.is_none() && names(self) == names(next) && last.zip(first).is_some_and(|(last, first)| first > last)
    }

    /// Adds the rows of another run, column by column.
    fn append(&mut self, next: Self) {
        for (index, column) in self.columns.iter_mut().enumerate() {
            match next.columns.get(index) {
                Some(more) => column.values.extend_from_slice(&more.values),
                None => column.values.resize(self.rows + next.rows, f64::NAN),
            }
        }
        self.rows += next.rows;
    }

    /// Adds the columns of another run beside the own ones.
    fn widen(&mut self, next: Self) {
        let before = self.columns.len();
        let rows = self.rows.max(next.rows);
        self.columns.extend(next.columns);
        self.columns.iter_mut().for_each(|column| column.values.resize(rows, f64::NAN));
        self.rows = rows;
        merge_clocks(&mut self.columns, before);
    }
}

/// Removes the clocks from the column `from` on that hold the same times as the first clock.
fn merge_clocks(columns: &mut Vec<MadeColumn>, from: usize) {
    let Some(first) = columns.iter().position(|column| column.clock) else { return };
    let same = |values: &[f64], other: &[f64]| {
        values.len() == other.len()
            && values.iter().zip(other).all(|(one, other)| one == other || (one.is_nan() && other.is_nan()))
    };
    // A channel between two clocks that differ must stay behind its own.
    let times = columns[first].values.clone();
    let all = columns.iter().skip(from).filter(|column| column.clock).all(|column| same(&column.values, &times));
    if all {
        let mut index = 0;
        columns.retain(|column| {
            index += 1;
            !column.clock || index - 1 == first || index - 1 < from
        });
    }
}

/// True if the runs fit beside each other without much empty space.
fn fit_side_by_side(first: &Run, rest: &[Run]) -> bool {
    let all = || std::iter::once(first).chain(rest);
    let longest = all().map(|run| run.rows).max().unwrap_or(0);
    let rows: usize = all().map(|run| run.rows).sum();
    let columns: usize = all().map(|run| run.columns.len()).sum();
    columns <= COLUMNS && (1 + rest.len()) * longest <= MOST_EXPANSION * rows
}

fn table(runs: Vec<Run>, findings: &mut Vec<Finding>) -> Table {
    let several = runs.len() > 1;
    let rows = runs.iter().map(|run| run.rows).max().unwrap_or(0);
    let mut columns = Vec::new();
    for (place, run) in runs.into_iter().enumerate() {
        let body = several.then(|| run.name.unwrap_or_else(|| format!("Run {}", place + 1)));
        for MadeColumn { head, mut values, words, .. } in run.columns {
            let conversion: Option<Conversion> = head.conversion();
            if let Some(conversion) = conversion {
                values.iter_mut().for_each(|value| *value = conversion.value(*value));
            }
            values.resize(rows, f64::NAN);
            let number = columns.len() + 1;
            let named = || if head.name.is_empty() { number.to_string() } else { head.name.clone() };
            if place == 0
                && let Some(unit) = head.origin.unknown()
            {
                findings.push(Finding::UnknownUnit { column: named(), unit: unit.to_owned() });
            }
            if place == 0 && values.iter().all(|value| value.is_nan()) {
                findings.push(Finding::EmptyColumn(named()));
            }
            if words > 0 {
                findings.push(Finding::MoreWords(words));
            }
            let origin =
                Origin { heading: head.heading, unit: head.origin, words, conversion, number, ..Origin::default() };
            columns.push(Column {
                name: head.name,
                unit: head.unit,
                body: body.clone(),
                independent: 0,
                values,
                origin,
            });
        }
    }
    Table { columns, ..Table::default() }
}
