//! Dragging of parts of the scene.

use crate::controls::drag::Pulled;
use crate::controls::hold::Holding;
use crate::{Announcement, Grips, Play};
use engine::Setup;
use program::{Drag, Dragged};

impl Play {
    /// The parts of the scene that can be dragged, and its scale.
    pub fn grips(&mut self) -> Grips<'_> {
        self.controls.grips(&self.basis, &self.line, &mut self.values)
    }

    /// Starts dragging a part of the scene. A part that moves a state pauses the run.
    pub fn drag_begin(&mut self, drag: &Drag) {
        if self.controls.is_dragging() {
            self.drag_end();
        }
        match drag.target {
            Dragged::State(held) => {
                let Some(hold) = self.grips().grip(drag, held) else { return };
                self.pause();
                self.controls.hold(Some(Holding::State(Box::new(hold))));
            }
            Dragged::Parameter(parameter) => {
                let Some(&from) = self.course().parameters().get(parameter) else { return };
                let (right, up) = self.grips().factors(drag);
                self.controls.hold(Some(Holding::Parameter { parameter, from, right, up, moved: false }));
            }
        }
    }

    /// Moves the pointer to `right` and `up` scene units from the start of the drag (up is positive). The state follows
    /// only as far as the drawing does: within the extent of the scene, while all values of the drawing are finite, and
    /// until an author's limit (`min(sum, sum/2 + y)`) stops the motion.
    pub fn drag_move(&mut self, right: f64, up: f64) {
        let mut hold = match self.controls.release() {
            Some(Holding::State(hold)) => hold,
            Some(Holding::Parameter { parameter, from, right: by_right, up: by_up, moved }) => {
                let moved = self.drag_parameter(parameter, from + right * by_right + up * by_up) || moved;
                self.controls.hold(Some(Holding::Parameter { parameter, from, right: by_right, up: by_up, moved }));
                return;
            }
            None => return,
        };
        if right.is_finite() && up.is_finite() {
            let right = right.clamp(-hold.reach.0, hold.reach.0);
            let up = up.clamp(-hold.reach.1, hold.reach.1);
            let way = right * hold.right + up * hold.up;
            if let Some(Pulled { parameters, state, by_hand }) = self.grips().followed(&mut hold, way) {
                let start = by_hand.then_some(state);
                self.restart(Setup { parameters, start, ..self.course().begun().clone() });
                hold.moved = true;
            }
        }
        self.controls.hold(Some(Holding::State(hold)));
    }

    /// Sets a dragged parameter (SI), clamped to its range. Returns true if it has the new value.
    fn drag_parameter(&mut self, parameter: usize, value: f64) -> bool {
        if !value.is_finite() {
            return false;
        }
        let range = self.model().parameters.get(parameter).and_then(|parameter| parameter.range);
        let value = range.map_or(value, |(least, greatest)| value.max(least).min(greatest));
        let Ok(value) = self.basis.admit(parameter, value) else { return false };
        let mut parameters = self.course().parameters().to_vec();
        if let Some(old) = parameters.get_mut(parameter)
            && old.to_bits() != value.to_bits()
        {
            *old = value;
            self.change_parameters(parameters);
        }
        true
    }

    /// Ends the drag. The run continues from there if it was playing before.
    pub fn drag_end(&mut self) {
        let hold = match self.controls.release() {
            Some(Holding::State(hold)) => hold,
            Some(Holding::Parameter { parameter, moved, .. }) => {
                if let (true, Some(&value)) = (moved, self.course().parameters().get(parameter)) {
                    self.announce(Announcement::ParameterSet(parameter, value));
                }
                return;
            }
            None => return,
        };
        if let (true, Some(&value)) = (hold.moved, self.course().state().get(hold.state)) {
            self.announce(if self.is_started_by_hand() {
                Announcement::StateSet(hold.state, value)
            } else {
                Announcement::StartSet { state: hold.state, value, before: hold.parameters }
            });
        }
        if hold.playing {
            self.play();
        }
    }
}
