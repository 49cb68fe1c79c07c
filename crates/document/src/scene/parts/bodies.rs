//! Bodies: block, bob, wheel, pulley, ramp, picture.

use super::super::builder::Builder;
use super::super::space::Spot;
use super::drawing::{GLASS, Ink, MARK, TEXT, fixed};
use super::{Drawn, Given};
use program::{Attribute, Piece};
use units::words;

/// Default appearance of a body.
const BODY: [(&str, &str); 3] = [("fill", MARK), ("stroke", TEXT), ("stroke-width", "1.5")];
/// Permitted pictures.
const PICTURES: [&str; 4] =
    ["data:image/png;base64,", "data:image/jpeg;base64,", "data:image/gif;base64,", "data:image/webp;base64,"];

impl Builder<'_, '_> {
    /// A rectangle, given by its centre.
    pub fn block(&mut self, given: &Given) -> Option<Drawn> {
        let (at, size) = (self.point_of(given, "at"), self.size(given.get("size")?.clone()));
        let (at, size) = at.zip(size)?;
        let turn = self.turn_of(given)?;
        let (left, top) = (self.times(-0.5, size.x), self.times(-0.5, size.y));
        let sides = [("width", size.x), ("height", size.y)];
        let child = if turn.is_some() {
            let body = self.numbered(fixed("rect", &[("rx", "3")]), &[("x", left), ("y", top), sides[0], sides[1]]);
            self.standing(at, turn, vec![body])
        } else {
            let corner = self.corner(at, size.x, size.y);
            self.numbered(fixed("rect", &[("rx", "3")]), &[("x", corner.x), ("y", corner.y), sides[0], sides[1]])
        };
        Some(Drawn { defaults: BODY.to_vec(), children: vec![child], anchor: at })
    }

    /// A ball, given by its centre; the default radius is [`super::BOB_RADIUS`].
    pub fn bob(&mut self, given: &Given) -> Option<Drawn> {
        let at = self.point_of(given, "at")?;
        let radius = self.extent_or(given, "r", super::BOB_RADIUS)?;
        let circle = self.numbered(fixed("circle", &[]), &[("cx", at.x), ("cy", at.y), ("r", radius)]);
        Some(Drawn { defaults: BODY.to_vec(), children: vec![circle], anchor: at })
    }

    /// A wheel with spokes that show its rotation; a pulley has a groove.
    pub fn wheel(&mut self, given: &Given, grooved: bool) -> Option<Drawn> {
        let at = self.point_of(given, "at")?;
        let radius = self.extent_or(given, "r", 24.0)?;
        let turn = self.turn_of(given)?;
        let opposite = self.graph().negate(radius);
        let rim = self.numbered(fixed("circle", &[("fill-opacity", "0.12")]), &[("r", radius)]);
        let mut children = vec![rim];
        if grooved {
            let groove = self.times(0.8, radius);
            children.push(self.numbered(fixed("circle", &[("fill", "none"), ("stroke-width", "1")]), &[("r", groove)]));
        }
        for (one, other) in [("x1", "x2"), ("y1", "y2")] {
            children.push(self.numbered(fixed("line", &[]), &[(one, opposite), (other, radius)]));
        }
        children.push(fixed("circle", &[("r", "3"), ("stroke", "none")]));
        let child = self.standing(at, turn, children);
        Some(Drawn {
            defaults: vec![("fill", TEXT), ("stroke", TEXT), ("stroke-width", "2")],
            children: vec![child],
            anchor: at,
        })
    }

    /// A wedge; its surface goes from its foot to its top.
    pub fn ramp(&mut self, given: &Given) -> Option<Drawn> {
        let way = self.way_of(given)?;
        let text = Ink::Text;
        let mut wedge = fixed("path", &[("fill-opacity", "0.25"), ("stroke-linejoin", "round")]);
        self.set(
            &mut wedge,
            "d",
            &[
                text("M"),
                Ink::Node(way.from.x),
                text(" "),
                Ink::Node(way.from.y),
                text("L"),
                Ink::Node(way.to.x),
                text(" "),
                Ink::Node(way.to.y),
                text("V"),
                Ink::Node(way.from.y),
                text("Z"),
            ],
        );
        let defaults = vec![("fill", GLASS), ("stroke", TEXT), ("stroke-width", "2")];
        Some(Drawn { defaults, children: vec![wedge], anchor: way.to })
    }

    /// A picture embedded in the document.
    pub fn image(&mut self, given: &Given) -> Option<Drawn> {
        let (at, size) = (self.point_of(given, "at"), self.size(given.get("size")?.clone()));
        let address = given.get("href")?.clone();
        let text = self.source(&address).trim().to_owned();
        let is_base64 = |data: &str| data.bytes().all(|c| c.is_ascii_alphanumeric() || matches!(c, b'+' | b'/' | b'='));
        if !PICTURES.iter().any(|start| text.strip_prefix(start).is_some_and(is_base64)) {
            self.refuse(
                words("a picture of a scene must stand in the document itself"),
                address.start..address.end.min(address.start + 40),
                Some(words("write `href=\"data:image/png;base64,...\"`; png, jpeg, gif and webp are known")),
            );
            return None;
        }
        let (at, size) = at.zip(size)?;
        let Spot { x, y } = self.corner(at, size.x, size.y);
        let mut picture = fixed("image", &[("preserveAspectRatio", "xMidYMid meet")]);
        picture = self.numbered(picture, &[("x", x), ("y", y), ("width", size.x), ("height", size.y)]);
        picture.attributes.push(Attribute { name: "href".to_owned(), value: vec![Piece::Literal(text)] });
        Some(Drawn { defaults: Vec::new(), children: vec![picture], anchor: at })
    }
}
