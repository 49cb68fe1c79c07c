//! Systems of many equal parts: chains and diffusion, whose equations are computed as columns and solved banded.

use crate::support::{model, run, setup};
use engine::{Method, Setup, Stepper};
use program::{Variable, differentiate_all};
use std::f64::consts::PI;
use std::fmt::Write;

/// Masses between fixed ends, in the normal mode of this number; k = m = 1 and the amplitude is 1.
fn chain(masses: usize, mode: usize) -> String {
    let at = |i: usize| if i == 0 || i > masses { "0".to_owned() } else { format!("x_{i}") };
    let mut text = "independent t\n".to_owned();
    for i in 1..=masses {
        writeln!(text, "x_{i}'' = {} - 2*x_{i} + {}", at(i - 1), at(i + 1)).unwrap();
        writeln!(text, "x_{i}(0) = sin({mode}*pi*{i}/{})\nx_{i}'(0) = 0", masses + 1).unwrap();
    }
    text
}

/// u' = u_xx on the unit interval with u = 0 at its ends, at so many inner points.
fn diffusion(points: usize) -> String {
    let at = |i: usize| if i == 0 || i > points { "0".to_owned() } else { format!("u_{i}") };
    let mut text = format!("independent t\nc = {}^2\n", points + 1);
    for i in 1..=points {
        writeln!(text, "u_{i}' = c*({} - 2*u_{i} + {})", at(i - 1), at(i + 1)).unwrap();
        writeln!(text, "u_{i}(0) = sin(pi*{i}/{})", points + 1).unwrap();
    }
    text
}

#[test]
fn a_chain_swings_in_its_normal_modes() {
    const MASSES: usize = 40;
    for (mode, method, error) in [
        (1, Method::RungeKutta4, 1e-9),
        (7, Method::RungeKutta4, 1e-5),
        (40, Method::RungeKutta4, 2e-4),
        (3, Method::VelocityVerlet, 1e-3),
        (3, Method::EulerRichardson, 2e-3),
        (7, Method::DormandPrince, 1e-5),
        (7, Method::Rosenbrock, 1e-4),
    ] {
        let model = model(&chain(MASSES, mode));
        let run = run(&model, setup(&model, method, 0.05), 400);
        let angle = mode as f64 * PI / (MASSES as f64 + 1.0);
        // omega_k = 2 sqrt(k/m) sin(k pi/(2 (N + 1)))
        let omega = 2.0 * libm::sin(angle / 2.0);
        for i in 1..=MASSES {
            let (position, velocity) = (2 * (i - 1), 2 * i - 1);
            assert_eq!(model.states[velocity].name(), format!("x_{i}'"));
            let amplitude = libm::sin(angle * i as f64);
            let expected = [amplitude * libm::cos(omega * 20.0), -omega * amplitude * libm::sin(omega * 20.0)];
            for (state, expected) in [position, velocity].into_iter().zip(expected) {
                let found = run.history().column(state)[400];
                assert!((found - expected).abs() < error, "{method:?} {mode} {i}: {found} {expected}");
            }
        }
    }
}

/// Half the step, a quarter of the error of the energy with velocity Verlet, and one of 32 with Runge-Kutta.
#[test]
fn the_energy_of_a_chain_is_kept_to_the_order_of_the_method() {
    const MASSES: usize = 30;
    let model = model(&chain(MASSES, 20));
    let energy = |state: &[f64]| {
        let at = |i: usize| if i == 0 || i > MASSES { 0.0 } else { state[2 * (i - 1)] };
        let kinetic: f64 = (1..=MASSES).map(|i| state[2 * i - 1] * state[2 * i - 1] / 2.0).sum();
        kinetic + (0..=MASSES).map(|i| (at(i + 1) - at(i)) * (at(i + 1) - at(i)) / 2.0).sum::<f64>()
    };
    for (method, order) in [(Method::VelocityVerlet, 2.0), (Method::RungeKutta4, 5.0)] {
        let error = |step: f64| {
            let mut stepper = Stepper::new(&model, &setup(&model, method, step)).unwrap();
            let first = energy(stepper.state());
            let mut greatest = 0.0_f64;
            for _ in 0..(20.0 / step) as usize {
                stepper.advance(|_, _, _| {}).unwrap();
                greatest = greatest.max((energy(stepper.state()) - first).abs() / first);
            }
            greatest
        };
        let found = libm::log2(error(0.1) / error(0.05));
        assert!((found - order).abs() < 0.2, "{method:?}: {found}");
    }
}

#[test]
fn diffusion_is_solved_banded() {
    const POINTS: usize = 200;
    let model = model(&diffusion(POINTS));
    let setup = Setup { tolerance: 1e-8, ..setup(&model, Method::Rosenbrock, 0.01) };
    let mut stepper = Stepper::new(&model, &setup).unwrap();
    for _ in 0..10 {
        stepper.advance(|_, _, _| {}).unwrap();
    }
    // The slowest mode of the lattice decays with 4 (N + 1)^2 sin^2(pi/(2 (N + 1))).
    let angle = PI / (POINTS as f64 + 1.0);
    let half = (POINTS as f64 + 1.0) * libm::sin(angle / 2.0);
    let decay = libm::exp(-4.0 * half * half * 0.1);
    for (i, &found) in stepper.state().iter().enumerate() {
        let expected = decay * libm::sin(angle * (i as f64 + 1.0));
        assert!((found - expected).abs() < 1e-6 * decay, "{i}: {found} {expected}");
    }
    // A dense elimination alone would take 200^3/3 operations in each step.
    let steps = stepper.jacobians();
    assert!(stepper.work() < steps * 200_000, "{} in {steps} steps", stepper.work());
}

#[test]
fn slopes_are_those_of_every_rate_by_every_state() {
    let model = model(
        "independent t\nx' = y*z + t\ny' = x^2 - sin(y)\nz' = x\nx(0) = 1\ny(0) = 0\nz(0) = 0\n\
         u'' + v''/2 = -u*x\nv'' + u''/3 = -v + cos(t)\nu(0) = 1\nu'(0) = 0\nv(0) = 0\nv'(0) = 0\n",
    );
    let rates: Vec<program::NodeId> = model.states.iter().map(|state| state.derivative).collect();
    let slopes = model.slopes().unwrap();
    let mut graph = slopes.graph.clone();
    let mut found = slopes.by_states.iter();
    for state in 0..rates.len() as u32 {
        for (rate, expected) in (0..).zip(differentiate_all(&mut graph, &rates, Variable::State(state))) {
            if graph.as_constant(expected) != Some(0.0) {
                assert_eq!(found.next(), Some(&program::Slope { rate, state, node: expected }));
            }
        }
    }
    assert_eq!(found.next(), None);
    assert_eq!(graph.len(), slopes.graph.len(), "nothing else was made");
    assert_eq!(slopes.by_independent, differentiate_all(&mut graph, &rates, Variable::Independent));
}

/// A long chain is compiled in a time that grows with its length, and every method goes through it.
#[test]
fn a_thousand_points_are_compiled_and_move() {
    let model = model(&chain(1000, 2));
    for method in Method::ALL {
        let mut stepper = Stepper::new(&model, &setup(&model, method, 0.05)).unwrap();
        for _ in 0..3 {
            stepper.advance(|_, _, _| {}).unwrap();
        }
        let middle = stepper.state()[2 * 250];
        assert!((middle - 1.0).abs() < 0.01, "{method:?}: {middle}");
    }
}

/// A string of finite elements: the mass matrix couples neighbours, as the stiffness matrix does (Zienkiewicz & Taylor, The
/// Finite Element Method, volume 1, section 16.2: the consistent mass matrix).
#[test]
fn coupled_equations_of_motion_are_solved_banded() {
    for (points, mode) in [(20, 3), (300, 3)] {
        let model = model(&format!(
            "independent t\nsize N = {points}\n\
             (x[i-1]'' + 4*x[i]'' + x[i+1]'')/6 = x[i-1] - 2*x[i] + x[i+1]  for i in 1..N\n\
             x[0] = 0\nx[N+1] = 0\nx[i](0) = sin({mode}*pi*i/(N + 1))  for i in 1..N\nx[i]'(0) = 0  for i in 1..N"
        ));
        assert_eq!(model.graph.systems().len(), 1);
        let mut stepper = Stepper::new(&model, &setup(&model, Method::RungeKutta4, 0.05)).unwrap();
        for _ in 0..200 {
            stepper.advance(|_, _, _| {}).unwrap();
        }
        let angle = f64::from(mode) * PI / (f64::from(points) + 1.0);
        let (c, half) = (libm::cos(angle), libm::sin(angle / 2.0));
        let omega = libm::sqrt(4.0 * half * half / ((2.0 + c) / 3.0));
        for i in 1..=points {
            let expected = libm::sin(angle * f64::from(i)) * libm::cos(10.0 * omega);
            let found = stepper.state()[2 * (i as usize - 1)];
            assert!((found - expected).abs() < 1e-6, "{points} {i}: {found} {expected}");
        }
        // A dense elimination of 300 equations would take nine million operations.
        let work = stepper.work() / stepper.evaluations();
        assert!(work < 100 * points as u64 + 10_000, "{points}: {work}");
    }
}
