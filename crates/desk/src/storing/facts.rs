//! Values that follow from the work: what a hand-in states, and what is computed again to verify it.

use super::fact_list::Facts;
use super::fit_facts::facts_of_fit;
use crate::Desk;
use crate::films::record::{table, text};
use crate::films::work::Work;
use crate::records::record::Record;
use play::{facts_of_answers, facts_of_run, name_of};
use saved::hand_in::{FOLLOWS, FOLLOWS_NOT, Fact, Part};

/// Values that follow from the present work, in SI units: states and parameters of the run and of the kept runs at their
/// times, grades of the answers, contents and uses of the records, tables of the films, and results of the finished fits. The same work gives the same bits.
/// Answers are graded again.
pub fn facts(desk: &Desk) -> Vec<Fact> {
    let (play, records) = (desk.play(), desk.records().records());
    let mut facts = Facts::default();
    facts.take(facts_of_run(play, name_of(&[&desk.document().source])));
    facts.take(facts_of_answers(play));
    for (id, name) in records.names() {
        let Some(record) = records.get(id) else { continue };
        let item = facts.item(Part::Record, record.name().to_owned());
        facts.text(Part::Record, &item, "content", name);
        facts.number(Part::Record, &item, "rows", record.table().rows() as f64);
        facts_of_record(record, &item, &mut facts);
    }
    for work in desk.films().works() {
        let Some(text) = text(work) else { continue };
        let item = facts.item(Part::Film, work.identity.name.clone());
        facts.text(Part::Film, &item, "table", name_of(&[&text]));
        facts_of_film(work, &item, &mut facts);
        if let Some(record) = work.record.and_then(|record| records.get(record)) {
            let follows = if follows(record, work) { FOLLOWS } else { FOLLOWS_NOT };
            facts.text(Part::Film, &item, "record", follows);
        }
    }
    for fit in desk.fits().finished() {
        facts_of_fit(fit, &mut facts);
    }
    facts.into_list()
}

/// Mean of each column, in the unit of the file, and the settings of the user.
fn facts_of_record(record: &Record, item: &str, facts: &mut Facts) {
    for (index, (column, used)) in record.table().columns.iter().zip(record.uses()).enumerate() {
        let label = record.table().label(index);
        facts.number(Part::Record, item, format!("mean:{label}"), mean(&column.values));
        let meaning = &used.meaning;
        if !meaning.quantity.is_empty() {
            let fitted = if used.fitted { ", fitted" } else { "" };
            let text = format!("{} [{}]{fitted}", meaning.quantity, meaning.unit.text);
            facts.text(Part::Record, item, &format!("meaning:{label}"), text);
        }
        if used.offset != 0.0 {
            facts.number(Part::Record, item, format!("zero:{label}"), used.offset);
        }
    }
    if let Some(origin) = record.fitted_origin() {
        facts.number(Part::Record, item, "origin", origin.reading);
    }
    for (name, value) in record.known() {
        facts.number(Part::Record, item, format!("known:{name}"), *value);
    }
}

/// Relative deviation up to which the record of a film has the numbers of its table.
const DEVIATION: f64 = 1e-6;

/// True if the record of a film has the numbers of its table.
fn follows(record: &Record, work: &Work) -> bool {
    let Some(table) = table(work) else { return false };
    let columns = table.columns();
    let is_near = |(one, other): (&f64, &f64)| {
        (one - other).abs() <= DEVIATION * other.abs() || !one.is_finite() && !other.is_finite()
    };
    let is_same = |(own, (_, values)): (&analysis::table::Column, &(String, &[f64]))| {
        own.values.len() == values.len() && own.values.iter().zip(values.iter()).all(is_near)
    };
    record.read_columns() == columns.len() && record.table().columns.iter().zip(&columns).all(is_same)
}

/// Number of tracked points, and the mean of each column of the table.
fn facts_of_film(work: &Work, item: &str, facts: &mut Facts) {
    let Some(table) = table(work) else { return };
    let points: usize = work.tracks().iter().map(|track| track.points.len()).sum();
    facts.number(Part::Film, item, "points", points as f64);
    for (head, values) in table.columns() {
        facts.number(Part::Film, item, format!("mean:{head}"), mean(values));
    }
    if let Some(error) = work.calibration.relative_sigma() {
        facts.number(Part::Film, item, "length-error", error);
    }
}

/// Mean of the finite values; NaN if there are none.
fn mean(values: &[f64]) -> f64 {
    let (count, sum) = values
        .iter()
        .filter(|value| value.is_finite())
        .fold((0.0, 0.0), |(count, sum), value| (count + 1.0, sum + value));
    sum / count
}
