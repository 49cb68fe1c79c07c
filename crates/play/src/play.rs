//! The state itself: a program, a run of it, and what the visitor has chosen.

use crate::announcement::{Announcement, Announcements};
use crate::controls::hold::Holding;
use crate::number::Style;
use crate::plots::kept::{Ghost, Kept};
use crate::plots::plot::{Content, PlotState};
use crate::plots::traces::{Columns, Traces};
use crate::questions::given::Answer;
use crate::removed::Undo;
use crate::time::course::Course;
use crate::values::trails::Trails;
use crate::values::{Lines, Outline};
use engine::checks::Checking;
use engine::{Readings, Setup};
use program::{Model, NodeId, Program, Speed};
use units::Language;

/// Counts changes, so that the shell draws only what has changed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Revision {
    /// The time or the state shown: scene, readouts, plots, table.
    pub frame: u64,
    /// Parameters, method, step.
    pub parameters: u64,
    /// Status, speed, problem.
    pub transport: u64,
    /// Rows were recorded or given up: table, length of the time line.
    pub rows: u64,
    /// Kept runs and ghost.
    pub runs: u64,
    /// Plots shown and zoomed.
    pub plots: u64,
    /// What has been answered to questions.
    pub answers: u64,
    /// What is known of the author's claims.
    pub checks: u64,
    /// The language.
    pub language: u64,
}

impl Revision {
    /// Everything has changed.
    pub(crate) fn raised(self) -> Self {
        Self {
            frame: self.frame + 1,
            parameters: self.parameters + 1,
            transport: self.transport + 1,
            rows: self.rows + 1,
            runs: self.runs + 1,
            plots: self.plots + 1,
            answers: self.answers + 1,
            checks: self.checks + 1,
            language: self.language + 1,
        }
    }
}

/// One simulation in the hands of a visitor.
#[derive(Debug)]
pub struct Play {
    pub(crate) program: Program,
    /// The language of the document's texts, any tag.
    pub(crate) tag: String,
    /// The language of all other words.
    pub(crate) language: Language,
    pub(crate) style: Style,
    pub(crate) revision: Revision,
    pub(crate) announcements: Announcements,
    /// What the document asks for.
    pub(crate) defaults: Setup,
    pub(crate) course: Course,
    /// How many rows there were at the last frame.
    rows_seen: usize,
    /// Since which time rows have been given up that may have been read; see [`Play::take_rewritten`].
    rewritten: Option<f64>,
    pub(crate) playing: bool,
    /// Whether the run stopped because its memory is used up.
    pub(crate) full: bool,
    /// How fast the document is to be watched, and how many times as fast it is.
    pub(crate) pace: Speed,
    pub(crate) speed: f64,
    pub(crate) slippage: f64,
    pub(crate) hold: Option<Holding>,
    pub(crate) columns: Columns,
    pub(crate) traces: Traces,
    pub(crate) present: Vec<f64>,
    pub(crate) ghost: Option<Ghost>,
    pub(crate) kept: Vec<Kept>,
    /// How many ids kept runs have been given: none is given twice.
    pub(crate) kept_issued: u32,
    pub(crate) plots: Vec<PlotState>,
    /// What is drawn over the scene.
    pub(crate) outline: Option<Outline>,
    pub(crate) evaluators: Evaluators,
    pub(crate) lines: Lines,
    /// One for each question, once anything has been answered.
    pub(crate) answers: Vec<Answer>,
    /// For each question whether it has been answered, or its answer shown.
    pub(crate) solved: Vec<bool>,
    /// Whether the values that questions hide are shown all the same.
    pub(crate) shows_hidden: bool,
    /// The author's claims, once somebody wants to know whether they hold.
    pub(crate) checking: Option<Checking>,
    pub(crate) undo: Undo,
    /// For each node of the model whether it is a count.
    pub(crate) whole: Vec<bool>,
    /// The greatest size that each state and then each quantity has shown in this run.
    pub(crate) scales: Vec<f64>,
}

/// What evaluates the expressions of the document, by subject.
#[derive(Debug)]
pub(crate) struct Evaluators {
    pub quantities: Readings,
    /// The values of the scene in the chosen language, and when they were last computed.
    pub scene: Readings,
    /// Where points of it have been.
    pub trails: Trails,
    pub scene_values: Vec<f64>,
    /// The greatest size that each of them has had in this run.
    pub scene_scales: Vec<f64>,
    pub scene_frame: Option<(u64, u64)>,
    pub initial: Readings,
    /// All assignments of all presets.
    pub presets: Readings,
    /// All assignments that questions suppose.
    pub setups: Readings,
    pub answers: Readings,
}

impl Play {
    /// Opens a simulation: the first row is drawn and the run stands still at 0.
    pub fn open(program: Program) -> Self {
        let model = &program.model;
        let columns = Columns::new(model, &program.plots);
        let defaults = Setup::of(&program);
        let course = Course::start(model, defaults.clone(), columns.bytes_per_row());
        let tag = program.language.clone();
        let solved = vec![false; program.questions.len()];
        let mut play = Self {
            language: Language::of(&tag),
            style: Style::of(&tag),
            revision: Revision::default(),
            announcements: Announcements::default(),
            whole: model.whole_numbers(),
            lines: Lines::of(model),
            scales: vec![0.0; model.states.len() + model.quantities.len()],
            evaluators: Evaluators::new(&program, &tag),
            plots: PlotState::of(&program, &columns),
            rewritten: None,
            outline: None,
            pace: program.pace(),
            program,
            tag,
            defaults,
            course,
            rows_seen: 0,
            playing: false,
            full: false,
            speed: 1.0,
            slippage: 0.0,
            hold: None,
            columns,
            traces: Traces::default(),
            present: Vec::new(),
            ghost: None,
            kept: Vec::new(),
            answers: Vec::new(),
            kept_issued: 0,
            solved,
            shows_hidden: false,
            checking: None,
            undo: Undo::default(),
        };
        play.label_plots();
        play.frame_changed();
        play
    }

    /// What is played.
    pub fn program(&self) -> &Program {
        &self.program
    }

    /// Its model.
    pub fn model(&self) -> &Model {
        &self.program.model
    }

    /// The language of the program's texts, as it was chosen.
    pub fn tag(&self) -> &str {
        &self.tag
    }

    /// The language of all other words.
    pub fn language(&self) -> Language {
        self.language
    }

    /// Chooses the language; any tag. The document's texts stay in its own language where they have no translation, the
    /// other words in English.
    pub fn set_language(&mut self, language: &str) {
        language.clone_into(&mut self.tag);
        self.language = Language::of(language);
        self.style = Style::of(language);
        self.evaluators.scene = Evaluators::scene(&self.program, language);
        self.evaluators.trails = Trails::new(&self.program.model, self.program.scene(language));
        self.evaluators.scene_frame = None;
        self.evaluators.scene_scales.clear();
        self.label_plots();
        self.revision.language += 1;
    }

    /// How the chosen language writes numbers.
    pub fn style(&self) -> Style {
        self.style
    }

    /// A text of the document in the chosen language.
    pub fn text<'a>(&'a self, original: &'a str) -> &'a str {
        self.program.text(&self.tag, original)
    }

    /// What has changed how often.
    pub fn revision(&self) -> Revision {
        self.revision
    }

    /// The parameters in force at the time shown, SI, in the order of the model.
    pub fn parameter_values(&self) -> &[f64] {
        self.course.parameters()
    }

    /// The run: its rows, parameters and state.
    pub fn course(&self) -> &Course {
        &self.course
    }

    /// The state at a recorded time (SI), between the rows too, and the parameters then; `None` beyond the run.
    pub fn state_at(&mut self, time: f64, out: &mut [f64]) -> Option<Vec<f64>> {
        self.course.state_at(time, out)
    }

    /// The greatest magnitude that a state has had in this run, SI.
    pub fn greatest(&self, state: usize) -> f64 {
        self.scales.get(state).copied().unwrap_or_default()
    }

    /// The time (SI) after which rows were given up since this was asked last: what was read of them holds no longer.
    pub fn take_rewritten(&mut self) -> Option<f64> {
        self.rewritten.take()
    }

    pub(crate) fn note_rewritten(&mut self, time: f64) {
        self.rewritten = Some(self.rewritten.map_or(time, |before| before.min(time)));
    }

    /// The next thing to tell, oldest first.
    pub fn take_announcement(&mut self) -> Option<Announcement> {
        self.announcements.take()
    }

    pub(crate) fn announce(&mut self, announcement: Announcement) {
        self.announcements.push(announcement);
    }

    /// To be called whenever the time, the state or the parameters shown have changed.
    pub(crate) fn frame_changed(&mut self) {
        self.revision.frame += 1;
        let rows = self.course.rows();
        if rows != self.rows_seen {
            self.rows_seen = rows;
            self.revision.rows += 1;
        }
        self.columns.present(&self.course, &mut self.present);
        for (scale, value) in self.scales.iter_mut().zip(self.course.state()) {
            if value.is_finite() {
                *scale = scale.max(value.abs());
            }
        }
    }

    /// Brings the columns up to the front of the run.
    pub(crate) fn follow(&mut self) {
        self.traces.follow(&self.course, &mut self.columns, &self.present);
        for (index, plot) in self.plots.iter_mut().enumerate() {
            match &mut plot.content {
                Content::Run => {}
                Content::Section(section) => section.follow(&mut self.course),
                Content::Swept(swept) => drop(swept.follow(&self.course)),
                Content::Profile(profile, _) => profile.follow(&self.course),
                Content::Histogram(histogram) => {
                    let column = self.columns.plot(index).map_or(&[][..], |plot| self.traces.column(plot.x));
                    histogram.follow(&self.course, column);
                }
            }
        }
    }

    /// Starts another run; the present one stays behind as a ghost if there is something to see of it.
    /// The same simulation as it would begin again with the present parameters, at time 0; without kept runs.
    #[must_use]
    pub fn from_start(&self) -> Self {
        let mut play = Self::open(self.program.clone());
        play.set_language(&self.tag);
        let parameters = self.course.parameters().to_vec();
        play.restart(Setup { parameters, ..self.course.begun().clone() });
        play.clear_ghost();
        play
    }

    pub(crate) fn restart(&mut self, mut setup: Setup) {
        // What was pressed in the former run was pressed for what happened there.
        setup.presses.clear();
        self.keep_ghost(0);
        self.adopt_drawings(&setup.drawings);
        let overhead = self.columns.bytes_per_row();
        let course = Course::start(&self.program.model, setup, overhead);
        self.replace_course(course);
    }

    /// Puts another run in the place of the present one.
    pub(crate) fn replace_course(&mut self, course: Course) {
        self.course = course;
        self.traces = Traces::default();
        for plot in &mut self.plots {
            plot.forget_rows();
        }
        self.note_rewritten(f64::NEG_INFINITY);
        self.scales.iter_mut().for_each(|scale| *scale = 0.0);
        // Digits do not depend on whether the start was shown, or a link led to a later moment at once.
        for (scale, value) in self.scales.iter_mut().zip(self.course.initial()) {
            *scale = if value.is_finite() { value.abs() } else { 0.0 };
        }
        self.evaluators.scene_scales.clear();
        self.full = false;
        self.slippage = 0.0;
        self.revision.rows += 1;
        self.revision.parameters += 1;
        self.revision.transport += 1;
        if self.course.error().is_some() {
            self.playing = false;
            self.announce(Announcement::Failed);
        }
        self.frame_changed();
    }

    /// The initial state that the model gives for some parameters.
    pub(crate) fn initial_for(&mut self, parameters: &[f64]) -> Vec<f64> {
        let nothing = vec![0.0; self.program.model.states.len()];
        self.evaluators.initial.at(parameters, &nothing, 0.0, &nothing).to_vec()
    }
}

impl Evaluators {
    pub(crate) fn new(program: &Program, language: &str) -> Self {
        let model = &program.model;
        let reading = |nodes: Vec<NodeId>| Readings::new(model, &nodes);
        let presets = program.presets.iter().flat_map(|preset| &preset.values);
        let setups = program.questions.iter().flat_map(|question| &question.setup);
        Self {
            quantities: reading(model.quantities.iter().map(|quantity| quantity.value.node).collect()),
            scene: Self::scene(program, language),
            trails: Trails::new(model, program.scene(language)),
            scene_values: Vec::new(),
            scene_scales: Vec::new(),
            scene_frame: None,
            initial: reading(model.states.iter().map(|state| state.initial).collect()),
            presets: reading(presets.map(|assignment| assignment.value.node).collect()),
            setups: reading(setups.map(|assignment| assignment.value.node).collect()),
            answers: reading(program.questions.iter().map(|question| question.answer.node).collect()),
        }
    }

    fn scene(program: &Program, language: &str) -> Readings {
        let nodes: Vec<NodeId> = program
            .scene(language)
            .map(|scene| scene.values.iter().map(|value| value.node).collect())
            .unwrap_or_default();
        Readings::new(&program.model, &nodes)
    }
}
