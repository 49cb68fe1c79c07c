//! Order of each method, and known results on its energy.

use crate::support::{U_TUBE, model, setup};
use engine::{Method, Run, Setup, Subject};
use program::Model;

/// The greatest error of `y` at the end of a run to `until`, for a step and its half.
fn slope(model: &Model, method: Method, step: f64, until: f64, exact: f64) -> f64 {
    let error = |step: f64| {
        let rows = (until / step).round() as usize;
        (crate::support::run(model, setup(model, method, step), rows).state()[0] - exact).abs()
    };
    libm::log2(error(step) / error(0.5 * step))
}

const DAMPED: &str = "
independent t
parameter c = 0.3
y'' = -y - c*y'
y(0) = 1
y'(0) = 0
";

/// y of [`DAMPED`] with c = 0.3 at `t`.
fn damped(t: f64) -> f64 {
    let (gamma, omega) = (0.15, (1.0_f64 - 0.15 * 0.15).sqrt());
    libm::exp(-gamma * t) * (libm::cos(omega * t) + gamma / omega * libm::sin(omega * t))
}

#[test]
fn methods_of_fixed_step_have_their_orders_with_damping() {
    let model = model(DAMPED);
    for (method, step, order) in [
        (Method::Euler, 0.001, 1.0),
        (Method::EulerRichardson, 0.01, 2.0),
        (Method::VelocityVerlet, 0.01, 2.0),
        (Method::RungeKutta4, 0.05, 4.0),
    ] {
        let slope = slope(&model, method, step, 4.0, damped(4.0));
        assert!((slope - order).abs() < 0.1, "{method}: {slope}");
        assert_eq!(f64::from(method.order()), order);
    }
}

#[test]
fn methods_of_fixed_step_have_their_orders_with_a_force_that_depends_on_time() {
    // y'' = -y + sin(2 t), from rest at 0: y = (2 sin t - sin 2t)/3.
    let model = model("independent t\ny'' = -y + sin(2*t)\ny(0) = 0\ny'(0) = 0\n");
    let exact = (2.0 * libm::sin(4.0) - libm::sin(8.0)) / 3.0;
    for (method, step, order) in [
        (Method::Euler, 0.001, 1.0),
        (Method::EulerRichardson, 0.01, 2.0),
        (Method::VelocityVerlet, 0.01, 2.0),
        (Method::RungeKutta4, 0.05, 4.0),
    ] {
        let slope = slope(&model, method, step, 4.0, exact);
        assert!((slope - order).abs() < 0.15, "{method}: {slope}");
    }
}

#[test]
fn velocity_verlet_has_order_2_with_friction_that_is_not_linear() {
    // m v' = -k v^2: x = ln(1 + t) for k/m = v_0 = 1.
    let model = model("independent t\nx'' = -x'^2\nx(0) = 0\nx'(0) = 1\n");
    let slope = slope(&model, Method::VelocityVerlet, 0.01, 2.0, libm::log(3.0));
    assert!((slope - 2.0).abs() < 0.05, "{slope}");
}

#[test]
fn velocity_verlet_refuses_equations_of_other_orders() {
    for (text, message) in [
        (
            "independent t\ny' = -y\ny(0) = 1\n",
            "velocity-verlet is for equations of second order; that for y is of order 1",
        ),
        (
            "independent t\ny'' = -y\ny(0) = 1\ny'(0) = 0\nz''' = -z\nz(0) = 1\nz'(0) = 0\nz''(0) = 0\n",
            "velocity-verlet is for equations of second order; that for z is of order 3",
        ),
    ] {
        let model = model(text);
        let error = Run::start(&model, setup(&model, Method::VelocityVerlet, 0.1)).expect_err("refused");
        assert_eq!((error.code(), &*error.message(&model).english()), ("not-second-order", message));
        assert_eq!(error.hint().english(), "use the method Runge-Kutta (rk4)");
        assert!(matches!(error.subject(), Some(Subject::State(_))));
    }
}

#[test]
fn adaptive_methods_follow_their_tolerance() {
    let model = model(DAMPED);
    for method in [Method::DormandPrince, Method::Rosenbrock] {
        let mut before = f64::INFINITY;
        for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
            let setup = Setup { tolerance, ..setup(&model, method, 2.0) };
            let run = crate::support::run(&model, setup, 5);
            let history = run.history();
            let worst = (0..history.len())
                .map(|row| (history.column(0)[row] - damped(history.time(row))).abs())
                .fold(0.0, f64::max);
            assert!(worst < 30.0 * tolerance, "{method} {tolerance:e}: {worst:e}");
            assert!(worst < before / 10.0, "{method} {tolerance:e}: {worst:e}");
            before = worst;
        }
    }
}

#[test]
fn energy_behaves_as_each_method_is_known_for() {
    let mut model = model(U_TUBE);
    let b = crate::support::parameter(&model, "b");
    model.parameters[b].value = 0.0;
    // The energy at the end of 100 s, relative to that at the start, and its greatest excursion on the way.
    let energies = |method| {
        let run = crate::support::run(&model, setup(&model, method, 0.05), 2000);
        let mut energy =
            engine::Readings::new(&model, &[model.quantities.iter().find(|q| q.name == "E").unwrap().value.node]);
        let start = energy.at_row(run.history(), 0)[0];
        let relative: Vec<f64> =
            (0..run.history().len()).map(|row| energy.at_row(run.history(), row)[0] / start - 1.0).collect();
        let worst = relative.iter().fold(0.0_f64, |worst, value| worst.max(value.abs()));
        (relative[2000], worst)
    };
    // Euler's energy grows by (1 + omega^2 h^2) in each step.
    let (end, _) = energies(Method::Euler);
    let growth = libm::pow(1.0 + 2.0 * 9.8 / 7.0 * 0.05 * 0.05, 2000.0) - 1.0;
    assert!((end / growth - 1.0).abs() < 1e-9, "{end} {growth}");
    // Velocity Verlet's stays within a bound of order (omega h)^2/4.
    let (_, worst) = energies(Method::VelocityVerlet);
    assert!(worst < 2.8 * 0.05 * 0.05 / 4.0 * 1.01 && worst > 1e-4, "{worst}");
    // RK4's falls by (omega h)^6/72 in each step.
    let (end, _) = energies(Method::RungeKutta4);
    let loss = 2000.0 * 2.8_f64 * 2.8 * 2.8 * 0.05 * 0.05 * 0.05 * 0.05 * 0.05 * 0.05 / 72.0;
    assert!((end / -loss - 1.0).abs() < 0.01, "{end} {loss}");
}
