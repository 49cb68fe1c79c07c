//! Equations that jump or bend: the moments are found, and between them every method keeps its order.

use crate::support::{jumps, model, parameter, run, setup};
use engine::{Method, Run, Setup};
use std::f64::consts::PI;

/// The states at the end.
fn last(run: &Run) -> Vec<f64> {
    run.state().to_vec()
}

/// A run of `until` seconds in steps of `step`.
fn run_until(text: &str, method: Method, step: f64, until: f64) -> Run {
    let model = model(text);
    let setup = Setup { tolerance: 1e-9, ..setup(&model, method, step) };
    run(&model, setup, (until / step).round() as usize)
}

/// For every method, and velocity Verlet where the equation is of second order.
fn methods(second_order: bool) -> impl Iterator<Item = Method> {
    Method::ALL.into_iter().filter(move |method| second_order || *method != Method::VelocityVerlet)
}

#[test]
fn a_step_in_time_is_met_exactly() {
    for method in methods(false) {
        for step in [0.05, 0.07, 1.0] {
            let run = run_until("x' = if t < 1 [s] then 0 else 1 [1/s]\nx(0) = 0", method, step, 350.0 * step);
            let (row, history) = (run.history().row_at(5.0), run.history());
            let expected = (history.time(row) - 1.0).max(0.0);
            let found = history.column(0)[row];
            assert!((found - expected).abs() < 1e-13, "{method}, {step}: {found} at {}", history.time(row));
        }
        let run = run_until("x' = if t < 1 [s] then 0 else 1 [1/s]\nx(0) = 0", method, 0.05, 5.0);
        assert!((last(&run)[0] - 4.0).abs() < 1e-13, "{method}: {}", last(&run)[0]);
        assert_eq!(jumps(&run), [1.0], "{method}");
    }
}

/// A pulse that is over long before the next row is neither skipped nor smeared.
#[test]
fn a_short_pulse_is_not_skipped() {
    let text = "w = 1e-6 [s]\nx' = if t >= 0.33 [s] and t < 0.33 [s] + w then 1/w else 0 [1/s]\nx(0) = 0";
    for method in methods(false) {
        let run = run_until(text, method, 0.05, 1.0);
        assert!((last(&run)[0] - 1.0).abs() < 1e-9, "{method}: {}", last(&run)[0]);
        assert_eq!(jumps(&run).len(), 2, "{method}");
    }
}

/// An oscillator that is pushed to and fro by a square wave: x'' = -x + s with s = 1 or -1 has the solution
/// s + (x_0 - s) cos t + v_0 sin t in each half of the period.
fn pushed(until: f64) -> f64 {
    let (mut x, mut v, mut time, mut push) = (0.5, 0.0, 0.0, 1.0);
    while time < until {
        let span = 1.5_f64.min(until - time);
        let (sine, cosine) = (libm::sin(span), libm::cos(span));
        (x, v) = (push + (x - push) * cosine + v * sine, v * cosine - (x - push) * sine);
        time += span;
        push = -push;
    }
    x
}

const PUSHED: &str =
    "x'' = -x/(1 [s^2]) + (if mod(t, 3 [s]) < 1.5 [s] then 1 [1/s^2] else -1 [1/s^2])\nx(0) = 0.5\nx'(0) = 0";

#[test]
fn a_square_wave_does_not_spoil_the_order() {
    for (method, order) in
        [(Method::Euler, 1), (Method::EulerRichardson, 2), (Method::VelocityVerlet, 2), (Method::RungeKutta4, 4)]
    {
        // 1.5 s are no multiple of the steps.
        let error = |step: f64| (last(&run_until(PUSHED, method, step, 10.5))[0] - pushed(10.5)).abs();
        let ratio = error(0.07) / error(0.035);
        let expected = f64::from(1 << order);
        assert!((ratio / expected - 1.0).abs() < 0.35, "{method}: {ratio}");
    }
    for method in [Method::DormandPrince, Method::Rosenbrock] {
        let error = (last(&run_until(PUSHED, method, 0.07, 10.5))[0] - pushed(10.5)).abs();
        assert!(error < 3e-8, "{method}: {error}");
    }
}

/// A current behind a diode: L i' + R i = u while u = sin(omega t) > 0, and R i alone afterwards.
#[test]
fn a_rectifier() {
    let text =
        "omega = 3 [rad/s]\nR = 2 [1/s]\nu = sin(omega*t)\ni' = (if u > 0 then u else 0)*(1 [1/s]) - R*i\ni(0) = 0";
    let driven = |i: f64, span: f64| {
        // The particular solution (R sin wt - w cos wt)/(R^2 + w^2), and the decaying part of the start.
        let part = |t: f64| (2.0 * libm::sin(3.0 * t) - 3.0 * libm::cos(3.0 * t)) / 13.0;
        part(span) + (i - part(0.0)) * libm::exp(-2.0 * span)
    };
    let half = PI / 3.0;
    let after_one = driven(0.0, half) * libm::exp(-2.0 * half);
    let rest = 2.5 - 2.0 * half;
    let expected = driven(after_one, rest);
    for (method, allowed) in [(Method::RungeKutta4, 2e-7), (Method::DormandPrince, 1e-8), (Method::Rosenbrock, 1e-8)] {
        let found = last(&run_until(text, method, 0.05, 2.5))[0];
        assert!((found - expected).abs() < allowed, "{method}: {found} for {expected}");
    }
}

/// Two springs of different stiffness, one on each side: a period is half a swing of each, whether the force is written
/// with `if`, with `max` and `min`, or with `abs`.
#[test]
fn a_spring_that_is_stiffer_on_one_side() {
    let forces = [
        "if x > 0 [m] then -9 [1/s^2]*x else -4 [1/s^2]*x",
        "-9 [1/s^2]*max(x, 0 [m]) - 4 [1/s^2]*min(x, 0 [m])",
        "-6.5 [1/s^2]*x - 2.5 [1/s^2]*abs(x)",
    ];
    let period = PI / 3.0 + PI / 2.0;
    let exact = |t: f64| {
        let t = t % period;
        if t < PI / 6.0 {
            libm::cos(3.0 * t)
        } else if t < PI / 6.0 + PI / 2.0 {
            -1.5 * libm::sin(2.0 * (t - PI / 6.0))
        } else {
            libm::sin(3.0 * (t - PI / 6.0 - PI / 2.0))
        }
    };
    for force in forces {
        let text = format!("x'' = {force}\nx(0) = 1 [m]\nx'(0) = 0");
        for (method, order) in [(Method::EulerRichardson, 2), (Method::VelocityVerlet, 2), (Method::RungeKutta4, 4)] {
            let error = |step: f64| (last(&run_until(&text, method, step, 10.4))[0] - exact(10.4)).abs();
            let ratio = error(0.04) / error(0.02);
            let expected = f64::from(1 << order);
            assert!((ratio / expected - 1.0).abs() < 0.35, "{force} with {method}: {ratio}");
        }
        for method in [Method::DormandPrince, Method::Rosenbrock] {
            let error = (last(&run_until(&text, method, 0.04, 10.4))[0] - exact(10.4)).abs();
            assert!(error < 1e-6, "{force} with {method}: {error}");
        }
    }
}

#[test]
fn a_corner_of_continuous_slope_is_none() {
    for term in ["v*abs(v)", "abs(v)*v*v/(1 [m/s])", "sign(v)*v^2", "3*v*(x*abs(-v))/(1 [m])"] {
        let model = model(&format!("v = x'\nx'' = -x/(1 [s^2]) - {term}/(1 [m])\nx(0) = 1 [m]\nx'(0) = 0"));
        assert!(model.held(true).is_none(), "{term}");
    }
    // A quantity that only events change is no switch.
    let text =
        "d' = 0\nd(0) = 1\nx' = abs(d)*(if d > 0 then 1 else 2)*(1 [m/s])\nx(0) = 0 [m]\nwhen x > 1 [m] { d = -d }";
    assert!(model(text).held(true).is_none());
    for term in ["abs(v)", "sign(v)*v", "x*abs(v)/(1 [m])"] {
        let text = format!("v = x'\nx'' = -x/(1 [s^2]) - {term}/(1 [s])\nx(0) = 1 [m]\nx'(0) = 0");
        let held = model(&text).held(true).expect(term);
        assert!(held.switches.iter().all(|switch| !switch.jumps), "{term}");
        assert!(model(&text).held(false).is_none(), "{term}: adaptive methods meet bends by their error control");
    }
}

/// Rates that are continuous have no jump that could be skipped, however they are written.
#[test]
fn jumps_are_told_from_continuous_branches() {
    let cases = [
        ("if x > 0 then -9*x else -4*x", false),
        ("if x > 0 then sqrt(x) else 0", false),
        ("if x > c then sqrt(x - c) else if x < c then -sqrt(c - x) else 0", false),
        ("if 0 <= -x then 0 else x^1.5", false),
        ("sign(x - y)*abs(x - y)^0.3", false),
        ("-c*sign(x)*sqrt(abs(x))*(2 + sin(y))", false),
        ("if x > 0 and y < 2 then x else 0", true),
        ("if x > 0 then -9*x else 1", true),
        ("if x > 0 then -9*x - c*y else 0", true),
        ("-sign(y)", true),
        ("y*sign(x)", true),
        ("if x > c then sqrt(x) else 0", true),
        ("if x > 0 then 1/sqrt(x) else 0", true),
        ("floor(x)*x", true),
    ];
    for (rate, expected) in cases {
        let text = format!("independent t\nparameter c = 0.5\nx' = {rate}\ny' = -x\nx(0) = 1\ny(0) = 0");
        let switches = model(&text).held(true).expect(rate).switches;
        assert_eq!(switches.iter().any(|switch| switch.jumps), expected, "{rate}");
    }
}

#[test]
fn a_run_goes_on_with_its_bits_after_a_switch() {
    let text = "parameter k = 4 [1/s^2]\nx'' = (if x > 0.1 [m] then -k*x else -9 [1/s^2]*x) + (if mod(t, 0.7 [s]) < 0.3 [s] \
                then 1 [m/s^2] else 0)\nx(0) = 1 [m]\nx'(0) = 0";
    for method in Method::ALL {
        let whole = run_until(text, method, 0.05, 10.0);
        assert!(jumps(&whole).len() > 20, "{method}");
        for back in [0.5, 1.2, 3.0, 7.95] {
            let mut again = whole.clone();
            again.truncate(again.history().row_at(back));
            while again.time() < whole.time() {
                again.advance().expect("it goes on");
            }
            assert_eq!(again.history().fingerprint(), whole.history().fingerprint(), "{method} from {back}");
        }
    }
}

/// A parameter that moves the surface over the state takes effect at the next step, as parameters do.
#[test]
fn a_parameter_moves_the_surface() {
    let model = model("parameter c = 10 [m]\nx' = if x < c then 1 [m/s] else -1 [m/s]\nx(0) = 0 [m]");
    let mut run = run(&model, setup(&model, Method::RungeKutta4, 0.25), 8);
    let mut parameters = run.parameters().to_vec();
    parameters[parameter(&model, "c")] = 1.0;
    run.set_parameters(parameters);
    run.advance().expect("it goes on");
    assert_eq!(last(&run), [1.75]);
}

#[test]
fn to_and_fro_without_end_is_said() {
    for method in methods(false) {
        let model = model("x' = if x > 0.5 [m] then -1 [m/s] else 1 [m/s]\nx(0) = 0 [m]");
        let mut run = Run::start(&model, setup(&model, method, 0.05)).expect("starts");
        let error = loop {
            if let Err(error) = run.advance() {
                break error;
            }
            assert!(run.time() < 1.0, "{method}");
        };
        assert_eq!(error.code(), "too-many-switches", "{method}");
        assert!((error.time - 0.5).abs() < 1e-9, "{method}: {}", error.time);
    }
}

/// A relay that acts on a second derivative switches ever more often: its swings about the wanted value become shorter without end.
#[test]
fn a_relay_that_switches_ever_faster_is_said() {
    for relay in ["sign(3 - w)", "(if w < 3 then 1 else -1)"] {
        for method in [Method::RungeKutta4, Method::DormandPrince] {
            let model = model(&format!(
                "i' = 20 [1/s]*{relay} - 10 [1/s]*i - 1 [1/s]*w\nw' = 10 [1/s]*i - 2 [1/s]*w\ni(0) = 0\nw(0) = 0"
            ));
            let mut run = Run::start(&model, setup(&model, method, 0.05)).expect("starts");
            let error = loop {
                if let Err(error) = run.advance() {
                    break error;
                }
                assert!(run.time() < 4.0, "{method} {relay}");
            };
            assert_eq!(error.code(), "too-many-switches", "{method} {relay}");
            let w = run.history().column(1).last().copied().unwrap_or(f64::NAN);
            assert!((w - 3.0).abs() < 1e-3, "{method} {relay}: {w}");
        }
    }
}

/// Crossings that depend on time alone are all seen, also when they follow one another faster than rows.
#[test]
fn no_event_in_time_is_skipped() {
    let text = "n' = 0\nn(0) = 0\nm' = 0\nm(0) = 0\nk' = 0\nk(0) = 0\nwhen sin(2*pi*238 [1/s]*t) > 0 { n = n + 1 }\n\
                when mod(t, 0.001 [s]) < 1e-7 [s] { m = m + 1 }\nwhen t > 0.5 [s] and t < 0.5000001 [s] { k = k + 1 }";
    for method in methods(false) {
        let model = model(text);
        let run = run(&model, setup(&model, method, 0.05), 20);
        // The remainder is small at the start already, and again at each millisecond up to the last moment.
        assert_eq!(last(&run), [238.0, 1000.0, 1.0], "{method}");
    }
}

/// Thousands of events in one long step are no reason to stop.
#[test]
fn many_events_in_a_step() {
    let text = "n' = 0\nn(0) = 0\nwhen mod(t, 1 [s]) < 0.5 [s] { n = n + 1 }";
    let model = model(text);
    let run = run(&model, setup(&model, Method::RungeKutta4, 86400.0), 1);
    assert_eq!(last(&run), [86400.0]);
}

/// Each of two choices decides the motion, whichever stands first.
#[test]
fn equations_follow_every_choice() {
    let text = "
choice gas { \"A\": gamma = 1.4
             \"B\": gamma = 1.6 }
choice process { \"P\": kappa = 1
                 \"Q\": kappa = 2
                 \"A\": kappa = 3 }
x' = kappa*gamma/1 [s]
x(0) = 0
";
    let model = model(text);
    let [gas, process] = ["gas", "process"].map(|name| parameter(&model, name));
    let value = |text: &str| model.texts.iter().position(|known| known == text).unwrap() as f64;
    for (one, gamma) in [("A", 1.4), ("B", 1.6)] {
        for (other, kappa) in [("P", 1.0), ("Q", 2.0), ("A", 3.0)] {
            let mut setup = setup(&model, Method::RungeKutta4, 0.5);
            setup.parameters[gas] = value(one);
            setup.parameters[process] = value(other);
            let run = run(&model, setup, 2);
            let x = run.history().column(0)[2];
            assert!((x - gamma * kappa).abs() < 1e-12, "{one} and {other}: {x}");
        }
    }
}
