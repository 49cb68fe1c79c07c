//! One run, row by row.

use crate::diagnostic::Diagnostic;
use crate::fault::{Fault, read, run_diagnostic};
use crate::host::Host;
use crate::opened::Opened;
use crate::reply::Reply;
use crate::settings::{Asked, Prepared};
use crate::table;
use engine::{Run, Subject};
use runner::fitting::Theory;
use runner::{in_keywords, place};
use serde::Deserialize;

/// Steps of a run after which the host is asked whether it goes on.
const STEPS: u64 = 1 << 14;

/// A run that is asked for.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    /// Names of columns; all if missing.
    columns: Option<Vec<String>>,
    settings: Asked,
}

/// Makes a run and returns its table.
pub fn run(host: &dyn Host, opened: &Opened, request: &str) -> Result<Reply, Fault> {
    let Request { columns, settings } = read(request)?;
    let Theory { sources, .. } = opened.theory();
    let Prepared { document, setup, until } = settings.prepare(host, opened.theory())?;
    let model = &document.program.model;
    let mut reader = match columns {
        None => engine::table::Table::new(model),
        Some(columns) => {
            let names: Vec<&str> = columns.iter().flat_map(|text| runner::names::names_in(text)).collect();
            runner::chosen_columns(model, &names)?
        }
    };
    let failed = |error: &engine::RunError| Fault::Run(Box::new(run_diagnostic((sources, &document), error)));
    let mut table = runner::Table::of_run(&reader);
    let mut run = Run::start(model, setup).map_err(|error| failed(&error))?;
    if let Some(compiler) = host.compiler() {
        run.compile(compiler);
    }
    let steps = runner::steps(&run, until)?;
    let failure = runner::follow(&mut run, (steps, until), |history, rows, done| {
        let rows_taken = rows.len();
        table.take(&mut reader, history, rows);
        if (rows_taken == 0 || done % STEPS == 0) && !host.goes_on() { Err(Fault::Interrupted) } else { Ok(()) }
    })?;
    let notices = run.notices().into_iter().map(|notice| {
        let span = place(&document, notice.subject().unwrap_or(Subject::State(0))).unwrap_or_default();
        let found = model::Diagnostic::warning(notice.code(), notice.message(model), span).with_hint(notice.hint());
        Diagnostic::new(sources, 0, &found)
    });
    let ended = match failure {
        Some(error) if error.is_end() => Some(in_keywords(&error.message(model).english())),
        Some(error) => return Err(failed(&error)),
        None => None,
    };
    table::reply(table, notices.collect(), ended)
}
