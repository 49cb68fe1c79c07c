//! Dragging of parts of the scene by the visitor.

use super::drag::Pulled;
use super::hold::Holding;
use super::settings::Settings;
use crate::{Announcement, Changes};
use engine::Setup;
use program::{Drag, Dragged};

impl Settings<'_> {
    /// Starts dragging a part of the scene. A part that moves a state pauses the run.
    pub fn drag_begin(&mut self, drag: &Drag) -> Changes {
        // Playing on after the former drag does not release this one.
        let changes = self.drag_end().without(&Changes::RELEASED);
        match drag.target {
            Dragged::State(held) => {
                let Some(hold) = self.grips().grip(drag, held) else { return changes };
                self.controls.hold(Some(Holding::State(Box::new(hold))));
                changes | self.line.pause()
            }
            Dragged::Parameter(parameter) => {
                let Some(&from) = self.course().parameters().get(parameter) else { return changes };
                let (right, up) = self.grips().factors(drag);
                self.controls.hold(Some(Holding::Parameter { parameter, from, right, up, moved: false }));
                changes
            }
        }
    }

    /// Moves the pointer to `right` and `up` scene units from the start of the drag (up is positive). The state follows
    /// only as far as the drawing does: within the extent of the scene, while all values of the drawing are finite, and
    /// until an author's limit (`min(sum, sum/2 + y)`) stops the motion.
    pub fn drag_move(&mut self, right: f64, up: f64) -> Changes {
        let mut hold = match self.controls.release() {
            Some(Holding::State(hold)) => hold,
            Some(Holding::Parameter { parameter, from, right: by_right, up: by_up, moved }) => {
                let set = self.drag_parameter(parameter, from + right * by_right + up * by_up);
                let moved = set.is_some() || moved;
                self.controls.hold(Some(Holding::Parameter { parameter, from, right: by_right, up: by_up, moved }));
                return set.unwrap_or_default();
            }
            None => return Changes::NONE,
        };
        let mut changes = Changes::NONE;
        if right.is_finite() && up.is_finite() {
            let right = right.clamp(-hold.reach.0, hold.reach.0);
            let up = up.clamp(-hold.reach.1, hold.reach.1);
            let way = right * hold.right + up * hold.up;
            if let Some(Pulled { parameters, state, by_hand }) = self.grips().followed(&mut hold, way) {
                let start = by_hand.then_some(state);
                let setup = Setup { parameters, start, ..self.course().begun().clone() };
                changes = self.line.restart(self.basis, setup);
                hold.moved = true;
            }
        }
        self.controls.hold(Some(Holding::State(hold)));
        changes
    }

    /// Sets a dragged parameter (SI), clamped to its range. `None` if it cannot have the value.
    fn drag_parameter(&mut self, parameter: usize, value: f64) -> Option<Changes> {
        if !value.is_finite() {
            return None;
        }
        let range = self.basis.model().parameters.get(parameter).and_then(|parameter| parameter.range);
        let value = range.map_or(value, |(least, greatest)| value.max(least).min(greatest));
        let value = self.basis.admit(parameter, value).ok()?;
        let mut parameters = self.course().parameters().to_vec();
        match parameters.get_mut(parameter) {
            Some(old) if old.to_bits() != value.to_bits() => *old = value,
            _ => return Some(Changes::NONE),
        }
        Some(self.line.set_parameters(self.basis, parameters))
    }

    /// Ends the drag. The run continues from there if it was playing before.
    pub fn drag_end(&mut self) -> Changes {
        let hold = match self.controls.release() {
            Some(Holding::State(hold)) => hold,
            Some(Holding::Parameter { parameter, moved: true, .. }) => {
                let value = self.course().parameters().get(parameter);
                let set = value.map(|&value| Announcement::ParameterSet(parameter, value));
                return set.map_or(Changes::NONE, |set| Changes::NONE.announcing(set));
            }
            _ => return Changes::NONE,
        };
        let mut changes = Changes::NONE;
        if let (true, Some(&value)) = (hold.moved, self.course().state().get(hold.state)) {
            changes = changes.announcing(if self.course().is_started_by_hand() {
                Announcement::StateSet(hold.state, value)
            } else {
                Announcement::StartSet { state: hold.state, value, before: hold.parameters }
            });
        }
        if hold.playing { changes | self.line.play() } else { changes }
    }
}
