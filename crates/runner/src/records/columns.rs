//! Description of the columns of a file as text and JSON.

use super::measured::Measured;
use analysis::table::Column;
use serde_json::{Value, json};
use std::fmt::Write;
use units::Language;

/// Maximum number of columns that are described. Further ones are only counted.
const SHOWN: usize = 24;

/// One line for the file and one per column: name, unit, origin of the unit, content of the cells.
pub fn columns_as_text(data: &Measured) -> String {
    let table = &data.table;
    let mut text = format!("{}: {}, {} rows\n", data.name, data.format.text(Language::English), table.rows());
    let names: Vec<String> = (0..table.columns.len()).map(|index| name(data, index)).collect();
    let units: Vec<String> = table.columns.iter().map(unit).collect();
    let width = |texts: &[String]| texts.iter().take(SHOWN).map(|text| text.chars().count()).max().unwrap_or(0);
    let (wide, unit_wide) = (width(&names), width(&units));
    for (index, column) in table.columns.iter().enumerate().take(SHOWN) {
        let mut cells = format!("{} values", column.filled());
        if gaps(column) > 0 {
            let _ = write!(cells, ", {} empty", gaps(column));
        }
        if let Some((line, word)) = &column.origin.first_word {
            let count = column.origin.words;
            let noun = if count == 1 { "word" } else { "words" };
            let _ = write!(cells, ", {count} {noun} (first `{word}` in line {line})");
        }
        let mut role = column.origin.role.text(Language::English).to_owned();
        if let Some(own) = (0..table.columns.len().min(SHOWN)).find(|other| table.errors_of(*other) == Some(index)) {
            role = format!("standard errors of {}", table.label(own));
        } else if role.is_empty() && table.readings.is_empty() {
            role = format!("against {}", data.called(column.independent));
        }
        let role = if role.is_empty() { role } else { format!("; {role}") };
        let _ = writeln!(
            text,
            "  {:wide$}  {:unit_wide$}  {}; {cells}{role}",
            names[index],
            units[index],
            column.origin.unit.text(Language::English)
        );
    }
    if table.columns.len() > SHOWN {
        let _ = writeln!(text, "  and {} more columns", table.columns.len() - SHOWN);
    }
    text
}

/// Description of the columns as an array of objects.
pub fn columns_as_json(data: &Measured) -> Value {
    let table = &data.table;
    let column = |(index, column): (usize, &Column)| {
        let first = column.origin.first_word.as_ref().map(|(line, text)| json!({"line": line, "text": text}));
        json!({
            "number": table.number(index),
            "name": column.name,
            "heading": column.origin.heading,
            "body": column.body,
            "unit": column.unit.as_ref().map(|unit| unit.text.clone()),
            "unit_from": column.origin.unit.code(),
            "unknown_unit": column.origin.unit.unknown(),
            "independent": table.number(column.independent),
            "role": column.origin.role.text(Language::English),
            "values": column.filled(),
            "empty": gaps(column),
            "words": column.origin.words,
            "first_word": first,
        })
    };
    table.columns.iter().enumerate().map(column).collect()
}

/// Number of empty cells, including cells with a sign for a missing value.
fn gaps(column: &Column) -> usize {
    column.values.len().saturating_sub(column.filled() + column.origin.words)
}

fn name(data: &Measured, index: usize) -> String {
    let column = &data.table.columns[index];
    match &column.body {
        Some(body) if !column.name.is_empty() => format!("{body}.{}", column.name),
        _ => data.called(index),
    }
}

fn unit(column: &Column) -> String {
    column.unit.as_ref().map_or_else(|| "-".to_owned(), |unit| format!("[{}]", unit.text))
}
