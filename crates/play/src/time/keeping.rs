//! Keeping, showing and removing runs. Discarded rows become the ghost.

use super::TimeLine;
use super::course::Course;
use super::kept::{Ghost, Kept, KeptValues, KeptView, MOST_KEPT};
use super::recipe::{Moments, Recipe};
use crate::plots::traces::{Columns, Traces};
use crate::{Basis, Changes, Refusal};

/// Maximum number of rows stored for a kept run or ghost.
const ROWS_KEPT: usize = 20_000;

/// A ghost with fewer rows does not replace another one: moving a slider leaves many short runs.
const ROWS_WORTH_SEEING: usize = 20;

/// A recomputed run.
struct Computed {
    /// Recipe of the computed part.
    recipe: Recipe,
    traces: Traces,
    /// State at the time of the recipe, SI.
    state: Vec<f64>,
    /// True if the work sufficed for the whole run.
    complete: bool,
}

impl TimeLine {
    /// Keeps the present run, whose columns must be up to date; it is drawn behind later ones.
    pub(crate) fn keep(&mut self) -> Result<Changes, Refusal> {
        let state = self.course.state().to_vec();
        self.keep_traces(self.course.recipe(), self.traces.thinned(0, ROWS_KEPT), state)
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
    fn compute(&mut self, basis: &Basis, recipe: &Recipe, moments: Moments, work: &mut u64) -> Computed {
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
        Course::replay(basis.model(), recipe, moments, self.columns.bytes_per_row(), work)
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
        let mut views: Vec<KeptView> = Vec::new();
        for kept in &self.kept {
            let name = basis.recipe_name(&self.course, &kept.recipe);
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
        self.kept.iter().zip(self.kept(basis)).map(values).collect()
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
    pub(crate) fn show_kept(&mut self, id: u32, shown: bool) -> Changes {
        let kept = self.kept.iter_mut().find(|kept| kept.id == id);
        Changes::RUNS.only_if(kept.map(|kept| kept.shown = shown).is_some())
    }

    /// Removes a kept run. Returns it with its position.
    pub(crate) fn take_kept(&mut self, id: u32) -> Option<(usize, Kept)> {
        let place = self.kept.iter().position(|kept| kept.id == id)?;
        Some((place, self.kept.remove(place)))
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

    /// Takes over the kept runs of another program, recomputed unless `is_same` holds for their recipe. `translated`
    /// gives the recipe for this program; `None` if it does not fit. Returns the names of the runs that were dropped.
    pub(crate) fn adopt_kept(
        &mut self,
        basis: &Basis,
        (before, former_basis): (&mut Self, &Basis),
        translated: impl Fn(&Recipe) -> Option<Recipe>,
        same_columns: bool,
        work: &mut u64,
    ) -> Vec<String> {
        let mut lost = Vec::new();
        let views = before.kept(former_basis);
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

    /// True if a ghost (the rows discarded last) is drawn.
    pub fn has_ghost(&self) -> bool {
        self.ghost.is_some()
    }

    /// Removes the ghost and returns it.
    pub(crate) fn take_ghost(&mut self) -> Option<Ghost> {
        self.ghost.take()
    }

    /// Sets the ghost.
    pub(crate) fn set_ghost(&mut self, ghost: Ghost) -> Changes {
        self.ghost = Some(ghost);
        Changes::RUNS
    }

    /// Turns the rows from index `first` on into the ghost, if there are enough to be seen. The columns must be up to
    /// date.
    pub(crate) fn keep_ghost(&mut self, first: usize) -> Changes {
        let rows = self.traces.rows().saturating_sub(first);
        let worth = if self.ghost.is_some() { ROWS_WORTH_SEEING } else { 2 };
        if rows < worth {
            return Changes::NONE;
        }
        // Starts one row earlier, so that the ghost joins the line that it left.
        self.set_ghost(Ghost { traces: self.traces.thinned(first.saturating_sub(1), ROWS_KEPT) })
    }
}
