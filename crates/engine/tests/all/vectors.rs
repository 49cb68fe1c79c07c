//! Runs of models with vectors, against closed forms and conserved quantities.

use crate::support::{model, run, setup, value};
use engine::Method;

/// In crossed fields a charge circles with qB/m, while the circle drifts with E/B at right angles to both.
#[test]
fn a_charge_in_crossed_fields_circles_and_drifts() {
    let model = model(
        "parameter q = 2 [C]\nparameter m = 0.5 [kg]\nparameter B_0 = 0.75 [T]\nparameter E_0 = 0.3 [V/m]\n\
         parameter v_0 = 1.1 [m/s]\nE = (0, E_0, 0)\nB = (0, 0, B_0)\nm*r'' = q*(E + cross(r', B))\n\
         r(0) = (0, 0, 0) [m]\nr'(0) = (v_0, 0, 0.2 [m/s])\n",
    );
    let end = run(&model, setup(&model, Method::RungeKutta4, 1e-3), 10_000);
    let (omega, drift, t) = (2.0 * 0.75 / 0.5, 0.3 / 0.75, end.time());
    let radius = (1.1 - drift) / omega;
    let expected = [drift * t + radius * libm::sin(omega * t), radius * (libm::cos(omega * t) - 1.0), 0.2 * t];
    for (name, expected) in ["r.x", "r.y", "r.z"].into_iter().zip(expected) {
        let found = value(&model, &end, name);
        assert!((found - expected).abs() < 1e-9, "{name} is {found}, not {expected}");
    }
}

/// A central force has no torque.
#[test]
fn a_central_force_keeps_the_angular_momentum() {
    let model = model(
        "independent t\nr'' = -r/norm(r)^3\nr(0) = (1, 0.2, -0.1)\nr'(0) = (0.1, 0.9, 0.3)\nL = cross(r, r')\n\
         E = norm(r')^2/2 - 1/norm(r)\nturn = dot(L, r)\n",
    );
    let mut run = run(&model, setup(&model, Method::RungeKutta4, 1e-3), 0);
    let names = ["L.x", "L.y", "L.z", "E", "turn"];
    let before = names.map(|name| value(&model, &run, name));
    while run.time() < 10.0 {
        run.advance().expect("it goes on");
    }
    for (name, before) in names.into_iter().zip(before) {
        let found = value(&model, &run, name);
        assert!((found - before).abs() < 1e-9, "{name} was {before} and is {found}");
    }
}

/// A ball in a corner: components are set one by one, or all at once.
#[test]
fn events_set_components_and_vectors() {
    let model = model(
        "r'' = 0\nr(0) = (1, 3) [m]\nr'(0) = (-2, -1) [m/s]\nwhen r.x < 0 [m] { r.x' = -0.5*r'.x }\n\
         when r.y < 0 [m] as floor_1 { r' = -r', n = n + (0, 1) }\ndiscrete n = (0, 0)\nplace = floor_1.r\n",
    );
    let end = run(&model, setup(&model, Method::RungeKutta4, 0.125), 32);
    // At 0.5 s the wall, at 3 s the floor, with x at 2.5 m; back from there for 1 s.
    for (name, expected) in [("r.x", 1.5), ("r.y", 1.0), ("n.x", 0.0), ("n.y", 1.0), ("place.x", 2.5)] {
        let found = value(&model, &end, name);
        assert!((found - expected).abs() < 1e-9, "{name} is {found}, not {expected}");
    }
}
