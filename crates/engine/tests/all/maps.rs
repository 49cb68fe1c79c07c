//! Maps: where the independent variable counts.

use crate::support::{model, parameter, run, setup};
use engine::{Method, Readings, Run, Setup};
use program::Model;

const LOGISTIC: &str =
    "independent k by 1\nparameter r = 3.2 in 0..4\nnext p = r*p*(1 - p)\np(0) = 0.1 \"Population\"\n";

fn counted(model: &Model, rows: usize) -> Run {
    run(model, Setup::defaults(model), rows)
}

fn column(model: &Model, run: &Run, name: &str) -> Vec<f64> {
    let state = model.states.iter().position(|state| state.variable == name).expect("a state");
    run.history().column(state).to_vec()
}

/// x_± = (r + 1 ± sqrt((r - 3)(r + 1)))/(2 r), the cycle of period 2 of the logistic map (R. M. May, Nature 261 (1976) 459).
#[test]
fn the_logistic_map_settles_to_its_cycle() {
    let model = model(LOGISTIC);
    assert_eq!(model.states[0].label.as_deref(), Some("Population"));
    let run = counted(&model, 200);
    let p = column(&model, &run, "p");
    let r: f64 = 3.2;
    let root = ((r - 3.0) * (r + 1.0)).sqrt();
    let mut last = [p[199], p[200]];
    last.sort_by(f64::total_cmp);
    for (found, sign) in last.into_iter().zip([-1.0, 1.0]) {
        let expected = (r + 1.0 + sign * root) / (2.0 * r);
        assert!((found - expected).abs() < 1e-12, "{found} and not {expected}");
    }
    // Each value has the bits of the formula, and there is one row at each count.
    assert_eq!(run.history().times(), (0..=200).map(f64::from).collect::<Vec<_>>());
    assert!(p.windows(2).all(|pair| pair[1] == r * pair[0] * (1.0 - pair[0])));
}

/// All act at once on the values before.
#[test]
fn fibonacci_and_henon() {
    let fibonacci = model("independent n by 1\nnext a = b\nnext b = a + b\na(0) = 0\nb(0) = 1\n");
    let a = column(&fibonacci, &counted(&fibonacci, 78), "a");
    assert_eq!(a[..10], [0.0, 1.0, 1.0, 2.0, 3.0, 5.0, 8.0, 13.0, 21.0, 34.0]);
    assert_eq!(a[78], 8_944_394_323_791_464.0);
    // The fixed point x = (b - 1 + sqrt((1 - b)² + 4 a))/(2 a) of x' = 1 - a x² + y, y' = b x (M. Hénon, Commun. Math. Phys.
    // 50 (1976) 69), which attracts for a = 0.2, b = 0.3.
    let henon = model(
        "independent k by 1\nparameter a = 0.2\nparameter b = 0.3\nnext x = 1 - a*x^2 + y\nnext y = b*x\nx(0) = 0\ny(0) = 0\n",
    );
    let run = counted(&henon, 300);
    let (a, b): (f64, f64) = (0.2, 0.3);
    let fixed = (b - 1.0 + ((1.0 - b) * (1.0 - b) + 4.0 * a).sqrt()) / (2.0 * a);
    assert!((column(&henon, &run, "x")[300] - fixed).abs() < 1e-12);
    assert!((column(&henon, &run, "y")[300] - b * fixed).abs() < 1e-12);
}

/// A rotating shift register: each member takes the previous value of its neighbour.
#[test]
fn families_have_maps() {
    let ring = model(
        "independent k by 1\nsize N = 5\nx[0] = x[N]\nnext x[i] = x[i-1] for i in 1..N\nx[i](0) = i for i in 1..N\n",
    );
    let mut run = counted(&ring, 3);
    assert_eq!(run.state()[..5], [3.0, 4.0, 5.0, 1.0, 2.0]);
    run.advance().expect("goes on");
    assert_eq!(run.state()[..5], [2.0, 3.0, 4.0, 5.0, 1.0]);
}

#[test]
fn step_and_method_mean_nothing() {
    let model = model(LOGISTIC);
    let expected = counted(&model, 20).history().fingerprint();
    for method in Method::ALL {
        for step in [0.05, 1.0, 7.0] {
            let run = run(&model, setup(&model, method, step), 20);
            assert_eq!(run.history().fingerprint(), expected, "{method} {step}");
        }
    }
}

/// Between two counts the value holds; a run that goes back and on has the same bits.
#[test]
fn the_value_holds_and_going_back_changes_nothing() {
    let model = model(LOGISTIC);
    let mut run = counted(&model, 20);
    let mut state = vec![0.0; model.states.len()];
    let expected = run.history().fingerprint();
    for (time, count) in [(0.0, 0), (0.999, 0), (1.0, 1), (7.5, 7), (20.0, 20)] {
        run.interpolate(time, &mut state);
        assert_eq!(state[0], run.history().column(0)[count], "{time}");
    }
    run.truncate(7);
    assert_eq!(run.history().len(), 8);
    for _ in 7..20 {
        run.advance().expect("goes on");
    }
    assert_eq!(run.history().fingerprint(), expected);
    let r = parameter(&model, "r");
    let mut parameters = run.parameters().to_vec();
    parameters[r] = 1.5;
    run.set_parameters(parameters);
    for _ in 0..100 {
        run.advance().expect("goes on");
    }
    assert!((run.state()[0] - 1.0 / 3.0).abs() < 1e-12, "1 - 1/r: {}", run.state()[0]);
}

/// Events look at the values of each count, `every` acts at multiples, and sums run over the counts.
#[test]
fn events_beside_a_map() {
    let model = model(
        "independent k by 1\ndiscrete n = 0\ndiscrete m = 0\nnext x = x + 1\nx(0) = 0\n\
         when x > 4 as there { n = k }\nevery 3 { m = m + x }\ns = maximum(x)\nwhen x > 9 { stop }\n",
    );
    let mut run = Run::start(&model, Setup::defaults(&model)).expect("starts");
    let ended = (0..100).find_map(|_| run.advance().err()).expect("ends");
    assert!(ended.is_end() && run.time() == 10.0, "{ended}");
    let value = |name: &str| {
        let node = model.lookup(name, 0).expect("a quantity").node;
        Readings::new(&model, &[node]).at(run.parameters(), run.initial(), run.time(), run.state())[0]
    };
    assert_eq!((value("n"), value("m"), value("s")), (5.0, 18.0, 10.0));
    assert_eq!(run.history().times(), (0..=10).map(f64::from).collect::<Vec<_>>());
}

/// Both components of a vector act at once: a quarter of a turn at each count.
#[test]
fn vectors_have_maps() {
    let model = model("independent k by 1\nnext r = (-r.y, r.x)\nr(0) = (3, 1) [m]\n");
    let run = counted(&model, 5);
    assert_eq!(run.state()[..2], [-1.0, 3.0]);
}
