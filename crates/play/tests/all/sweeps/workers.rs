//! Runs of plots over a parameter that workers make: the picture does not depend on who computes, nor on who is ready first.

use super::side_by_side::Singles;
use crate::support::{open, set};
use play::engine::Compiler;
use play::{Play, PlotId, SweepNews, SweepWork, SweepWorkers, TakenRun};
use std::rc::Rc;

/// Several workers that have a batch by its bytes only, and report the last one first, in parts.
#[derive(Default)]
struct Elsewhere {
    /// Batches in work, and their runs that are not reported, once they are made.
    given: Vec<(u32, Vec<u8>, Option<Vec<TakenRun>>)>,
    issued: u32,
    /// Number of workers.
    count: usize,
    /// Number of the next calls in which there is no worker yet.
    late: usize,
    /// Greatest number of batches at the same time.
    most: usize,
    /// Number of the next reports in which all is lost.
    losses: usize,
    /// Number of batches that were given up.
    given_up: usize,
    /// True if runs are made side by side.
    together: bool,
}

impl Elsewhere {
    fn new(count: usize) -> Self {
        Self { count, ..Self::default() }
    }

    /// The runs of a batch.
    fn made(&self, bytes: &[u8]) -> Vec<TakenRun> {
        let compiler = self.together.then(|| Rc::new(Singles::default()) as Rc<dyn Compiler>);
        let mut computation = postcard::from_bytes::<SweepWork>(bytes).unwrap().start(compiler);
        let mut runs = Vec::new();
        while !computation.is_complete() {
            runs.extend(computation.advance(10_000));
        }
        runs
    }
}

/// A value after it has been sent.
fn sent<T: serde::Serialize + serde::de::DeserializeOwned>(value: &T) -> T {
    postcard::from_bytes(&postcard::to_allocvec(value).unwrap()).unwrap()
}

impl SweepWorkers for Elsewhere {
    fn count(&mut self) -> usize {
        if self.late > 0 {
            self.late -= 1;
            return 0;
        }
        self.count
    }

    fn begin(&mut self, work: SweepWork) -> u32 {
        self.issued += 1;
        self.given.push((self.issued, postcard::to_allocvec(&work).unwrap(), None));
        self.most = self.most.max(self.given.len());
        assert!(self.given.len() <= self.count);
        self.issued
    }

    fn news(&mut self) -> Vec<(u32, SweepNews)> {
        if self.losses > 0 && !self.given.is_empty() {
            self.losses -= 1;
            return self.given.drain(..).map(|(number, ..)| (number, SweepNews::Lost)).collect();
        }
        let Some((number, bytes, made)) = self.given.pop() else { return Vec::new() };
        let mut runs = made.unwrap_or_else(|| self.made(&bytes));
        let rest = runs.split_off(runs.len().min(25));
        let is_last = rest.is_empty();
        if !is_last {
            self.given.insert(0, (number, bytes, Some(rest)));
        }
        let news = SweepNews::Taken { runs, is_last };
        assert_eq!(format!("{:?}", sent(&news)), format!("{news:?}"));
        vec![(number, sent(&news))]
    }

    fn keep(&mut self, wanted: &[u32]) {
        let before = self.given.len();
        self.given.retain(|(number, ..)| wanted.contains(number));
        self.given_up += before - self.given.len();
    }
}

/// x' = -k x + c x^2, which grows without bounds for some k.
fn growth(curves: &str) -> Play {
    let model = "---\nstep: 0.02 [s]\nuntil: 20 [s]\nmethod: rk4\n---\n```model\nparameter k = 1 in -2..2\n\
        parameter c = 1 in 0..2\nevery 0.3 [s] as drive { }\nx' = (c*x^2 - k*x)/(1 [s])\nx(0) = 0.5 + 0.1*k\n```\n";
    open(&format!("{model}```plots\n{curves}```\n"), &[])
}

const LINES: &str = "\"Lines\": maximum(x) - mean(x), x at end, k against k in -0.5..1.5 step 0.01\n";
const POINTS: &str = "\"Points\": points x from 1 [s], k from 2 [s] against k in -0.5..1.5 step 0.01 at drive\n";

fn csv(play: &mut Play, plot: usize) -> String {
    play.plots_to_front().csv(PlotId::at(plot))
}

/// The columns of a table as CSV, without the cells that have no value.
fn columns(csv: &str) -> Vec<Vec<&str>> {
    let mut columns = Vec::new();
    for line in csv.lines() {
        for (number, cell) in line.split(',').enumerate() {
            columns.resize(columns.len().max(number + 1), Vec::new());
            if !cell.is_empty() {
                columns[number].push(cell);
            }
        }
    }
    columns
}

/// Computes all that is missing with workers. Returns the number of calls.
fn finish(play: &mut Play, workers: &mut Elsewhere) -> usize {
    let mut calls = 0;
    while play.change_plots(|plots, run| plots.work_beside(run, workers)) || !workers.given.is_empty() {
        calls += 1;
        assert!(calls < 10_000);
    }
    calls
}

/// All runs in slices, here.
fn finish_here(play: &mut Play) {
    while play.change_plots(|plots, run| plots.work(run)) {}
}

#[test]
fn workers_draw_what_is_drawn_here() {
    for curves in [LINES, POINTS] {
        let mut here = growth(curves);
        finish_here(&mut here);
        let expected = csv(&mut here, 0);
        assert!(expected.lines().count() > 200);
        for (count, late, losses, together) in
            [(1, 0, 0, false), (2, 0, 0, false), (2, 0, 0, true), (3, 5, 0, false), (3, 0, 2, false), (5, 2, 1, true)]
        {
            let mut workers = Elsewhere { late, losses, together, ..Elsewhere::new(count) };
            let mut play = growth(curves);
            finish(&mut play, &mut workers);
            let state = (count, late, losses, together);
            assert_eq!(csv(&mut play, 0), expected, "{state:?}");
            assert_eq!(play.plots().progress(PlotId::at(0)), None, "{state:?}");
            assert_eq!((workers.most, workers.given_up), (count, 0), "{state:?}");
        }
    }
}

/// The picture is always one of those that slices show, in any order of arrival.
#[test]
fn runs_are_drawn_in_the_order_of_their_values() {
    for curves in [LINES, POINTS] {
        let mut here = growth(curves);
        finish_here(&mut here);
        let expected = csv(&mut here, 0);
        let expected = columns(&expected);
        let mut play = growth(curves);
        let mut workers = Elsewhere::new(3);
        let mut steps = std::collections::BTreeSet::new();
        while play.change_plots(|plots, run| plots.work_beside(run, &mut workers)) || !workers.given.is_empty() {
            let Some((done, all)) = play.plots().progress(PlotId::at(0)) else { continue };
            assert_eq!(all, 201);
            steps.insert(done);
            let now = csv(&mut play, 0);
            let now = columns(&now);
            assert!(now.iter().zip(&expected).all(|(now, all)| all.starts_with(now)), "{done}");
        }
        assert!(steps.len() > 1, "{steps:?}");
    }
}

#[test]
fn what_takes_one_slice_needs_no_worker() {
    let mut play = growth("\"Few\": x at end against k in 0..1 step 0.5\n");
    let mut workers = Elsewhere::new(2);
    assert!(!play.change_plots(|plots, run| plots.work_beside(run, &mut workers)));
    assert_eq!((workers.issued, play.plots().progress(PlotId::at(0))), (0, None));
}

#[test]
fn what_is_not_wanted_any_more_is_given_up() {
    let mut expected = growth(LINES);
    set(&mut expected, "c", 0.5);
    finish_here(&mut expected);
    let mut play = growth(LINES);
    let mut workers = Elsewhere::new(2);
    let work =
        |play: &mut Play, workers: &mut Elsewhere| play.change_plots(|plots, run| plots.work_beside(run, workers));
    // The first slice is made here; then the page waits.
    assert!(!(work(&mut play, &mut workers) && work(&mut play, &mut workers)));
    assert_eq!((workers.given.len(), workers.given_up), (2, 0));
    // The swept parameter changes nothing.
    set(&mut play, "k", 0.5);
    work(&mut play, &mut workers);
    assert_eq!(workers.given_up, 0);
    // Another one makes what is computed stale; reports that are on their way are ignored.
    set(&mut play, "c", 1.5);
    work(&mut play, &mut workers);
    let after_first = workers.given_up;
    assert!(after_first > 0);
    set(&mut play, "c", 0.5);
    finish(&mut play, &mut workers);
    assert_eq!(csv(&mut play, 0), csv(&mut expected, 0));
    // A hidden plot computes nothing, and goes on when it is shown.
    set(&mut play, "c", 1.0);
    work(&mut play, &mut workers);
    work(&mut play, &mut workers);
    assert!(!workers.given.is_empty());
    play.change_plots(|plots, _| plots.show(PlotId::at(0), false));
    assert!(!work(&mut play, &mut workers));
    assert!(workers.given.is_empty());
    play.change_plots(|plots, _| plots.show(PlotId::at(0), true));
    finish(&mut play, &mut workers);
    let mut again = growth(LINES);
    finish_here(&mut again);
    assert_eq!(csv(&mut play, 0), csv(&mut again, 0));
    // Another program gives up what the one before had.
    set(&mut play, "c", 0.5);
    work(&mut play, &mut workers);
    work(&mut play, &mut workers);
    let before = workers.given_up;
    let mut other = growth(POINTS);
    work(&mut other, &mut workers);
    assert!(workers.given_up > before);
}

#[test]
fn plots_share_the_workers() {
    let both = format!("{LINES}{POINTS}");
    let mut here = growth(&both);
    let show = |play: &mut Play| play.change_plots(|plots, _| plots.show(PlotId::at(1), true));
    show(&mut here);
    finish_here(&mut here);
    let mut play = growth(&both);
    show(&mut play);
    let mut workers = Elsewhere::new(6);
    finish(&mut play, &mut workers);
    assert_eq!(workers.most, 6);
    for plot in 0..2 {
        assert_eq!(csv(&mut play, plot), csv(&mut here, plot));
    }
}
