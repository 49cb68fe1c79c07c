//! Parts: springs, blocks, arrows and others, drawn as plain SVG from a few values.

mod axes;
mod bodies;
mod circuits;
mod drawing;
mod lines;
mod marks;
mod trails;
mod vessels;

use super::builder::Builder;
use super::space::Spot;
use program::{Attribute, Child, Element, Piece};
use std::collections::BTreeMap;
use std::ops::Range;
use units::{Words, words};

/// Places of the attribute values of a part, by name.
pub type Given = BTreeMap<String, Range<usize>>;

/// A part of a drawing, or another element for editors.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Name of its element.
    pub name: &'static str,
    /// Default title, for screen readers and tooltips.
    pub title: Words,
    /// Its own attributes, required ones first.
    pub attributes: &'static [&'static str],
    /// Number of required attributes.
    pub needed: usize,
}

/// Constructor of a part.
pub(crate) const fn part(name: &'static str, title: Words, needed: usize, attributes: &'static [&'static str]) -> Part {
    Part { name, title, attributes, needed }
}

/// All parts.
pub static PARTS: [Part; 24] = [
    part("spring", words("Spring"), 2, &["from", "to", "turns", "width"]),
    part("damper", words("Damper"), 2, &["from", "to", "width", "length"]),
    part("rod", words("Rod"), 2, &["from", "to"]),
    part("ground", words("Ground"), 2, &["from", "to", "depth"]),
    part("arrow", words("Arrow"), 2, &["at", "vector"]),
    part("block", words("Block"), 2, &["at", "size", "turn"]),
    part("bob", words("Bob"), 1, &["at", "r"]),
    part("wheel", words("Wheel"), 2, &["at", "r", "turn"]),
    part("pulley", words("Pulley"), 2, &["at", "r", "turn"]),
    part("ramp", words("Ramp"), 2, &["from", "to"]),
    part("label", words("Label"), 1, &["at"]),
    part("ruler", words("Ruler"), 3, &["from", "to", "step", "first"]),
    part("axes", words("Axes"), 3, &["x", "y", "step"]),
    part("angle", words("Angle"), 3, &["at", "from", "to", "r"]),
    part("protractor", words("Protractor"), 2, &["at", "r", "turn"]),
    part("image", words("Picture"), 3, &["at", "size", "href"]),
    part("tube", words("Tube"), 3, &["from", "to", "width", "level"]),
    part("utube", words("U-tube"), 5, &["at", "spacing", "height", "left", "right", "width"]),
    part("trail", words("Trail"), 1, &["at", "last", "every"]),
    part("resistor", words("Resistor"), 2, &["from", "to"]),
    part("coil", words("Coil"), 2, &["from", "to"]),
    part("capacitor", words("Capacitor"), 2, &["from", "to"]),
    part("switch", words("Switch"), 2, &["from", "to", "closed"]),
    part("source", words("Source"), 2, &["from", "to"]),
];

/// The part with this element name.
pub fn part_of(name: &str) -> Option<&'static Part> {
    PARTS.iter().find(|part| part.name == name)
}

/// Default radius of a bob, in units of the drawing.
pub(crate) const BOB_RADIUS: f64 = 12.0;
/// Default radius of the arc of an angle, in units of the drawing.
pub(crate) const ARC_RADIUS: f64 = 30.0;

/// A drawn part.
pub struct Drawn {
    /// Attributes of the whole, unless the document sets them.
    pub defaults: Vec<(&'static str, &'static str)>,
    /// Elements of the part.
    pub children: Vec<Element>,
    /// Point that follows the pointer when the part is dragged.
    pub anchor: Spot,
}

impl Builder<'_, '_> {
    /// Draws a part. All required attributes must be given.
    pub fn draw_part(&mut self, part: &Part, given: &Given) -> Option<Drawn> {
        match part.name {
            "spring" => self.spring(given),
            "damper" => self.damper(given),
            "rod" => self.rod(given),
            "ground" => self.ground(given),
            "arrow" => self.arrow(given),
            "block" => self.block(given),
            "bob" => self.bob(given),
            "wheel" | "pulley" => self.wheel(given, part.name == "pulley"),
            "ramp" => self.ramp(given),
            "label" => self.label(given),
            "ruler" => self.ruler(given),
            "axes" => self.axes(given),
            "angle" => self.angle_arc(given),
            "protractor" => self.protractor(given),
            "image" => self.image(given),
            "trail" => self.trail(given),
            "tube" => self.tube(given),
            "utube" => self.u_tube(given),
            name => self.circuit(name, given),
        }
    }

    /// True if all required attributes are given; reports the first missing one.
    pub fn has_needed(&mut self, part: &Part, given: &Given, place: Range<usize>) -> bool {
        let missing = part.attributes.iter().take(part.needed).find(|name| !given.contains_key(**name));
        if let Some(missing) = missing {
            let all = part.attributes.iter().take(part.needed).map(|name| format!("{name}=\"...\""));
            let all = all.collect::<Vec<_>>().join(" ");
            self.refuse(
                words!("`<{}>` needs `{missing}`", part.name),
                place,
                Some(words!("write `<{} {all}/>`", part.name)),
            );
        }
        missing.is_none()
    }

    /// Adds the defaults that the document does not set.
    pub fn with_defaults(defaults: &[(&'static str, &'static str)], attributes: &mut Vec<Attribute>) {
        for (name, value) in defaults {
            if !attributes.iter().any(|attribute| attribute.name == *name) {
                let value = vec![Piece::Literal((*value).to_owned())];
                attributes.push(Attribute { name: (*name).to_owned(), value });
            }
        }
    }
}

/// A `title` element.
pub fn title(text: Vec<Piece>) -> Element {
    Element { name: "title".to_owned(), attributes: Vec::new(), children: vec![Child::Text(text)], drag: None }
}
