//! Keeping, showing and removing runs. Discarded rows become the ghost.

use super::TimeLine;
use super::course::Course;
use super::kept::{Ghost, Kept, KeptValues, KeptView, MOST_KEPT};
use super::recipe::{Moments, Recipe};
use crate::plots::traces::{Columns, Traces};
use crate::removed::Removed;
use crate::{Announcement, Basis, Changes, Refusal, words};

/// Maximum number of rows stored for a kept run or ghost.
const ROWS_KEPT: usize = 20_000;

/// A ghost with fewer rows does not replace another one: moving a slider leaves many short runs.
const ROWS_WORTH_SEEING: usize = 20;

/// A recomputed run.
pub(super) struct Computed {
    /// Recipe of the computed part.
    pub(super) recipe: Recipe,
    pub(super) traces: Traces,
    /// State at the time of the recipe, SI.
    pub(super) state: Vec<f64>,
    /// True if the work sufficed for the whole run.
    pub(super) complete: bool,
}

impl TimeLine {
    /// Keeps the present run; it is drawn behind later ones.
    ///
    /// # Errors
    ///
    /// [`MOST_KEPT`] runs are kept already.
    pub fn keep(&mut self, basis: &Basis) -> Result<Changes, Refusal> {
        self.follow_rows();
        let (recipe, state) = (self.course.recipe(), self.course.state().to_vec());
        let changes = self.keep_traces(recipe, self.traces.thinned(0, ROWS_KEPT), state)?;
        let name = self.kept(basis).pop().map(|kept| kept.name).unwrap_or_default();
        Ok(changes.announcing(Announcement::Kept(name)))
    }

    /// Keeps a run by recomputing it. `work` is the limit in floating-point operations and is reduced by the work done.
    /// Returns true if it sufficed for the whole run.
    pub(crate) fn keep_recipe(
        &mut self,
        basis: &Basis,
        recipe: &Recipe,
        work: &mut u64,
    ) -> Result<(bool, Changes), Refusal> {
        let Computed { recipe, traces, state, complete } = self.compute(basis, recipe, Moments::Rows, work);
        Ok((complete, self.keep_traces(recipe, traces, state)?))
    }

    /// Recomputes a run.
    pub(super) fn compute(&mut self, basis: &Basis, recipe: &Recipe, moments: Moments, work: &mut u64) -> Computed {
        // Drawn curves change the model and therefore the columns.
        let drawn = basis.model().with_drawings(&recipe.setup.drawings);
        let mut own = drawn.map(|model| Columns::new(&model, &basis.program().plots));
        let (mut course, complete) = self.replay(basis, recipe, moments, work);
        let (recipe, state) = (course.recipe(), course.state().to_vec());
        course.show(course.front());
        let mut present = Vec::new();
        let mut traces = Traces::default();
        let columns = own.as_mut().unwrap_or(&mut self.columns);
        columns.present(&course, &mut present);
        traces.follow(&course, columns, &present);
        Computed { recipe, traces: traces.thinned(0, ROWS_KEPT), state, complete }
    }

    /// Recomputes a run; see [`Course::replay`].
    pub(crate) fn replay(&self, basis: &Basis, recipe: &Recipe, moments: Moments, work: &mut u64) -> (Course, bool) {
        Course::replay(self.motion(basis), recipe, moments, self.columns.bytes_per_row(), work)
    }

    fn keep_traces(&mut self, recipe: Recipe, traces: Traces, state: Vec<f64>) -> Result<Changes, Refusal> {
        if self.kept.len() >= MOST_KEPT {
            return Err(Refusal::TooManyRuns { most: MOST_KEPT });
        }
        let free = |pattern: &u8| self.kept.iter().all(|kept| kept.pattern != *pattern);
        let pattern = (0..MOST_KEPT as u8).find(free).unwrap_or(0);
        self.kept_issued += 1;
        let id = self.kept_issued;
        self.kept.push(Kept { id, recipe, shown: true, pattern, traces, state });
        Ok(Changes::RUNS)
    }

    /// All kept runs, oldest first.
    pub fn kept(&self, basis: &Basis) -> Vec<KeptView> {
        self.kept_beside(basis, self.course.parameters())
    }

    /// All kept runs, named by their differences to a run with these parameters (SI).
    fn kept_beside(&self, basis: &Basis, parameters: &[f64]) -> Vec<KeptView> {
        let mut views: Vec<KeptView> = Vec::new();
        for kept in &self.kept {
            let name = basis.recipe_name(&self.course, &kept.recipe, parameters);
            let same =
                views.iter().filter(|view| view.name == name || view.name.starts_with(&format!("{name} ("))).count();
            let name = if same == 0 { name } else { format!("{name} ({})", same + 1) };
            views.push(KeptView { id: kept.id, name, shown: kept.shown, pattern: kept.pattern });
        }
        views
    }

    /// Values of the kept runs at their times, oldest first.
    pub fn kept_values(&self, basis: &Basis) -> Vec<KeptValues> {
        let values = |(kept, view): (&Kept, KeptView)| KeptValues {
            name: view.name,
            time: kept.recipe.time,
            parameters: kept.recipe.last_parameters().to_vec(),
            state: kept.state.clone(),
        };
        // A hand-in is compared by these names, whatever the present run is.
        let own: Vec<f64> = basis.model().parameters.iter().map(|parameter| parameter.value).collect();
        self.kept.iter().zip(self.kept_beside(basis, &own)).map(values).collect()
    }

    /// Recipes of the kept runs, oldest first.
    pub(crate) fn kept_recipes(&self) -> impl Iterator<Item = &Recipe> {
        self.kept.iter().map(|kept| &kept.recipe)
    }

    /// Traces and patterns of the kept runs that are drawn, oldest first.
    pub(crate) fn kept_traces(&self) -> impl Iterator<Item = (&Traces, u8)> {
        self.kept.iter().filter(|kept| kept.shown).map(|kept| (&kept.traces, kept.pattern))
    }

    /// Traces of the rows discarded last, if they are drawn.
    pub(crate) fn ghost_traces(&self) -> Option<&Traces> {
        self.ghost.as_ref().map(|ghost| &ghost.traces)
    }

    /// Shows or hides a kept run.
    pub fn show_kept(&mut self, id: u32, shown: bool) -> Changes {
        let kept = self.kept.iter_mut().find(|kept| kept.id == id);
        Changes::RUNS.only_if(kept.map(|kept| kept.shown = shown).is_some())
    }

    /// Removes a kept run; can be undone.
    pub fn remove_kept(&mut self, basis: &Basis, id: u32) -> Changes {
        let mut views = self.kept(basis).into_iter().enumerate();
        let Some((place, view)) = views.find(|(_, view)| view.id == id) else { return Changes::NONE };
        let removed = Removed::Run(place, self.kept.remove(place));
        Changes::RUNS.removing(removed).announcing(Announcement::Removed(view.name))
    }

    /// Removes the ghost at the user's request; can be undone.
    pub fn remove_ghost(&mut self, basis: &Basis) -> Changes {
        let Some(ghost) = self.ghost.take() else { return Changes::NONE };
        let name = words::previous_run(basis.language()).to_owned();
        Changes::RUNS.removing(Removed::Ghost(ghost)).announcing(Announcement::Removed(name))
    }

    /// Removes the ghost; cannot be undone.
    pub fn clear_ghost(&mut self) -> Changes {
        Changes::RUNS.only_if(self.ghost.take().is_some())
    }

    /// Inserts a kept run at a position, or at the end if the list has become shorter.
    pub(crate) fn insert_kept(&mut self, place: usize, kept: Kept) -> Changes {
        self.kept.insert(place.min(self.kept.len()), kept);
        Changes::RUNS
    }

    /// Removes all kept runs and the ghost.
    pub(crate) fn forget_runs(&mut self) -> Changes {
        self.kept.clear();
        self.ghost = None;
        Changes::RUNS
    }

    /// True if a ghost (the rows discarded last) is drawn.
    pub fn has_ghost(&self) -> bool {
        self.ghost.is_some()
    }

    /// Sets the ghost.
    pub(crate) fn set_ghost(&mut self, ghost: Ghost) -> Changes {
        self.ghost = Some(ghost);
        Changes::RUNS
    }

    /// Turns the rows from index `first` on into the ghost, if there are enough to be seen.
    pub(crate) fn keep_ghost(&mut self, first: usize) -> Changes {
        self.follow_rows();
        let rows = self.traces.rows().saturating_sub(first);
        let worth = if self.ghost.is_some() { ROWS_WORTH_SEEING } else { 2 };
        if rows < worth {
            return Changes::NONE;
        }
        // Starts one row earlier, so that the ghost joins the line that it left.
        self.set_ghost(Ghost { traces: self.traces.thinned(first.saturating_sub(1), ROWS_KEPT) })
    }
}
