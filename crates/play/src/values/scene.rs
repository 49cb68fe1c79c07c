//! Values of the scene, and of the outline drawn over it.

use super::Values;
use super::outline::Outline;
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

    /// Writes the path of a trail up to the time shown into `path`, in scene units: a line, or dots (segments of length
    /// zero).
    pub(crate) fn trail(&mut self, basis: &Basis, line: &mut TimeLine, number: usize, path: &mut String) {
        path.clear();
        self.scene_values(line.course());
        let Some(trail) = basis.scene().and_then(|scene| scene.trails.get(number)) else { return };
        let value = |index: usize| self.scene_values.get(index).copied().unwrap_or(f64::NAN);
        let (last, every) = (trail.last.map(value), trail.every.map(value));
        let from = last.map_or(0.0, |last| (line.course().time() - last).max(0.0));
        match every {
            Some(every) => self.trails.write_dots(line.course_between_rows(), number, (from, every), path),
            None => self.trails.write_line(line.course(), number, from, path),
        }
    }

    /// Value `index` of the scene at the time shown, formatted with its unit; empty for an unknown index.
    pub(crate) fn scene_text(&mut self, basis: &Basis, at: &Course, index: usize, decimals: Option<u8>) -> String {
        let Some(&value) = self.scene_values(at).get(index) else {
            return String::new();
        };
        let scene = basis.scene();
        let Some(shown) = scene.and_then(|scene| scene.values.get(index)) else {
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
                let scale = self.scene_scales.get(index).copied().unwrap_or_default();
                Group::of_scale(&shown.unit, scale, MOVING_DIGITS, basis.style()).quantity(value)
            }
        }
    }

    /// Outline drawn over the scene.
    pub(crate) fn outline(&self) -> Option<&Outline> {
        self.outline.as_ref()
    }

    /// Sets or removes the outline.
    pub(crate) fn set_outline(&mut self, outline: Option<Outline>) {
        self.outline = outline;
    }

    /// Sets the values of the outline for the time shown.
    pub(crate) fn set_outline_values(&mut self, values: Option<&[f64]>) {
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
