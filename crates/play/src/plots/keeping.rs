//! Runs are kept, shown, removed; what is given up becomes the ghost.

use crate::plots::kept::{Ghost, Kept, KeptView, MOST_KEPT};
use crate::plots::traces::{Columns, Traces};
use crate::removed::Removed;
use crate::time::course::Course;
use crate::time::recipe::{Moments, Recipe};
use crate::values::symbol::symbol;
use crate::{Announcement, Play, Refusal, words};
use program::State;

/// The most rows that are kept of a run that is only looked at.
const ROWS_KEPT: usize = 20_000;

/// A ghost with fewer rows than this does not replace another: it is one of the short runs that moving a slider leaves.
const ROWS_WORTH_SEEING: usize = 20;

impl Play {
    /// Keeps the run as it is now, to be drawn behind later ones.
    pub fn keep(&mut self) -> Result<(), Refusal> {
        let recipe = self.course.recipe();
        self.follow();
        let traces = self.traces.thinned(0, ROWS_KEPT);
        self.keep_traces(recipe, traces)?;
        let name = self.kept().pop().map(|kept| kept.name).unwrap_or_default();
        self.announce(Announcement::Kept(name));
        Ok(())
    }

    /// Keeps a run of this model by computing it again with no more than the work given, from which what was done is taken.
    /// Returns whether that was enough for all of it.
    pub(crate) fn keep_recipe(&mut self, recipe: &Recipe, work: &mut u64) -> Result<bool, Refusal> {
        let (recipe, traces, complete) = self.compute_kept(recipe, Moments::Rows, work);
        self.keep_traces(recipe, traces)?;
        Ok(complete)
    }

    /// The recipe of the run that was computed, what is drawn of it, and whether the work was enough for all of it.
    pub(crate) fn compute_kept(&mut self, recipe: &Recipe, moments: Moments, work: &mut u64) -> (Recipe, Traces, bool) {
        let overhead = self.columns.bytes_per_row();
        // What is drawn decides the columns, too.
        let drawn = self.program.model.with_drawings(&recipe.setup.drawings);
        let mut own = drawn.map(|model| Columns::new(&model, &self.program.plots));
        let (mut course, complete) = Course::replay(&self.program.model, recipe, moments, overhead, work);
        let computed = course.recipe();
        course.show(course.front());
        let mut present = Vec::new();
        let mut traces = Traces::default();
        let columns = own.as_mut().unwrap_or(&mut self.columns);
        columns.present(&course, &mut present);
        traces.follow(&course, columns, &present);
        (computed, traces.thinned(0, ROWS_KEPT), complete)
    }

    fn keep_traces(&mut self, recipe: Recipe, traces: Traces) -> Result<(), Refusal> {
        if self.kept.len() >= MOST_KEPT {
            return Err(Refusal::TooManyRuns { most: MOST_KEPT });
        }
        let free = |pattern: &u8| self.kept.iter().all(|kept| kept.pattern != *pattern);
        let pattern = (0..MOST_KEPT as u8).find(free).unwrap_or(0);
        self.kept_issued += 1;
        let id = self.kept_issued;
        self.kept.push(Kept { id, recipe, shown: true, pattern, traces });
        self.revision.runs += 1;
        Ok(())
    }

    /// The kept runs, oldest first.
    pub fn kept(&self) -> Vec<KeptView> {
        let mut views: Vec<KeptView> = Vec::new();
        for kept in &self.kept {
            let name = self.recipe_name(&kept.recipe);
            let same =
                views.iter().filter(|view| view.name == name || view.name.starts_with(&format!("{name} ("))).count();
            let name = if same == 0 { name } else { format!("{name} ({})", same + 1) };
            views.push(KeptView { id: kept.id, name, shown: kept.shown, pattern: kept.pattern });
        }
        views
    }

    /// Draws a kept run or not.
    pub fn show_kept(&mut self, id: u32, shown: bool) {
        if let Some(kept) = self.kept.iter_mut().find(|kept| kept.id == id) {
            kept.shown = shown;
            self.revision.runs += 1;
        }
    }

    /// Forgets a kept run.
    pub fn remove_kept(&mut self, id: u32) {
        let Some(view) = self.kept().into_iter().find(|view| view.id == id) else {
            return;
        };
        if let Some(place) = self.kept.iter().position(|kept| kept.id == id) {
            let kept = self.kept.remove(place);
            self.can_undo(Removed::Run(place, kept));
        }
        self.revision.runs += 1;
        self.announce(Announcement::Removed(view.name));
    }

    /// Whether the rows given up last are drawn.
    pub fn has_ghost(&self) -> bool {
        self.ghost.is_some()
    }

    /// Removes the ghost at a person's wish; it can be put back.
    pub fn remove_ghost(&mut self) {
        if let Some(ghost) = self.ghost.take() {
            self.can_undo(Removed::Ghost(ghost));
            self.revision.runs += 1;
            self.announce(Announcement::Removed(words::previous_run(self.language).to_owned()));
        }
    }

    /// Forgets the ghost.
    pub fn clear_ghost(&mut self) {
        if self.ghost.take().is_some() {
            self.revision.runs += 1;
        }
    }

    /// Makes the rows of the run from `first` on the ghost, if there is something to see.
    pub(crate) fn keep_ghost(&mut self, first: usize) {
        self.follow();
        let rows = self.traces.rows().saturating_sub(first);
        let worth = if self.ghost.is_some() { ROWS_WORTH_SEEING } else { 2 };
        if rows >= worth {
            // From the row before on, so that the ghost hangs on to the line it left.
            self.ghost = Some(Ghost { traces: self.traces.thinned(first.saturating_sub(1), ROWS_KEPT) });
            self.revision.runs += 1;
        }
    }

    /// `y(0) = 0.3 m` for each state of a start set by hand.
    pub(crate) fn start_texts(&self, start: &[f64]) -> Vec<String> {
        let text = |(state, &value): (&State, &f64)| {
            format!("{}(0) = {}", symbol(&state.name()), self.quantity_text(value, &state.unit))
        };
        self.model().states.iter().zip(start).map(text).collect()
    }

    /// `h = 0.01 s`
    pub(crate) fn step_words(&self, step: f64) -> String {
        format!("h = {}", self.quantity_text(step, &self.model().independent.unit))
    }

    /// What distinguishes a run from the document's own: `b = 200 kg/s, rk4`.
    fn recipe_name(&self, recipe: &Recipe) -> String {
        let model = &self.program.model;
        let last = recipe.last_parameters();
        let mut parts: Vec<String> = Vec::new();
        for (index, parameter) in model.parameters.iter().enumerate() {
            let (Some(&first), Some(&value)) = (recipe.setup.parameters.get(index), last.get(index)) else {
                continue;
            };
            let mut values = recipe.parameter_sets().filter_map(|set| set.get(index));
            if values.any(|value| *value != parameter.value) {
                let symbol = symbol(&parameter.name);
                let now = self.parameter_value_text(index, value);
                parts.push(if first == value {
                    format!("{symbol} = {now}")
                } else {
                    format!("{symbol} = {} → {now}", self.parameter_value_text(index, first))
                });
            }
        }
        let drawings = recipe.setup.drawings.iter().zip(&self.defaults.drawings).enumerate();
        parts.extend(drawings.filter(|(_, (drawn, own))| drawn != own).map(|(index, _)| self.drawing_label(index)));
        parts.extend(self.press_texts(&recipe.setup.presses, recipe.front));
        parts.extend(recipe.setup.start.iter().flat_map(|start| self.start_texts(start)));
        if recipe.setup.method != self.defaults.method {
            parts.push(words::method_name(self.language, recipe.setup.method).to_owned());
        }
        if recipe.setup.step != self.defaults.step {
            parts.push(self.step_words(recipe.setup.step));
        }
        if parts.is_empty() { words::defaults(self.language).to_owned() } else { parts.join(", ") }
    }
}
