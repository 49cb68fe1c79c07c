//! Generated files with known contents, and the result of reading each: right, difference reported, refused, or silently
//! wrong.

use analysis::import::{self, Import};
use units::{Language, Unit};

/// True properties of a column of numbers.
#[derive(Clone, Debug)]
pub struct Truth {
    pub name: &'static str,
    /// Unit of the SI values below; `None` if the file states none.
    pub unit: Option<&'static str>,
    /// The values, in SI.
    pub si: Vec<f64>,
}

/// Possible results of a variant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    Right,
    /// Something differs from the truth, and a message names the column or the line.
    Said,
    Refused,
    /// Something differs, and nothing is reported.
    Silent,
}

/// One generated file.
pub struct Variant {
    pub kind: String,
    pub bytes: Vec<u8>,
    pub truth: Vec<Truth>,
    /// True if it must be read right; otherwise it may be refused or the difference reported.
    pub clear: bool,
}

/// Ten rows of a record, with two decimals.
pub fn rows() -> Vec<[f64; 3]> {
    (0..10)
        .map(|row| {
            let time = f64::from(row);
            let round = |value: f64| (value * 100.0).round() / 100.0;
            [0.05 * time, round(9.0 * libm::cos(time)), round(libm::sin(time) - 20.0)].map(round)
        })
        .collect()
}

pub fn column(index: usize, factor: f64) -> Vec<f64> {
    rows().iter().map(|row| row[index] * factor).collect()
}

pub fn truth(name: &'static str, unit: &'static str, index: usize) -> Truth {
    let factor = Unit::parse(unit).map_or(1.0, |unit| unit.factor);
    Truth { name, unit: Some(unit), si: column(index, factor) }
}

pub fn same(found: &[f64], expected: &[f64]) -> bool {
    let close = |(one, other): (&f64, &f64)| (one - other).abs() <= 1e-9 * other.abs().max(1e-12);
    found.len() == expected.len() && found.iter().zip(expected).all(close)
}

/// Compares what is read with the truth.
pub fn judge(variant: &Variant) -> (Outcome, String) {
    let import = match import::text(&variant.bytes) {
        Ok(import) => import,
        Err(error) => return (Outcome::Refused, error.message(Language::English)),
    };
    let said: Vec<String> = import.findings.iter().map(|finding| finding.text(Language::English)).collect();
    let spanish = import.findings.iter().all(|finding| !finding.text(catalogues::with(Language::Spanish)).is_empty());
    assert!(spanish, "{}", variant.kind);
    let mut outcome = Outcome::Right;
    let mut text = shown(&import);
    for truth in &variant.truth {
        let is_right = |column: &analysis::table::Column| {
            let unit = match (&column.unit, truth.unit) {
                (Some(unit), Some(expected)) => {
                    Unit::parse(expected).is_ok_and(|expected| expected.dimension == unit.dimension)
                }
                (None, None) => true,
                _ => false,
            };
            unit && column.name == truth.name && same(&column.si(None), &truth.si)
        };
        if import.table.columns.iter().any(is_right) {
            continue;
        }
        let named = |text: &String| text.contains(truth.name) || text.contains("of the file has the names");
        outcome = if said.iter().any(named) && outcome != Outcome::Silent { Outcome::Said } else { Outcome::Silent };
        text.push_str(&format!("wanted {} [{:?}] = {:?}\n", truth.name, truth.unit, &truth.si[..3]));
    }
    (outcome, text)
}

pub fn shown(import: &Import) -> String {
    let mut text = String::new();
    for column in &import.table.columns {
        let unit = column.unit.as_ref().map(|unit| unit.text.clone());
        let values = column.values.get(..3).unwrap_or_default();
        text.push_str(&format!("{} [{unit:?}] = {values:?}\n", column.name));
    }
    for finding in &import.findings {
        text.push_str(&format!("! {}\n", finding.text(Language::English)));
    }
    text
}

/// Checks that no result is silently wrong and that all clear variants are right; prints the number of each result.
pub fn check(title: &str, variants: Vec<Variant>, least: usize) {
    let (mut counts, mut wrong) = ([0_usize; 4], String::new());
    for variant in &variants {
        let (outcome, text) = judge(variant);
        counts[outcome as usize] += 1;
        if outcome == Outcome::Silent || (variant.clear && outcome != Outcome::Right) {
            let file = String::from_utf8_lossy(&variant.bytes);
            let first: Vec<&str> = file.lines().take(6).collect();
            wrong.push_str(&format!("{}: {outcome:?}\n{}\n{text}\n", variant.kind, first.join("\n")));
        }
    }
    let [right, said, refused, silent] = counts;
    println!(
        "{title}: {} variants, {right} right, {said} said, {refused} refused, {silent} silently wrong",
        variants.len()
    );
    assert!(wrong.is_empty(), "{title}:\n{wrong}");
    assert!(variants.len() >= least, "{title}: {} variants", variants.len());
}

/// A line of cells, with a column of words at this place.
pub fn line(cells: &[String], delimiter: &str, words: Option<usize>, word: &str) -> String {
    let mut cells = cells.to_vec();
    if let Some(place) = words {
        cells.insert(place, word.to_owned());
    }
    cells.join(delimiter) + "\n"
}

pub fn body(delimiter: &str, words: Option<usize>, comma: bool) -> String {
    let mut text = String::new();
    for (index, row) in rows().iter().enumerate() {
        let cells: Vec<String> = row.iter().map(|value| format!("{value:.2}")).collect();
        let cells = if comma { cells.iter().map(|cell| cell.replace('.', ",")).collect() } else { cells };
        text.push_str(&line(&cells, delimiter, words, if index % 3 == 0 { "ok" } else { "weak" }));
    }
    text
}

/// A file with one heading over `v`.
pub fn over(heading: &str, delimiter: &str) -> Vec<u8> {
    let mut text = format!("t (s){delimiter}{heading}\n");
    for row in rows() {
        text.push_str(&format!("{:.2}{delimiter}{:.2}\n", row[0], row[1]));
    }
    text.into_bytes()
}
