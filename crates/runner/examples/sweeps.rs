//! Prints the time in microseconds of a prepared sweep of 64 short runs of the U-tube, `sweep-call 12.3`, and how many times as fast
//! sweeps of the whole run are side by side as one by one, `sweep-utube 4.5` and `sweep-bouncing-ball 1.2`.

use engine::Setup;
use runner::{Axis, Plan, Points, Sweep, SweepCode, Table, Values};
use std::hint::black_box;
use std::time::Instant;

const RUNS: u64 = 64;
const ROUNDS: usize = 5;

/// End of the short runs, s.
const SHORT: f64 = 0.5;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // One thread: the other processors may be busy.
    runner::use_threads(1);
    let utube = Case::new(include_str!("../../../simulations/utube.md"), "b", "y at end", Some(SHORT))?;
    let code = utube.code();
    println!("sweep-call {:.1}", 1e6 * fastest(|| utube.table(&code), 1000));
    for (name, text, parameter, keep) in [
        ("utube", include_str!("../../../simulations/utube.md"), "b", "y at end, maximum(y)"),
        ("bouncing-ball", include_str!("../../../simulations/bouncing-ball.md"), "g", "maximum(y)"),
    ] {
        let case = Case::new(text, parameter, keep, None)?;
        let code = case.code();
        let alone = code.clone().one_by_one();
        println!("sweep-{name} {:.2}", fastest(|| case.table(&alone), 1) / fastest(|| case.table(&code), 1));
    }
    Ok(())
}

/// A document with a parameter that is varied.
struct Case {
    document: document::Document,
    setup: Setup,
    until: f64,
    plan: Plan,
    outcomes: program::Outcomes,
}

impl Case {
    fn new(text: &str, parameter: &str, keep: &str, until: Option<f64>) -> Result<Self, String> {
        let mut document = document::open(text, &[]).document.ok_or("the document has errors")?;
        let outcomes = runner::kept(&mut document, keep).map_err(|refusal| format!("{refusal:?}"))?;
        let model = &document.program.model;
        let setup = Setup::of(&document.program);
        let place = model.parameters.iter().position(|known| known.name == parameter);
        let place = place.ok_or_else(|| format!("no parameter {parameter}"))?;
        let value = setup.parameters[place];
        let values = Values::Range { low: 0.9 * value, high: 1.1 * value, step: None };
        let plan = Plan::new(vec![Axis { parameter: place, values }], Points::Halton(RUNS));
        let plan = plan.map_err(|error| format!("{error:?}"))?;
        let until = until.unwrap_or(document.program.end());
        Ok(Self { document, setup, until, plan, outcomes })
    }

    fn code(&self) -> SweepCode {
        SweepCode::new(&self.document.program.model, (&self.setup, self.until), &self.outcomes)
    }

    fn table(&self, code: &SweepCode) -> Table {
        let model = &self.document.program.model;
        let sweep = Sweep::new(model, (&self.setup, self.until), &self.plan, (&self.outcomes, code));
        Table::of_runs(model, &self.plan, &self.outcomes, &sweep.compute(0..RUNS))
    }
}

/// Seconds of one of `count` calls, the least of several rounds.
fn fastest<R>(mut work: impl FnMut() -> R, count: u32) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        for _ in 0..count {
            black_box(work());
        }
        least = least.min(start.elapsed().as_secs_f64() / f64::from(count));
    }
    least
}
