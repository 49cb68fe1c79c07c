//! Liquids and gases in tubes, and circuits.

use super::bodies::named;
use super::{Case, Motion};
use libm::{cos, pow, sqrt};
use std::f64::consts::PI;

const G: f64 = 9.81;

pub const CASES: [Case; 6] = [
    Case {
        document: "utube",
        settings: &[],
        until: 100.0,
        error: 1e-5,
        tolerance: None,
        states: |_| named(&["y", "y'"]),
        motion: |values| {
            let (left, right) = (values.of("h_l"), values.of("h_r"));
            let mass = values.of("rho") * values.of("S") * (2.0 + left + right);
            let (b, stiffness) = (values.of("b"), 2.0 * values.of("rho") * values.of("S") * values.of("g"));
            Motion::new([(left - right) / 2.0, values.of("v_0")], move |_, y, rate| {
                rate[0] = y[1];
                rate[1] = -(b * y[1] + stiffness * y[0]) / mass;
            })
        },
    },
    // Until the lower level reaches the bottom of its arm.
    Case {
        document: "utube-arms",
        settings: &[("b", 0.3)],
        until: 30.0,
        error: 5e-7,
        tolerance: None,
        states: |_| named(&["y", "y'"]),
        motion: |values| {
            let area = |d: f64| PI * d * d / 4.0;
            let (left, right, bend) = (area(values.of("d_l")), area(values.of("d_r")), area(0.02));
            let (h, b, rho, ratio) = (values.of("h"), values.of("b"), values.of("rho"), left / right);
            Motion::new([values.of("y_0"), 0.0], move |_, y, rate| {
                // Each part of the liquid has the velocity of the left level, times the ratio of the cross-sections.
                let in_arms = left * (h + y[0]) + right * ratio * ratio * (h - ratio * y[0]);
                let in_bend = bend * 0.3 * (left / bend) * (left / bend);
                let force = -rho * left * (1.0 - ratio * ratio) * y[1] * y[1] / 2.0
                    - b * y[1]
                    - rho * left * (1.0 + ratio) * G * y[0];
                rate[0] = y[1];
                rate[1] = force / (rho * (in_arms + in_bend));
            })
        },
    },
    Case {
        document: "rlc",
        settings: &[("U_s", 5.0)],
        until: 30.0,
        error: 1e-6,
        tolerance: None,
        states: |_| named(&["q", "q'", "x", "x'"]),
        motion: |values| {
            let (r, l, c) = (values.of("R"), values.of("L"), values.of("C"));
            let (source, omega) = (values.of("U_s"), values.of("omega"));
            // A charge of 1 C corresponds to 100 m.
            let start = [values.of("q_0"), 0.0, 100.0 * values.of("q_0"), 0.0];
            Motion::new(start, move |t, y, rate| {
                let voltage = source * cos(omega * t);
                rate[0] = y[1];
                rate[1] = (voltage - r * y[1] - y[0] / c) / l;
                rate[2] = y[3];
                rate[3] = (100.0 * voltage - r * y[3] - y[2] / c) / l;
            })
        },
    },
    Case {
        document: "ruchardt",
        settings: &[],
        until: 20.0,
        error: 1e-7,
        tolerance: None,
        states: |_| named(&["x", "x'", "p"]),
        motion: |values| {
            let (m, b, gamma) = (values.of("m"), values.of("b"), values.of("gamma"));
            let (volume, outside) = (values.of("V"), values.of("p_0"));
            let area = PI * values.of("d") * values.of("d") / 4.0;
            // An adiabatic change: the pressure follows from the volume.
            let pressure = move |x: f64| (outside + m * G / area) * pow(volume / (volume + area * x), gamma);
            let start = values.of("x_0");
            Motion::new([start, 0.0, pressure(start)], move |_, y, rate| {
                rate[0] = y[1];
                rate[1] = ((pressure(y[0]) - outside) * area - b * y[1]) / m - G;
                rate[2] = -gamma * pressure(y[0]) * area * y[1] / (volume + area * y[0]);
            })
        },
    },
    // Until the upper tank is empty.
    Case {
        document: "two-tanks",
        settings: &[],
        until: 150.0,
        error: 1e-6,
        tolerance: None,
        states: |_| named(&["v_1", "v_2", "B"]),
        motion: |values| {
            let square = |name: &str| values.of(name) * values.of(name);
            let (hole_1, hole_2) = (values.of("mu") * square("d_1"), values.of("mu") * square("d_2"));
            let (tank_1, tank_2) = (square("D_1"), square("D_2"));
            let start = [sqrt(2.0 * G * values.of("l_1")), sqrt(2.0 * G * values.of("l_2")), 0.0];
            // Bernoulli: v^2 = 2 g h, and each level falls by the outflow.
            Motion::new(start, move |_, y, rate| {
                rate[0] = -G * hole_1 / tank_1;
                rate[1] = G / y[1] * (hole_1 * y[0] - hole_2 * y[1]) / tank_2;
                rate[2] = PI / 4.0 * hole_2 * y[1];
            })
        },
    },
    // A relaxation oscillation: two slow branches and the jumps between them.
    Case {
        document: "van-der-pol",
        settings: &[],
        until: 20.0,
        error: 1e-5,
        tolerance: Some(1e-10),
        states: |_| named(&["x", "x'"]),
        motion: |values| {
            let mu = values.of("mu");
            Motion::new([values.of("x_0"), 0.0], move |_, y, rate| {
                rate[0] = y[1];
                rate[1] = mu * (1.0 - y[0] * y[0]) * y[1] - y[0];
            })
        },
    },
];
