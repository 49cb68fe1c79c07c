//! Tables whose curve the reader draws.

use crate::support::{model, run, setup};
use engine::{Method, Readings, Run, Setup};
use program::{Drawn, Model};

const PUSHED: &str = "
table a(t) in [m/s^2] \"Push\" drawn in -5..5 until 10 [s]
x'' = a(t)
x(0) = 0 [m]
x'(0) = 0 [m/s]
";

fn drawn(model: &Model, method: Method, step: f64, values: impl Fn(f64) -> f64) -> Setup {
    let own = model.tables[0].drawn.as_ref().unwrap();
    let values = (0..Drawn::POINTS).map(|point| values(own.argument(point))).collect();
    Setup { drawings: vec![values], tolerance: 1e-10, ..setup(model, method, step) }
}

fn value(run: &Run, model: &Model, name: &str) -> f64 {
    let node = model.quantities.iter().find(|quantity| quantity.name == name).unwrap().value.node;
    Readings::new(model, &[node]).at_row(run.history(), run.history().len() - 1)[0]
}

#[test]
fn nothing_is_drawn_at_first() {
    let model = model(PUSHED);
    let own = model.tables[0].drawn.as_ref().unwrap();
    assert_eq!((own.low, own.high, own.from, own.until), (-5.0, 5.0, 0.0, 10.0));
    assert!(own.values.iter().all(|value| *value == 0.0));
    let run = run(&model, setup(&model, Method::RungeKutta4, 0.1), 50);
    assert_eq!(run.state(), [0.0, 0.0]);
}

#[test]
fn a_constant_push_gives_the_parabola() {
    let model = model(PUSHED);
    for method in [
        Method::EulerRichardson,
        Method::VelocityVerlet,
        Method::RungeKutta4,
        Method::DormandPrince,
        Method::Rosenbrock,
    ] {
        let run = run(&model, drawn(&model, method, 0.1, |_| 1.5), 100);
        let history = run.history();
        for row in 0..history.len() {
            let exact = 0.75 * history.time(row) * history.time(row);
            assert!((history.column(0)[row] - exact).abs() < 1e-9, "{method} at {}", history.time(row));
        }
    }
}

/// A push that grows linearly up to its last point and is then constant: x is the cubic a t^3/6 while it grows.
#[test]
fn a_push_that_rises_gives_the_cubic_and_then_the_parabola() {
    let model = model(PUSHED);
    let run = run(&model, drawn(&model, Method::RungeKutta4, 0.05, |t| 0.3 * t), 240);
    let history = run.history();
    for row in 0..history.len() {
        let t = history.time(row);
        let within = t.min(10.0);
        let later = (t - 10.0).max(0.0);
        let exact = 0.05 * within * within * within + 0.15 * within * within * later + 1.5 * later * later;
        assert!((history.column(0)[row] - exact).abs() < 1e-9, "{t}");
    }
    assert_eq!(run.notices().len(), 1, "outside of what is drawn");
}

#[test]
fn what_is_derived_from_it_follows() {
    let text = "
smooth table a(t) in [m] \"Way\" drawn in 0..9 from 0 [s] until 3 [s]
v = a(t)
w = v'
late = a(2 [s])
y' = w
y(0) = a(0 [s])
";
    let model = model(text);
    let setup = drawn(&model, Method::RungeKutta4, 0.01, |t| t * t);
    let run = run(&model, setup.clone(), 250);
    let model = model.with_drawings(&setup.drawings).unwrap();
    let t = run.time();
    assert!((value(&run, &model, "v") - t * t).abs() < 1e-3);
    assert!((value(&run, &model, "w") - 2.0 * t).abs() < 1e-2);
    assert!((value(&run, &model, "late") - 4.0).abs() < 1e-4, "no constant of the document");
    assert!((run.state()[0] - t * t).abs() < 1e-3);
}

#[test]
fn curves_that_are_alike_at_first_are_two() {
    let text = "
table a(t) in [m/s] drawn in -5..5 until 10 [s]
table b(t) in [m/s] drawn in -5..5 until 10 [s]
x' = a(t)
x(0) = 0 [m]
y' = b(t)
y(0) = 0 [m]
";
    let model = model(text);
    let drawings = vec![vec![1.0; Drawn::POINTS], vec![0.0; Drawn::POINTS]];
    let run = run(&model, Setup { drawings, ..setup(&model, Method::RungeKutta4, 0.1) }, 10);
    assert!((run.state()[0] - 1.0).abs() < 1e-12);
    assert_eq!(run.state()[1], 0.0);
}

#[test]
fn what_cannot_be_drawn_is_left_out() {
    let model = model(PUSHED);
    let plain = run(&model, setup(&model, Method::RungeKutta4, 0.1), 10);
    let short = vec![vec![1.0; 3]];
    let beyond = vec![vec![5.1; Drawn::POINTS]];
    let nan = vec![vec![f64::NAN; Drawn::POINTS]];
    for drawings in [Vec::new(), short, beyond, nan, vec![vec![1.0; Drawn::POINTS]; 2]] {
        let run = run(&model, Setup { drawings, ..setup(&model, Method::RungeKutta4, 0.1) }, 10);
        assert_eq!(run.history().fingerprint(), plain.history().fingerprint());
    }
}

#[test]
fn it_starts_with_the_points_that_are_given() {
    let model = model(
        "table a(t) in [cm/s^2] drawn in -500..500 from 1 [s] until 2 [s] { 0 [s] 0  2 200 }\n\
         x' = a(t)*(1 [s])\nx(0) = 0 [m]",
    );
    let own = model.tables[0].drawn.as_ref().unwrap();
    assert_eq!((own.low, own.high, own.from, own.until), (-5.0, 5.0, 1.0, 2.0));
    assert!(
        (own.values[0] - 1.0).abs() < 1e-12
            && (own.values[25] - 1.5).abs() < 1e-12
            && (own.values[50] - 2.0).abs() < 1e-12
    );
}
