//! Intervals between rows and ends of steps.

use crate::checks::passed;
use crate::grid::{Block, Grid, WIDTH};

/// Intervals of the lanes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Intervals {
    /// Times reached, and times of the ends.
    pub from: Grid,
    pub to: Grid,
    /// States there.
    pub present: Grid,
    pub next: Grid,
    /// 1 for lanes that have an interval, and for those whose checks fail.
    pub ready: Vec<Block>,
    pub failed: Vec<Block>,
}

impl Intervals {
    /// Begins all lanes at 0 with these states, SI units.
    pub fn begin(&mut self, initial: &Grid) {
        let blocks = initial.blocks();
        if self.ready.len() != blocks {
            [self.from, self.to] = [Grid::new(1, blocks), Grid::new(1, blocks)];
            self.next = Grid::new(initial.rows(), blocks);
        }
        self.from.fill(0, 0.0);
        self.present.clone_from(initial);
        for list in [&mut self.ready, &mut self.failed] {
            list.clear();
            list.resize(blocks, Block::of(0.0));
        }
    }

    /// True if a lane has an interval in which nothing can have happened.
    #[inline(always)]
    pub fn passed(&self, lane: usize) -> bool {
        let number = |blocks: &[Block]| blocks[lane / WIDTH].0[lane % WIDTH];
        number(&self.ready) != 0.0 && number(&self.failed) == 0.0
    }

    /// Moves the lanes that have passed to the ends of their intervals.
    pub fn accept(&mut self) {
        let passed = passed(&self.ready, &self.failed);
        for row in 0..self.present.rows() {
            let (present, next) = (self.present.row_mut(row), self.next.row(row));
            for ((present, next), passed) in present.iter_mut().zip(next).zip(&passed) {
                *present = passed.choose(*next, *present);
            }
        }
        for ((from, to), passed) in self.from.row_mut(0).iter_mut().zip(self.to.row(0)).zip(&passed) {
            *from = passed.choose(*to, *from);
        }
    }
}
