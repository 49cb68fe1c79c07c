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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// Name of its element.
    pub name: &'static str,
    /// Default title in English and Spanish, for screen readers and tooltips.
    pub words: (&'static str, &'static str),
    /// Its own attributes, required ones first.
    pub attributes: &'static [&'static str],
    /// Number of required attributes.
    pub needed: usize,
}

impl Part {
    /// Default title.
    pub fn title(self) -> Words {
        words(self.words.0, self.words.1)
    }
}

/// Constructor of a part.
pub(crate) const fn part(
    name: &'static str,
    words: (&'static str, &'static str),
    needed: usize,
    attributes: &'static [&'static str],
) -> Part {
    Part { name, words, attributes, needed }
}

/// All parts.
pub const PARTS: [Part; 24] = [
    part("spring", ("Spring", "Muelle"), 2, &["from", "to", "turns", "width"]),
    part("damper", ("Damper", "Amortiguador"), 2, &["from", "to", "width", "length"]),
    part("rod", ("Rod", "Varilla"), 2, &["from", "to"]),
    part("ground", ("Ground", "Suelo"), 2, &["from", "to", "depth"]),
    part("arrow", ("Arrow", "Flecha"), 2, &["at", "vector"]),
    part("block", ("Block", "Bloque"), 2, &["at", "size", "turn"]),
    part("bob", ("Bob", "Lenteja"), 1, &["at", "r"]),
    part("wheel", ("Wheel", "Rueda"), 2, &["at", "r", "turn"]),
    part("pulley", ("Pulley", "Polea"), 2, &["at", "r", "turn"]),
    part("ramp", ("Ramp", "Plano inclinado"), 2, &["from", "to"]),
    part("label", ("Label", "Rótulo"), 1, &["at"]),
    part("ruler", ("Ruler", "Regla"), 3, &["from", "to", "step", "first"]),
    part("axes", ("Axes", "Ejes"), 3, &["x", "y", "step"]),
    part("angle", ("Angle", "Ángulo"), 3, &["at", "from", "to", "r"]),
    part("protractor", ("Protractor", "Transportador"), 2, &["at", "r", "turn"]),
    part("image", ("Picture", "Imagen"), 3, &["at", "size", "href"]),
    part("tube", ("Tube", "Tubo"), 3, &["from", "to", "width", "level"]),
    part("utube", ("U-tube", "Tubo en U"), 5, &["at", "spacing", "height", "left", "right", "width"]),
    part("trail", ("Trail", "Estela"), 1, &["at", "last", "every"]),
    part("resistor", ("Resistor", "Resistencia"), 2, &["from", "to"]),
    part("coil", ("Coil", "Bobina"), 2, &["from", "to"]),
    part("capacitor", ("Capacitor", "Condensador"), 2, &["from", "to"]),
    part("switch", ("Switch", "Interruptor"), 2, &["from", "to", "closed"]),
    part("source", ("Source", "Fuente"), 2, &["from", "to"]),
];

/// The part with this element name.
pub fn part_of(name: &str) -> Option<Part> {
    PARTS.into_iter().find(|part| part.name == name)
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
    pub fn draw_part(&mut self, part: Part, given: &Given) -> Option<Drawn> {
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
    pub fn has_needed(&mut self, part: Part, given: &Given, place: Range<usize>) -> bool {
        let missing = part.attributes.iter().take(part.needed).find(|name| !given.contains_key(**name));
        if let Some(missing) = missing {
            let all = part.attributes.iter().take(part.needed).map(|name| format!("{name}=\"...\""));
            let all = all.collect::<Vec<_>>().join(" ");
            self.refuse(
                words!("`<{}>` needs `{missing}`", "`<{}>` necesita `{missing}`", part.name),
                place,
                Some(words!("write `<{} {all}/>`", "escribe `<{} {all}/>`", part.name)),
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
