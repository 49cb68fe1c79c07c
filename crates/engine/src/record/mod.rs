//! Recording of a run.

pub mod csv;
pub mod table;

pub(crate) mod checkpoints;
pub(crate) mod folds;
pub(crate) mod history;
pub(crate) mod ranges;
pub(crate) mod readings;

/// Receiver of the rows of a run in progress.
pub trait Record {
    /// Takes a row: time and state (SI units), and true if the state jumped there from the row before.
    fn row(&mut self, time: f64, state: &[f64], jumped: bool);

    /// Takes additional data of the last row, which follows a jump.
    fn after_jump(&mut self, _after: AfterJump) {}
}

/// Data right after a jump that are needed, besides time, state and parameters, to continue with the same bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AfterJump {
    /// True for each event that can fire again. False if its action has not kept its condition from becoming true.
    pub armed: Vec<bool>,
    /// True if the next step begins on the grid. False after an event so close to a grid point that both have the same
    /// time.
    pub on_grid: bool,
    /// Number of presses that have acted.
    pub presses: usize,
}

impl<F: FnMut(f64, &[f64], bool)> Record for F {
    fn row(&mut self, time: f64, state: &[f64], jumped: bool) {
        self(time, state, jumped);
    }
}
