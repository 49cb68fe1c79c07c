//! The drawing as a tree of harmless elements with placeholders for values.

mod written;

use crate::Compiled;
use serde::{Deserialize, Serialize};
use std::fmt::Write;

/// A drawing whose attributes and texts follow the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Written", into = "Written")]
pub struct Scene {
    /// The `svg` element.
    pub root: Element,
    /// Values used in the templates, evaluated for each frame.
    pub values: Vec<Compiled>,
    /// Traces of points.
    pub trails: Vec<Trail>,
    /// Length of a unit of the drawing (SI units), if the document states it: an index in `values`.
    pub length: Option<usize>,
}

impl Scene {
    /// Width and height of the view box in units of the drawing; `None` without a view box of fixed, positive size.
    pub fn size(&self) -> Option<[f64; 2]> {
        let view = self.root.attributes.iter().find(|attribute| attribute.name == "viewBox")?;
        let [Piece::Literal(text)] = view.value.as_slice() else { return None };
        let numbers = text.split([' ', ',']).filter(|part| !part.is_empty()).map(units::number::decimal);
        let [_, _, width, height] = numbers.collect::<Option<Vec<f64>>>()?[..] else { return None };
        (width > 0.0 && height > 0.0 && (width / height).is_finite()).then_some([width, height])
    }
}

/// Trace of a point: a line, or dots at equal intervals of time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trail {
    /// Horizontal position to the right, in units of the drawing: an index in [`Scene::values`], as all fields.
    pub x: usize,
    /// Vertical position downwards, in units of the drawing.
    pub y: usize,
    /// Time for which a point remains visible, in SI units of the independent variable; `None`: for the whole run.
    pub last: Option<usize>,
    /// Time between two dots, in SI units of the independent variable; `None`: a line.
    pub every: Option<usize>,
}

impl Trail {
    /// Indices of all values that it uses.
    pub fn values(&self) -> impl Iterator<Item = usize> + use<> {
        [Some(self.x), Some(self.y), self.last, self.every].into_iter().flatten()
    }
}

/// Serialized form of a [`Scene`], not yet checked: the last element is the root.
#[derive(Serialize, Deserialize)]
struct Written {
    elements: Vec<WrittenElement>,
    values: Vec<Compiled>,
    trails: Vec<Trail>,
    length: Option<usize>,
}

#[derive(Serialize, Deserialize)]
struct WrittenElement {
    name: String,
    attributes: Vec<Attribute>,
    children: Vec<WrittenChild>,
    drag: Option<Drag>,
}

#[derive(Serialize, Deserialize)]
enum WrittenChild {
    /// The element of this index, which precedes its parent.
    Element(u32),
    Text(Template),
}

/// An allowed SVG element.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// Name in the SVG namespace, such as `path`.
    pub name: String,
    /// Attributes; names and literal parts are safe to set without escaping.
    pub attributes: Vec<Attribute>,
    /// Child elements and texts.
    pub children: Vec<Child>,
    /// Effect of dragging the element, if it can be dragged.
    pub drag: Option<Drag>,
}

/// An attribute of an element.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Attribute {
    /// Name of the attribute.
    pub name: String,
    /// Value; numbers in it are written without unit. While one of them is not finite, the attribute keeps its previous
    /// text.
    pub value: Template,
}

/// A child of an element.
#[derive(Clone, Debug, PartialEq)]
pub enum Child {
    /// A nested element.
    Element(Element),
    /// A text; numbers in it are formatted for readers, with their units.
    Text(Template),
}

/// A text with placeholders for values.
pub type Template = Vec<Piece>;

/// A part of a template: literal text or a placeholder.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Piece {
    /// Literal text.
    Literal(String),
    /// A number, `Scene::values[index]`.
    Value {
        /// Index in `Scene::values`.
        index: usize,
        /// Number of decimals; `{t:.2}` asks for 2. `None`: a sensible number of significant digits.
        decimals: Option<u8>,
    },
    /// Text selected by the value of `Scene::values[index]`, such as a colour or a visibility. In attributes only.
    Choice {
        /// Index in `Scene::values`.
        index: usize,
        /// Integers with the text of each.
        texts: Vec<(u32, String)>,
    },
    /// Path of `Scene::trails[index]`; the only piece of its attribute.
    Trail(usize),
}

impl Piece {
    /// Index in [`Scene::values`] of the value shown, if any.
    pub fn value(&self) -> Option<usize> {
        match self {
            Self::Literal(_) | Self::Trail(_) => None,
            Self::Value { index, .. } | Self::Choice { index, .. } => Some(*index),
        }
    }
}

/// Writes the text of an attribute for the values of [`Scene::values`]. Returns false if it has none: a number is not
/// finite, a value has no text, or it contains a trail, which needs more than these values.
pub fn write_attribute(template: &[Piece], values: &[f64], text: &mut String) -> bool {
    text.clear();
    template.iter().all(|piece| match piece {
        Piece::Literal(literal) => {
            text.push_str(literal);
            true
        }
        Piece::Trail(_) => false,
        Piece::Value { index, .. } => {
            // Seven digits exceed the resolution of a screen, and a shorter text is parsed faster.
            let value = values.get(*index).map_or(f32::NAN, |value| *value as f32);
            let _ = write!(text, "{value}");
            value.is_finite()
        }
        Piece::Choice { index, texts } => {
            let value = values.get(*index).copied().unwrap_or(f64::NAN);
            let chosen = texts.iter().find(|(number, _)| f64::from(*number) == value);
            text.push_str(chosen.map_or("", |(_, chosen)| chosen));
            chosen.is_some()
        }
    })
}

/// Effect of dragging an element on a state or a parameter. Distances are in user units of the viewBox of the `svg`
/// element.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Drag {
    /// State or parameter that changes.
    pub target: Dragged,
    /// Change per unit upwards, SI units: an index in [`Scene::values`].
    pub up: Option<usize>,
    /// Change per unit to the right, SI units: an index in [`Scene::values`].
    pub right: Option<usize>,
    /// Height at which the target is 0 if it moves up and down alone, downwards from the top of the user space: an index in
    /// [`Scene::values`]. With `up` it makes the drawing a scale of the target.
    pub zero: Option<usize>,
}

/// State or parameter that dragging changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Dragged {
    /// Index in [`crate::Model::states`].
    State(usize),
    /// Index in [`crate::Model::parameters`].
    Parameter(usize),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_has_the_size_of_a_fixed_view_box() {
        let size = |value: Template| {
            let attributes = vec![Attribute { name: "viewBox".into(), value }];
            let root = Element { name: "svg".into(), attributes, children: Vec::new(), drag: None };
            Scene { root, values: Vec::new(), trails: Vec::new(), length: None }.size()
        };
        let fixed = |text: &str| size(vec![Piece::Literal(text.into())]);
        assert_eq!(fixed("-10 4, 330 486.5"), Some([330.0, 486.5]));
        for text in ["", "0 0 10", "0 0 10 0", "0 0 -1 5", "0 0 a 5", "0 0 1 2 3", "0 0 inf 1"] {
            assert_eq!(fixed(text), None, "{text}");
        }
        assert_eq!(size(vec![Piece::Value { index: 0, decimals: None }]), None);
    }

    #[test]
    fn an_attribute_has_a_text_where_all_its_values_have_one() {
        let shown = Piece::Choice { index: 1, texts: vec![(0, "none".into()), (1, "inline".into())] };
        let number = Piece::Value { index: 0, decimals: None };
        let mut text = String::new();
        let template = [Piece::Literal("M".into()), number, shown];
        assert!(write_attribute(&template, &[0.1, 1.0], &mut text));
        assert_eq!(text, "M0.1inline");
        assert!(!write_attribute(&template, &[f64::NAN, 1.0], &mut text));
        assert!(!write_attribute(&template, &[0.1, 2.0], &mut text));
        assert!(!write_attribute(&template, &[0.1], &mut text));
    }
}
