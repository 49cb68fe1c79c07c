//! Random draws in runs.

use crate::support::{model, parameter, run, setup};
use engine::{Method, Run, Setup};
use program::Model;

const DECAY: &str = "random seed = 1 in 1..9999 \"Seed\"\nparameter lambda = 0.5 [1/s]\ndiscrete N = 100000 \"Nuclei\"\n\
                     every 0.1 [s] as tick { N = N - binomial(N, 1 - exp(-lambda*0.1 [s])) }\n\
                     x'' = -x/(1 [s^2])\nx(0) = normal(0 [m], 1 [m])\nx'(0) = 0\n";

fn seeded(model: &Model, seed: f64, method: Method, step: f64) -> Setup {
    let mut setup = setup(model, method, step);
    setup.parameters[parameter(model, "seed")] = seed;
    setup
}

fn column<'a>(model: &Model, run: &'a Run, name: &str) -> &'a [f64] {
    let state = model.states.iter().position(|state| state.variable == name).expect("a state");
    run.history().column(state)
}

/// Mean N_0 exp(-lambda t), variance N_0 exp(-lambda t)(1 - exp(-lambda t)): the nuclei decay independently.
#[test]
fn nuclei_decay_exponentially() {
    let model = model(DECAY);
    let (seeds, whole) = (40, 100_000.0);
    let ends: Vec<f64> = (1..=seeds)
        .map(|seed| {
            // To 4.25 s, after the tick at 4.2 s.
            let run = run(&model, seeded(&model, f64::from(seed), Method::RungeKutta4, 0.25), 17);
            column(&model, &run, "N").last().copied().unwrap_or(f64::NAN)
        })
        .collect();
    let part = libm::exp(-0.5 * 4.2);
    let deviation = (whole * part * (1.0 - part)).sqrt();
    for end in &ends {
        assert!((end - whole * part).abs() < 5.0 * deviation, "{end} and not {} ± {deviation}", whole * part);
    }
    let mean = ends.iter().sum::<f64>() / f64::from(seeds);
    let error = deviation / f64::from(seeds).sqrt();
    assert!((mean - whole * part).abs() < 5.0 * error, "{mean} and not {} ± {error}", whole * part);
    let spread = ends.iter().map(|end| (end - whole * part) * (end - whole * part)).sum::<f64>() / f64::from(seeds);
    let error = deviation * deviation * (2.0 / f64::from(seeds)).sqrt();
    assert!((spread - deviation * deviation).abs() < 5.0 * error, "{spread} and not {}", deviation * deviation);
}

/// The draws do not depend on step, method, going back or the division of the work.
#[test]
fn draws_do_not_depend_on_the_way() {
    let model = model(DECAY);
    let of = |method, step: f64, rows| {
        let run = run(&model, seeded(&model, 7.0, method, step), rows);
        let mut counts = column(&model, &run, "N").to_vec();
        counts.dedup();
        (counts, column(&model, &run, "x")[0])
    };
    let (expected, start) = of(Method::RungeKutta4, 0.05, 101);
    assert_eq!(expected.len(), 51);
    for (method, step, rows) in [
        (Method::RungeKutta4, 0.025, 202),
        (Method::Euler, 0.3, 17),
        (Method::DormandPrince, 0.25, 21),
        (Method::Rosenbrock, 0.05, 101),
    ] {
        let (counts, own) = of(method, step, rows);
        assert_eq!((&counts[..50], own), (&expected[..50], start), "{method} {step}");
    }
    let mut run = run(&model, seeded(&model, 7.0, Method::DormandPrince, 0.05), 60);
    let fingerprint = run.history().fingerprint();
    run.truncate(13);
    while run.history().times().last().is_some_and(|&time| time < 2.999) {
        run.advance().expect("goes on");
    }
    assert_eq!(run.history().fingerprint(), fingerprint);
}

/// Two draws of one action, of two family members, or of two events differ; `let` draws once.
#[test]
fn each_draw_has_its_own_number() {
    let model = model(
        "independent k by 1\nrandom seed = 3\nsize N = 3\ndiscrete a = uniform(0, 1)\ndiscrete b = uniform(0, 1)\n\
         discrete c = 0\ndiscrete d = 0\nnext x[i] = uniform(0, 1) for i in 1..N\nx[i](0) = uniform(0, 1) for i in 1..N\n\
         every 1 { let u = uniform(0, 1), a = u, b = uniform(0, 1), c = u + uniform(0, 1) - uniform(0, 1) }\n\
         every 1 { d = pick(1, 2, 5, 9) }\n",
    );
    let run = run(&model, Setup::defaults(&model), 2000);
    let of = |name: &str| column(&model, &run, name);
    let mut all: Vec<u64> =
        ["a", "b", "x[1]", "x[2]", "x[3]"].iter().flat_map(|name| of(name)).map(|value| value.to_bits()).collect();
    let count = all.len();
    all.sort_unstable();
    all.dedup();
    assert_eq!(all.len(), count, "no number comes twice");
    assert!(of("c").iter().zip(of("a")).skip(1).all(|(c, a)| c != a && (c - a).abs() < 1.0));
    for value in [1.0, 2.0, 5.0, 9.0] {
        let found = of("d").iter().filter(|&&d| d == value).count() as f64;
        assert!((found - 500.0).abs() < 5.0 * 375_f64.sqrt(), "{value}: {found}");
    }
}

/// A walk with steps of ±1 has the variance k after k steps.
#[test]
fn a_random_walk_spreads_with_the_root_of_time() {
    let model = model("independent k by 1\nrandom seed = 1\nnext x = x + pick(-1, 1)\nx(0) = 0\n");
    let walks = 400;
    let squares = (1..=walks).map(|seed| {
        let run = run(&model, seeded(&model, f64::from(seed), Method::Euler, 1.0), 100);
        run.state()[0] * run.state()[0]
    });
    let mean = squares.sum::<f64>() / f64::from(walks);
    // The fourth moment of a sum of k signs is 3 k² - 2 k.
    let error = ((2.0 * 100.0 * 100.0 - 2.0 * 100.0) / f64::from(walks)).sqrt();
    assert!((mean - 100.0).abs() < 5.0 * error, "{mean} ± {error}");
}

/// Reference bits of a run, equal on all machines.
#[test]
fn the_bits_of_a_random_run() {
    let model = model(
        "independent k by 1\nrandom seed = 1\nnext a = normal(a, 1)\nnext b = b + exponential(2)\nnext c = c + poisson(3) - poisson(40)\n\
         next d = binomial(1000, 0.3)\na(0) = 0\nb(0) = 0\nc(0) = 0\nd(0) = 0\n",
    );
    let run = run(&model, Setup::defaults(&model), 500);
    assert_eq!(run.history().fingerprint(), GOLDEN);
}

const GOLDEN: u64 = 14_811_118_980_968_901_106;
