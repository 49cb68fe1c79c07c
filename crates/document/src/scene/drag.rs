//! Dragging of elements of a scene.

use super::builder::{Builder, Dragging};
use super::space::Spot;
use crate::expressions::{Placed, dimension_error};
use model::Span;
use program::{Compiled, Drag, Dragged, Kind, Node, NodeId, Variable};
use std::ops::Range;
use units::{Unit, words};

impl Builder<'_, '_> {
    /// Effect of dragging an element. `anchor`: its point that follows the pointer, in the current coordinate system.
    pub fn drag(&mut self, dragging: Dragging, anchor: Option<Spot>) -> Option<Drag> {
        let Some(place) = dragging.state else {
            if let Some(place) = dragging.up.or(dragging.right).or(dragging.zero) {
                self.refuse(
                    words("what does the pointer change?"),
                    place,
                    Some(words("name a state: `drag=\"y\" drag-up=\"0.01 [m]\"`")),
                );
            }
            return None;
        };
        let place = crate::text::source::trim(self.expressions.source, place);
        let target = self.dragged(&place)?;
        if dragging.up.is_none() && dragging.right.is_none() && (self.space().framed || anchor.is_some()) {
            return self.along(target, anchor, place);
        }
        if dragging.up.is_none() && dragging.right.is_none() {
            self.refuse(
                words("dragging needs `drag-up`, `drag-right` or both"),
                place,
                Some(words("`drag-up=\"0.01 [m]\"` is what one unit upwards adds")),
            );
            return None;
        }
        if let Some(place) = dragging.zero.clone().filter(|_| dragging.right.is_some() || dragging.up.is_none()) {
            self.refuse(
                words("`drag-zero` belongs to what moves up and down alone"),
                place,
                Some(words("leave `drag-zero` out, or write `drag-up` without `drag-right`")),
            );
            return None;
        }
        let up = dragging.up.and_then(|range| self.drag_rate(range, target));
        let right = dragging.right.and_then(|range| self.drag_rate(range, target));
        let zero = dragging.zero.and_then(|range| self.level(range));
        (up.is_some() || right.is_some()).then_some(Drag { target, up, right, zero })
    }

    /// A vertical coordinate, in the drawing.
    fn level(&mut self, range: Range<usize>) -> Option<usize> {
        let height = self.coordinate(range)?;
        let space = self.space().clone();
        let graph = self.expressions.graph();
        let nothing = graph.constant(0.0);
        let spot = space.spot(graph, nothing, height);
        let node = space.outside(graph, spot).y;
        self.drawn_value(node)
    }

    /// The state or parameter of a name.
    fn dragged(&mut self, place: &Range<usize>) -> Option<Dragged> {
        let name = self.expressions.name(place.clone()).unwrap_or_else(|| self.source(place).to_owned());
        let model = self.expressions.model();
        let states: Vec<String> = model.states.iter().map(program::State::name).collect();
        if let Some(state) = states.iter().position(|known| *known == name) {
            return Some(Dragged::State(state));
        }
        if let Some(parameter) = model.parameters.iter().position(|parameter| parameter.name == name) {
            let place = Span::new(place.start, place.end);
            return self.expressions.is_shown(parameter, place).then_some(Dragged::Parameter(parameter));
        }
        let parameters = model.parameters.iter().map(|parameter| parameter.name.as_str());
        let near = units::nearest(&name, states.iter().map(String::as_str).chain(parameters)).map(str::to_owned);
        let message = words!("`{name}` is neither a state nor a parameter, so it cannot be dragged");
        match near {
            Some(near) => self.refuse_word(message, place.clone(), Some(&near)),
            None => {
                let hint = words!("the states are {}", states.join(", "));
                self.refuse(message, place.clone(), Some(hint));
            }
        }
        None
    }

    /// Unit, name and place of declaration of a drag target.
    fn target(&self, target: Dragged) -> Option<(Unit, String, Span)> {
        let (model, places) = (self.expressions.model(), self.expressions.places);
        match target {
            Dragged::State(index) => {
                let state = model.states.get(index)?;
                Some((state.unit.clone(), state.name(), places.states.get(index).copied().unwrap_or_default()))
            }
            Dragged::Parameter(index) => {
                let parameter = model.parameters.get(index)?;
                let declared = places.parameters.get(index).copied().unwrap_or_default();
                Some((parameter.unit.clone(), parameter.name.clone(), declared))
            }
        }
    }

    /// Drag along the path of the point `anchor`, which depends on the target s: the component of the pointer's
    /// displacement along the path, divided by the rate. With the position r(s), ds = r'·dr/|r'|².
    fn along(&mut self, target: Dragged, anchor: Option<Spot>, place: Range<usize>) -> Option<Drag> {
        let (unit, name, _) = self.target(target)?;
        let variable = match target {
            Dragged::State(index) => Variable::State(index as u32),
            Dragged::Parameter(index) => Variable::Parameter(index as u32),
        };
        let space = self.space().clone();
        let graph = self.expressions.graph();
        let zero = graph.constant(0.0);
        let spot = anchor.map_or(Spot { x: zero, y: zero }, |anchor| space.outside(graph, anchor));
        let rates = program::differentiate_all(graph, &[spot.x, spot.y], variable);
        let [right, down] = rates[..] else { return None };
        let up = graph.negate(down);
        let (right_squared, up_squared) = (graph.multiply(right, right), graph.multiply(up, up));
        let square = graph.add(right_squared, up_squared);
        if graph.as_constant(square) == Some(0.0) {
            self.refuse(
                words!("where this part lies does not depend on `{name}`"),
                place,
                Some(words("say with `drag-right` and `drag-up` what a way to the right or upwards adds")),
            );
            return None;
        }
        let span = Span::new(place.start, place.end);
        let mut index = |rate: NodeId| {
            if self.graph().as_constant(rate) == Some(0.0) {
                return None;
            }
            let node = self.graph().divide(rate, square);
            let value = Compiled { node, unit: unit.clone(), kind: Kind::Number };
            self.value(Placed { value, span })
        };
        let (up, right) = (index(up), index(right));
        let zero = if right.is_none() { self.origin_of(variable, spot.y, down) } else { None };
        Some(Drag { target, up, right, zero })
    }

    /// Height at which a variable is 0, where the height `down` changes by the same rate everywhere.
    fn origin_of(&mut self, variable: Variable, height: NodeId, rate: NodeId) -> Option<usize> {
        let graph = self.expressions.graph();
        let bend = program::differentiate_all(graph, &[rate], variable);
        if bend.first().and_then(|bend| graph.as_constant(*bend)) != Some(0.0) {
            return None;
        }
        let value = graph.insert(match variable {
            Variable::State(index) => Node::State(index),
            Variable::Parameter(index) => Node::Parameter(index),
            Variable::Initial(_) | Variable::Independent => return None,
        });
        let way = graph.multiply(value, rate);
        let node = graph.subtract(height, way);
        self.drawn_value(node)
    }

    /// Change of the target per unit of the drawing. In a frame, the document states it per unit of the frame.
    fn drag_rate(&mut self, range: Range<usize>, target: Dragged) -> Option<usize> {
        let inner = self.inside_braces(range);
        let mut rate = self.expressions.number(inner)?;
        let (unit, name, declared) = self.target(target)?;
        let expected = if self.space().framed { unit.dimension.per(self.space().dimension)? } else { unit.dimension };
        let is_zero = self.graph().as_constant(rate.value.node) == Some(0.0);
        if rate.value.dimension() != expected && !is_zero {
            let message = if self.space().framed {
                words!("this times a length of the frame must have the dimension of `{name}`")
            } else {
                words!("one unit of the drawing must add to `{name}` something of its dimension")
            };
            let found = (rate.span, rate.value.dimension());
            self.expressions.diagnostics.push(dimension_error(message, found, (declared, expected)));
            return None;
        }
        if self.space().framed {
            let scale = self.space().scale;
            rate.value.node = self.graph().divide(rate.value.node, scale);
            rate.value.unit = unit;
        }
        self.value(rate)
    }
}
