//! `meniscus run`: writes the table of a document row by row while it is computed.

mod drawn;
pub(crate) mod rows;

use crate::arguments::assignments::names_in;
use crate::arguments::run_settings::RunSettings;
use crate::arguments::settings;
use crate::arguments::{Format, Run};
use crate::failure::Failure;
use crate::load::{self, Loaded, Sources};
use crate::terminal::Terminal;
use crate::terminal::output::Output;
use crate::terminal::progress;
use document::Document;
use engine::table::Table;
use engine::{RunError, Setup, Subject};
use indicatif::ProgressBar;
use model::{Diagnostic, Span};
use rows::Rows;
use std::io::Write;
use std::path::Path;

/// Buffer size in bytes before rows are written.
const CHUNK: usize = 1 << 16;
/// Size in bytes of the run's history at which written rows are dropped.
const HISTORY: usize = 1 << 20;

/// Number of steps from which on progress is shown.
const LONG: u64 = 200_000;

/// Runs the document from 0 to the end.
pub fn run(arguments: &Run, terminal: Terminal) -> Result<(), Failure> {
    let Prepared { sources, document, setup, until } = prepare(&arguments.document, &arguments.settings, terminal)?;
    let model = &document.program.model;
    let table = match &arguments.columns {
        Some(names) => Table::select(model, &names.iter().flat_map(|text| names_in(text)).collect::<Vec<_>>())
            .map_err(|unknown| {
                let message = format!("there is no column `{}`", unknown.name);
                match unknown.near {
                    Some(near) => Failure::with_hint(message, format!("did you mean `{near}`?")),
                    None => Failure::with_hint(
                        message,
                        "columns are names of the document: states, quantities and parameters",
                    ),
                }
            })?,
        None => Table::new(model),
    };
    let failed = |error: RunError| failed(&sources, &document, &error, terminal);
    let mut run = engine::Run::start(model, setup).map_err(failed)?;
    // Uses the step of the run: a discrete model always has step 1.
    let steps = steps(until, run.setup().step)?;
    let output = match &arguments.output {
        Some(path) => Output::to(path, &sources)?,
        None => Output::standard(),
    };
    let progress = match steps {
        0..LONG => ProgressBar::hidden(),
        _ => progress::bar(steps, "steps", arguments.output.as_deref()),
    };
    let rows = Rows::new(table, format(arguments));
    let mut writer = Writer { output, rows, text: String::new() };
    writer.rows.head(&mut writer.text);
    let outcome = write_rows(&mut run, (steps, until), &mut writer, &progress);
    progress.finish_and_clear();
    for notice in run.notices() {
        let (message, hint) = (notice.message(model), notice.hint());
        // A notice without a subject is attributed to the equations.
        let subject = notice.subject().unwrap_or(Subject::State(0));
        let span = place(&document, subject).unwrap_or_default();
        terminal.report_one(&sources, &Diagnostic::warning(notice.code(), message, span).with_hint(hint));
    }
    match outcome? {
        None => writer.finish(),
        Some(error) if error.is_end() => {
            terminal.print(&format!("{}\n", error.message(model).text(terminal.language)));
            writer.finish()
        }
        Some(error) => {
            // The standard output stays well-formed. An output file is not created.
            if matches!(writer.output, Output::Standard(_)) {
                writer.finish()?;
            }
            Err(failed(error))
        }
    }
}

/// A document without errors, with the settings of its runs.
pub(crate) struct Prepared {
    pub sources: Sources,
    pub document: Document,
    pub setup: Setup,
    /// End of the runs, SI.
    pub until: f64,
}

/// Opens a document for runs with these settings. Findings are reported.
pub(crate) fn prepare(path: &Path, settings: &RunSettings, terminal: Terminal) -> Result<Prepared, Failure> {
    let sources = load::sources(path)?;
    // A button may be named by its translated title.
    let loaded = Loaded::open(if settings.press.is_empty() { sources.without_translations() } else { sources });
    terminal.report(&loaded);
    let refused = loaded.opened.has_errors();
    let Loaded { sources, opened } = loaded;
    let Some(mut document) = opened.document.filter(|_| !refused) else {
        return Err(Failure::Document);
    };
    let (mut setup, until) = settings::setup(&mut document, settings, terminal)?;
    drawn::draw(&mut document, &settings.draw)?;
    setup.drawings = document.program.model.drawings();
    Ok(Prepared { sources, document, setup, until })
}

/// Number of whole steps between 0 and `until`, tolerant to rounding.
fn steps(until: f64, step: f64) -> Result<u64, Failure> {
    let steps = (until / step * (1.0 + engine::ROUNDING)).floor();
    // Above this limit, step number times step is no longer exact.
    const MOST: f64 = (1_u64 << 53) as f64;
    if steps < MOST { Ok(steps as u64) } else { Err(Failure::request("--until is too many steps away")) }
}

/// Writes the rows of `steps` steps and the events up to `until`, SI. Returns the error that ended the run, if any.
fn write_rows(
    run: &mut engine::Run,
    (steps, until): (u64, f64),
    writer: &mut Writer,
    progress: &ProgressBar,
) -> Result<Option<RunError>, Failure> {
    writer.row(run.history(), 0)?;
    for done in 0..steps {
        // Written rows are dropped, so the length of a run is not limited by memory.
        if run.history().bytes() > HISTORY {
            run.forget();
            progress.set_position(done);
        }
        let written = run.history().len();
        let outcome = run.advance();
        for row in written..run.history().len() {
            writer.row(run.history(), row)?;
        }
        if let Err(error) = outcome {
            return Ok(Some(error));
        }
    }
    let written = run.history().len();
    let outcome = run.finish(until);
    for row in written..run.history().len() {
        writer.row(run.history(), row)?;
    }
    Ok(outcome.err())
}

/// Position of a part of the model in the document.
fn place(document: &Document, subject: Subject) -> Option<Span> {
    let places = &document.places;
    let span = match subject {
        Subject::Parameter(index) => places.parameters.get(index),
        Subject::State(index) => places.states.get(index),
        Subject::Event(index) => places.events.get(index),
    };
    span.copied()
}

/// Reports why a run cannot start or continue, with the position in the document if known.
pub(crate) fn failed(sources: &Sources, document: &Document, error: &RunError, terminal: Terminal) -> Failure {
    let span = error.subject().and_then(|subject| place(document, subject));
    let (message, hint) = (error.message(&document.program.model), error.hint());
    match span {
        Some(span) => {
            terminal.report_one(sources, &Diagnostic::error(error.code(), message, span).with_hint(hint));
        }
        None => terminal.error(&message.text(terminal.language), Some(&hint.text(terminal.language))),
    }
    Failure::Document
}

fn format(arguments: &Run) -> Format {
    let by_ending = || {
        let ending = arguments.output.as_ref()?.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "json" => Some(Format::Json),
            "jsonl" | "ndjson" => Some(Format::Jsonl),
            _ => None,
        }
    };
    arguments.format.or_else(by_ending).unwrap_or(Format::Csv)
}

/// Writer of the table.
struct Writer {
    output: Output,
    rows: Rows,
    text: String,
}

impl Writer {
    fn row(&mut self, history: &engine::History, row: usize) -> Result<(), Failure> {
        self.rows.row(history, row, &mut self.text);
        if self.text.len() >= CHUNK { self.write() } else { Ok(()) }
    }

    fn write(&mut self) -> Result<(), Failure> {
        let written = self.output.write_all(self.text.as_bytes());
        self.text.clear();
        written.map_err(|error| self.output.failure(&error))
    }

    fn finish(mut self) -> Result<(), Failure> {
        self.rows.end(&mut self.text);
        self.write()?;
        self.output.finish()
    }
}
