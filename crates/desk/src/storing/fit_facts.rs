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
        let kind = if place < outcome.parameters.len() { "" } else { "derived " };
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
            facts.number(Part::Fit, item, format!("correlation of {} and {}", name(row), name(column)), *correlation);
        }
    }
    for one in &outcome.observations {
        let label = format!("{}{}", one.name, of_record(Some(one.record)));
        facts.number(Part::Fit, item, format!("residual of {label}"), one.rmse);
        if let Some(outside) = one.outside {
            facts.number(Part::Fit, item, format!("predicted values of {label}"), outside.n as f64);
            facts.number(Part::Fit, item, format!("error of the prediction of {label}"), outside.rmse);
        }
    }
    for scale in &outcome.scales {
        let label = of_record(Some(scale.record));
        facts.number(Part::Fit, item, format!("scale of the film{label}"), scale.value);
        facts.number(Part::Fit, item, format!("standard error of the scale{label}"), scale.stderr.unwrap_or(f64::NAN));
    }
    for (record, origin) in outcome.origins.iter().enumerate() {
        facts.number(Part::Fit, item, format!("begin of the model{}", of_record(Some(record))), *origin);
    }
}

fn criteria(outcome: &Outcome, item: &str, facts: &mut Facts) {
    let reweighted = outcome.reweighted.is_some();
    let numbers = [
        ("values", Some(outcome.n as f64)),
        ("degrees of freedom", Some(outcome.dof as f64)),
        ("RMSE", Some(outcome.rmse)),
        ("sum of squares", Some(outcome.chi2)),
        ("reduced chi-square", outcome.chi2_reduced),
        ("R2", Some(outcome.r2).filter(|_| !reweighted)),
        ("AICc", outcome.aicc),
        ("BIC", Some(outcome.bic)),
        ("Durbin-Watson", Some(outcome.durbin_watson)),
        ("autocorrelation", Some(outcome.autocorrelation)),
        ("independent values", Some(outcome.independent)),
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
    facts.text(Part::Fit, item, &format!("unit of {label}"), unit.text.clone());
    facts.number(Part::Fit, item, format!("standard error of {label}"), stderr_hac.or(*stderr).unwrap_or(f64::NAN));
    if let (Some(error), Some(_)) = (stderr, stderr_hac) {
        facts.number(Part::Fit, item, format!("standard error of {label}, independent residuals"), *error);
    }
    if let Some((low, high)) = one.interval() {
        facts.number(Part::Fit, item, format!("lower end of the interval of {label}"), low);
        facts.number(Part::Fit, item, format!("upper end of the interval of {label}"), high);
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
