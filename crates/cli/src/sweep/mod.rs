//! `meniscus sweep`: runs a document with many values of its parameters and writes what is kept of each run.

pub(crate) mod arguments;
mod rows;

use crate::failure::Failure;
use crate::run::{Prepared, failed, prepare};
use crate::terminal::Terminal;
use crate::terminal::output::Output;
use crate::terminal::progress;
use arguments::Sweep;
use document::Document;
use engine::RunError;
use rows::Rows;
use runner::{Plan, Points, Sources, Table, Taken};
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
    let path = arguments.output.as_deref();
    let table = |taken: &Taken| Table::of_runs(&document.program.model, &plan, &outcomes, taken);
    let mut rows = Rows::begin(output, path, &table(&Taken::default()))?;
    let mut missing = Missing::default();
    let (mut next, mut together) = (runs.start, runner::Sweep::LEAST * runner::threads() as u64);
    while next < runs.end {
        let part = next..runs.end.min(next + together);
        let begun = Instant::now();
        let computed = sweep.compute(part.clone());
        rows.write(&table(&computed), path)?;
        missing.note(&computed);
        next = part.end;
        progress.set_position(next - runs.start);
        if begun.elapsed() < TOGETHER {
            together = (2 * together).min(MOST_TOGETHER);
        }
    }
    progress.finish_and_clear();
    rows.finish(path)?;
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

/// Runs that could not be computed.
#[derive(Default)]
struct Missing {
    count: u64,
    first: Option<(u64, RunError)>,
}

impl Missing {
    fn note(&mut self, taken: &Taken) {
        self.count += taken.errors().len() as u64;
        self.first = self.first.take().or_else(|| taken.errors().first().cloned());
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
