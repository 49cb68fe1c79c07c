//! The table of cycles for people.

use super::Record;
use crate::rounded::rounded;
use analysis::cycles::{Cycle, Measured};

/// The widest line of words.
const WIDTH: usize = 96;

/// What was measured, what it hides, its cycles, and what changes from one to the next.
pub fn table(record: &Record) -> String {
    let mut out = heading(record);
    if !record.data.findings.is_empty() {
        out.push_str("\nWhat this measurement hides\n");
        for finding in &record.data.findings {
            wrapped(&mut out, "  - ", &finding.text(false));
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
    wrapped(&mut out, "", &change(record, "angular frequency", "rad/s", |cycle| cycle.angular_frequency));
    wrapped(&mut out, "", &change(record, "damping", "1/s", |cycle| cycle.damping));
    if let Some(lost) = record.found.lost {
        wrapped(&mut out, "", &format!("From {lost:.2} s on the noise hides the oscillation."));
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
        "{}: {what} against {}, {} rows from {first:.2} s to {last:.2} s\n",
        record.data.name,
        record.data.called(against),
        record.times.len()
    )
}

/// One column of the table: a heading, and values with errors, aligned at the decimal points.
struct Block {
    heading: String,
    cells: Vec<(String, String)>,
}

impl Block {
    fn of(record: &Record, name: &str, unit: &str, of: fn(&Cycle) -> Measured) -> Self {
        let heading = if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") };
        let cells = record.found.cycles.iter().map(|cycle| rounded(of(cycle).value, of(cycle).error)).collect();
        Self { heading, cells }
    }

    /// The lines of this column, the heading first, all of the same width.
    fn lines(&self, with_errors: bool) -> Vec<String> {
        let places = |text: &str| -> (usize, usize) {
            let whole = text.find('.').map_or(text.chars().count(), |point| text[..point].chars().count());
            (whole, text.chars().count() - whole)
        };
        let widest = |texts: &mut dyn Iterator<Item = &String>| {
            texts.map(|text| places(text)).fold((0, 0), |widest, place| (widest.0.max(place.0), widest.1.max(place.1)))
        };
        let value = widest(&mut self.cells.iter().map(|cell| &cell.0));
        let error = widest(&mut self.cells.iter().map(|cell| &cell.1));
        let aligned = |text: &str, widest: (usize, usize)| {
            let (before, after) = places(text);
            format!("{}{text}{}", " ".repeat(widest.0 - before), " ".repeat(widest.1 - after))
        };
        let cell = |(own, its): &(String, String)| match with_errors {
            true => format!("{} ± {}", aligned(own, value), aligned(its, error)),
            false => aligned(own, value),
        };
        let cells: Vec<String> = self.cells.iter().map(cell).collect();
        let width = cells.iter().map(|cell| cell.chars().count()).max().unwrap_or(0).max(self.heading.chars().count());
        let left = (width - cells.first().map_or(0, |cell| cell.chars().count())) / 2;
        let padded = |text: &str, left: usize| {
            format!("{}{text}{}", " ".repeat(left), " ".repeat(width.saturating_sub(left + text.chars().count())))
        };
        let heading = padded(&self.heading, (width - self.heading.chars().count()) / 2);
        std::iter::once(heading).chain(cells.iter().map(|cell| padded(cell, left))).collect()
    }
}

fn rows(out: &mut String, record: &Record) {
    let kinds: Vec<&str> = record.found.cycles.iter().map(|cycle| if cycle.maximum { "max" } else { "min" }).collect();
    let blocks = [
        Block::of(record, "t", "s", |cycle| cycle.time).lines(false),
        Block::of(record, "A", &record.unit, |cycle| cycle.amplitude).lines(true),
        Block::of(record, "T", "s", |cycle| cycle.period).lines(true),
        Block::of(record, "decrement", "", |cycle| cycle.decrement).lines(true),
        Block::of(record, "ω", "rad/s", |cycle| cycle.angular_frequency).lines(true),
        Block::of(record, "γ", "1/s", |cycle| cycle.damping).lines(true),
    ];
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

/// Whether a quantity is the same in all cycles, by chi-square over rows that share no data.
fn change(record: &Record, name: &str, unit: &str, of: fn(&Cycle) -> Measured) -> String {
    let independent: Vec<Measured> =
        record.found.cycles.iter().step_by(3).map(of).filter(|one| one.error > 0.0).collect();
    let mean = mean(&independent);
    let written = |measured: Measured| {
        let (value, error) = rounded(measured.value, measured.error);
        format!("{value} ± {error} {unit}")
    };
    let Some(freedom) = independent.len().checked_sub(1).filter(|freedom| *freedom > 0) else {
        return format!("The {name} is {}; one cycle alone shows no change.", written(mean));
    };
    let chi_square: f64 = independent.iter().map(|one| (one.value - mean.value) / one.error).map(|off| off * off).sum();
    let reduced = chi_square / freedom as f64;
    // Two standard deviations of chi-square above its mean.
    if reduced < 1.0 + 2.0 * (2.0 / freedom as f64).sqrt() {
        return format!(
            "The {name} is the same in all cycles within its errors, as in the linear theory: {} (chi-square {chi_square:.1} for {freedom} degrees of freedom).",
            written(mean)
        );
    }
    let third = independent.len().div_ceil(3);
    let (early, late) = (self::mean(&independent[..third]), self::mean(&independent[independent.len() - third..]));
    format!(
        "The {name} changes by more than its errors explain (chi-square {chi_square:.1} for {freedom} degrees of freedom), which the linear theory does not allow: {} in the first third of the cycles, {} in the last.",
        written(early),
        written(late)
    )
}

/// The mean, each value weighted by its error.
fn mean(of: &[Measured]) -> Measured {
    let weight = |one: &Measured| 1.0 / (one.error * one.error);
    let sum: f64 = of.iter().map(weight).sum();
    Measured { value: of.iter().map(|one| weight(one) * one.value).sum::<f64>() / sum, error: 1.0 / sum.sqrt() }
}

/// Words in lines of bounded width; the lines after the first are as far in as the first one's text.
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
