//! Ends and errors of single lanes among others.

use crate::documents::compare;
use engine::{Method, Setup};
use ensemble::Features;

/// Name, model, and the first and last value of the parameter `a`.
const MODELS: [(&str, &str, [f64; 2]); 13] = [
    ("a state becomes infinite", "x' = 1 [1/s]*a*x^2\nx(0) = 1", [0.0, 2.0]),
    ("a state is not a number", "x' = 1 [1/s]*sqrt(a - x)\nx(0) = 0", [0.2, 4.0]),
    ("initial values are not finite", "x' = -1 [1/s]*x\nx(0) = 1/a", [0.0, 5.0]),
    ("an event ends the run", "x' = 1 [1/s]*a\nx(0) = 0\nwhen x > 1 { stop }", [0.0, 3.0]),
    ("an event in the last row", "x' = 1 [1/s]\nx(0) = 0\nwhen x >= 3*a { x = 0 }", [0.5, 1.0]),
    ("a switch at a time", "x' = if t > 1 [s]*a then 1 [1/s] else -1 [1/s]*x\nx(0) = 1", [0.1, 2.9]),
    ("an event that only observes", "x'' = -9 [1/s^2]*a*x\nx(0) = 1\nx'(0) = 0\nwhen x > 0 as up { }", [0.2, 4.0]),
    (
        "a maximum, a counter and a place",
        "x'' = -9 [1/s^2]*a*x\nx(0) = 0\nx'(0) = 1 [1/s]\ndiscrete n = 0\nwhen x' < 0 as top { n = n + 1 }\n\
         h = maximum(x)\nd = top.x",
        [0.2, 4.0],
    ),
    ("jumps that come back", "x'' = -9.81 [1/s^2]\nx(0) = a\nx'(0) = 0\nwhen x < 0 { x' = -0.9*x' }", [1.0, 3.0]),
    ("jumps that come denser", "x'' = -9.81 [1/s^2]\nx(0) = a\nx'(0) = 0\nwhen x < 0 { x' = -0.7*x' }", [1.5, 2.9]),
    ("marks in few rows", "x' = -1 [1/s]*a*x\nx(0) = 1\ndiscrete m = 0\nevery 0.7 [s]*a { m = x }", [0.5, 2.0]),
    ("marks in all rows", "x' = -1 [1/s]*a*x\nx(0) = 1\ndiscrete m = 0\nevery 0.03 [s] { m = x }", [0.5, 2.0]),
    ("a switch", "x'' = -9 [1/s^2]*a*(if x > 0.3 then 1 else 2)*x\nx(0) = 1\nx'(0) = 0", [0.2, 4.0]),
];

#[test]
fn a_lane_that_ends_leaves_the_others_alone() {
    for (name, model, [low, high]) in MODELS {
        let text = format!("---\nuntil: 3 [s]\nstep: 0.05\n---\n\n```model\nparameter a = {high}\n{model}\n```\n");
        let opened = document::open(&text, &[]);
        let program = opened.document.unwrap_or_else(|| panic!("{name}: {:?}", opened.diagnostics)).program;
        let parameters: Vec<Vec<f64>> = (0..13).map(|run| vec![low + (high - low) * f64::from(run) / 12.0]).collect();
        let nodes = [program.model.states[0].derivative];
        for method in [Method::DormandPrince, Method::RungeKutta4, Method::EulerRichardson, Method::Euler] {
            for features in [Features::Least, Features::Avx2, Features::Best] {
                let setup = Setup { method, ..Setup::of(&program) };
                let alone = compare(name, &program, &setup, &parameters, &nodes, features);
                assert_eq!(alone, None, "{name}, {method:?}");
                compare(name, &program, &setup, &parameters, &[], features);
            }
        }
    }
}
