//! Replacement of the program while it runs. While a document is edited, the former program runs on until the text is free of
//! errors.
//!
//! | item | treatment |
//! |---|---|
//! | parameters | by name and dimension: a value that differs from the former default stays, any other becomes the new default |
//! | method, step | likewise: values that differ from the former document stay |
//! | presses of buttons | stay at their times, by the names or titles of the buttons |
//! | drawn curves | stay by the names of their tables, if range and arguments are equal |
//! | start set by hand | stays if each state has a former one of its name and dimension |
//! | the run, its time | recomputed with the changes of parameters at their times, up to the work limit of a link; kept as it is if model and values are equal |
//! | speed, language, playing | stay |
//! | ghost | the run that was replaced, or the former ghost if the run stays; none if other curves are plotted |
//! | kept runs | recomputed, except where nothing would change; a run that loses a value is dropped |
//! | visibility and zoom of plots | by title; zoom only if the units of the axes are equal |
//! | answers | by the text of the question; the grade stays if the computed answer is the same expression |
//! | undo, drag in the scene | end, because they refer to the former program |
//! | added plots | stay after those of the document, whose number determines their [`PlotId`](crate::PlotId) |
//!
//! A value that equals the former default counts as not set, even if the user has set it: the two cases cannot be distinguished.

mod answers;
mod names;
mod plots;
mod recipe;

use crate::plots::kept::Kept;
use crate::share::restore::MOST_WORK;
use crate::time::course::Course;
use crate::time::recipe::Moments;
use crate::{Announcement, Changes, Play, words};
use answers::asks_the_same;
use names::Names;
use program::Program;

impl Play {
    /// Replaces the program. Time, parameters and the user's choices are kept by name as far as they fit. Dropped items
    /// are listed in [`Announcement::Replaced`].
    pub fn replace_program(&mut self, program: Program) {
        let lost = self.replace(program);
        self.announce(Announcement::Replaced(lost));
    }

    /// Replaces the program by that of the same document with other sizes. Dropped items are listed in
    /// [`Announcement::Resized`].
    pub fn resize(&mut self, program: Program) {
        let lost = self.replace(program);
        self.announce(Announcement::Resized(lost));
    }

    /// Replaces the program and returns what was dropped, in the chosen language.
    fn replace(&mut self, program: Program) -> Vec<String> {
        self.drag_end();
        let mut before = std::mem::replace(self, Self::open(program));
        let names = Names::between(before.model(), self.model());
        self.revision = before.revision.after(Changes::ALL);
        self.announcements = std::mem::take(&mut before.announcements);
        self.number_removals_from(before.removals());
        self.speed = before.speed;
        self.lines.choose_as(std::mem::take(&mut before.lines));
        self.adopt_plots(&mut before);
        self.set_language(before.basis.tag());
        let mut lost = self.adopt_runs(&mut before, &names);
        let same = |own, former| asks_the_same((&self.basis, own), (&before.basis, former), &names);
        let answers = self.answers.adopt(&self.basis, (&before.answers, &before.basis), same);
        lost.extend(answers.iter().map(|typed| words::answer(self.language(), typed)));
        lost
    }

    /// Takes over the present and the kept runs. Returns what was dropped, in the chosen language.
    fn adopt_runs(&mut self, before: &mut Play, names: &Names) -> Vec<String> {
        let present = before.course.recipe();
        let (recipe, mut lost) = self.translated(&present, before, names);
        let same_motion = self.model().moves_like(before.model());
        let same_layout = self.has_curves_of(before);
        let same_columns = same_motion && same_layout && self.columns_are_those_of(before);
        let mut work = MOST_WORK;
        before.follow();
        self.adopt_drawings(&recipe.setup.drawings);
        if same_motion && recipe == present {
            self.adopt_course(before, same_columns);
        } else {
            let overhead = self.columns.bytes_per_row();
            let (course, complete) = Course::replay(self.basis.model(), &recipe, Moments::Times, overhead, &mut work);
            if !complete && course.error().is_none() {
                lost.push(words::time(self.basis.language(), &before.time_words(recipe.front)));
            }
            before.keep_ghost(0);
            self.replace_course(course);
        }
        if same_layout {
            self.ghost = before.ghost.take();
        }
        self.playing = before.playing && self.course.history().is_some() && self.course.error().is_none();
        self.kept_issued = before.kept_issued;
        let views = before.kept();
        for (kept, view) in std::mem::take(&mut before.kept).into_iter().zip(views) {
            let (recipe, missing) = self.translated(&kept.recipe, before, names);
            if !missing.is_empty() {
                lost.push(words::kept_run(self.basis.language(), &view.name));
            } else if same_columns && recipe == kept.recipe {
                self.kept.push(kept);
            } else {
                match self.compute_kept(&recipe, Moments::Times, &mut work) {
                    (recipe, traces, true) => self.kept.push(Kept { recipe, traces, ..kept }),
                    _ => lost.push(words::kept_run(self.basis.language(), &view.name)),
                }
            }
        }
        lost
    }

    /// Takes over the run unchanged.
    fn adopt_course(&mut self, before: &mut Play, same_columns: bool) {
        let model = self.basis.model();
        let nothing = Course::start(model, self.basis.defaults().clone(), 0);
        self.course = std::mem::replace(&mut before.course, nothing);
        self.course.set_overhead(self.columns.bytes_per_row());
        self.full = before.full;
        self.slippage = before.slippage;
        if let Some(time) = before.take_rewritten() {
            self.note_rewritten(time);
        }
        if same_columns {
            self.traces = std::mem::take(&mut before.traces);
        }
        // The magnitudes of states determine their number format. Those of quantities may have changed and are found
        // again in the next frames.
        let states = self.basis.model().states.len();
        for (scale, former) in self.scales.iter_mut().zip(&before.scales).take(states) {
            *scale = *former;
        }
        self.frame_changed();
    }
}
