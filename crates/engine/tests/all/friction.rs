//! Dry friction: sliding, sticking and giving way, against closed forms.

use crate::support::{model, parameter, run, setup, value};
use engine::{Method, Run, Setup};
use std::f64::consts::PI;

const EXACT: [Method; 3] = [Method::RungeKutta4, Method::DormandPrince, Method::Rosenbrock];

/// A run with small errors of the method.
fn exactly(text: &str, method: Method, until: f64) -> Run {
    let model = model(text);
    let step = if method.adaptive() { 0.05 } else { 0.002 };
    let setup = Setup { tolerance: 1e-11, ..setup(&model, method, step) };
    run(&model, setup, (until / step).round() as usize)
}

/// A mass on a spring loses 2 F/k of its amplitude in each half-swing, and rests where the spring cannot overcome the
/// friction any more.
#[test]
fn a_spring_comes_to_rest_where_the_half_swings_end() {
    for (friction, rest, half_swings) in
        [("coulomb(x', F)", 0.1, 4), ("coulomb(x', 2 [N], F)", -0.325, 3), ("coulomb(x', 0.5 [N], F)", 0.1, 4)]
    {
        let text = format!(
            "parameter m = 1 [kg]\nparameter k = 4 [N/m]\nparameter F = 0.45 [N]\nF_r = {friction}\n\
             m*x'' = -k*x - F_r\nx(0) = 1 [m]\nx'(0) = 0 [m/s]"
        );
        for method in EXACT {
            let run = exactly(&text, method, 10.0);
            let history = run.history();
            let (x, v) = (history.column(0), history.column(1));
            assert!((run.state()[0] - rest).abs() < 1e-9, "{friction}, {method}: {}", run.state()[0]);
            let stopped = f64::from(half_swings) * PI / 2.0;
            let after = history.row_at(stopped + 1e-6) + 1;
            assert!(v[after..].iter().all(|&v| v == 0.0), "{friction}, {method}: it rests exactly");
            assert!(x[after..].iter().all(|&at| at == run.state()[0]), "{friction}, {method}: it stays where it is");
            let before = history.row_at(stopped - 0.06);
            assert!(v[before] != 0.0, "{friction}, {method}: not before {stopped} s");
        }
    }
}

/// A block on a belt is carried along until the spring overcomes the static friction, and slips back.
#[test]
fn a_block_on_a_belt_sticks_and_slips() {
    let text = "parameter v_b = 0.5 [m/s]\nx'' = -4 [1/s^2]*x - coulomb(x' - v_b, 3 [m/s^2], 1 [m/s^2])\nx(0) = 0 [m]\n\
                x'(0) = 0.5 [m/s]";
    // It slips from x = 3/4 m on about 1/4 m, with the amplitude A and the phase at which x' = v_b; it sticks again at the
    // mirrored phase, at -1/4 m.
    let (swing, speed): (f64, f64) = (0.5, 0.25);
    let amplitude = (swing * swing + speed * speed).sqrt();
    let slip = (PI + 2.0 * libm::atan2(speed, swing)) / 2.0;
    let stick = (0.75 + 0.25) / 0.5;
    for method in EXACT {
        let run = exactly(text, method, 20.0);
        let history = run.history();
        let motion = history.column(2);
        let begins = |from: f64, to: f64| -> Vec<f64> {
            let rows = (1..history.len()).filter(|&row| motion[row - 1] == from && motion[row] == to);
            rows.map(|row| history.time(row)).collect()
        };
        let (slips, sticks) = (begins(0.0, -1.0), begins(-1.0, 0.0));
        assert!((slips[0] - 1.5).abs() < 1e-9, "{method}: {slips:?}");
        for (slips, sticks) in slips.windows(2).zip(&sticks) {
            assert!((sticks - slips[0] - slip).abs() < 1e-8, "{method}: slips for {}", sticks - slips[0]);
            assert!((slips[1] - sticks - stick).abs() < 1e-8, "{method}: sticks for {}", slips[1] - sticks);
        }
        assert!(slips.len() >= 4, "{method}");
        let greatest = history.column(0).iter().copied().fold(0.0, f64::max);
        assert!((greatest - 0.25 - amplitude).abs() < 1e-3, "{method}: {greatest}");
        let stuck = (0..history.len()).filter(|&row| motion[row] == 0.0);
        assert!(stuck.clone().count() > 100 && stuck.clone().all(|row| history.column(1)[row] == 0.5), "{method}");
    }
}

/// Two blocks, one on the other, pulled ever harder: first all rest, then both move as one, then the upper slides.
#[test]
fn a_block_on_a_block() {
    let text = "F = t*(1 [m/s^3])\nx'' = coulomb(y' - x', 3 [m/s^2]) - coulomb(x', 2 [m/s^2])\n\
                y'' = F - coulomb(y' - x', 3 [m/s^2])\nx(0) = 0 [m]\nx'(0) = 0 [m/s]\ny(0) = 0 [m]\ny'(0) = 0 [m/s]";
    for method in EXACT {
        for (until, lower, upper) in [(1.9, 0.0, 0.0), (3.0, 0.25, 0.25), (4.0, 1.0, 1.0), (5.0, 2.0, 2.5)] {
            let run = exactly(text, method, until);
            let (x, y) = (run.state()[1], run.state()[3]);
            assert!((x - lower).abs() < 1e-8 && (y - upper).abs() < 1e-8, "{method}, {until} s: {x}, {y}");
        }
    }
}

/// A block on a slope rests although friction would not be exact, and slides when the slope is made steeper.
#[test]
fn a_slope_is_made_steeper() {
    let model = model(
        "parameter alpha = 20 [deg]\nparameter mu = 0.5\nparameter g = 9.8 [m/s^2]\n\
         s'' = g*sin(alpha) - coulomb(s', mu*g*cos(alpha))\ns(0) = 0 [m]\ns'(0) = 0 [m/s]",
    );
    assert!(!model.parameters[parameter(&model, "mu")].restarts, "a slider does not restart the run");
    let mut run = run(&model, setup(&model, Method::RungeKutta4, 0.05), 20);
    assert_eq!(run.state()[..2], [0.0, 0.0]);
    let mut parameters = run.parameters().to_vec();
    parameters[parameter(&model, "alpha")] = PI / 6.0;
    run.set_parameters(parameters);
    for _ in 0..20 {
        run.advance().expect("it goes on");
    }
    let expected = 9.8 * (0.5 - 0.5 * libm::cos(PI / 6.0));
    assert!((run.state()[1] - expected).abs() < 1e-12, "{}", run.state()[1]);
    let mut parameters = run.parameters().to_vec();
    parameters[parameter(&model, "alpha")] = 0.0;
    run.set_parameters(parameters);
    for _ in 0..20 {
        run.advance().expect("it goes on");
    }
    assert_eq!(run.state()[1..], [0.0, 0.0], "on level ground it comes to rest");
}

#[test]
fn a_run_goes_on_with_its_bits() {
    let text = "x'' = -4 [1/s^2]*x - coulomb(x' - 0.5 [m/s], 3 [m/s^2], 1 [m/s^2])\nx(0) = 0.2 [m]\nx'(0) = 0 [m/s]";
    let model = model(text);
    for method in EXACT {
        let whole = run(&model, setup(&model, method, 0.05), 200);
        for back in (0..200).step_by(7) {
            let mut again = whole.clone();
            again.truncate(again.history().row_at(f64::from(back) * 0.05));
            while again.time() < whole.time() {
                again.advance().expect("it goes on");
            }
            assert_eq!(again.history().fingerprint(), whole.history().fingerprint(), "{method} from {back}");
        }
    }
}

/// With the limit 0 nothing sticks: from rest, with the belt and through turning points it moves as without friction.
#[test]
fn friction_without_a_limit_holds_nothing() {
    let text = "parameter mu = 0
m = 1 [kg]
m*x'' = -4 [N/m]*x + 1 [N]*sin(1 [rad/s]*t) - coulomb(x', mu*m*9.8 [m/s^2])
x(0) = 0 [m]
x'(0) = 0 [m/s]
z'' = -4 [1/s^2]*z - coulomb(z' - 0.5 [m/s], mu*9.8 [m/s^2])
z(0) = 0 [m]
z'(0) = 0.5 [m/s]
";
    for method in EXACT {
        let run = exactly(text, method, 5.0);
        // x'' + 4 x = sin t from rest: (sin t - sin 2t / 2)/3.
        let (x, z) = ((libm::sin(5.0) - libm::sin(10.0) / 2.0) / 3.0, 0.25 * libm::sin(10.0));
        assert!((run.state()[0] - x).abs() < 1e-8, "{method}: {} for {x}", run.state()[0]);
        assert!((run.state()[2] - z).abs() < 1e-8, "{method}: {} for {z}", run.state()[2]);
    }
}

/// A quantity derived from friction may be remembered from the start on: there it is the static force.
#[test]
fn the_force_at_the_start_is_that_which_holds() {
    let text = "F = coulomb(x', 3 [N], 2 [N])
1 [kg]*x'' = -4 [N/m]*x + 1 [N/s]*t - F
x(0) = 0.5 [m]
x'(0) = 0 [m/s]
F_max = maximum(F)
F_0 = F(0)
";
    let model = model(text);
    let run = run(&model, setup(&model, Method::RungeKutta4, 0.01), 50);
    for (name, expected) in [("F_0", -2.0), ("F_max", -1.5)] {
        let found = value(&model, &run, name);
        assert!((found - expected).abs() < 1e-12, "{name}: {found}");
    }
}
