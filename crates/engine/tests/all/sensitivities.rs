//! Sensitivities of solutions to parameters, against derivatives of closed forms.

use crate::support::model;
use engine::{Method, Setup, Stepper};

/// The state and its sensitivity to each of `parameters` at `time`, by Dormand-Prince to 1e-10.
fn sensitivities(text: &str, values: &[f64], time: f64) -> (Vec<f64>, Vec<Vec<f64>>) {
    let model = model(text);
    let states = model.states.len();
    let parameters: Vec<usize> = (0..model.parameters.len()).collect();
    let extended = model.with_sensitivities(&parameters).unwrap();
    let mut setup = Setup { method: Method::DormandPrince, tolerance: 1e-10, ..Setup::defaults(&extended) };
    setup.parameters = values.to_vec();
    let mut stepper = Stepper::new(&extended, &setup).unwrap();
    stepper.advance_to(time).unwrap();
    assert_eq!(stepper.time(), time);
    let all = stepper.state();
    (all[..states].to_vec(), all[states..].chunks(states).map(<[f64]>::to_vec).collect())
}

/// Compares with central differences of a closed form y(parameters, t).
pub fn check(text: &str, values: &[f64], times: &[f64], exact: impl Fn(&[f64], f64) -> f64, tolerance: f64) {
    for &time in times {
        let (state, by_parameter) = sensitivities(text, values, time);
        let scale = values.iter().fold(1.0_f64, |scale, value| scale.max(value.abs()));
        assert!((state[0] - exact(values, time)).abs() < 1e-8 * scale, "the state at {time}");
        for (number, sensitivity) in by_parameter.iter().enumerate() {
            let step = 1e-5 * values[number].abs().max(0.1);
            let (mut above, mut below) = (values.to_vec(), values.to_vec());
            above[number] += step;
            below[number] -= step;
            let expected = (exact(&above, time) - exact(&below, time)) / (2.0 * step);
            let error = (sensitivity[0] - expected).abs();
            assert!(
                error < tolerance * expected.abs().max(1.0),
                "parameter {number} at {time}: {} instead of {expected}",
                sensitivity[0]
            );
        }
    }
}

#[test]
fn of_a_damped_oscillation_to_its_constants_and_initial_values() {
    let text = "
parameter k = 4 [s^-2]
parameter c = 0.3 [s^-1]
parameter y_0 = 0.7 [m]
parameter v_0 = -0.2 [m/s]
y'' = -k*y - c*y'
y(0) = y_0
y'(0) = v_0
";
    let exact = |p: &[f64], t: f64| {
        let gamma = p[1] / 2.0;
        let omega = (p[0] - gamma * gamma).sqrt();
        let phase = omega * t;
        libm::exp(-gamma * t) * (p[2] * libm::cos(phase) + (p[3] + gamma * p[2]) / omega * libm::sin(phase))
    };
    check(text, &[4.0, 0.3, 0.7, -0.2], &[0.3, 2.0, 9.7], exact, 1e-7);
}

/// A state does not depend on the numbers of what follows from it, nor on one that is read beside it.
#[test]
fn of_states_that_a_parameter_does_not_move_are_constant() {
    let text = "
parameter a = 0.5 [s^-1]
parameter b = 2 [s^-1]
parameter c = 3 [m]
parameter x_0 = 1 [m]
x' = -a*x
y' = a*x - b*y
x(0) = x_0
y(0) = 0 [m]
z = y + c
";
    let extended = model(text).with_sensitivities(&[0, 1, 2, 3]).unwrap();
    let still: Vec<bool> =
        extended.states[2..].iter().map(|state| extended.graph.as_constant(state.derivative) == Some(0.0)).collect();
    // Of x and y to each parameter.
    let expected = [[false, false], [true, false], [true, true], [false, false]];
    assert_eq!(still, expected.concat());
    let exact = |p: &[f64], t: f64| p[3] * libm::exp(-p[0] * t);
    check(text, &[0.5, 2.0, 3.0, 1.0], &[0.4, 2.5], exact, 1e-7);
}

#[test]
fn of_what_depends_on_the_initial_value_itself() {
    let text = "
parameter a = 0.5 [s^-1]
parameter y_0 = 2 [m]
y' = -a*(y - y(0)/2)
y(0) = y_0^2/(1 [m])
";
    let exact = |p: &[f64], t: f64| p[1] * p[1] * (0.5 + 0.5 * libm::exp(-p[0] * t));
    check(text, &[0.5, 2.0], &[1.0, 3.0], exact, 1e-7);
}

#[test]
fn of_a_ball_to_gravity_restitution_and_height_across_two_bounces() {
    let text = "
parameter g = 9.8 [m/s^2]
parameter e = 0.8
parameter h = 1 [m]
y'' = -g
y(0) = h
y'(0) = 0 [m/s]
when y < 0 [m] { y' = -e*y' }
";
    let exact = |p: &[f64], t: f64| {
        let (g, e, h) = (p[0], p[1], p[2]);
        let (mut start, mut speed) = ((2.0 * h / g).sqrt(), e * (2.0 * g * h).sqrt());
        if t < start {
            return h - g * t * t / 2.0;
        }
        while t > start + 2.0 * speed / g {
            start += 2.0 * speed / g;
            speed *= e;
        }
        let since = t - start;
        speed * since - g * since * since / 2.0
    };
    check(text, &[9.8, 0.8, 1.0], &[0.3, 0.7, 1.6], exact, 1e-6);
}

/// Where the force changes at a moment that depends on the parameters, the sensitivity jumps although the state does not.
#[test]
fn of_a_force_that_changes_where_a_condition_of_two_parts_is_met() {
    let text = "
parameter a = 2 [m/s^2]
parameter b = 3 [m]
y'' = if s > 0.5 then -a else a
y(0) = 0 [m]
y'(0) = 0 [m/s]
s' = 0 [s^-1]
s(0) = 0
when y > b and t > 0.1 [s] { s = 1 }
";
    let exact = |p: &[f64], t: f64| {
        let turn = (2.0 * p[1] / p[0]).sqrt();
        if t < turn {
            return p[0] * t * t / 2.0;
        }
        let since = t - turn;
        p[1] + p[0] * turn * since - p[0] * since * since / 2.0
    };
    check(text, &[2.0, 3.0], &[1.0, 2.5], exact, 1e-6);
}

/// Compares all sensitivities with central differences of the solution itself; one state after the other.
fn check_against_differences(what: &str, text: &str, time: f64) {
    let values: Vec<f64> = model(text).parameters.iter().map(|parameter| parameter.value).collect();
    let (_, by_parameter) = sensitivities(text, &values, time);
    for (number, sensitivity) in by_parameter.iter().enumerate() {
        let step = 1e-5 * values[number].abs().max(0.1);
        let moved = |step: f64| {
            let mut moved = values.clone();
            moved[number] += step;
            sensitivities(text, &moved, time).0
        };
        let (above, below) = (moved(step), moved(-step));
        for (state, found) in sensitivity.iter().enumerate() {
            let expected = (above[state] - below[state]) / (2.0 * step);
            let error = (found - expected).abs();
            assert!(
                error < 1e-6 * expected.abs().max(1.0),
                "{what}: state {state} by parameter {number}: {found} instead of {expected}"
            );
        }
    }
}

const BALL: &str = "
parameter g = 9.8 [m/s^2]
parameter e = 0.8
parameter h = 1 [m]
y'' = -g
y(0) = h
y'(0) = 0 [m/s]
";

/// Events of one moment, each with its own jump of the sensitivities: none may undo the jump of another.
#[test]
fn of_events_at_one_moment() {
    // Balls that meet the floor at one moment because they are dropped from one height, not because they must.
    let two_balls = "
parameter g = 9.8 [m/s^2]
parameter e_1 = 0.8
parameter e_2 = 0.6
parameter h_1 = 1 [m]
parameter h_2 = 1 [m]
y'' = -g
z'' = -g
y(0) = h_1
y'(0) = 0 [m/s]
z(0) = h_2
z'(0) = 0 [m/s]
when y < 0 [m] { y' = -e_1*y' }
when z < 0 [m] { z' = -e_2*z' }
";
    check_against_differences("two balls", two_balls, 0.7);
    // A sum of the losses at the bounces, which reads the velocity before or after the bounce.
    let lost = "
parameter m = 0.3 [kg]
w' = 0 [W]
w(0) = 0 [J]
when y < 0 [m] { w = w + m*y'^2/2*(1 - e^2) }
";
    let bounce = "when y < 0 [m] { y' = -e*y' }\n";
    check_against_differences("the bounce first", &[BALL, bounce, lost].concat(), 0.7);
    check_against_differences("the bounce last", &[BALL, lost, bounce].concat(), 0.7);
    // Both set the velocity, the later one what the first has left.
    let again = "when y < 0 [m] { y' = e^2*y' + e*(1 [m/s]) }\n";
    check_against_differences("both set the velocity", &[BALL, bounce, again].concat(), 0.7);
    // Nothing moves any more after the first; the second still has the moment of the impact.
    let stop = "
parameter u = 0.2 [m/s]
p' = 0 [m/s]
p(0) = h
d' = 1
d(0) = 0 [s]
when y < 0 [m] { y' = 0 [m/s] }
when y < 0 [m] { d = -d }
when y < 0 [m] { p = p + u*d }
";
    let still = BALL.replace("-g\n", "if d < 0 [s] then 0 else -g\n");
    check_against_differences("a stop and what it starts", &[&still, stop].concat(), 0.6);
}

/// An event that the jump of another has made due fires with that one, whatever the speed of its own condition.
#[test]
fn of_events_that_follow_from_one_another() {
    let chain = "
parameter k = 2 [m/s^2]
n' = 0 [s^-1]
n(0) = 0
q'' = k*n
q(0) = 0 [m]
q'(0) = 0 [m/s]
when y < 0 [m] { y' = -e*y'; n = n + 1 }
when n > 0.5 and q < 1 [m] { q' = h/(1 [s]) }
";
    check_against_differences("a chain", &[BALL, chain].concat(), 0.7);
}

/// The moments at which equations switch depend on parameters, too.
#[test]
fn across_switches_of_the_equations() {
    let text = "
parameter a = 2 [m/s]
parameter b = 0.5 [m/s]
parameter c = 1.2 [m]
parameter d = 1.7 [s]
x' = (if x < c then a else b) + (if t < d then 0 else c/(3 [s]))
x(0) = 0 [m]
";
    let exact = |p: &[f64], t: f64| {
        let reached = p[2] / p[0];
        let slow = if t < reached { p[0] * t } else { p[2] + p[1] * (t - reached) };
        slow + p[2] / 3.0 * (t - p[3]).max(0.0)
    };
    check(text, &[2.0, 0.5, 1.2, 1.7], &[0.3, 1.0, 4.0], exact, 1e-8);
    // A saw: floor counts the teeth.
    let text = "
parameter a = 0.9 [m/s]
parameter l = 0.4 [m]
x' = a*(1 + floor(x/l))
x(0) = 0 [m]
";
    let exact = |p: &[f64], t: f64| {
        let (mut left, mut tooth) = (t, 0.0);
        while left > p[1] / (p[0] * (1.0 + tooth)) {
            left -= p[1] / (p[0] * (1.0 + tooth));
            tooth += 1.0;
        }
        tooth * p[1] + p[0] * (1.0 + tooth) * left
    };
    check(text, &[0.9, 0.4], &[0.3, 0.6, 1.1], exact, 1e-6);
}

/// Where a body comes to rest depends on every parameter; while it slides, sticks and has come to rest.
#[test]
fn across_dry_friction() {
    let text = "
parameter k = 4 [s^-2]
parameter F = 0.45 [m/s^2]
parameter y_0 = 1 [m]
y'' = -k*y - coulomb(y', F)
y(0) = y_0
y'(0) = 0 [m/s]
";
    for time in [1.0, 2.0, 5.0, 8.0] {
        check_against_differences("a spring with dry friction", text, time);
    }
}

/// The derivative of the root is infinite where the vessel is empty; behind it nothing depends on a parameter.
#[test]
fn of_a_vessel_that_runs_empty() {
    let exact = |p: &[f64], t: f64| {
        let root = p[1].sqrt() - 0.5 * p[0] * t;
        if root > 0.0 { root * root } else { 0.0 }
    };
    for root in ["sqrt(max(h, 0))", "(if h > 0 then sqrt(h) else 0)", "sign(h)*sqrt(abs(h))"] {
        let text = format!("independent t\nparameter c = 1\nparameter h_0 = 1\nh' = -c*{root}\nh(0) = h_0");
        check(&text, &[1.0, 1.0], &[0.7, 1.6, 2.5], exact, 1e-4);
    }
}
