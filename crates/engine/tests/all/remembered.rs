//! Values that events remember, names local to events, and events that end the run.

use crate::support::{model, run, setup, value};
use engine::{Method, Run, Subject};

const STONE: &str = "g = 9.8 [m/s^2]\nx' = 3 [m/s]\nx(0) = 0 [m]\ny'' = -g\ny(0) = 0 [m]\ny'(0) = 4.9 [m/s]\n\
                     when y < 0 [m] as landing { y' = -0.5*y' }\nR = landing.x \"Range\"\nT = landing.time\n\
                     n = landing.count\nD = landing.interval\nu = landing.y'\n";

/// Thrown up with 4.9 m/s a stone lands after 1 s, and each flight takes half as long as the one before.
#[test]
fn an_event_remembers_its_last_moment() {
    for method in [Method::RungeKutta4, Method::DormandPrince, Method::Rosenbrock] {
        let model = model(STONE);
        let before = run(&model, setup(&model, method, 0.125), 7);
        for name in ["R", "T", "D", "u"] {
            assert!(value(&model, &before, name).is_nan(), "{method}: {name} has no value yet");
        }
        assert_eq!(value(&model, &before, "n"), 0.0, "{method}");
        let once = run(&model, setup(&model, method, 0.125), 9);
        for (name, expected) in [("R", 3.0), ("T", 1.0), ("n", 1.0), ("u", -4.9)] {
            let found = value(&model, &once, name);
            assert!((found - expected).abs() < 1e-9, "{method}: {name} is {found}");
        }
        assert!(value(&model, &once, "D").is_nan(), "{method}");
        let twice = run(&model, setup(&model, method, 0.125), 13);
        for (name, expected) in [("R", 4.5), ("T", 1.5), ("n", 2.0), ("D", 0.5), ("u", -2.45)] {
            let found = value(&model, &twice, name);
            assert!((found - expected).abs() < 1e-9, "{method}: {name} is {found}");
        }
        // The motion is the same as without it, and nothing of it is a column of the table.
        assert!(engine::table::Table::new(&model).columns().iter().all(|column| !column.heading().contains('.')));
    }
}

#[test]
fn going_back_forgets_what_came_later() {
    let model = model(STONE);
    let mut again = run(&model, setup(&model, Method::RungeKutta4, 0.125), 13);
    again.truncate(4);
    assert!(value(&model, &again, "R").is_nan());
    while again.time() < 1.6 {
        again.advance().expect("it goes on");
    }
    assert_eq!(value(&model, &again, "n"), 2.0);
}

#[test]
fn an_event_ends_the_run() {
    for method in [Method::RungeKutta4, Method::DormandPrince, Method::Rosenbrock] {
        let model = model(
            "y'' = -9.8 [m/s^2]\ny(0) = 0 [m]\ny'(0) = 4.9 [m/s]\ndiscrete n = 0\nwhen y < 0 [m] as landing { stop, n = 1 }",
        );
        let mut run = Run::start(&model, setup(&model, method, 0.3)).expect("starts");
        let end = (0..10).find_map(|_| run.advance().err()).expect("an end");
        assert!(end.is_end() && (end.time - 1.0).abs() < 1e-9, "{method}: {end}");
        assert_eq!(end.subject(), Some(Subject::Event(0)));
        assert!(end.message(&model).english().ends_with(": landing"), "{:?}", end.message(&model));
        let rows = run.history().len();
        assert_eq!(run.history().time(rows - 1), end.time, "{method}");
        assert_eq!(run.state()[2], 1.0, "{method}: the actions beside it are carried out");
        assert!(run.advance().is_err() && run.history().len() == rows, "{method}: it stays there");
        run.go_on();
        run.advance().expect("it goes on");
        assert!(run.time() > end.time && run.state()[0] < 0.0, "{method}");
    }
}

/// `let` has the value of its expression, computed from the values before the event.
#[test]
fn names_inside_an_event() {
    let text = |actions: &str| {
        format!("y'' = -9.8 [m/s^2]\ny(0) = 1 [m]\ny'(0) = 0\ndiscrete n = 0\nwhen y < 0 [m] {{ {actions} }}")
    };
    let plain = model(&text("y' = -0.8*y', n = n + 1"));
    let named = model(&text("let u = 0.8*y', n = n + 1, let one = u/u, y' = -u*one"));
    let [plain_run, named_run] = [&plain, &named].map(|model| run(model, setup(model, Method::RungeKutta4, 0.05), 60));
    assert_eq!(plain_run.history().fingerprint(), named_run.history().fingerprint());
    for (actions, code) in [
        ("let u = y' + y, y' = -u", "dimension-mismatch"),
        ("let n = 2, y' = 0", "let-of-known-name"),
        ("y' = u", "unknown-name"),
        ("y' = landing.u", "unknown-name"),
    ] {
        let text = text(actions);
        let (_, diagnostics) = model::compile(&text, std::slice::from_ref(&(0..text.len())));
        assert!(diagnostics.iter().any(|found| found.code == code), "{actions}: {diagnostics:?}");
    }
    // The words are free as names.
    model("stop = 2\nlet = 3\nas = 4\ny' = stop*(1 [1/s])\ny(0) = 0\nwhen y > let { y = as }");
}
