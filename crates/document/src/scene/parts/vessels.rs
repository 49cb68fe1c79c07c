//! Vessels with liquid: a straight tube and a U-tube.

use super::super::builder::Builder;
use super::super::space::Spot;
use super::drawing::{GLASS, Ink, LIQUID, PAPER, fixed};
use super::{Drawn, Given};

impl Builder<'_, '_> {
    /// A tube, closed at the start and open at the end, filled up to a length.
    pub fn tube(&mut self, given: &Given) -> Option<Drawn> {
        let way = self.way_of(given)?;
        let width = self.extent(given.get("width")?.clone())?;
        let level = self.extent_or(given, "level", 0.0)?;
        let zero = self.constant(0.0);
        let level = self.between(zero, level, way.length);
        let side = self.times(0.5, width);
        let opposite = self.graph().negate(side);
        let liquid = fixed("rect", &[("fill", LIQUID), ("stroke", "none")]);
        let liquid = self.numbered(liquid, &[("y", opposite), ("width", level), ("height", width)]);
        let mut wall = fixed("path", &[("fill", "none")]);
        let text = Ink::Text;
        self.set(
            &mut wall,
            "d",
            &[
                text("M"),
                Ink::Node(way.length),
                text(" "),
                Ink::Node(opposite),
                text("H0V"),
                Ink::Node(side),
                text("H"),
                Ink::Node(way.length),
            ],
        );
        Some(self.along_way(way, &[("stroke", GLASS), ("stroke-width", "3")], vec![liquid, wall]))
    }

    /// A U-tube. `at`: lowest point of its centre line; `spacing`: distance of its arms; heights and levels are measured
    /// from `at`.
    pub fn u_tube(&mut self, given: &Given) -> Option<Drawn> {
        let at = self.point_of(given, "at")?;
        let spacing = self.extent(given.get("spacing")?.clone())?;
        let height = self.extent(given.get("height")?.clone())?;
        let (left, right) = (self.extent(given.get("left")?.clone())?, self.extent(given.get("right")?.clone())?);
        let bore = self.extent_or(given, "width", 24.0)?;
        let radius = self.times(0.5, spacing);
        let wall = self.plus(bore, 5.0);
        let walls = self.bend([height, height], radius, wall, GLASS);
        let inside = self.bend([height, height], radius, bore, PAPER);
        // A level is not below the beginning of the bend.
        let [left, right] = [left, right].map(|level| self.between(radius, level, height));
        let liquid = self.bend([left, right], radius, bore, LIQUID);
        let child = self.standing(at, None, vec![walls, inside, liquid]);
        Some(Drawn { defaults: vec![("fill", "none")], children: vec![child], anchor: at })
    }

    /// A line down one arm, through the bend and up the other arm.
    fn bend(
        &mut self,
        heights: [program::NodeId; 2],
        radius: program::NodeId,
        width: program::NodeId,
        colour: &str,
    ) -> program::Element {
        let [one, other] = heights.map(|height| self.graph().negate(height));
        let opposite = self.graph().negate(radius);
        let foot = Spot { x: radius, y: opposite };
        let text = Ink::Text;
        let mut line = fixed("path", &[("stroke", colour)]);
        self.set(
            &mut line,
            "d",
            &[
                text("M"),
                Ink::Node(opposite),
                text(" "),
                Ink::Node(one),
                text("V"),
                Ink::Node(opposite),
                text("A"),
                Ink::Node(radius),
                text(" "),
                Ink::Node(radius),
                text(" 0 0 0 "),
                Ink::Node(foot.x),
                text(" "),
                Ink::Node(foot.y),
                text("V"),
                Ink::Node(other),
            ],
        );
        self.numbered(line, &[("stroke-width", width)])
    }
}
