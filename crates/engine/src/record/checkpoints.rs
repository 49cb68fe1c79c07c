//! Moments from which a run with an adaptive method can go on with the same bits. What such a method does next depends on the
//! steps behind it, so that going on from an earlier row means to make the steps before it again, from a checkpoint on.

use crate::methods::stepper::{Moment, Stepper};

/// Checkpoints, sparse enough for memory and dense enough for going back within a moment.
#[derive(Clone, Debug)]
pub(crate) struct Checkpoints {
    /// Ascending; the first one is the start.
    list: Vec<Checkpoint>,
    /// The least work between two of them.
    spacing: u64,
}

#[derive(Clone, Debug)]
struct Checkpoint {
    /// The row at which the run stood.
    row: usize,
    /// What the stepper had worked until then.
    work: u64,
    moment: Moment,
}

impl Checkpoints {
    /// The work between the first ones: some milliseconds.
    const SPACING: u64 = 2_000_000;
    /// How many there are at most; then every other one is given up.
    const MOST: usize = 64;
    /// The memory they may take.
    const BYTES: usize = 4 << 20;

    /// Those of a run that stands at its start.
    pub fn new(stepper: &Stepper) -> Self {
        let start = Checkpoint { row: 0, work: stepper.work(), moment: stepper.moment() };
        Self { list: vec![start], spacing: Self::SPACING }
    }

    /// Adds the present moment, `row` being the last row of the run, if it is far enough from the last checkpoint.
    pub fn note(&mut self, stepper: &Stepper, row: usize) {
        let work = stepper.work();
        if self.list.last().is_some_and(|last| work.saturating_sub(last.work) < self.spacing) {
            return;
        }
        self.list.push(Checkpoint { row, work, moment: stepper.moment() });
        let bytes = |list: &[Checkpoint]| list.iter().map(|one| one.moment.bytes()).sum::<usize>();
        if self.list.len() > Self::MOST || bytes(&self.list) > Self::BYTES {
            let mut index = 0;
            self.list.retain(|_| {
                index += 1;
                index % 2 == 1
            });
            self.spacing *= 2;
        }
    }

    /// The last moment at or before `row`, and its row; what lies after it is forgotten.
    pub fn back_to(&mut self, row: usize, work: u64) -> Option<(usize, &Moment)> {
        self.list.retain(|one| one.row <= row);
        let last = self.list.last_mut()?;
        // Work is counted on, also for what is done twice.
        last.work = work;
        Some((last.row, &last.moment))
    }

    /// Rows are counted from `dropped` on.
    pub fn forget(&mut self, dropped: usize) {
        self.list.retain_mut(|one| {
            let stays = one.row >= dropped;
            one.row = one.row.saturating_sub(dropped);
            stays
        });
    }
}
