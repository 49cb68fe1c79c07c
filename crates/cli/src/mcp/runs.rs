//! Tool `run`: a document with settings gives a table, statistics and events.

use super::answer::{Answer, Refused, data};
use super::given::RunSettings;
use super::summary::Summary;
use super::workplace::Call;
use crate::terminal::findings::Finding;
use document::Document;
use engine::csv::Dialect;
use engine::table::Table;
use engine::{Run, RunError, Setup, Subject};
use model::Diagnostic;
use rmcp::schemars::{self, JsonSchema};
use runner::names::names_in;
use runner::{Sources, in_keywords, place};
use serde::Deserialize;
use serde_json::Value;

/// Rows that are returned unless another number is asked for, and at most.
const ROWS: usize = 25;
const MOST_ROWS: usize = 1000;
/// Largest size of a table that is written, in bytes.
const LARGEST: usize = 64 << 20;

/// Arguments of `run`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Asked {
    /// Path of the document below the folder.
    document: Option<String>,
    /// The document itself, in place of a path.
    text: Option<String>,
    /// Settings in place of the document's own.
    #[serde(default)]
    settings: RunSettings,
    /// Columns by name, also parameters and constants; without it all that changes.
    columns: Option<Vec<String>>,
    /// Number of rows that are returned, 25 without it and at most 1000. Statistics are of all rows.
    rows: Option<usize>,
    /// Path of a CSV file to write with all rows; without it nothing is written.
    output: Option<String>,
}

/// Runs a document.
pub fn run(call: Call, asked: Asked) -> Result<Answer, Refused> {
    let theory = call.theory(asked.document.as_ref(), asked.text.as_ref())?;
    let (sources, mut document) = (theory.sources, theory.document);
    let (setup, until) = runner::setup(&mut document, &asked.settings.settings()?)?;
    let model = &document.program.model;
    let table = || match &asked.columns {
        Some(names) => runner::chosen_columns(model, &names.iter().flat_map(|text| names_in(text)).collect::<Vec<_>>()),
        None => Ok(Table::new(model)),
    };
    let mut summary = Summary::new(table()?, model, asked.rows.unwrap_or(ROWS).min(MOST_ROWS));
    let mut written = asked.output.as_ref().map(|_| table().map(|table| (table, String::new()))).transpose()?;
    if let Some((table, text)) = &mut written {
        // Writing to a string cannot fail.
        let _ = table.write_head(Dialect::Lines, text);
    }
    let failed = |error: &RunError| failed(call, (&sources, &document), error);
    let mut run = Run::start(model, setup).map_err(|error| failed(&error))?;
    let steps = runner::steps(&run, until)?;
    let outcome = runner::follow(&mut run, (steps, until), |history, rows, _| {
        summary.take(model, history, rows.clone());
        if let Some((table, text)) = &mut written {
            for row in rows {
                let _ = table.write_row(Dialect::Lines, history, row, text);
            }
            if text.len() > LARGEST {
                return Err(Refused::because("the table is too large; write fewer columns, or end the run earlier"));
            }
        }
        if call.goes_on() {
            Ok(())
        } else {
            Err(too_long(call, model.independent.unit.from_si(history.time(history.len() - 1))))
        }
    })?;
    let mut answer = summary.data();
    if let Some(error) = outcome {
        if !error.is_end() {
            return Err(failed(&error));
        }
        answer["ended"] = in_keywords(&error.message(model).text(call.language)).into();
    }
    let notices: Vec<Value> = run
        .notices()
        .into_iter()
        .map(|notice| {
            let span = place(&document, notice.subject().unwrap_or(Subject::State(0))).unwrap_or_default();
            let found = Diagnostic::warning(notice.code(), notice.message(model), span).with_hint(notice.hint());
            finding(call, (&sources, &document), &found)
        })
        .collect();
    answer["notices"] = notices.into();
    if let (Some(path), Some((_, text))) = (&asked.output, written) {
        call.write(path, text.as_bytes())?;
        answer["written"] = path.as_str().into();
    }
    Ok(Answer::Data(answer))
}

/// Refusal of a call that has taken too long; `reached` is where the run was.
pub fn too_long(call: Call, reached: f64) -> Refused {
    let seconds = call.workplace.seconds;
    Refused::because(format!(
        "the run was stopped after {seconds} s, at {reached}: state an earlier end with `until`, a longer step, or another method"
    ))
}

/// Refusal of a run that cannot start or go on.
pub fn failed(call: Call, document: (&Sources, &Document), error: &RunError) -> Refused {
    let (message, hint) = (error.message(&document.1.program.model), error.hint());
    let span = error.subject().and_then(|subject| place(document.1, subject)).unwrap_or_default();
    let found = Diagnostic::error(error.code(), message, span).with_hint(hint);
    Refused::with_findings("the run failed", [finding(call, document, &found)])
}

fn finding(call: Call, (sources, document): (&Sources, &Document), found: &Diagnostic) -> Value {
    let name = sources.path().display().to_string();
    data(Finding::new((name, &document.source), found, call.language))
}

/// The setup of a run of a document with settings, for other tools: the document may be changed by them.
pub fn prepared(
    call: Call,
    asked: (Option<&String>, Option<&String>),
    settings: &RunSettings,
) -> Result<(Document, Setup, f64), Refused> {
    let mut document = call.theory(asked.0, asked.1)?.document;
    let (setup, until) = runner::setup(&mut document, &settings.settings()?)?;
    Ok((document, setup, until))
}
