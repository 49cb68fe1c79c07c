//! The U-tube compared with its closed form and with a plain Runge-Kutta loop, through the output of the program.

use crate::common::{meniscus, numbers};
use libm::{cos, cosh, exp, sin, sinh, sqrt};

const STEP: f64 = 0.05;

/// The parameters of a run, SI.
#[derive(Clone, Copy)]
struct Tube {
    b: f64,
    h_l: f64,
    h_r: f64,
    rho: f64,
    s: f64,
}

const DEFAULT: Tube = Tube { b: 50.0, h_l: 3.0, h_r: 2.0, rho: 1000.0, s: 0.05 };

impl Tube {
    fn length(self) -> f64 {
        2.0 + self.h_l + self.h_r
    }

    fn mass(self) -> f64 {
        self.rho * self.s * self.length()
    }

    fn omega_0(self) -> f64 {
        sqrt(2.0 * 9.8 / self.length())
    }

    fn start(self) -> f64 {
        (self.h_l - self.h_r) / 2.0
    }

    /// Solution of m y'' + b y' + 2 rho S g y = 0 that starts at rest.
    fn closed_form(self, t: f64) -> f64 {
        let (y, gamma) = (self.start(), self.b / (2.0 * self.mass()));
        let square = self.omega_0() * self.omega_0() - gamma * gamma;
        // At critical damping rounding leaves about 1e-16, where both formulas are ill-conditioned and the limit is
        // used.
        if square.abs() < 1e-12 {
            return exp(-gamma * t) * y * (1.0 + gamma * t);
        }
        let omega = sqrt(square.abs());
        let (c, s) = if square > 0.0 { (cos(omega * t), sin(omega * t)) } else { (cosh(omega * t), sinh(omega * t)) };
        exp(-gamma * t) * y * (c + gamma / omega * s)
    }

    /// y at t = n h by the classical method, written out for y'' = -2 g y/L - b y'/m.
    fn plain_rk4(self, steps: usize) -> Vec<f64> {
        let (length, mass) = (self.length(), self.mass());
        let rate = |y: f64, v: f64| (v, -2.0 * 9.8 * y / length - self.b * v / mass);
        let (mut y, mut v) = (self.start(), 0.0);
        let mut all = vec![y];
        for _ in 0..steps {
            let (k1, l1) = rate(y, v);
            let (k2, l2) = rate(y + STEP / 2.0 * k1, v + STEP / 2.0 * l1);
            let (k3, l3) = rate(y + STEP / 2.0 * k2, v + STEP / 2.0 * l2);
            let (k4, l4) = rate(y + STEP * k3, v + STEP * l3);
            y += STEP / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
            v += STEP / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
            all.push(y);
        }
        all
    }

    /// Runs the document over 100 s and compares every row.
    fn agrees(self, settings: &[&str], tolerance: f64) {
        let mut words = vec!["run", "simulations/utube.md", "--method", "rk4", "--columns", "t,y"];
        words.extend(settings.iter().flat_map(|setting| ["--set", setting]));
        let done = meniscus(&words);
        assert_eq!(done.code, 0, "{}", done.stderr);
        assert!(done.stdout.starts_with("t [s],y [m]\n"), "{}", &done.stdout[..40]);
        let rows = numbers(&done.stdout);
        assert_eq!(rows.len(), 2001, "0 to 100 s in steps of 0.05 s");
        let plain = self.plain_rk4(2000);
        let (mut closed_error, mut plain_error) = (0.0_f64, 0.0_f64);
        for (n, row) in rows.iter().enumerate() {
            assert_eq!(row[0], n as f64 * STEP);
            closed_error = closed_error.max((row[1] - self.closed_form(row[0])).abs());
            plain_error = plain_error.max((row[1] - plain[n]).abs());
        }
        println!("{settings:?}: {closed_error:e} m from the closed form, {plain_error:e} m from plain RK4");
        assert!(closed_error <= tolerance, "{closed_error:e} m from the closed form");
        assert!(plain_error <= 1e-11 * self.start().abs(), "{plain_error:e} m from plain RK4");
    }
}

#[test]
fn with_the_defaults() {
    DEFAULT.agrees(&[], 4e-6);
}

#[test]
fn heavy_liquid_in_a_wide_tube() {
    let tube = Tube { h_l: 2.0, h_r: 6.0, b: 200.0, rho: 13600.0, s: 0.5 };
    tube.agrees(&["h_l=2", "h_r=6", "b=200", "rho=13600", "S=0.5"], 6e-5);
}

#[test]
fn overdamped() {
    Tube { b: 1500.0, ..DEFAULT }.agrees(&["b=1500"], 4e-6);
}

#[test]
fn critically_damped() {
    let b = 2.0 * DEFAULT.mass() * DEFAULT.omega_0();
    Tube { b, ..DEFAULT }.agrees(&["b=2*m*omega_0"], 4e-6);
}
