//! Events that begin and end within a step: none is skipped, and where that cannot be guaranteed the run gives a notice.

use crate::support::{jumps, model, run, setup};
use engine::{Method, Run, Setup, Subject};

/// The methods that follow a parabola exactly, besides Euler's.
const EXACT: [Method; 5] =
    [Method::EulerRichardson, Method::VelocityVerlet, Method::RungeKutta4, Method::DormandPrince, Method::Rosenbrock];

fn counting(text: &str, method: Method, step: f64, steps: usize) -> Run {
    let model = model(text);
    run(&model, setup(&model, method, step), steps)
}

/// A stone that is thrown up 4.9 m dips through a threshold for a time that is shorter than the step, whatever the step.
#[test]
fn a_graze_through_a_threshold_is_seen() {
    for method in EXACT {
        for (height, steps) in [(4.899, 20), (4.899_999, 20), (4.8, 3), (4.899_999_999, 7)] {
            let text = format!(
                "y'' = -9.8 [m/s^2]\ny(0) = 0 [m]\ny'(0) = 9.8 [m/s]\ndiscrete n = 0\nwhen y > {height} [m] {{ n = n + 1 }}"
            );
            let run = counting(&text, method, 2.1 / steps as f64, steps);
            assert_eq!(run.state()[2], 1.0, "{method}, {height}, {steps} steps");
            let expected = 1.0 - (1.0 - height / 4.9_f64).sqrt();
            // At a height of so little less than the greatest the moment is rounded most.
            let found = jumps(&run)[0];
            assert!((found - expected).abs() < 1e-7, "{method}, {height}: {found} for {expected}");
            assert_eq!(run.notices(), [], "{method}");
        }
        // Not quite as high: nothing happens, and the bits are those of the model without an event.
        let plain = "y'' = -9.8 [m/s^2]\ny(0) = 0 [m]\ny'(0) = 9.8 [m/s]\ndiscrete n = 0\n";
        let missed = counting(&format!("{plain}when y > 4.900001 [m] {{ n = n + 1 }}"), method, 0.3, 7);
        assert_eq!(missed.history().fingerprint(), counting(plain, method, 0.3, 7).history().fingerprint(), "{method}");
    }
}

/// The graze of a stone that counts only after 0.9 s: the step in which it lies begins at 0.7 s.
#[test]
fn a_graze_and_the_time_are_seen_together() {
    let text = "y'' = -9.8 [m/s^2]\ny(0) = 0 [m]\ny'(0) = 9.8 [m/s]\ndiscrete n = 0\n\
                when y > 4.899 [m] and t > 0.9 [s] { n = n + 1 }";
    for method in EXACT {
        assert_eq!(counting(text, method, 0.7, 3).state()[2], 1.0, "{method}");
    }
}

/// A push of 10 microseconds whose moment is a parameter, at the value of the document and at another one.
#[test]
fn a_short_push_at_a_moment_by_a_parameter_is_not_skipped() {
    let model =
        model("parameter T = 0.313 [s]\nv' = if t > T and t < T + 1e-5 [s] then 1e5 [1/s] else 0 [1/s]\nv(0) = 0");
    for method in [Method::Euler, Method::RungeKutta4, Method::DormandPrince, Method::Rosenbrock] {
        for moment in [0.313, 0.747] {
            let run = run(&model, Setup { parameters: vec![moment], ..setup(&model, method, 0.1) }, 10);
            assert!((run.state()[0] - 1.0).abs() < 1e-6, "{method}, {moment}: {}", run.state()[0]);
        }
    }
}

/// Two conditions that hold together only between two crossings inside one step.
#[test]
fn two_crossings_in_a_step() {
    let text = "x' = 1 [m/s]\nx(0) = 0 [m]\ny' = -1 [m/s]\ny(0) = 1 [m]\ndiscrete n = 0\n\
                when x > 0.52 [m] and y > 0.47 [m] { n = n + 1 }";
    for method in Method::ALL.into_iter().filter(|method| *method != Method::VelocityVerlet) {
        for step in [0.1, 0.5, 0.9] {
            let run = counting(text, method, step, 2);
            assert_eq!(run.state()[2], if step > 0.4 { 1.0 } else { 0.0 }, "{method}, {step}");
        }
        let run = counting(text, method, 1.0, 1);
        assert!((jumps(&run)[0] - 0.52).abs() < 1e-12, "{method}");
    }
}

/// A wheel that turns many times in a step, by a state and not by the time, and the pulses of a remainder.
#[test]
fn none_of_238_fast_events_is_skipped() {
    let text = "phi' = 2*pi*238 [1/s]\nphi(0) = 0\ndiscrete n = 0\ndiscrete m = 0\nwhen sin(phi) > 0 { n = n + 1 }\n\
                when mod(phi, 2*pi) < 0.001 { m = m + 1 }";
    for method in [Method::Euler, Method::RungeKutta4, Method::DormandPrince, Method::Rosenbrock] {
        let run = counting(text, method, 0.05, 20);
        // The angle is small at the start already; the last of both lies at the very end.
        assert!((237.0..=238.0).contains(&run.state()[1]), "{method}: {}", run.state()[1]);
        assert!((237.0..=238.0).contains(&run.state()[2]), "{method}: {}", run.state()[2]);
        assert_eq!(run.notices(), [], "{method}");
    }
}

/// An action between two crossings of one step is seen by the second.
#[test]
fn a_threshold_that_moves_at_its_first_crossing() {
    let text = "y'' = -9.8 [m/s^2]\ny(0) = 0 [m]\ny'(0) = 9.8 [m/s]\ndiscrete h = 4.8 [m]\ndiscrete n = 0\n\
                when y > h { h = h + 0.03 [m], n = n + 1 }";
    for method in EXACT {
        assert_eq!(counting(text, method, 0.7, 3).state()[3], 4.0, "{method}");
    }
}

/// A short push by the equations, not by an event.
#[test]
fn a_jump_of_the_equations_is_not_skipped_either() {
    let text = "x' = 1 [m/s]\nx(0) = 0 [m]\nv' = if x > 0.52 [m] and x < 0.53 [m] then 100 [1/s] else 0\nv(0) = 0";
    for method in Method::ALL.into_iter().filter(|method| *method != Method::VelocityVerlet) {
        let run = counting(text, method, 0.4, 3);
        assert!((run.state()[1] - 1.0).abs() < 1e-9, "{method}: {}", run.state()[1]);
    }
}

#[test]
fn what_cannot_be_promised_is_said() {
    let fast = "phi' = 1 [rad/s]\nphi(0) = 0\ndiscrete n = 0\nwhen sin(100000*phi) > 0 { n = n + 1 }";
    let run = counting(fast, Method::RungeKutta4, 0.05, 1);
    let [notice] = run.notices().try_into().expect("one notice");
    assert_eq!((notice.code(), notice.time, notice.subject()), ("may-be-skipped", 0.0, Some(Subject::Event(0))));
    let in_time = "discrete n = 0\nwhen sin(100000 [1/s]*t) > 0 { n = n + 1 }";
    let run = counting(in_time, Method::RungeKutta4, 0.05, 1);
    assert_eq!(run.notices().iter().map(|notice| notice.code()).collect::<Vec<_>>(), ["too-fast-in-time"]);
    let message = run.notices()[0].message(&model(in_time));
    assert!(message.english().ends_with("from t = 0 s on"), "{message:?}");
    assert!(message.text(catalogues::with(units::Language::Spanish)).contains("t = 0 s"), "{message:?}");
    // After going back to the start there is no notice; after going back to a later row it stays.
    for text in [fast, in_time] {
        let mut back = counting(text, Method::RungeKutta4, 0.05, 3);
        back.truncate(1);
        assert_eq!(back.notices().len(), 1, "{text}");
        back.truncate(0);
        assert_eq!(back.notices(), [], "{text}");
    }
    let slow = "discrete n = 0\nwhen sin(2*pi*238 [1/s]*t) > 0 { n = n + 1 }";
    assert_eq!(counting(slow, Method::RungeKutta4, 0.05, 20).notices(), []);
}

#[test]
fn the_event_in_doubt_is_named() {
    let fast = "phi' = 1 [rad/s]\nphi(0) = 0\nX = maximum(sin(100000*phi))";
    let run = counting(fast, Method::RungeKutta4, 0.05, 1);
    let message = run.notices()[0].message(&model(fast));
    assert!(message.english().starts_with("the event that changes `maximum(sin(100000*phi))` may be"), "{message:?}");
    let named = "phi' = 1 [rad/s]\nphi(0) = 0\ndiscrete n = 0\nwhen sin(100000*phi) > 0 as drive { n = n + 1 }";
    let run = counting(named, Method::RungeKutta4, 0.05, 1);
    assert!(run.notices()[0].message(&model(named)).english().starts_with("the event `drive` may be"));
}

/// A root that is not defined in the middle of a step, where the interpolant is checked, and is near 0 for short times on
/// both sides.
#[test]
fn a_value_that_ceases_to_be_a_number_hides_no_event() {
    for (centre, half) in [(0.455, 0.2), (0.45, 0.25), (0.47, 0.3), (0.4, 0.35)] {
        let text = format!(
            "independent t\nx' = 1\nx(0) = 0\ndiscrete n = 0\nwhen sqrt((x - {centre})^2 - {half}^2) < 0.05 {{ n = n + 1 }}"
        );
        for method in [Method::EulerRichardson, Method::RungeKutta4, Method::DormandPrince, Method::Rosenbrock] {
            let run = counting(&text, method, 1.0, 1);
            assert_eq!(run.state()[1], 2.0, "{method}, {centre}, {half}: {:?}", jumps(&run));
            let expected = centre - (half * half + 0.0025_f64).sqrt();
            assert!((jumps(&run)[0] - expected).abs() < 1e-9, "{method}: {:?} for {expected}", jumps(&run));
        }
    }
    let quiet = "independent t\nx' = 1\nx(0) = 0\ndiscrete n = 0\nwhen sqrt(x - 0.5) > 10 { n = n + 1 }";
    let run = counting(quiet, Method::RungeKutta4, 0.3, 7);
    assert_eq!((run.state()[1], run.notices()), (0.0, Vec::new()));
}

/// The voltage of a motor, switched by time, by an event, or by a state.
const VOLTAGES: [&str; 8] = [
    "if t < T then 0 [V] else 12 [V]",
    "if t > T and t < T + 0.7 [s] then 12 [V] else 0 [V]",
    "if mod(t, T) < 0.4*T then 12 [V] else -3 [V]",
    "12 [V]*sign(sin(2*pi*t/T))",
    "12 [V]*floor(t/T)/(2 + floor(t/T))",
    "if on then 12 [V] else 0 [V]",
    "if w < 3 [1/s] then 12 [V] else 8 [V]",
    "10 [V] + 2 [V]*sign(3 [1/s] - w)",
];

/// A motor with this voltage and inductance in H. Events see its current and its speed, and its current has a maximum.
fn motor(voltage: &str, moment: f64, inductance: f64) -> String {
    format!(
        "T = {moment} [s]\nU = {voltage}\ndiscrete on = true\ndiscrete n = 0\n\
         {inductance} [H]*i' = U - 1 [ohm]*i - 0.5 [V s]*w\n0.05 [kg m^2]*w' = 0.5 [N m/A]*i - 0.02 [N m s]*w\n\
         i(0) = 0 [A]\nw(0) = 0 [1/s]\nwhen w > 4 [1/s] {{ n = n + 1, on = false }}\nwhen w < 2 [1/s] {{ on = true }}\n\
         when i > 3 [A] {{ n = n + 1 }}\ni_max = maximum(i)\nwhen i' < -5 [A/s] {{ n = n + 1 }}\n"
    )
}

/// The slope of the current jumps with the voltage, and the number compared by the maximum jumps over zero. All changes are
/// detected.
#[test]
fn a_switched_voltage_gives_no_false_alarm() {
    for voltage in VOLTAGES {
        for (moment, inductance, step) in
            [(0.33, 0.1, 0.05), (0.5, 0.1, 0.01), (1.0, 0.1, 0.02), (0.7, 0.02, 0.005), (0.61, 0.3, 0.1)]
        {
            let text = motor(voltage, moment, inductance);
            for method in [Method::RungeKutta4, Method::EulerRichardson, Method::DormandPrince, Method::Rosenbrock] {
                let run = counting(&text, method, step, (2.0 / step) as usize);
                assert_eq!(run.notices(), [], "{method}, {inductance} H, step {step}, {moment} s: {voltage}");
            }
        }
    }
}

/// With a switched voltage, too, a notice is given if events may be skipped: a mark on the axis that passes hundreds of
/// times per step. It acts only after 99 counts, so that none of its passages ends a step.
#[test]
fn a_switched_voltage_hides_no_doubt() {
    for voltage in VOLTAGES {
        let fast = "phi' = w + 1 [1/s]\nphi(0) = 0\nwhen sin(20000*phi) > 0 and n > 99 as mark { n = n + 1 }\n";
        let text = format!("{}{fast}", motor(voltage, 0.05, 0.1));
        for method in [Method::RungeKutta4, Method::DormandPrince] {
            let run = counting(&text, method, 0.1, 1);
            let message = run.notices().first().map(|notice| notice.message(&model(&text)));
            let message = message.unwrap_or_else(|| panic!("{method}: nothing is said: {voltage}"));
            assert!(message.english().starts_with("the event `mark` may be"), "{method}, {voltage}: {message:?}");
        }
    }
}
