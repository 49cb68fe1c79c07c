//! Running extrema, integrals and other quantities of the past of a run, and events at equal intervals.

use crate::support::{jumps, model, run, setup, value};
use engine::{Method, Run};
use std::f64::consts::PI;

/// x = 2 cos t + 1: between 3 and -1, with the integral 2 sin t + t.
const SWING: &str = "x'' = 1 [m/s^2] - x/(1 [s^2])\nx(0) = 3 [m]\nx'(0) = 0\nhigh = maximum(x)\nlow = minimum(x)\n\
                     area = integral(x)\nmiddle = mean(x)\nspeed = maximum(abs(x'))\nmaximum_of = 2";

#[test]
fn extrema_and_integrals_of_an_oscillation() {
    for method in [Method::RungeKutta4, Method::DormandPrince, Method::Rosenbrock] {
        let model = model(SWING);
        // The extremum at t = pi lies between two rows, as do those of the speed.
        for (rows, low) in [(3, 1.0 + 2.0 * libm::cos(1.5)), (7, -1.0), (20, -1.0)] {
            let run = run(&model, setup(&model, method, 0.5), rows);
            let t = 0.5 * rows as f64;
            let error = if method == Method::RungeKutta4 { 1e-2 } else { 1e-5 };
            let speed = if t > PI / 2.0 { 2.0 } else { 2.0 * libm::sin(t) };
            let area = 2.0 * libm::sin(t) + t;
            for (name, expected) in
                [("high", 3.0), ("low", low), ("area", area), ("middle", area / t), ("speed", speed)]
            {
                let found = value(&model, &run, name);
                assert!((found - expected).abs() < error, "{method}, {rows}: {name} is {found} for {expected}");
            }
        }
        let start = run(&model, setup(&model, method, 0.5), 0);
        for (name, expected) in [("high", 3.0), ("low", 3.0), ("area", 0.0), ("middle", 3.0), ("speed", 0.0)] {
            assert_eq!(value(&model, &start, name), expected, "{method}: {name}");
        }
    }
}

/// The greatest speed of a ball so far is that of its impact, where the speed jumps down.
#[test]
fn the_maximum_before_a_jump_counts() {
    let model = model(
        "y'' = -9.8 [m/s^2]\ny(0) = 4.9 [m]\ny'(0) = 0\nv = maximum(abs(y'))\nh = maximum(if t > 1 [s] then y else 0)\n\
         when y < 0 [m] { y' = -0.5*y' }",
    );
    for method in [Method::RungeKutta4, Method::DormandPrince] {
        // After 3 s there would be infinitely many bounces.
        let run = run(&model, setup(&model, method, 0.3), 9);
        assert!((value(&model, &run, "v") - 9.8).abs() < 1e-9, "{method}: {}", value(&model, &run, "v"));
        // The second flight rises to a quarter.
        assert!((value(&model, &run, "h") - 1.225).abs() < 1e-9, "{method}: {}", value(&model, &run, "h"));
    }
}

#[test]
fn events_at_equal_intervals() {
    let text = "discrete n = 0\ndiscrete m = 0\nevery 0.1 [s] from 0 [s] as tick { n = n + 1 }\n\
                every 0.25 [s] from 0.4 [s] { let more = m + 1, m = more }\nT = tick.time";
    let model = model(text);
    for method in [Method::RungeKutta4, Method::DormandPrince] {
        let run = run(&model, setup(&model, method, 0.7), 10);
        // At 0.1, 0.2 ... 7.0 s, and at 0.4, 0.65 ... 6.9 s; the last of the first lies at the very end.
        assert!((69.0..=70.0).contains(&run.state()[0]), "{method}: {}", run.state()[0]);
        assert_eq!(run.state()[1], 27.0, "{method}");
        let moments = jumps(&run);
        assert!(moments.contains(&(3.0 * 0.1)) && moments.contains(&(0.4 + 2.0 * 0.25)), "{method}: {moments:?}");
        let last = value(&model, &run, "T");
        assert!(last == 69.0 * 0.1 || last == 70.0 * 0.1, "{method}: {last}");
    }
    // A hostile interval stops the run as any events without end do.
    let hostile = crate::support::model("discrete n = 0\nevery 1e-12 [s] { n = n + 1 }");
    let mut run = Run::start(&hostile, setup(&hostile, Method::RungeKutta4, 0.05)).expect("starts");
    assert_eq!(run.advance().expect_err("too many").code(), "too-many-events");
    // The words are free as names.
    crate::support::model(
        "every = 2\nfrom = 3\nmean = every + from\nmaximum = mean\nintegral = 1\ny' = maximum*(1 [1/s])\ny(0) = 0",
    );
}

/// The moments are known in advance and need no search: each costs less than ten steps.
#[test]
fn events_at_equal_intervals_cost_little() {
    let work = |interval: &str| {
        let text = format!(
            "x'' = -4 [1/s^2]*x\nx(0) = 1 [m]\nx'(0) = 0\ndiscrete n = 0\nevery {interval} [s] {{ n = n + 1 }}"
        );
        let model = model(&text);
        run(&model, setup(&model, Method::RungeKutta4, 0.01), 10_000).work() as f64
    };
    let without = work("1000");
    for (interval, events) in [("0.5", 200.0), ("0.313", 319.0)] {
        let steps = (work(interval) - without) / (without / 10_000.0);
        assert!(steps < 10.0 * events, "every {interval} s: as much as {steps} steps");
    }
}
