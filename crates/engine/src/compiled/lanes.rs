//! Runs side by side in compiled code: what is compiled, and the numbers that it works on.

use super::Compiled;
use super::layout::Layout;
use super::listing::{Formulas, Listing};
use super::side_by_side::LANES;

/// Number of runs whose numbers stand together.
const TOGETHER: usize = 2;

/// Maximum number of rows that are made at once.
const MOST_ROWS: usize = 256;

/// Maximum number of values in these rows, for a run.
const MOST_VALUES: usize = 512;

/// Steps for [`LANES`] runs, and what is read at each row.
#[derive(Clone, Debug, PartialEq)]
pub struct LanesListing {
    /// The steps. The layout of a fixed-step method is that of a single run; a window of the Dormand-Prince method has the record of
    /// the last step only, and neither steps nor rows.
    pub steps: Listing,
    /// Formulas that are read at each row; their interpolations follow those of the steps in the list that both share.
    pub readings: Formulas,
    /// True if events, switches or timed changes can act in a step of the Dormand-Prince method.
    pub checked: bool,
    /// The block of a pair of runs.
    pub layout: LanesLayout,
}

/// Indices into the numbers of a pair of runs. At each place stand two numbers, one for each run; the numbers of one pair follow
/// those of the pair before. SI units; states are in the order of the model. The block of the steps comes first: that of a
/// fixed-step method, whose states are replaced by those after the last step, or the window of the Dormand-Prince method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LanesLayout {
    /// Registers, settings and states of the steps of a fixed-step method.
    pub steps: Layout,
    /// First place after the block of the steps.
    rest: usize,
    /// Number of registers of what is read.
    registers: usize,
    /// Number of values that are read at a row.
    pub values: usize,
    /// Maximum number of rows.
    pub rows: usize,
}

impl LanesLayout {
    pub(super) fn new(listing: &Listing, readings: &Formulas) -> Self {
        let values = readings.roots.len();
        let rows = (MOST_VALUES / values.max(1)).clamp(1, MOST_ROWS);
        let rest = listing.window.as_ref().map_or(listing.layout.row(0), |window| window.layout.row(0));
        Self { steps: listing.layout, rest, registers: readings.registers, values, rows }
    }

    /// Index of the grid point before row 0. Steps of the Dormand-Prince method have this place and those up to
    /// [`LanesLayout::since`].
    pub const fn base(self) -> usize {
        self.rest
    }

    /// Index of the grid point at which the run pauses.
    pub const fn limit(self) -> usize {
        self.rest + 1
    }

    /// Reason why the run has stopped, a result: 0 if it has not, 1 if a check has failed, 2 if a step is too small or there are too many
    /// of them since the last row.
    pub const fn stopped(self) -> usize {
        self.rest + 2
    }

    /// 1 if the last attempt of a step was not accepted.
    pub const fn rejected(self) -> usize {
        self.rest + 3
    }

    /// Number of steps since the last row.
    pub const fn since(self) -> usize {
        self.rest + 4
    }

    /// First register of what is read.
    pub const fn readings(self) -> usize {
        self.rest + 5
    }

    /// First value at row `k`: the one after step `k` of a fixed-step method, and the one after the grid point `base + k` of the
    /// Dormand-Prince method.
    pub const fn row(self, k: usize) -> usize {
        self.readings() + self.registers + k * self.values
    }

    /// Number of places.
    pub const fn places(self) -> usize {
        self.row(self.rows)
    }
}

/// The numbers of all runs.
#[derive(Debug)]
pub(crate) struct Numbers {
    /// Number of places of a pair.
    places: usize,
    numbers: Vec<f64>,
}

impl Numbers {
    pub fn new(layout: LanesLayout) -> Self {
        Self { places: layout.places(), numbers: vec![0.0; LANES * layout.places()] }
    }

    fn at(&self, run: usize, place: usize) -> usize {
        (run / TOGETHER * self.places + place) * TOGETHER + run % TOGETHER
    }

    /// Number of a run at a place.
    pub fn get(&self, run: usize, place: usize) -> f64 {
        self.numbers[self.at(run, place)]
    }

    /// Sets numbers of a run from a place on.
    pub fn set(&mut self, run: usize, place: usize, numbers: &[f64]) {
        let first = self.at(run, place);
        self.numbers[first..].iter_mut().step_by(TOGETHER).zip(numbers).for_each(|(to, number)| *to = *number);
    }

    /// Copies numbers of a run from a place on.
    pub fn copy(&self, run: usize, place: usize, out: &mut [f64]) {
        let first = self.at(run, place);
        out.iter_mut().zip(self.numbers[first..].iter().step_by(TOGETHER)).for_each(|(to, number)| *to = *number);
    }

    /// Runs code over them.
    pub fn run(&mut self, code: &dyn Compiled, count: u32) -> u32 {
        code.run(&mut self.numbers, count)
    }
}
