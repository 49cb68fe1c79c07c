//! Checkpoints of a run with an adaptive method. The next step of such a method depends on the previous ones. To continue
//! from an earlier row with the same bits, the steps from the last checkpoint before it are made again.

use crate::methods::stepper::{Moment, Stepper};

/// Checkpoints of a run. Their spacing limits both the memory and the time to go back.
#[derive(Clone, Debug)]
pub(crate) struct Checkpoints {
    /// Ascending by row; the first one is the start.
    list: Vec<Checkpoint>,
    /// Minimum work between two checkpoints, in floating-point operations.
    spacing: u64,
}

#[derive(Clone, Debug)]
struct Checkpoint {
    /// Index of the last row.
    row: usize,
    /// Work of the stepper up to here, in floating-point operations.
    work: u64,
    moment: Moment,
}

impl Checkpoints {
    /// Initial spacing, in floating-point operations: some milliseconds.
    const SPACING: u64 = 2_000_000;
    /// Maximum number of checkpoints; beyond it every other one is dropped.
    const MOST: usize = 64;
    /// Maximum memory, in bytes.
    const BYTES: usize = 4 << 20;

    /// Checkpoints of a run at its start.
    pub fn new(stepper: &Stepper) -> Self {
        let start = Checkpoint { row: 0, work: stepper.work(), moment: stepper.moment() };
        Self { list: vec![start], spacing: Self::SPACING }
    }

    /// Adds a checkpoint of the present moment if it is far enough from the last one; `row` is the last row of the run.
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

    /// The last checkpoint at or before `row`: its row and moment. Later checkpoints are dropped.
    pub fn back_to(&mut self, row: usize, work: u64) -> Option<(usize, &Moment)> {
        self.list.retain(|one| one.row <= row);
        let last = self.list.last_mut()?;
        // The work counter never goes back: repeated steps count again.
        last.work = work;
        Some((last.row, &last.moment))
    }

    /// Drops the checkpoints before row `dropped` and renumbers the others.
    pub fn forget(&mut self, dropped: usize) {
        self.list.retain_mut(|one| {
            let stays = one.row >= dropped;
            one.row = one.row.saturating_sub(dropped);
            stays
        });
    }
}
