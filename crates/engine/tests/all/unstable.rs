//! A step that is too long for a method is reported, and none that is not.

use crate::support::{U_TUBE, model, parameter, run, setup};
use engine::{Method, Notice, NoticeKind, Run};

fn notices(text: &str, method: Method, step: f64, rows: usize) -> Vec<Notice> {
    let model = model(text);
    run(&model, setup(&model, method, step), rows).notices()
}

fn too_long(time: f64) -> Vec<Notice> {
    vec![Notice { kind: NoticeKind::StepTooLong, time }]
}

/// Where each method becomes unstable along the negative real axis: Hairer & Wanner II, section IV.2.
#[test]
fn what_decays_faster_than_the_method_can_follow_is_reported() {
    let decay = "y' = -100 [1/s]*y\ny(0) = 1";
    for (method, limit) in [(Method::Euler, 2.0), (Method::EulerRichardson, 2.0), (Method::RungeKutta4, 2.785_29)] {
        assert_eq!(notices(decay, method, 0.999 * limit / 100.0, 20), [], "{method}");
        assert_eq!(notices(decay, method, 1.001 * limit / 100.0, 20), too_long(0.0), "{method}");
    }
    for method in [Method::DormandPrince, Method::Rosenbrock] {
        assert_eq!(notices(decay, method, 1.0, 3), [], "{method}");
    }
}

/// The notice is right: beyond the limit they grow, below they decay.
#[test]
fn the_limit_is_where_the_numbers_begin_to_grow() {
    let text = "y' = -100 [1/s]*y\ny(0) = 1";
    let model = model(text);
    for method in [Method::Euler, Method::EulerRichardson, Method::RungeKutta4] {
        for h in 1..60 {
            let run = run(&model, setup(&model, method, f64::from(h) * 1e-3), 60);
            assert_eq!(run.state()[0].abs() > 1.0, !run.notices().is_empty(), "{method}, {h} ms");
        }
    }
}

#[test]
fn an_oscillation_of_few_steps_is_reported_whatever_its_units() {
    for (unit, k) in [("m", 1.0), ("nm", 1.0), ("km", 1.0), ("m", 1e8), ("nm", 1e-8)] {
        let text = format!("x'' = -{k:e} [1/s^2]*x\nx(0) = 1 [{unit}]\nx'(0) = 0");
        let omega = f64::sqrt(k);
        for (method, limit) in [(Method::VelocityVerlet, 2.0), (Method::RungeKutta4, 2.785_29)] {
            assert_eq!(notices(&text, method, 0.9 * limit / omega, 30), [], "{method}, {text}");
            assert_eq!(notices(&text, method, 1.1 * limit / omega, 30), too_long(0.0), "{method}, {text}");
        }
    }
}

/// The fastest of the modes of a chain of 100 masses has omega = 2 sqrt(k/m) sin(100 pi/202).
#[test]
fn the_fastest_mode_of_a_chain_decides() {
    let text = "size N = 100\nx[0] = 0 [m]\nx[N+1] = 0 [m]\nx[i]'' = 100 [1/s^2]*(x[i-1] - 2*x[i] + x[i+1]) for i in 1..N\n\
                x[i](0) = 1 [cm]*sin(pi*i/(N + 1)) for i in 1..N\nx[i]'(0) = 0 for i in 1..N";
    assert_eq!(notices(text, Method::VelocityVerlet, 0.09, 300), []);
    assert!(!notices(text, Method::VelocityVerlet, 0.11, 300).is_empty());
}

#[test]
fn what_falls_freely_grows_or_rests_is_no_reason() {
    for text in [
        "y'' = -9.8 [m/s^2]\ny(0) = 0 [m]\ny'(0) = 1 [m/s]",
        "y' = 0.5 [1/s]*y\ny(0) = 1",
        "x'' = -4 [1/s^2]*x\nx(0) = 0 [m]\nx'(0) = 0",
        "y' = 1 [1/s]\ny(0) = 0",
    ] {
        for method in [Method::Euler, Method::RungeKutta4] {
            assert_eq!(notices(text, method, 0.1, 600), [], "{method}, {text}");
        }
    }
}

/// Damping is raised during the run and lowered again: the notice has the time of the change, and going back before it
/// removes the notice.
#[test]
fn a_parameter_that_is_changed_is_looked_at_at_once() {
    let model = model(U_TUBE);
    let b = parameter(&model, "b");
    let mut run = Run::start(&model, setup(&model, Method::RungeKutta4, 0.1)).expect("starts");
    for _ in 0..50 {
        run.advance().expect("goes on");
    }
    let mut parameters = run.parameters().to_vec();
    // m = 350 kg: b h/m = 5.7
    parameters[b] = 20_000.0;
    run.set_parameters(parameters.clone());
    for _ in 0..20 {
        run.advance().expect("goes on");
    }
    assert_eq!(run.notices(), too_long(run.history().time(51)));
    run.truncate(20);
    assert_eq!(run.notices(), []);
}
