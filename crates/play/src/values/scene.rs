//! Values of the scene, and of the outline drawn over it.

use super::outline::Outline;
use super::readout::MOVING_DIGITS;
use crate::{Play, number};
use program::Kind;
use units::number::Group;

impl Play {
    /// Values of [`program::Scene::values`] at the time shown, SI, for attributes. Computed once per frame.
    pub fn scene_values(&mut self) -> &[f64] {
        let frame = (self.revision.frame, self.revision.parameters);
        if self.evaluators.scene_frame != Some(frame) {
            let course = self.line.course();
            let values = self.evaluators.scene.at(course.parameters(), course.initial(), course.time(), course.state());
            self.evaluators.scene_values.clear();
            self.evaluators.scene_values.extend_from_slice(values);
            self.evaluators.scene_scales.resize(values.len(), 0.0);
            for (scale, value) in self.evaluators.scene_scales.iter_mut().zip(values) {
                if value.is_finite() {
                    *scale = scale.max(value.abs());
                }
            }
            self.evaluators.scene_frame = Some(frame);
        }
        &self.evaluators.scene_values
    }

    /// Writes the path of a trail up to the time shown into `path`, in scene units: a line, or dots (segments of length
    /// zero).
    pub fn scene_trail(&mut self, number: usize, path: &mut String) {
        path.clear();
        self.scene_values();
        let Some(trail) = self.basis.scene().and_then(|scene| scene.trails.get(number)) else { return };
        let value = |index: usize| self.evaluators.scene_values.get(index).copied().unwrap_or(f64::NAN);
        let (last, every) = (trail.last.map(value), trail.every.map(value));
        let from = last.map_or(0.0, |last| (self.course().time() - last).max(0.0));
        let trails = &mut self.evaluators.trails;
        match every {
            Some(every) => trails.write_dots(self.line.course_between_rows(), number, (from, every), path),
            None => trails.write_line(self.line.course(), number, from, path),
        }
    }

    /// Value `index` of the scene at the time shown, formatted with its unit; empty for an unknown index.
    pub fn scene_text(&mut self, index: usize, decimals: Option<u8>) -> String {
        let Some(&value) = self.scene_values().get(index) else {
            return String::new();
        };
        let scene = self.basis.scene();
        let Some(shown) = scene.and_then(|scene| scene.values.get(index)) else {
            return String::new();
        };
        if shown.kind != Kind::Number {
            return self.basis.word_value(shown, value);
        }
        match decimals {
            Some(decimals) => {
                let number = number::fixed(shown.unit.from_si(value), usize::from(decimals), self.basis.style());
                number::with_unit(&number, &shown.unit)
            }
            None if self.basis.is_count(shown.node, &shown.unit) => self.basis.count(value),
            None => {
                let scale = self.evaluators.scene_scales.get(index).copied().unwrap_or_default();
                Group::of_scale(&shown.unit, scale, MOVING_DIGITS, self.basis.style()).quantity(value)
            }
        }
    }

    /// Outline drawn over the scene.
    pub fn outline(&self) -> Option<&Outline> {
        self.outline.as_ref()
    }

    /// Sets or removes the outline.
    pub fn set_outline(&mut self, outline: Option<Outline>) {
        self.outline = outline;
    }

    /// Sets the values of the outline for the time shown.
    pub fn set_outline_values(&mut self, values: Option<&[f64]>) {
        let Some(outline) = &mut self.outline else { return };
        match (values, &mut outline.values) {
            (Some(values), Some(old)) => {
                old.clear();
                old.extend_from_slice(values);
            }
            (values, old) => *old = values.map(<[f64]>::to_vec),
        }
    }
}
