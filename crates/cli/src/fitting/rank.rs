//! `meniscus rank`: several theories of the same data, best first.

use super::arguments::{Form, Rank as Arguments};
use super::carrying::carrying;
use super::fit::{FileKind, complete, kind, notes, read, with_font};
use super::fitted::Fitted;
use super::prepare::{self, Theory};
use super::text::{Columns, beginnings, searches};
use crate::arguments::settings::Reader;
use crate::data::Measured;
use crate::failure::Failure;
use crate::terminal::Terminal;
use crate::terminal::output;
use analysis::fit::{Outcome, Outside, Ranked, rank as order, ties, worth};
use report::{Ranking, Report};
use serde_json::json;
use std::fmt::Write;
use units::Language;
use units::Unit;
use units::number::{Group, Style, plain};

/// Fit of a theory, and its prediction from the beginning of the data.
struct Contender {
    fitted: Fitted,
    /// Errors of the first observation: of the whole fit before and after the time of `--predict-from`, and of the
    /// prediction after it. `None` without that option.
    parts: Option<[Outside; 3]>,
}

/// Fits all theories and prints them, best first.
pub fn rank(arguments: &Arguments, terminal: Terminal) -> Result<(), Failure> {
    if arguments.models.len() < 2 {
        return Err(Failure::with_hint("there is only one theory", "name another one with --model DOC"));
    }
    let kind = arguments.output.as_deref().map(kind).transpose()?;
    if kind == Some(FileKind::Svg) {
        return Err(Failure::with_hint("a ranking is no figure", "end --output in .html, .xlsx or .csv"));
    }
    let theories: Vec<Theory> =
        arguments.models.iter().map(|path| prepare::theory(path, terminal)).collect::<Result<_, _>>()?;
    let Some(first) = theories.first() else { return Err(Failure::request("there is no theory")) };
    let data = read(&arguments.data, &arguments.common, first, terminal)?;
    if arguments.common.format == Form::Text {
        // The table of theories does not contain these findings.
        for finding in data.iter().flat_map(|one| &one.findings) {
            terminal.note(finding);
        }
    }
    let contenders: Vec<Contender> = theories
        .into_iter()
        .zip(&arguments.models)
        .map(|(theory, path)| contend(theory, path, &data, arguments, terminal))
        .collect::<Result<_, _>>()?;
    let outcomes: Vec<&Outcome> = contenders.iter().map(|one| &one.fitted.outcome).collect();
    let ranked = order(&outcomes);
    if let (Some(path), Some(kind)) = (&arguments.output, kind) {
        let notes: Vec<Vec<Vec<String>>> = contenders.iter().map(|one| notes(&data, &one.fitted.theory)).collect();
        let reports: Vec<Report> =
            contenders.iter().zip(&notes).map(|(one, notes)| one.fitted.report(notes, "")).collect();
        let command = crate::command::typed();
        let ranking = Ranking { theories: &reports, command: &command };
        let bytes = match kind {
            FileKind::Xlsx => report::ranking_workbook(&ranking),
            FileKind::Csv => report::ranking_csv(&ranking, false).into_bytes(),
            FileKind::Html | FileKind::Svg => {
                let fitted: Vec<&Fitted> = contenders.iter().map(|one| &one.fitted).collect();
                with_font(&carrying(&report::ranking_html(&ranking), &fitted, &data, &arguments.common))
            }
        };
        output::file(path, &arguments.data, &bytes)?;
    }
    output::print(&match arguments.common.format {
        Form::Text => table(&contenders, &ranked, arguments),
        Form::Json => as_json(&contenders, &ranked, &data),
    })
}

fn contend(
    mut theory: Theory,
    path: &std::path::Path,
    data: &[Measured],
    arguments: &Arguments,
    terminal: Terminal,
) -> Result<Contender, Failure> {
    let mut task = prepare::task(&mut theory.document, data, &arguments.common, terminal)?;
    let Some(text) = &arguments.predict_from else {
        return Ok(Contender { fitted: complete(theory, task, false)?, parts: None });
    };
    let time = theory.document.program.model.independent.unit.clone();
    let moment = Reader { model: &mut theory.document.program.model, terminal }.value(
        "--predict-from",
        text,
        &time,
        &task.parameters.clone(),
    )?;
    let mut fitted = complete(theory, task.clone(), false)?;
    // Values exactly at the time are predicted.
    task.until = Some(moment - 1e-9 * moment.abs().max(1e-9));
    let predicted = complete(prepare::theory(path, terminal)?, task, false)?;
    let (whole, after) = (&fitted.task, |time| time >= moment);
    let before = error(&fitted, |time| whole.covers(time) && !after(time));
    let rest = |time| whole.covers(time) && after(time);
    let after = error(&fitted, rest);
    if after.n == 0 {
        return Err(Failure::with_hint(
            format!("--predict-from {text}: no value is measured from there on"),
            "give a time before the end of the records",
        ));
    }
    let prediction = error(&predicted, rest);
    // The report shows the prediction in the place of the values outside a fitted part.
    for (own, predicted) in fitted.outcome.observations.iter_mut().zip(&predicted.outcome.observations) {
        own.outside = Some(predicted.error_where(|time, _| rest(time))).filter(|part| part.n > 0);
    }
    Ok(Contender { fitted, parts: Some([before, after, prediction]) })
}

/// Root mean square of the first observation's residuals at times that satisfy `inside`, over all records.
fn error(fitted: &Fitted, inside: impl Fn(f64) -> bool) -> Outside {
    let first = fitted.outcome.observations.iter().filter(|one| one.observation == 0);
    Outside::together(first.map(|one| one.error_where(|time, _| inside(time))))
}

/// Number of parameters that the data determined: values minus degrees of freedom.
fn numbers(fitted: &Fitted) -> usize {
    fitted.outcome.n.saturating_sub(fitted.outcome.dof)
}

/// Common number format of the residuals of all theories.
fn residuals(contenders: &[Contender]) -> Group {
    let outcomes = || contenders.iter().map(|one| &one.fitted.outcome);
    let parts = contenders.iter().filter_map(|one| one.parts.as_ref()).flatten().filter(|part| part.n > 0);
    let sizes: Vec<f64> = outcomes().map(|outcome| outcome.rmse).chain(parts.map(|part| part.rmse)).collect();
    let unit = outcomes().find_map(|outcome| outcome.observations.first()).map(|one| one.unit.clone());
    Group::of_residuals(&unit.unwrap_or_else(Unit::dimensionless), &sizes, 3, Style::POINT)
}

fn table(contenders: &[Contender], ranked: &[Ranked], arguments: &Arguments) -> String {
    let mut columns = Columns::default();
    let predicts = contenders.iter().any(|one| one.parts.is_some());
    let moment = arguments.predict_from.as_deref().unwrap_or_default();
    let (before, after) = (format!("before {moment}"), format!("after {moment}"));
    let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<String>>();
    let mut head = words(&["", "theory", "numbers", "ΔAICc", "weight", "RMSE"]);
    if predicts {
        head.extend([before, after, "predicted".to_owned()]);
    }
    columns.push(head);
    let residuals = residuals(contenders);
    for ranked in ranked {
        let one = &contenders[ranked.index];
        let mut row = vec![
            format!("{}.", ranked.place),
            one.fitted.theory.document.program.title.clone(),
            numbers(&one.fitted).to_string(),
            if ranked.difference.is_finite() { format!("{:.1}", ranked.difference) } else { "–".to_owned() },
            if ranked.weight < 1e-3 { "< 0.001".to_owned() } else { format!("{:.3}", ranked.weight) },
            residuals.quantity(one.fitted.outcome.rmse),
        ];
        if let Some(parts) = one.parts {
            row.extend(parts.map(|part| if part.n > 0 { residuals.quantity(part.rmse) } else { "–".to_owned() }));
        }
        columns.push(row);
    }
    let mut text = columns.text(&[false, false, true, true, true, true, true, true, true]);
    for (_, sentence) in tied(contenders, ranked) {
        let _ = writeln!(text, "\n{sentence}");
    }
    if let Some(first) = ranked.first().map(|ranked| &contenders[ranked.index].fitted) {
        let best = &first.outcome;
        let _ = writeln!(text, "\nOf the best: {}", best.verdict_text(Language::English));
        let worth = worth(best);
        if worth < 0.8 {
            let _ = writeln!(
                text,
                "The residuals are autocorrelated: {} values are worth about {:.0} independent ones. ΔAICc and the weights \
                 count each value {} times, and the prediction is the better judge.",
                best.n,
                best.independent,
                plain(worth, 2, Style::POINT)
            );
        }
        for remark in first.remarks() {
            let _ = writeln!(text, "{remark}");
        }
    }
    if let Some(moved) = contenders.iter().map(|one| beginnings(&one.fitted)).find(|found| !found.is_empty())
        && arguments.common.from.is_some()
    {
        for (record, when) in moved {
            let of = if record.is_empty() { String::new() } else { format!(" of {record}") };
            let _ = writeln!(text, "Equations of motion: initial values{of} hold at {when}.");
        }
    }
    for one in contenders.iter().filter(|one| one.fitted.outcome.rival.is_some()) {
        for sentence in searches(&one.fitted.outcome) {
            let _ = writeln!(text, "{}: {sentence}", one.fitted.theory.document.program.title);
        }
    }
    for one in contenders.iter().filter(|one| !one.fitted.outcome.converged) {
        let _ = writeln!(text, "The fit of {} did not converge.", one.fitted.theory.document.program.title);
    }
    for one in contenders {
        for undetermined in &one.fitted.outcome.undetermined {
            let _ = writeln!(
                text,
                "{}: {}",
                one.fitted.theory.document.program.title,
                undetermined.text(Language::English)
            );
        }
    }
    text
}

/// One sentence per place that several theories share.
fn tied(contenders: &[Contender], ranked: &[Ranked]) -> Vec<(usize, String)> {
    let outcomes: Vec<&Outcome> = contenders.iter().map(|one| &one.fitted.outcome).collect();
    let title = |index: usize| contenders[index].fitted.theory.document.program.title.clone();
    ties(ranked, &outcomes, Language::English, title)
}

fn as_json(contenders: &[Contender], ranked: &[Ranked], data: &[Measured]) -> String {
    let best = ranked.first().map(|ranked| &contenders[ranked.index].fitted.outcome);
    let worth = best.map(worth);
    let tied = tied(contenders, ranked);
    let rows: Vec<serde_json::Value> = ranked
        .iter()
        .map(|ranked| {
            let one = &contenders[ranked.index];
            let mut row = super::json::fit(&one.fitted, data);
            let unit = &one.fitted.outcome.rmse_unit;
            row["place"] = json!(ranked.place);
            row["tie"] = json!(tied.iter().find(|(place, _)| *place == ranked.place).map(|(_, sentence)| sentence));
            row["delta_aicc"] = json!(ranked.difference);
            row["weight"] = json!(ranked.weight);
            row["worth"] = json!(worth);
            if let Some([before, after, prediction]) = one.parts {
                row["rmse_before"] = json!(unit.from_si(before.rmse));
                row["rmse_after"] = json!(unit.from_si(after.rmse));
                row["rmse_predicted"] = json!(unit.from_si(prediction.rmse));
            }
            row
        })
        .collect();
    format!("{:#}\n", serde_json::Value::Array(rows))
}
