//! `meniscus class assign`: assigned values and right answers, seat by seat.

use super::arguments::{Assign, ListFormat};
use crate::failure::Failure;
use crate::load;
use crate::terminal::Terminal;
use crate::terminal::output;
use analysis::csv::{self, Dialect};
use engine::checks;
use program::Program;
use runner::Loaded;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use units::number::{Style, plain, shortest};
use units::{Language, Unit, say};

/// Significant digits of an answer in the text.
const DIGITS: usize = 4;

/// A column of the list.
struct ListColumn {
    heading: String,
    unit: Unit,
    /// Values in the unit, one per seat.
    values: Vec<f64>,
    is_answer: bool,
}

/// Writes the list.
pub fn assign(arguments: &Assign, terminal: Terminal) -> Result<(), Failure> {
    let loaded = Loaded::open(load::sources(&arguments.document)?);
    terminal.report(&loaded);
    let refused = loaded.opened.has_errors();
    let Some(document) = loaded.opened.document.filter(|_| !refused) else { return Err(Failure::Document) };
    let mut program = document.program;
    if !program.has_seats() {
        return Err(runner::no_seats().into());
    }
    let equal = equal_seats(&program.assigned_values(arguments.seats));
    let columns = columns(&mut program, arguments.seats, terminal.language);
    let text = match ListFormat::chosen(arguments.format, arguments.output.as_deref()) {
        ListFormat::Text => as_text(&program, &columns, &equal, terminal.language),
        ListFormat::Csv => as_csv(&columns, arguments.seats),
        ListFormat::Json => as_json(&program, &columns, &equal, arguments.seats),
    };
    output::deliver(arguments.output.as_deref(), std::slice::from_ref(&arguments.document), text.as_bytes())
}

/// The assigned parameters, then the answers. The program keeps the values of the last seat.
fn columns(program: &mut Program, seats: u32, language: Language) -> Vec<ListColumn> {
    let column = |heading: String, unit: &Unit, is_answer| ListColumn {
        heading: if unit.text.is_empty() { heading } else { format!("{heading} [{unit}]") },
        unit: unit.clone(),
        values: Vec::new(),
        is_answer,
    };
    let indices: Vec<usize> = program.model.assigned_parameters().collect();
    let parameters = indices.iter().map(|&index| &program.model.parameters[index]);
    let answer = language.say("answer");
    let mut columns: Vec<ListColumn> = parameters
        .map(|parameter| column(parameter.name.clone(), &parameter.unit, false))
        .chain(
            program
                .questions
                .iter()
                .zip(1..)
                .filter_map(|(one, number)| Some((one.number()?, number)))
                .map(|(one, number)| column(format!("{answer} {number}"), &one.unit, true)),
        )
        .collect();
    for values in program.assigned_values(seats) {
        for (&index, &value) in indices.iter().zip(&values) {
            program.model.parameters[index].value = value;
        }
        let numbers = program.questions.iter().filter(|question| question.number().is_some());
        let answers: Vec<f64> = numbers.map(|question| checks::answer(program, question)).collect();
        for (column, value) in columns.iter_mut().zip(values.into_iter().chain(answers)) {
            column.values.push(column.unit.from_si(value));
        }
    }
    columns
}

/// Groups of seats with equal values, which a document with few values cannot avoid.
fn equal_seats(seats: &[Vec<f64>]) -> Vec<Vec<usize>> {
    let mut groups: BTreeMap<Vec<u64>, Vec<usize>> = BTreeMap::new();
    for (values, seat) in seats.iter().zip(1..) {
        groups.entry(values.iter().map(|value| value.to_bits()).collect()).or_default().push(seat);
    }
    let mut equal: Vec<Vec<usize>> = groups.into_values().filter(|group| group.len() > 1).collect();
    equal.sort();
    equal
}

fn as_text(program: &Program, columns: &[ListColumn], equal: &[Vec<usize>], language: Language) -> String {
    let cell = |column: &ListColumn, row: usize| {
        let value = column.values.get(row).copied().unwrap_or(f64::NAN);
        if column.is_answer { plain(value, DIGITS, Style::POINT) } else { shortest(value) }
    };
    let rows = columns.first().map_or(0, |column| column.values.len());
    let numbers = std::iter::once(language.say("seat").to_owned()).chain((1..=rows).map(|row| row.to_string()));
    let mut cells: Vec<Vec<String>> = vec![numbers.collect()];
    cells.extend(
        columns.iter().map(|column| {
            std::iter::once(column.heading.clone()).chain((0..rows).map(|row| cell(column, row))).collect()
        }),
    );
    let width = |column: &Vec<String>| column.iter().map(|cell| cell.chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = cells.iter().map(width).collect();
    let name = program.assignment.as_deref().unwrap_or_default();
    let mut text = format!("{}: {name}\n\n", program.title);
    for row in 0..=rows {
        let padded =
            cells.iter().zip(&widths).filter_map(|(column, width)| Some(format!("{:>width$}", column.get(row)?)));
        text.push_str(&padded.collect::<Vec<_>>().join("  "));
        text.push('\n');
    }
    for group in equal {
        let seats = language.join(&group.iter().map(usize::to_string).collect::<Vec<_>>());
        text.push_str(&say!(language, "\nSeats {seats} have equal values: assign more parameters, or more values.\n"));
    }
    text
}

fn as_csv(columns: &[ListColumn], seats: u32) -> String {
    let numbers: Vec<f64> = (1..=seats).map(f64::from).collect();
    let headings: Vec<&str> = std::iter::once("seat").chain(columns.iter().map(|one| one.heading.as_str())).collect();
    let values: Vec<&[f64]> =
        std::iter::once(numbers.as_slice()).chain(columns.iter().map(|one| one.values.as_slice())).collect();
    csv::write(&headings, &values, Dialect::Commas)
}

fn as_json(program: &Program, columns: &[ListColumn], equal: &[Vec<usize>], seats: u32) -> String {
    let values = |row: usize, answers: bool| -> Vec<Value> {
        let own = columns.iter().filter(|column| column.is_answer == answers);
        own.map(|column| json!(column.values.get(row))).collect()
    };
    let parameters = program.model.assigned_parameters().filter_map(|index| program.model.parameters.get(index));
    let parameter = |one: &program::Parameter| json!({ "name": one.name, "unit": one.unit.text, "hidden": one.hidden });
    let object = json!({
        "title": program.title,
        "assignment": program.assignment,
        "parameters": parameters.map(parameter).collect::<Vec<_>>(),
        "answers": program.questions.iter().zip(1..).filter_map(|(one, number)| {
            Some(json!({ "question": number, "unit": one.number()?.unit.text }))
        }).collect::<Vec<_>>(),
        "seats": (1..=seats).map(|seat| json!({
            "seat": seat,
            "values": values(seat as usize - 1, false),
            "answers": values(seat as usize - 1, true),
        })).collect::<Vec<_>>(),
        "equal": equal,
    });
    format!("{object:#}\n")
}
