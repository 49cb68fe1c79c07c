//! Symbolic derivatives compared with finite differences.

use crate::common::{At, compile, difference};
use program::{Variable, differentiate, differentiate_all};

/// Every function, away from its corners, at y = 0.6 and p = 1.4.
const EXPRESSIONS: &[&str] = &[
    "y^3 - p*y",
    "y/p + p/y",
    "y^p",
    "p^y",
    "y^2.5",
    "y^(-3)",
    "y^(1/3)",
    "sqrt(y*p)",
    "cbrt(y + p)",
    "abs(y - p)",
    "sign(y)*y",
    "exp(-p*y)",
    "ln(y + p)",
    "log10(y*p)",
    "sin(p*y)",
    "cos(p*y)",
    "tan(p*y)",
    "asin(y/p)",
    "acos(y/p)",
    "atan(p*y)",
    "atan2(y, p)",
    "sinh(p*y)",
    "cosh(p*y)",
    "tanh(p*y)",
    "asinh(p*y)",
    "acosh(1 + p*y)",
    "atanh(y/p)",
    "floor(7*y)*y",
    "min(y, p) + max(y^2, p, 3*y)",
    "mod(8*y, p)",
    "hypot(y, p)",
    "if y < p then y^2 else p",
    "sin(t*p)*y",
];

#[test]
fn of_every_function() {
    for expression in EXPRESSIONS {
        let mut model = compile(&format!("independent t\nparameter p = 1.4\nf = {expression}\ny' = 1\ny(0) = 0.6\n"));
        let at = At::new(&model, 0.3, &[0.6]);
        let f = model.lookup("f", 0).unwrap().node;
        for variable in [Variable::State(0), Variable::Parameter(0), Variable::Independent] {
            let derivative = differentiate(&mut model.graph, f, variable);
            let found = at.value(&model.graph, derivative);
            let expected = difference(&model, &at, f, variable);
            assert!(
                (found - expected).abs() < 1e-8 * expected.abs().max(1.0),
                "{expression} by {variable:?}: {found}, {expected}"
            );
        }
    }
}

#[test]
fn of_the_solution_of_coupled_equations() {
    let mut model = compile(
        "independent t\nparameter p = 1.4\n\
         (2 + x^2)*x'' + p*y''*cos(x - y) = -sin(x)\n\
         p*x''*cos(x - y) + (3 + y'^2)*y'' = x*y' + t\n\
         x(0) = 0\nx'(0) = 0\ny(0) = 0\ny'(0) = 0\n",
    );
    assert_eq!(model.graph.systems().len(), 1);
    let at = At::new(&model, 0.3, &[0.4, -0.7, 1.1, 0.9]);
    let rates = [model.lookup("x", 2).unwrap().node, model.lookup("y", 2).unwrap().node];
    let variables = (0..4).map(Variable::State).chain([Variable::Parameter(0), Variable::Independent]);
    for variable in variables {
        let derivatives = differentiate_all(&mut model.graph, &rates, variable);
        for (rate, derivative) in rates.into_iter().zip(derivatives) {
            let expected = difference(&model, &at, rate, variable);
            let found = at.value(&model.graph, derivative);
            assert!((found - expected).abs() < 1e-8, "{variable:?}: {found}, {expected}");
        }
    }
}

#[test]
fn what_does_not_depend_has_the_derivative_0() {
    let mut model = compile("independent t\nparameter p = 1.4\nf = sin(p)\ny' = -y\ny(0) = 1\n");
    let f = model.lookup("f", 0).unwrap().node;
    let derivative = differentiate(&mut model.graph, f, Variable::State(0));
    assert_eq!(model.graph.as_constant(derivative), Some(0.0));
}

#[test]
fn primes_of_definitions_follow_the_solution() {
    // d/dt of the energy of a damped oscillator is minus the power lost in the damper.
    let model = compile(
        "parameter m = 2 [kg]\nparameter k = 3 [N/m]\nparameter b = 0.5 [kg/s]\nm*x'' = -k*x - b*x'\n\
         x(0) = 1 [m]\nx'(0) = 0\nE = m*x'^2/2 + k*x^2/2\nP = E' in [W]\nj = x'''\n",
    );
    let at = At::new(&model, 0.0, &[0.7, -1.3]);
    crate::common::assert_near(crate::common::value(&model, &at, "P", 0), -0.5 * 1.3 * 1.3);
    // x''' = (-k x' - b x'')/m
    let acceleration = (-3.0 * 0.7 + 0.5 * 1.3) / 2.0;
    crate::common::assert_near(crate::common::value(&model, &at, "j", 0), (3.0 * 1.3 - 0.5 * acceleration) / 2.0);
}

#[test]
fn a_damped_closed_form_and_its_velocity() {
    let model = compile(
        "parameter A = 0.5 [m]\nparameter gamma = 0.1 [1/s]\nparameter omega = 1.7 [1/s]\n\
         y = A*exp(-gamma*t)*cos(omega*t)\nv = y'\n",
    );
    let at = At::new(&model, 2.5, &[]);
    let (cos, sin) = (libm::cos(1.7 * 2.5), libm::sin(1.7 * 2.5));
    let expected = 0.5 * libm::exp(-0.25) * (-0.1 * cos - 1.7 * sin);
    crate::common::assert_near(crate::common::value(&model, &at, "v", 0), expected);
}
