//! Models compared with equations of motion derived by hand.

use crate::common::{At, assert_near, compile, value};
use program::{Kind, Node};

const UTUBE: &str = r#"
parameter g   = 9.8  [m/s^2]
parameter rho = 1000 [kg/m^3]
parameter S   = 0.05 [m^2]
parameter b   = 50   [kg/s]
parameter h_l = 3    [m]
parameter h_r = 2    [m]
parameter v_0 = 0    [m/s]
L = 2 [m] + h_l + h_r
m = rho*S*L
rho*S*L*y'' + b*y' + 2*rho*S*g*y = 0
y(0)  = (h_l - h_r)/2
y'(0) = v_0
T = m*y'^2/2 in [J]
V = m*g*y^2/L in [J]
E = T + V
b_c = 2*m*sqrt(2*g/L)
regime = if b < b_c then "underdamped" else "overdamped"
"#;

#[test]
fn the_u_tube_is_its_equation_of_motion() {
    let model = compile(UTUBE);
    let names: Vec<String> = model.states.iter().map(program::State::name).collect();
    assert_eq!(names, ["y", "y'"]);
    assert_eq!(model.states.iter().map(|state| state.unit.text.as_str()).collect::<Vec<_>>(), ["m", "m/s"]);
    for (y, v) in [(0.5, 0.0), (-0.3, 1.7), (1e-9, -2.0)] {
        let at = At::new(&model, 0.0, &[y, v]);
        let (g, rho, s, l, b) = (9.8, 1000.0, 0.05, 7.0, 50.0);
        assert_near(value(&model, &at, "y", 2), -(b * v + 2.0 * rho * s * g * y) / (rho * s * l));
        assert_near(at.value(&model.graph, model.states[0].derivative), v);
        let m = rho * s * l;
        assert_near(value(&model, &at, "E", 0), m * v * v / 2.0 + m * g * y * y / l);
    }
    let at = At::new(&model, 0.0, &[0.0, 0.0]);
    assert_eq!(at.initial, [0.5, 0.0]);
}

#[test]
fn parameters_behind_initial_values_restart_the_run() {
    let model = compile(UTUBE);
    let restarts: Vec<&str> = model
        .parameters
        .iter()
        .filter(|parameter| parameter.restarts)
        .map(|parameter| parameter.name.as_str())
        .collect();
    assert_eq!(restarts, ["h_l", "h_r", "v_0"]);
    let varies: Vec<&str> =
        model.quantities.iter().filter(|quantity| quantity.varies).map(|quantity| quantity.name.as_str()).collect();
    assert_eq!(varies, ["T", "V", "E"]);
}

#[test]
fn a_text_follows_the_parameters() {
    let model = compile(UTUBE);
    let regime = model.lookup("regime", 0).unwrap();
    assert_eq!(regime.kind, Kind::Text);
    let mut at = At::new(&model, 0.0, &[0.0, 0.0]);
    let text = |at: &At| model.texts[at.value(&model.graph, regime.node) as usize].clone();
    assert_eq!(text(&at), "underdamped");
    at.parameters[3] = 5000.0;
    assert_eq!(text(&at), "overdamped");
}

/// Accelerations of the double pendulum derived by hand, as in textbooks and on myphysicslab.com.
fn double_pendulum([m1, m2, l1, l2, g]: [f64; 5], [a, wa, b, wb]: [f64; 4]) -> [f64; 2] {
    let (sin, cos) = (libm::sin, libm::cos);
    let d = 2.0 * m1 + m2 - m2 * cos(2.0 * a - 2.0 * b);
    let first = -g * (2.0 * m1 + m2) * sin(a)
        - m2 * g * sin(a - 2.0 * b)
        - 2.0 * sin(a - b) * m2 * (wb * wb * l2 + wa * wa * l1 * cos(a - b));
    let second =
        2.0 * sin(a - b) * (wa * wa * l1 * (m1 + m2) + g * (m1 + m2) * cos(a) + wb * wb * l2 * m2 * cos(a - b));
    [first / (l1 * d), second / (l2 * d)]
}

#[test]
fn the_double_pendulum_runs_from_its_lagrange_equations() {
    let model = compile(
        "parameter m1 = 1.5 [kg]\nparameter m2 = 0.7 [kg]\nparameter l1 = 1.1 [m]\nparameter l2 = 0.6 [m]\n\
         parameter g = 9.81 [m/s^2]\n\
         (m1 + m2)*l1*alpha'' + m2*l2*beta''*cos(alpha - beta) + m2*l2*beta'^2*sin(alpha - beta) + (m1 + m2)*g*sin(alpha) = 0\n\
         m2*l2*beta'' + m2*l1*alpha''*cos(alpha - beta) - m2*l1*alpha'^2*sin(alpha - beta) + m2*g*sin(beta) = 0\n\
         alpha(0) = 120 [deg]\nalpha'(0) = 0 [1/s]\nbeta(0) = -10 [deg]\nbeta'(0) = 0 [1/s]\n",
    );
    assert_eq!(model.graph.systems().len(), 1);
    for states in [[2.0, 0.0, -0.2, 0.0], [0.3, -1.2, 1.9, 4.5], [-3.0, 6.0, 0.1, -0.7]] {
        let at = At::new(&model, 0.0, &states);
        let expected = double_pendulum([1.5, 0.7, 1.1, 0.6, 9.81], states);
        assert_near(value(&model, &at, "alpha", 2), expected[0]);
        assert_near(value(&model, &at, "beta", 2), expected[1]);
    }
}

#[test]
fn equations_are_solved_one_after_the_other_where_possible() {
    // The second equation determines x'', which the first needs.
    let model = compile("independent t\ny'' + x''/2 = -y\n3*x'' = -x\nx(0) = 1\nx'(0) = 0\ny(0) = 0\ny'(0) = 0\n");
    assert!(model.graph.systems().is_empty());
    let at = At::new(&model, 0.0, &[0.6, 0.0, 0.25, 0.0]);
    assert_near(value(&model, &at, "x", 2), -0.2);
    assert_near(value(&model, &at, "y", 2), -0.25 + 0.1);
}

/// y'' as a function of y and y'.
type Acceleration = fn(f64, f64) -> f64;

#[test]
fn implicit_forms_are_solved() {
    let cases: &[(&str, Acceleration)] = &[
        ("0 = y'' + y", |y, _| -y),
        ("-(y'' - 3*y') = y", |y, v| 3.0 * v - y),
        ("(y'' + y)/(1 + y^2) = y'", |y, v| v * (1.0 + y * y) - y),
        ("2*(y'' + y'*(1 - y'')) = 3", |_, v| (1.5 - v) / (1.0 - v)),
        ("(if y > 0 then y'' else 2*y'') = 1", |y, _| if y > 0.0 { 1.0 } else { 0.5 }),
        ("F = -y\n2*y'' = F", |y, _| -y / 2.0),
        ("a = y''\n2*a + y = a", |y, _| -y),
        ("p = (1 + y^2)*y'\np' = -y", |y, v| (-y - 2.0 * y * v * v) / (1.0 + y * y)),
        ("y'' = -y*abs(y)*3", |y, _| -3.0 * y * y.abs()),
    ];
    for (equation, expected) in cases {
        let model = compile(&format!("independent t\n{equation}\ny(0) = 1\ny'(0) = 0\n"));
        for (y, v) in [(0.5, 0.25), (-0.7, 2.0)] {
            let at = At::new(&model, 0.0, &[y, v]);
            let found = value(&model, &at, "y", 2);
            assert!((found - expected(y, v)).abs() < 1e-14, "{equation}: {found}");
        }
    }
}

#[test]
fn systems_of_first_and_mixed_order() {
    let model = compile(
        "parameter a = 1.1 [1/s]\nparameter b = 0.4 [1/s]\nprey' = a*prey - b*prey*predator\n\
         predator' = b*prey*predator - predator*0.3 [1/s]\nprey(0) = 10\npredator(0) = 5\n\
         w''' = prey/1 [s^3]\nw(0) = 0\nw'(0) = 0\nw''(0) = 0\n",
    );
    let names: Vec<String> = model.states.iter().map(program::State::name).collect();
    assert_eq!(names, ["prey", "predator", "w", "w'", "w''"]);
    let at = At::new(&model, 0.0, &[10.0, 5.0, 0.0, 0.0, 0.0]);
    assert_near(value(&model, &at, "prey", 1), 11.0 - 20.0);
    assert_near(value(&model, &at, "predator", 1), 20.0 - 1.5);
    assert_near(value(&model, &at, "w", 3), 10.0);
}

#[test]
fn initial_values_may_use_each_other_and_readouts_the_start() {
    let model = compile(
        "parameter A = 2 [m]\nparameter k = 3 [1/s]\nx'' = -k^2*x\nx'(0) = k*x(0)\nx(0) = A\n\
         E = (x'^2 + k^2*x^2)/2\nloss = 1 - E/E(0)\n",
    );
    let at = At::new(&model, 0.0, &[2.0, 6.0]);
    assert_eq!(at.initial, [2.0, 6.0]);
    assert_eq!(value(&model, &at, "loss", 0), 0.0);
    let later = At { states: vec![1.0, 3.0], ..at };
    assert_near(value(&model, &later, "loss", 0), 0.75);
    assert!(model.parameters.iter().all(|parameter| parameter.restarts));
}

#[test]
fn events_have_a_condition_and_change_states() {
    let model = compile(
        "parameter e = 0.8\nparameter g = 9.8 [m/s^2]\ny'' = -g\ny(0) = 1 [m]\ny'(0) = 0\nwhen y < 0 [m] { y' = -e*y' }\n",
    );
    let event = &model.events[0];
    let at = At::new(&model, 0.0, &[-0.1, -2.0]);
    assert_eq!(at.value(&model.graph, event.condition), 1.0);
    let (state, to) = event.actions[0];
    assert_eq!(state, 1);
    assert_near(at.value(&model.graph, to), 1.6);
}

#[test]
fn a_model_may_have_no_equation_at_all() {
    let model = compile("parameter A = 2 [m]\nparameter omega = 3 [1/s]\ny = A*cos(omega*t)\nv = y'\na = y''\n");
    assert!(model.states.is_empty());
    let at = At::new(&model, 0.4, &[]);
    assert_near(value(&model, &at, "v", 0), -6.0 * libm::sin(1.2));
    assert_near(value(&model, &at, "a", 0), -18.0 * libm::cos(1.2));
    assert_eq!(model.lookup("v", 0).unwrap().unit.text, "m/s");
}

#[test]
fn the_independent_variable_can_be_a_length() {
    let model = compile("independent x in [m]\ny'' = -y/(2 [m])^2\ny(0) = 1 [cm]\ny'(0) = 0 in [cm/m]\n");
    assert_eq!(model.independent.name, "x");
    assert_eq!(model.states[1].unit.text, "cm/m");
    let at = At::new(&model, 0.0, &[0.01, 0.0]);
    assert_near(value(&model, &at, "y", 2), -0.0025);
}

#[test]
fn equal_expressions_are_computed_once() {
    let model = compile("independent t\ny'' = -sin(y)\ny(0) = 1\ny'(0) = 0\na = sin(y)\nb = sin(y) + 1\n");
    let sines = (0..model.graph.len() as u32)
        .filter(|&number| matches!(model.graph.node(program::NodeId(number)), Node::Unary(program::Unary::Sin, _)))
        .count();
    assert_eq!(sines, 1);
}

#[test]
fn counts_are_whole() {
    let source = "parameter e = 0.9\ny'' = -9.81 [m/s^2]\ny(0) = 1 [m]\ny'(0) = 0 [m/s]\nn' = 0\nn(0) = 0\n\
        half' = 0\nhalf(0) = 0\nboth' = 0\nboth(0) = 1\ntwice = 2*n + 1\nquarter = n/4\nrounded = floor(e)\n\
        when y < 0 [m] {\n  y' = -e*y'\n  n = n + 1\n  half = half + 0.5\n  both = both + half\n}\n";
    let model = compile(source);
    let whole = model.whole_numbers();
    let is_whole = |name: &str| model.lookup(name, 0).is_some_and(|value| whole[value.node.0 as usize]);
    let names = ["n", "twice", "rounded", "y", "half", "both", "quarter", "e"];
    assert_eq!(names.map(is_whole), [true, true, true, false, false, false, false, false]);
}

#[test]
fn a_default_may_be_a_quotient_and_what_is_hidden_is_marked() {
    let model = compile(
        "parameter k = 1/3 [1/s] in 0..2\nsize N = 3\nhidden a = 2*k\nhidden b[i] = i*k for i in 1..N\nc = a + b[2]\nhidden = 4",
    );
    assert_eq!(model.parameters[0].value, 1.0 / 3.0);
    let hidden: Vec<(&str, bool)> =
        model.quantities.iter().map(|quantity| (quantity.name.as_str(), quantity.hidden)).collect();
    let expected = [("a", true), ("b[1]", true), ("b[2]", true), ("b[3]", true), ("c", false), ("hidden", false)];
    assert_eq!(hidden, expected);
}

/// Quotients are read as derivatives only if the names have no other meaning.
#[test]
fn differences_may_be_called_dx_and_dt() {
    let model = compile("dt = 0.1 [s]\ndx = 0.5 [m]\nc = dx/dt");
    assert_near(At::new(&model, 0.0, &[]).value(&model.graph, model.quantities[2].value.node), 5.0);
}
