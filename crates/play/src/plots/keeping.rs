//! Keeping, showing and removing runs. Discarded rows become the ghost.

use crate::plots::kept::{Ghost, Kept, KeptView, MOST_KEPT};
use crate::plots::traces::{Columns, Traces};
use crate::removed::Removed;
use crate::time::course::Course;
use crate::time::recipe::{Moments, Recipe};
use crate::values::symbol::symbol;
use crate::{Announcement, Changes, Play, Refusal, words};

/// Maximum number of rows stored for a kept run or ghost.
const ROWS_KEPT: usize = 20_000;

/// A ghost with fewer rows does not replace another one: moving a slider leaves many short runs.
const ROWS_WORTH_SEEING: usize = 20;

impl Play {
    /// Keeps the present run; it is drawn behind later ones.
    pub fn keep(&mut self) -> Result<(), Refusal> {
        let recipe = self.course.recipe();
        self.follow();
        let traces = self.traces.thinned(0, ROWS_KEPT);
        self.keep_traces(recipe, traces)?;
        let name = self.kept().pop().map(|kept| kept.name).unwrap_or_default();
        self.announce(Announcement::Kept(name));
        Ok(())
    }

    /// Keeps a run by recomputing it. `work` is the limit in floating-point operations and is reduced by the work done.
    /// Returns true if it sufficed for the whole run.
    pub(crate) fn keep_recipe(&mut self, recipe: &Recipe, work: &mut u64) -> Result<bool, Refusal> {
        let (recipe, traces, complete) = self.compute_kept(recipe, Moments::Rows, work);
        self.keep_traces(recipe, traces)?;
        Ok(complete)
    }

    /// Recomputes a run. Returns the recipe of the computed part, its traces, and true if `work` sufficed for the whole
    /// run.
    pub(crate) fn compute_kept(&mut self, recipe: &Recipe, moments: Moments, work: &mut u64) -> (Recipe, Traces, bool) {
        let overhead = self.columns.bytes_per_row();
        // Drawn curves change the model and therefore the columns.
        let drawn = self.basis.model().with_drawings(&recipe.setup.drawings);
        let mut own = drawn.map(|model| Columns::new(&model, &self.basis.program().plots));
        let (mut course, complete) = Course::replay(self.basis.model(), recipe, moments, overhead, work);
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
        self.note(Changes::RUNS);
        Ok(())
    }

    /// All kept runs, oldest first.
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

    /// Shows or hides a kept run.
    pub fn show_kept(&mut self, id: u32, shown: bool) {
        if let Some(kept) = self.kept.iter_mut().find(|kept| kept.id == id) {
            kept.shown = shown;
            self.note(Changes::RUNS);
        }
    }

    /// Removes a kept run; can be undone.
    pub fn remove_kept(&mut self, id: u32) {
        let Some(view) = self.kept().into_iter().find(|view| view.id == id) else {
            return;
        };
        if let Some(place) = self.kept.iter().position(|kept| kept.id == id) {
            let kept = self.kept.remove(place);
            self.can_undo(Removed::Run(place, kept));
        }
        self.note(Changes::RUNS);
        self.announce(Announcement::Removed(view.name));
    }

    /// True if a ghost (the rows discarded last) is drawn.
    pub fn has_ghost(&self) -> bool {
        self.ghost.is_some()
    }

    /// Removes the ghost at the user's request; can be undone.
    pub fn remove_ghost(&mut self) {
        if let Some(ghost) = self.ghost.take() {
            self.can_undo(Removed::Ghost(ghost));
            self.note(Changes::RUNS);
            self.announce(Announcement::Removed(words::previous_run(self.basis.language()).to_owned()));
        }
    }

    /// Removes the ghost; cannot be undone.
    pub fn clear_ghost(&mut self) {
        if self.ghost.take().is_some() {
            self.note(Changes::RUNS);
        }
    }

    /// Turns the rows from index `first` on into the ghost, if there are enough to be seen.
    pub(crate) fn keep_ghost(&mut self, first: usize) {
        self.follow();
        let rows = self.traces.rows().saturating_sub(first);
        let worth = if self.ghost.is_some() { ROWS_WORTH_SEEING } else { 2 };
        if rows >= worth {
            // Starts one row earlier, so that the ghost joins the line that it left.
            self.ghost = Some(Ghost { traces: self.traces.thinned(first.saturating_sub(1), ROWS_KEPT) });
            self.note(Changes::RUNS);
        }
    }

    /// Name of a run, from its differences to the document's own run: `b = 200 kg/s, rk4`.
    fn recipe_name(&self, recipe: &Recipe) -> String {
        let model = self.basis.model();
        let last = recipe.last_parameters();
        let mut parts: Vec<String> = Vec::new();
        for (index, parameter) in model.parameters.iter().enumerate() {
            let (Some(&first), Some(&value)) = (recipe.setup.parameters.get(index), last.get(index)) else {
                continue;
            };
            let mut values = recipe.parameter_sets().filter_map(|set| set.get(index));
            if values.any(|value| *value != parameter.value) {
                let symbol = symbol(&parameter.name);
                let now = self.basis.parameter_value_text(index, value);
                parts.push(if first == value {
                    format!("{symbol} = {now}")
                } else {
                    format!("{symbol} = {} → {now}", self.basis.parameter_value_text(index, first))
                });
            }
        }
        let drawings = recipe.setup.drawings.iter().zip(&self.basis.defaults().drawings).enumerate();
        parts.extend(drawings.filter(|(_, (drawn, own))| drawn != own).map(|(index, _)| self.drawing_label(index)));
        parts.extend(self.press_texts(&recipe.setup.presses, recipe.front));
        parts.extend(recipe.setup.start.iter().flat_map(|start| self.basis.start_texts(start)));
        if recipe.setup.method != self.basis.defaults().method {
            parts.push(words::method_name(self.basis.language(), recipe.setup.method).to_owned());
        }
        if recipe.setup.step != self.basis.defaults().step {
            parts.push(self.basis.step_words(recipe.setup.step));
        }
        if parts.is_empty() { words::defaults(self.basis.language()).to_owned() } else { parts.join(", ") }
    }
}
