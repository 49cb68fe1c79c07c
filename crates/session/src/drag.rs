//! Dragging a part of the scene: the state follows the pointer; let go, the run begins from there.

use crate::Session;
use document::{Document, Drag, Piece};

/// A part of the scene that is held.
#[derive(Clone, Debug)]
pub(crate) struct Hold {
    state: usize,
    /// The state when it was taken hold of; the variable held is at rest.
    from: Vec<f64>,
    /// What a scene unit to the right and upwards adds.
    right: f64,
    up: f64,
    /// How far the pointer may move, in scene units: the extent of the scene.
    reach: (f64, f64),
    /// Whether the run goes on afterwards.
    playing: bool,
}

impl Session {
    /// Takes hold of a part of the scene; the run stands still meanwhile.
    pub fn drag_begin(&mut self, drag: &Drag) {
        if self.hold.is_some() {
            self.drag_end();
        }
        let factor = |values: &[f64], index: Option<usize>| {
            index
                .and_then(|index| values.get(index).copied())
                .filter(|value| value.is_finite())
                .unwrap_or(0.0)
        };
        let values = self.scene_values();
        let (right, up) = (factor(values, drag.right), factor(values, drag.up));
        let mut from = self.course.state().to_vec();
        if drag.state >= from.len() || from.iter().any(|value| !value.is_finite()) {
            return;
        }
        self.rest(drag.state, &mut from);
        let reach = extent(&self.document, &self.language);
        let playing = self.playing;
        self.pause();
        self.hold = Some(Hold {
            state: drag.state,
            from,
            right,
            up,
            reach,
            playing,
        });
    }

    /// The pointer is now `right` and `up` scene units from where it took hold (up is positive). It cannot pull the
    /// state further than the extent of the scene, nor to where the scene has no values.
    pub fn drag_move(&mut self, right: f64, up: f64) {
        let Some(hold) = self.hold.clone() else {
            return;
        };
        if !(right.is_finite() && up.is_finite()) {
            return;
        }
        let right = right.clamp(-hold.reach.0, hold.reach.0);
        let up = up.clamp(-hold.reach.1, hold.reach.1);
        let mut state = hold.from;
        let Some(value) = state.get_mut(hold.state) else {
            return;
        };
        *value += right * hold.right + up * hold.up;
        if value.is_finite() && self.is_drawable(&state) {
            self.start_from(state);
        }
    }

    /// Lets go: the run goes on from there if it was going on before.
    pub fn drag_end(&mut self) {
        if let Some(hold) = self.hold.take()
            && hold.playing
        {
            self.play();
        }
    }

    /// Whether a part of the scene is held.
    pub fn is_dragging(&self) -> bool {
        self.hold.is_some()
    }

    /// What is held does not move: the derivatives of its variable are 0.
    fn rest(&self, held: usize, state: &mut [f64]) {
        let states = &self.document.model.states;
        let Some(held) = states.get(held) else { return };
        for (other, value) in states.iter().zip(state) {
            if other.variable == held.variable && other.order > held.order {
                *value = 0.0;
            }
        }
    }

    /// Whether every value of the scene that is a number now is a number in this state too.
    fn is_drawable(&mut self, state: &[f64]) -> bool {
        let now: Vec<bool> = self
            .scene_values()
            .iter()
            .map(|value| value.is_finite())
            .collect();
        let parameters = self.course.parameters().to_vec();
        let then = self.evaluators.scene.at(&parameters, state, 0.0, state);
        now.iter()
            .zip(then)
            .all(|(now, then)| !now || then.is_finite())
    }
}

/// The width and height of the scene, in its units; without a view box there is no telling.
fn extent(document: &Document, language: &str) -> (f64, f64) {
    let unlimited = (f64::MAX, f64::MAX);
    let Some(scene) = document.scene(language) else {
        return unlimited;
    };
    let view_box = scene
        .root
        .attributes
        .iter()
        .find(|attribute| attribute.name == "viewBox");
    let Some([Piece::Literal(text)]) = view_box.map(|attribute| attribute.value.as_slice()) else {
        return unlimited;
    };
    let numbers: Vec<f64> = text
        .split([' ', ','])
        .filter(|part| !part.is_empty())
        .filter_map(|part| part.parse().ok())
        .collect();
    match numbers.as_slice() {
        [_, _, width, height] if *width > 0.0 && *height > 0.0 => (*width, *height),
        _ => unlimited,
    }
}
