//! Tables and columns in JSON, collected while it is read.

use super::scan::{DEEPEST, Scalar, Scanner};
use crate::import::cells::COLUMNS;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Greatest number of tables and of single columns that are collected.
const MOST: usize = 1000;
/// Greatest number of elements of an array inside a record that become columns.
const LONGEST_INSIDE: usize = 16;
/// Greatest number of cells of a table beyond those that JSON states.
const SPARE: usize = 4_000_000;

/// Table of a text of JSON.
#[derive(Debug)]
pub(in crate::import) struct JsonTable {
    /// Names and rows, with tabs between the cells.
    pub cells: String,
    /// Names of arrays whose length differs from that of the table.
    pub left_out: Vec<String>,
}

/// Column of a table.
#[derive(Debug, Default)]
struct JsonColumn {
    name: String,
    /// Numbers by row; NaN without one.
    numbers: Vec<f64>,
    /// Texts with their rows, ascending.
    texts: Vec<(usize, String)>,
}

/// Array of records.
#[derive(Debug, Default)]
struct Records {
    columns: Vec<JsonColumn>,
    places: BTreeMap<String, usize>,
    rows: usize,
    /// Number of cells that JSON states.
    cells: usize,
}

/// Tables and columns found so far.
#[derive(Debug, Default)]
pub(super) struct Collector {
    tables: Vec<Records>,
    /// Arrays of numbers or texts, with the keys that lead to them.
    columns: Vec<(Vec<String>, JsonColumn)>,
}

impl JsonColumn {
    fn put(&mut self, row: usize, scalar: Scalar<'_>) {
        self.numbers.resize(row, f64::NAN);
        self.numbers.push(match scalar {
            Scalar::Number(number) => number,
            Scalar::Text(text) => {
                self.texts.push((row, text.replace(['\t', '\n', '\r', '"'], " ")));
                f64::NAN
            }
            Scalar::Nothing => f64::NAN,
        });
    }
}

impl Records {
    fn put(&mut self, path: &str, scalar: Scalar<'_>) {
        let place = match self.places.get(path) {
            Some(place) => *place,
            None if self.columns.len() >= COLUMNS || self.columns.len() * self.rows > self.cells + SPARE => return,
            None => {
                self.places.insert(path.to_owned(), self.columns.len());
                self.columns.push(JsonColumn { name: path.to_owned(), ..JsonColumn::default() });
                self.columns.len() - 1
            }
        };
        // A key that stands twice in a record keeps its first value.
        if let Some(column) = self.columns.get_mut(place).filter(|column| column.numbers.len() <= self.rows) {
            self.cells += 1;
            column.put(self.rows, scalar);
        }
    }

    /// Reads an element of the array: an object, an array or a single value.
    fn element(&mut self, scanner: &mut Scanner<'_>, path: &mut String, depth: usize) -> Option<()> {
        if depth > DEEPEST {
            return None;
        }
        let length = path.len();
        if scanner.take(b'{') {
            if scanner.take(b'}') {
                return Some(());
            }
            loop {
                let key = scanner.key()?;
                let _ = write!(path, "{}{key}", if length == 0 { "" } else { "." });
                self.element(scanner, path, depth + 1)?;
                path.truncate(length);
                if scanner.take(b'}') {
                    return Some(());
                }
                scanner.take(b',').then_some(())?;
            }
        }
        if scanner.take(b'[') {
            if scanner.take(b']') {
                return Some(());
            }
            for index in 0.. {
                // The elements of a row are columns; those of a long array in a record are not.
                if length == 0 || index < LONGEST_INSIDE {
                    let _ = write!(path, "{}{index}", if length == 0 { "" } else { "." });
                    self.element(scanner, path, depth + 1)?;
                    path.truncate(length);
                } else {
                    scanner.skip(depth + 1)?;
                }
                if scanner.take(b']') {
                    return Some(());
                }
                scanner.take(b',').then_some(())?;
            }
        }
        let scalar = scanner.scalar()?;
        self.put(path, scalar);
        Some(())
    }

    fn row(&mut self, scanner: &mut Scanner<'_>, depth: usize) -> Option<()> {
        self.element(scanner, &mut String::new(), depth)?;
        self.rows += 1;
        Some(())
    }

    fn numbers(&self) -> usize {
        self.columns.iter().flat_map(|column| &column.numbers).filter(|number| number.is_finite()).count()
    }
}

impl Collector {
    /// Reads the whole document: one value, or several records one after the other.
    pub fn document(&mut self, scanner: &mut Scanner<'_>) -> Option<()> {
        let first = scanner.peek()?;
        let mut whole = Scanner::new(scanner.rest());
        whole.skip(0)?;
        if whole.peek().is_none() {
            return self.value(scanner, &mut Vec::new(), 0);
        }
        // NDJSON.
        let mut records = Records::default();
        while let Some(next) = scanner.peek() {
            (next == first).then_some(())?;
            records.row(scanner, 0)?;
        }
        self.tables.push(records);
        Some(())
    }

    fn value(&mut self, scanner: &mut Scanner<'_>, path: &mut Vec<String>, depth: usize) -> Option<()> {
        if depth > DEEPEST {
            return None;
        }
        if scanner.take(b'{') {
            if scanner.take(b'}') {
                return Some(());
            }
            loop {
                path.push(scanner.key()?.into_owned());
                self.value(scanner, path, depth + 1)?;
                path.pop();
                if scanner.take(b'}') {
                    return Some(());
                }
                scanner.take(b',').then_some(())?;
            }
        }
        if !scanner.take(b'[') {
            return scanner.scalar().map(|_| ());
        }
        if scanner.take(b']') {
            return Some(());
        }
        let of_records = matches!(scanner.peek()?, b'{' | b'[');
        let (mut records, mut column) = (Records::default(), JsonColumn::default());
        let mut count = 0;
        loop {
            // An array of mixed values is a list of neither.
            match (of_records, scanner.peek()?) {
                (true, b'{' | b'[') => records.row(scanner, depth + 1)?,
                (false, b'{' | b'[') | (true, _) => scanner.skip(depth + 1)?,
                (false, _) => {
                    column.put(count, scanner.scalar()?);
                    count += 1;
                }
            }
            if scanner.take(b']') {
                break;
            }
            scanner.take(b',').then_some(())?;
        }
        if of_records && self.tables.len() < MOST {
            self.tables.push(records);
        } else if !of_records && self.columns.len() < MOST {
            self.columns.push((path.clone(), column));
        }
        Some(())
    }

    /// Table with the most numbers; `None` if there is none of two columns.
    pub fn table(self) -> Option<JsonTable> {
        let Self { tables, columns } = self;
        let numbers = |columns: &[&(Vec<String>, JsonColumn)]| {
            columns
                .iter()
                .map(|(_, column)| column.numbers.iter().filter(|number| number.is_finite()).count())
                .sum::<usize>()
        };
        let mut lengths: Vec<usize> = columns.iter().map(|(_, column)| column.numbers.len()).collect();
        lengths.sort_unstable();
        lengths.dedup();
        let of_length =
            |length: usize| columns.iter().filter(|(_, column)| column.numbers.len() == length).collect::<Vec<_>>();
        let best = lengths
            .into_iter()
            .map(of_length)
            .filter(|columns| columns.len() >= 2)
            .max_by_key(|columns| numbers(columns));
        let records = tables.into_iter().filter(|records| records.columns.len() >= 2).max_by_key(Records::numbers);
        let by_columns = best.as_ref().map_or(0, |columns| numbers(columns));
        match records {
            Some(records) if records.numbers() > 0 && records.numbers() >= by_columns => {
                Some(of_records(records, &columns))
            }
            _ if by_columns > 0 => Some(of_columns(&best?, &columns)),
            _ => None,
        }
    }
}

/// Table of records. Rows of arrays have the names of an array of as many texts, `"columns": ["t", "x"]`.
fn of_records(records: Records, columns: &[(Vec<String>, JsonColumn)]) -> JsonTable {
    let count = records.columns.len();
    let listed = columns.iter().find(|(_, column)| column.texts.len() == count && column.numbers.len() == count);
    let numbered = records.columns.iter().enumerate().all(|(index, column)| column.name == index.to_string());
    let names: Option<Vec<&str>> = match listed {
        Some((_, column)) if numbered => Some(column.texts.iter().map(|(_, text)| text.as_str()).collect()),
        _ if numbered => None,
        _ => Some(records.columns.iter().map(|column| column.name.as_str()).collect()),
    };
    let columns: Vec<&JsonColumn> = records.columns.iter().collect();
    JsonTable { cells: written(names.as_deref(), &columns, records.rows), left_out: Vec::new() }
}

/// Table of arrays of one length, named by the keys that distinguish them.
fn of_columns(chosen: &[&(Vec<String>, JsonColumn)], all: &[(Vec<String>, JsonColumn)]) -> JsonTable {
    let paths: Vec<&[String]> = chosen.iter().map(|(path, _)| path.as_slice()).collect();
    let shortest = paths.iter().map(|path| path.len()).min().unwrap_or(0);
    let same = |key: &dyn Fn(&[String]) -> Option<String>| paths.windows(2).all(|pair| key(pair[0]) == key(pair[1]));
    let before = (0..shortest).take_while(|place| same(&|path| path.get(*place).cloned())).count();
    let behind =
        (0..shortest - before).take_while(|place| same(&|path| path.get(path.len() - 1 - *place).cloned())).count();
    let name = |path: &[String]| path.get(before..path.len() - behind).unwrap_or_default().join(".");
    let names: Vec<String> = paths.iter().map(|path| name(path)).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let columns: Vec<&JsonColumn> = chosen.iter().map(|(_, column)| column).collect();
    let rows = columns.first().map_or(0, |column| column.numbers.len());
    let other = |(path, column): &(Vec<String>, JsonColumn)| {
        let numbers = column.numbers.len() > 1 && column.numbers.len() != rows && column.texts.is_empty();
        numbers
            .then(|| path.get(before.min(path.len())..path.len().saturating_sub(behind)).unwrap_or_default().join("."))
    };
    JsonTable {
        cells: written(Some(&names), &columns, rows),
        left_out: all.iter().filter_map(other).take(10).collect(),
    }
}

/// Names and rows with tabs between the cells.
fn written(names: Option<&[&str]>, columns: &[&JsonColumn], rows: usize) -> String {
    let mut text = String::new();
    if let Some(names) = names {
        let clean = |name: &&str| name.replace(['\t', '\n', '\r', '"'], " ");
        text = names.iter().map(clean).collect::<Vec<_>>().join("\t");
        text.push('\n');
    }
    let mut texts: Vec<std::iter::Peekable<std::slice::Iter<'_, (usize, String)>>> =
        columns.iter().map(|column| column.texts.iter().peekable()).collect();
    for row in 0..rows {
        for (place, (column, texts)) in columns.iter().zip(&mut texts).enumerate() {
            if place > 0 {
                text.push('\t');
            }
            if let Some((_, word)) = texts.next_if(|(own, _)| *own == row) {
                text.push_str(word);
            } else if let Some(number) = column.numbers.get(row).filter(|number| number.is_finite()) {
                // Writing to a string cannot fail.
                let _ = write!(text, "{number:?}");
            }
        }
        text.push('\n');
    }
    text
}
