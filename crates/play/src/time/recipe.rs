//! Data from which a run can be recomputed: its settings and the changes during the run.

use crate::motion::Motion;
use crate::time::course::{Course, Outcome};
use engine::{Advance, Setup};

/// Maximum work for all recomputed runs together, in floating-point operations. A link may come from a stranger, and
/// the page is blocked meanwhile: about a second on a slow phone.
pub(crate) const MOST_WORK: u64 = 50_000_000;

/// Settings of a run and the changes of parameters during it.
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    /// Initial settings.
    pub setup: Setup,
    /// Changes in the order of time.
    pub changes: Vec<Change>,
    /// Greatest time reached (SI).
    pub front: f64,
    /// Time shown (SI).
    pub time: f64,
}

/// A change of parameters during the run.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// First row to which the parameters apply.
    pub row: usize,
    /// Time of the previous row (SI), at which the change was made. Unlike the row, it depends neither on the step nor
    /// on the rows of events.
    pub after: f64,
    /// All parameters from then on, SI.
    pub parameters: Vec<f64>,
}

/// Property that determines the moment of a [`Change`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moments {
    /// The row: for the model with which the recipe was made.
    Rows,
    /// The time: for another model.
    Times,
}

impl Recipe {
    /// Parameters at the end, SI.
    pub fn last_parameters(&self) -> &[f64] {
        self.changes.last().map_or(&self.setup.parameters, |change| &change.parameters)
    }

    /// All parameter sets (SI), in the order of time.
    pub fn parameter_sets(&self) -> impl Iterator<Item = &[f64]> {
        std::iter::once(&self.setup.parameters[..]).chain(self.changes.iter().map(|change| &change.parameters[..]))
    }
}

impl Course {
    /// Recipe of this run.
    pub fn recipe(&self) -> Recipe {
        let changes = self.history().into_iter().flat_map(|history| {
            // The first set is that of the start.
            history.parameter_sets().iter().skip(1).map(|(row, parameters)| Change {
                row: *row,
                after: history.time(row - 1),
                parameters: parameters.clone(),
            })
        });
        Recipe { setup: self.begun().clone(), changes: changes.collect(), front: self.front(), time: self.time() }
    }

    /// Recomputes a recipe. `left` is the remaining work in floating-point operations ([`engine::Run::work`]) and is
    /// reduced by the work done. Returns true if the recipe could be followed to its end.
    pub fn replay(motion: Motion, recipe: &Recipe, moments: Moments, overhead: usize, left: &mut u64) -> (Self, bool) {
        let mut course = Self::start(motion, recipe.setup.clone(), overhead);
        for change in &recipe.changes {
            let is_due = |course: &Self| match moments {
                Moments::Rows => course.rows_computed() >= change.row,
                Moments::Times => course.has_computed(change.after),
            };
            while !is_due(&course) && *left > 0 {
                // The run had been continued beyond its end.
                course.go_on();
                if matches!(course.advance(left), None | Some(Advance::Full)) {
                    break;
                }
            }
            if !is_due(&course) || (moments == Moments::Rows && course.rows_computed() != change.row) {
                course.proceed(course.last_time(), &mut 0);
                return (course, false);
            }
            course.set_parameters(motion, change.parameters.clone());
        }
        let mut outcome = course.proceed(recipe.front, left);
        while outcome == Outcome::Failed && course.is_behind(recipe.front) && course.has_ended() {
            course.go_on();
            outcome = course.proceed(recipe.front, left);
        }
        let complete = outcome == Outcome::Reached || course.has_ended() && course.last_time() >= recipe.front;
        course.show(recipe.time.min(course.front()));
        (course, complete)
    }
}
