//! Dragging a part of the scene: the state follows the pointer; on release, the run starts from there.
//!
//! At the start of a run that uses the document's initial values, the drag changes the parameters that determine the
//! dragged initial value, as little as possible ([`Start::solve`]); the other initial values stay those of the
//! document. If no parameter determines it, if a range ends, or at any later time, the state itself becomes the start
//! of the run, and the dragged quantity is at rest. It remains the start until another one is set or
//! [`crate::Settings::restore_defaults`] is called.
//!
//! A part may also set a parameter, like a slider; the run then continues during the drag.

use crate::controls::hold::Hold;
use crate::controls::start::Start;
use crate::number;
use program::{Child, Drag, Dragged, Element, Piece, Program, Scene};
use units::{Dimension, Unit};

use super::Grips;

/// Start of the run that results from a drag.
pub(crate) struct Pulled {
    pub parameters: Vec<f64>,
    pub state: Vec<f64>,
    /// True if the state differs from the one that the parameters determine.
    pub by_hand: bool,
}

/// Number of bisections used to find the position at which the drawing stops following.
const HALVINGS: u32 = 40;

/// Significant digits of a length in the drawing, as on a ruler.
const LENGTH_DIGITS: usize = 3;

impl Grips<'_> {
    /// Least and greatest value (SI) that dragging this part can give its state from the present value, limited by how
    /// far the drawing follows. For a parameter, its range.
    pub fn range(&mut self, drag: &Drag) -> Option<(f64, f64)> {
        let held = match drag.target {
            Dragged::State(held) => held,
            Dragged::Parameter(index) => return self.basis.model().parameters.get(index)?.range,
        };
        let mut hold = self.grip(drag, held)?;
        let now = *hold.from.get(hold.state)?;
        let way = hold.reach.0 * hold.right.abs() + hold.reach.1 * hold.up.abs();
        let mut end = |way: f64| self.followed(&mut hold, way)?.state.get(held).copied();
        let (one, other) = (end(-way).unwrap_or(now), end(way).unwrap_or(now));
        Some((one.min(other).min(now), one.max(other).max(now)))
    }

    /// Text of a length given in scene units; `None` if the drawing has no scale.
    pub fn length(&mut self, units: f64) -> Option<String> {
        let (metres, unit) = self.scale()?;
        let text = number::plain(unit.from_si(units * metres), LENGTH_DIGITS, self.basis.style());
        Some(format!("{text} {}", number::unit_text(&unit.text)))
    }

    /// Scale of the drawing at the time shown, in metres per scene unit, and the unit in which lengths are displayed.
    /// Taken from a handle that changes a length, otherwise from a frame of lengths; `None` if there is neither.
    pub fn scale(&mut self) -> Option<(f64, Unit)> {
        let scene = self.basis.scene()?;
        let mut drags = Vec::new();
        collect_drags(&scene.root, &mut drags);
        let lengths = drags.into_iter().filter_map(|drag| {
            let unit = match drag.target {
                Dragged::State(index) => &self.basis.model().states.get(index)?.unit,
                Dragged::Parameter(index) => &self.basis.model().parameters.get(index)?.unit,
            };
            (unit.dimension == Dimension::LENGTH).then_some((drag.up.or(drag.right)?, unit.clone()))
        });
        let framed = scene.length.map(|index| (index, Unit::si(Dimension::LENGTH)));
        let (factor, unit) = lengths.collect::<Vec<_>>().into_iter().next().or(framed)?;
        let factor = self
            .values
            .scene_values(self.line.course())
            .get(factor)
            .copied()
            .filter(|factor| factor.is_finite() && *factor != 0.0)?;
        Some((factor.abs(), unit))
    }

    /// Data for dragging a part that moves a state; `None` if the state cannot be dragged.
    pub(crate) fn grip(&mut self, drag: &Drag, held: usize) -> Option<Hold> {
        let (right, up) = self.factors(drag);
        let mut from = self.line.course().state().to_vec();
        if held >= from.len() || from.iter().any(|value| !value.is_finite()) {
            return None;
        }
        let at_start = self.line.course().time() == 0.0 && self.line.course().begun().start.is_none();
        if !at_start {
            self.rest(held, &mut from);
        }
        let start = if at_start { Start::of(self.basis.model(), held) } else { None };
        let parameters = self.line.course().parameters().to_vec();
        let reach = extent(self.basis.program(), self.basis.tag());
        let mut shaping = Vec::new();
        if let Some(scene) = self.basis.scene() {
            collect_shaping(&scene.root, &mut shaping);
        }
        let playing = self.line.is_playing();
        Some(Hold { state: held, from, parameters, start, right, up, reach, shaping, moved: false, playing })
    }

    /// Change of the dragged value (SI) per scene unit to the right and upwards, at the moment shown.
    pub(crate) fn factors(&mut self, drag: &Drag) -> (f64, f64) {
        let values = self.values.scene_values(self.line.course());
        let factor = |index: Option<usize>| {
            index.and_then(|index| values.get(index).copied()).filter(|value| value.is_finite()).unwrap_or(0.0)
        };
        (factor(drag.right), factor(drag.up))
    }

    /// Sets the higher derivatives of the dragged variable to 0.
    fn rest(&self, held: usize, state: &mut [f64]) {
        let states = &self.basis.model().states;
        let Some(held) = states.get(held) else { return };
        for (other, value) in states.iter().zip(state) {
            if other.variable == held.variable && other.order > held.order {
                *value = 0.0;
            }
        }
    }

    /// Start of the run after pulling the dragged value by `way` (SI).
    fn pulled(&mut self, hold: &mut Hold, way: f64) -> Pulled {
        let mut state = hold.from.clone();
        let Some(value) = state.get_mut(hold.state) else {
            return Pulled { parameters: hold.parameters.clone(), state, by_hand: true };
        };
        *value += way;
        match hold.start.as_mut().and_then(|start| start.solve(&hold.parameters, *value)) {
            Some(parameters) => {
                let state = self.initial(&parameters);
                Pulled { parameters, state, by_hand: false }
            }
            None => Pulled { parameters: hold.parameters.clone(), state, by_hand: true },
        }
    }

    /// Start of the run at the furthest point along `way` (SI) to which the drawing follows; `None` if it cannot be
    /// drawn.
    pub(crate) fn followed(&mut self, hold: &mut Hold, way: f64) -> Option<Pulled> {
        let there = self.pulled(hold, way);
        let here = self.pulled(hold, 0.0);
        let (here, drawn) = (self.drawing(hold, &here), self.drawing(hold, &there));
        if !way.is_finite() || here.iter().zip(&drawn).any(|(here, there)| here.is_finite() && !there.is_finite()) {
            return None;
        }
        if same(&here, &drawn) {
            // The dragged value does not affect the drawing, or is already beyond its limits.
            return Some(there);
        }
        let (mut follows, mut stands) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = (follows + stands) / 2.0;
            let pulled = self.pulled(hold, way * middle);
            if same(&self.drawing(hold, &pulled), &drawn) {
                stands = middle;
            } else {
                follows = middle;
            }
        }
        Some(self.pulled(hold, way * stands))
    }

    /// Values that determine the drawing for a run with this start.
    fn drawing(&mut self, hold: &Hold, Pulled { parameters, state, .. }: &Pulled) -> Vec<f64> {
        let values = self.values.scene_at_start(parameters, state);
        hold.shaping.iter().filter_map(|&index| values.get(index).copied()).collect()
    }

    /// Initial state (SI) for given parameters (SI).
    fn initial(&mut self, parameters: &[f64]) -> Vec<f64> {
        let nothing = vec![0.0; self.basis.model().states.len()];
        self.controls.initial.at(parameters, &nothing, 0.0, &nothing).to_vec()
    }
}

/// True if two drawings are bit-identical.
fn same(one: &[f64], other: &[f64]) -> bool {
    one.iter().map(|value| value.to_bits()).eq(other.iter().map(|value| value.to_bits()))
}

/// All handles, in the order of the scene.
pub(super) fn collect_drags<'a>(element: &'a Element, drags: &mut Vec<&'a Drag>) {
    drags.extend(&element.drag);
    for child in &element.children {
        if let Child::Element(child) = child {
            collect_drags(child, drags);
        }
    }
}

/// Collects the indices of the values in the attributes of an element and of its descendants.
fn collect_shaping(element: &Element, indices: &mut Vec<usize>) {
    let pieces = element.attributes.iter().flat_map(|attribute| &attribute.value);
    indices.extend(pieces.filter_map(Piece::value));
    for child in &element.children {
        if let Child::Element(child) = child {
            collect_shaping(child, indices);
        }
    }
}

/// Width and height of the scene in scene units; unlimited without a view box.
fn extent(program: &Program, language: &str) -> (f64, f64) {
    program.scene(language).and_then(Scene::size).map_or((f64::MAX, f64::MAX), Into::into)
}
