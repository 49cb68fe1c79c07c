//! Measured liquid column, compared with the published fits. The reference data are not part of the project; without them
//! these tests print a message and do nothing.

use crate::support::fitting::{fitted, model, observation, record, task, value};
use crate::support::utube;
use std::f64::consts::TAU;

const POSITION: &str = "
parameter A = 1 [m]
parameter gamma = 1 [1/s]
parameter omega = 1 [1/s]
parameter phi = 1
parameter c = 1 [m]
y = A*exp(-gamma*t)*sin(omega*t + phi) + c
";

const VELOCITY: &str = "
parameter A = 1 [m]
parameter gamma = 1 [1/s]
parameter omega = 1 [1/s]
parameter phi = 1
v = A*exp(-gamma*t)*(omega*cos(omega*t + phi) - gamma*sin(omega*t + phi))
";

/// A, gamma, omega, phi, c of the position and A, gamma, omega, phi of the velocity.
const PUBLISHED: [(&str, [f64; 5], [f64; 4]); 4] = [
    (
        "U1",
        [2.71001900e-02, 5.63642290e-01, 1.05532234e+01, -7.45290879e+00, -3.61251530e-03],
        [0.02542187, 0.54238129, 10.58249813, -1.21534777],
    ),
    (
        "U2",
        [5.22424239e-02, 4.13983911e-01, 1.04672334e+01, -3.29994102e+00, -3.88076534e-03],
        [0.04676029, 0.38162428, 10.41932968, -3.18203383],
    ),
    (
        "U3",
        [5.64505433e-02, 3.86718345e-01, 9.60927046e+00, -1.62320938e+00, -2.69462262e-03],
        [0.05905883, 0.40396188, 9.61698414, -1.64480463],
    ),
    (
        "U4",
        [5.20914470e-02, 3.82700894e-01, 9.62157549e+00, -1.91330391e+00, -3.31260078e-03],
        [0.05074857, 0.37976784, 9.63011983, -1.93420348],
    ),
];

/// Equal up to the sign of the amplitude with half a turn of the phase.
fn same(found: &[f64], published: &[f64], tolerance: f64, what: &str) {
    let turned = found[0] * published[0] < 0.0;
    let phase = found[3] + if turned { TAU / 2.0 } else { 0.0 };
    let mut turn = (phase - published[3]) / TAU;
    turn -= turn.round();
    let near = |a: f64, b: f64| (a - b).abs() <= tolerance * b.abs();
    assert!(near(found[0].abs(), published[0].abs()), "{what}: A {found:?} {published:?}");
    assert!(near(found[1], published[1]), "{what}: gamma {found:?} {published:?}");
    assert!(near(found[2].abs(), published[2]), "{what}: omega {found:?} {published:?}");
    assert!((turn * TAU).abs() <= tolerance * published[3].abs(), "{what}: phi {found:?} {published:?}");
    if let (Some(&found), Some(&published)) = (found.get(4), published.get(4)) {
        assert!(near(found, published), "{what}: c {found} {published}");
    }
}

#[test]
#[ignore = "needs the measured records in ../shared/data/utube"]
fn the_closed_forms_reach_the_published_parameters_from_any_start() {
    let (position, velocity) = (model(POSITION), model(VELOCITY));
    for (name, of_position, of_velocity) in PUBLISHED {
        let columns = utube(name);
        for scale in [1.0, 0.01, 7.0, 60.0] {
            let mut task_y = task(
                &position,
                record(vec![observation(&position, "y", 0, &columns[0], &columns[1])]),
                &["A", "gamma", "omega", "phi", "c"],
            );
            let mut task_v = task(
                &velocity,
                record(vec![observation(&velocity, "v", 0, &columns[0], &columns[2])]),
                &["A", "gamma", "omega", "phi"],
            );
            for parameter in task_y.parameters.iter_mut().chain(&mut task_v.parameters) {
                *parameter *= scale;
            }
            let outcome = fitted(&position, task_y);
            let found = ["A", "gamma", "omega", "phi", "c"].map(|name| value(&outcome, name));
            same(&found, &of_position, 2e-6, &format!("{name}, position, start {scale}"));
            let outcome = fitted(&velocity, task_v);
            let found = ["A", "gamma", "omega", "phi"].map(|name| value(&outcome, name));
            same(&found, &of_velocity, 1e-5, &format!("{name}, velocity, start {scale}"));
        }
    }
}

#[test]
#[ignore = "needs the measured records in ../shared/data/utube"]
fn the_equation_of_motion_gives_the_same_curve_as_its_closed_form() {
    let motion = model(
        "
parameter k = 1 [s^-2]
parameter gamma = 1 [1/s]
parameter y_0 = 1 [m]
parameter v_0 = 1 [m/s]
parameter c = 0 [m]
x'' = -2*gamma*x' - k*x
x(0) = y_0
x'(0) = v_0
y = x + c
",
    );
    let closed = model(POSITION);
    for (name, published, _) in PUBLISHED {
        let columns = utube(name);
        let of_motion = fitted(
            &motion,
            task(
                &motion,
                record(vec![observation(&motion, "y", 0, &columns[0], &columns[1])]),
                &["k", "gamma", "y_0", "v_0", "c"],
            ),
        );
        let of_formula = fitted(
            &closed,
            task(
                &closed,
                record(vec![observation(&closed, "y", 0, &columns[0], &columns[1])]),
                &["A", "gamma", "omega", "phi", "c"],
            ),
        );
        let gamma = value(&of_motion, "gamma");
        assert!((gamma / published[1] - 1.0).abs() < 2e-6, "{name}: {gamma}");
        let difference = of_motion.observations[0]
            .fitted
            .iter()
            .zip(&of_formula.observations[0].fitted)
            .fold(0.0_f64, |greatest, (a, b)| greatest.max((a - b).abs()));
        // Equations of motion are integrated to 1e-9 in each step.
        assert!(difference < 2e-7 * published[0], "{name}: {difference}");
        assert!((of_motion.rmse / of_formula.rmse - 1.0).abs() < 1e-9);
    }
}
