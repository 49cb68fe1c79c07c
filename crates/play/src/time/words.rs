//! Texts of times and runs.

use super::recipe::Recipe;
use super::transport::is_at;
use crate::values::symbol::symbol;
use crate::{Basis, Course, number, words};
use engine::Press;
use program::Button;

/// Initial length, in steps, of the time line and of plots against the independent variable.
const STEPS_AT_FIRST: f64 = 200.0;

impl Basis {
    /// End of the time line (SI). It starts with the length of a plot against time and doubles whenever the run reaches
    /// it, limited by the end set by the document. So the line shows the progress of the run without stretching in
    /// every frame.
    pub fn horizon(&self, at: &Course) -> f64 {
        let mut horizon = at.begun().step * STEPS_AT_FIRST;
        while horizon < at.front() {
            horizon *= 2.0;
        }
        self.program()
            .until
            .filter(|end| *end >= at.front() || is_at(at.front(), *end))
            .map_or(horizon, |end| horizon.min(end))
    }

    /// Initial length of plots against the independent variable (SI).
    pub(crate) fn first_part(&self, at: &Course) -> f64 {
        let first = at.begun().step * STEPS_AT_FIRST;
        self.program().until.map_or(first, |end| first.min(end))
    }

    /// Text of the time shown, `12,35 s`, with as many decimals as the step has, at least two.
    pub fn time_text(&self, at: &Course) -> String {
        self.time_words(at, at.time())
    }

    /// Text of any time (SI) in the same format, for the ends of the time line and for `aria-valuetext`.
    pub fn time_words(&self, at: &Course, time: f64) -> String {
        if let Some(group) = self.small_times(at) {
            return group.quantity(time);
        }
        let unit = &self.model().independent.unit;
        let number = self.time_number(at, time);
        if unit.text.is_empty() { number } else { format!("{number} {}", number::unit_text(&unit.text)) }
    }

    /// Format with a prefixed unit for times that would need more than six decimals or are all below a tenth of their
    /// unit; `None` if the unit fits.
    pub(crate) fn small_times(&self, at: &Course) -> Option<number::Group> {
        let longest = self.program().until.unwrap_or_else(|| self.horizon(at));
        let unit = &self.model().independent.unit;
        let is_small = self.step_decimals(at) > 6 || unit.from_si(longest) < 0.1;
        is_small.then(|| number::Group::of_scale(unit, longest, 4, self.style()))
    }

    /// Number of decimals of a time: that of the step, from two to six.
    pub(crate) fn time_decimals(&self, at: &Course) -> usize {
        self.step_decimals(at).clamp(2, 6)
    }

    /// Number of decimals that the step needs for three digits.
    fn step_decimals(&self, at: &Course) -> usize {
        number::decimals(self.model().independent.unit.from_si(at.begun().step), 3)
    }

    pub(crate) fn time_number(&self, at: &Course, time: f64) -> String {
        if self.model().independent.counts {
            return number::fixed(time.floor(), 0, self.style());
        }
        let unit = &self.model().independent.unit;
        number::fixed(unit.from_si(time), self.time_decimals(at), self.style())
    }

    /// Name of a run, from its differences to a run with the parameters `others` (SI): `b = 200 kg/s, rk4`. A run with these
    /// parameters is named by its differences to the document's own run.
    pub(super) fn recipe_name(&self, at: &Course, recipe: &Recipe, others: &[f64]) -> String {
        let model = self.model();
        let last = recipe.last_parameters();
        let own: Vec<f64> = model.parameters.iter().map(|parameter| parameter.value).collect();
        let is_same = recipe.parameter_sets().all(|set| set == others);
        let others = if is_same { &own[..] } else { others };
        let mut parts: Vec<String> = Vec::new();
        for (index, parameter) in model.shown_parameters() {
            let (Some(&first), Some(&value), Some(other)) =
                (recipe.setup.parameters.get(index), last.get(index), others.get(index))
            else {
                continue;
            };
            let mut values = recipe.parameter_sets().filter_map(|set| set.get(index));
            if values.any(|value| value != other) {
                let symbol = symbol(&parameter.name);
                let now = self.parameter_value_text(index, value);
                parts.push(if first == value {
                    format!("{symbol} = {now}")
                } else {
                    format!("{symbol} = {} → {now}", self.parameter_value_text(index, first))
                });
            }
        }
        let drawings = recipe.setup.drawings.iter().zip(&self.defaults().drawings).enumerate();
        parts.extend(drawings.filter(|(_, (drawn, own))| drawn != own).map(|(index, _)| self.drawing_label(index)));
        parts.extend(self.press_texts(at, &recipe.setup.presses, recipe.front));
        parts.extend(recipe.setup.start.iter().flat_map(|start| self.start_texts(start)));
        if recipe.setup.method != self.defaults().method {
            parts.push(words::method_name(self.language(), recipe.setup.method).to_owned());
        }
        if recipe.setup.step != self.defaults().step {
            parts.push(self.step_words(recipe.setup.step));
        }
        if parts.is_empty() { words::defaults(self.language()).to_owned() } else { parts.join(", ") }
    }

    /// Texts such as `Kick 3.20 s` for the presses of a run up to the time `until` (SI). If there are many presses, one
    /// count per button instead.
    pub(crate) fn press_texts(&self, at: &Course, presses: &[Press], until: f64) -> Vec<String> {
        /// Up to this number, presses are listed individually.
        const FEW: usize = 3;
        let presses: Vec<&Press> = presses.iter().filter(|press| press.time <= until).collect();
        let title = |button: &Button| self.text(&button.title).to_owned();
        let buttons = &self.model().buttons;
        if presses.len() <= FEW {
            let one = |press: &&Press| {
                Some(format!("{} {}", title(buttons.get(press.button)?), self.time_words(at, press.time)))
            };
            return presses.iter().filter_map(one).collect();
        }
        let counted = buttons
            .iter()
            .enumerate()
            .map(|(index, button)| (presses.iter().filter(|press| press.button == index).count(), button));
        counted.filter(|(count, _)| *count > 0).map(|(count, button)| format!("{} × {count}", title(button))).collect()
    }
}
