//! What is known of each lane.

use crate::alone::LastRow;
use crate::grid::{Grid, WIDTH};
use engine::RunError;

/// Progress and last row of each lane. Rows of a grid: one for each parameter or state, SI units.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lanes {
    /// Number of runs, and of blocks for which there is room.
    pub runs: usize,
    pub blocks: usize,
    pub parameters: Grid,
    /// Initial values.
    pub initial: Grid,
    /// True while a lane is computed.
    pub running: Vec<bool>,
    /// Index of the last row reached.
    pub index: Vec<u64>,
    /// Number of steps since that row.
    pub steps: Vec<usize>,
    /// Number of times that a lane has left.
    pub left: Vec<u64>,
    /// Time and states of the last row that is taken.
    pub last_time: Grid,
    pub last: Grid,
    pub errors: Vec<Option<RunError>>,
    /// Values that are read at a row.
    pub values: Vec<f64>,
}

impl Lanes {
    /// Lanes with room for so many parameters, states and blocks; `values` are read at each row.
    pub fn new(parameters: usize, states: usize, blocks: usize, values: usize) -> Self {
        Self {
            blocks,
            parameters: Grid::new(parameters, blocks),
            initial: Grid::new(states, blocks),
            last_time: Grid::new(1, blocks),
            last: Grid::new(states, blocks),
            values: vec![0.0; values],
            ..Self::default()
        }
    }

    /// Begins the runs at their first rows.
    pub fn begin(&mut self) {
        let count = self.blocks * WIDTH;
        self.running.clear();
        self.running.extend((0..count).map(|lane| lane < self.runs));
        self.index.clear();
        self.index.resize(count, 0);
        self.steps.clear();
        self.steps.resize(count, 0);
        self.left.clear();
        self.left.resize(count, 0);
        self.errors.clear();
        self.errors.resize(count, None);
        self.last_time.fill(0, 0.0);
        self.last.clone_from(&self.initial);
    }

    /// Parameters and initial values of a lane.
    pub fn begun(&self, lane: usize) -> [Vec<f64>; 2] {
        [self.parameters.list(lane), self.initial.list(lane)]
    }

    /// Keeps the state of a lane as that of its last row.
    pub fn keep(&mut self, lane: usize, time: f64, states: &Grid) {
        self.last_time.set(0, lane, time);
        (0..states.rows()).for_each(|row| self.last.set(row, lane, states.get(row, lane)));
    }

    /// Last row of a lane.
    pub fn last_row(&self, lane: usize) -> LastRow {
        LastRow { time: self.last_time.get(0, lane), state: self.last.list(lane) }
    }

    /// Replaces the last row of a lane.
    pub fn set_last_row(&mut self, lane: usize, row: &LastRow) {
        self.last_time.set(0, lane, row.time);
        self.last.set_lane(lane, &row.state);
    }

    /// Ends a lane.
    pub fn end(&mut self, lane: usize, result: Result<(), RunError>) {
        self.running[lane] = false;
        self.errors[lane] = result.err();
    }
}
