//! Sudden changes of the state.

use crate::support::{jumps, model, setup};
use engine::{Advance, Method, Run, Setup, Subject};

const BALL: &str = "
parameter g = 9.8 [m/s^2]
parameter e = 1
parameter h = 1 [m]
y'' = -g
y(0) = h
y'(0) = 0 [m/s]
when y < 0 [m] { y' = -e*y' }
";

fn ball(e: f64, method: Method, step: f64) -> (program::Model, Setup) {
    let model = model(BALL);
    let mut setup = setup(&model, method, step);
    setup.parameters[1] = e;
    (model, setup)
}

/// The methods that are exact for a parabola.
const EXACT: [Method; 5] =
    [Method::EulerRichardson, Method::VelocityVerlet, Method::RungeKutta4, Method::DormandPrince, Method::Rosenbrock];

#[test]
fn a_ball_bounces_at_the_right_times_and_to_the_right_heights() {
    for method in EXACT {
        let e: f64 = 0.9;
        let (model, setup) = ball(e, method, 0.05);
        let run = crate::support::run(&model, setup, 80);
        let first = (2.0 / 9.8_f64).sqrt();
        let (mut time, mut power) = (first, 1.0);
        let jumps = jumps(&run);
        assert_eq!(jumps.len(), 6, "{method}");
        for (n, jump) in jumps.iter().enumerate() {
            assert!((jump - time).abs() < 1e-12, "{method}, bounce {n}: {jump} {time}");
            power *= e;
            // The height of the flight after bounce n is e^(2 (n + 1)): from the speed with which it leaves.
            let history = run.history();
            let row =
                (1..history.len()).find(|&row| history.time(row) == *jump && history.column(1)[row] > 0.0).unwrap();
            let speed = history.column(1)[row];
            assert!((speed * speed / (2.0 * 9.8) - power * power).abs() < 1e-12, "{method}, bounce {n}");
            time += 2.0 * first * power;
        }
    }
}

#[test]
fn an_elastic_ball_keeps_its_energy_for_a_thousand_bounces() {
    let (model, setup) = ball(1.0, Method::RungeKutta4, 0.05);
    let run = crate::support::run(&model, setup, 18_200);
    assert!(jumps(&run).len() > 1000);
    let history = run.history();
    for row in 0..history.len() {
        let (y, v) = (history.column(0)[row], history.column(1)[row]);
        assert!((9.8 * y + v * v / 2.0 - 9.8).abs() < 1e-9, "row {row}");
    }
}

#[test]
fn nothing_falls_through_the_floor_and_infinitely_many_bounces_stop_the_run() {
    for method in EXACT {
        for e in [0.0, 1e-9, 0.5, 0.9] {
            let (model, setup) = ball(e, method, 0.05);
            let mut run = Run::start(&model, setup).unwrap();
            let error = (0..2000).find_map(|_| run.advance().err());
            let lowest = run.history().column(0).iter().copied().fold(f64::INFINITY, f64::min);
            assert!(lowest >= 0.0, "{method}, e = {e}: {lowest:e}");
            let error = error.unwrap_or_else(|| panic!("{method}, e = {e}: no end"));
            assert_eq!(error.code(), "too-many-events", "{method}, e = {e}: {error}");
            let message = error.message(&model).english();
            assert!(message.starts_with("more than 1000 events in a hundredth of a step, at t = "), "{message}");
            assert_eq!(error.subject(), Some(Subject::Event(0)));
            let end = (2.0 / 9.8_f64).sqrt() * (1.0 + 2.0 * e / (1.0 - e));
            assert!((error.time - end).abs() < 1e-6 * end, "{method}, e = {e}: {} {end}", error.time);
        }
    }
}

#[test]
fn a_floor_that_is_not_at_zero_holds_too() {
    let text = BALL.replace("y < 0 [m]", "y < 123.4 [m]").replace("y(0) = h", "y(0) = 123.4 [m] + h");
    let model = model(&text);
    for method in EXACT {
        for e in [0.3, 0.8] {
            let mut setup = setup(&model, method, 0.05);
            setup.parameters[1] = e;
            let mut run = Run::start(&model, setup).unwrap();
            while run.time() < 20.0 && run.advance().is_ok() {}
            let lowest = run.history().column(0).iter().copied().fold(f64::INFINITY, f64::min);
            assert!(lowest >= 123.4, "{method}, e = {e}: {lowest}");
        }
    }
}

#[test]
fn rows_before_and_after_an_event_have_the_same_time_and_the_grid_is_kept() {
    let (model, setup) = ball(1.0, Method::RungeKutta4, 0.1);
    let mut run = Run::start(&model, setup).unwrap();
    let advances: Vec<Advance> = (0..6).map(|_| run.advance().unwrap()).collect();
    assert_eq!(advances, [Advance::Step, Advance::Step, Advance::Step, Advance::Step, Advance::Event, Advance::Step]);
    let history = run.history();
    assert_eq!(history.len(), 9);
    assert_eq!(history.time(5), history.time(6));
    assert_eq!(history.column(1)[5], -history.column(1)[6]);
    assert_eq!(history.segments(), [0, 0, 0, 0, 0, 0, 1, 1, 1]);
    assert_eq!((history.time(4), history.time(7), history.time(8)), (0.4, 0.5, 6.0 * 0.1));
}

#[test]
fn an_event_that_stays_true_fires_once() {
    for method in Method::ALL {
        let model = model(
            "y'' = 0 [m/s^2]\ny(0) = 0 [m]\ny'(0) = 1 [m/s]\nn' = 0 [1/s]\nn(0) = 0\nwhen t > 1 [s] { n = n + 1 }\nwhen y > 2.05 [m] { n = n + 10 }\n",
        );
        if method == Method::VelocityVerlet {
            continue;
        }
        for step in [0.1, 0.25, 0.3] {
            let run = crate::support::run(&model, setup(&model, method, step), 30);
            assert_eq!(run.state()[2], 11.0, "{method}, step {step}");
            let jumps = jumps(&run);
            assert!((jumps[0] - 1.0).abs() < 1e-15 && (jumps[1] - 2.05).abs() < 1e-12, "{method} {jumps:?}");
        }
    }
}

#[test]
fn a_condition_that_is_true_at_the_start_does_not_fire_there() {
    let model = model(
        "y' = 1 [m/s]\ny(0) = 0 [m]\nn' = 0 [1/s]\nn(0) = 0\nwhen y < 1 [m] { n = n + 1 }\nwhen y >= 0 [m] { n = n + 1 }\n",
    );
    assert_eq!(crate::support::run(&model, setup(&model, Method::RungeKutta4, 0.1), 30).state()[1], 0.0);
}

#[test]
fn events_of_one_moment_act_in_their_order_each_on_what_those_before_have_left() {
    let model = model(
        "x' = 1 [m/s]\nx(0) = 0 [m]\na' = 0 [1/s]\na(0) = 1\nb' = 0 [1/s]\nb(0) = 2\nwhen x > 0.5 [m] { a = b\n b = a }\nwhen x > 0.5 [m] { b = a + 10 }\n",
    );
    let run = crate::support::run(&model, setup(&model, Method::RungeKutta4, 0.1), 10);
    // The first exchanges a and b; the second sees that.
    assert_eq!(run.state()[1..], [2.0, 12.0]);
    assert_eq!(run.history().len(), 11 + 2);
}

#[test]
fn a_jump_can_cause_another() {
    let model = model(
        "x' = 1 [m/s]\nx(0) = 0 [m]\na' = 0 [1/s]\na(0) = 0\nb' = 0 [1/s]\nb(0) = 0\nwhen x > 0.5 [m] { a = 1 }\nwhen a > 0.5 { b = 1 }\n",
    );
    let run = crate::support::run(&model, setup(&model, Method::RungeKutta4, 0.2), 5);
    assert_eq!(run.state()[1..], [1.0, 1.0]);
    assert_eq!(jumps(&run).len(), 2);
}

#[test]
fn jumps_that_cause_each_other_stop_the_run() {
    let model = model(
        "x' = 1 [m/s]
x(0) = 0 [m]
a' = 0 [1/s]
a(0) = 0
b' = 0 [1/s]
b(0) = 0
when x > 0.5 [m] { a = 1 }
when a > 0.5 { a = 0
 b = 1 }
when b > 0.5 { b = 0
 a = 1 }
",
    );
    let mut run = Run::start(&model, setup(&model, Method::RungeKutta4, 0.2)).unwrap();
    let error = (0..10).find_map(|_| run.advance().err()).expect("stops");
    assert_eq!(error.code(), "too-many-events");
}

#[test]
fn going_on_from_any_row_around_a_jump_gives_the_same_run() {
    for method in [Method::EulerRichardson, Method::VelocityVerlet, Method::RungeKutta4] {
        let (model, setup) = ball(0.8, method, 0.05);
        let run = crate::support::run(&model, setup, 60);
        for row in 1..run.history().len() {
            let mut again = run.clone();
            again.truncate(row);
            while again.time() < run.time() {
                again.advance().unwrap();
            }
            assert_eq!(again.history().fingerprint(), run.history().fingerprint(), "{method}, row {row}");
        }
    }
}

#[test]
fn a_time_event_does_not_fire_again_after_going_back_to_it() {
    let model = model("y' = 0 [1/s]\ny(0) = 0\nwhen t > 1 [s] { y = y + 1 }\n");
    for method in [Method::RungeKutta4, Method::DormandPrince, Method::Rosenbrock] {
        let mut run = crate::support::run(&model, setup(&model, method, 0.25), 8);
        let row = run.history().row_at(1.0);
        run.truncate(row);
        for _ in 0..8 {
            run.advance().unwrap();
        }
        assert_eq!(run.state(), [1.0], "{method}");
    }
}

/// `when a == b` fires where they cross, each way, but not where the run begins at equality.
#[test]
fn a_crossing_fires_either_way() {
    let model = model(
        "x'' = -x/(1 [s^2])\nx(0) = 0 [m]\nx'(0) = 1 [m/s]\nn' = 0\nn(0) = 0\nm' = 0\nm(0) = 0\nwhen x == 0 { n = n + 1 }\n\
         when x == 0.5 [m] { m = m + 1 }\n",
    );
    for method in [Method::RungeKutta4, Method::DormandPrince, Method::Rosenbrock] {
        let run = crate::support::run(&model, setup(&model, method, 0.05), 200);
        // 10 s: x passes through 0 at pi, 2 pi and 3 pi, and through 1/2 twice in each period.
        assert_eq!(run.state()[2..], [3.0, 4.0], "{method}");
        let first = jumps(&run);
        assert!((first[0] - std::f64::consts::PI / 6.0).abs() < 1e-5, "{method}: {first:?}");
        assert!((first[2] - std::f64::consts::PI).abs() < 1e-5, "{method}: {first:?}");
    }
    // A bounce at a crossing does not fire again by itself.
    let model = model_of_a_bounce();
    let run = crate::support::run(&model, setup(&model, Method::DormandPrince, 0.05), 60);
    assert!(run.history().column(0).iter().all(|&y| y >= 0.0));
    assert_eq!(jumps(&run).len(), 3);
}

fn model_of_a_bounce() -> program::Model {
    model("y'' = -9.8 [m/s^2]\ny(0) = 1 [m]\ny'(0) = 0 [m/s]\nwhen y == 0 { y' = -y' }\n")
}

/// A `discrete` variable has the bits of an unknown with the derivative 0; the word remains free as a name.
#[test]
fn discrete_quantities_change_at_events_only() {
    let text = |counter: &str| {
        format!(
            "y'' = -9.8 [m/s^2]\ny(0) = 1 [m]\ny'(0) = 0 [m/s]\n{counter}\nwhen y < 0 [m] {{ y' = -0.9*y', n = n + 1 }}\n"
        )
    };
    let (long, short) = (model(&text("n' = 0\nn(0) = 0")), model(&text("discrete n = 0 \"Bounces\"")));
    assert_eq!(short.states[2].label.as_deref(), Some("Bounces"));
    for method in EXACT {
        let [long, short] = [&long, &short].map(|model| crate::support::run(model, setup(model, method, 0.05), 60));
        assert_eq!(short.state()[2], 4.0, "{method}");
        assert_eq!(long.history().fingerprint(), short.history().fingerprint(), "{method}");
    }
    assert_eq!(model("discrete = 2\ny' = discrete*(1 [1/s])\ny(0) = 0\n").states.len(), 1);
}

/// Texts and truth values that events set: a ball rises and falls, and is thrown up once.
#[test]
fn texts_and_truth_values_are_set_by_events() {
    let model = model(
        "discrete phase = \"rises\"\ndiscrete thrown = false\ny'' = -10 [m/s^2]\ny(0) = 0 [m]\ny'(0) = 5 [m/s]\n\
         when y' < 0 [m/s] { phase = \"falls\" }\n\
         when y < 0 [m] { phase = if thrown then \"lies\" else \"rises\", y' = if thrown then 0 [m/s] else 5 [m/s], y = 0 [m], thrown = not thrown }\n",
    );
    let text = |rows: usize| {
        let run = crate::support::run(&model, setup(&model, Method::RungeKutta4, 0.1), rows);
        let phase = model.texts[crate::support::value(&model, &run, "phase") as usize].clone();
        (phase, crate::support::value(&model, &run, "thrown"))
    };
    let expected = [(4, "rises", 0.0), (6, "falls", 0.0), (13, "rises", 1.0), (17, "falls", 1.0)];
    for (rows, phase, thrown) in expected {
        assert_eq!(text(rows), (phase.to_owned(), thrown), "after {rows} steps");
    }
}
