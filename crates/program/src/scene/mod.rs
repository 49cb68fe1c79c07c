//! The drawing as a tree of elements that are known to be harmless, with places for values.

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
    /// What the templates name, evaluated for each frame.
    pub values: Vec<Compiled>,
    /// Where points have been.
    pub trails: Vec<Trail>,
    /// How long a unit of the drawing is (SI), where a frame of lengths says so: an index into `values`.
    pub length: Option<usize>,
}

/// Where a point has been: a line, or dots at multiples of a time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trail {
    /// Its place to the right, in units of the drawing: an index into [`Scene::values`], as are the others.
    pub x: usize,
    /// Its place downwards, likewise.
    pub y: usize,
    /// How long a point of it is seen, of the independent variable (SI); without, as long as the run.
    pub last: Option<usize>,
    /// The time from one dot to the next; without, it is a line.
    pub every: Option<usize>,
}

impl Trail {
    /// The values that it names.
    pub fn values(&self) -> impl Iterator<Item = usize> + use<> {
        [Some(self.x), Some(self.y), self.last, self.every].into_iter().flatten()
    }
}

/// A [`Scene`], not yet checked: the last of the elements is the root.
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
    /// The element of this number, which comes before its parent.
    Element(u32),
    Text(Template),
}

/// An SVG element of the allow-list.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// Its name in the SVG namespace, such as `path`.
    pub name: String,
    /// Its attributes; names and literal parts are safe to set as they are.
    pub attributes: Vec<Attribute>,
    /// What it holds.
    pub children: Vec<Child>,
    /// What moving the pointer changes, where the element can be dragged.
    pub drag: Option<Drag>,
}

/// An attribute.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Attribute {
    /// Its name.
    pub name: String,
    /// Its value; values in it are written as bare numbers. While one of them is not finite, the attribute keeps what
    /// it had.
    pub value: Template,
}

/// A child of an element.
#[derive(Clone, Debug, PartialEq)]
pub enum Child {
    /// A further element.
    Element(Element),
    /// A text; values in it are written for people, with their units.
    Text(Template),
}

/// A text with values in it.
pub type Template = Vec<Piece>;

/// A part of a template.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Piece {
    /// This text.
    Literal(String),
    /// `Scene::values[index]`.
    Value {
        /// Which.
        index: usize,
        /// How many decimals; `{t:.2}` asks for 2. Without, a sensible number of significant digits.
        decimals: Option<u8>,
    },
    /// The text that belongs to the value of `Scene::values[index]`: a colour, or whether something is shown. In
    /// attributes only.
    Choice {
        /// Which.
        index: usize,
        /// Whole numbers and the text for each.
        texts: Vec<(u32, String)>,
    },
    /// The path of `Scene::trails[index]`; alone in its attribute.
    Trail(usize),
}

impl Piece {
    /// The value that it shows, as an index into [`Scene::values`].
    pub fn value(&self) -> Option<usize> {
        match self {
            Self::Literal(_) | Self::Trail(_) => None,
            Self::Value { index, .. } | Self::Choice { index, .. } => Some(*index),
        }
    }
}

/// Writes the text of an attribute for the values of [`Scene::values`]. False where it has none: a number that is not
/// finite, a value without a text, or a trail, which more than values decide.
pub fn write_attribute(template: &[Piece], values: &[f64], text: &mut String) -> bool {
    text.clear();
    template.iter().all(|piece| match piece {
        Piece::Literal(literal) => {
            text.push_str(literal);
            true
        }
        Piece::Trail(_) => false,
        Piece::Value { index, .. } => {
            // Seven digits are more than a screen has, and the shorter text is parsed sooner.
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

/// How dragging an element changes a state or a parameter. Distances are in user units of the `svg` element's viewBox.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Drag {
    /// What it changes.
    pub target: Dragged,
    /// What one unit upwards adds to it, SI: an index into [`Scene::values`].
    pub up: Option<usize>,
    /// What one unit to the right adds to it, SI: an index into [`Scene::values`].
    pub right: Option<usize>,
}

/// What dragging changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Dragged {
    /// Which of [`crate::Model::states`].
    State(usize),
    /// Which of [`crate::Model::parameters`].
    Parameter(usize),
}

#[cfg(test)]
mod tests {
    use super::*;

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
