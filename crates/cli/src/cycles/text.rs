//! The cycles as a table of text.

use super::record::Record;
use analysis::cycles::{Cycle, Measured, Quantity, Writing};
use runner::records::columns_as_text;
use units::Language;
use units::number::{self, Layout, Style};

/// Maximum width of wrapped text, in characters.
const WIDTH: usize = 96;

/// Significant digits of a value with an unknown error.
const DIGITS: usize = 4;

/// Text about the data, their quality, the cycles, and their changes.
pub fn table(record: &Record) -> String {
    let mut out = heading(record);
    out.push_str("\nThe columns of the file\n");
    for line in columns_as_text(record.data).lines().skip(1) {
        out.push_str(line);
        out.push('\n');
    }
    if !record.data.findings.is_empty() {
        out.push_str("\nData quality\n");
        for finding in &record.data.findings {
            wrapped(&mut out, "  - ", &finding.text(Language::English));
        }
    }
    out.push_str("\nCycle by cycle\n\n");
    rows(&mut out, record);
    out.push('\n');
    wrapped(
        &mut out,
        "",
        "Each row is a turning point with the half-cycles around it: its time t, the amplitude A from the level between \
         maximum and minimum, the period T, the decrement (the natural logarithm of the ratio of two amplitudes one period \
         apart), and the local angular frequency ω = 2π/T and damping γ = decrement/T. After ± stands one standard \
         error. Rows next to each other share data; each third row is independent.",
    );
    out.push('\n');
    for sentence in sentences(record) {
        wrapped(&mut out, "", &sentence);
    }
    out
}

fn heading(record: &Record) -> String {
    let table = &record.data.table;
    let against = table.columns.get(record.column).map_or(0, |column| column.independent);
    let column = record.data.called(record.column);
    let what = if column == record.name { column } else { format!("{} ({column})", record.name) };
    let (first, last) = (record.times.first().copied().unwrap_or(0.0), record.times.last().copied().unwrap_or(0.0));
    format!(
        "{}: {what} against {}, {} rows from {} to {}\n",
        record.data.name,
        record.data.called(against),
        record.times.len(),
        seconds(first),
        seconds(last)
    )
}

fn seconds(time: f64) -> String {
    format!("{} s", number::fixed(time, 2, Style::POINT))
}

/// One column of the table: a heading and cells with the same number of decimals.
struct Block {
    heading: String,
    cells: Vec<String>,
}

impl Block {
    fn of(record: &Record, name: &str, unit: &str, with_errors: bool, of: impl Fn(&Cycle) -> Measured) -> Self {
        let heading = if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") };
        let measured: Vec<Measured> = record.found.cycles.iter().map(of).collect();
        let layout = Layout::of_errors(measured.iter().map(|one| (one.value, one.error)));
        let cell = |one: &Measured| match layout {
            Some(layout) if with_errors => layout.with_error(one.value, one.error, Style::POINT),
            Some(layout) => layout.number(one.value, Style::POINT),
            None => number::plain(one.value, DIGITS, Style::POINT),
        };
        Self { heading, cells: measured.iter().map(cell).collect() }
    }

    /// Lines of the column with the heading first, all of the same width, numbers aligned to the right.
    fn lines(&self) -> Vec<String> {
        let longest = self.cells.iter().map(|cell| cell.chars().count()).max().unwrap_or(0);
        let width = longest.max(self.heading.chars().count());
        let right = (width - longest) / 2;
        let padded = |text: &str, right: usize| {
            format!("{}{text}{}", " ".repeat((width - right).saturating_sub(text.chars().count())), " ".repeat(right))
        };
        let heading = padded(&self.heading, (width - self.heading.chars().count()) / 2);
        std::iter::once(heading).chain(self.cells.iter().map(|cell| padded(cell, right))).collect()
    }
}

fn rows(out: &mut String, record: &Record) {
    let kinds: Vec<&str> = record.found.cycles.iter().map(|cycle| if cycle.maximum { "max" } else { "min" }).collect();
    let of = |quantity: Quantity| {
        let unit = quantity.unit(&record.unit, "s");
        Block::of(record, quantity.symbol(Language::English), &unit, true, |cycle| quantity.of(cycle)).lines()
    };
    let time = Block::of(record, "t", "s", false, |cycle| cycle.time).lines();
    let blocks: Vec<Vec<String>> = std::iter::once(time).chain(Quantity::ALL.map(of)).collect();
    for row in 0..=kinds.len() {
        let mut line = format!("  {:3}", if row == 0 { "" } else { kinds[row - 1] });
        for block in &blocks {
            line.push_str("   ");
            line.push_str(block.get(row).map_or("", String::as_str));
        }
        out.push_str(line.trim_end());
        out.push('\n');
    }
}

/// Sentences about the record and its cycles.
pub fn sentences(record: &Record) -> Vec<String> {
    let digits = |value: f64| number::plain(value, DIGITS, Style::POINT);
    record.found.sentences(
        Language::English,
        &Writing {
            measured: &|quantity, measured| {
                let unit = quantity.unit(&record.unit, "s");
                let text = number::with_error(measured.value, Some(measured.error), Style::POINT);
                number::error_with_unit(&text, &unit)
            },
            value: &|value| format!("{} {}", digits(value), record.unit).trim_end().to_owned(),
            time: &seconds,
            fixed: &|value, decimals| number::fixed(value, decimals, Style::POINT),
        },
    )
}

/// Wraps words into lines of [`WIDTH`]. Lines after the first are indented by the length of `first`.
fn wrapped(out: &mut String, first: &str, text: &str) {
    let mut width = first.chars().count();
    let indent = width;
    out.push_str(first);
    for (index, word) in text.split(' ').enumerate() {
        let length = word.chars().count();
        if index > 0 && width + 1 + length > WIDTH {
            out.push('\n');
            out.push_str(&" ".repeat(indent));
            width = indent;
        } else if index > 0 {
            out.push(' ');
            width += 1;
        }
        out.push_str(word);
        width += length;
    }
    out.push('\n');
}
