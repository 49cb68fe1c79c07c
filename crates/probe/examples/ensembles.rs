//! Prints the number of steps of the U-tube per second in millions, in an ensemble on one core for each kind of processor features:
//! `lanes-least 12.3`, `lanes-avx2 45.6` and `lanes 78.9`, and `lanes-best 12.3` for the best loop for one run.

use engine::{Method, Setup};
use ensemble::{Alone, Ensemble, Features, LANES};
use probe::Pace;
use std::hint::black_box;
use std::time::Instant;

/// Number of steps of a run.
const STEPS: u32 = 20_000;
const ROUNDS: usize = 5;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let opened = document::open(include_str!("../../../simulations/utube.md"), &[]);
    let program = opened.document.ok_or("the document has errors")?.program;
    let setup = Setup { method: Method::RungeKutta4, ..Setup::of(&program) };
    let damping = program.model.parameters.iter().position(|parameter| parameter.name == "b").ok_or("no b")?;
    let parameters = |run: usize| {
        let mut parameters = setup.parameters.clone();
        parameters[damping] *= 1.0 + 0.001 * run as f64;
        parameters
    };
    let parameters: Vec<Vec<f64>> = (0..LANES).map(parameters).collect();
    let until = f64::from(STEPS) * setup.step;
    let mut ensemble =
        Ensemble::new(&program.model, &setup, until, &[]).map_err(|reason| format!("no lanes: {reason:?}"))?;
    let mut alone = Alone::new(&program.model, &setup, &[]);
    let pace = Pace::new()?;
    let names = [(Features::Least, "lanes-least"), (Features::Avx2, "lanes-avx2"), (Features::Best, "lanes")];
    let (mut found, mut best) = ([0.0_f64; 3], 0.0_f64);
    // Alternating, with the best of each, to reduce the influence of other load on the machine.
    for _ in 0..ROUNDS {
        for ((features, _), found) in names.iter().zip(&mut found) {
            ensemble.use_features(*features);
            let start = Instant::now();
            black_box(ensemble.run(&mut alone, &parameters, &mut |_, _, _| ()));
            *found = found.max(f64::from(STEPS) * LANES as f64 / start.elapsed().as_secs_f64());
        }
        let steps = 100 * STEPS;
        let start = Instant::now();
        black_box(pace.best_by_hand(steps));
        best = best.max(f64::from(steps) / start.elapsed().as_secs_f64());
    }
    for ((_, name), found) in names.iter().zip(found) {
        println!("{name} {:.2}", found / 1e6);
    }
    println!("lanes-best {:.2}", best / 1e6);
    Ok(())
}
