//! Results as JSON, in declared units; unknown values are null.

use super::fitted::Fitted;
use crate::records::{Measured, columns_as_json};
use analysis::fit::{Estimate, Interval, Lack, ObservationFit, Outcome, Outlier, Record};
use serde_json::{Map, Value, json};
use units::Language;
use units::Unit;

/// A fit as one object.
pub fn fit_as_json(fitted: &Fitted, data: &[Measured]) -> Value {
    let outcome = &fitted.outcome;
    let report = fitted.fit_report();
    let several = fitted.task.records.len() > 1;
    let time = &fitted.theory.document.program.model.independent.unit;
    let lacking = |lack: Lack| outcome.undetermined.iter().filter(move |one| one.lack == lack);
    let least_squares = outcome.reweighted.as_ref().map(|robust| robust.least_squares.as_slice());
    let mut object = json!({
        "document": fitted.theory.sources.path().display().to_string(),
        "title": fitted.theory.document.program.title,
        "converged": outcome.converged,
        "starts": outcome.starts,
        "improved_by_profile": outcome.improved > 0,
        "other_minimum": other_minimum(outcome),
        "unexplained_period": outcome.unexplained.map(|period| in_unit(time, period)),
        "n": outcome.n,
        "dof": outcome.dof,
        "residual_share": outcome.largest_share().map(|share| share.value),
        "excluded": fitted.task.records.iter().map(analysis::fit::Record::excluded_count).sum::<usize>(),
        "given_starts": outcome.scan.map(|scan| json!({"starts": scan.starts, "ended_here": scan.ended})),
        "rmse": in_unit(&outcome.rmse_unit, outcome.rmse),
        "rmse_unit": outcome.rmse_unit.text,
        "chi2_reduced": outcome.chi2_reduced,
        "r2": outcome.r2,
        "loss": fitted.task.loss.code(),
        "reweighted": outcome.reweighted.as_ref().map(|robust| json!({
            "scale": in_unit(&outcome.rmse_unit, robust.scale),
            "values": robust.count,
            "count_less": robust.less,
            "count_less_than_half": robust.half,
        })),
        "aicc": outcome.aicc,
        "bic": outcome.bic,
        "durbin_watson": outcome.durbin_watson,
        "autocorrelation": outcome.autocorrelation,
        "runs_test": outcome.runs.map(|runs| json!({
            "runs": runs.runs, "expected": runs.expected, "z": runs.z, "p": runs.p,
        })),
        "exact": outcome.exact,
        "independent_values": outcome.independent,
        "short_for_its_correlation": outcome.is_short(),
        "outliers": outliers(fitted),
        "verdict": report.verdict,
        "warnings": report.warnings,
        "findings": report.findings,
        "parameters": estimates(&outcome.parameters, &fitted.intervals, least_squares, None),
        "film_scales": outcome.scales.iter().map(|scale| json!({
            "record": fitted.task.records.get(scale.record).map(|record| &record.name),
            "value": scale.value, "stderr": scale.stderr, "prior_stderr": scale.prior,
        })).collect::<Vec<_>>(),
        "derived": estimates(&outcome.derived, &[], None, None),
        "correlation": correlation(fitted),
        "undetermined": lacking(Lack::Flat).flat_map(|one| one.names.clone()).collect::<Vec<_>>(),
        "hardly_determined": lacking(Lack::Weak).map(|one| one.names.clone()).collect::<Vec<_>>(),
        "exchangeable": lacking(Lack::Exchange).map(|one| one.names.clone()).collect::<Vec<_>>(),
        "determined_combinations":
            outcome.undetermined.iter().flat_map(|one| one.combinations.clone()).collect::<Vec<_>>(),
        "data": data.iter().map(record_as_json).collect::<Vec<_>>(),
    });
    if several {
        let run = |(record, one): (usize, &Record)| {
            json!({
                "name": one.name,
                "parameters": estimates(&outcome.parameters, &fitted.intervals, least_squares, Some(record)),
                "derived": estimates(&outcome.derived, &[], None, Some(record)),
                "observations": observations(outcome, Some(record)),
                "initial_values_at": begin(fitted, record, false),
                "clock_moved_to": begin(fitted, record, true),
            })
        };
        object["runs"] = fitted.task.records.iter().enumerate().map(run).collect();
    } else {
        object["observations"] = observations(outcome, None);
        object["initial_values_at"] = begin(fitted, 0, false);
        object["clock_moved_to"] = begin(fitted, 0, true);
    }
    object
}

/// Description of a record.
pub fn record_as_json(data: &Measured) -> Value {
    let findings: Vec<String> = data.findings.iter().map(|finding| finding.text(Language::English)).collect();
    json!({"name": data.name, "findings": findings, "columns": columns_as_json(data)})
}

/// Another minimum that fits as well within the noise, or null: the excess of its chi-square in variances of a
/// residual, and the values of the varied numbers.
fn other_minimum(outcome: &Outcome) -> Value {
    let Some(rival) = &outcome.rival else { return Value::Null };
    let values = outcome.parameters.iter().zip(&rival.values);
    let values: Vec<Value> = values
        .map(|(one, si)| json!({"name": one.name, "run": one.record, "value": in_unit(&one.unit, *si), "unit": one.unit.text}))
        .collect();
    json!({"chi2_growth": rival.growth, "parameters": values})
}

/// Clock reading of a record at the model's 0: where the initial values of equations hold, or for a `formula`, where its clock was
/// moved. Null for the other kind of model, and for a clock that was not moved.
fn begin(fitted: &Fitted, record: usize, formula: bool) -> Value {
    let model = &fitted.theory.document.program.model;
    let unit = &model.independent.unit;
    let origin = fitted.outcome.origins.get(record).filter(|_| model.states.is_empty() == formula);
    origin.map_or(Value::Null, |origin| json!({"value": in_unit(unit, *origin), "unit": unit.text}))
}

/// Estimates of `record`, or those that hold for all records if it is `None`. `least_squares`: estimates of least
/// squares, given for a robust loss.
fn estimates(
    estimates: &[Estimate],
    intervals: &[Option<[Interval; 2]>],
    least_squares: Option<&[f64]>,
    record: Option<usize>,
) -> Value {
    let mut object = Map::new();
    for (place, one) in estimates.iter().enumerate().filter(|(_, one)| one.record == record) {
        let known = |si: f64| one.determined.then(|| in_unit(&one.unit, si));
        let mut entry = json!({
            "value": known(one.value),
            "stderr": one.stderr.map(|error| in_unit(&one.unit, error)),
            "stderr_hac": one.stderr_hac.map(|error| in_unit(&one.unit, error)),
            "unit": one.unit.text,
        });
        if let Some(least_squares) = least_squares.and_then(|all| all.get(place)) {
            entry["least_squares"] = json!(in_unit(&one.unit, *least_squares));
        }
        if let Some((low, high)) = one.interval() {
            entry["interval_95"] = json!([in_unit(&one.unit, low), in_unit(&one.unit, high)]);
        }
        if one.at_bound {
            entry["at_bound"] = Value::Bool(true);
        }
        if let Some(Some(intervals)) = intervals.get(place) {
            let end = |si: Option<f64>| si.map(|si| in_unit(&one.unit, si));
            entry["profile"] = intervals
                .iter()
                .map(|interval| json!({"level": interval.level, "low": end(interval.low), "high": end(interval.high)}))
                .collect();
        }
        object.insert(one.name.clone(), entry);
    }
    Value::Object(object)
}

/// Correlation matrix as nested objects. With several runs, the name of a parameter of one run is followed by the run's
/// name.
fn correlation(fitted: &Fitted) -> Value {
    let outcome = &fitted.outcome;
    let names: Vec<String> = outcome
        .parameters
        .iter()
        .map(|one| match one.record.and_then(|record| fitted.task.records.get(record)) {
            Some(record) => format!("{} ({})", one.name, record.name),
            None => one.name.clone(),
        })
        .collect();
    let row = |row: usize| -> Value {
        let cells = outcome.correlation.iter().skip(row * names.len());
        names.iter().cloned().zip(cells.copied()).collect()
    };
    names.iter().cloned().zip((0..).map(row)).collect()
}

/// Outliers; times in the unit of the document's clock.
fn outliers(fitted: &Fitted) -> Value {
    let clock = &fitted.theory.document.program.model.independent.unit;
    let outcome = &fitted.outcome;
    let entry = |one: &Outlier| {
        let fit = outcome.outlying(one)?;
        Some(json!({
            "record": fitted.task.records.get(one.record).map(|record| &record.name),
            "name": fit.name,
            "time": in_unit(clock, *fit.times.get(one.row)?),
            "measured": in_unit(&fit.unit, *fit.measured.get(one.row)?),
            "unit": fit.unit.text,
            "sigmas": one.sigmas,
        }))
    };
    outcome.outliers.iter().filter_map(entry).collect()
}

fn observations(outcome: &Outcome, record: Option<usize>) -> Value {
    let mine = outcome.observations.iter().filter(|one| record.is_none_or(|record| one.record == record));
    mine.map(observation).collect()
}

fn observation(one: &ObservationFit) -> Value {
    json!({
        "name": one.name,
        "unit": one.unit.text,
        "n": one.inside.iter().filter(|inside| **inside).count(),
        "rmse": in_unit(&one.unit, one.rmse),
        "r2": one.r2,
        "made_from_another": one.derived,
        "before_initial_values": one.early,
        "outside": one.outside.map(|outside| json!({"n": outside.n, "rmse": in_unit(&one.unit, outside.rmse)})),
    })
}

fn in_unit(unit: &Unit, si: f64) -> f64 {
    unit.from_si(si)
}
