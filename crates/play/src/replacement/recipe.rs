//! Conversion of a run of the former program to the new program.

use super::names::Names;
use crate::time::recipe::{Change, Recipe};
use crate::{Basis, words};
use engine::Setup;
use std::collections::BTreeMap;

impl Basis {
    /// Converts a recipe to this program. Returns also what does not fit, in the chosen language. The changes of the
    /// result must be located by their times. `time_shown` is the text of the time shown by the former program.
    pub(crate) fn translated(
        &self,
        recipe: &Recipe,
        before: &Basis,
        time_shown: &str,
        names: &Names,
    ) -> (Recipe, Vec<String>) {
        let mut left = BTreeMap::new();
        let mut parameters = |values: &[f64]| self.parameters_from(values, before, names, &mut left);
        let first = parameters(&recipe.setup.parameters);
        let changes =
            recipe.changes.iter().map(|change| Change { parameters: parameters(&change.parameters), ..*change });
        let mut changes: Vec<Change> = changes.collect();
        let mut lost: Vec<String> = left.iter().map(|(&index, &value)| before.parameter_text(index, value)).collect();
        let mut setup = self.setup_from(&recipe.setup, first, before, names, &mut lost);
        self.decide_start(&mut setup, &mut changes);
        let (mut front, mut time) = (recipe.front, recipe.time);
        if names.same_time {
            setup.presses = self.presses_from(&recipe.setup.presses, before, &mut lost);
        } else {
            if front > 0.0 {
                lost.push(words::time(self.language(), time_shown));
            }
            if let Some(last) = changes.pop() {
                setup.parameters = last.parameters;
            }
            changes.clear();
            (front, time) = (0.0, 0.0);
        }
        // Drops changes that no longer change anything.
        let mut now = setup.parameters.clone();
        changes.retain(|change| std::mem::replace(&mut now, change.parameters.clone()) != change.parameters);
        (Recipe { setup, changes, front, time }, lost)
    }

    /// Parameters (SI) of this program for those of the former one. Values that do not fit are stored in `left`, by the
    /// former index; the last value remains.
    fn parameters_from(
        &self,
        values: &[f64],
        before: &Basis,
        names: &Names,
        left: &mut BTreeMap<usize, f64>,
    ) -> Vec<f64> {
        let mut parameters = self.defaults().parameters.clone();
        for (index, (&value, default)) in values.iter().zip(&before.defaults().parameters).enumerate() {
            if value == *default {
                continue;
            }
            let admitted = names.parameter(index).and_then(|place| {
                let value = self.same_choice(before, (index, value), place)?;
                Some((place, self.admit(place, value).ok()?))
            });
            match admitted.and_then(|(place, value)| parameters.get_mut(place).zip(Some(value))) {
                Some((parameter, value)) => *parameter = value,
                None => _ = left.insert(index, value),
            }
        }
        parameters
    }

    fn setup_from(
        &self,
        former: &Setup,
        parameters: Vec<f64>,
        before: &Basis,
        names: &Names,
        lost: &mut Vec<String>,
    ) -> Setup {
        let mut setup = Setup { parameters, ..self.defaults().clone() };
        if let Some(start) = &former.start {
            let states = 0..self.model().states.len();
            setup.start = states.map(|state| start.get(names.former_state(state)?).copied()).collect();
            if setup.start.is_none() {
                lost.extend(before.start_texts(start));
            }
        }
        setup.drawings = self.drawings_from(former, before, lost);
        if former.method != before.defaults().method {
            if self.method_refusal(former.method).is_none() {
                setup.method = former.method;
            } else {
                lost.push(words::method_name(before.language(), former.method).to_owned());
            }
        }
        if former.step != before.defaults().step {
            if names.same_time {
                setup.step = former.step;
            } else {
                lost.push(before.step_words(former.step));
            }
        }
        setup
    }

    /// A parameter that determines an initial value of this model cannot change during the run: its last value is used
    /// from the start.
    fn decide_start(&self, setup: &mut Setup, changes: &mut [Change]) {
        let Some(last) = changes.last().map(|change| change.parameters.clone()) else { return };
        let sets =
            std::iter::once(&mut setup.parameters).chain(changes.iter_mut().map(|change| &mut change.parameters));
        for set in sets {
            for ((value, last), parameter) in set.iter_mut().zip(&last).zip(&self.model().parameters) {
                if parameter.restarts {
                    *value = *last;
                }
            }
        }
    }

    /// Converts a value of the former program. The number of a text may have changed.
    fn same_choice(&self, before: &Basis, (index, value): (usize, f64), place: usize) -> Option<f64> {
        match before.model().parameters.get(index)?.word(value, &before.model().texts) {
            Some(word) => self.model().parameters.get(place)?.chosen(word, &self.model().texts),
            None => Some(value),
        }
    }
}
