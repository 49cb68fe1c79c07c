//! The data that a report of fits carries, from which `meniscus verify` computes the fits again.

use super::arguments::Common;
use crate::handing::write::{now, packed};
use analysis::fit::{Estimate, Outcome, Record};
use analysis::origin::UnitOrigin;
use class::verify::{DataFile, Recomputation, project_of_files, write_varied};
use document::page::Source;
use runner::fitting::{Fitted, excluded_rows};
use runner::records::Measured;
use saved::Number;
use saved::carried::{carry, carry_nothing};
use saved::format::{self, Column, StatedError};
use saved::hand_in::{Fact, FactValue, HandIn, Part, Sender};
use saved::project::Project;
use units::{Language, Unit, Words, words};

/// Largest deviation between a fit and its recomputation from the carried data, in standard errors and relative.
const AGREEMENT: f64 = 1e-3;

/// A report with the data of its fits. It states why it carries none if the fits cannot be computed again from the data alone.
pub fn carrying(page: &str, fitted: &[&Fitted], data: &[Measured], arguments: &Common) -> String {
    let language = fitted.first().map_or(Language::English, |one| Language::of(&one.theory.document.program.language));
    match work(fitted, data, arguments).and_then(|work| hand_in(work, fitted, arguments)) {
        Ok(hand_in) => carry(page, &packed(&hand_in.of_page(page, language)), language),
        Err(why) => {
            let why = words!("This page does not carry its data, and cannot be verified: {why}.");
            carry_nothing(page, &why.text(language), language)
        }
    }
}

fn hand_in(work: Project, fitted: &[&Fitted], arguments: &Common) -> Result<HandIn, Words> {
    let recomputation = Recomputation::complete(&work)?;
    if let Some(why) = recomputation.left_out().next() {
        return Err(why.clone());
    }
    let facts = recomputation.facts();
    let agrees = |one: &&Fitted| agrees(&facts, &one.theory.document.program.title, &one.outcome);
    if let Some(other) = fitted.iter().find(|one| !agrees(one)) {
        let theory = &other.theory.document.program.title;
        return Err(words!("the laboratory finds other values of the fit of {theory} from the same data"));
    }
    let sender = Sender { seat: arguments.seat.map(|seat| seat.number()), ..Sender::default() };
    Ok(HandIn::new(now(), sender, work, facts))
}

/// True if the recomputed fit of a theory agrees with its outcome: values within a part of their standard errors, errors
/// relative.
fn agrees(facts: &[Fact], theory: &str, outcome: &Outcome) -> bool {
    let number = |quantity: &str, near: f64, within: f64| {
        let mut stated = facts.iter().filter(|fact| {
            fact.part == Part::Fit && fact.item.starts_with(theory) && fact.quantity.starts_with(quantity)
        });
        stated.any(|fact| match &fact.value {
            FactValue::Number(Number(number)) => (number - near).abs() <= within || number.is_nan() && near.is_nan(),
            FactValue::Text(_) => false,
        })
    };
    let determined = outcome.parameters.iter().filter(|one| one.determined);
    determined.into_iter().all(|Estimate { name, value, stderr, stderr_hac, .. }| {
        let error = stderr_hac.or(*stderr).unwrap_or(f64::NAN);
        let within = if error.is_finite() { AGREEMENT * error } else { AGREEMENT * value.abs() };
        number(&format!("value:{name}"), *value, within.max(f64::MIN_POSITIVE))
            && number(&format!("stderr:value:{name}"), error, 2.0 * AGREEMENT * error.abs())
    })
}

/// Documents, records and fits as a project.
///
/// # Errors
/// The reason for which a hand-in cannot state the fits.
fn work(fitted: &[&Fitted], data: &[Measured], arguments: &Common) -> Result<Project, Words> {
    if fitted.iter().any(|one| !one.task.tied.is_empty()) {
        return Err(words("the fit ties parameters, which a hand-in cannot state"));
    }
    let Stated { documents, state, files, fits } = stated(fitted, data, arguments)
        .ok_or_else(|| words("the fit uses an expression or an option that a hand-in cannot state"))?;
    project_of_files(documents, state, files, Vec::new(), fits)
}

/// Parts of a project of fits.
struct Stated {
    documents: Vec<Source>,
    /// State of the run, as in a link.
    state: String,
    files: Vec<DataFile>,
    fits: Vec<format::Fit>,
}

/// Parts of the project; `None` if something of the fits cannot be stated.
fn stated(fitted: &[&Fitted], data: &[Measured], arguments: &Common) -> Option<Stated> {
    let documents = fitted.first()?.theory.sources.embedded();
    let state = arguments.seat.map_or_else(String::new, |seat| format!("1&seat={}", seat.number()));
    let observed = |one: &Measured| -> Option<Vec<usize>> {
        let mut columns = Vec::new();
        for observe in &arguments.observe {
            columns.push(one.column(observe, &columns).ok()?);
        }
        Some(columns)
    };
    let columns: Vec<Vec<usize>> = data.iter().map(observed).collect::<Option<_>>()?;
    let file = |(one, columns): (&Measured, &Vec<usize>)| {
        let independent = columns.iter().filter_map(|column| Some(one.table.columns.get(*column)?.independent));
        let mut against: Vec<usize> = if arguments.against.is_empty() { Vec::new() } else { independent.collect() };
        against.dedup();
        let name = one.name.rsplit('/').next().unwrap_or_default().to_owned();
        Some(DataFile { name, bytes: one.bytes.clone()?, against })
    };
    let files = data.iter().zip(&columns).map(file).collect::<Option<_>>()?;
    let fits = fitted.iter().map(|one| fit(one, data, &columns, arguments)).collect::<Option<_>>()?;
    Some(Stated { documents, state, files, fits })
}

fn fit(fitted: &Fitted, data: &[Measured], columns: &[Vec<usize>], arguments: &Common) -> Option<format::Fit> {
    let (task, outcome) = (&fitted.task, &fitted.outcome);
    let numbers = |values: &[f64]| values.iter().copied().map(Number).collect();
    let independent = &fitted.theory.document.program.model.independent;
    let excluded = excluded_rows(data, &arguments.exclude).ok()?;
    let part = |(place, record): (usize, &Record)| {
        let (measured, columns, excluded) = (data.get(place)?, columns.get(place)?, excluded.get(place)?);
        let unit_of = |column: usize, else_in: &Unit| {
            let own = measured.table.columns.get(column).and_then(|column| column.unit.clone());
            own.unwrap_or_else(|| else_in.clone()).text
        };
        let stated = |column: usize| {
            measured.table.columns.get(column).is_some_and(|own| own.origin.unit != UnitOrigin::Assumed)
        };
        let mut uses: Vec<Column> =
            (0..measured.table.columns.len()).map(|column| Column { column, ..Column::default() }).collect();
        let mut errors = Vec::new();
        for (observation, &column) in record.observations.iter().zip(columns) {
            // A hand-in names the quantity of a column.
            if observation.name.contains(['+', '-', '*', '/', '^', '(', ' ']) {
                return None;
            }
            let clock = measured.table.columns.get(column)?.independent;
            let (quantity, unit) = (independent.name.clone(), unit_of(clock, &independent.unit));
            *uses.get_mut(clock)? = Column { column: clock, quantity, unit, stated: stated(clock), fitted: false };
            let (quantity, unit) = (observation.name.clone(), unit_of(column, &observation.observed.unit));
            *uses.get_mut(column)? = Column { column, quantity, unit, stated: stated(column), fitted: true };
            if let Some(stated) = arguments.error.iter().find(|one| one.name == observation.name) {
                let all = observation.errors.as_deref().unwrap_or_default();
                let value = all.first().filter(|first| all.iter().all(|one| one == *first)).copied();
                let beside = if value.is_some() { None } else { Some(measured.table.column(&stated.value).ok()?) };
                errors.push(StatedError { column, value: value.map(Number), beside });
            }
        }
        let fixed = record.fixed.iter().map(|&(index, value)| (index, Number(value))).collect();
        let origin = record.origin.map(Number);
        let excluded = excluded.iter().enumerate().filter(|(_, excluded)| **excluded).map(|(row, _)| row).collect();
        Some(format::Part { origin, fixed, columns: uses, errors, excluded, ..format::Part::default() })
    };
    let rival = outcome.rival.as_ref();
    let theory = &fitted.theory;
    Some(format::Fit {
        documents: theory.sources.texts().map(|(_, text)| text.to_owned()).collect(),
        task: format::Task {
            file: theory.sources.embedded().first()?.name.clone(),
            window: [task.from, task.until].map(|end| end.map(Number)),
            parameters: numbers(&task.parameters),
            varied: task.varied.iter().map(write_varied).collect(),
            loss: Some(task.loss.code().to_owned()).filter(|_| task.loss != analysis::fit::Loss::Squares),
            records: task.records.iter().enumerate().map(part).collect::<Option<_>>()?,
        },
        found: format::Found {
            values: outcome.parameters.iter().map(|one| Number(one.value)).collect(),
            starts: outcome.starts,
            rival: rival.map(|rival| format::Rival { growth: Number(rival.growth), values: numbers(&rival.values) }),
        },
    })
}
