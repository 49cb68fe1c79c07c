//! Places of the numbers that compiled code of the Dormand-Prince method reads and writes.

/// Indices into the block of numbers of a window: steps of the Dormand-Prince method with the rows in them. All values are in
/// SI units; lists of states, rates and dense coefficients are in the order of the model.
///
/// Record 0 is the step made last before the window, with the time reached in it; records 1 and later are those of the
/// window. In a record only the numbers of states that move are written, see [`Listing::still`](crate::Listing::still).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WindowLayout {
    /// Number of registers of the right-hand side, which begin the block.
    pub registers: usize,
    /// Number of states.
    pub states: usize,
    /// Number of events.
    pub events: usize,
    /// Number of switches.
    pub switches: usize,
    /// Number of values compared in conditions.
    pub compared: usize,
    /// Number of registers of each list of formulas, in the order of [`WindowListing::formulas`](crate::WindowListing).
    pub formulas: [usize; 5],
    /// Maximum number of steps.
    pub steps: usize,
    /// Maximum number of rows.
    pub rows: usize,
}

impl WindowLayout {
    /// Time reached.
    pub const fn time(self) -> usize {
        self.registers
    }

    /// Index of the grid point before the first row.
    pub const fn index(self) -> usize {
        self.registers + 1
    }

    /// Distance of the rows.
    pub const fn spacing(self) -> usize {
        self.registers + 2
    }

    /// Upper bound of the step.
    pub const fn longest(self) -> usize {
        self.registers + 3
    }

    /// Tolerance relative to the magnitude of each state.
    pub const fn tolerance(self) -> usize {
        self.registers + 4
    }

    /// Lower bound of that magnitude as a fraction of the peak.
    pub const fn below_peak(self) -> usize {
        self.registers + 5
    }

    /// Number of steps made, a result.
    pub const fn made(self) -> usize {
        self.registers + 6
    }

    /// First lower bound of the magnitude of a state.
    pub const fn floors(self) -> usize {
        self.registers + 7
    }

    /// First state at the time reached.
    pub const fn present(self) -> usize {
        self.floors() + self.states
    }

    /// First event: 1 if its condition must stay false, 0 if it must stay true.
    pub const fn armed(self) -> usize {
        self.present() + self.states
    }

    /// First held value of a switch.
    pub const fn held(self) -> usize {
        self.armed() + self.events
    }

    /// First compared value at the time reached; their rates of change follow.
    pub const fn values(self) -> usize {
        self.held() + self.switches
    }

    /// First register of a list of formulas.
    pub fn formula(self, number: usize) -> usize {
        self.values() + 2 * self.compared + self.formulas[..number].iter().sum::<usize>()
    }

    /// First estimated error of a single attempt.
    pub fn error(self) -> usize {
        self.formula(self.formulas.len())
    }

    /// First of the numbers that code may use for itself, [`WindowLayout::OWN`] for each state.
    pub fn own(self) -> usize {
        self.error() + self.states
    }

    /// Number of lists with a number for each state that code may use for itself: the numbers of a record, the rates of all stages but
    /// one, three states, lower bounds of magnitudes, and errors.
    pub const OWN: usize = 19;

    /// First number of a record: start, size and end of the step, size proposed for the next one, error in units of the
    /// allowed error, number of attempts since the begin of the window.
    pub fn record(self, number: usize) -> usize {
        self.own() + Self::OWN * self.states + number * self.record_len()
    }

    /// First state at the end of the step, counted from the record.
    pub const fn to(self) -> usize {
        6
    }

    /// First peak of a state, counted from the record.
    pub const fn peaks(self) -> usize {
        6 + self.states
    }

    /// First rate at the end of the step, counted from the record.
    pub const fn rates(self) -> usize {
        6 + 2 * self.states
    }

    /// First coefficient of degree `degree`, 0 to 4, of the continuous solution, counted from the record.
    pub const fn dense(self, degree: usize) -> usize {
        6 + (3 + degree) * self.states
    }

    /// Length of a record.
    pub const fn record_len(self) -> usize {
        6 + 8 * self.states
    }

    /// First number of a row: number of its record, number of intervals up to it, compared values with their rates of
    /// change, states.
    pub fn row(self, number: usize) -> usize {
        self.record(1 + self.steps) + number * self.row_len()
    }

    /// First state of a row, counted from the row.
    pub const fn row_states(self) -> usize {
        2 + 2 * self.compared
    }

    /// Length of a row.
    pub const fn row_len(self) -> usize {
        self.row_states() + self.states
    }

    /// Length of the block.
    pub(super) fn len(self) -> usize {
        self.row(self.rows)
    }
}
