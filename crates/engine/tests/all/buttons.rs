//! Presses of buttons, which are part of the setup of a run.

use crate::support::{jumps, model, run, setup};
use engine::{Cause, Method, Press, Run, Setup};
use program::Model;

const KICKED: &str = "
parameter w = 2 [rad/s]
x'' + w^2*x = 0
x(0) = 0.3 [m]
x'(0) = 0 [m/s]
button \"Kick\" as kick { x' = x' + 1 [m/s] }
button \"Stop\" { x' = 0 [m/s] }
n = kick.count
before = kick.x'
";

/// x(t) of an oscillator that is kicked with 1 m/s at these times.
fn kicked(kicks: &[f64], time: f64) -> f64 {
    let w = 2.0;
    let kick = |at: &f64| if time > *at { libm::sin(w * (time - at)) / w } else { 0.0 };
    0.3 * libm::cos(w * time) + kicks.iter().map(kick).sum::<f64>()
}

fn presses(presses: &[(f64, usize)]) -> Vec<Press> {
    presses.iter().map(|&(time, button)| Press { time, button }).collect()
}

fn pressed(model: &Model, method: Method, step: f64, list: &[(f64, usize)]) -> Setup {
    Setup { presses: presses(list), tolerance: 1e-12, ..setup(model, method, step) }
}

#[test]
fn a_kicked_oscillator_follows_the_closed_form() {
    let model = model(KICKED);
    for (method, step, near) in [
        (Method::Euler, 5e-5, 4e-3),
        (Method::EulerRichardson, 2e-4, 1e-6),
        (Method::VelocityVerlet, 2e-4, 1e-6),
        (Method::RungeKutta4, 2.5e-3, 1e-9),
        (Method::DormandPrince, 0.05, 1e-9),
        (Method::Rosenbrock, 0.05, 1e-9),
    ] {
        // On the grid, between two points of it, at the start, and twice at one moment.
        for kicks in [vec![3.2], vec![3.2123], vec![0.0], vec![0.0, 1.7, 1.7]] {
            let list: Vec<(f64, usize)> = kicks.iter().map(|&at| (at, 0)).collect();
            let run = run(&model, pressed(&model, method, step, &list), (5.0 / step).round() as usize);
            let history = run.history();
            let worst = (0..history.len())
                .filter(|&row| row + 1 == history.len() || history.time(row + 1) > history.time(row))
                .map(|row| (history.column(0)[row] - kicked(&kicks, history.time(row))).abs())
                .fold(0.0, f64::max);
            assert!(worst < near, "{method} {kicks:?}: {worst:e}");
            assert_eq!(jumps(&run), kicks, "{method}: rows before and after, at the moment exactly");
        }
    }
}

#[test]
fn presses_of_one_moment_act_one_after_the_other() {
    let model = model(KICKED);
    let speed = |list: &[(f64, usize)]| {
        let run = run(&model, pressed(&model, Method::RungeKutta4, 0.1, list), 10);
        let row = run.history().times().iter().rposition(|&time| time == 0.5).unwrap();
        run.history().column(1)[row]
    };
    assert_eq!(speed(&[(0.5, 0), (0.5, 1)]), 0.0);
    assert_eq!(speed(&[(0.5, 1), (0.5, 0)]), 1.0);
    assert_eq!(speed(&[(0.5, 1), (0.5, 0), (0.5, 0)]), 2.0);
}

#[test]
fn what_a_press_remembers_is_known() {
    let model = model(KICKED);
    let run = run(&model, pressed(&model, Method::RungeKutta4, 0.1, &[(0.25, 0), (0.7, 0)]), 10);
    let table = |name: &str| {
        let node = model.quantities.iter().find(|quantity| quantity.name == name).unwrap().value.node;
        engine::Readings::new(&model, &[node]).at_row(run.history(), run.history().len() - 1)[0]
    };
    assert_eq!(table("n"), 2.0);
    let row = run.history().times().iter().position(|&time| time == 0.7).unwrap();
    assert_eq!(table("before"), run.history().column(1)[row], "before the last press");
}

/// A press at the time of the run or before it gives the bits of a run that has the press in its setup.
#[test]
fn a_run_that_is_pressed_has_the_bits_of_one_that_knew() {
    let model = model(KICKED);
    for method in Method::ALL {
        let step = 0.05;
        let all = [(0.0, 0), (0.0, 0), (0.6, 0), (0.6, 1), (0.6123, 0), (0.63, 0), (1.0, 1)];
        let known = run(&model, pressed(&model, method, step, &all), 40);
        let mut live = run(&model, pressed(&model, method, step, &[]), 1);
        for (number, &(time, button)) in all.iter().enumerate() {
            while live.time() < time {
                live.advance().unwrap();
            }
            // Sometimes far beyond, sometimes in the middle of a step.
            for _ in 0..number % 3 {
                live.advance().unwrap();
            }
            if number == 4 {
                let _ = live.advance_within(1).unwrap();
            }
            live.press(time, Some(button));
        }
        while live.time() < 2.0 {
            live.advance().unwrap();
        }
        assert_eq!(live.history().fingerprint(), known.history().fingerprint(), "{method}");
        assert_eq!(live.setup().presses, known.setup().presses);
        // Back in time and on again, from points of the grid: the later presses are repeated.
        for back in [0.05, 0.55, 0.9] {
            let row = live.history().row_at(back + 1e-9);
            live.truncate(row);
            while live.time() < 2.0 {
                live.advance().unwrap();
            }
            assert_eq!(live.history().fingerprint(), known.history().fingerprint(), "{method} from {back}");
        }
        // Dropped rows and presses leave no trace.
        live.press(0.61, None);
        while live.time() < 2.0 {
            live.advance().unwrap();
        }
        let fewer = run(&model, pressed(&model, method, step, &all[..4]), 40);
        assert_eq!(live.history().fingerprint(), fewer.history().fingerprint(), "{method}");
    }
}

#[test]
fn a_button_may_end_the_run_and_let_events_follow() {
    let model = model(
        "y' = 1 [m/s]\ny(0) = 0 [m]\ndiscrete n = 0\nwhen y > 10 [m] { n = n + 1 }\n\
         button \"Lift\" { y = 11 [m] }\nbutton \"End\" { stop }",
    );
    let mut run = Run::start(&model, pressed(&model, Method::RungeKutta4, 0.1, &[(0.33, 0), (0.52, 1)])).unwrap();
    let error = loop {
        if let Err(error) = run.advance() {
            break error;
        }
    };
    assert_eq!((error.cause, error.time), (Cause::Ended(2), 0.52));
    assert_eq!(run.state()[1], 1.0, "the event that the press has made due");
    run.go_on();
    run.advance().unwrap();
    assert!((run.time() - 0.6).abs() < 1e-12 && (run.state()[0] - 11.27).abs() < 1e-12);
}

#[test]
fn a_press_between_two_counts_belongs_to_the_count_before() {
    let model = model("independent k by 1\nnext p = 2*p\np(0) = 1\nbutton \"One more\" as more { p = p + 1 }");
    let run = run(&model, pressed(&model, Method::Euler, 1.0, &[(2.7, 0)]), 4);
    assert_eq!(run.history().times(), [0.0, 1.0, 2.0, 2.0, 3.0, 4.0]);
    assert_eq!(run.history().column(0), [1.0, 2.0, 4.0, 5.0, 10.0, 20.0]);
}

#[test]
fn presses_that_mean_nothing_are_left_out() {
    let model = model(KICKED);
    let wrong = [(f64::NAN, 0), (-1.0, 0), (f64::INFINITY, 0), (0.5, 7)];
    let plain = run(&model, pressed(&model, Method::RungeKutta4, 0.1, &[]), 10);
    let run = run(&model, pressed(&model, Method::RungeKutta4, 0.1, &wrong), 10);
    assert_eq!(run.history().fingerprint(), plain.history().fingerprint());
}

/// A random draw at a press depends on the number of the press, not on the time at which the run reached it.
#[test]
fn draws_of_presses_are_repeated() {
    let model = model(
        "random seed = 3 in 1..99\ndiscrete n = 0\nbutton \"Throw\" { n = uniform(0, 1) }\n\
         x' = n*1 [1/s]\nx(0) = 0",
    );
    let both = run(&model, pressed(&model, Method::DormandPrince, 0.1, &[(0.2, 0), (0.47, 0)]), 10);
    let mut live = run(&model, pressed(&model, Method::DormandPrince, 0.1, &[]), 3);
    live.press(0.2, Some(0));
    while live.time() < 0.8 {
        live.advance().unwrap();
    }
    live.press(0.47, Some(0));
    while live.time() < 1.0 {
        live.advance().unwrap();
    }
    assert_eq!(live.history().fingerprint(), both.history().fingerprint());
    let values = both.history().column(0);
    assert!(values.first() == Some(&0.0) && values.last().is_some_and(|last| *last > 0.0));
}
