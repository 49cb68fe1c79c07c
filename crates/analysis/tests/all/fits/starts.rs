//! Starts that are taken from the data: an oscillation is found whatever numbers the document begins with.

use crate::support::Noise;
use crate::support::fitting::{DAMPED_COSINE, fitted, model, observation, parameter, record, task, value};

/// Text of a formula, its varied parameters, and those that are compared with their true values, SI.
type Formula = (&'static str, &'static [&'static str], [(&'static str, f64); 2]);

/// The same oscillation by its rates, and by its period and time constant.
const FORMULAS: [Formula; 2] = [
    (DAMPED_COSINE, &["A", "gamma", "omega", "phi", "c"], [("omega", 9.6), ("gamma", 0.4)]),
    (
        "parameter A = 0.05 [m]\nparameter tau = 2.5 [s]\nparameter T = 0.6545 [s]\nparameter phi = 0.5\n\
         y = A*exp(-t/tau)*cos(2*pi*t/T + phi)",
        &["A", "tau", "T", "phi"],
        [("T", 2.0 * std::f64::consts::PI / 9.6), ("tau", 2.5)],
    ),
];

#[test]
fn an_oscillation_is_found_from_any_frequency_damping_and_phase() {
    let times: Vec<f64> = (0..300).map(|row| f64::from(row) / 30.0).collect();
    for (text, names, truth) in FORMULAS {
        let model = model(text);
        let mut noise = Noise::new(26);
        let swing = |time: &f64| 0.05 * libm::exp(-0.4 * time) * libm::cos(9.6 * time + 0.5);
        let values: Vec<f64> = times.iter().map(|time| swing(time) + 5e-4 * noise.normal()).collect();
        for [first, second, phase] in
            [[0.05, 1.0, 0.0], [0.3, 20.0, 2.0], [3.0, 0.1, -2.0], [20.0, 1.0, 4.0], [1.0, 1.0, 3.5]]
        {
            let mut task = task(&model, record(vec![observation(&model, "y", 0, &times, &values)]), names);
            for ((name, value), factor) in truth.into_iter().zip([first, second]) {
                task.parameters[parameter(&model, name)] = value * factor;
            }
            task.parameters[parameter(&model, "phi")] += phase;
            let outcome = fitted(&model, task);
            for (name, expected) in truth {
                let found = value(&outcome, name);
                assert!((found / expected - 1.0).abs() < 0.02, "{name} from {first} {second} {phase}: {found}");
            }
        }
    }
}
