//! Who receives the rows of a run.

pub mod csv;
pub mod table;

pub(crate) mod checkpoints;
pub(crate) mod history;
pub(crate) mod ranges;
pub(crate) mod readings;

/// Receives the rows of a run while it is made.
pub trait Record {
    /// A row: time, state, and whether the state jumped there from the row before.
    fn row(&mut self, time: f64, state: &[f64], jumped: bool);

    /// What the last row, which a jump has left, does not tell by itself.
    fn after_jump(&mut self, _after: AfterJump) {}
}

/// What must be known right after a jump to go on with the same bits, besides time, state and parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AfterJump {
    /// For each event whether it can fire again. One whose action has not kept its condition from becoming true is used up.
    pub armed: Vec<bool>,
    /// Whether the next step begins on the grid. After an event so soon behind a point of the grid that their times are
    /// equal it does not.
    pub on_grid: bool,
    /// How many presses have acted.
    pub presses: usize,
}

impl<F: FnMut(f64, &[f64], bool)> Record for F {
    fn row(&mut self, time: f64, state: &[f64], jumped: bool) {
        self(time, state, jumped);
    }
}
