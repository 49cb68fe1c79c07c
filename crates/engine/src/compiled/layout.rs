//! Places of the numbers that compiled code of a fixed-step method reads and writes.

/// Indices into the block of numbers that compiled code shares with the engine. All values are in SI units; lists of states
/// and rates are in the order of the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Number of registers, which begin the block. The code reads those that no operation of the listing writes, except
    /// the registers of the independent variable and of the states.
    pub registers: usize,
    /// Number of states.
    pub states: usize,
    /// Number of rows of results: the maximum number of steps of a fixed-step method in one run of the code.
    pub rows: usize,
}

impl Layout {
    /// Number of the first step, in units of [`Layout::spacing`]: step `k` begins at the time `(first + k) * spacing`.
    pub const fn first(self) -> usize {
        self.registers
    }

    /// Distance of the times at which steps begin.
    pub const fn spacing(self) -> usize {
        self.registers + 1
    }

    /// Size of a step.
    pub const fn size(self) -> usize {
        self.registers + 2
    }

    /// First state at the start.
    pub const fn from(self) -> usize {
        self.registers + 3
    }

    /// First state at the end of step `k`.
    pub const fn row(self, k: usize) -> usize {
        self.from() + (1 + k) * self.states
    }

    /// First of the numbers that code may use for itself, [`Layout::OWN`] for each state.
    pub const fn own(self) -> usize {
        self.row(self.rows)
    }

    /// Number of lists with a number for each state that code may use for itself: states, and rates of each stage.
    pub const OWN: usize = 5;

    /// Length of the block.
    pub(super) fn len(self) -> usize {
        self.own() + Self::OWN * self.states
    }
}
