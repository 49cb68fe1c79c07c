//! Populations and heat: systems of first order.

use super::bodies::named;
use super::{Case, Motion};
use std::f64::consts::PI;

const DAY: f64 = 86400.0;

pub const CASES: [Case; 3] = [
    Case {
        document: "predator-prey",
        settings: &[],
        until: 120.0 * DAY,
        error: 1e-6,
        tolerance: None,
        states: |_| named(&["N", "P"]),
        motion: |values| {
            let [a, b, e, c, h] = ["a", "b", "e", "c", "h"].map(|name| values.of(name));
            Motion::new([values.of("N_0"), values.of("P_0")], move |_, y, rate| {
                rate[0] = (a - h - b * y[1]) * y[0];
                rate[1] = (e * b * y[0] - c - h) * y[1];
            })
        },
    },
    Case {
        document: "epidemic",
        settings: &[("p", 0.1)],
        until: 150.0 * DAY,
        error: 1e-6,
        tolerance: None,
        states: |_| named(&["S", "I", "R"]),
        motion: |values| {
            let (recovery, vaccinated) = (1.0 / values.of("T_i"), values.of("p"));
            let transmission = values.of("R_0") * recovery;
            let infected = values.of("I_0") * (1.0 - vaccinated);
            Motion::new([1.0 - vaccinated - infected, infected, vaccinated], move |_, y, rate| {
                let infections = transmission * y[0] * y[1];
                rate.copy_from_slice(&[-infections, infections - recovery * y[1], recovery * y[1]]);
            })
        },
    },
    Case {
        document: "cooling",
        settings: &[("radiation", 1.0)],
        until: 90.0 * 60.0,
        error: 1e-7,
        tolerance: None,
        states: |_| named(&["T"]),
        motion: |values| {
            let (outside, transfer, mass) = (values.of("T_a"), values.of("alpha"), values.of("m"));
            let (diameter, fourth) = (0.07, |t: f64| t * t * t * t);
            let top = PI * diameter * diameter / 4.0;
            let area = top + PI * diameter * mass / (1000.0 * top);
            Motion::new([values.of("T_0")], move |_, y, rate| {
                let radiated = 0.95 * 5.670374e-8 * (fourth(y[0] + 273.15) - fourth(outside + 273.15));
                rate[0] = -area * (transfer * (y[0] - outside) + radiated) / (mass * 4186.0);
            })
        },
    },
];
