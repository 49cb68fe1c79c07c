//! A simulation as its visitor has it: a program, a run of it, and the choices of the visitor. What stands here is the
//! wiring: which parts an operation changes, and what follows for the others.
//!
//! | part | state |
//! |---|---|
//! | `Basis` (`basis`) | the program in the visitor's language: labels, texts, parsing of typed values and expressions |
//! | `TimeLine` (`time`) | the run (`Course`), its clock, the rows for the plots, the ghost and the kept runs |
//! | `Plots` (`plots`) | visibility, zoom, cursors, added plots; what is computed for plots that are no lines along the run |
//! | `Values` (`values`) | readouts, values of the scene, the selected members of families, the outline |
//! | `Controls` (`controls`) | presets and the part of the scene that is dragged |
//! | `Answers` (`questions`) | answers and grades, and which values open questions hide |
//! | `Survey` (`survey`) | answers to the survey, which no link, project or storage has |
//! | `Claims` (`claims`) | the author's claims and their results |
//! | `Removals` (`removed.rs`) | the numbers of removals, and the last one for undo |
//!
//! Each part has private fields and holds no other part. What it needs, such as the program or the run, is a parameter of its
//! methods: mostly the `Basis`, or an `OpenRun` (program and time line). An operation that changes a part returns `Changes`:
//! the parts changed, events to announce, and a removal that can be undone.
//!
//! - `Play::note` is the only place that folds `Changes`: another run gives the model its drawn curves, empties the plots and
//!   forgets the magnitudes of values; a run that is played on releases what is dragged. Then come the counters of the
//!   `Revision` that views compare, the announcements and the removal.
//! - A change goes straight to its part: `play.change_run(|line, basis| line.keep(basis))`, likewise `change_plots`,
//!   `change_values`, `change_answers`, `change_survey` and `change_claims`. The closure gets one part for changes, and the
//!   compiler keeps it from the others.
//! - `change_settings` gives `Settings`, the controls with what they act on: basis, time line and values of the scene. It
//!   sets parameters by slider, text or preset, states, method, step and curves, drags (`controls/dragging.rs`), and presses
//!   buttons.
//! - What else involves several parts is a method of `Play`: `replace_program` puts another program in the place of the
//!   present one while it runs, and what was chosen stays by name (`replacement` has the rules, `time/adopting.rs` moves the
//!   runs); `restore` reads a link.
//! - Readers get a part with what it is shown with: `Play::plots` gives `Figures`, `Play::values` gives `Shown`,
//!   `Play::scene` gives `ShownScene`, `Play::grips` gives `Grips`.
//! - Functions over several parts that change nothing by themselves stand outside of `Play`: `facts.rs`, `share/missing.rs`.
//!
//! Other crates extend the figures without `play` depending on them. `PlotId` names a plot. `Points` are points over the
//! curves of a plot, `AddedPlot` is a further plot, and `Outline` is a second drawing of the scene with other values.
//!
//! Rows that are given up, by a restart or by continuing after a scrub, stay visible as the *ghost*, the previous run.

use crate::announcement::{Announcement, Announcements};
use crate::changes::{Changes, Outcome, Revision};
use crate::removed::{Removals, Removed};
use crate::replacement::{Names, asks_the_same, same_curves};
use crate::share::restoring::{Reader, fields, seat};
use crate::share::state::{MOST_CHANGES, State};
use crate::share::{Extent, Passed};
use crate::time::recipe::MOST_WORK;
use crate::{
    Answers, Basis, Claims, Controls, Course, Figures, Grips, OpenRun, PlotId, Plots, Readout, Refusal, Settings,
    Shown, ShownScene, Survey, TimeLine, Values, words,
};
use figure::Figure;
use program::{Model, Program, Seat};

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
    removals: Removals,
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
            removals: Removals::default(),
            line,
            basis,
        };
        let changes = play.plots.label(&play.basis, play.line.columns()) | play.line.begin();
        play.note(changes);
        play
    }

    /// Folds changes into the revision, and updates the parts that follow from what has changed.
    fn note(&mut self, mut changes: Changes) {
        if changes.touch(&Changes::NEW_RUN) {
            changes |= self.follow_drawings();
            self.plots.forget_rows();
            self.values.forget_run();
        }
        if changes.touch(&Changes::RELEASED) {
            self.controls.hold(None);
        }
        if changes.touch(&Changes::SETTLED) {
            self.removals.forget();
        }
        self.revision = self.revision.after(&changes);
        self.values.follow(&changes);
        let (announcements, removed) = changes.take_events();
        announcements.into_iter().for_each(|announcement| self.announcements.push(announcement));
        if let Some(removed) = removed {
            self.removals.remember(removed);
        }
    }

    /// Notes the changes of an operation. Returns its value for the caller.
    fn noted<O: Outcome<Changes>>(&mut self, outcome: O) -> O::Value {
        let (changes, value) = outcome.split();
        self.note(changes);
        value
    }

    /// Gives the model the drawn curves of the run.
    fn follow_drawings(&mut self) -> Changes {
        if !self.basis.set_drawings(&self.line.course().begun().drawings) {
            return Changes::NONE;
        }
        self.line.model_changed(&self.basis);
        self.controls.model_changed(self.basis.program());
        self.values.basis_changed(&self.basis);
        self.answers.model_changed(self.basis.program());
        self.plots.model_changed(self.basis.program(), self.line.columns());
        Changes::PARAMETERS
    }

    /// Updates the columns and the contents of the plots to the front of the run.
    fn follow(&mut self) {
        self.line.follow(&self.basis);
        self.plots.follow(&mut self.line);
    }

    /// Change counters.
    pub fn revision(&self) -> Revision {
        self.revision
    }

    /// Removes and returns the oldest announcement.
    pub fn take_announcement(&mut self) -> Option<Announcement> {
        self.announcements.take()
    }

    /// Numbers of the removals, and whether the last one can be undone here.
    pub fn removals(&self) -> &Removals {
        &self.removals
    }

    /// Undoes the removal with this number. Only the last removal can be undone; returns true if this was the last one.
    ///
    /// Parameters get their former values. If one of them determines the initial state, the run restarts.
    pub fn undo(&mut self, number: u32) -> bool {
        let Some(removed) = self.removals.take(number) else { return false };
        let changes = match removed {
            Removed::Run(place, kept) => self.line.insert_kept(place, kept),
            Removed::Ghost(ghost) => self.line.set_ghost(ghost),
            Removed::Parameters(parameters) => self.line.set_parameters(&self.basis, parameters),
            Removed::Start(setup) => self.line.restart(&self.basis, setup),
        };
        self.note(changes.announcing(Announcement::Undone));
        true
    }

    /// Issues a number for a removal that another component can undo; the last removal here can no longer be undone.
    /// All removals share one ascending sequence, so that only the very last one is undone.
    pub fn number_removal(&mut self) -> u32 {
        self.number_removals_from(self.removals.count() + 1);
        self.removals.count()
    }

    /// Continues the numbering of another simulation after `count` removals; they cannot be undone here.
    pub fn number_removals_from(&mut self, count: u32) {
        self.removals = Removals::after(count);
    }

    // The program.

    /// The program in the chosen language.
    pub fn basis(&self) -> &Basis {
        &self.basis
    }

    /// The program being played.
    pub fn program(&self) -> &Program {
        self.basis.program()
    }

    /// Model of the program.
    pub fn model(&self) -> &Model {
        self.basis.model()
    }

    /// Sets the language; any tag. Texts of the document without a translation stay in its own language; other texts
    /// fall back to English.
    pub fn set_language(&mut self, language: &str) {
        self.basis.set_language(language);
        self.values.basis_changed(&self.basis);
        let changes = self.plots.label(&self.basis, self.line.columns());
        self.note(changes | Changes::LANGUAGE);
    }

    /// Replaces the program. Time, parameters and the user's choices are kept by name as far as they fit; see
    /// `replacement`. Dropped items are listed in [`Announcement::Replaced`].
    pub fn replace_program(&mut self, program: Program) {
        let lost = self.replace(program, self.program().seat);
        self.announcements.push(Announcement::Replaced(lost));
    }

    /// Replaces the program by that of the same document with other sizes. Dropped items are listed in
    /// [`Announcement::Resized`].
    pub fn resize(&mut self, program: Program) {
        let lost = self.replace(program, self.program().seat);
        self.announcements.push(Announcement::Resized(lost));
    }

    /// Gives the assigned parameters the values of the seat that is typed, and without a text the stated ones. The runs are
    /// computed again with them.
    ///
    /// # Errors
    ///
    /// A text that is no seat, or a document that assigns no values.
    pub fn set_seat(&mut self, text: &str) -> Result<(), Refusal> {
        let text = text.trim();
        let seat = (!text.is_empty()).then(|| text.parse::<Seat>()).transpose().map_err(|()| Refusal::NoSeat)?;
        if !self.program().has_seats() {
            return Err(Refusal::NoSeat);
        }
        self.replace(self.program().clone(), seat);
        self.announcements.push(Announcement::Seated(seat.map(Seat::number)));
        Ok(())
    }

    /// Replaces the program, with a seat, and returns what was dropped, in the chosen language.
    fn replace(&mut self, mut program: Program, seat: Option<Seat>) -> Vec<String> {
        program.set_seat(seat);
        self.change_settings(|settings| settings.drag_end());
        let mut before = std::mem::replace(self, Self::open(program));
        let names = Names::between(before.model(), self.model());
        self.revision = before.revision.after(&Changes::ALL);
        self.announcements = std::mem::take(&mut before.announcements);
        self.number_removals_from(before.removals.count());
        self.values.adopt(&mut before.values);
        let axes = |line: &TimeLine, plot| line.columns().plot(plot).map(|columns| columns.axes.clone());
        self.plots.adopt((self.basis.program(), before.basis.program()), before.plots, same_curves, |own, former| {
            axes(&self.line, own) == axes(&before.line, former)
        });
        self.set_language(before.basis.tag());
        let adopted = self.line.adopt(&self.basis, (&mut before.line, &before.basis), &names);
        let mut lost = self.noted(adopted);
        self.survey.adopt(&self.basis, (&mut before.survey, &before.basis));
        let same = |own, former| asks_the_same((&self.basis, own), (&before.basis, former), &names);
        let answers = self.answers.adopt(&self.basis, (&before.answers, &before.basis), same);
        lost.extend(answers.iter().map(|typed| words::answer(self.basis.language(), typed)));
        lost
    }

    // The run and its settings.

    /// The run, its clock, and the runs drawn behind it.
    pub fn time_line(&self) -> &TimeLine {
        &self.line
    }

    /// The run: its rows, parameters and state.
    pub fn course(&self) -> &Course {
        self.line.course()
    }

    fn open_run(&self) -> OpenRun<'_> {
        OpenRun { basis: &self.basis, line: &self.line }
    }

    /// Operates the time line: play, pause, step, scrub, keep runs.
    pub fn change_run<O: Outcome<Changes>>(&mut self, change: impl FnOnce(&mut TimeLine, &Basis) -> O) -> O::Value {
        let outcome = change(&mut self.line, &self.basis);
        self.noted(outcome)
    }

    /// Presets, and the part of the scene that is being dragged.
    pub fn controls(&self) -> &Controls {
        &self.controls
    }

    /// The parts of the scene that can be dragged, and its scale.
    pub fn grips(&mut self) -> Grips<'_> {
        self.controls.grips(&self.basis, &self.line, &mut self.values)
    }

    /// Sets parameters, states, method, step and curves, drags a part of the scene, or presses a button.
    pub fn change_settings<O: Outcome<Changes>>(&mut self, change: impl FnOnce(&mut Settings<'_>) -> O) -> O::Value {
        let outcome = change(&mut self.controls.settings(&self.basis, &mut self.line, &mut self.values));
        self.noted(outcome)
    }

    // Plots and values.

    /// The plots, as far as they follow the run.
    pub fn plots(&self) -> Figures<'_> {
        self.plots.seen(self.open_run())
    }

    /// The plots, up to the front of the run.
    pub fn plots_to_front(&mut self) -> Figures<'_> {
        self.follow();
        self.plots()
    }

    /// Changes settings, cursors or points of plots, or adds plots.
    pub fn change_plots<O: Outcome<Changes>>(&mut self, change: impl FnOnce(&mut Plots, OpenRun<'_>) -> O) -> O::Value {
        let outcome = change(&mut self.plots, OpenRun { basis: &self.basis, line: &self.line });
        self.noted(outcome)
    }

    /// Lays out a plot for the time shown, reusing the buffers of its figure. `None` if there is no such plot.
    pub fn layout_plot(&mut self, id: PlotId, settings: &figure::Settings) -> Option<&Figure> {
        self.follow();
        self.plots.layout(OpenRun { basis: &self.basis, line: &self.line }, id, settings)
    }

    /// The values at the moment shown, and the recorded rows.
    pub fn values(&self) -> Shown<'_> {
        self.values.shown(&self.basis, &self.line, &self.answers)
    }

    /// All readouts at the time shown; see [`Readout`].
    pub fn readouts(&mut self) -> Vec<Readout> {
        self.values.readouts(&self.basis, &self.line, &self.answers)
    }

    /// The values of the scene at the moment shown.
    pub fn scene(&mut self) -> ShownScene<'_> {
        self.values.scene(&self.basis, &mut self.line)
    }

    /// Changes the members of families that are shown, or the outline over the scene.
    pub fn change_values(&mut self, change: impl FnOnce(&mut Values) -> Changes) {
        let changes = change(&mut self.values);
        self.note(changes);
    }

    // Questions, survey and claims.

    /// The user's answers to questions.
    pub fn answers(&self) -> &Answers {
        &self.answers
    }

    /// Changes answers to questions.
    pub fn change_answers<O: Outcome<Changes>>(
        &mut self,
        change: impl FnOnce(&mut Answers, OpenRun<'_>) -> O,
    ) -> O::Value {
        let outcome = change(&mut self.answers, OpenRun { basis: &self.basis, line: &self.line });
        self.noted(outcome)
    }

    /// Sets the parameters that a question assumes.
    ///
    /// # Errors
    ///
    /// There is no such question, or a value is outside its range.
    pub fn apply_question_setup(&mut self, question: usize) -> Result<(), Refusal> {
        let parameters = self.answers.admitted_setup(self.open_run(), question)?;
        let changes = self.line.overwrite_parameters(&self.basis, parameters);
        self.note(changes.announcing(Announcement::QuestionSetup(question)));
        Ok(())
    }

    /// The answers to the survey.
    pub fn survey(&self) -> &Survey {
        &self.survey
    }

    /// Changes answers to the survey.
    pub fn change_survey(&mut self, change: impl FnOnce(&mut Survey, &Basis) -> Changes) {
        let changes = change(&mut self.survey, &self.basis);
        self.note(changes);
    }

    /// The author's claims.
    pub fn claims(&self) -> &Claims {
        &self.claims
    }

    /// Judges the author's claims.
    pub fn change_claims<O: Outcome<Changes>>(&mut self, change: impl FnOnce(&mut Claims, &Basis) -> O) -> O::Value {
        let outcome = change(&mut self.claims, &self.basis);
        self.noted(outcome)
    }

    // The state in a link and in another program of the page.

    /// Differences from the freshly opened document, as text for the fragment of a URL; empty if there are none.
    pub fn share(&self) -> String {
        self.share_within(Extent::Whole)
    }

    /// [`Play::share`] with a part of the state.
    pub fn share_within(&self, extent: Extent) -> String {
        let Self { basis, line, plots, answers, .. } = self;
        State { basis, line, plots, answers }.text(extent)
    }

    /// Restores a state. Parts that do not fit the document are omitted and named in the refusal; the rest is applied.
    ///
    /// # Errors
    ///
    /// A text that is not a state, or parts that do not fit: an unknown key, a value out of range, too many kept runs,
    /// a run that exceeds the work limit of a link.
    pub fn restore(&mut self, fragment: &str) -> Result<(), Refusal> {
        self.restore_within(fragment, MOST_CHANGES, &mut { MOST_WORK })
    }

    /// Restores a state with at most `most_changes` changes in each run, and the work limit `work` for all runs
    /// together, in floating-point operations; it is reduced by the work done.
    pub(crate) fn restore_within(
        &mut self,
        fragment: &str,
        most_changes: usize,
        work: &mut u64,
    ) -> Result<(), Refusal> {
        let Some(fields) = fields(fragment)? else { return Ok(()) };
        if let Some(seat) = seat(&fields) {
            self.basis.set_seat(Some(seat));
            self.answers.grade_again(&self.basis);
        }
        let Self { basis, line, plots, answers, .. } = self;
        let restored = Reader::new(basis, line, plots, answers, most_changes).restore(&fields, work);
        let restored = self.noted(restored);
        self.announcements.clear();
        // A link to a seat alone brings no state back.
        if fields.iter().any(|field| !field.starts_with("seat=")) {
            self.announcements.push(Announcement::Restored);
        }
        restored
    }

    /// State of the simulation, for [`Play::take_over`].
    pub fn pass_on(&mut self) -> Passed {
        Passed { state: self.share_within(Extent::Exact), line: self.line.pass_on(), scales: self.values.scales() }
    }

    /// Continues a simulation of the same document. Nothing is announced.
    pub fn take_over(&mut self, passed: Passed) {
        // Written by this program for this document: every part of it fits.
        let _ = self.restore_within(&passed.state, usize::MAX, &mut { u64::MAX });
        let changes = self.line.take_over(passed.line);
        self.note(changes);
        self.values.set_scales(passed.scales);
        self.announcements.clear();
    }
}
