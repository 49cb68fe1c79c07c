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
//! | answers to the survey | by kind and texts of the item |
//! | undo, drag in the scene | end, because they refer to the former program |
//! | added plots | stay after those of the document, whose number determines their [`PlotId`](crate::PlotId) |
//!
//! A value that equals the former default counts as not set, even if the user has set it: the two cases cannot be distinguished.

mod answers;
mod names;
mod plots;
mod recipe;

use super::restore::MOST_WORK;
use crate::time::recipe::{Moments, Recipe};
use crate::{Announcement, Changes, Play, TimeLine, words};
use answers::asks_the_same;
use names::Names;
use plots::same_curves;
use program::Program;

impl Play {
    /// Replaces the program. Time, parameters and the user's choices are kept by name as far as they fit. Dropped items
    /// are listed in [`Announcement::Replaced`].
    pub fn replace_program(&mut self, mut program: Program) {
        program.set_seat(self.program().seat);
        let lost = self.replace(program);
        self.announce(Announcement::Replaced(lost));
    }

    /// Replaces the program by that of the same document with other sizes. Dropped items are listed in
    /// [`Announcement::Resized`].
    pub fn resize(&mut self, mut program: Program) {
        program.set_seat(self.program().seat);
        let lost = self.replace(program);
        self.announce(Announcement::Resized(lost));
    }

    /// Replaces the program and returns what was dropped, in the chosen language.
    pub(crate) fn replace(&mut self, program: Program) -> Vec<String> {
        self.drag_end();
        let mut before = std::mem::replace(self, Self::open(program));
        let names = Names::between(before.model(), self.model());
        self.revision = before.revision.after(Changes::ALL);
        self.announcements = std::mem::take(&mut before.announcements);
        self.number_removals_from(before.removals());
        self.line.adopt_speed(&before.line);
        self.values.adopt(&mut before.values);
        let axes = |line: &TimeLine, plot| line.columns().plot(plot).map(|columns| columns.axes.clone());
        self.plots.adopt(
            (self.basis.program(), before.basis.program()),
            std::mem::take(&mut before.plots),
            same_curves,
            |own, former| axes(&self.line, own) == axes(&before.line, former),
        );
        self.set_language(before.basis.tag());
        let mut lost = self.adopt_runs(&mut before, &names);
        self.survey.adopt(&self.basis, (&mut before.survey, &before.basis));
        let same = |own, former| asks_the_same((&self.basis, own), (&before.basis, former), &names);
        let answers = self.answers.adopt(&self.basis, (&before.answers, &before.basis), same);
        lost.extend(answers.iter().map(|typed| words::answer(self.language(), typed)));
        lost
    }

    /// Takes over the present and the kept runs. Returns what was dropped, in the chosen language.
    fn adopt_runs(&mut self, before: &mut Play, names: &Names) -> Vec<String> {
        let present = before.course().recipe();
        let time_shown = before.basis.time_words(before.course(), present.time);
        let (recipe, mut lost) = self.basis.translated(&present, &before.basis, &time_shown, names);
        let same_motion = self.model().moves_like(before.model());
        let same_layout = self.has_curves_of(before);
        let same_columns = same_motion && same_layout && self.columns_are_those_of(before);
        let mut work = MOST_WORK;
        before.follow();
        self.adopt_drawings(&recipe.setup.drawings);
        if same_motion && recipe == present {
            let changes = self.line.adopt_run(&self.basis, &mut before.line, same_columns);
            self.note(changes);
        } else {
            let (course, complete) = self.line.replay(&self.basis, &recipe, Moments::Times, &mut work);
            if !complete && course.error().is_none() {
                let time = before.basis.time_words(before.course(), recipe.front);
                lost.push(words::time(self.language(), &time));
            }
            before.keep_ghost();
            self.replace_course(course);
        }
        self.line.adopt_rest(&mut before.line, same_layout);
        let translated = |recipe: &Recipe| {
            let (recipe, missing) = self.basis.translated(recipe, &before.basis, "", names);
            missing.is_empty().then_some(recipe)
        };
        let kept =
            self.line.adopt_kept(&self.basis, (&mut before.line, &before.basis), translated, same_columns, &mut work);
        lost.extend(kept.iter().map(|name| words::kept_run(self.basis.language(), name)));
        lost
    }
}
