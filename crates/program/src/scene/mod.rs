//! The drawing as a tree of elements that are known to be harmless, with places for values.

mod written;

use crate::Compiled;
use serde::{Deserialize, Serialize};

/// A drawing whose attributes and texts follow the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Written", into = "Written")]
pub struct Scene {
    /// The `svg` element.
    pub root: Element,
    /// What the templates name, evaluated for each frame.
    pub values: Vec<Compiled>,
}

/// A [`Scene`], not yet checked: the last of the elements is the root.
#[derive(Serialize, Deserialize)]
struct Written {
    elements: Vec<WrittenElement>,
    values: Vec<Compiled>,
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
}

/// How dragging an element changes a state. Distances are in user units of the `svg` element's viewBox.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Drag {
    /// Which of [`crate::Model::states`].
    pub state: usize,
    /// What one unit upwards adds to the state, SI: an index into [`Scene::values`].
    pub up: Option<usize>,
    /// What one unit to the right adds to the state, SI: an index into [`Scene::values`].
    pub right: Option<usize>,
}
