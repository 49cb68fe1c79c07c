//! Runs against closed forms, against plain loops, and against orbits and stiff problems of the literature.

use crate::support::{U_TUBE, model, parameter, setup};
use engine::{Method, Setup};

/// Parameters of the U-tube.
struct Case {
    h_l: f64,
    h_r: f64,
    b: f64,
    rho: f64,
    area: f64,
    /// Error of RK4 at 0.05 s over 100 s, in m.
    allowed: f64,
}

const DEFAULT: Case = Case { h_l: 3.0, h_r: 2.0, b: 50.0, rho: 1000.0, area: 0.05, allowed: 4e-6 };

impl Case {
    fn length(&self) -> f64 {
        2.0 + self.h_l + self.h_r
    }

    fn exact(&self, t: f64) -> f64 {
        let start = (self.h_l - self.h_r) / 2.0;
        let gamma = self.b / (2.0 * self.rho * self.area * self.length());
        let square = 2.0 * 9.8 / self.length() - gamma * gamma;
        let decay = libm::exp(-gamma * t);
        if square.abs() < 1e-9 {
            start * decay * (1.0 + gamma * t)
        } else if square > 0.0 {
            let omega = square.sqrt();
            start * decay * (libm::cos(omega * t) + gamma / omega * libm::sin(omega * t))
        } else {
            let kappa = (-square).sqrt();
            let (slow, fast) = (libm::exp((kappa - gamma) * t), libm::exp((-kappa - gamma) * t));
            start * ((1.0 + gamma / kappa) * slow + (1.0 - gamma / kappa) * fast) / 2.0
        }
    }

    fn run(&self, method: Method, step: f64, rows: usize) -> engine::Run {
        let model = model(U_TUBE);
        let mut setup = setup(&model, method, step);
        for (name, value) in [("h_l", self.h_l), ("h_r", self.h_r), ("b", self.b), ("rho", self.rho), ("S", self.area)]
        {
            setup.parameters[parameter(&model, name)] = value;
        }
        crate::support::run(&model, setup, rows)
    }

    /// The classical method written down once more, as plainly as possible.
    fn plain(&self, step: f64, rows: usize) -> Vec<f64> {
        let (length, mass) = (self.length(), self.rho * self.area * self.length());
        let acceleration = |y: f64, v: f64| -2.0 * 9.8 * y / length - self.b * v / mass;
        let (mut y, mut v) = ((self.h_l - self.h_r) / 2.0, 0.0);
        let mut all = vec![y];
        for _ in 0..rows {
            let (k1, l1) = (v, acceleration(y, v));
            let (k2, l2) = (v + step / 2.0 * l1, acceleration(y + step / 2.0 * k1, v + step / 2.0 * l1));
            let (k3, l3) = (v + step / 2.0 * l2, acceleration(y + step / 2.0 * k2, v + step / 2.0 * l2));
            let (k4, l4) = (v + step * l3, acceleration(y + step * k3, v + step * l3));
            y += step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
            v += step / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
            all.push(y);
        }
        all
    }
}

fn cases() -> Vec<Case> {
    let critical = 2.0 * 1000.0 * 0.05 * 7.0 * (2.0 * 9.8 / 7.0_f64).sqrt();
    vec![
        DEFAULT,
        Case { h_l: 2.0, h_r: 6.0, b: 200.0, rho: 13600.0, area: 0.5, allowed: 6e-5 },
        Case { b: 1500.0, allowed: 4e-6, ..DEFAULT },
        Case { b: critical, allowed: 4e-6, ..DEFAULT },
    ]
}

#[test]
fn the_u_tube_agrees_with_its_closed_form_and_with_a_plain_loop() {
    for case in cases() {
        let run = case.run(Method::RungeKutta4, 0.05, 2000);
        let plain = case.plain(0.05, 2000);
        let history = run.history();
        let amplitude = (case.h_l - case.h_r).abs() / 2.0;
        for (row, plain) in plain.iter().enumerate() {
            let y = history.column(0)[row];
            assert!((y - case.exact(history.time(row))).abs() < case.allowed, "b = {}, row {row}", case.b);
            assert!((y - plain).abs() < 1e-11 * amplitude, "b = {}, row {row}", case.b);
        }
    }
}

#[test]
fn every_regime_with_the_adaptive_methods() {
    for case in cases() {
        for method in [Method::DormandPrince, Method::Rosenbrock] {
            let run = case.run(method, 0.5, 200);
            let history = run.history();
            for row in 0..=200 {
                let error = history.column(0)[row] - case.exact(history.time(row));
                assert!(error.abs() < 2e-4, "{method}, b = {}, row {row}: {error:e}", case.b);
            }
        }
    }
}

/// Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, section II.0: a closed orbit of a satellite around
/// earth and moon.
const ARENSTORF: &str = "
independent t
parameter mu = 0.012277471
D_1 = ((x + mu)^2 + y^2)^1.5
D_2 = ((x - 1 + mu)^2 + y^2)^1.5
x'' = x + 2*y' - (1 - mu)*(x + mu)/D_1 - mu*(x - 1 + mu)/D_2
y'' = y - 2*x' - (1 - mu)*y/D_1 - mu*y/D_2
x(0) = 0.994
x'(0) = 0
y(0) = 0
y'(0) = -2.00158510637908252240537862224
";

#[test]
fn the_arenstorf_orbit_closes() {
    let model = model(ARENSTORF);
    let period = 17.065_216_560_157_96;
    for (method, tolerance, allowed) in [(Method::DormandPrince, 1e-10, 1e-5), (Method::Rosenbrock, 1e-10, 1e-3)] {
        let setup = Setup { tolerance, ..setup(&model, method, period / 100.0) };
        let run = crate::support::run(&model, setup, 100);
        for (value, start) in run.state().iter().zip(run.initial()).take(2) {
            assert!((value - start).abs() < allowed, "{method}: {value} {start}");
        }
    }
}

#[test]
fn a_kepler_ellipse_has_the_right_period_and_shape() {
    // Eccentricity 0.6 and semi-major axis 1: period 2 pi, from perihelion at 0.4 to aphelion at -1.6.
    let model = model(
        "independent t\nr = sqrt(x^2 + y^2)\nx'' = -x/r^3\ny'' = -y/r^3\nx(0) = 0.4\nx'(0) = 0\ny(0) = 0\ny'(0) = 2\n",
    );
    let setup = Setup { tolerance: 1e-11, ..setup(&model, Method::DormandPrince, core::f64::consts::PI) };
    let run = crate::support::run(&model, setup, 10);
    let x = run.history().column(0);
    for (row, x) in x.iter().enumerate() {
        let exact = if row % 2 == 0 { 0.4 } else { -1.6 };
        assert!((x - exact).abs() < 1e-7, "row {row}: {x}");
    }
}

#[test]
fn van_der_pol_with_mu_1000_agrees_with_the_test_set() {
    // Mazzia & Magherini, Test Set for Initial Value Problem Solvers, release 2.4, problem VDPOLM at t = 2000.
    let model = model("independent t\nparameter mu = 1000\ny'' = mu*(1 - y^2)*y' - y\ny(0) = 2\ny'(0) = 0\n");
    let setup = Setup { tolerance: 1e-9, ..setup(&model, Method::Rosenbrock, 10.0) };
    let run = crate::support::run(&model, setup, 200);
    let [y, v] = run.state() else { panic!("two states") };
    assert!((y / 1.706_167_732_170_469 - 1.0).abs() < 1e-6, "{y}");
    assert!((v / -0.892_809_701_024_8e-3 - 1.0).abs() < 1e-5, "{v}");
}

#[test]
fn robertsons_reaction_agrees_with_the_test_set() {
    // Mazzia & Magherini, problem ROBER at t = 1e11.
    let model = model(
        "independent t\nx' = -0.04*x + 1e4*y*z\ny' = 0.04*x - 1e4*y*z - 3e7*y^2\nz' = 3e7*y^2\nx(0) = 1\ny(0) = 0\nz(0) = 0\n",
    );
    let setup = Setup { tolerance: 1e-8, ..setup(&model, Method::Rosenbrock, 1e9) };
    let run = crate::support::run(&model, setup, 100);
    for (value, exact) in
        run.state().iter().zip([0.208_334_014_970_125_5e-7, 0.833_336_077_033_471_3e-13, 0.999_999_979_166_505])
    {
        assert!((value / exact - 1.0).abs() < 1e-4, "{value:e} {exact:e}");
    }
}

#[test]
fn a_stiff_equation_driven_in_time_keeps_its_accuracy() {
    // Prothero & Robinson (Math. Comp. 28 (1974) 145): y = cos t whatever lambda is; needs the derivative by time.
    let model = model("independent t\ny' = -1e6*(y - cos(t)) - sin(t)\ny(0) = 1\n");
    let setup = Setup { tolerance: 1e-7, ..setup(&model, Method::Rosenbrock, 0.1) };
    let run = crate::support::run(&model, setup, 100);
    let error = run.state()[0] - libm::cos(run.time());
    assert!(error.abs() < 1e-7, "{error:e}");
}

#[test]
fn the_double_pendulum_keeps_its_energy() {
    let model = model(
        "independent t
D = p - q
2*p'' + q''*cos(D) + q'^2*sin(D) + 2*sin(p) = 0
q'' + p''*cos(D) - p'^2*sin(D) + sin(q) = 0
p(0) = 2
p'(0) = 0
q(0) = 1
q'(0) = 0
E = p'^2 + q'^2/2 + p'*q'*cos(D) - 2*cos(p) - cos(q)
",
    );
    let energy = model.quantities.iter().find(|quantity| quantity.name == "E").unwrap().value.node;
    let mut energy = engine::Readings::new(&model, &[energy]);
    for (method, step, allowed) in
        [(Method::RungeKutta4, 0.002, 1e-8), (Method::DormandPrince, 0.1, 1e-6), (Method::Rosenbrock, 0.1, 1e-6)]
    {
        let setup = Setup { tolerance: 1e-9, ..setup(&model, method, step) };
        let run = crate::support::run(&model, setup, (20.0 / step) as usize);
        let start = energy.at_row(run.history(), 0)[0];
        let end = energy.at_row(run.history(), run.history().len() - 1)[0];
        assert!((end - start).abs() < allowed, "{method}: {:e}", end - start);
    }
}
