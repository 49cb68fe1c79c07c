//! Facts about a fit: its numbers with their errors, its residuals and its criteria.

use super::fact_list::Facts;
use crate::fits::fit::Fitted;
use analysis::fit::{Estimate, Outcome, Target};
use saved::hand_in::Part;

/// Adds the results of a fit, SI.
pub(super) fn facts_of_fit(fit: &Fitted, facts: &mut Facts) {
    let outcome = &fit.outcome;
    let name = format!("{}: {}", fit.document.program.title, fit.record_names().join(" + "));
    let item = &facts.item(Part::Fit, name);
    facts.text(Part::Fit, item, "theory", fit.document.program.title.clone());
    criteria(outcome, item, facts);
    let several = fit.task.records.len() > 1;
    let of_record = |index: Option<usize>| {
        let record = index.filter(|_| several).and_then(|index| fit.task.records.get(index));
        record.map_or(String::new(), |record| format!(" ({})", record.name))
    };
    for (place, one) in outcome.parameters.iter().chain(&outcome.derived).enumerate() {
        let kind = if place < outcome.parameters.len() { "value:" } else { "derived:" };
        estimate(one, &format!("{kind}{}{}", one.name, of_record(one.record)), item, facts);
    }
    facts_of_fixed(fit, item, facts);
    for (place, correlation) in outcome.correlation.iter().enumerate() {
        let (row, column) = (place / outcome.parameters.len().max(1), place % outcome.parameters.len().max(1));
        if row < column {
            let name = |index: usize| {
                outcome
                    .parameters
                    .get(index)
                    .map_or(String::new(), |one| format!("{}{}", one.name, of_record(one.record)))
            };
            facts.number(Part::Fit, item, format!("correlation:{} and {}", name(row), name(column)), *correlation);
        }
    }
    for one in &outcome.observations {
        let label = format!("{}{}", one.name, of_record(Some(one.record)));
        facts.number(Part::Fit, item, format!("residual:{label}"), one.rmse);
        if let Some(outside) = one.outside {
            facts.number(Part::Fit, item, format!("predicted:{label}"), outside.n as f64);
            facts.number(Part::Fit, item, format!("prediction-error:{label}"), outside.rmse);
        }
    }
    for scale in &outcome.scales {
        let label = of_record(Some(scale.record));
        facts.number(Part::Fit, item, format!("scale:{label}"), scale.value);
        facts.number(Part::Fit, item, format!("scale-stderr:{label}"), scale.stderr.unwrap_or(f64::NAN));
    }
    for (record, origin) in outcome.origins.iter().enumerate() {
        facts.number(Part::Fit, item, format!("begin:{}", of_record(Some(record))), *origin);
    }
}

fn criteria(outcome: &Outcome, item: &str, facts: &mut Facts) {
    let reweighted = outcome.reweighted.is_some();
    let numbers = [
        ("n", Some(outcome.n as f64)),
        ("dof", Some(outcome.dof as f64)),
        ("rmse", Some(outcome.rmse)),
        ("chi2", Some(outcome.chi2)),
        ("chi2-reduced", outcome.chi2_reduced),
        ("r2", Some(outcome.r2).filter(|_| !reweighted)),
        ("aicc", outcome.aicc),
        ("bic", Some(outcome.bic)),
        ("durbin-watson", Some(outcome.durbin_watson)),
        ("autocorrelation", Some(outcome.autocorrelation)),
        ("independent", Some(outcome.independent)),
        ("outliers", Some(outcome.outliers.len() as f64)),
    ];
    for (name, value) in numbers {
        if let Some(value) = value {
            facts.number(Part::Fit, item, name, value);
        }
    }
}

/// Adds a number with its unit, standard errors and interval. `label`: its name in the facts.
fn estimate(one: &Estimate, label: &str, item: &str, facts: &mut Facts) {
    let Estimate { value, stderr, stderr_hac, unit, .. } = one;
    facts.number(Part::Fit, item, label, *value);
    facts.text(Part::Fit, item, &format!("unit:{label}"), unit.text.clone());
    facts.number(Part::Fit, item, format!("stderr:{label}"), stderr_hac.or(*stderr).unwrap_or(f64::NAN));
    if let (Some(error), Some(_)) = (stderr, stderr_hac) {
        facts.number(Part::Fit, item, format!("stderr-independent:{label}"), *error);
    }
    if let Some((low, high)) = one.interval() {
        facts.number(Part::Fit, item, format!("low:{label}"), low);
        facts.number(Part::Fit, item, format!("high:{label}"), high);
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
            let label = format!("fixed:{}{record}", parameter.name);
            facts.text(Part::Fit, item, &format!("unit:{label}"), parameter.unit.text.clone());
            facts.number(Part::Fit, item, label, *value);
        }
    }
}
