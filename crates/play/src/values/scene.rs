//! Values of the scene, and of the outline drawn over it.

use super::Values;
use super::readout::MOVING_DIGITS;
use crate::{Basis, Course, TimeLine, number};
use program::Kind;
use units::number::Group;

impl Values {
    /// Values of [`program::Scene::values`] at the time shown, SI, for attributes. Computed once per frame.
    pub(crate) fn scene_values(&mut self, at: &Course) -> &[f64] {
        if !std::mem::replace(&mut self.scene_is_current, true) {
            let values = self.scene.at(at.parameters(), at.initial(), at.time(), at.state());
            self.scene_values.clear();
            self.scene_values.extend_from_slice(values);
            self.scene_scales.resize(values.len(), 0.0);
            for (scale, value) in self.scene_scales.iter_mut().zip(values) {
                if value.is_finite() {
                    *scale = scale.max(value.abs());
                }
            }
        }
        &self.scene_values
    }

    /// Values of the scene for a run that starts with these parameters and this state, SI.
    pub(crate) fn scene_at_start(&mut self, parameters: &[f64], state: &[f64]) -> &[f64] {
        self.scene.at(parameters, state, 0.0, state)
    }

    /// The scene as it is shown.
    pub(crate) fn scene<'a>(&'a mut self, basis: &'a Basis, line: &'a mut TimeLine) -> ShownScene<'a> {
        ShownScene { basis, line, values: self }
    }
}

/// The values of the scene as they are shown: of the run, in the chosen language.
#[derive(Debug)]
pub struct ShownScene<'a> {
    basis: &'a Basis,
    line: &'a mut TimeLine,
    values: &'a mut Values,
}

impl<'a> ShownScene<'a> {
    /// Values of [`program::Scene::values`] at the time shown, SI, for attributes. Computed once per frame.
    pub fn values(self) -> &'a [f64] {
        let Self { line, values, .. } = self;
        values.scene_values(line.course())
    }

    /// Writes the path of a trail up to the time shown into `path`, in scene units: a line, or dots (segments of length
    /// zero).
    pub fn write_trail(self, number: usize, path: &mut String) {
        path.clear();
        let Some(trail) = self.basis.scene().and_then(|scene| scene.trails.get(number)) else { return };
        let values = self.values.scene_values(self.line.course());
        let value = |index: usize| values.get(index).copied().unwrap_or(f64::NAN);
        let (last, every) = (trail.last.map(value), trail.every.map(value));
        let from = last.map_or(0.0, |last| (self.line.course().time() - last).max(0.0));
        match every {
            Some(every) => {
                self.values.trails.write_dots(self.line.course_between_rows(), number, (from, every), path);
            }
            None => self.values.trails.write_line(self.line.course(), number, from, path),
        }
    }

    /// Value `index` of the scene at the time shown, formatted with its unit; empty for an unknown index.
    pub fn text(self, index: usize, decimals: Option<u8>) -> String {
        let basis = self.basis;
        let Some(&value) = self.values.scene_values(self.line.course()).get(index) else {
            return String::new();
        };
        let Some(shown) = basis.scene().and_then(|scene| scene.values.get(index)) else {
            return String::new();
        };
        if shown.kind != Kind::Number {
            return basis.word_value(shown, value);
        }
        match decimals {
            Some(decimals) => {
                let number = number::fixed(shown.unit.from_si(value), usize::from(decimals), basis.style());
                number::with_unit(&number, &shown.unit)
            }
            None if basis.is_count(shown.node, &shown.unit) => basis.count(value),
            None => {
                let scale = self.values.scene_scales.get(index).copied().unwrap_or_default();
                Group::of_scale(&shown.unit, scale, MOVING_DIGITS, basis.style()).quantity(value)
            }
        }
    }
}
