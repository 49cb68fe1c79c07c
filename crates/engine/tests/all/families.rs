//! Families of states against closed forms.

use crate::support::{jumps, model, parameter, run, setup};
use engine::{Method, Readings};
use program::Model;

fn state(model: &Model, name: &str) -> usize {
    model.states.iter().position(|state| state.name() == name).expect(name)
}

const CHAIN: &str = "
size N = 12
parameter m = 0.1 [kg]
parameter k = 10 [N/m]
parameter A = 2 [cm]
parameter n = 3
m*x[i]'' = k*(x[i-1] - 2*x[i] + x[i+1]) for i in 1..N
x[0] = 0 [m]
x[N+1] = 0 [m]
x[i](0) = A*sin(n*pi*i/(N + 1)) in [cm] for i in 1..N \"Displacement\"
x[i]'(0) = 0 [m/s] for i in 1..N
E = sum(m*x[i]'^2/2 for i in 1..N) + sum(k*(x[i+1] - x[i])^2/2 for i in 0..N)
x_max = max(x[i] for i in 1..N)
";

#[test]
fn a_chain_swings_in_its_normal_modes() {
    // omega_n = 2 sqrt(k/m) sin(n pi/(2 (N + 1))): see A. P. French, Vibrations and Waves (1971), chapter 5.
    let model = model(CHAIN);
    assert_eq!(model.states.len(), 24);
    let mut energies = Readings::new(&model, &[model.lookup("E", 0).unwrap().node]);
    for n in [1.0, 5.0, 12.0] {
        let mut setup = setup(&model, Method::RungeKutta4, 1e-3);
        setup.parameters[parameter(&model, "n")] = n;
        let run = run(&model, setup, 2000);
        let omega = 20.0 * libm::sin(n * std::f64::consts::PI / 26.0);
        let history = run.history();
        for i in 1..=12 {
            let column = history.column(state(&model, &format!("x[{i}]")));
            let amplitude = 0.02 * libm::sin(n * std::f64::consts::PI * f64::from(i) / 13.0);
            for (&x, &t) in column.iter().zip(history.times()) {
                assert!((x - amplitude * libm::cos(omega * t)).abs() < 1e-8, "mode {n}, x[{i}] at {t} s");
            }
        }
        let [first, last] = [0, history.len() - 1].map(|row| energies.at_row(history, row)[0]);
        assert!((last / first - 1.0).abs() < 1e-7, "mode {n}: {first} J and {last} J");
    }
}

#[test]
fn warmth_spreads_over_a_plate_as_its_modes_decay() {
    // u = sin(p pi i/(N+1)) sin(q pi j/(M+1)) decays with 4 (sin^2(p pi/(2 (N+1))) + sin^2(q pi/(2 (M+1)))) D/a^2.
    let model = model(
        "size N = 4
size M = 3
parameter D = 0.5 [1/s]
u[i, j]' = D*(u[i-1, j] + u[i+1, j] + u[i, j-1] + u[i, j+1] - 4*u[i, j]) for i in 1..N, j in 1..M
u[0, j] = 0 for j in 1..M
u[N+1, j] = 0 for j in 1..M
u[i, 0] = 0 for i in 1..N
u[i, M+1] = 0 for i in 1..N
u[i, j](0) = sin(2*pi*i/(N+1))*sin(pi*j/(M+1)) for i in 1..N, j in 1..M",
    );
    let run = run(&model, setup(&model, Method::RungeKutta4, 1e-2), 200);
    let part = |p: f64, n: f64| libm::pow(libm::sin(p * std::f64::consts::PI / (2.0 * (n + 1.0))), 2.0);
    let rate = 4.0 * 0.5 * (part(2.0, 4.0) + part(1.0, 3.0));
    for (i, j) in [(1, 1), (4, 2), (2, 3)] {
        let column = run.history().column(state(&model, &format!("u[{i},{j}]")));
        let expected = column[0] * libm::exp(-rate * 2.0);
        assert!((column[200] - expected).abs() < 1e-9, "u[{i},{j}]: {} for {expected}", column[200]);
    }
}

#[test]
fn definitions_may_recur_and_sums_have_their_closed_forms() {
    let model = model(
        "size N = 100
q = 0.5
function square(a) = a^2
function total(f, n) = sum(f[j] for j in 1..n)
s[0] = 1
s[i] = s[i-1]*q + 1 for i in 1..N
geometric = s[N]
squares = sum(square(i) for i in 1..N)
half = total(s, N/2)
pairs = sum(1 for i in 1..N, j in i+1..N)
empty = sum(i for i in N+1..N)
least = min((i - 7)^2 for i in 1..N)
x' = -x/1 [s]
x(0) = 1",
    );
    let names = ["geometric", "squares", "half", "pairs", "empty", "least"];
    let nodes: Vec<_> = names.iter().map(|name| model.lookup(name, 0).unwrap().node).collect();
    let run = run(&model, setup(&model, Method::RungeKutta4, 0.1), 1);
    let mut readings = Readings::new(&model, &nodes);
    // The 50 members are 2 - 2^-i, and so their sum 100 - 1 but for 2^-50.
    assert_eq!(readings.at_row(run.history(), 0), [2.0, 338_350.0, 99.0, 4950.0, 0.0, 0.0]);
}

#[test]
fn each_member_has_its_event() {
    let model = model(
        "size N = 3
parameter g = 10 [m/s^2]
y[i]'' = -g for i in 1..N
y[i](0) = i*i*1.25 [m] for i in 1..N
y[i]'(0) = 0 [m/s] for i in 1..N
discrete n[i] = 0 for i in 1..N
when y[i] < 0 [m] { y[i]' = -y[i]', n[i] = n[i] + 1 } for i in 1..N",
    );
    let run = run(&model, setup(&model, Method::RungeKutta4, 0.01), 160);
    // A fall from 1.25 i^2 m takes i/2 s, and each bounce twice that.
    let times: Vec<f64> = jumps(&run).into_iter().map(|time| (time * 1e9).round() / 1e9).collect();
    assert_eq!(times, [0.5, 1.0, 1.5, 1.5]);
    let counts: Vec<f64> = (1..=3).map(|i| run.state()[state(&model, &format!("n[{i}]"))]).collect();
    assert_eq!(counts, [2.0, 1.0, 1.0], "at 1.5 s the first and the third ball land together");
}
