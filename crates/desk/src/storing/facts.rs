//! Values that follow from the work: what a hand-in states, and what is computed again to verify it.

use crate::Desk;
use crate::films::record::text;
use crate::fits::fit::Fitted;
use analysis::fit::{Estimate, Target};
use play::name_of;
use saved::Number;
use saved::hand_in::{Fact, FactValue, Part};
use std::collections::BTreeMap;

/// Facts in the order in which they are made.
#[derive(Default)]
struct Facts {
    facts: Vec<Fact>,
    /// Number of items of a part with this name.
    named: BTreeMap<(Part, String), usize>,
}

impl Facts {
    /// Name of an item in the facts: items of the same name are numbered from the second one on.
    fn item(&mut self, part: Part, name: String) -> String {
        let count = self.named.entry((part, name.clone())).or_default();
        *count += 1;
        if *count == 1 { name } else { format!("{name} ({count})") }
    }

    fn number(&mut self, part: Part, item: &str, quantity: impl Into<String>, value: f64) {
        self.add(part, item, quantity.into(), FactValue::Number(Number(value)));
    }

    fn text(&mut self, part: Part, item: &str, quantity: &str, value: impl Into<String>) {
        self.add(part, item, quantity.to_owned(), FactValue::Text(value.into()));
    }

    fn add(&mut self, part: Part, item: &str, quantity: String, value: FactValue) {
        self.facts.push(Fact { part, item: item.to_owned(), quantity, value });
    }
}

impl Desk {
    /// Values that follow from the present work, in SI units: states of the run at the time shown, grades of the answers,
    /// contents of the records, tables of the films, and results of the finished fits. The same work gives the same bits.
    /// Answers are graded again.
    pub fn facts(&mut self) -> Vec<Fact> {
        let mut facts = Facts::default();
        self.facts_of_run(&mut facts);
        self.facts_of_answers(&mut facts);
        for (id, name) in self.record_names() {
            let Some(record) = self.record(id) else { continue };
            let item = facts.item(Part::Record, record.name.clone());
            facts.text(Part::Record, &item, "content", name);
            facts.number(Part::Record, &item, "rows", record.table.rows() as f64);
        }
        for work in &self.films.works {
            let Some(text) = text(work) else { continue };
            let item = facts.item(Part::Film, work.identity.name.clone());
            facts.text(Part::Film, &item, "table", name_of(&[&text]));
        }
        for fit in &self.fits.finished {
            facts_of_fit(fit, &mut facts);
        }
        facts.facts
    }

    fn facts_of_run(&self, facts: &mut Facts) {
        let title = self.document.program.title.clone();
        facts.text(Part::Run, &title, "document", self.document_name());
        facts.number(
            Part::Run,
            &title,
            self.document.program.model.independent.name.clone(),
            self.play.course().time(),
        );
        for state in self.play.values().states() {
            facts.number(Part::Run, &title, state.name, state.value);
        }
    }

    fn facts_of_answers(&self, facts: &mut Facts) {
        let play = &self.play;
        let grade =
            |question, typed: &str| play.answers().verdict(play.basis(), play.course(), question, typed).grade.code();
        for question in 0..self.document.program.questions.len() {
            let answer = play.answers().answer(play.basis(), question);
            let item = format!("question {}", question + 1);
            if !answer.typed.is_empty() {
                facts.text(Part::Answer, &item, "text", answer.typed.clone());
            }
            if answer.revealed {
                facts.text(Part::Answer, &item, "right answer", "shown");
            }
            if let Some(given) = answer.verdict {
                facts.text(Part::Answer, &item, "grade given", given.grade.code());
                facts.text(Part::Answer, &item, "grade", grade(question, &answer.typed));
            }
            for (attempt, number) in answer.attempts.iter().zip(1..) {
                facts.text(Part::Answer, &item, &format!("attempt {number}"), attempt.typed.clone());
                facts.text(Part::Answer, &item, &format!("grade given to attempt {number}"), attempt.grade.code());
                facts.text(Part::Answer, &item, &format!("grade of attempt {number}"), grade(question, &attempt.typed));
            }
        }
    }
}

fn facts_of_fit(fit: &Fitted, facts: &mut Facts) {
    let outcome = &fit.outcome;
    let name = format!("{}: {}", fit.document.program.title, fit.record_names().join(" + "));
    let item = facts.item(Part::Fit, name);
    facts.text(Part::Fit, &item, "theory", fit.document.program.title.clone());
    facts.number(Part::Fit, &item, "values", outcome.n as f64);
    facts.number(Part::Fit, &item, "RMSE", outcome.rmse);
    facts.number(Part::Fit, &item, "sum of squares", outcome.chi2);
    let several = fit.task.records.len() > 1;
    for (place, one) in outcome.parameters.iter().chain(&outcome.derived).enumerate() {
        let record = one.record.filter(|_| several).and_then(|record| fit.task.records.get(record));
        let record = record.map_or(String::new(), |record| format!(" ({})", record.name));
        let label = if place < outcome.parameters.len() { one.name.clone() } else { format!("derived {}", one.name) };
        let Estimate { value, stderr, stderr_hac, unit, .. } = one;
        facts.number(Part::Fit, &item, format!("{label}{record}"), *value);
        facts.text(Part::Fit, &item, &format!("unit of {label}{record}"), unit.text.clone());
        let error = stderr_hac.or(*stderr).unwrap_or(f64::NAN);
        facts.number(Part::Fit, &item, format!("standard error of {label}{record}"), error);
    }
    facts_of_fixed(fit, &item, facts);
    for (place, correlation) in outcome.correlation.iter().enumerate() {
        let (row, column) = (place / outcome.parameters.len().max(1), place % outcome.parameters.len().max(1));
        if row < column {
            let name = |index: usize| outcome.parameters.get(index).map_or("", |one| one.name.as_str());
            facts.number(Part::Fit, &item, format!("correlation of {} and {}", name(row), name(column)), *correlation);
        }
    }
}

/// Values and units of the parameters that readers see and that were held fixed: once if all records have the same value.
fn facts_of_fixed(fit: &Fitted, item: &str, facts: &mut Facts) {
    for (index, parameter) in fit.document.program.model.shown_parameters() {
        if fit.task.varied.iter().any(|varied| varied.target == Target::Parameter(index)) {
            continue;
        }
        let values = fit.outcome.settings.iter().filter_map(|row| row.get(index)).copied();
        let values: Vec<f64> = values.collect();
        let is_same = values.windows(2).all(|pair| pair[0].to_bits() == pair[1].to_bits());
        for (value, record) in values.iter().zip(&fit.task.records).take(if is_same { 1 } else { values.len() }) {
            let record = if is_same { String::new() } else { format!(" ({})", record.name) };
            let label = format!("fixed {}{record}", parameter.name);
            facts.text(Part::Fit, item, &format!("unit of {label}"), parameter.unit.text.clone());
            facts.number(Part::Fit, item, label, *value);
        }
    }
}
