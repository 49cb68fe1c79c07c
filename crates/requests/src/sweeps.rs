//! Sweeps: many runs, and what is kept of each.

use crate::diagnostic::Diagnostic;
use crate::fault::{Fault, read, run_diagnostic};
use crate::host::Host;
use crate::opened::Opened;
use crate::prepared::Kept;
use crate::reply::Reply;
use crate::settings::Prepared;
use crate::table;
use model::Severity;
use runner::{Points, Sources, Sweep, Taken};
use serde::Deserialize;
use serde_json::value::RawValue;
use std::sync::Arc;
use units::words;

/// Numbers of runs that are computed before the host is asked whether it goes on, for each processor: at first if they are short, and at
/// most.
const FIRST: u64 = 64;
const MOST: u64 = 1 << 11;
/// Time that these runs may take, s: half of that is too short, more too long.
const MOMENT: f64 = 0.1;

/// A sweep that is asked for.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request<'a> {
    /// A `Preparation`. The same text as that of the last sweep needs no other one.
    #[serde(borrow)]
    prepare: &'a RawValue,
    /// Number of samples.
    random: Option<u64>,
    halton: Option<u64>,
    seed: u64,
    /// Number of the share from 1, and number of shares.
    #[serde(default = "whole")]
    shard: (u64, u64),
}

/// The share that is all runs.
fn whole() -> (u64, u64) {
    (1, 1)
}

/// Computes a sweep and returns its table.
pub fn sweep(host: &dyn Host, opened: &Opened, request: &str, numbers: &[Vec<f64>]) -> Result<Reply, Fault> {
    let Request { prepare, random, halton, seed, shard: (number, of) } = read(request)?;
    let points = match (random, halton) {
        (Some(_), Some(_)) => return Err(Fault::Value("random and halton exclude each other".to_owned())),
        (Some(runs), None) => Points::Random(runs, seed),
        (None, Some(runs)) => Points::Halton(runs),
        (None, None) => Points::Grid,
    };
    if !(1..=of).contains(&number) {
        let message = "shard must be (number, shards), such as (3, 16) for the third of 16 parts";
        return Err(Fault::Value(message.to_owned()));
    }
    let kept = match opened.last_sweep().filter(|kept| kept.request == prepare.get()) {
        Some(kept) => kept,
        None => {
            let kept = Arc::new(Kept::new(host, opened.theory(), prepare.get())?);
            opened.keep(&kept);
            kept
        }
    };
    let Prepared { document, setup, until } = &kept.prepared;
    let model = &document.program.model;
    let plan = kept.plan(points, numbers)?;
    let sweep = Sweep::new(model, (setup, *until), &plan, (&kept.outcomes, &kept.code));
    let runs = plan.share(number - 1, of);
    let mut taken = Taken::starting_at(runs.start);
    let (mut next, mut each) = (runs.start, if kept.code.is_short() { FIRST } else { Sweep::LEAST });
    while next < runs.end {
        let part = next..runs.end.min(next + each * runner::threads() as u64);
        next = part.end;
        let begun = host.seconds();
        taken.append(sweep.compute(part));
        if !host.goes_on() {
            return Err(Fault::Interrupted);
        }
        each = match host.seconds() - begun {
            long if long > MOMENT => (each / 2).max(Sweep::LEAST),
            short if short < 0.5 * MOMENT => (2 * each).min(MOST),
            _ => each,
        };
    }
    let computed = runner::Table::of_runs(model, &plan, &kept.outcomes, &taken);
    table::reply(computed, missing(&taken, &opened.theory().sources, &kept), None)
}

/// How many runs could not be computed, and why the first one could not.
fn missing(taken: &Taken, sources: &Sources, kept: &Kept) -> Vec<Diagnostic> {
    let [(run, error), ..] = taken.errors() else { return Vec::new() };
    let (count, all) = (taken.errors().len(), taken.runs().count());
    let why = words!("{count} of {all} runs could not be computed; the first is run {}", run + 1);
    let summary = Diagnostic::without_place(Severity::Warning, "", &why, None);
    vec![summary, run_diagnostic((sources, &kept.prepared.document), error)]
}
