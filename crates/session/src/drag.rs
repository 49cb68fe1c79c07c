//! Dragging a part of the scene: the state follows the pointer; let go, the run begins from there.

use crate::{Announcement, Session};
use document::{Child, Document, Drag, Element, Piece};

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
    /// The values of the scene that shape the drawing, those in attributes.
    shaping: Vec<usize>,
    /// Whether the state has been changed.
    moved: bool,
    /// Whether the run goes on afterwards.
    playing: bool,
}

/// How finely the place is found at which the drawing stops following: parts of the way, as a power of two.
const HALVINGS: u32 = 40;

impl Session {
    /// Takes hold of a part of the scene; the run stands still meanwhile.
    pub fn drag_begin(&mut self, drag: &Drag) {
        if self.hold.is_some() {
            self.drag_end();
        }
        let factor = |values: &[f64], index: Option<usize>| {
            index.and_then(|index| values.get(index).copied()).filter(|value| value.is_finite()).unwrap_or(0.0)
        };
        let values = self.scene_values();
        let (right, up) = (factor(values, drag.right), factor(values, drag.up));
        let mut from = self.course.state().to_vec();
        if drag.state >= from.len() || from.iter().any(|value| !value.is_finite()) {
            return;
        }
        self.rest(drag.state, &mut from);
        let reach = extent(&self.document, &self.tag);
        let mut shaping = Vec::new();
        if let Some(scene) = self.document.scene(&self.tag) {
            collect_shaping(&scene.root, &mut shaping);
        }
        let playing = self.playing;
        self.pause();
        self.hold = Some(Hold { state: drag.state, from, right, up, reach, shaping, moved: false, playing });
    }

    /// The pointer is now `right` and `up` scene units from where it took hold (up is positive). It pulls the state no
    /// further than the drawing follows: not past the extent of the scene, not to where a value of the drawing is not
    /// finite, and not on where nothing moves any more because the author limits it (`min(sum, sum/2 + y)`).
    pub fn drag_move(&mut self, right: f64, up: f64) {
        let Some(mut hold) = self.hold.take() else {
            return;
        };
        if right.is_finite() && up.is_finite() {
            let right = right.clamp(-hold.reach.0, hold.reach.0);
            let up = up.clamp(-hold.reach.1, hold.reach.1);
            let way = right * hold.right + up * hold.up;
            if let Some(state) = self.followed(&hold, way) {
                self.start_from(state);
                hold.moved = true;
            }
        }
        self.hold = Some(hold);
    }

    /// Lets go: the run goes on from there if it was going on before.
    pub fn drag_end(&mut self) {
        let Some(hold) = self.hold.take() else { return };
        if let (true, Some(&value)) = (hold.moved, self.course.state().get(hold.state)) {
            self.announce(Announcement::StateSet(hold.state, value));
        }
        if hold.playing {
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

    /// The state as far along `way` (SI) as the drawing follows; `None` where it cannot be drawn.
    fn followed(&mut self, hold: &Hold, way: f64) -> Option<Vec<f64>> {
        let at = |part: f64| {
            let mut state = hold.from.clone();
            if let Some(value) = state.get_mut(hold.state) {
                *value += way * part;
            }
            state
        };
        let here = self.drawing(hold, &at(0.0));
        let there = self.drawing(hold, &at(1.0));
        if !way.is_finite() || here.iter().zip(&there).any(|(here, there)| here.is_finite() && !there.is_finite()) {
            return None;
        }
        if same(&here, &there) {
            // What is held does not shape the drawing at all, or is beyond its limits already.
            return Some(at(1.0));
        }
        let (mut follows, mut stands) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = (follows + stands) / 2.0;
            if same(&self.drawing(hold, &at(middle)), &there) {
                stands = middle;
            } else {
                follows = middle;
            }
        }
        Some(at(stands))
    }

    /// The values that shape the drawing when a run begins with `state`.
    fn drawing(&mut self, hold: &Hold, state: &[f64]) -> Vec<f64> {
        let values = self.evaluators.scene.at(self.course.parameters(), state, 0.0, state);
        hold.shaping.iter().filter_map(|&index| values.get(index).copied()).collect()
    }
}

/// Whether two drawings are the same, bit by bit.
fn same(one: &[f64], other: &[f64]) -> bool {
    one.iter().map(|value| value.to_bits()).eq(other.iter().map(|value| value.to_bits()))
}

/// Collects the values in the attributes of an element and those below it.
fn collect_shaping(element: &Element, indices: &mut Vec<usize>) {
    let pieces = element.attributes.iter().flat_map(|attribute| &attribute.value);
    indices.extend(pieces.filter_map(|piece| match piece {
        Piece::Value { index, .. } => Some(*index),
        Piece::Literal(_) => None,
    }));
    for child in &element.children {
        if let Child::Element(child) = child {
            collect_shaping(child, indices);
        }
    }
}

/// The width and height of the scene, in its units; without a view box there is no telling.
fn extent(document: &Document, language: &str) -> (f64, f64) {
    let unlimited = (f64::MAX, f64::MAX);
    let Some(scene) = document.scene(language) else {
        return unlimited;
    };
    let view_box = scene.root.attributes.iter().find(|attribute| attribute.name == "viewBox");
    let Some([Piece::Literal(text)]) = view_box.map(|attribute| attribute.value.as_slice()) else {
        return unlimited;
    };
    let numbers: Vec<f64> =
        text.split([' ', ',']).filter(|part| !part.is_empty()).filter_map(|part| part.parse().ok()).collect();
    match numbers.as_slice() {
        [_, _, width, height] if *width > 0.0 && *height > 0.0 => (*width, *height),
        _ => unlimited,
    }
}
