//! The central state: a program, a run of it, and the choices of the visitor.

mod drag;
mod passing;
mod removed;
mod replacement;
mod restore;
mod settings;
pub(crate) mod share;
mod transport;
mod undo;

pub use passing::Passed;

use crate::announcement::{Announcement, Announcements};
use crate::number::Style;
use crate::questions::given::Answer;
use crate::time::course::Course;
use crate::{
    AddedPlot, Answers, Basis, Changes, Claims, Controls, Figures, Outline, PlotId, Plots, Readout, Refusal, Revision,
    Shown, Survey, TimeLine, Values, Verdict,
};
use engine::Setup;
use figure::{Figure, Point, Settings};
use program::{Model, Program};
use removed::Undo;
use units::Language;

/// One simulation operated by a visitor.
#[derive(Debug)]
pub struct Play {
    basis: Basis,
    revision: Revision,
    announcements: Announcements,
    line: TimeLine,
    plots: Plots,
    values: Values,
    controls: Controls,
    answers: Answers,
    survey: Survey,
    claims: Claims,
    undo: Undo,
}

impl Play {
    /// Opens a simulation: the first row is shown and the run is paused at time 0.
    pub fn open(program: Program) -> Self {
        let basis = Basis::new(program);
        let (program, line) = (basis.program(), TimeLine::new(&basis));
        let mut play = Self {
            revision: Revision::default(),
            announcements: Announcements::default(),
            controls: Controls::new(program),
            plots: Plots::new(program, line.columns()),
            values: Values::new(&basis),
            answers: Answers::new(program),
            survey: Survey::new(program),
            claims: Claims::default(),
            undo: Undo::default(),
            line,
            basis,
        };
        let changes = play.plots.label(&play.basis, play.line.columns()) | play.line.begin();
        play.note(changes);
        play
    }

    /// The program in the chosen language.
    pub fn basis(&self) -> &Basis {
        &self.basis
    }

    /// Records what has changed.
    pub(super) fn note(&mut self, changes: Changes) {
        self.revision = self.revision.after(changes);
        self.values.follow(changes);
    }

    /// The program being played.
    pub fn program(&self) -> &Program {
        self.basis.program()
    }

    /// Model of the program.
    pub fn model(&self) -> &Model {
        self.basis.model()
    }

    /// Language of all other texts.
    pub fn language(&self) -> Language {
        self.basis.language()
    }

    /// Sets the language; any tag. Texts of the document without a translation stay in its own language; other texts
    /// fall back to English.
    pub fn set_language(&mut self, language: &str) {
        self.basis.set_language(language);
        self.values.basis_changed(&self.basis);
        let changes = self.plots.label(&self.basis, self.line.columns());
        self.note(changes | Changes::LANGUAGE);
    }

    /// Number format of the chosen language.
    pub fn style(&self) -> Style {
        self.basis.style()
    }

    /// Change counters.
    pub fn revision(&self) -> Revision {
        self.revision
    }

    /// The run, its clock, and the runs drawn behind it.
    pub fn time_line(&self) -> &TimeLine {
        &self.line
    }

    /// The run: its rows, parameters and state.
    pub fn course(&self) -> &Course {
        self.line.course()
    }

    /// Writes the state (SI) at a recorded time (SI) into `out`, interpolated between rows. Returns the parameters (SI)
    /// in force then; `None` if the run could not start.
    pub fn state_at(&mut self, time: f64, out: &mut [f64]) -> Option<Vec<f64>> {
        self.line.course_between_rows().state_at(time, out)
    }

    /// Returns the earliest time (SI) from which rows were discarded since the last call: data read after it is
    /// invalid. `None` if no rows were discarded.
    pub fn take_rewritten(&mut self) -> Option<f64> {
        self.line.take_rewritten()
    }

    /// Presets, and the part of the scene that is being dragged.
    pub fn controls(&self) -> &Controls {
        &self.controls
    }

    /// The user's answers to questions.
    pub fn answers(&self) -> &Answers {
        &self.answers
    }

    /// Stores the text in the field of a question as an unchecked answer.
    pub fn type_answer(&mut self, question: usize, text: &str) {
        let changes = self.answers.type_text(question, text);
        self.note(changes);
    }

    /// Grades and stores an answer; see [`Answers::check`].
    pub fn check_answer(&mut self, question: usize, text: &str) -> Verdict {
        let (verdict, changes) = self.answers.check(&self.basis, self.line.course(), question, text);
        self.note(changes);
        verdict
    }

    /// Right answer with its unit, as [`Answers::right_text`]. Marks the question as solved.
    pub fn reveal_answer(&mut self, question: usize) -> String {
        let changes = self.answers.reveal(question);
        self.note(changes);
        self.answers.right_text(&self.basis, self.line.course(), question)
    }

    /// Restores the answer to the question with this name. Returns false if there is no such question.
    pub fn restore_answer(&mut self, name: &str, saved: &Answer) -> bool {
        let restored = self.answers.restore(&self.basis, name, saved);
        self.note(restored.unwrap_or_default());
        restored.is_some()
    }

    /// Sets the parameters that a question assumes.
    pub fn apply_question_setup(&mut self, question: usize) -> Result<(), Refusal> {
        let parameters = self.answers.supposed(&self.basis, self.line.course(), question);
        let unknown = || Refusal::Unknown { name: question.to_string() };
        let asked = self.program().questions.get(question).ok_or_else(unknown)?;
        let parameters = self.basis.admit_assignments(&asked.setup, parameters)?;
        self.overwrite_parameters(parameters);
        self.announce(Announcement::QuestionSetup(question));
        Ok(())
    }

    /// The answers to the survey.
    pub fn survey(&self) -> &Survey {
        &self.survey
    }

    /// Chooses an answer of the survey; see [`Survey::choose`].
    pub fn choose_in_survey(&mut self, item: usize, answer: Option<usize>) {
        let changes = self.survey.choose(&self.basis, item, answer);
        self.note(changes);
    }

    /// Sets a free text of the survey; see [`Survey::type_text`].
    pub fn type_in_survey(&mut self, item: usize, text: &str) {
        let changes = self.survey.type_text(&self.basis, item, text);
        self.note(changes);
    }

    /// Shows the values that questions hide, or hides them again; see [`Answers::show_hidden`].
    pub fn show_hidden(&mut self, show: bool) {
        let changes = self.answers.show_hidden(show);
        self.note(changes);
    }

    /// The plots, as far as they follow the run.
    pub fn plots(&self) -> Figures<'_> {
        self.plots.seen(&self.basis, &self.line)
    }

    /// The plots, up to the front of the run.
    pub fn plots_to_front(&mut self) -> Figures<'_> {
        self.follow();
        self.plots()
    }

    /// Changes settings or points of plots.
    pub fn change_plots(&mut self, change: impl FnOnce(&mut Plots) -> Changes) {
        let changes = change(&mut self.plots);
        self.note(changes);
    }

    /// Lays out a plot for the time shown, reusing the buffers of its figure. `None` if there is no such plot.
    pub fn layout_plot(&mut self, id: PlotId, settings: &Settings) -> Option<&Figure> {
        self.follow();
        self.plots.layout(&self.basis, &self.line, id, settings)
    }

    /// Read-out at a pixel of the last layout: values of the present and kept runs and the nearest measured points.
    /// Moves the keyboard cursor there.
    pub fn hover_plot(&mut self, id: PlotId, at: Point) -> Option<figure::Readout> {
        self.plots.hover(&self.basis, &self.line, id, at)
    }

    /// Moves the keyboard cursor by `rows` rows along the run, initially from the present row, and returns the read-out
    /// there.
    pub fn move_cursor(&mut self, id: PlotId, rows: isize) -> Option<figure::Readout> {
        self.plots.move_cursor(&self.basis, &self.line, id, rows)
    }

    /// Continues the runs of sweep plots for part of one frame. Returns true if work remains.
    pub fn work_on_plots(&mut self) -> bool {
        let (remains, changes) = self.plots.work(self.basis.model(), self.line.course());
        self.note(changes);
        remains
    }

    /// Adds an empty plot after the others.
    pub fn add_plot(&mut self) -> PlotId {
        let (id, changes) = self.plots.add();
        self.note(changes);
        id
    }

    /// Access to an added plot. Call [`Play::added_plot_changed`] after changing it; `None` if the plot is not an added
    /// one.
    pub fn added_plot(&mut self, id: PlotId) -> Option<&mut AddedPlot> {
        self.plots.added(id)
    }

    /// Redraws an added plot after a change.
    pub fn added_plot_changed(&mut self, id: PlotId) {
        let changes = self.plots.added_changed(id);
        self.note(changes);
    }

    /// The values at the moment shown, and the recorded rows.
    pub fn values(&self) -> Shown<'_> {
        self.values.shown(&self.basis, &self.line, &self.answers)
    }

    /// All readouts at the time shown; see [`Readout`].
    pub fn readouts(&mut self) -> Vec<Readout> {
        let values = self.values.quantities(self.line.course());
        self.values().readouts(&values)
    }

    /// Displays another member of a family: sets the index at position `place` to `value`. If that member does not
    /// exist, the next one in the direction of the change.
    pub fn choose_member(&mut self, family: &str, place: usize, value: i64) {
        let changes = self.values.choose_member(family, place, value);
        self.note(changes);
    }

    /// Values of [`program::Scene::values`] at the time shown, SI, for attributes. Computed once per frame.
    pub fn scene_values(&mut self) -> &[f64] {
        self.values.scene_values(self.line.course())
    }

    /// Value `index` of the scene at the time shown, formatted with its unit; empty for an unknown index.
    pub fn scene_text(&mut self, index: usize, decimals: Option<u8>) -> String {
        self.values.scene_text(&self.basis, self.line.course(), index, decimals)
    }

    /// Writes the path of a trail of the scene up to the time shown into `path`, in scene units.
    pub fn scene_trail(&mut self, number: usize, path: &mut String) {
        self.values.trail(&self.basis, &mut self.line, number, path);
    }

    /// Outline drawn over the scene.
    pub fn outline(&self) -> Option<&Outline> {
        self.values.outline()
    }

    /// Sets or removes the outline.
    pub fn set_outline(&mut self, outline: Option<Outline>) {
        self.values.set_outline(outline);
    }

    /// Sets the values of the outline for the time shown.
    pub fn set_outline_values(&mut self, values: Option<&[f64]>) {
        self.values.set_outline_values(values);
    }

    /// Pitch in hertz of the first state while the run is playing or a part is dragged: 440 Hz at 0, one octave up or
    /// down at its greatest magnitude in this run. `None` if there is nothing to hear.
    pub fn pitch(&self) -> Option<f64> {
        let (&value, scale) = (self.course().state().first()?, self.line.greatest(0));
        let sounding = (self.line.is_playing() || self.controls.is_dragging()) && value.is_finite() && scale > 0.0;
        sounding.then(|| 440.0 * libm::exp2((value / scale).clamp(-1.0, 1.0)))
    }

    /// The author's claims.
    pub fn claims(&self) -> &Claims {
        &self.claims
    }

    /// Starts judging the author's claims.
    pub fn begin_claims(&mut self) {
        let changes = self.claims.begin();
        self.note(changes);
    }

    /// Judges claims for part of one frame. Returns true if claims remain.
    pub fn advance_claims(&mut self) -> bool {
        let (remain, changes) = self.claims.advance(&self.basis);
        self.note(changes);
        remain
    }

    /// Removes and returns the oldest announcement.
    pub fn take_announcement(&mut self) -> Option<Announcement> {
        self.announcements.take()
    }

    pub(super) fn announce(&mut self, announcement: Announcement) {
        self.announcements.push(announcement);
    }

    /// Updates the columns and the contents of the plots to the front of the run.
    pub(super) fn follow(&mut self) {
        self.line.follow(&self.basis);
        self.plots.follow(&mut self.line);
    }

    /// Copy of this simulation, restarted at time 0 with the present parameters; without kept runs and ghost.
    #[must_use]
    pub fn from_start(&self) -> Self {
        let mut play = Self::open(self.basis.program().clone());
        play.set_language(self.basis.tag());
        play.restart(self.setup());
        play.clear_ghost();
        play
    }

    /// Settings of the present run, with the parameters shown.
    pub(super) fn setup(&self) -> Setup {
        Setup { parameters: self.course().parameters().to_vec(), ..self.course().begun().clone() }
    }

    /// Starts another run. The present one becomes the ghost if it is long enough to be seen.
    pub(super) fn restart(&mut self, mut setup: Setup) {
        // Presses belong to the former run.
        setup.presses.clear();
        self.keep_ghost();
        self.adopt_drawings(&setup.drawings);
        let changes = self.line.start(self.basis.model(), setup);
        self.run_replaced(changes);
    }

    /// Replaces the present run.
    pub(super) fn replace_course(&mut self, course: Course) {
        let changes = self.line.replace(course);
        self.run_replaced(changes);
    }

    fn run_replaced(&mut self, changes: Changes) {
        self.plots.forget_rows();
        self.values.forget_run();
        self.note(changes);
        if self.course().error().is_some() {
            self.announce(Announcement::Failed);
        }
    }
}
