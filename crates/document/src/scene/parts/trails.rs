//! Trails: `<trail at="(x, y)" last="5 [s]"/>` shows the past path of a point. With `every="0.1 [s]"` it shows dots, like a
//! stroboscope.

use super::super::builder::Builder;
use super::drawing::{ACCENT, fixed};
use super::{Drawn, Given};
use crate::expressions::{Placed, wrong_dimension};
use program::{Attribute, Compiled, Kind, NodeId, Piece, Trail};
use units::{Unit, words};

/// Maximum number of trails in a scene.
const TRAILS: usize = 50;

impl Builder<'_, '_> {
    /// The past path of a point.
    pub fn trail(&mut self, given: &Given) -> Option<Drawn> {
        let at = self.point_of(given, "at")?;
        let (last, every) = (self.duration(given, "last")?, self.duration(given, "every")?);
        if self.trail_count() == TRAILS {
            let message = words!("a scene cannot have more than {TRAILS} trails");
            self.refuse_at(message, self.element_place(), None);
            return None;
        }
        let (x, y) = (self.drawing_value(at.x)?, self.drawing_value(at.y)?);
        let mut path = fixed("path", &[("fill", "none"), ("pointer-events", "none")]);
        let trail = self.add_trail(Trail { x, y, last, every });
        path.attributes.push(Attribute { name: "d".to_owned(), value: vec![Piece::Trail(trail)] });
        let mut defaults = vec![("stroke", ACCENT), ("stroke-linejoin", "round"), ("stroke-linecap", "round")];
        defaults.push(("stroke-width", if every.is_some() { "5" } else { "2" }));
        Some(Drawn { defaults, children: vec![path], anchor: at })
    }

    fn drawing_value(&mut self, node: NodeId) -> Option<usize> {
        let value = Compiled { node, unit: Unit::dimensionless(), kind: Kind::Number };
        self.value(Placed { value, span: self.element_place() })
    }

    /// Index of the value of a duration; `Some(None)` if it is not given.
    fn duration(&mut self, given: &Given, name: &str) -> Option<Option<usize>> {
        let Some(range) = given.get(name) else { return Some(None) };
        let range = self.inside_braces(range.clone());
        let placed = self.expressions.number(range)?;
        let (found, expected) = (placed.value.dimension(), self.expressions.model().independent.unit.dimension);
        if found == expected {
            return self.value(placed).map(Some);
        }
        let message = words!("`{name}` has the wrong dimension");
        self.expressions.diagnostics.push(wrong_dimension(message, placed.span, found, expected));
        None
    }
}
