//! Many identical parts, and chaos.

use super::bodies::named;
use super::{Case, Motion, Values};
use libm::{cos, sin};
use std::f64::consts::PI;

pub const CASES: [Case; 4] = [
    // A mode without nodes at the masses, so that no state is zero throughout.
    Case {
        document: "chain",
        settings: &[("n", 5.0)],
        until: 30.0,
        error: 1e-6,
        tolerance: None,
        states: |values| members(values, "x"),
        motion: |values| line(values, values.of("k") / values.of("m"), values.of("n")),
    },
    Case {
        document: "string",
        settings: &[],
        until: 12e-3,
        error: 1e-5,
        tolerance: None,
        states: |values| members(values, "y"),
        motion: |values| {
            let distance = values.of("L") / (values.of("N") + 1.0);
            line(values, values.of("F") / (values.of("mu") * distance * distance), values.of("n"))
        },
    },
    // Chaotic: errors grow tenfold in two and a half units of time.
    Case {
        document: "lorenz",
        settings: &[],
        until: 8.0,
        error: 1e-6,
        tolerance: None,
        states: |_| named(&["x", "y", "z", "u", "v", "w", "phi"]),
        motion: |values| {
            let (rho, sigma, beta) = (values.of("rho"), values.of("sigma"), values.of("beta"));
            let start = ["x_0", "y_0", "z_0"].map(|name| values.of(name));
            let second = [start[0] + values.of("d_0"), start[1], start[2]];
            Motion::new([&start[..], &second, &[0.0]].concat(), move |_, y, rate| {
                for run in [0, 3] {
                    let (x, other, z) = (y[run], y[run + 1], y[run + 2]);
                    rate[run] = sigma * (other - x);
                    rate[run + 1] = x * (rho - z) - other;
                    rate[run + 2] = x * other - beta * z;
                }
                rate[6] = y[0];
            })
        },
    },
    Case {
        document: "driven-pendulum",
        settings: &[],
        until: 40.0,
        error: 1e-6,
        tolerance: None,
        states: |_| named(&["theta", "theta'", "delta", "delta'"]),
        motion: |values| {
            let (drive, quality, omega) = (values.of("F"), values.of("q"), values.of("Omega"));
            let acceleration = move |t, angle, velocity| drive * cos(omega * t) - sin(angle) - velocity / quality;
            let start = [values.of("theta_0"), 0.0, libm::pow(10.0, -values.of("k")), 0.0];
            Motion::new(start, move |t, y, rate| {
                let first = acceleration(t, y[0], y[1]);
                let second = acceleration(t, y[0] + y[2], y[1] + y[3]);
                rate.copy_from_slice(&[y[1], first, y[3], second - first]);
            })
        },
    },
];

/// Positions and velocities of a family of size N.
fn members(values: &Values, name: &str) -> Vec<String> {
    (1..=values.of("N") as usize).flat_map(|i| [format!("{name}[{i}]"), format!("{name}[{i}]'")]).collect()
}

/// Points between fixed ends, started in a normal mode. `stiffness`: stiffness between neighbours per mass.
fn line(values: &Values, stiffness: f64, mode: f64) -> Motion {
    let count = values.of("N") as usize;
    let start = (1..=count).flat_map(|i| {
        let place = i as f64 / (count as f64 + 1.0);
        [values.of("A") * sin(mode * PI * place), 0.0]
    });
    Motion::new(start.collect::<Vec<_>>(), move |_, y, rate| {
        for i in 0..count {
            let at = |i: usize| y.get(2 * i).copied().unwrap_or_default();
            let left = if i == 0 { 0.0 } else { at(i - 1) };
            rate[2 * i] = y[2 * i + 1];
            rate[2 * i + 1] = stiffness * ((left - at(i)) + (at(i + 1) - at(i)));
        }
    })
}
