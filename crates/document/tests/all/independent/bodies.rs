//! Bodies in force fields, on rods, thrown, and bound by gravitation.

use super::{Case, Motion, Values};
use libm::{cos, hypot, sin, sqrt};
use std::f64::consts::PI;

pub const CASES: [Case; 9] = [
    Case {
        document: "pendulum",
        settings: &[("gamma", 0.05)],
        until: 60.0,
        error: 1e-6,
        tolerance: None,
        states: |_| named(&["theta", "theta'"]),
        motion: |values| {
            let (length, g, gamma) = (values.of("l"), values.of("g"), values.of("gamma"));
            Motion::new([values.of("theta_0"), 0.0], move |_, y, rate| {
                rate[0] = y[1];
                rate[1] = -g / length * sin(y[0]) - 2.0 * gamma * y[1];
            })
        },
    },
    // Chaotic: errors grow tenfold in little more than a second.
    Case {
        document: "double-pendulum",
        settings: &[],
        until: 5.0,
        error: 1e-6,
        tolerance: None,
        states: |_| named(&["theta_1", "theta_1'", "theta_2", "theta_2'"]),
        motion: double_pendulum,
    },
    Case {
        document: "kepler",
        settings: &[],
        until: 10.0,
        error: 1e-6,
        tolerance: None,
        states: |_| named(&["x", "x'", "y", "y'", "theta", "A"]),
        motion: |values| {
            let (start, gm) = (values.of("r_0"), 4.0 * PI * PI * values.of("M"));
            let speed = values.of("f") * sqrt(gm / start);
            Motion::new([start, 0.0, 0.0, speed, 0.0, 0.0], move |_, y, rate| {
                let distance = hypot(y[0], y[2]);
                let attraction = gm / (distance * distance * distance);
                let swept = y[0] * y[3] - y[2] * y[1];
                rate.copy_from_slice(&[
                    y[1],
                    -attraction * y[0],
                    y[3],
                    -attraction * y[2],
                    swept / (distance * distance),
                    swept / 2.0,
                ]);
            })
        },
    },
    Case {
        document: "three-bodies",
        settings: &[],
        until: 40.0,
        error: 1e-6,
        tolerance: None,
        states: |_| {
            let of_body = |body| ["x", "x'", "y", "y'"].map(|component| format!("r[{body}].{component}"));
            (1..=3).flat_map(of_body).collect()
        },
        motion: figure_eight,
    },
    Case {
        document: "charge",
        settings: &[("alpha", 0.5)],
        until: 50e-9,
        error: 1e-7,
        tolerance: None,
        states: |_| named(&["r.x", "r.x'", "r.y", "r.y'", "r.z", "r.z'"]),
        motion: |values| {
            let (electric, magnetic) = (values.of("E_0"), values.of("B_0"));
            let (speed, angle) = (values.of("v_0"), values.of("alpha"));
            // An electron: charge-to-mass ratio.
            let ratio = -1.602176634e-19 / 9.1093837e-31;
            let start = [-0.34, speed * cos(angle), 0.0, 0.0, 0.0, speed * sin(angle)];
            Motion::new(start, move |_, y, rate| {
                rate.copy_from_slice(&[
                    y[1],
                    ratio * magnetic * y[3],
                    y[3],
                    ratio * (electric - magnetic * y[1]),
                    y[5],
                    0.0,
                ]);
            })
        },
    },
    Case {
        document: "projectile",
        settings: &[],
        until: 3.0,
        error: 2e-7,
        tolerance: None,
        states: |_| named(&["x", "x'", "y", "y'"]),
        motion: |values| {
            let (speed, angle, m, g) = (values.of("v_0"), values.of("alpha"), values.of("m"), values.of("g"));
            let diameter = values.of("d");
            let drag = values.of("c_d") * values.of("rho") * PI * diameter * diameter / 8.0;
            let start = [0.0, speed * cos(angle), values.of("h"), speed * sin(angle)];
            Motion::new(start, move |_, y, rate| {
                let damping = drag * hypot(y[1], y[3]) / m;
                rate.copy_from_slice(&[y[1], -damping * y[1], y[3], -g - damping * y[3]]);
            })
        },
    },
    // Until the first bounce.
    Case {
        document: "bouncing-ball",
        settings: &[("c", 0.02), ("h", 10.0)],
        until: 1.4,
        error: 1e-6,
        tolerance: Some(1e-9),
        states: |_| named(&["y", "y'"]),
        motion: |values| {
            let (g, drag) = (values.of("g"), values.of("c") / values.of("m"));
            Motion::new([values.of("h"), values.of("v_0")], move |_, y, rate| {
                rate[0] = y[1];
                rate[1] = -g - drag * y[1] * y[1].abs();
            })
        },
    },
    Case {
        document: "coupled-oscillators",
        settings: &[],
        until: 40.0,
        error: 1e-6,
        tolerance: None,
        states: |_| named(&["x_1", "x_1'", "x_2", "x_2'"]),
        motion: |values| {
            let (m, k, kappa) = (values.of("m"), values.of("k"), values.of("kappa"));
            Motion::new([values.of("x_10"), 0.0, values.of("x_20"), 0.0], move |_, y, rate| {
                let coupling = kappa * (y[2] - y[0]);
                rate.copy_from_slice(&[y[1], (coupling - k * y[0]) / m, y[3], (-coupling - k * y[2]) / m]);
            })
        },
    },
    Case {
        document: "driven-oscillator",
        settings: &[],
        until: 60.0,
        error: 1e-7,
        tolerance: None,
        states: |_| named(&["y", "y'", "theta"]),
        motion: |values| {
            let (m, k, b) = (values.of("m"), values.of("k"), values.of("b"));
            let (omega, support) = (values.of("omega"), values.of("a"));
            Motion::new([values.of("y_0"), 0.0, 0.0], move |t, y, rate| {
                let force = k * (support * cos(omega * t) - y[0]) - b * y[1];
                rate.copy_from_slice(&[y[1], force / m, omega]);
            })
        },
    },
];

pub fn named(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

/// Angular accelerations, derived by hand (Cramer's rule).
fn double_pendulum(values: &Values) -> Motion {
    let [m_1, m_2, l_1, l_2, g] = ["m_1", "m_2", "l_1", "l_2", "g"].map(|name| values.of(name));
    Motion::new([values.of("a_1"), 0.0, values.of("a_2"), 0.0], move |_, y, rate| {
        let (difference, m) = (y[0] - y[2], m_1 + m_2);
        let (c, s) = (cos(difference), sin(difference));
        let upper = -m_2 * l_2 * y[3] * y[3] * s - m * g * sin(y[0]);
        let lower = l_1 * y[1] * y[1] * s - g * sin(y[2]);
        let determinant = m - m_2 * c * c;
        rate.copy_from_slice(&[
            y[1],
            (upper - m_2 * c * lower) / (l_1 * determinant),
            y[3],
            (m * lower - c * upper) / (l_2 * determinant),
        ]);
    })
}

/// Three bodies of mass 1 with G = 1 on one curve (Chenciner & Montgomery 2000), at any scale.
fn figure_eight(values: &Values) -> Motion {
    let (size, shift) = (values.of("s"), values.of("epsilon"));
    let (place, speed) = ([0.97000436, -0.24308753], [-0.93240737, -0.86473146].map(|v: f64| v / sqrt(size)));
    let start = [
        size * place[0],
        -speed[0] / 2.0,
        size * place[1],
        -speed[1] / 2.0,
        -size * place[0],
        -speed[0] / 2.0,
        -size * place[1],
        -speed[1] / 2.0,
        size * shift,
        speed[0],
        0.0,
        speed[1],
    ];
    Motion::new(start, |_, y, rate| {
        rate.fill(0.0);
        for body in (0..12).step_by(4) {
            (rate[body], rate[body + 2]) = (y[body + 1], y[body + 3]);
            for other in (0..12).step_by(4).filter(|&other| other != body) {
                let (x, z) = (y[other] - y[body], y[other + 2] - y[body + 2]);
                let square = x * x + z * z;
                let attraction = 1.0 / (square * sqrt(square));
                rate[body + 1] += attraction * x;
                rate[body + 3] += attraction * z;
            }
        }
    })
}
