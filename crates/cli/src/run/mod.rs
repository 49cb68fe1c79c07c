//! `meniscus run`: writes the table of a document row by row while it is computed.

pub(crate) mod rows;

use crate::arguments::run_settings::RunSettings;
use crate::arguments::{Format, Run};
use crate::failure::Failure;
use crate::terminal::Terminal;
use crate::terminal::output::Output;
use crate::terminal::progress;
use crate::{data, load};
use document::Document;
use engine::table::Table;
use engine::{RunError, Setup, Subject};
use indicatif::ProgressBar;
use model::Diagnostic;
use rows::Rows;
use runner::names::{Assignment, names_in};
use runner::records::Stated;
use runner::{Loaded, Sources, place};
use std::io::Write;
use std::path::Path;

/// Buffer size in bytes before rows are written.
const CHUNK: usize = 1 << 16;

/// Number of steps between two changes of the progress.
const SHOWN: u64 = 1 << 12;

/// Number of steps from which on progress is shown.
const LONG: u64 = 200_000;

/// Runs the document from 0 to the end.
pub fn run(arguments: &Run, terminal: Terminal) -> Result<(), Failure> {
    let Prepared { sources, document, setup, until } = prepare(&arguments.document, &arguments.settings, terminal)?;
    let model = &document.program.model;
    let table = match &arguments.columns {
        Some(names) => {
            runner::chosen_columns(model, &names.iter().flat_map(|text| names_in(text)).collect::<Vec<_>>())?
        }
        None => Table::new(model),
    };
    let failed = |error: RunError| failed(&sources, &document, &error, terminal);
    let mut run = engine::Run::start(model, setup).map_err(failed)?;
    let steps = runner::steps(&run, until)?;
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
    let outcome = runner::follow(&mut run, (steps, until), |history, rows, done| {
        if done % SHOWN == 0 {
            progress.set_position(done);
        }
        rows.into_iter().try_for_each(|row| writer.row(history, row))
    });
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
    let Some((sources, mut document)) = loaded.sound() else { return Err(Failure::Document) };
    let (mut setup, until) = runner::setup(&mut document, &settings.into())?;
    for Assignment { name, value } in &settings.draw {
        runner::draw(&mut document, &mut setup, name, || data::read(Path::new(value), Stated::default()))?;
    }
    Ok(Prepared { sources, document, setup, until })
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
