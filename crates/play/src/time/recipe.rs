//! How to make a run again: what it starts with, and what was changed on the way.

use crate::time::course::{Course, Outcome};
use engine::{Advance, Setup};
use program::Model;

/// The same run again: from these values, with these changes of parameters on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    /// What it starts with.
    pub setup: Setup,
    /// In the order of time.
    pub changes: Vec<Change>,
    /// How far it goes (SI).
    pub front: f64,
    /// Which moment is shown (SI).
    pub time: f64,
}

/// A change of parameters on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The first row they hold for.
    pub row: usize,
    /// The time of the row before (SI), which is that of the change. Unlike the row it does not depend on the step, nor on the
    /// rows that events leave.
    pub after: f64,
    /// All parameters from then on, SI.
    pub parameters: Vec<f64>,
}

/// What tells the moment of a [`Change`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moments {
    /// Its row: for the model that the recipe was made with.
    Rows,
    /// Its time: for another model.
    Times,
}

impl Recipe {
    /// The parameters at the end.
    pub fn last_parameters(&self) -> &[f64] {
        self.changes.last().map_or(&self.setup.parameters, |change| &change.parameters)
    }

    /// All sets of parameters, in the order of time.
    pub fn parameter_sets(&self) -> impl Iterator<Item = &[f64]> {
        std::iter::once(&self.setup.parameters[..]).chain(self.changes.iter().map(|change| &change.parameters[..]))
    }
}

impl Course {
    /// How to make this run again.
    pub fn recipe(&self) -> Recipe {
        let changes = self.history().into_iter().flat_map(|history| {
            // The first set is what the run was started with.
            history.parameter_sets().iter().skip(1).map(|(row, parameters)| Change {
                row: *row,
                after: history.time(row - 1),
                parameters: parameters.clone(),
            })
        });
        Recipe { setup: self.begun().clone(), changes: changes.collect(), front: self.front(), time: self.time() }
    }

    /// Runs a recipe with no more than about the work in `left` ([`engine::Run::work`]), from which what was done is taken.
    /// Returns whether it could be followed to its end.
    pub fn replay(model: &Model, recipe: &Recipe, moments: Moments, overhead: usize, left: &mut u64) -> (Self, bool) {
        let mut course = Self::start(model, recipe.setup.clone(), overhead);
        for change in &recipe.changes {
            let is_due = |course: &Self| match moments {
                Moments::Rows => course.rows_computed() >= change.row,
                Moments::Times => course.has_computed(change.after),
            };
            while !is_due(&course) && *left > 0 {
                // What was gone on with beyond its end is here, too.
                course.go_on();
                if matches!(course.advance(left), None | Some(Advance::Full)) {
                    break;
                }
            }
            if !is_due(&course) || (moments == Moments::Rows && course.rows_computed() != change.row) {
                course.proceed(course.last_time(), &mut 0);
                return (course, false);
            }
            course.set_parameters(model, change.parameters.clone());
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
