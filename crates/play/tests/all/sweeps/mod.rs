//! Expressions of what is taken of runs, over the values of a parameter: their values, units and what stands behind them.

mod side_by_side;
mod workers;

use crate::support::{open, set};
use play::engine::{Compiled, Compiler, Listing, Setup, SideBySide};
use play::program::{Model, NodeId};
use play::{Play, PlotId};
use std::cell::Cell;
use std::rc::Rc;

/// Where the runs end, s.
const UNTIL: f64 = 3.0;
/// The amplitude, m.
const AMPLITUDE: f64 = 0.8;

/// x = a exp(-k t), a plane vector r = (x, 2 x) and a family u[i] = i x.
fn decay(curves: &str) -> Play {
    let decay = "---\nstep: 0.01 [s]\nuntil: 3 [s]\nmethod: rk4\n---\n```model\nparameter k = 1 [1/s] in 0.1..5\n\
        parameter a = 80 [cm]\nfunction half(z) = z/2\nx' = -k*x\nx(0) = a in [cm]\nc = k/(2 [1/s])\n\
        r = (x, 2*x)\nu[i] = i*x for i in 1..3\nx_greatest = maximum(x)\n```\n";
    open(&format!("{decay}```plots\n\"Sweep\": {curves} against k in 0.5..2.5 step 0.5\n```\n"), &[])
}

/// What is taken of a run from a time on, SI.
struct Truth {
    greatest: f64,
    least: f64,
    integral: f64,
    mean: f64,
    end: f64,
    c: f64,
}

fn truth(k: f64, from: f64) -> Truth {
    let x = |time: f64| AMPLITUDE * libm::exp(-k * time);
    let integral = (x(from) - x(UNTIL)) / k;
    let mean = integral / (UNTIL - from);
    Truth { greatest: x(from), least: x(UNTIL), integral, mean, end: x(UNTIL), c: k / 2.0 }
}

/// The rows of the plot's CSV.
fn rows(play: &mut Play) -> (String, Vec<Vec<f64>>) {
    while play.change_plots(|plots, run| plots.work(run)) {}
    let csv = play.plots_to_front().csv(PlotId::at(0));
    let (head, rest) = csv.split_once('\n').unwrap();
    let rows = rest.lines().map(|line| line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect());
    (head.to_owned(), rows.collect())
}

type Formula = fn(&Truth) -> f64;

/// Expressions of lengths, with their values in m.
const LENGTHS: [(&str, Formula); 12] = [
    ("maximum(x)", |run| run.greatest),
    ("minimum(x)", |run| run.least),
    ("mean(x)", |run| run.mean),
    ("maximum(x) - minimum(x)", |run| run.greatest - run.least),
    ("(maximum(x) + minimum(x))/2 - mean(x)", |run| (run.greatest + run.least) / 2.0 - run.mean),
    ("c*maximum(x) - 3 [mm]", |run| run.c * run.greatest - 0.003),
    ("sqrt(mean(x^2) + maximum(x)^2) - x(0)", |run| {
        // The mean square of a decay between two values is their mean times the half of their sum.
        libm::sqrt(run.mean * (run.greatest + run.least) / 2.0 + run.greatest * run.greatest) - AMPLITUDE
    }),
    ("if maximum(x) > 2*minimum(x) then maximum(x) else 0 [m]", |run| {
        if run.greatest > 2.0 * run.least { run.greatest } else { 0.0 }
    }),
    ("half(maximum(x) - minimum(x))", |run| (run.greatest - run.least) / 2.0),
    ("sum(maximum(u[i]) for i in 1..3)", |run| 6.0 * run.greatest),
    ("norm(mean(r))", |run| libm::sqrt(5.0) * run.mean),
    ("k*integral(x)", |run| 2.0 * run.c * run.integral),
];

#[test]
fn expressions_of_what_is_taken_of_runs_have_their_values_with_unit_and_time_in_any_order() {
    for (expression, value) in LENGTHS {
        for (behind, from, factor) in [
            ("", 0.0, None),
            (" in [cm]", 0.0, Some(100.0)),
            (" from 1 [s]", 1.0, None),
            (" from 1000 [ms] in [cm]", 1.0, Some(100.0)),
            (" in [mm] from 1", 1.0, Some(1000.0)),
            (" from 1 [s] in [cm] \"Length\"", 1.0, Some(100.0)),
            (" in [cm] at end", 0.0, Some(100.0)),
            (" from 1 [s] at end in [cm]", 1.0, Some(100.0)),
        ] {
            let mut play = decay(&format!("{expression}{behind}"));
            let (head, rows) = rows(&mut play);
            assert_eq!(rows.len(), 5, "{expression}{behind}");
            // Alone, what is taken of x is in the unit of x.
            let of_x = ["maximum(x)", "minimum(x)", "mean(x)"].contains(&expression);
            let factor = factor.unwrap_or(if of_x { 100.0 } else { 1.0 });
            let unit = if factor == 1.0 {
                "m"
            } else if factor == 100.0 {
                "cm"
            } else {
                "mm"
            };
            assert!(head.contains(&format!("[{unit}]")), "{expression}{behind}: {head}");
            for row in rows {
                let expected = factor * value(&truth(row[0], from));
                let size = factor * AMPLITUDE;
                assert!((row[1] - expected).abs() < 1e-4 * size, "{expression}{behind}: {row:?}, not {expected}");
            }
        }
    }
}

/// What changes during the run is that at its end, beside what is taken of all of it.
#[test]
fn at_the_end_the_rest_of_the_expression_has_its_last_value() {
    for (expression, value) in [
        ("maximum(x) - x", (|run| run.greatest - run.end) as Formula),
        ("x", |run| run.end),
        ("mean(x)*t/(1 [s])", |run| run.mean * UNTIL),
        ("u[2] + minimum(u[3])", |run| 2.0 * run.end + 3.0 * run.least),
        // The model's own is that of the run so far.
        ("x_greatest", |_| AMPLITUDE),
        ("x_greatest - maximum(x)", |run| AMPLITUDE - run.greatest),
    ] {
        let from = if expression.contains("m(") { " from 0.5 [s]" } else { "" };
        let (_, rows) = rows(&mut decay(&format!("{expression}{from} at end in [m]")));
        for row in rows {
            let expected = value(&truth(row[0], if from.is_empty() { 0.0 } else { 0.5 }));
            assert!((row[1] - expected).abs() < 1e-4, "{expression}: {row:?}, not {expected}");
        }
    }
}

/// Curves of one plot share what they take, each from its own time on; definitions need no run.
#[test]
fn curves_of_one_plot_each_have_their_own_time() {
    let curves =
        "maximum(x) in [m], c, maximum(x) from 1 [s] in [m], maximum(x) - minimum(x) from 1 [s], x at end in [m]";
    let mut play = decay(curves);
    let (_, rows) = rows(&mut play);
    assert_eq!(play.plots().progress(PlotId::at(0)), None);
    for row in rows {
        let (whole, later) = (truth(row[0], 0.0), truth(row[0], 1.0));
        // Each curve has a column of the parameter before it.
        let found: Vec<f64> = row.iter().copied().skip(1).step_by(2).collect();
        let expected = [whole.greatest, whole.c, later.greatest, later.greatest - later.least, whole.end];
        assert_eq!(found.len(), expected.len(), "{row:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-6, "{row:?}: {found}, not {expected}");
        }
    }
}

/// What is written and read back draws the same.
#[test]
fn a_bundle_keeps_expressions_of_runs() {
    let document = document::open(
        "---\nuntil: 1 [s]\n---\n```model\nparameter k = 1 [1/s]\nx' = -k*x\nx(0) = 1\n```\n\
        ```plots\n\"Sweep\": maximum(x) - minimum(x) from 0.5 [s], k against k in 1..2 step 0.5\n```\n",
        &[],
    );
    let program = document.document.unwrap().program;
    let bytes = program::bundle::write(&program).unwrap();
    let read = program::bundle::read(&bytes).unwrap();
    assert_eq!(program.plots, read.plots);
    let [mut one, mut other] = [program, read].map(Play::open);
    assert_eq!(rows(&mut one), rows(&mut other));
    // Whatever single byte is wrong, what is read can be drawn.
    for place in (9..bytes.len()).step_by(7) {
        let mut damaged = bytes.clone();
        damaged[place] ^= 0x05;
        if let Ok(program) = program::bundle::read(&damaged) {
            let mut play = Play::open(program);
            play.change_plots(|plots, run| plots.work(run));
            play.plots_to_front().csv(PlotId::at(0));
        }
    }
}

/// Counts the runs whose steps it is asked for, and leaves them interpreted.
#[derive(Debug, Default)]
struct Counting(Cell<usize>);

impl Compiler for Counting {
    fn compile(&self, _: Listing) -> Option<Rc<dyn Compiled>> {
        self.0.set(self.0.get() + 1);
        None
    }

    fn side_by_side(&self, _: &Model, _: &Setup, _: &[NodeId]) -> Option<Box<dyn SideBySide>> {
        None
    }
}

#[test]
fn all_runs_are_offered_to_the_compiler() {
    let mut play = decay("maximum(x)");
    let compiler = Rc::new(Counting::default());
    let compiled = |before: usize| compiler.0.get() - before;
    play.change_run(|line, _| line.use_compiler(compiler.clone()));
    assert_eq!(compiled(0), 1, "the present run");
    set(&mut play, "a", 40.0);
    assert_eq!(compiled(1), 1, "a run with another start");
    rows(&mut play);
    assert!(compiled(2) >= 5, "a run for each value of the parameter");
    let before = compiled(0);
    play.replace_program(play.program().clone());
    set(&mut play, "a", 50.0);
    assert!(compiled(before) > 0, "runs of the program that replaces this one");
}
