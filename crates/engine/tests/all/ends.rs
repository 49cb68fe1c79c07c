//! Events at the end of a run take place, in every form in which they can be written.

use crate::support::{model, setup};
use engine::{Advance, Method, Press, Run, RunError};
use program::Model;

/// A run until `end` with all events there, and the error that ended it.
fn until(model: &Model, method: Method, step: f64, end: f64, presses: &[Press]) -> (Run, Option<RunError>) {
    let mut setup = setup(model, method, step);
    setup.presses = presses.to_vec();
    let mut run = Run::start(model, setup).unwrap();
    let rows = (end / step * (1.0 + 1e-12)).floor() as usize;
    for _ in 0..rows {
        if let Err(error) = run.advance() {
            return (run, Some(error));
        }
    }
    let error = run.finish(end).err();
    (run, error)
}

/// The forms of an event that happens `count` times at multiples of `interval`, with what else a model needs.
fn forms(interval: &str, end: &str) -> [(String, bool); 9] {
    let flows = "x' = 1 [m/s]\nx(0) = 0 [m]\n";
    [
        (format!("every {interval} [s] {{ n = n + 1 }}"), true),
        (format!("every {interval} [s] from 0 [s] {{ n = n + 1 }}"), true),
        (format!("parameter T = {interval} [s]\nevery T as beat {{ n = n + 1 }}"), true),
        (format!("when t >= {end} [s] {{ n = n + 1 }}"), false),
        (format!("when t > {end} [s] {{ n = n + 1 }}"), false),
        (format!("when t == {end} [s] {{ n = n + 1 }}"), false),
        (format!("when x >= {end} [m] {{ n = n + 1 }}"), false),
        (format!("when x > {end} [m] {{ n = n + 1 }}"), false),
        (format!("when x + 1 [m] >= {end} [m] + 1 [m] {{ n = n + 1 }}"), false),
    ]
    .map(|(event, every)| (format!("{flows}discrete n = 0\n{event}\n"), every))
}

#[test]
fn an_event_at_the_end_counts_in_every_form() {
    for (interval, count, step) in
        [("1", 3, 0.05), ("0.1", 7, 0.05), ("0.3", 11, 0.1), ("0.99", 3, 0.05), ("0.07", 43, 0.01), ("2.5", 4, 0.25)]
    {
        let end = interval.parse::<f64>().unwrap() * f64::from(count);
        for method in [Method::Euler, Method::RungeKutta4, Method::DormandPrince, Method::Rosenbrock] {
            for (text, every) in forms(interval, &format!("{end}")) {
                let model = model(&text);
                let (run, error) = until(&model, method, step, end, &[]);
                assert_eq!(error, None);
                let happened = run.history().column(1)[run.history().len() - 1];
                let expected = if every { f64::from(count) } else { 1.0 };
                assert_eq!(happened, expected, "{method}, end {end}, step {step}:\n{text}");
                assert!((run.time() - end).abs() < step, "{method}: {}", run.time());
                assert!(run.time() <= end * (1.0 + 1e-12));
            }
        }
    }
}

#[test]
fn an_event_behind_the_end_does_not() {
    for method in [Method::RungeKutta4, Method::DormandPrince] {
        for form in ["every 1.01 [s]", "when t >= 3.001 [s]", "when x > 3.0001 [m]", "every 1 [s] from 3.01 [s]"] {
            let model = model(&format!("x' = 1 [m/s]\nx(0) = 0 [m]\ndiscrete n = 0\n{form} {{ n = n + 1 }}\n"));
            let (run, _) = until(&model, method, 0.05, 3.0, &[]);
            let before = if form == "every 1.01 [s]" { 2.0 } else { 0.0 };
            assert_eq!(run.history().column(1)[run.history().len() - 1], before, "{method}: {form}");
        }
    }
}

#[test]
fn a_phase_shifts_the_last_moment() {
    for (phase, end, count) in [("0.5", 3.5, 4.0), ("0.5", 3.4, 3.0), ("1", 3.0, 3.0), ("3", 3.0, 1.0)] {
        for method in [Method::RungeKutta4, Method::DormandPrince] {
            let text =
                format!("x' = 1 [m/s]\nx(0) = 0 [m]\ndiscrete n = 0\nevery 1 [s] from {phase} [s] {{ n = n + 1 }}\n");
            let model = model(&text);
            let (run, _) = until(&model, method, 0.05, end, &[]);
            assert_eq!(run.history().column(1)[run.history().len() - 1], count, "{method}, from {phase} until {end}");
        }
    }
}

#[test]
fn the_rows_are_those_of_a_longer_run_and_it_goes_on_with_the_same_bits() {
    let text = "x'' = -4 [1/s^2]*x\nx(0) = 1 [m]\nx'(0) = 0\ndiscrete n = 0\n\
        every 0.5 [s] { x' = x' + 0.1 [m/s], n = n + 1 }\nwhen t >= 1.5 [s] { x = 0.9*x }\nwhen x < 0.2 [m] { n = n + 100 }\n\
        button \"Kick\" { x' = x' + 1 [m/s] }\n";
    let model = model(text);
    let presses = [Press { time: 1.0, button: 0 }, Press { time: 1.5, button: 0 }];
    for method in [Method::Euler, Method::RungeKutta4, Method::DormandPrince, Method::Rosenbrock] {
        for end in [0.5, 1.0, 1.5, 2.0, 1.48, 2.31] {
            let (whole, _) = until(&model, method, 0.05, 3.0, &presses);
            let (mut run, _) = until(&model, method, 0.05, end, &presses);
            let count = run.history().len();
            assert_eq!(run.history().times(), &whole.history().times()[..count], "{method}, {end}");
            let next = whole.history().times().get(count).copied().unwrap_or(f64::INFINITY);
            assert!(next > end, "{method}, {end}: {next} is missing");
            while run.time() < 2.99 {
                assert_ne!(run.advance().unwrap(), Advance::Full);
            }
            run.finish(3.0).unwrap();
            assert_eq!(run.history().fingerprint(), whole.history().fingerprint(), "{method}, {end}");
        }
    }
}

#[test]
fn what_ends_a_run_at_its_end_is_reported() {
    let model = model("x' = 1 [m/s]\nx(0) = 0 [m]\nwhen t >= 3 [s] { stop }\n");
    for method in [Method::RungeKutta4, Method::DormandPrince] {
        let (_, error) = until(&model, method, 0.05, 3.0, &[]);
        assert!(error.unwrap().is_end());
    }
}

#[test]
fn a_press_at_the_end_acts() {
    let model = model("x' = 0 [m/s]\nx(0) = 0 [m]\nbutton \"Set\" { x = x + 1 [m] }\n");
    for method in [Method::RungeKutta4, Method::DormandPrince] {
        let (run, _) =
            until(&model, method, 0.05, 3.0, &[Press { time: 3.0, button: 0 }, Press { time: 3.0, button: 0 }]);
        assert_eq!(value_of(&run), 2.0);
    }
    let counting = model_of_counts();
    let (run, _) = until(&counting, Method::Euler, 1.0, 3.0, &[Press { time: 3.0, button: 0 }]);
    assert_eq!(value_of(&run), 13.0);
}

fn value_of(run: &Run) -> f64 {
    run.history().column(0)[run.history().len() - 1]
}

fn model_of_counts() -> Model {
    model("independent k by 1\nnext p = p + 1\np(0) = 0\nbutton \"Set\" { p = p + 10 }\n")
}

#[test]
fn where_the_variable_counts_the_last_count_has_its_events() {
    for interval in 1..=4_u32 {
        let model = model(&format!("independent k by 1\ndiscrete n = 0\nevery {interval} {{ n = n + 1 }}\n"));
        for end in 1..=9_u32 {
            let (run, _) = until(&model, Method::Euler, 1.0, f64::from(end), &[]);
            assert_eq!(value_of(&run), f64::from(end / interval), "every {interval} until {end}");
        }
    }
}
