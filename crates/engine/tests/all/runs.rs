//! Rows recorded by a run; changing parameters, going back and interpolating.

use crate::support::{U_TUBE, model, parameter, setup};
use engine::{Advance, CAPACITY, Method, Readings, Run, Setup, Subject};

#[test]
fn times_are_products_not_sums() {
    let model = model(U_TUBE);
    for method in Method::ALL {
        let run = crate::support::run(&model, setup(&model, method, 0.1), 1000);
        for (row, time) in run.history().times().iter().enumerate() {
            assert_eq!(*time, row as f64 * 0.1, "{method}");
        }
    }
}

#[test]
fn a_parameter_changes_from_the_next_step_on_and_the_state_does_not_jump() {
    let model = model(U_TUBE);
    let mut run = crate::support::run(&model, setup(&model, Method::RungeKutta4, 0.05), 10);
    let before = run.parameters().to_vec();
    let mut after = before.clone();
    after[parameter(&model, "b")] = 5000.0;
    run.set_parameters(vec![0.0; before.len()]);
    run.set_parameters(after.clone());
    for _ in 0..10 {
        run.advance().unwrap();
    }
    let history = run.history();
    assert_eq!(history.len(), 21);
    assert_eq!(history.parameters(10), before);
    assert_eq!(history.parameters(11), after);
    assert_eq!(history.parameters(20), after);
    assert_eq!(history.segment(20), 0);
    // A run that starts from row 10 with the new parameters goes the same way.
    let mut start = vec![0.0; 2];
    history.state(10, &mut start);
    let again = Setup { parameters: after, start: Some(start), ..run.setup().clone() };
    let again = crate::support::run(&model, again, 10);
    assert_eq!(again.history().column(0), &history.column(0)[10..]);
}

#[test]
fn going_back_restores_the_parameters_of_that_time() {
    let model = model(U_TUBE);
    let mut run = crate::support::run(&model, setup(&model, Method::RungeKutta4, 0.05), 10);
    let original = crate::support::run(&model, setup(&model, Method::RungeKutta4, 0.05), 20);
    let before = run.parameters().to_vec();
    let mut after = before.clone();
    after[parameter(&model, "g")] = 1.62;
    run.set_parameters(after.clone());
    for _ in 0..10 {
        run.advance().unwrap();
    }
    let mut later = run.clone();
    later.truncate(15);
    assert_eq!((later.time(), later.history().len()), (15.0 * 0.05, 16));
    assert_eq!(later.parameters(), after);
    for row in [5, 10] {
        let mut earlier = run.clone();
        earlier.truncate(row);
        assert_eq!(earlier.parameters(), before);
        while earlier.time() < original.time() {
            earlier.advance().unwrap();
        }
        assert_eq!(earlier.history().fingerprint(), original.history().fingerprint());
        assert_eq!(earlier.history().parameters(20), before);
    }
}

#[test]
fn adaptive_runs_take_changes_and_go_back() {
    let model = model(U_TUBE);
    for method in [Method::DormandPrince, Method::Rosenbrock] {
        let mut run = crate::support::run(&model, setup(&model, method, 0.05), 40);
        let mut parameters = run.parameters().to_vec();
        parameters[0] = 1.62;
        run.truncate(20);
        run.set_parameters(parameters);
        for _ in 0..20 {
            run.advance().unwrap();
        }
        let mut fine = crate::support::run(&model, setup(&model, Method::RungeKutta4, 0.05), 20);
        fine.set_parameters(run.parameters().to_vec());
        for _ in 0..20 {
            fine.advance().unwrap();
        }
        for row in 0..=40 {
            let (a, b) = (run.history().column(0)[row], fine.history().column(0)[row]);
            assert!((a - b).abs() < 1e-5, "{method}, row {row}: {a} {b}");
        }
    }
}

#[test]
fn between_rows_the_state_is_interpolated() {
    let model = model(U_TUBE);
    let mut run = crate::support::run(&model, setup(&model, Method::RungeKutta4, 0.05), 100);
    let fine = crate::support::run(&model, setup(&model, Method::RungeKutta4, 0.0125), 400);
    let mut state = [0.0; 2];
    for row in 0..=400 {
        run.interpolate(row as f64 * 0.0125, &mut state);
        for (k, value) in state.iter().enumerate() {
            assert!((value - fine.history().column(k)[row]).abs() < 5e-6, "row {row}");
        }
    }
    run.interpolate(-1.0, &mut state);
    assert_eq!(state, [0.5, 0.0]);
    run.interpolate(1000.0, &mut state);
    assert_eq!(state, run.state());
}

#[test]
fn nothing_is_interpolated_over_a_jump_or_where_rows_are_too_coarse() {
    let switch = model("y' = 0 [1/s]\ny(0) = 0\nwhen t > 0.25 [s] { y = 1 }\n");
    let mut run = crate::support::run(&switch, setup(&switch, Method::RungeKutta4, 0.1), 5);
    let mut state = [0.0];
    for (time, value) in [(0.24, 0.0), (0.25, 1.0), (0.26, 1.0)] {
        run.interpolate(time, &mut state);
        assert_eq!(state, [value], "{time}");
    }
    let stiff = model("y' = -1e6 [1/s]*(y - 1)\ny(0) = 0\n");
    let mut run = crate::support::run(&stiff, setup(&stiff, Method::Rosenbrock, 0.1), 5);
    for part in 0..100 {
        run.interpolate(0.005 * f64::from(part), &mut state);
        assert!((0.0..=1.000_001).contains(&state[0]), "{state:?}");
    }
}

#[test]
fn a_start_replaces_the_initial_values() {
    let model = model("y' = (y(0) - y)/(1 [s])\ny(0) = 1 [m]\n");
    let start = Setup { start: Some(vec![3.0]), ..Setup::defaults(&model) };
    let run = crate::support::run(&model, start, 10);
    assert_eq!(run.initial(), [3.0]);
    assert_eq!(run.state(), [3.0]);
}

#[test]
fn a_model_without_states_gives_rows_of_time() {
    let model = model("A = 2 [m]\nomega = 3 [1/s]\ny = A*cos(omega*t)\nv = y'\n");
    for method in Method::ALL {
        let run = crate::support::run(&model, setup(&model, method, 0.1), 10);
        assert_eq!((run.history().len(), run.history().states(), run.time()), (11, 0, 1.0), "{method}");
        let node = |name| model.quantities.iter().find(|quantity| quantity.name == name).unwrap().value.node;
        let mut readings = Readings::new(&model, &[node("y"), node("v")]);
        let [y, v] = readings.at_row(run.history(), 10) else { panic!("two values") };
        assert!((y - 2.0 * libm::cos(3.0)).abs() < 1e-15 && (v + 6.0 * libm::sin(3.0)).abs() < 1e-14, "{y} {v}");
    }
}

#[test]
fn a_state_that_is_not_finite_stops_the_run_with_place_and_time() {
    let text = "independent t\ny' = y^2\ny(0) = 1\n";
    let model = model(text);
    for (method, code) in [
        (Method::RungeKutta4, "not-finite"),
        (Method::DormandPrince, "step-too-small"),
        (Method::Rosenbrock, "not-finite"),
    ] {
        let mut run = Run::start(&model, setup(&model, method, 0.01)).unwrap();
        let error = (0..200).find_map(|_| run.advance().err()).expect("stops");
        assert_eq!(error.code(), code, "{method}: {error}");
        assert!(error.time > 0.98 && error.time < 1.06, "{method}: {error}");
        assert_eq!(error.subject(), Some(Subject::State(0)), "{method}");
        assert!(run.history().column(0).iter().all(|value| value.is_finite()));
        // The next call returns the same error.
        assert_eq!(run.advance().unwrap_err().code(), code, "{method}");
    }
}

#[test]
fn messages_name_the_state_and_the_time() {
    for (text, method, message) in [
        (
            "y'' = 1e200 [1/(m^3*s^2)]*y^4\ny(0) = 1 [m]\ny'(0) = 0 [m/s]\n",
            Method::Euler,
            "y' exceeds the largest number after t = 0.2 s",
        ),
        ("y' = sqrt(1 - t/(1 [s]))/(1 [s])\ny(0) = 0\n", Method::RungeKutta4, "y has no defined value after t = 1 s"),
        (
            "independent x in [mm]\ny' = 1/(y - y)/(1 [m])\ny(0) = 0\n",
            Method::RungeKutta4,
            "y has no defined value after x = 0 mm",
        ),
        (
            "independent t\nc = 1 - t\nx'' + y'' = 1\nx'' + (1 - c)*y'' = x\nx(0) = 0\nx'(0) = 0\ny(0) = 0\ny'(0) = 0\n",
            Method::Euler,
            "the equations have no unique solution for the highest derivatives after t = 1",
        ),
    ] {
        let model = model(text);
        let mut run = Run::start(&model, setup(&model, method, 0.1)).unwrap();
        let error = (0..100).find_map(|_| run.advance().err()).unwrap_or_else(|| panic!("{text}"));
        assert_eq!(error.message(&model).english(), message);
    }
}

#[test]
fn a_setup_that_makes_no_sense_is_refused() {
    let model = model(U_TUBE);
    let good = Setup::defaults(&model);
    let adaptive = Setup { method: Method::DormandPrince, ..good.clone() };
    for (setup, code) in [
        (Setup { step: 0.0, ..good.clone() }, "step-not-positive"),
        (Setup { step: -0.1, ..good.clone() }, "step-not-positive"),
        (Setup { step: f64::NAN, ..good.clone() }, "step-not-positive"),
        (Setup { tolerance: 0.0, ..adaptive.clone() }, "bad-tolerance"),
        (Setup { tolerance: 1e-20, ..adaptive.clone() }, "bad-tolerance"),
        (Setup { tolerance: f64::NAN, ..adaptive }, "bad-tolerance"),
        (Setup { parameters: vec![1.0], ..good.clone() }, "wrong-parameters"),
        (Setup { parameters: vec![f64::NAN; good.parameters.len()], ..good.clone() }, "parameter-not-finite"),
        (Setup { start: Some(vec![1.0]), ..good.clone() }, "wrong-start"),
        (Setup { start: Some(vec![1.0, f64::INFINITY]), ..good }, "initial-not-finite"),
    ] {
        let error = Run::start(&model, setup.clone()).expect_err(code);
        assert_eq!(error.code(), code, "{setup:?}");
        assert!(
            !error.message(&model).text(catalogues::with(units::Language::Spanish)).is_empty()
                && !error.hint().text(catalogues::with(units::Language::Spanish)).is_empty(),
            "{setup:?}"
        );
    }
}

#[test]
fn too_much_work_for_one_row_is_given_up() {
    let model = model("independent t\ny' = -1e9*(y - cos(t))\ny(0) = 1\n");
    let mut run = Run::start(&model, setup(&model, Method::DormandPrince, 1.0)).unwrap();
    let error = run.advance().unwrap_err();
    assert_eq!(error.code(), "too-many-steps");
    assert_eq!(error.hint().english(), "if the equations are stiff, use the method Rosenbrock");
}

#[test]
fn the_history_is_bounded() {
    let model = model("y' = 1 [m/s]\ny(0) = 0 [m]\n");
    let mut run = Run::start(&model, Setup::defaults(&model)).unwrap();
    let mut rows = 1;
    while run.advance().unwrap() != Advance::Full {
        rows += 1;
    }
    assert!(run.history().bytes() >= CAPACITY && run.history().bytes() < CAPACITY + 100);
    assert_eq!(run.history().len(), rows);
    run.truncate(10);
    assert_eq!(run.advance().unwrap(), Advance::Step);
}

#[test]
fn forgetting_rows_changes_nothing_that_follows() {
    let model = model(U_TUBE);
    let whole = crate::support::run(&model, setup(&model, Method::RungeKutta4, 0.05), 20);
    let mut run = crate::support::run(&model, setup(&model, Method::RungeKutta4, 0.05), 10);
    run.forget();
    assert_eq!(run.history().len(), 1);
    for _ in 0..10 {
        run.advance().unwrap();
    }
    assert_eq!(run.history().times(), &whole.history().times()[10..]);
    assert_eq!(run.history().column(1), &whole.history().column(1)[10..]);
}
