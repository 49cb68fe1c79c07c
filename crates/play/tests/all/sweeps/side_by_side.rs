//! Plots over a parameter whose runs are made side by side: they are those of runs one by one.

use crate::support::open;
use play::engine::{Compiled, Compiler, LANES, Listing, Readings, Run, Setup, SideBySide};
use play::program::{Model, NodeId};
use play::{Play, PlotId};
use std::cell::Cell;
use std::rc::Rc;

/// Makes runs side by side of single ones, and counts them.
#[derive(Debug, Default)]
pub struct Singles(Rc<Cell<usize>>);

#[derive(Debug)]
struct Beside {
    model: Model,
    setup: Setup,
    readings: Readings,
    until: f64,
    /// Number of steps made.
    made: usize,
    runs: Vec<Run>,
    failed: Vec<bool>,
    count: Rc<Cell<usize>>,
}

impl Compiler for Singles {
    fn compile(&self, _: Listing) -> Option<Rc<dyn Compiled>> {
        None
    }

    fn side_by_side(&self, model: &Model, setup: &Setup, nodes: &[NodeId]) -> Option<Box<dyn SideBySide>> {
        Some(Box::new(Beside {
            model: model.clone(),
            setup: setup.clone(),
            readings: Readings::new(model, nodes),
            until: 0.0,
            made: 0,
            runs: Vec::new(),
            failed: Vec::new(),
            count: self.0.clone(),
        }))
    }
}

impl SideBySide for Beside {
    fn begin(&mut self, runs: &[[Vec<f64>; 2]], until: f64, take: &mut dyn FnMut(usize, f64, &[f64])) {
        assert!(runs.len() <= LANES);
        self.until = until;
        self.count.set(self.count.get() + runs.len());
        for (number, [parameters, initial]) in runs.iter().enumerate() {
            let run = Run::start(&self.model, Setup { parameters: parameters.clone(), ..self.setup.clone() }).unwrap();
            assert_eq!(run.history().initial(), initial);
            take(number, 0.0, self.readings.at_row(run.history(), 0));
            self.runs.push(run);
            self.failed.push(false);
        }
    }

    fn advance(&mut self, left: &mut u64, take: &mut dyn FnMut(usize, f64, &[f64])) -> bool {
        if self.made as f64 * self.setup.step >= self.until {
            return true;
        }
        self.made += 1;
        *left /= 2;
        for (number, run) in self.runs.iter_mut().enumerate() {
            let known = run.history().len();
            self.failed[number] |= run.advance().is_err();
            for row in known..run.history().len() {
                take(number, run.history().time(row), self.readings.at_row(run.history(), row));
            }
        }
        false
    }

    fn end(&self, run: usize) -> Option<(f64, Vec<f64>)> {
        let history = self.runs[run].history();
        let mut state = vec![0.0; history.states()];
        history.state(history.len() - 1, &mut state);
        (!self.failed[run]).then_some((history.time(history.len() - 1), state))
    }
}

/// The plot of x' = -k x + c x^2, which grows without bounds for some k, as CSV.
fn csv(event: &str, curves: &str, compiler: Option<Rc<dyn Compiler>>) -> String {
    let model = format!(
        "---\nstep: 0.125 [s]\nuntil: 4 [s]\nmethod: rk4\n---\n```model\nparameter k = 1 in -2..2\n\
        parameter c = 1\n{event}\nx' = (c*x^2 - k*x)/(1 [s])\nx(0) = 0.5 + 0.1*k\n```\n"
    );
    let text = format!("{model}```plots\n\"Sweep\": {curves}\n```\n");
    let mut play: Play = open(&text, &[]);
    if let Some(compiler) = compiler {
        play.change_run(|line, _| line.use_compiler(compiler.clone()));
    }
    while play.change_plots(|plots, run| plots.work(run)) {}
    play.plots_to_front().csv(PlotId::at(0))
}

#[test]
fn runs_side_by_side_draw_what_single_runs_draw() {
    for (event, curves) in [
        ("", "maximum(x) - mean(x), x at end, k against k in -0.5..1.5 step 0.02"),
        ("every 0.3 [s] as drive { }", "points x from 1 [s] against k in -0.5..1.5 step 0.02 at drive"),
    ] {
        let count = Rc::new(Cell::new(0));
        let alone = csv(event, curves, None);
        let together = csv(event, curves, Some(Rc::new(Singles(count.clone()))));
        for (alone, together) in alone.lines().zip(together.lines()) {
            assert_eq!(alone, together, "{curves}");
        }
        assert_eq!(alone.len(), together.len(), "{curves}");
        assert_eq!(count.get(), 101, "{curves}");
        assert!(alone.lines().count() > 100, "{curves}");
    }
}
