//! The time line: the run and its clock, the rows for the plots, the runs kept for comparison.

mod ahead;
pub(crate) mod course;
mod keeping;
pub(crate) mod kept;
mod problem;
pub(crate) mod recipe;
pub(crate) mod transport;
mod words;

pub use course::Course;
pub use kept::{KeptValues, KeptView, MOST_KEPT};
pub use problem::Problem;
pub use transport::{LONGEST_GAP, SPEEDS, Status, WORK_PER_TICK};

use crate::plots::traces::{Columns, Traces};
use crate::{Basis, Changes};
use engine::Setup;
use figure::Interval;
use kept::{Ghost, Kept};
use program::{Model, Speed};

/// The run, its clock, and the runs drawn behind it.
#[derive(Debug)]
pub struct TimeLine {
    course: Course,
    /// Number of rows at the last frame.
    rows_seen: usize,
    /// Earliest time (SI) from which rows were discarded; see [`TimeLine::take_rewritten`].
    rewritten: Option<f64>,
    playing: bool,
    /// True if the run stopped because its memory limit was reached.
    full: bool,
    /// Playback speed of the document; `speed` is the chosen multiple of it.
    pace: Speed,
    speed: f64,
    slippage: f64,
    columns: Columns,
    traces: Traces,
    /// Range of each column in the first part of the run; `None` until it is needed.
    ahead: Option<Vec<Option<Interval>>>,
    /// Values of the columns at the moment shown, in their units.
    present: Vec<f64>,
    ghost: Option<Ghost>,
    kept: Vec<Kept>,
    /// Number of ids issued to kept runs, so that none is used twice.
    kept_issued: u32,
    /// Greatest magnitude of each state in this run, SI.
    scales: Vec<f64>,
}

impl TimeLine {
    /// The run of the document, paused at time 0.
    pub(crate) fn new(basis: &Basis) -> Self {
        let columns = Columns::new(basis.model(), &basis.program().plots);
        let course = Course::start(basis.model(), basis.defaults().clone(), columns.bytes_per_row());
        Self {
            course,
            rows_seen: 0,
            rewritten: None,
            playing: false,
            full: false,
            pace: basis.program().pace(),
            speed: 1.0,
            slippage: 0.0,
            columns,
            traces: Traces::default(),
            ahead: None,
            present: Vec::new(),
            ghost: None,
            kept: Vec::new(),
            kept_issued: 0,
            scales: vec![0.0; basis.model().states.len()],
        }
    }

    /// The run: its rows, parameters and state.
    pub fn course(&self) -> &Course {
        &self.course
    }

    /// The run, for reading between its rows.
    pub(crate) fn course_between_rows(&mut self) -> &mut Course {
        &mut self.course
    }

    /// Layout of the columns of the plots.
    pub(crate) fn columns(&self) -> &Columns {
        &self.columns
    }

    /// Columns of the plots, as far as they follow the run.
    pub(crate) fn traces(&self) -> &Traces {
        &self.traces
    }

    /// Values of the columns at the moment shown, in their units.
    pub(crate) fn present(&self) -> &[f64] {
        &self.present
    }

    /// Greatest magnitude of a state in this run, SI; 0 for an unknown index.
    pub fn greatest(&self, state: usize) -> f64 {
        self.scales.get(state).copied().unwrap_or_default()
    }

    /// Greatest magnitude of each state in this run, SI.
    pub(crate) fn scales(&self) -> &[f64] {
        &self.scales
    }

    /// Sets the greatest magnitudes of the states, SI, to those of the same run in another program.
    pub(crate) fn set_scales(&mut self, scales: Vec<f64>) {
        if scales.len() == self.scales.len() {
            self.scales = scales;
        }
    }

    /// Returns the earliest time (SI) from which rows were discarded since the last call: data read after it is
    /// invalid. `None` if no rows were discarded.
    pub(crate) fn take_rewritten(&mut self) -> Option<f64> {
        self.rewritten.take()
    }

    fn note_rewritten(&mut self, time: f64) {
        self.rewritten = Some(self.rewritten.map_or(time, |before| before.min(time)));
    }

    /// Must be called whenever the time, state or parameters shown have changed.
    fn moved(&mut self) -> Changes {
        let rows = self.course.rows();
        let changed = std::mem::replace(&mut self.rows_seen, rows) != rows;
        self.columns.present(&self.course, &mut self.present);
        for (scale, value) in self.scales.iter_mut().zip(self.course.state()) {
            if value.is_finite() {
                *scale = scale.max(value.abs());
            }
        }
        Changes::FRAME | Changes::ROWS.only_if(changed)
    }

    /// Shows the start for the first time.
    pub(crate) fn begin(&mut self) -> Changes {
        self.moved()
    }

    /// Updates the columns to the front of the run.
    pub(crate) fn follow(&mut self, basis: &Basis) {
        self.traces.follow(&self.course, &mut self.columns, &self.present);
        if self.ahead.is_none() {
            self.ahead = Some(ahead::ranges(basis, &self.course, &mut self.columns));
        }
    }

    /// Range of a column in the first part of the run, in its unit; `None` if it is not known.
    pub(crate) fn range_ahead(&self, column: usize) -> Option<Interval> {
        self.ahead.as_ref()?.get(column).copied().flatten()
    }

    /// Must be called when the model has changed.
    pub(crate) fn model_changed(&mut self, basis: &Basis) {
        self.ahead = None;
        self.columns = Columns::new(basis.model(), &basis.program().plots);
    }

    /// Starts another run.
    pub(crate) fn start(&mut self, model: &Model, setup: Setup) -> Changes {
        let course = Course::start(model, setup, self.columns.bytes_per_row());
        self.replace(course)
    }

    /// Replaces the run.
    pub(crate) fn replace(&mut self, course: Course) -> Changes {
        self.course = course;
        self.traces = Traces::default();
        self.ahead = None;
        self.note_rewritten(f64::NEG_INFINITY);
        // Starts from the initial state, so that the number of digits is the same whether the start was shown or a link
        // opened a later moment directly.
        for (scale, value) in self.scales.iter_mut().zip(self.course.initial()) {
            *scale = if value.is_finite() { value.abs() } else { 0.0 };
        }
        self.full = false;
        self.slippage = 0.0;
        self.playing &= self.course.error().is_none();
        Changes::ROWS | Changes::PARAMETERS | Changes::TRANSPORT | self.moved()
    }

    /// Presses a button at the moment shown, which must be the front.
    pub(crate) fn press(&mut self, button: usize) -> Changes {
        let time = self.course.time();
        self.course.press(button);
        self.note_rewritten(time);
        Changes::TRANSPORT | Changes::PARAMETERS | self.moved()
    }

    /// Changes parameters (SI) from the moment shown on, which must be the front. None may decide an initial value.
    pub(crate) fn set_parameters(&mut self, model: &Model, parameters: Vec<f64>) -> Changes {
        self.course.give_up_presses();
        self.course.set_parameters(model, parameters);
        self.traces.truncate(self.course.rows().saturating_sub(1));
        Changes::TRANSPORT | self.moved()
    }

    /// Takes over the run of another program unchanged; `with_columns` if its columns have the same values.
    pub(crate) fn adopt_run(&mut self, basis: &Basis, before: &mut Self, with_columns: bool) -> Changes {
        let nothing = Course::start(basis.model(), basis.defaults().clone(), 0);
        self.course = std::mem::replace(&mut before.course, nothing);
        self.course.set_overhead(self.columns.bytes_per_row());
        self.full = before.full;
        self.slippage = before.slippage;
        if let Some(time) = before.take_rewritten() {
            self.note_rewritten(time);
        }
        if with_columns {
            self.traces = std::mem::take(&mut before.traces);
        }
        // The magnitudes of states determine their number format.
        self.scales.clone_from(&before.scales);
        self.moved()
    }

    /// Takes over the speed of the time line of another program.
    pub(crate) fn adopt_speed(&mut self, before: &Self) {
        self.speed = before.speed;
    }

    /// Takes over the ghost of a program with the same curves, and plays on as the former program did. `kept_issued`
    /// continues.
    pub(crate) fn adopt_rest(&mut self, before: &mut Self, same_curves: bool) {
        if same_curves {
            self.ghost = before.ghost.take();
        }
        self.playing = before.playing && self.course.history().is_some() && self.course.error().is_none();
        self.kept_issued = before.kept_issued;
    }
}
