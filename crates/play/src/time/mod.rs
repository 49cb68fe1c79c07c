//! The time line: the run and its clock, the rows for the plots, the runs kept for comparison.

mod adopting;
mod ahead;
pub(crate) mod course;
mod keeping;
pub(crate) mod kept;
mod problem;
pub(crate) mod recipe;
pub(crate) mod transport;
mod words;

pub(crate) use adopting::PassedLine;
pub use course::Course;
pub use kept::{KeptValues, KeptView, MOST_KEPT};
pub use problem::Problem;
pub use transport::{LONGEST_GAP, SPEEDS, Status, WORK_PER_TICK};

use crate::motion::Motion;
use crate::plots::traces::{Columns, Traces};
use crate::removed::Removed;
use crate::{Announcement, Basis, Changes};
use engine::{Compiler, Setup};
use figure::Interval;
use kept::{Ghost, Kept};
use program::{Parameter, Speed};
use std::rc::Rc;

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
    /// End of the run set by the document, SI.
    until: Option<f64>,
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
    /// Compiles the steps of runs; `None`: they are interpreted.
    compiler: Option<Rc<dyn Compiler>>,
}

impl TimeLine {
    /// The run of the document, paused at time 0.
    pub(crate) fn new(basis: &Basis) -> Self {
        let columns = Columns::new(basis.model(), &basis.program().plots);
        let course = Course::start(Motion::new(basis.model(), None), basis.defaults().clone(), columns.bytes_per_row());
        Self {
            course,
            rows_seen: 0,
            rewritten: None,
            playing: false,
            full: false,
            pace: basis.program().pace(),
            speed: 1.0,
            until: basis.program().until,
            slippage: 0.0,
            columns,
            traces: Traces::default(),
            ahead: None,
            present: Vec::new(),
            ghost: None,
            kept: Vec::new(),
            kept_issued: 0,
            scales: vec![0.0; basis.model().states.len()],
            compiler: None,
        }
    }

    /// The run: its rows, parameters and state.
    pub fn course(&self) -> &Course {
        &self.course
    }

    /// True once a step of the run has been recorded.
    pub fn has_run(&self) -> bool {
        self.course.rows() > 1
    }

    /// The run, for reading between its rows.
    pub(crate) fn course_between_rows(&mut self) -> &mut Course {
        &mut self.course
    }

    /// Makes the steps of the run and of later ones with compiled code from now on. All bits stay the same.
    pub fn use_compiler(&mut self, compiler: Rc<dyn Compiler>) -> Changes {
        self.course.compile(compiler.as_ref());
        self.compiler = Some(compiler);
        Changes::NONE
    }

    /// The equations of motion, from which runs are started.
    pub(crate) fn motion<'a>(&'a self, basis: &'a Basis) -> Motion<'a> {
        Motion::new(basis.model(), self.compiler.as_ref())
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

    /// Writes the state (SI) at a recorded time (SI) into `out`, interpolated between rows. Returns the parameters (SI)
    /// in force then; `None` if the run could not start. Nothing changes but what is kept for the next call.
    pub fn state_at(&mut self, time: f64, out: &mut [f64]) -> (Option<Vec<f64>>, Changes) {
        (self.course.state_at(time, out), Changes::NONE)
    }

    /// Returns the earliest time (SI) from which rows were discarded since the last call: data read after it is
    /// invalid. `None` if no rows were discarded.
    pub fn take_rewritten(&mut self) -> (Option<f64>, Changes) {
        (self.rewritten.take(), Changes::NONE)
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
    fn follow_rows(&mut self) {
        self.traces.follow(&self.course, &mut self.columns, &self.present);
    }

    /// Updates what is drawn of the run: the columns to its front, and their range in its first part.
    pub(crate) fn follow(&mut self, basis: &Basis) {
        self.follow_rows();
        if self.ahead.is_none() {
            self.ahead = {
                let motion = Motion::new(basis.model(), self.compiler.as_ref());
                Some(ahead::ranges(basis, motion, &self.course, &mut self.columns))
            };
        }
    }

    /// Range of a column in the first part of the run, in its unit; `None` if it is not known.
    pub(crate) fn range_ahead(&self, column: usize) -> Option<Interval> {
        self.ahead.as_ref()?.get(column).copied().flatten()
    }

    /// Must be called when the model has changed.
    pub(crate) fn model_changed(&mut self, basis: &Basis) {
        self.ahead = None;
        self.traces = Traces::default();
        self.columns = Columns::new(basis.model(), &basis.program().plots);
        self.columns.present(&self.course, &mut self.present);
    }

    /// True if all sizes and parameters have the values of the document, and the run starts with its initial values and
    /// curves.
    pub fn is_as_written(&self, basis: &Basis) -> bool {
        self.starts_as_written(basis)
            && basis.sizes().iter().all(|size| size.is_default)
            && basis.parameters(&self.course).iter().all(|parameter| parameter.is_default)
    }

    /// True if the run starts with the document's initial values and curves.
    pub(crate) fn starts_as_written(&self, basis: &Basis) -> bool {
        !self.course.is_started_by_hand() && self.course.begun().drawings == basis.defaults().drawings
    }

    /// Settings of the present run, with the parameters shown.
    pub(crate) fn setup(&self) -> Setup {
        Setup { parameters: self.course.parameters().to_vec(), ..self.course.begun().clone() }
    }

    /// Starts another run. The present one becomes the ghost if it is long enough to be seen.
    pub(crate) fn restart(&mut self, basis: &Basis, mut setup: Setup) -> Changes {
        // Presses belong to the former run.
        setup.presses.clear();
        let changes = self.keep_ghost(0);
        let course = Course::start(self.motion(basis), setup, self.columns.bytes_per_row());
        changes | self.replace(course)
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
        let changes = Changes::NEW_RUN | Changes::ROWS | Changes::PARAMETERS | Changes::TRANSPORT | self.moved();
        if self.course.error().is_some() { changes.announcing(Announcement::Failed) } else { changes }
    }

    /// Presses a button at the moment shown. If an earlier moment is shown, the run continues from there and the later
    /// rows become the ghost. A part of the scene that is dragged is released.
    pub(crate) fn press(&mut self, button: usize) -> Changes {
        let (time, changes) = (self.course.time(), self.branch());
        self.course.press(button);
        self.note_rewritten(time);
        let changes = changes | Changes::RELEASED | Changes::TRANSPORT | Changes::PARAMETERS | self.moved();
        let changes = changes.announcing(Announcement::Pressed(button, time));
        if self.playing && self.course.error().is_some() {
            (changes | self.stop()).announcing(Announcement::Failed)
        } else {
            changes
        }
    }

    /// Sets all parameters (SI) from the moment shown on. Restarts the run if an initial value depends on a changed one.
    pub(crate) fn set_parameters(&mut self, basis: &Basis, parameters: Vec<f64>) -> Changes {
        let old = self.course.parameters();
        if old == parameters {
            return Changes::NONE;
        }
        let deciding = |(index, parameter): (usize, &Parameter)| {
            (parameter.restarts && old.get(index) != parameters.get(index)).then_some(index)
        };
        let decides = basis.model().parameters.iter().enumerate().find_map(deciding);
        if decides.is_some() || self.course.history().is_none() {
            let begun = self.course.front() > 0.0 || self.course.is_started_by_hand();
            let setup = Setup { parameters, start: None, ..self.course.begun().clone() };
            let changes = Changes::PARAMETERS | self.restart(basis, setup);
            return match decides.filter(|_| begun) {
                Some(index) => changes.announcing(Announcement::Restarted(index)),
                None => changes,
            };
        }
        let changes = self.branch();
        self.course.give_up_presses();
        self.course.set_parameters(Motion::new(basis.model(), self.compiler.as_ref()), parameters);
        self.traces.truncate(self.course.rows().saturating_sub(1));
        changes | Changes::PARAMETERS | Changes::TRANSPORT | self.moved()
    }

    /// Sets all parameters (SI) at once; can be undone.
    pub(crate) fn overwrite_parameters(&mut self, basis: &Basis, parameters: Vec<f64>) -> Changes {
        let before = self.course.parameters().to_vec();
        if before == parameters {
            return Changes::SETTLED;
        }
        self.set_parameters(basis, parameters).removing(Removed::Parameters(before))
    }
}
