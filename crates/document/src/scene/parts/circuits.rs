//! Circuit symbols (IEC 60617), in the middle of their wires.

use super::super::builder::Builder;
use super::drawing::{Ink, TEXT, fixed};
use super::{Drawn, Given};
use program::{Kind, NodeId};
use units::words;

impl Builder<'_, '_> {
    /// The symbol with this name, between two wires.
    pub fn circuit(&mut self, name: &str, given: &Given) -> Option<Drawn> {
        let way = self.way_of(given)?;
        let half = match name {
            "capacitor" => 4.0,
            "source" => 14.0,
            "switch" => 16.0,
            _ => 22.0,
        };
        let middle = self.times(0.5, way.length);
        let (before, behind) = (self.plus(middle, -half), self.plus(middle, half));
        let mut wires = fixed("path", &[]);
        let text = Ink::Text;
        self.set(
            &mut wires,
            "d",
            &[text("M0 0H"), Ink::Node(before), text("M"), Ink::Node(behind), text(" 0H"), Ink::Node(way.length)],
        );
        let mut children = vec![wires];
        match name {
            "resistor" => children.push(fixed("path", &[("d", "M-22-8h44v16h-44z")])),
            "coil" => children.push(fixed(
                "path",
                &[("d", "M-22 0a5.5 6 0 0 1 11 0a5.5 6 0 0 1 11 0a5.5 6 0 0 1 11 0a5.5 6 0 0 1 11 0")],
            )),
            "capacitor" => children.push(fixed("path", &[("d", "M-4-13V13M4-13V13"), ("stroke-width", "2.5")])),
            "source" => {
                children.push(fixed("path", &[("d", "M-14 0a14 14 0 1 0 28 0a14 14 0 1 0-28 0h28M21-17h8m-4-4v8")]))
            }
            _ => children.extend(self.contact(given)),
        }
        let symbol = children.split_off(1);
        let zero = self.constant(0.0);
        let at = super::super::space::Spot { x: middle, y: zero };
        children.push(self.standing(at, None, symbol));
        Some(self.along_way(way, &[("fill", "none"), ("stroke", TEXT), ("stroke-width", "2")], children))
    }

    /// The arm of a switch: in line with the wires if it is closed, otherwise raised.
    fn contact(&mut self, given: &Given) -> Option<program::Element> {
        let degrees: NodeId = match given.get("closed") {
            Some(range) => {
                let inner = self.inside_braces(range.clone());
                let condition = self.expressions.compile(inner)?;
                if condition.value.kind != Kind::Truth {
                    self.refuse_at(
                        words("`closed` needs a condition"),
                        condition.span,
                        Some(words("such as `closed=\"t > 1 [s]\"`")),
                    );
                    return None;
                }
                let graph = self.graph();
                let (down, up) = (graph.constant(0.0), graph.constant(-28.0));
                graph.select(condition.value.node, down, up)
            }
            None => self.constant(-28.0),
        };
        let mut arm = fixed("path", &[("d", "M0 0H32")]);
        self.set(&mut arm, "transform", &[Ink::Text("translate(-16 0) rotate("), Ink::Node(degrees), Ink::Text(")")]);
        Some(arm)
    }
}
