//! Taking over the runs of another time line: of another program, or of the same one in another module of the page.

use super::TimeLine;
use super::course::Course;
use super::keeping::Computed;
use super::kept::{Ghost, Kept};
use super::recipe::{MOST_WORK, Moments, Recipe};
use crate::plots::traces::Traces;
use crate::replacement::{Names, has_same_curves};
use crate::{Basis, Changes, words};
use serde::{Deserialize, Serialize};

/// State of a time line that a link does not have.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct PassedLine {
    playing: bool,
    /// For each kept run, true if it is drawn.
    kept: Vec<bool>,
    ghost: Option<Traces>,
    /// Greatest magnitudes so far of the states, SI.
    scales: Vec<f64>,
}

impl TimeLine {
    /// State that a link does not have, for [`TimeLine::take_over`]. The ghost is given up.
    pub(crate) fn pass_on(&mut self) -> PassedLine {
        PassedLine {
            playing: self.playing,
            kept: self.kept.iter().map(|kept| kept.shown).collect(),
            ghost: self.ghost.take().map(|ghost| ghost.traces),
            scales: self.scales.clone(),
        }
    }

    /// Continues the time line of the same document, whose link has been restored.
    pub(crate) fn take_over(&mut self, passed: PassedLine) -> Changes {
        for (kept, shown) in self.kept.iter_mut().zip(passed.kept) {
            kept.shown = shown;
        }
        if let Some(traces) = passed.ghost {
            self.ghost = Some(Ghost { traces });
        }
        if passed.scales.len() == self.scales.len() {
            self.scales = passed.scales;
        }
        if passed.playing { Changes::RUNS | self.play_on() } else { Changes::RUNS }
    }

    /// Takes over the present and the kept runs of another program, its speed, and its ghost if the curves are the same.
    /// Runs on if that one did. Returns what was dropped, in the chosen language.
    pub(crate) fn adopt(
        &mut self,
        basis: &Basis,
        (before, former): (&mut Self, &Basis),
        names: &Names,
    ) -> (Vec<String>, Changes) {
        self.speed = before.speed;
        self.compiler.clone_from(&before.compiler);
        let present = before.course.recipe();
        let time_shown = former.time_words(&before.course, present.time);
        let (recipe, mut lost) = basis.translated(&present, former, &time_shown, names);
        let same_motion = basis.model().moves_like(former.model());
        let same_layout =
            has_same_curves(basis.program(), former.program()) && self.columns.is_arranged_like(&before.columns);
        let same_columns = same_motion && same_layout && {
            let (graph, other) = (&basis.model().graph, &former.model().graph);
            graph.same(self.columns.nodes(), other, before.columns.nodes(), Some)
        };
        let mut work = MOST_WORK;
        before.follow_rows();
        let changes = if same_motion && recipe == present {
            self.adopt_run(basis, before, same_columns)
        } else {
            let (course, complete) = self.replay(basis, &recipe, Moments::Times, &mut work);
            if !complete && course.error().is_none() {
                let time = former.time_words(&before.course, recipe.front);
                lost.push(words::time(basis.language(), &time));
            }
            // The former time line itself is given up.
            let _ = before.keep_ghost(0);
            self.replace(course)
        };
        if same_layout {
            self.ghost = before.ghost.take();
        }
        self.playing = before.playing && self.course.history().is_some() && self.course.error().is_none();
        self.kept_issued = before.kept_issued;
        let translated = |recipe: &Recipe| {
            let (recipe, missing) = basis.translated(recipe, former, "", names);
            missing.is_empty().then_some(recipe)
        };
        let kept = self.adopt_kept(basis, (before, former), translated, same_columns, &mut work);
        lost.extend(kept.iter().map(|name| words::kept_run(basis.language(), name)));
        (lost, changes)
    }

    /// Takes over the run of another program unchanged; `with_columns` if its columns have the same values.
    fn adopt_run(&mut self, basis: &Basis, before: &mut Self, with_columns: bool) -> Changes {
        let nothing = Course::start(self.motion(basis), basis.defaults().clone(), 0);
        self.course = std::mem::replace(&mut before.course, nothing);
        self.course.set_overhead(self.columns.bytes_per_row());
        self.full = before.full;
        self.slippage = before.slippage;
        if let Some(time) = before.rewritten {
            self.note_rewritten(time);
        }
        if with_columns {
            self.traces = std::mem::take(&mut before.traces);
        }
        // The magnitudes of states determine their number format.
        self.scales.clone_from(&before.scales);
        Changes::NEW_RUN | self.moved()
    }

    /// Takes over the kept runs of another program, recomputed unless `translated` leaves their recipe as it is and the
    /// columns are the same. `translated` gives the recipe for this program; `None` if it does not fit. Returns the names
    /// of the runs that were dropped.
    fn adopt_kept(
        &mut self,
        basis: &Basis,
        (before, former): (&mut Self, &Basis),
        translated: impl Fn(&Recipe) -> Option<Recipe>,
        same_columns: bool,
        work: &mut u64,
    ) -> Vec<String> {
        let mut lost = Vec::new();
        let views = before.kept(former);
        for (kept, view) in std::mem::take(&mut before.kept).into_iter().zip(views) {
            match translated(&kept.recipe) {
                Some(recipe) if same_columns && recipe == kept.recipe => self.kept.push(kept),
                Some(recipe) => match self.compute(basis, &recipe, Moments::Times, work) {
                    Computed { recipe, traces, state, complete: true } => {
                        self.kept.push(Kept { recipe, traces, state, ..kept });
                    }
                    _ => lost.push(view.name),
                },
                None => lost.push(view.name),
            }
        }
        lost
    }
}
