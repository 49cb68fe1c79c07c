//! Parts of a scene that follow the hand.

use super::build::{Builder, Dragging};
use crate::expressions::dimension_error;
use program::Drag;
use std::ops::Range;
use units::words;

impl Builder<'_, '_> {
    /// What dragging an element does.
    pub fn drag(&mut self, dragging: Dragging) -> Option<Drag> {
        let Some(place) = dragging.state else {
            if let Some(place) = dragging.up.or(dragging.right) {
                self.refuse(
                    words("what does the pointer change?", "¿qué cambia el puntero?"),
                    place,
                    Some(words(
                        "name a state: `drag=\"y\" drag-up=\"0.01 [m]\"`",
                        "nombra un estado: `drag=\"y\" drag-up=\"0.01 [m]\"`",
                    )),
                );
            }
            return None;
        };
        let place = crate::source::trim(self.expressions.source, place);
        let name = self.source(&place).to_owned();
        let states: Vec<String> = self.expressions.model().states.iter().map(program::State::name).collect();
        let Some(state) = states.iter().position(|known| *known == name) else {
            let mut hint = words!("the states are {}", "los estados son {}", states.join(", "));
            if let Some(near) = units::nearest(&name, states.iter().map(String::as_str)) {
                hint = words!("did you mean `{near}`?", "¿querías decir `{near}`?");
            }
            self.refuse(
                words!(
                    "`{name}` is not a state, so it cannot be dragged",
                    "`{name}` no es un estado, así que no se puede arrastrar"
                ),
                place,
                Some(hint),
            );
            return None;
        };
        if dragging.up.is_none() && dragging.right.is_none() {
            self.refuse(
                words(
                    "dragging needs `drag-up`, `drag-right` or both",
                    "para arrastrar hacen falta `drag-up`, `drag-right` o los dos",
                ),
                place,
                Some(words(
                    "`drag-up=\"0.01 [m]\"` is what one unit upwards adds",
                    "`drag-up=\"0.01 [m]\"` es lo que añade una unidad hacia arriba",
                )),
            );
            return None;
        }
        let up = dragging.up.and_then(|range| self.drag_rate(range, state));
        let right = dragging.right.and_then(|range| self.drag_rate(range, state));
        (up.is_some() || right.is_some()).then_some(Drag { state, up, right })
    }

    /// What one unit of the drawing adds to a state.
    fn drag_rate(&mut self, range: Range<usize>, state: usize) -> Option<usize> {
        let rate = self.expressions.number(range)?;
        let declared = self.expressions.places.states.get(state).copied().unwrap_or_default();
        let state = &self.expressions.model().states[state];
        if rate.value.dimension() != state.unit.dimension {
            let message = words!(
                "one unit of the drawing must add to `{}` something of its dimension",
                "una unidad del dibujo debe añadir a `{}` algo de su dimensión",
                state.name()
            );
            let expected = (declared, state.unit.dimension);
            self.expressions.diagnostics.push(dimension_error(message, (rate.span, rate.value.dimension()), expected));
            return None;
        }
        self.value(rate)
    }
}
