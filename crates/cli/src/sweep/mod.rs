//! `meniscus sweep`: runs a document with many values of its parameters and writes what is kept of each run.

pub(crate) mod arguments;

use crate::failure::Failure;
use crate::run::{Prepared, failed, prepare};
use crate::terminal::Terminal;
use crate::terminal::output::Output;
use crate::terminal::progress;
use arguments::Sweep;
use document::Document;
use engine::RunError;
use engine::csv::Dialect;
use program::Outcomes;
use runner::{Outcome, Plan, Points, Sources, sweep_columns};
use std::fmt::Write as _;
use std::io::Write as _;
use std::ops::Range;
use std::time::{Duration, Instant};
use units::words;

/// Time for which runs are computed together before their rows are written.
const TOGETHER: Duration = Duration::from_millis(200);

/// Greatest number of runs that are computed together.
const MOST_TOGETHER: u64 = 1 << 14;

/// Runs the document with all values.
pub fn run(arguments: &Sweep, terminal: Terminal) -> Result<(), Failure> {
    if let Some(threads) = arguments.threads {
        runner::use_threads(threads);
    }
    let prepared = prepare(&arguments.document, &arguments.settings, terminal)?;
    let Prepared { sources, mut document, setup, until } = prepared;
    let plan = plan(&mut document, arguments, &setup.parameters)?;
    let outcomes = runner::kept(&mut document, &arguments.keep.join(", "))?;
    let output = match &arguments.output {
        Some(path) => Output::to(path, &sources)?,
        None => Output::standard(),
    };
    let code = runner::SweepCode::new(&document.program.model, (&setup, until), &outcomes);
    let sweep = runner::Sweep::new(&document.program.model, (&setup, until), &plan, (&outcomes, &code));
    let runs = plan.share(arguments.shard.number, arguments.shard.of.get());
    let progress = progress::bar(runs.end - runs.start, "runs", arguments.output.as_deref());
    let mut table = Table::new(output, &document, &plan, &outcomes);
    let mut missing = Missing::default();
    let (mut next, mut together) = (runs.start, runner::Sweep::LEAST * runner::threads() as u64);
    while next < runs.end {
        let part = next..runs.end.min(next + together);
        let begun = Instant::now();
        for outcome in sweep.compute(part.clone()) {
            table.row(&outcome)?;
            missing.note(outcome);
        }
        next = part.end;
        progress.set_position(next - runs.start);
        if begun.elapsed() < TOGETHER {
            together = (2 * together).min(MOST_TOGETHER);
        }
    }
    progress.finish_and_clear();
    table.finish()?;
    missing.report(&runs, (&sources, &document), terminal)
}

/// The runs, as `--over` says.
fn plan(document: &mut Document, arguments: &Sweep, parameters: &[f64]) -> Result<Plan, Failure> {
    let axes = arguments.over.iter().map(|text| runner::axis(document, text, parameters));
    let axes = axes.collect::<Result<Vec<_>, _>>()?;
    let points = match (arguments.random, arguments.halton) {
        (Some(runs), _) => Points::Random(runs, arguments.seed),
        (_, Some(runs)) => Points::Halton(runs),
        _ => Points::Grid,
    };
    Ok(runner::plan(&document.program.model, axes, points, &arguments.over)?)
}

/// Writer of the rows, as CSV.
struct Table<'a> {
    output: Output,
    document: &'a Document,
    plan: &'a Plan,
    /// Number of columns with what is kept.
    kept: usize,
    text: String,
}

impl<'a> Table<'a> {
    fn new(output: Output, document: &'a Document, plan: &'a Plan, outcomes: &Outcomes) -> Self {
        let mut text = "run".to_owned();
        for column in sweep_columns(&document.program.model, plan, outcomes).iter().flatten() {
            text.push(',');
            // Writing to a string cannot fail.
            let _ = Dialect::Lines.text(&mut text, &column.heading());
        }
        text.push('\n');
        Self { output, document, plan, kept: outcomes.curves.len(), text }
    }

    fn row(&mut self, outcome: &Outcome) -> Result<(), Failure> {
        let parameters = &self.document.program.model.parameters;
        let text = &mut self.text;
        // Writing to a string cannot fail.
        let _ = write!(text, "{}", outcome.run + 1);
        for (axis, value) in self.plan.axes().iter().zip(&outcome.axes) {
            text.push(',');
            if let Some(parameter) = parameters.get(axis.parameter) {
                let _ = match parameter.word(*value, &self.document.program.model.texts) {
                    Some(word) => Dialect::Lines.text(text, word),
                    None => Dialect::Lines.number(text, parameter.unit.from_si(*value)),
                };
            }
        }
        let taken = outcome.taken.as_deref().unwrap_or_default();
        for number in 0..self.kept {
            text.push(',');
            let _ = Dialect::Lines.number(text, taken.get(number).copied().unwrap_or(f64::NAN));
        }
        text.push('\n');
        self.write()
    }

    fn write(&mut self) -> Result<(), Failure> {
        let written = self.output.write_all(self.text.as_bytes());
        self.text.clear();
        written.map_err(|error| self.output.failure(&error))
    }

    fn finish(mut self) -> Result<(), Failure> {
        self.write()?;
        self.output.finish()
    }
}

/// Runs that could not be computed.
#[derive(Default)]
struct Missing {
    count: u64,
    first: Option<(u64, RunError)>,
}

impl Missing {
    fn note(&mut self, outcome: Outcome) {
        if let Err(error) = outcome.taken {
            self.count += 1;
            self.first.get_or_insert((outcome.run, error));
        }
    }

    /// Says how many runs are missing, and why the first one is. It is a failure if all are.
    fn report(
        self,
        runs: &Range<u64>,
        (sources, document): (&Sources, &Document),
        terminal: Terminal,
    ) -> Result<(), Failure> {
        let Some((run, error)) = self.first else { return Ok(()) };
        let (count, all) = (self.count, runs.end - runs.start);
        let why = words!("{count} of {all} runs could not be computed; the first is run {}", run + 1);
        terminal.error(&why.text(terminal.language), None);
        let failure = failed(sources, document, &error, terminal);
        if count == all { Err(failure) } else { Ok(()) }
    }
}
