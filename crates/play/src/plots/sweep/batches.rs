//! Batches of runs in the hands of workers. They are drawn in the order of the parameter values, whoever is ready first.

use super::runs::FEW;
use super::taking::TakenRun;
use engine::LANES;
use std::collections::VecDeque;
use std::ops::Range;

/// Batches of one plot in the order of their runs, without gaps between them.
#[derive(Debug, Default)]
pub(super) struct Batches {
    list: VecDeque<Batch>,
    /// Number of runs of a batch, once the first one is handed out.
    size: usize,
}

/// Runs that a worker makes.
#[derive(Debug)]
struct Batch {
    /// Its number among the batches of all plots.
    number: u32,
    /// Numbers of the runs that are neither drawn nor waiting.
    missing: Range<usize>,
    /// Values and points of the runs that wait to be drawn.
    waiting: Vec<TakenRun>,
}

impl Batches {
    /// Forgets all batches; what comes of them is ignored.
    pub fn clear(&mut self) {
        self.list.clear();
        self.size = 0;
    }

    /// Numbers of the batches in progress.
    pub fn in_progress(&self) -> impl Iterator<Item = u32> {
        self.list.iter().filter(|batch| !batch.missing.is_empty()).map(|batch| batch.number)
    }

    /// Runs of the next batch, of those with the numbers `open` that are not drawn; `None` if all are handed out. `workers`, at
    /// least 1, share all runs equally.
    pub fn next(&mut self, open: Range<usize>, workers: usize) -> Option<Range<usize>> {
        if self.list.is_empty() {
            let batches = open.len().div_ceil(LANES).next_multiple_of(workers);
            let least = if open.len() < FEW { 1 } else { FEW };
            self.size = open.len().div_ceil(batches.max(1)).max(least);
        }
        let first = self.list.back().map_or(open.start, |batch| batch.missing.end);
        let next = first..open.end.min(first + self.size);
        (!next.is_empty()).then_some(next)
    }

    /// Adds the batch of these runs.
    pub fn add(&mut self, number: u32, runs: Range<usize>) {
        self.list.push_back(Batch { number, missing: runs, waiting: Vec::new() });
    }

    /// Takes what is taken from further runs of a batch, in their order.
    pub fn take(&mut self, number: u32, runs: &[TakenRun]) {
        if let Some(batch) = self.list.iter_mut().find(|batch| batch.number == number) {
            let runs = &runs[..runs.len().min(batch.missing.len())];
            batch.missing.start += runs.len();
            batch.waiting.extend_from_slice(runs);
        }
    }

    /// Removes and returns the runs that can be drawn: those up to the first one that is missing.
    pub fn ready(&mut self) -> Vec<TakenRun> {
        let mut ready = Vec::new();
        while let Some(batch) = self.list.front_mut() {
            ready.append(&mut batch.waiting);
            if !batch.missing.is_empty() {
                break;
            }
            self.list.pop_front();
        }
        ready
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn workers_share_the_runs_equally() {
        // Ends of the batches; each begins where the one before ends.
        for (open, workers, ends) in [
            (0..0, 2, &[][..]),
            (0..1, 2, &[1]),
            (0..14, 1, &[14]),
            (0..14, 2, &[7, 14]),
            (3..18, 4, &[7, 11, 15, 18]),
            // Fewer than 16 runs are not made side by side.
            (0..20, 2, &[16, 20]),
            (1..101, 2, &[51, 101]),
            (0..150, 2, &[38, 76, 114, 150]),
            (0..192, 3, &[64, 128, 192]),
        ] {
            let mut batches = Batches::default();
            let mut found = vec![open.start];
            while let Some(runs) = batches.next(open.clone(), workers) {
                assert_eq!(Some(&runs.start), found.last());
                batches.add(0, runs.clone());
                found.push(runs.end);
            }
            assert_eq!(found[1..], *ends, "{open:?} by {workers}");
        }
    }

    #[test]
    fn runs_are_ready_up_to_the_first_one_that_is_missing() {
        let runs = |values: Range<usize>| {
            let run = |value| TakenRun { points: vec![value as f64], values: Vec::new() };
            values.map(run).collect::<Vec<_>>()
        };
        let mut batches = Batches::default();
        batches.add(7, 0..3);
        batches.add(8, 3..5);
        batches.take(8, &runs(3..4));
        assert_eq!(batches.ready(), []);
        batches.take(7, &runs(0..2));
        // A number that is not known is ignored.
        batches.take(9, &runs(0..2));
        assert_eq!(batches.ready(), runs(0..2));
        batches.take(8, &runs(4..5));
        assert_eq!(batches.ready(), []);
        assert_eq!(batches.in_progress().collect::<Vec<_>>(), [7]);
        // More runs than a batch has are ignored.
        batches.take(7, &runs(2..9));
        assert_eq!(batches.ready(), runs(2..5));
        assert_eq!((batches.ready(), batches.in_progress().count()), (Vec::new(), 0));
        batches.add(10, 5..6);
        batches.clear();
        batches.take(10, &runs(5..6));
        assert_eq!(batches.ready(), []);
    }
}
