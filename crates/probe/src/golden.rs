//! Golden runs: documents whose runs must have the same bits on every machine, with the golden results of measured data.

use crate::measured::golden_measured;
use engine::{Advance, Compiler, Method, Run, Setup};
use program::Seat;
use units::split_mix::scramble;
use wasm_bindgen::prelude::wasm_bindgen;

/// Name, text, method and end (SI) of each golden run. They cover every method, every function, events, random draws,
/// tables, vectors, columns, and equations that are solved in every step. The runs are short, because runs that differ
/// at all differ early.
const RUNS: [(&str, &str, Method, f64); 20] = [
    ("utube", UTUBE, Method::RungeKutta4, 100.0),
    ("utube", UTUBE, Method::Euler, 20.0),
    ("utube", UTUBE, Method::EulerRichardson, 20.0),
    ("utube", UTUBE, Method::VelocityVerlet, 20.0),
    ("utube", UTUBE, Method::DormandPrince, 20.0),
    ("utube", UTUBE, Method::Rosenbrock, 20.0),
    ("pendulum", PENDULUM, Method::RungeKutta4, 20.0),
    ("pendulum", PENDULUM, Method::DormandPrince, 20.0),
    ("double-pendulum", DOUBLE_PENDULUM, Method::RungeKutta4, 20.0),
    ("double-pendulum", DOUBLE_PENDULUM, Method::Rosenbrock, 5.0),
    ("bouncing-ball", BOUNCING_BALL, Method::RungeKutta4, 5.0),
    ("bouncing-ball", BOUNCING_BALL, Method::DormandPrince, 5.0),
    ("van-der-pol", VAN_DER_POL, Method::Rosenbrock, 50.0),
    ("functions", FUNCTIONS, Method::RungeKutta4, 20.0),
    ("functions", FUNCTIONS, Method::DormandPrince, 5.0),
    ("chance", CHANCE, Method::RungeKutta4, 20.0),
    ("chance", CHANCE, Method::DormandPrince, 10.0),
    ("tables", TABLES, Method::RungeKutta4, 10.0),
    ("tables", TABLES, Method::Rosenbrock, 5.0),
    ("chain", CHAIN, Method::RungeKutta4, 2.0),
];

pub(crate) const UTUBE: &str = include_str!("../../../simulations/utube.md");
const PENDULUM: &str = include_str!("../golden/pendulum.md");
const DOUBLE_PENDULUM: &str = include_str!("../../../simulations/double-pendulum.md");
const BOUNCING_BALL: &str = include_str!("../../../simulations/bouncing-ball.md");
const VAN_DER_POL: &str = include_str!("../golden/van-der-pol.md");
const CHAIN: &str = include_str!("../../../simulations/chain.md");
const FUNCTIONS: &str = include_str!("../golden/functions.md");
const CHANCE: &str = include_str!("../golden/chance.md");
const TABLES: &str = include_str!("../golden/tables.md");
const ASSIGNED: &str = include_str!("../golden/assigned.md");

/// Seats of the golden draws: with four assigned parameters 10^5 values.
const SEATS: u32 = 25_000;

/// Fingerprints of all golden runs, one line each: `name method end fingerprint`, and of the values assigned to seats:
/// `assigned seats learners fingerprint`, and golden results of measured data. They are stored in `golden.txt`.
#[wasm_bindgen]
pub fn golden() -> String {
    listed(fingerprint)
}

/// [`golden`] with the steps in emitted code where there is any; in WebAssembly only.
#[wasm_bindgen]
pub fn golden_emitted() -> String {
    let compiler = host::Compiler::default();
    listed(|text, method, until| said(run(text, method, until, Some(&compiler))))
}

fn listed(fingerprint: impl Fn(&str, &str, f64) -> String) -> String {
    let runs = RUNS.iter().map(|(name, text, method, until)| {
        let found = fingerprint(text, method.name(), *until);
        format!("{name} {} {until} {found}\n", method.name())
    });
    let assigned = assigned().unwrap_or_else(|message| message);
    runs.chain([format!("assigned {SEATS} {SEATS} {assigned}\n"), golden_measured()]).collect()
}

/// Hash of the values of the first seats, and of the seats of as many learners.
fn assigned() -> Result<String, String> {
    let program = setup(ASSIGNED)?.0.program;
    let values = program.assigned_values(SEATS).into_iter().flatten().map(f64::to_bits);
    let learners = (0..SEATS).map(|learner| Seat::of_learner("golden", &format!("learner {learner}")));
    let all = values.chain(learners.map(|seat| u64::from(seat.number())));
    Ok(format!("{:016x}", all.fold(0, |hash, bits| scramble(hash ^ bits))))
}

/// Fingerprint of a run from its start to `until`, SI: the hash of its history in 16 hexadecimal digits, or an error
/// message. `method`: name of the method.
#[wasm_bindgen]
pub fn fingerprint(document: &str, method: &str, until: f64) -> String {
    said(run(document, method, until, None))
}

fn said(run: Result<Run, String>) -> String {
    match run {
        Ok(run) => format!("{:016x}", run.history().fingerprint()),
        Err(message) => message,
    }
}

fn run(text: &str, method: &str, until: f64, compiler: Option<&dyn Compiler>) -> Result<Run, String> {
    let mut setup = setup(text)?;
    setup.1.method = method.parse().map_err(|_| format!("no method {method}"))?;
    let (document, setup) = setup;
    let mut run = Run::start(&document.program.model, setup).map_err(|error| error.to_string())?;
    if let Some(compiler) = compiler {
        run.compile(compiler);
    }
    while run.time() < until {
        if run.advance().map_err(|error| error.to_string())? == Advance::Full {
            break;
        }
    }
    Ok(run)
}

/// Opens a document. Returns it with the setup that it states.
pub(crate) fn setup(text: &str) -> Result<(document::Document, Setup), String> {
    let opened = document::open(text, &[]);
    let document = opened.document.ok_or_else(|| {
        let messages = opened.diagnostics.iter().map(|(_, diagnostic)| diagnostic.message.english());
        messages.collect::<Vec<_>>().join("; ")
    })?;
    let setup = Setup::of(&document.program);
    Ok((document, setup))
}
